// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/import/internal/joined_file.h"

#include <QtEndian>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

namespace odo {

namespace {

constexpr std::size_t headBytes = 16;
using PartHead = std::array<char, headBytes>;

std::string_view textAt(const PartHead &head, std::size_t at)
{
    return {head.data() + at, 4};
}

/// Nothing at the end of the file.
std::optional<PartHead> headAt(std::ifstream &file, std::uint64_t at)
{
    PartHead head{};
    file.clear();
    if (at > std::uint64_t(std::numeric_limits<std::streamoff>::max()) ||
        !file.seekg(static_cast<std::streamoff>(at)))
        return std::nullopt;
    file.read(head.data(), headBytes);
    return file.gcount() < 12 ? std::nullopt : std::optional(head);
}

/// A long AVI goes on in parts that are called AVIX (OpenDML 1.02).
bool isSeveralAvi(std::ifstream &file)
{
    std::uint64_t at = 0;
    for (auto head = headAt(file, at); head && textAt(*head, 0) == "RIFF"; head = headAt(file, at)) {
        if (at > 0 && textAt(*head, 8) == "AVI ")
            return true;
        const std::uint64_t length = qFromLittleEndian<quint32>(head->data() + 4);
        at += 8 + length + length % 2;
    }
    return false;
}

/// ISO/IEC 14496-12 §4.2: one ftyp, before all others.
bool isSeveralMp4(std::ifstream &file)
{
    std::uint64_t at = 0;
    for (auto head = headAt(file, at); head; head = headAt(file, at)) {
        if (at > 0 && textAt(*head, 4) == "ftyp")
            return true;
        const std::uint64_t stated = qFromBigEndian<quint32>(head->data()),
                            length = stated == 1 ? qFromBigEndian<quint64>(head->data() + 8) : stated;
        if (length < 8 || length > std::uint64_t(std::numeric_limits<std::streamoff>::max()))
            return false;
        at += length;
    }
    return false;
}

} // namespace

bool isSeveralFiles(const std::filesystem::path &path)
{
    std::ifstream file(path, std::ios::binary);
    const auto head = headAt(file, 0);
    if (!head)
        return false;
    if (textAt(*head, 0) == "RIFF")
        return textAt(*head, 8) == "AVI " && isSeveralAvi(file);
    return textAt(*head, 4) == "ftyp" && isSeveralMp4(file);
}

} // namespace odo
