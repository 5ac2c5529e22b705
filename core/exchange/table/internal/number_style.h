// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// How a table writes its numbers; whatever the locale. Marks of thousands that can be nothing else (blanks,
/// also those of no width, and apostrophes) are always read. Plain value.
struct NumberStyle
{
    char decimal = '.';
    char thousands = 0; ///< 0: none
    /// Each cell decides by itself: one mark in it is its decimal sign.
    bool isMixed = false;
};

/// A whole cell as a finite number; nullopt: it is none in this style.
std::optional<double> styledNumber(std::string_view cell, const NumberStyle &style);
/// The same with as many digits as times since 1970 need.
std::optional<long double> styledLongNumber(std::string_view cell, const NumberStyle &style);

/// Whether a cell says that nothing was measured: blank, nan, inf, NA, null, none, a dash.
bool isMissingMark(std::string_view cell);

/// Decides the style of a table by all of its numbers.
class NumberStyleSurvey
{
public:
    /// column: of those that are asked, from 0; the first one holds the times.
    void add(std::size_t column, std::string_view cell);

    struct Outcome
    {
        NumberStyle style;
        bool isAmbiguous = false, isGrouped = false; ///< some number has marks of thousands
        std::string example;                         ///< of an ambiguous table: a cell that both readings fit
    };
    Outcome outcome() const;

private:
    struct Column
    {
        std::size_t marked = 0, plain = 0;
        /// Of both readings of its only mark, as decimal sign and as mark of thousands.
        struct Course
        {
            std::optional<double> last;
            double low = 0, high = 0, variation = 0;
            std::size_t falls = 0;
            void add(double value);
            double roughness() const;
        } decimal, grouped;
    };
    std::optional<NumberStyle> byCourse() const;
    bool isDecided(std::string_view cell) const;

    bool m_pointFits = true, m_commaFits = true, m_hasPoint = false, m_hasComma = false;
    char m_mark = 0; ///< the last one found
    std::string m_example;
    std::vector<Column> m_columns;
};

} // namespace odo
