// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/internal/table_reader.h"

#include "core/base/plain_text.h"
#include "core/exchange/table/internal/column_name.h"
#include "core/exchange/table/internal/course.h"
#include "core/exchange/table/internal/headerless.h"
#include "core/exchange/table/internal/stamps.h"
#include "core/exchange/table/internal/table_rows.h"
#include "core/exchange/text_file.h"
#include "core/files/file_words.h"

#include <algorithm>
#include <optional>

namespace odo {

namespace {

constexpr std::size_t mostTrackBytes = std::size_t(256) << 20;
constexpr int linesAboveHeader = 60;
constexpr int linesBetweenQuestions = 4096; // about cancellation

/// Walks through a file: to its header, and from there row by row.
class TableReader
{
public:
    TableReader(const std::filesystem::path &file, const TrackReading &reading, const JobControl &control)
        : m_file(file), m_reading(reading), m_control(control)
    {
    }

    Result<RawTable> read()
    {
        ODO_TRY(open(0));
        ODO_TRY(findHeader());
        const NumberStyle style = ODO_TRY(surveyed());
        TableRows rows(m_table, style, m_delimiter, m_reading, m_file);
        std::optional<Error> cut; // of a row that may be the last one
        int cutLine = 0;
        while (ODO_TRY(nextRow())) {
            if (cut)
                return tl::unexpected(*cut);
            auto added = rows.add(m_cells, m_lines->number());
            if (!added && !rows.isCut(m_cells))
                return tl::unexpected(added.error());
            if (!added)
                cut = added.error(), cutLine = m_lines->number();
        }
        auto table = ODO_TRY(rows.finish(m_lines->number()));
        table.cutLine = cutLine;
        ODO_TRY(checkAssumed(table));
        return table;
    }

private:
    Result<void> open(double from)
    {
        m_from = from;
        auto text = ODO_TRY(TextFile::open(m_file, mostTrackBytes, TextCoding::OfSpreadsheets));
        m_lines.emplace(std::move(text));
        return {};
    }
    tl::unexpected<Error> wrong(Message why, Message advice) const
    {
        return fail(ErrorCode::InvalidInput, atLineOf(m_file, m_reading, std::max(1, m_lines->number())),
                    std::move(why), std::move(advice));
    }
    Result<bool> nextLine();
    Result<bool> nextRow();
    Result<void> findHeader();
    Result<bool> findTrcHeader();
    Result<bool> takeHeader(std::string_view line);
    void rememberRemark(std::string_view content);
    bool takeHeaderless();
    void lookForUnit();
    Result<NumberStyle> surveyed();
    Result<void> readUnitsRow();
    Result<void> checkAssumed(const RawTable &table) const;

    const std::filesystem::path &m_file;
    const TrackReading &m_reading;
    const JobControl &m_control;
    std::optional<FileLines> m_lines;
    double m_from = 0; ///< share of the work that is done before this pass
    std::string_view m_line;
    char m_delimiter = ' ';
    std::vector<std::string_view> m_cells, m_above;
    std::string m_lineAbove;
    RawTable m_table;
    std::optional<TableColumns> m_remark;  ///< the last one that may be a header
    std::optional<LengthUnit> m_unitAbove; ///< as the lines above the header say it
    bool m_isFirstRowWaiting = false;      ///< m_line is a row already
    int m_rowsAfter = 0;                   ///< the line in front of the first row
};

/// False in the value: there is none; asks for cancellation.
Result<bool> TableReader::nextLine()
{
    if (m_lines->number() % linesBetweenQuestions == 0) {
        if (m_control.isCancelled())
            return cancelled(quotedFileSubject(m_file));
        m_control.report(m_from + (0.5 - m_from) * m_lines->doneShare(),
                         ODO_TEXT("exchange.reading_line", "reading line %1")(m_lines->number()));
    }
    const auto line = ODO_TRY(m_lines->next());
    m_line = line.value_or(std::string_view());
    return line.has_value();
}

/// The next row's cells; blank rows and comments are passed over.
Result<bool> TableReader::nextRow()
{
    for (;;) {
        if (!m_isFirstRowWaiting && !ODO_TRY(nextLine()))
            return false;
        m_isFirstRowWaiting = false;
        if (m_line.starts_with('#'))
            continue;
        splitCells(m_line, m_delimiter, m_cells);
        if (std::ranges::any_of(m_cells, [](std::string_view cell) { return !cell.empty(); }))
            return true;
    }
}

/// "# t_s x_m y_m", as NumPy writes it; only the rows show that it is no sentence.
void TableReader::rememberRemark(std::string_view content)
{
    std::vector<std::string_view> cells;
    splitCells(content.substr(1), ' ', cells);
    auto header = tableColumnsOf(cells, {});
    if (header && *header)
        m_remark = std::move(**header);
}

/// Lines without a header, of a known format or as a remark names their columns. False: it is not known what
/// they hold.
bool TableReader::takeHeaderless()
{
    if (m_delimiter != ',' && m_delimiter != ';')
        m_delimiter = ' '; // tabs part as well
    splitCells(m_line, m_delimiter, m_cells);
    const bool isRemarked =
        m_remark && m_remark->columns == m_cells.size() && m_remark->columns != tumColumns().columns;
    auto columns = isRemarked ? m_remark : headerlessColumns(m_cells, m_delimiter);
    if (!columns)
        return false;
    m_table.columns = std::move(*columns);
    m_isFirstRowWaiting = true;
    m_rowsAfter = m_lines->number() - 1;
    return true;
}

/// False in the value: the line is no header, whatever parts its cells.
Result<bool> TableReader::takeHeader(std::string_view line)
{
    m_delimiter = delimiterOf(line);
    splitCells(line, m_delimiter, m_cells);
    auto header = tableColumnsOf(m_cells, m_above);
    if (!header)
        return false;
    if (!*header)
        return wrong(header->error().why, header->error().advice);
    m_table.columns = std::move(**header);
    if (m_cells.back()
            .empty()) { // Tracker ends its lines with a delimiter, Motive with a column without name
        --m_table.columns.columns;
        m_table.columns.mayHaveUnnamed = true;
    }
    for (TrackColumns &track : m_table.columns.tracks) {
        for (LengthColumn *column : {&track.x, &track.y, track.z ? &*track.z : nullptr}) {
            if (column && !column->unit)
                column->unit = m_unitAbove;
        }
    }
    m_rowsAfter = m_lines->number();
    return true;
}

bool beginsAsNumber(std::string_view line)
{
    const std::string_view content = withoutBlanks(line);
    std::vector<std::string_view> cells;
    const char delimiter = delimiterOf(content);
    splitCells(content.substr(0, 200), delimiter, cells);
    return !cells.empty() && (cellNumber(cells[0], delimiter) || lowerCaseAscii(cells[0]) == "nan");
}

/// Behind the line "PathFileType ...": names and values of the head, markers, axes.
Result<bool> TableReader::findTrcHeader()
{
    std::vector<std::string_view> names;
    m_delimiter = '\t';
    std::string head, unit;
    if (!ODO_TRY(nextLine()))
        return false;
    head = m_line;
    splitCells(head, m_delimiter, names);
    if (!ODO_TRY(nextLine()))
        return false;
    splitCells(m_line, m_delimiter, m_cells);
    for (std::size_t i = 0; i < std::min(names.size(), m_cells.size()); ++i) {
        if (lowerCaseAscii(names[i]) == "units")
            unit = m_cells[i];
    }
    if (!ODO_TRY(nextLine()))
        return false;
    splitCells(m_line, m_delimiter, m_cells);
    auto columns = trcColumns(m_cells, unit);
    if (!columns || !ODO_TRY(nextLine())) // the axes
        return false;
    m_table.columns = std::move(*columns);
    m_rowsAfter = m_lines->number();
    return true;
}

/// Motive: "...,Length Units,Millimeters" above the header.
void TableReader::lookForUnit()
{
    for (std::size_t i = 0; i + 1 < m_cells.size(); ++i) {
        if (lowerCaseAscii(m_cells[i]) == "length units")
            m_unitAbove = lengthUnitNamed(lowerCaseAscii(m_cells[i + 1]));
        else if (m_cells[i] == "NO_OF_MARKERS") // Qualisys writes millimetres and does not say so
            m_unitAbove = LengthUnit::Millimetre;
    }
}

Result<void> TableReader::findHeader()
{
    int above = 0;
    while (ODO_TRY(nextLine())) {
        const std::string_view content = withoutBlanks(m_line);
        m_table.isTracker = m_table.isTracker || m_line.starts_with("#multi:");
        if (content.empty() || m_line.starts_with("sep="))
            continue;
        if (content.starts_with("PathFileType")) {
            if (ODO_TRY(findTrcHeader()))
                return {};
            break;
        }
        if (content.starts_with('#')) { // EuRoC's header; a comment of TUM is none
            if (delimiterOf(content) != ' ' && ODO_TRY(takeHeader(content)))
                return {};
            if (delimiterOf(content) == ' ')
                rememberRemark(content);
            continue;
        }
        m_delimiter = delimiterOf(m_line);
        splitCells(m_line, m_delimiter, m_cells);
        const bool isNumberAlone = above > 0 && m_cells.size() == 1; // Vicon's rate
        const std::size_t clockCells = m_remark && m_delimiter == ' ' ? m_remark->columns : 3;
        const bool isClock =
            above == 0 && m_cells.size() == clockCells && stampOf(m_cells[0], {}).has_value();
        if ((beginsAsNumber(m_line) && !isNumberAlone) || isClock) {
            if (above > 0 || !takeHeaderless())
                break;
            return {};
        }
        lookForUnit();
        if (ODO_TRY(takeHeader(m_line))) {
            const bool isBare = withoutBlanks(m_cells[0]) == "t" && !m_table.columns.hasUnits;
            if (m_table.columns.format == TrackFormat::Csv && (m_table.isTracker || isBare || above > 0))
                m_table.columns.format = TrackFormat::Tracker;
            return {};
        }
        m_lineAbove = m_line;
        m_above = {withoutBlanks(m_lineAbove)}; // a name may have blanks
        if (m_delimiter != ' ')
            splitCells(m_lineAbove, m_delimiter, m_above);
        if (++above == linesAboveHeader)
            break;
    }
    return wrong(m_lines->number() == 0
                     ? fileIsEmpty()
                     : ODO_TEXT("exchange.neither_header_nor_tum",
                                "it has no header with a time, x and y, and it is not a TUM file"),
                 beginWithHeaderOrTum());
}

/// Below some headers stands a row of units.
Result<void> TableReader::readUnitsRow()
{
    TableColumns &columns = m_table.columns;
    if (m_isFirstRowWaiting || !columns.time || !ODO_TRY(nextRow()))
        return {};
    m_isFirstRowWaiting = true;
    const auto unitAt = [&](std::size_t index) {
        std::string_view cell = index < m_cells.size() ? m_cells[index] : std::string_view();
        if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '('))
            cell = cell.substr(1, cell.size() - 2);
        return lowerCaseAscii(cell);
    };
    const auto time = timeUnitNamed(unitAt(columns.time->index));
    const auto length = lengthUnitNamed(unitAt(columns.tracks.front().x.index));
    if (!length || (!time && !unitAt(columns.time->index).empty()))
        return {};
    if (time)
        columns.time->unit = time;
    for (TrackColumns &track : columns.tracks) {
        for (LengthColumn *column :
             {&track.x, &track.y, track.z ? &*track.z : nullptr, track.sigmaX ? &*track.sigmaX : nullptr,
              track.sigmaY ? &*track.sigmaY : nullptr}) {
            if (column)
                column->unit = lengthUnitNamed(unitAt(column->index));
        }
    }
    columns.hasUnits = true;
    if (columns.format == TrackFormat::Tracker && !m_table.isTracker)
        columns.format = TrackFormat::Csv;
    m_isFirstRowWaiting = false;
    m_rowsAfter = m_lines->number();
    return {};
}

/// How the rows write their numbers, with the file at its first row again.
Result<NumberStyle> TableReader::surveyed()
{
    ODO_TRY(readUnitsRow());
    if (m_reading.decimal)
        return *m_reading.decimal == DecimalSign::Point ? NumberStyle{'.', ',', false}
                                                        : NumberStyle{',', '.', false};
    // Of cells that commas part, only those in quotes can have one.
    const bool isQuoted = m_isFirstRowWaiting && m_line.find('"') != std::string_view::npos;
    if (m_delimiter == ',' && !isQuoted)
        return NumberStyle{'.', ',', false};
    std::vector<std::size_t> asked;
    asked.push_back(m_table.columns.time ? m_table.columns.time->index : m_table.columns.columns);
    for (const TrackColumns &track : m_table.columns.tracks) {
        asked.insert(asked.end(), {track.x.index, track.y.index});
        if (track.z)
            asked.push_back(track.z->index);
    }
    NumberStyleSurvey survey;
    while (ODO_TRY(nextRow())) {
        for (std::size_t i = 0; i < asked.size(); ++i) {
            if (asked[i] < m_cells.size())
                survey.add(i, m_cells[asked[i]]);
        }
    }
    const auto outcome = survey.outcome();
    if (outcome.isAmbiguous) {
        std::string without = outcome.example;
        std::erase(without, outcome.style.decimal);
        return fail(ErrorCode::InvalidInput, atLineOf(m_file, m_reading, m_rowsAfter + 1),
                    ODO_TEXT("exchange.number_in_two_ways",
                             "its numbers can be read in two ways: '%1' with three decimals, or as %2")(
                        outcome.example, without),
                    ODO_TEXT("exchange.choose_decimal_sign", "choose its decimal sign: point or comma"));
    }
    m_table.thousands = outcome.isGrouped ? outcome.style.thousands : 0;
    ODO_TRY(open(0.25));
    while (m_lines->number() < m_rowsAfter) {
        if (!ODO_TRY(nextLine()))
            break;
    }
    m_isFirstRowWaiting = false;
    return outcome.style;
}

Result<void> TableReader::checkAssumed(const RawTable &table) const
{
    const RawTrack &track = table.tracks.front();
    const bool isKnown = !table.columns.areAssumed || track.stampKind != Stamp::Kind::Number;
    if (isKnown || (mayBeTimes(track.stamps) && (spreadOf(track.x) > 0 || spreadOf(track.y) > 0)))
        return {};
    return fail(ErrorCode::InvalidInput, atLineOf(m_file, m_reading, m_rowsAfter + 1),
                ODO_TEXT("exchange.no_header_and_no_times",
                         "it has no header, and its columns do not look like time, x and y"),
                beginWithHeaderOrTum());
}

} // namespace

Message atLineOf(const std::filesystem::path &file, const TrackReading &reading, int line)
{
    return atLine(reading.shownAs.empty() ? file : reading.shownAs, line);
}

std::size_t mostBadRows(std::size_t rows)
{
    constexpr std::size_t least = 10, one = 50;
    return rows < least ? 0 : std::max<std::size_t>(1, rows / one);
}

Message beginWithHeaderOrTum()
{
    return ODO_TEXT("exchange.begin_with_header_or_tum",
                    "begin the file with the line %1, or write lines of %2")(
        std::string("t_s,x_mm,y_mm"), std::string("timestamp tx ty tz qx qy qz qw"));
}

Result<RawTable> readRawTable(const std::filesystem::path &file, const TrackReading &reading,
                              const JobControl &control)
{
    return TableReader(file, reading, control).read();
}

} // namespace odo
