// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/exchange/text_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

/// Tables as other programs write them, line by line and without the whole text in memory; whatever the
/// locale.

/// Walks through the lines of a text file; LF or CRLF. One thread at a time.
class FileLines
{
public:
    explicit FileLines(TextFile file) : m_file(std::move(file)) {}
    /// The next line without its end, until the one after it is asked for; nullopt behind the last one.
    /// Errors: those of TextFile, and a line of more than 8 MiB.
    Result<std::optional<std::string_view>> next();
    int number() const { return m_number; } ///< of the line that next() gave last, from 1
    double doneShare() const;               ///< of the file

private:
    TextFile m_file;
    std::string m_text; ///< what was read of it and not given yet, and what next() gave last
    std::size_t m_position = 0, m_given = 0;
    int m_number = 0;
    bool m_atEnd = false;
};

std::string_view withoutBlanks(std::string_view text);

/// What parts the cells of a header line: a tab, or else ';', or else ',', or else blanks.
char delimiterOf(std::string_view header);

/// The cells of a line, without blanks and quotes around them; one that is quoted may hold the delimiter.
/// With a blank as delimiter several of them count as one.
void splitCells(std::string_view line, char delimiter, std::vector<std::string_view> &cells);

/// A whole cell as a finite number, with a point, or with a comma where that parts no cells.
std::optional<double> cellNumber(std::string_view cell, char delimiter);

/// A whole cell as a time in a unit of so many seconds, exact to the nanosecond (a double is not, for times
/// since 1970); nullopt also where it is beyond four thousand million seconds.
std::optional<Nanoseconds> cellTime(std::string_view cell, char delimiter, double secondsPerUnit);

/// A row of a CSV file below its header, with the line it began on.
struct CsvRow
{
    int line = 0;
    std::vector<std::string> cells;
};

/// Reads the rows of a CSV file as they are (RFC 4180: commas, quoted cells, LF or CRLF; a byte order mark is
/// allowed), with the header. Blank lines are skipped. At most 1 MiB.
Result<std::vector<CsvRow>> readCsvRows(const std::filesystem::path &file);

/// Reads a CSV file (RFC 4180: commas, quoted cells, LF or CRLF; a byte order mark is allowed) whose header
/// line holds exactly these columns, in this order. Blank lines are skipped. At most 1 MiB, each row as wide
/// as the header. Errors name file and line.
Result<std::vector<CsvRow>> readCsvTable(const std::filesystem::path &file,
                                         const std::vector<std::string> &columns);

/// A cell read as a finite number with a point, whatever the locale.
Result<double> csvNumber(const std::filesystem::path &file, const CsvRow &row, std::size_t column,
                         const std::string &name);

/// A text as a cell has to hold it: quoted where it has the delimiter, a quote or a line break, and with an
/// apostrophe in front where a spreadsheet would take it as a formula (it begins with = + - @, a tab or CR,
/// and is no number).
std::string csvText(const std::string &text, char delimiter);

/// The text of a cell that csvText has written, without such an apostrophe.
std::string csvTextOf(const std::string &cell);

} // namespace odo
