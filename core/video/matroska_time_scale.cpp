// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/matroska_time_scale.h"

#include <cstdio>
#include <fstream>
#include <string>

namespace odo {

namespace {

constexpr std::size_t headBytes = 8192; // the muxer writes Info and Tags before the first cluster

} // namespace

Result<void> setMicrosecondScale(const std::filesystem::path &file, Nanoseconds duration)
{
    using namespace std::string_literals;
    static const std::string milliseconds =
        "\x2a\xd7\xb1\x83\x0f\x42\x40"s; // TimestampScale, 3 bytes, 1 000 000 ns
    static const std::string microseconds = "\x2a\xd7\xb1\x83\x00\x03\xe8"s; // 1000 ns
    static const std::string tag = "DURATION\x44\x87"s; // a SimpleTag's name, then TagString
    constexpr std::size_t durationLetters = 18;         // "00:00:12.345678000"

    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    std::string head(headBytes, '\0');
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    const std::size_t scaleAt = head.find(milliseconds);
    if (scaleAt == std::string::npos)
        return fail(ErrorCode::Internal, "cannot write the video " + file.string(),
                    "its time scale was not found where the muxer should have put it",
                    "report this as a bug");
    stream.seekp(static_cast<std::streamoff>(scaleAt));
    stream.write(microseconds.data(), static_cast<std::streamsize>(microseconds.size()));

    if (const std::size_t tagAt = head.find(tag); tagAt != std::string::npos) {
        const long long ns = duration.count();
        const long long seconds = ns / 1'000'000'000;
        char text[40];
        std::snprintf(text, sizeof text, "%02lld:%02lld:%02lld.%09lld", seconds / 3600 % 100,
                      seconds / 60 % 60, seconds % 60, ns % 1'000'000'000);
        stream.seekp(static_cast<std::streamoff>(tagAt + tag.size() + 1)); // after the length byte
        stream.write(text, durationLetters);
    }
    stream.close();
    if (!stream)
        return fail(ErrorCode::Io, "cannot write the video " + file.string(),
                    "its header could not be rewritten", "check that there is room on the disk");
    return {};
}

} // namespace odo
