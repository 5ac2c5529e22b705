// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/video/coded_frames.h"

#include <cmath>

namespace odo::test {

namespace {

constexpr int blockSize = 16;

}

FrameFormat smallFormat()
{
    FrameFormat format;
    format.width = 192;
    format.height = 96;
    format.siting = ChromaSiting::Center;
    format.fullRange = true;
    return format;
}

Frame rampFrame()
{
    FrameFormat format;
    format.width = 256;
    format.height = 64;
    format.fullRange = true;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int row = 0; row < format.height; ++row)
        for (int x = 0; x < format.width; ++x)
            buffer->yRow(row)[x] = static_cast<std::uint8_t>(x);
    for (int row = 0; row < buffer->chromaHeight(); ++row) {
        std::fill_n(buffer->uRow(row), buffer->chromaWidth(), std::uint8_t(128));
        std::fill_n(buffer->vRow(row), buffer->chromaWidth(), std::uint8_t(128));
    }
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

Frame codedFrame(const FrameFormat &format, int number, Nanoseconds time)
{
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < format.height; ++y)
        for (int x = 0; x < format.width; ++x) {
            const int bit = x / blockSize;
            const bool code = y < blockSize && bit < codedBits;
            const int pattern = 100 + (x * 60) / format.width + ((y + number) * 40) / (format.height + 200);
            buffer->yRow(y)[x] = static_cast<std::uint8_t>(code ? ((number >> bit & 1) != 0 ? 220 : 30)
                                                                : std::min(pattern, 230));
        }
    for (int y = 0; y < buffer->chromaHeight(); ++y)
        for (int x = 0; x < buffer->chromaWidth(); ++x) {
            buffer->uRow(y)[x] = static_cast<std::uint8_t>(90 + (x * 60) / buffer->chromaWidth());
            buffer->vRow(y)[x] = static_cast<std::uint8_t>(100 + (y * 50) / buffer->chromaHeight());
        }
    return FrameBuffer::toFrame(std::move(buffer), number, time);
}

int numberIn(const Frame &frame)
{
    int number = 0;
    for (int bit = 0; bit < codedBits; ++bit)
        if (frame.y.at(bit * blockSize + blockSize / 2, blockSize / 2) > 125)
            number |= 1 << bit;
    return number;
}

std::uint64_t fingerprint(const Frame &frame)
{
    std::uint64_t sum = 0;
    for (const PlaneView &plane : {frame.y, frame.u, frame.v})
        for (int y = 0; y < plane.height; ++y) {
            const std::string_view row(reinterpret_cast<const char *>(plane.row(y)),
                                       static_cast<std::size_t>(plane.width));
            sum = sum * 1099511628211ULL + std::hash<std::string_view>()(row);
        }
    return sum;
}

QString writeCoded(const std::filesystem::path &file, const std::vector<Nanoseconds> &times,
                   const VideoWriterOptions &options, const FrameFormat &format)
{
    auto writer = VideoWriter::create(file, format, options);
    if (!writer)
        return QString::fromStdString(writer.error().message());
    int number = 0;
    for (const Nanoseconds time : times)
        if (auto written = (*writer)->write(codedFrame(format, number++, time)); !written)
            return QString::fromStdString(written.error().message());
    if (auto finished = (*writer)->finish(); !finished)
        return QString::fromStdString(finished.error().message());
    return {};
}

std::vector<Nanoseconds> evenTimes(int count, double framesPerSecond)
{
    std::vector<Nanoseconds> times;
    for (int i = 0; i < count; ++i)
        times.push_back(fromSeconds(i / framesPerSecond));
    return times;
}

std::vector<Nanoseconds> unevenTimes(int count)
{
    std::vector<Nanoseconds> times;
    std::int64_t us = 0;
    unsigned state = 12345;
    for (int i = 0; i < count; ++i) {
        times.emplace_back(us * 1000);
        state = state * 1664525U + 1013904223U;
        us += 5000 + state % 55'000U;
    }
    return times;
}

} // namespace odo::test
