// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/yaml_scalar.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace odo {

namespace {

void appendUtf8(std::string &text, std::uint32_t character)
{
    const auto put = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (character < 0x80) {
        put(character);
    } else if (character < 0x800) {
        put(0xc0 | character >> 6);
        put(0x80 | (character & 0x3f));
    } else if (character < 0x10000) {
        put(0xe0 | character >> 12);
        put(0x80 | (character >> 6 & 0x3f));
        put(0x80 | (character & 0x3f));
    } else {
        put(0xf0 | character >> 18);
        put(0x80 | (character >> 12 & 0x3f));
        put(0x80 | (character >> 6 & 0x3f));
        put(0x80 | (character & 0x3f));
    }
}

/// The four digits of "\uXXXX" at a place.
std::optional<std::uint32_t> codeAt(const std::string &text, std::size_t at)
{
    std::uint32_t code = 0;
    if (at + 6 > text.size() || text[at] != '\\' || text[at + 1] != 'u')
        return std::nullopt;
    const char *first = text.data() + at + 2;
    const auto [end, problem] = std::from_chars(first, first + 4, code, 16);
    return problem == std::errc() && end == first + 4 ? std::optional(code) : std::nullopt;
}

/// Takes one escape; gives how many characters it has, 0 for one that is not known.
std::size_t takeEscape(const std::string &text, std::size_t at, std::string &into)
{
    static constexpr std::string_view letters = "nt\"\\/rbf0", meant("\n\t\"\\/\r\b\f\0", 9);
    const std::size_t known = at + 1 < text.size() ? letters.find(text[at + 1]) : std::string_view::npos;
    if (known != std::string_view::npos) {
        into += meant[known];
        return 2;
    }
    const auto code = codeAt(text, at);
    if (!code)
        return 0;
    const bool isFirstHalf = *code >= 0xd800 && *code < 0xdc00;
    const auto second = isFirstHalf ? codeAt(text, at + 6) : std::nullopt;
    if (isFirstHalf && second && *second >= 0xdc00 && *second < 0xe000) {
        appendUtf8(into, 0x10000 + ((*code - 0xd800) << 10) + (*second - 0xdc00));
        return 12;
    }
    if (*code >= 0xd800 && *code < 0xe000) // half a character
        return 0;
    appendUtf8(into, *code);
    return 6;
}

} // namespace

std::size_t closingQuote(const std::string &text, std::size_t start)
{
    for (std::size_t i = start + 1; i < text.size(); ++i) {
        if (text[start] == '"' && text[i] == '\\')
            ++i;
        else if (text[i] == text[start])
            return i;
    }
    return std::string::npos;
}

std::string unquoted(const std::string &text)
{
    const bool isQuoted = text.size() >= 2 && (text[0] == '"' || text[0] == '\'') && text.back() == text[0];
    if (!isQuoted)
        return text;
    const std::string inner = text.substr(1, text.size() - 2);
    std::string plain;
    for (std::size_t i = 0; i < inner.size();) {
        if (text[0] == '\'' && inner[i] == '\'' && i + 1 < inner.size() && inner[i + 1] == '\'')
            ++i;
        const std::size_t taken = text[0] == '"' && inner[i] == '\\' ? takeEscape(inner, i, plain) : 0;
        if (taken == 0)
            plain += inner[i];
        i += std::max<std::size_t>(taken, 1);
    }
    return plain;
}

} // namespace odo
