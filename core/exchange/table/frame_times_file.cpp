// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/table/frame_times_file.h"

#include "core/exchange/table/internal/table_columns.h"
#include "core/exchange/table/internal/table_reader.h"
#include "core/exchange/table/internal/track_times.h"
#include "core/exchange/text_file.h"
#include "core/files/file_words.h"

#include <algorithm>
#include <optional>
#include <string>

namespace odo {

namespace {

constexpr std::size_t mostTimesBytes = std::size_t(256) << 20;
constexpr int timesBetweenQuestions = 4096; // about cancellation

Message oneTimeForEachFrame()
{
    return ODO_TEXT("exchange.one_time_a_frame",
                    "give one time for each frame, in the order of the frames, under a name such as t_s");
}

/// Whether the cells are numbers or moments and no names.
bool areValues(const std::vector<std::string_view> &cells)
{
    return std::ranges::all_of(cells, [](std::string_view cell) {
        return cell.empty() || isMissingMark(cell) || stampOf(cell, {}) || stampOf(cell, {',', 0, false});
    });
}

/// The cells of one table, row by row, until its times are known.
class FrameTimesReader
{
public:
    FrameTimesReader(const std::filesystem::path &file, const TrackReading &reading,
                     const JobControl &control)
        : m_control(control), m_how{file, reading, {}, {}}
    {
    }
    Result<std::vector<Nanoseconds>> read();

private:
    Result<void> readRows();
    Result<void> takeFirst(std::string_view line);
    void addRow(std::string_view line, int number);
    void chooseColumn();
    Result<NumberStyle> style() const;
    Result<void> readStamps();

    const JobControl &m_control;
    Understanding m_how;
    RawTable m_table;
    RawTrack m_track;
    char m_delimiter = 0; ///< 0: not known yet
    bool m_hasHeader = false;
    std::size_t m_columnsOfRemark = 0; ///< of a header that may be a sentence; 0: it is none
    std::vector<std::string_view> m_cells;
    std::vector<std::vector<std::string>> m_rows; ///< the time; without a header the first two cells
};

/// A header, whether or not it begins as a comment does; or a row.
Result<void> FrameTimesReader::takeFirst(std::string_view line)
{
    const bool isRemark = line.starts_with('#');
    std::string_view content = line;
    content.remove_prefix(std::min(content.find_first_not_of("# "), content.size()));
    const char delimiter = delimiterOf(content);
    splitCells(content, delimiter, m_cells);
    m_columnsOfRemark = 0;
    auto column = timeColumnOf(m_cells);
    if (delimiter == ' ') { // a name may have blanks: "timestamps [seconds]"
        if (auto whole = timeColumnOf({content}))
            column = std::move(whole), m_cells.resize(1);
        m_columnsOfRemark = isRemark ? m_cells.size() : 0;
    }
    if (column && !*column)
        return m_how.wrong(1, column->error().why, column->error().advice);
    m_hasHeader = column.has_value();
    if (m_hasHeader) {
        m_table.columns.time = **column;
        m_delimiter = delimiter;
    } else if (!isRemark && areValues(m_cells)) {
        m_delimiter = delimiter;
    } else if (!isRemark) {
        return m_how.wrong(1, ODO_TEXT("exchange.no_time_column", "no column of it is called a time"),
                           oneTimeForEachFrame());
    }
    return {};
}

void FrameTimesReader::addRow(std::string_view line, int number)
{
    splitCells(line, m_delimiter, m_cells);
    if (std::ranges::all_of(m_cells, [](std::string_view cell) { return cell.empty(); }))
        return;
    const bool wasSentence = m_columnsOfRemark > 0 && m_columnsOfRemark != m_cells.size();
    if (m_rows.empty() && m_hasHeader && wasSentence)
        m_hasHeader = false;
    const auto cellAt = [this](std::size_t index) {
        return index < m_cells.size() ? std::string(m_cells[index]) : std::string();
    };
    std::vector<std::string> kept{cellAt(m_hasHeader ? m_table.columns.time->index : 0)};
    if (m_hasHeader && m_table.columns.time->nanoseconds)
        kept.push_back(cellAt(*m_table.columns.time->nanoseconds));
    else if (!m_hasHeader && m_cells.size() > 1)
        kept.push_back(cellAt(1));
    m_rows.push_back(std::move(kept));
    m_track.lines.push_back(number);
}

Result<void> FrameTimesReader::readRows()
{
    auto text = ODO_TRY(TextFile::open(m_how.file, mostTimesBytes, TextCoding::OfSpreadsheets));
    FileLines lines(std::move(text));
    for (;;) {
        if (lines.number() % timesBetweenQuestions == 0 && m_control.isCancelled())
            return cancelled(quotedFileSubject(m_how.file));
        const auto line = ODO_TRY(lines.next());
        if (!line)
            return {};
        const std::string_view content = withoutBlanks(*line);
        if (content.empty() || content.starts_with("sep="))
            continue;
        if (m_delimiter == 0) {
            ODO_TRY(takeFirst(content));
            if (m_hasHeader || m_delimiter == 0)
                continue;
        }
        if (!content.starts_with('#'))
            addRow(content, lines.number());
    }
}

/// Without a header: the second column where the first counts the rows.
void FrameTimesReader::chooseColumn()
{
    const auto counts = [this] {
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            const auto number = styledNumber(m_rows[i].front(), {});
            const auto before = i > 0 ? styledNumber(m_rows[i - 1].front(), {}) : std::nullopt;
            if (m_rows[i].size() < 2 || !number || (before && *number != *before + 1))
                return false;
        }
        return true;
    };
    const bool isSecond = !m_hasHeader && m_rows.size() > 1 && counts();
    if (m_hasHeader)
        return;
    m_table.columns.time = TableColumns::Time{isSecond ? std::size_t(1) : std::size_t(0), {}, {}};
    for (std::vector<std::string> &row : m_rows)
        row = {row[isSecond ? 1 : 0]};
}

Result<NumberStyle> FrameTimesReader::style() const
{
    if (m_delimiter == ',')
        return NumberStyle{'.', 0, false};
    NumberStyleSurvey survey;
    for (const std::vector<std::string> &row : m_rows)
        survey.add(0, row.front());
    const auto outcome = survey.outcome();
    if (outcome.isAmbiguous && outcome.style.decimal != '.') // nobody groups seconds by points
        return m_how.wrong(
            m_track.lines.front(),
            ODO_TEXT("exchange.times_in_two_ways",
                     "its times can be read in two ways: '%1' with three decimals, or without")(
                outcome.example),
            ODO_TEXT("exchange.write_decimal_point", "write them with a decimal point"));
    return outcome.style;
}

Result<void> FrameTimesReader::readStamps()
{
    const NumberStyle style = ODO_TRY(this->style());
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const std::vector<std::string> &row = m_rows[i];
        const std::optional<Stamp> stamp = stampOf(row.front(), style);
        const auto rest = row.size() > 1 ? styledLongNumber(row[1], style) : std::optional<long double>(0);
        const Stamp::Kind kind = stamp ? stamp->kind : Stamp::Kind::Number;
        if (!stamp || !rest || (i > 0 && kind != m_track.stampKind))
            return m_how.wrong(m_track.lines[i],
                               ODO_TEXT("exchange.frame_without_time", "it has no time that can be read"),
                               oneTimeForEachFrame());
        m_track.stampKind = kind;
        m_track.stamps.push_back(stamp->value + *rest / nanosecondsPer(TimeUnit::Second));
    }
    return {};
}

Result<std::vector<Nanoseconds>> FrameTimesReader::read()
{
    ODO_TRY(readRows());
    if (m_rows.empty())
        return m_how.wrong(0, fileIsEmpty(), oneTimeForEachFrame());
    chooseColumn();
    ODO_TRY(readStamps());
    auto times = ODO_TRY(statedTimesOf(m_track, m_table, m_how));
    const Nanoseconds start = times.front();
    for (std::size_t i = 1; i < times.size(); ++i)
        if (times[i] <= times[i - 1])
            return m_how.wrong(m_track.lines[i], whyNotLater(times[i - 1], times[i]), oneTimeForEachFrame());
    for (Nanoseconds &time : times)
        time -= start;
    return times;
}

} // namespace

Result<std::vector<Nanoseconds>> readFrameTimes(const std::filesystem::path &file,
                                                const TrackReading &reading, const JobControl &control)
{
    return FrameTimesReader(file, reading, control).read();
}

} // namespace odo
