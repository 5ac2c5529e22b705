// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/number_style.h"

#include "core/base/plain_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace odo {

namespace {

constexpr std::size_t longestNumber = 64;
constexpr std::size_t groupDigits = 3;

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Blanks and apostrophes between digits, which can only part thousands: the bytes that the mark takes.
std::size_t groupMarkAt(std::string_view text, std::size_t at)
{
    for (const std::string_view mark : {" ", "'", "\u00a0", "\u202f", "\u2009", "\u2019"}) {
        if (text.substr(at).starts_with(mark))
            return mark.size();
    }
    return 0;
}

/// The digits in front of the decimal sign, without marks of thousands; nullopt: they are not grouped right.
std::optional<std::string> wholeDigits(std::string_view text, char thousands)
{
    std::string digits;
    std::size_t inGroup = 0, groups = 0;
    for (std::size_t i = 0; i < text.size();) {
        if (isDigit(text[i])) {
            digits += text[i++];
            ++inGroup;
            continue;
        }
        const std::size_t mark = thousands != 0 && text[i] == thousands ? 1 : groupMarkAt(text, i);
        if (mark == 0 || inGroup == 0 || inGroup > groupDigits || (groups > 0 && inGroup != groupDigits))
            return std::nullopt;
        ++groups;
        inGroup = 0;
        i += mark;
    }
    if (groups > 0 && (inGroup != groupDigits || digits.front() == '0'))
        return std::nullopt;
    return digits;
}

/// A cell with a point and without marks of thousands; nullopt: it is no number of this style.
std::optional<std::string> plainNumber(std::string_view cell, char decimal, char thousands)
{
    if (cell.empty() || cell.size() > longestNumber)
        return std::nullopt;
    std::string plain;
    for (const std::string_view sign : {"-", "+", "\u2212"}) {
        if (plain.empty() && cell.starts_with(sign)) {
            plain = sign == "+" ? "" : "-";
            cell.remove_prefix(sign.size());
            break;
        }
    }
    const std::size_t exponent = cell.find_first_of("eE");
    const std::string_view mantissa = cell.substr(0, exponent);
    const std::size_t sign = mantissa.find(decimal);
    const auto whole = wholeDigits(mantissa.substr(0, sign), thousands);
    if (!whole)
        return std::nullopt;
    plain += *whole;
    if (sign != std::string_view::npos) {
        const std::string_view fraction = mantissa.substr(sign + 1);
        if (!std::ranges::all_of(fraction, isDigit) || (whole->empty() && fraction.empty()))
            return std::nullopt;
        plain += '.';
        plain += fraction;
    } else if (whole->empty()) {
        return std::nullopt;
    }
    if (exponent != std::string_view::npos)
        plain += cell.substr(exponent);
    return plain;
}

template <class Number>
std::optional<Number> read(std::string_view plain)
{
    Number value = 0;
    std::array<char, longestNumber + 2> copy{}; // libstdc++ reads one character beyond the given end
    if (plain.empty() || plain.size() >= copy.size())
        return std::nullopt;
    std::ranges::copy(plain, copy.begin());
    const auto [end, problem] = std::from_chars(copy.data(), copy.data() + plain.size(), value);
    if (problem != std::errc() || end != copy.data() + plain.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

template <class Number>
std::optional<Number> numberOf(std::string_view cell, const NumberStyle &style)
{
    // Most cells are plain.
    if (!cell.empty() && cell.front() != '+' && cell.size() <= longestNumber &&
        cell.find_first_not_of(style.decimal == '.' ? "0123456789.-+eE" : "0123456789-+eE") ==
            std::string_view::npos)
        if (style.thousands != '.')
            return read<Number>(cell);
    auto plain = plainNumber(cell, style.decimal, style.thousands);
    if (!plain && style.isMixed)
        plain = plainNumber(cell, style.decimal == '.' ? ',' : '.', 0);
    return plain ? read<Number>(*plain) : std::nullopt;
}

} // namespace

std::optional<double> styledNumber(std::string_view cell, const NumberStyle &style)
{
    return numberOf<double>(cell, style);
}

std::optional<long double> styledLongNumber(std::string_view cell, const NumberStyle &style)
{
    return numberOf<long double>(cell, style);
}

bool isMissingMark(std::string_view cell)
{
    if (cell.empty())
        return true;
    if (cell.size() > 10 || isDigit(cell.back()))
        return false;
    constexpr auto marks = std::to_array<std::string_view>(
        {"nan",      "-nan",      "+nan",    "nan(ind)", "-nan(ind)", "inf",    "+inf",      "-inf",
         "infinity", "-infinity", "na",      "n/a",      "#n/a",      "<na>",   "null",      "none",
         "nil",      "nd",        "n.d.",    "-",        "--",        "---",    "?",         "*",
         "**",       "***",       "#num!",   "#value!",  "#nv",       "#n/v",   "nv",        "n.v.",
         "#wert!",   "#zahl!",    "#div/0!", "lost",     "missing",   "<null>", "not found", "undefined"});
    return std::ranges::find(marks, lowerCaseAscii(cell)) != marks.end();
}

void NumberStyleSurvey::Column::Course::add(double value)
{
    if (!last) {
        low = high = value;
    } else {
        variation += std::abs(value - *last);
        falls += value < *last;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    last = value;
}

double NumberStyleSurvey::Column::Course::roughness() const
{
    return high > low ? variation / (high - low) : 0;
}

/// Whether a cell adds nothing: one of the signs is out already, and this number has one of the other.
bool NumberStyleSurvey::isDecided(std::string_view cell) const
{
    if (m_pointFits && m_commaFits)
        return false;
    if (!m_pointFits && !m_commaFits)
        return true;
    const char sign = m_pointFits ? '.' : ',', other = m_pointFits ? ',' : '.';
    const std::size_t at = cell.find(sign);
    return cell.find(other) == std::string_view::npos &&
           (at == std::string_view::npos || cell.find(sign, at + 1) == std::string_view::npos);
}

void NumberStyleSurvey::add(std::size_t column, std::string_view cell)
{
    if (cell.size() > longestNumber || cell.find_first_of("0123456789") == std::string_view::npos)
        return;
    const bool isMarked = cell.find_first_of(".,") != std::string_view::npos;
    if (isDecided(cell))
        return;
    const auto byPoint = plainNumber(cell, '.', ','), byComma = plainNumber(cell, ',', '.');
    if (!byPoint && !byComma)
        return; // no number at all: the reader will say so
    m_columns.resize(std::max(m_columns.size(), column + 1));
    Column &its = m_columns[column];
    constexpr auto lost = std::to_array<std::string_view>({"0", "-1", "-99", "-999", "-9999"});
    if (isMarked)
        ++its.marked;
    else if (std::ranges::find(lost, cell) == lost.end()) // they say nothing of how numbers are written
        ++its.plain;
    m_hasPoint = m_hasPoint || cell.find('.') != std::string_view::npos;
    m_hasComma = m_hasComma || cell.find(',') != std::string_view::npos;
    m_pointFits = m_pointFits && byPoint;
    m_commaFits = m_commaFits && byComma;
    if (!byPoint || !byComma)
        return;
    const double point = read<double>(*byPoint).value_or(0), comma = read<double>(*byComma).value_or(0);
    if (isMarked) {
        m_mark = cell.find('.') != std::string_view::npos ? '.' : ',';
        if (m_example.empty() || (m_example.front() == '0' && point != comma))
            m_example = cell;
    }
    its.decimal.add(std::min(point, comma) < 0 ? std::max(point, comma) : std::min(point, comma));
    its.grouped.add(std::min(point, comma) < 0 ? std::min(point, comma) : std::max(point, comma));
}

/// Of two readings that fit all cells: the one that gives a course without leaps, and times that rise.
std::optional<NumberStyle> NumberStyleSurvey::byCourse() const
{
    constexpr double clearlyRougher = 3;
    constexpr std::size_t enoughCells = 30, mostFalls = 2;
    const NumberStyle decimal{m_mark, 0, false}, grouped{m_mark == '.' ? ',' : '.', m_mark, false};
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const Column &column = m_columns[i];
        if (column.marked == 0)
            continue;
        // A stamp may be out of order; times of the wrong reading fall at each thousand.
        if (i == 0 && column.decimal.falls != column.grouped.falls &&
            std::min(column.decimal.falls, column.grouped.falls) <= mostFalls)
            return column.decimal.falls < column.grouped.falls ? decimal : grouped;
        const double asDecimal = column.decimal.roughness(), asGrouped = column.grouped.roughness();
        if (asDecimal > clearlyRougher * asGrouped)
            return grouped;
        if (asGrouped > clearlyRougher * asDecimal)
            return decimal;
        // Three decimals in so many cells, and none at all in others.
        if (column.marked >= enoughCells && column.plain > 0)
            return grouped;
    }
    return std::nullopt;
}

NumberStyleSurvey::Outcome NumberStyleSurvey::outcome() const
{
    constexpr NumberStyle point{'.', ',', false}, comma{',', '.', false};
    if (m_pointFits != m_commaFits)
        return {m_pointFits ? point : comma, false, m_pointFits ? m_hasComma : m_hasPoint, {}};
    if (!m_pointFits)
        return {{'.', 0, true}, false, false, {}};
    if (m_mark == 0)
        return {{'.', 0, false}, false, false, {}};
    if (const auto style = byCourse())
        return {*style, false, style->thousands != 0, {}};
    return {{m_mark, 0, false}, true, false, m_example};
}

} // namespace odo
