// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/plain_text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace odo {

namespace {

struct Decoded
{
    char32_t character = 0;
    std::size_t bytes = 0; ///< 0: the first byte does not begin a character
};

/// The first character of a text that is not empty, strictly: no overlong forms, surrogates or numbers that
/// Unicode does not have.
Decoded firstOf(std::string_view text)
{
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return {lead, 1};
    const std::size_t bytes = lead >= 0xf0 && lead < 0xf5   ? 4
                              : lead >= 0xe0 && lead < 0xf0 ? 3
                              : lead >= 0xc2 && lead < 0xe0 ? 2
                                                            : 0;
    if (bytes == 0 || text.size() < bytes)
        return {};
    char32_t character = lead & (0x7fu >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80)
            return {};
        character = character << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool isSurrogate = character >= 0xd800 && character < 0xe000;
    return character < least[bytes] || character > 0x10ffff || isSurrogate ? Decoded()
                                                                           : Decoded{character, bytes};
}

void addEscaped(std::string &to, const char *format, unsigned number)
{
    std::array<char, 32> text{};
    to.append(text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, number)));
}

std::string plain(std::string_view text, bool keepsLines)
{
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const auto isLetter = [](char c) { return c >= 0x20 && c < 0x7f; }; // most are
        const std::size_t letters =
            static_cast<std::size_t>(std::ranges::find_if_not(text, isLetter) - text.begin());
        shown += text.substr(0, letters);
        text.remove_prefix(letters);
        if (text.empty())
            break;
        const auto [character, bytes] = firstOf(text);
        const std::size_t taken = std::max<std::size_t>(bytes, 1);
        if (bytes == 0 || character < 0x20 || character == 0x7f) {
            const bool isKept = keepsLines && (text[0] == '\n' || text[0] == '\t');
            if (isKept)
                shown += text[0];
            else
                addEscaped(shown, "\\x%02x", static_cast<unsigned char>(text[0]));
        } else if (isInvisible(character)) {
            addEscaped(shown, "‹U+%04X›", character);
        } else {
            shown += text.substr(0, taken);
        }
        text.remove_prefix(taken);
    }
    return shown;
}

} // namespace

bool isInvisible(char32_t character)
{
    // By number, each range with its ends: as Unicode 15 has them.
    static constexpr std::pair<char32_t, char32_t> ranges[] = {
        {0x00, 0x1f},     {0x7f, 0x9f},      {0xad, 0xad},     {0x61c, 0x61c},   {0x115f, 0x1160},
        {0x17b4, 0x17b5}, {0x180e, 0x180e},  {0x200b, 0x200b}, {0x200e, 0x200f}, {0x2028, 0x202e},
        {0x2060, 0x206f}, {0x2800, 0x2800},  {0x3164, 0x3164}, {0xfeff, 0xfeff}, {0xffa0, 0xffa0},
        {0xfff0, 0xfffb}, {0xe0000, 0xe001f}};
    return std::ranges::any_of(ranges, [character](const auto &range) {
        return range.first <= character && character <= range.second;
    });
}

std::string plainText(std::string_view text)
{
    return plain(text, true);
}

std::string plainLine(std::string_view text)
{
    return plain(text, false);
}

std::string lowerCaseAscii(std::string_view text)
{
    std::string lower(text);
    for (char &c : lower) {
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

} // namespace odo
