// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace odo {

/// A row of a CSV file below its header, with the line it began on.
struct CsvRow
{
    int line = 0;
    std::vector<std::string> cells;
};

/// Reads the rows of a CSV file as they are (RFC 4180: commas, quoted cells, LF or CRLF; a byte order mark is allowed), with the
/// header. Blank lines are skipped. At most 1 MiB.
Result<std::vector<CsvRow>> readCsvRows(const std::filesystem::path &file);

/// Reads a CSV file (RFC 4180: commas, quoted cells, LF or CRLF; a byte order mark is allowed) whose header
/// line holds exactly these columns, in this order. Blank lines are skipped. At most 1 MiB, each row as wide
/// as the header. Errors name file and line.
Result<std::vector<CsvRow>> readCsvTable(const std::filesystem::path &file,
                                         const std::vector<std::string> &columns);

/// A cell read as a finite number with a point, whatever the locale.
Result<double> csvNumber(const std::filesystem::path &file, const CsvRow &row, std::size_t column,
                         const std::string &name);

/// A text as a cell has to hold it: quoted where it has the delimiter, a quote or a line break, and with an apostrophe in front where a
/// spreadsheet would take it as a formula (it begins with = + - @, a tab or CR, and is no number).
std::string csvText(const std::string &text, char delimiter);

/// The text of a cell that csvText has written, without such an apostrophe.
std::string csvTextOf(const std::string &cell);

} // namespace odo
