// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/delimited_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t mostLineBytes = std::size_t(8) << 20; // a million columns; of blank cells each takes eight times its bytes
constexpr long double mostSeconds = 4e9L; // the year 2096; nanoseconds of 64 bits hold what lies between any two

/// A whole cell as a number of any kind of floating point.
template <class Number>
std::optional<Number> numberOf(std::string_view cell, char delimiter)
{
    std::array<char, 65> copy{}; // ends with a zero: libstdc++ looks for one beyond the end it is given
    if (cell.starts_with('+'))
        cell.remove_prefix(1); // from_chars knows none
    if (cell.empty() || cell.size() >= copy.size())
        return std::nullopt;
    std::copy(cell.begin(), cell.end(), copy.begin());
    if (delimiter != ',')
        std::replace(copy.data(), copy.data() + cell.size(), ',', '.');
    Number value = 0;
    const auto [end, problem] = std::from_chars(copy.data(), copy.data() + cell.size(), value);
    if (problem != std::errc() || end != copy.data() + cell.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace

Result<std::optional<std::string_view>> FileLines::next()
{
    std::size_t searched = m_position, end = 0;
    while ((end = m_text.find('\n', searched)) == std::string::npos && !m_atEnd) {
        m_text.erase(0, m_position);
        m_position = 0;
        searched = m_text.size();
        if (searched > mostLineBytes)
            return fail(ErrorCode::InvalidInput, m_file.lineName(m_number + 1), "it is longer than 8 MiB", "check that it is the right file");
        const auto block = m_file.read();
        if (!block)
            return tl::unexpected(block.error());
        m_atEnd = block->empty();
        m_text += *block;
    }
    if (m_position >= m_text.size())
        return std::nullopt;
    end = std::min(end, m_text.size());
    std::string_view line = std::string_view(m_text).substr(m_position, end - m_position);
    m_given += line.size() + 1;
    m_position = end + 1;
    ++m_number;
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

double FileLines::doneShare() const
{
    return std::min(1.0, double(m_given) / double(std::max<std::size_t>(m_file.size(), 1)));
}

std::string_view withoutBlanks(std::string_view text)
{
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

char delimiterOf(std::string_view header)
{
    for (const char delimiter : {'\t', ';', ','}) {
        if (header.find(delimiter) != std::string_view::npos)
            return delimiter;
    }
    return ' ';
}

void splitCells(std::string_view line, char delimiter, std::vector<std::string_view> &cells)
{
    cells.clear();
    if (delimiter == ' ')
        line = withoutBlanks(line);
    for (std::size_t at = 0; at <= line.size();) {
        if (delimiter == ' ')
            at = std::min(line.find_first_not_of(" \t", at), line.size());
        std::size_t end = at;
        const auto parts = [delimiter](char c) { return c == delimiter || (delimiter == ' ' && c == '\t'); };
        for (bool isQuoted = false; end < line.size() && (isQuoted || !parts(line[end])); ++end)
            isQuoted ^= line[end] == '"';
        std::string_view cell = withoutBlanks(line.substr(at, end - at));
        if (cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"'))
            cell = withoutBlanks(cell.substr(1, cell.size() - 2));
        cells.push_back(cell);
        at = end + 1;
    }
}

std::optional<double> cellNumber(std::string_view cell, char delimiter)
{
    return numberOf<double>(cell, delimiter);
}

std::optional<Nanoseconds> cellTime(std::string_view cell, char delimiter, double secondsPerUnit)
{
    const auto value = numberOf<long double>(cell, delimiter);
    if (!value)
        return std::nullopt;
    const long double unitsPerSecond = std::roundl(1 / static_cast<long double>(secondsPerUnit)); // 1e-9 is no double
    const long double seconds = *value / unitsPerSecond;
    if (std::abs(seconds) > mostSeconds)
        return std::nullopt;
    return Nanoseconds(std::llroundl(*value * (1e9L / unitsPerSecond)));
}

} // namespace odo
