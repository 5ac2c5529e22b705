// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/roster_csv.h"

#include "core/exchange/internal/delimited_text.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

namespace odo {

namespace {

/// Where a column of that name is, whatever the case of its letters.
std::optional<std::size_t> columnOf(const CsvRow &header, const std::string &name)
{
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
        std::string cell = header.cells[i];
        std::ranges::transform(cell, cell.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (cell == name)
            return i;
    }
    return std::nullopt;
}

std::string cellOf(const CsvRow &row, std::optional<std::size_t> column)
{
    return column && *column < row.cells.size() ? row.cells[*column] : std::string();
}

/// Names between semicolons, without the blanks around them.
std::vector<std::string> partsOf(const std::string &cell)
{
    std::vector<std::string> parts;
    std::size_t start = 0;
    while (start <= cell.size()) {
        const std::size_t end = std::min(cell.find(';', start), cell.size());
        const std::size_t first = cell.find_first_not_of(" \t", start);
        if (first < end)
            parts.push_back(cell.substr(first, cell.find_last_not_of(" \t", end - 1) - first + 1));
        start = end + 1;
    }
    return parts;
}

} // namespace

std::string joinedLines(const std::vector<std::string> &sentences)
{
    constexpr std::size_t most = 10;
    std::string joined;
    for (std::size_t i = 0; i < std::min(most, sentences.size()); ++i)
        joined += (joined.empty() ? "" : "; ") + sentences[i];
    if (sentences.size() > most)
        joined += "; and " + std::to_string(sentences.size() - most) + " lines more";
    return joined;
}

Result<std::vector<RosterEntry>> readRosterCsv(const std::filesystem::path &file)
{
    const auto rows = readCsvRows(file);
    if (!rows)
        return tl::unexpected(rows.error());
    const std::string advice = "begin the file with the line class,team or class,team,pseudonym";
    if (rows->empty())
        return fail(ErrorCode::InvalidInput, atLine(file, 1), "the file is empty", advice);
    const CsvRow &header = rows->front();
    const auto className = columnOf(header, "class"), team = columnOf(header, "team"),
               pseudonym = columnOf(header, "pseudonym"), members = columnOf(header, "members");
    if (!className || !team) {
        const bool semicolons =
            header.cells.size() == 1 && header.cells.front().find(';') != std::string::npos;
        return fail(ErrorCode::InvalidInput, atLine(file, header.line),
                    semicolons ? "its columns are separated by semicolons"
                               : "it lacks the column " + std::string(className ? "team" : "class"),
                    semicolons ? std::string("save it with commas") : advice);
    }
    const std::string what = "roster '" + file.filename().string() + "'";
    std::vector<RosterEntry> entries;
    std::vector<std::string> bad;
    std::map<std::string, int> lineOf;
    for (std::size_t i = 1; i < rows->size(); ++i) {
        const CsvRow &row = (*rows)[i];
        RosterEntry entry{row.line, cellOf(row, className), cellOf(row, team), cellOf(row, pseudonym),
                          partsOf(cellOf(row, members))};
        const std::string line = "line " + std::to_string(row.line);
        if (entry.team.empty())
            bad.push_back(line + " has no team");
        else if (entry.className.empty())
            bad.push_back(line + " has no class for team '" + entry.team + "'");
        else if (const auto [first, isNew] = lineOf.try_emplace(entry.team, row.line); !isNew)
            bad.push_back(line + " names team '" + entry.team + "' again, as line " +
                          std::to_string(first->second));
        entries.push_back(std::move(entry));
    }
    if (!bad.empty())
        return fail(ErrorCode::InvalidInput, what, joinedLines(bad),
                    "mend these lines; nothing was imported");
    if (entries.empty())
        return fail(ErrorCode::InvalidInput, what, "it has no team",
                    "write a line with class and team below the header");
    return entries;
}

} // namespace odo
