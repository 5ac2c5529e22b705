// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/exchange/text_file.h"
#include "core/exchange/track_export.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace odo {

/// What comes before the header line of a table in this style.
inline std::string_view csvStart(CsvStyle style)
{
    return style == CsvStyle::Analysis ? "" : "\xef\xbb\xbf";
}

/// Builds one line of a table, cell by cell. Plain value.
class CsvLine
{
public:
    explicit CsvLine(CsvStyle style)
        : m_delimiter(style == CsvStyle::Continental ? ';' : ','), m_comma(style == CsvStyle::Continental)
    {
    }

    void number(double value)
    {
        std::string text = std::isfinite(value) ? numberText(value) : std::string();
        if (m_comma)
            std::replace(text.begin(), text.end(), '.', ',');
        m_cells.push_back(std::move(text));
    }
    void empty() { m_cells.emplace_back(); }
    void text(const std::string &text) { m_cells.push_back(csvText(text, m_delimiter)); }

    std::string take() const
    {
        std::string line;
        for (const std::string &cell : m_cells)
            line += cell + m_delimiter;
        return ended(std::move(line));
    }
    /// Only these cells, in this order.
    std::string take(std::span<const std::size_t> columns) const
    {
        std::string line;
        for (const std::size_t column : columns)
            line += m_cells[column] + m_delimiter;
        return ended(std::move(line));
    }

private:
    static std::string ended(std::string line)
    {
        line.back() = '\n'; // in place of the last delimiter
        return line;
    }

    const char m_delimiter;
    const bool m_comma;
    std::vector<std::string> m_cells;
};

} // namespace odo
