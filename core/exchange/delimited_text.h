// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// Tables as other programs write them, line by line and without a copy of the text; any thread, whatever the locale.

/// Walks through the lines of a text, which must outlive it; LF or CRLF.
class TextLines
{
public:
    explicit TextLines(std::string_view text) : m_text(text) {}
    /// The next line without its end; nullopt behind the last one.
    std::optional<std::string_view> next();
    int number() const { return m_number; } ///< of the line that next() gave last, from 1

private:
    std::string_view m_text;
    std::size_t m_position = 0;
    int m_number = 0;
};

std::string_view withoutBlanks(std::string_view text);

/// What parts the cells of a header line: a tab, or else ';', or else ',', or else blanks.
char delimiterOf(std::string_view header);

/// The cells of a line, without blanks and quotes around them; one that is quoted may hold the delimiter. With a blank as
/// delimiter several of them count as one.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view> &cells);

/// A whole cell as a finite number, with a point, or with a comma where that parts no cells.
std::optional<double> cellNumber(std::string_view cell, char delimiter);

/// A whole cell as a time in a unit of so many seconds, exact to the nanosecond (a double is not, for times since 1970); nullopt
/// also where it is beyond four thousand million seconds.
std::optional<Nanoseconds> cellTime(std::string_view cell, char delimiter, double secondsPerUnit);

} // namespace odo
