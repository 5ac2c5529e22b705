// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/roster_csv.h"

#include "core/base/plain_text.h"
#include "core/exchange/text_file.h"
#include "core/files/file_words.h"

#include <algorithm>
#include <map>
#include <optional>

namespace odo {

namespace {

/// Where a column of that name is, whatever the case of its letters.
std::optional<std::size_t> columnOf(const CsvRow &header, const std::string &name)
{
    for (std::size_t i = 0; i < header.cells.size(); ++i) {
        if (lowerCaseAscii(header.cells[i]) == name)
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

Message rosterSubject(const std::filesystem::path &file)
{
    return ODO_TEXT("exchange.roster", "roster '%1'")(Named::file(file.filename()));
}

} // namespace

tl::unexpected<Error> wrongLines(const std::filesystem::path &roster, std::vector<Message> sentences)
{
    constexpr std::size_t most = 10;
    if (sentences.size() > most) {
        const std::size_t more = sentences.size() - most;
        sentences.resize(most);
        sentences.push_back(ODO_TEXT("exchange.and_lines_more", "and %1 more lines")(more));
    }
    return fail(ErrorCode::InvalidInput, rosterSubject(roster), joined(std::move(sentences), Join::Semicolon),
                joined({ODO_TEXT("exchange.mend_lines", "correct these lines"),
                        ODO_TEXT("exchange.nothing_imported", "nothing was imported")},
                       Join::Semicolon));
}

Result<std::vector<RosterEntry>> readRosterCsv(const std::filesystem::path &file)
{
    const auto rows = ODO_TRY(readCsvRows(file));
    const Message advice =
        ODO_TEXT("exchange.begin_roster", "begin the file with the line class,team or class,team,pseudonym");
    if (rows.empty())
        return fail(ErrorCode::InvalidInput, atLine(file, 1), fileIsEmpty(), advice);
    const CsvRow &header = rows.front();
    const auto className = columnOf(header, "class"), team = columnOf(header, "team"),
               pseudonym = columnOf(header, "pseudonym"), members = columnOf(header, "members");
    if (!className || !team) {
        const bool semicolons =
            header.cells.size() == 1 && header.cells.front().find(';') != std::string::npos;
        return semicolons ? fail(ErrorCode::InvalidInput, atLine(file, header.line), separatedBySemicolons(),
                                 ODO_TEXT("exchange.save_with_commas", "save it with commas"))
                          : fail(ErrorCode::InvalidInput, atLine(file, header.line),
                                 ODO_TEXT("exchange.lacks_column", "it lacks the column %1")(
                                     std::string(className ? "team" : "class")),
                                 advice);
    }
    std::vector<RosterEntry> entries;
    std::vector<Message> bad;
    std::map<std::string, int> lineOf;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const CsvRow &row = rows[i];
        RosterEntry entry{row.line, cellOf(row, className), cellOf(row, team), cellOf(row, pseudonym),
                          partsOf(cellOf(row, members))};
        if (entry.team.empty())
            bad.push_back(ODO_TEXT("exchange.line_without_team", "line %1 has no team")(row.line));
        else if (entry.className.empty())
            bad.push_back(ODO_TEXT("exchange.line_without_class",
                                   "line %1 has no class for team '%2'")(row.line, Named::team(entry.team)));
        else if (const auto [first, isNew] = lineOf.try_emplace(entry.team, row.line); !isNew)
            bad.push_back(ODO_TEXT("exchange.team_named_again", "line %1 names team '%2' again, as line %3")(
                row.line, Named::team(entry.team), first->second));
        entries.push_back(std::move(entry));
    }
    if (!bad.empty())
        return wrongLines(file, std::move(bad));
    if (entries.empty())
        return fail(
            ErrorCode::InvalidInput, rosterSubject(file),
            ODO_TEXT("exchange.roster_is_empty", "it has no team"),
            ODO_TEXT("exchange.write_class_and_team", "write a line with class and team below the header"));
    return entries;
}

} // namespace odo
