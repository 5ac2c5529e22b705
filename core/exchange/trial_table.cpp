// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/trial_table.h"

#include "core/analysis/metric_table.h"
#include "core/base/plain_text.h"
#include "core/base/units.h"
#include "core/exchange/internal/csv_line.h"
#include "core/project/names.h"

#include <QDateTime>
#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <xlsxwriter.h>

namespace odo {

namespace {

/// "max_speed_m_s", "laps": one word.
std::string columnName(const TrialTableColumn &column)
{
    std::string name = column.metric;
    if (column.unit == "1")
        return name;
    name += '_';
    for (std::size_t i = 0; i < column.unit.size(); ++i) {
        if (column.unit.compare(i, 2, "²") == 0) {
            name += '2';
            ++i;
        } else {
            name += std::isalnum(static_cast<unsigned char>(column.unit[i])) ? column.unit[i] : '_';
        }
    }
    return name;
}

/// "var_surface": one word.
std::string variableName(const std::string &variable)
{
    std::string name = "var_" + variable;
    std::ranges::replace(name, ' ', '_');
    return name;
}

/// Empty: the trial does not have it.
std::string variableCell(const TrialTableRow &row, const std::string &variable)
{
    const auto found = row.trial.variables.find(variable);
    return found == row.trial.variables.end() ? std::string() : found->second;
}

std::string verdictCell(const TrialTableRow &row)
{
    if (row.robot.empty())
        return "not tracked";
    return row.verdict ? wordOf(*row.verdict) : std::string("unknown");
}

std::string lowerBounds(const ResultTable &table, const TrialTableRow &row)
{
    std::string names;
    for (std::size_t i = 0; i < table.columns.size(); ++i)
        if (row.metrics[i] && row.metrics[i]->isAtLeast)
            names += (names.empty() ? "" : "|") + table.columns[i].metric;
    return names;
}

/// Why its values are to be used with care.
std::string remarks(const TrialTableRow &row)
{
    std::vector<Message> sentences;
    if (row.trial.range)
        sentences.push_back(rangeSentence(row.trial));
    if (row.isMeasuredOtherwise)
        sentences.push_back(ODO_TEXT("exchange.measured_otherwise",
                                     "It was analysed with a different course than its task has now."));
    if (row.verdict) {
        for (const TrialCheck &check : row.verdict->checks)
            if (check.level != CheckLevel::Pass)
                sentences.push_back(check.text);
        if (row.verdict->isAccepted())
            sentences.push_back(
                ODO_TEXT("exchange.accepted", "Accepted: %1")(row.verdict->acceptance->reason));
    }
    return plainLine(joined(std::move(sentences), Join::Space).english());
}

QDateTime dateOf(const TrialRecord &trial)
{
    return QDateTime::fromMSecsSinceEpoch(trial.date.time_since_epoch().count());
}

constexpr std::array facts{"trial", "team", "class", "task", "robot", "date", "verdict"};

} // namespace

Result<void> writeTrialTableCsv(const ResultTable &table, CsvStyle style, const TextSink &sink)
{
    TextPieces text(sink);
    text.add(csvStart(style));
    CsvLine header(style);
    for (const char *fact : facts)
        header.text(fact);
    for (const std::string &variable : table.variables)
        header.text(variableName(variable));
    for (const TrialTableColumn &column : table.columns) {
        header.text(columnName(column));
        header.text("sigma_" + columnName(column));
    }
    header.text("at_least");
    header.text("remarks");
    text.add(header.take());
    for (const TrialTableRow &row : table.rows) {
        CsvLine line(style);
        for (const std::string &cell :
             {row.trial.name, row.trial.teamName, row.trial.className, row.trial.task, row.robot,
              dateOf(row.trial).toString(Qt::ISODate).toStdString(), verdictCell(row)})
            line.text(cell);
        for (const std::string &variable : table.variables) {
            const std::string cell = variableCell(row, variable);
            if (const auto number = parseNumber(cell))
                line.number(*number);
            else
                line.text(cell);
        }
        for (const std::optional<Metric> &metric : row.metrics) {
            for (const std::optional<double> &number : {metric ? std::optional(metric->value) : std::nullopt,
                                                        metric ? metric->sigma : std::nullopt})
                if (number)
                    line.number(*number);
                else
                    line.empty();
        }
        line.text(lowerBounds(table, row));
        line.text(remarks(row));
        text.add(line.take());
    }
    return text.finish();
}

namespace {

/// "Top speed (m/s)"
std::string heading(const TrialTableColumn &column)
{
    const MetricKind *kind = metricKind(column.metric);
    const std::string name = kind ? kind->name.english() : column.metric;
    return column.unit == "1" ? name : name + " (" + column.unit + ")";
}

/// The formats of a workbook's cells; they belong to the workbook.
class CellFormats
{
public:
    explicit CellFormats(lxw_workbook &workbook)
        : header(add(workbook)), date(add(workbook)), value(add(workbook)), sigma(add(workbook)),
          lowerBound(add(workbook)), count(add(workbook)), lowerCount(add(workbook)), percent(add(workbook)),
          doubtful(add(workbook)), bad(add(workbook))
    {
        constexpr lxw_color_t paleYellow = 0xffeb9c, paleRed = 0xffc7ce, grey = 0xd9d9d9;
        format_set_bold(header);
        format_set_text_wrap(header);
        format_set_bg_color(header, grey);
        format_set_num_format(date, "yyyy-mm-dd hh:mm:ss");
        format_set_num_format(value, "0.000");
        format_set_num_format(sigma, "0.0000");
        format_set_num_format(lowerBound, "\"≥ \"0.000");
        format_set_num_format(count, "0.###");
        format_set_num_format(lowerCount, "\"≥ \"0.###");
        format_set_num_format(percent, "0.0%");
        format_set_bg_color(doubtful, paleYellow);
        format_set_bg_color(bad, paleRed);
    }

    lxw_format *const header, *const date, *const value, *const sigma;
    lxw_format *const lowerBound, *const count, *const lowerCount, *const percent;
    lxw_format *const doubtful, *const bad;

    lxw_format *of(const TrialTableColumn &column, const Metric &metric) const
    {
        if (column.unit == "1")
            return metric.isAtLeast ? lowerCount : count;
        return metric.isAtLeast ? lowerBound : value;
    }
    lxw_format *of(const std::optional<TrialVerdict> &verdict) const
    {
        if (!verdict || verdict->isSound())
            return nullptr;
        return verdict->level() == CheckLevel::Bad ? bad : doubtful;
    }

private:
    static lxw_format *add(lxw_workbook &workbook) { return workbook_add_format(&workbook); }
};

/// Writes the cells of a row one after the other.
class SheetRow
{
public:
    SheetRow(lxw_worksheet &sheet, std::size_t row) : m_sheet(sheet), m_row(static_cast<lxw_row_t>(row)) {}

    void text(const std::string &text, lxw_format *format = nullptr)
    {
        constexpr int longest = 32'000; // a cell has at most 32,767
        const QByteArray cell = firstCharacters(QString::fromStdString(text), longest).toUtf8();
        worksheet_write_string(&m_sheet, m_row, m_column++, cell.constData(), format);
    }
    void number(double value, lxw_format *format)
    {
        if (std::isfinite(value))
            worksheet_write_number(&m_sheet, m_row, m_column, value, format);
        ++m_column;
    }
    void date(const QDateTime &date, lxw_format *format)
    {
        const QDate day = date.date();
        const QTime time = date.time();
        lxw_datetime cell{day.year(),  day.month(),   day.day(),
                          time.hour(), time.minute(), double(time.second())};
        worksheet_write_datetime(&m_sheet, m_row, m_column++, &cell, format);
    }
    void empty(int cells = 1) { m_column = static_cast<lxw_col_t>(m_column + cells); }

private:
    lxw_worksheet &m_sheet;
    const lxw_row_t m_row;
    lxw_col_t m_column = 0;
};

void fillHeader(lxw_worksheet &sheet, const ResultTable &table, const CellFormats &formats)
{
    SheetRow row(sheet, 0);
    for (const char *fact : {"Trial", "Team", "Class", "Task", "Robot", "Date", "Verdict"})
        row.text(fact, formats.header);
    for (const std::string &variable : table.variables)
        row.text(variable, formats.header);
    for (const TrialTableColumn &column : table.columns) {
        row.text(heading(column), formats.header);
        row.text("± " + heading(column), formats.header);
    }
    row.text("At least", formats.header);
    row.text("Remarks", formats.header);
}

void fillRow(lxw_worksheet &sheet, std::size_t position, const ResultTable &table, const CellFormats &formats)
{
    const TrialTableRow &from = table.rows[position];
    SheetRow row(sheet, position + 1);
    for (const std::string &cell :
         {from.trial.name, from.trial.teamName, from.trial.className, from.trial.task, from.robot})
        row.text(cell);
    row.date(dateOf(from.trial), formats.date);
    row.text(verdictCell(from), formats.of(from.verdict));
    for (const std::string &variable : table.variables) {
        const std::string cell = variableCell(from, variable);
        if (const auto number = parseNumber(cell))
            row.number(*number, nullptr);
        else
            row.text(cell);
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::optional<Metric> &metric = from.metrics[i];
        if (!metric) {
            row.empty(2);
            continue;
        }
        row.number(metric->value, formats.of(table.columns[i], *metric));
        if (metric->sigma)
            row.number(*metric->sigma, formats.sigma);
        else
            row.empty();
    }
    row.text(lowerBounds(table, from));
    row.text(remarks(from));
}

void addStatistics(lxw_workbook &workbook, const ResultTable &table, const CellFormats &formats)
{
    lxw_worksheet *sheet = workbook_add_worksheet(&workbook, "Statistics");
    if (!sheet)
        return;
    SheetRow header(*sheet, 0);
    for (const char *title :
         {"Metric", "Group", "Runs", "Mean", "± Mean", "Median", "Standard deviation", "CV", "Least", "Most"})
        header.text(title, formats.header);
    for (std::size_t i = 0; i < table.statistics.size(); ++i) {
        const ResultStatistics &from = table.statistics[i];
        SheetRow row(*sheet, i + 1);
        row.text(heading(table.columns[from.column]));
        row.text(from.group);
        row.number(static_cast<double>(from.count), formats.count);
        const auto add = [&row](const std::optional<double> &value, lxw_format *format) {
            if (value)
                row.number(*value, format);
            else
                row.empty();
        };
        row.number(from.mean, formats.value);
        add(from.meanSigma, formats.sigma);
        row.number(from.median, formats.value);
        add(from.deviation, formats.sigma);
        add(from.variation, formats.percent);
        row.number(from.least, formats.value);
        row.number(from.most, formats.value);
    }
    constexpr double nameWidth = 24, numberWidth = 14;
    constexpr lxw_col_t lastName = 1, last = 9;
    worksheet_set_column(sheet, 0, lastName, nameWidth, nullptr);
    worksheet_set_column(sheet, lastName + 1, last, numberWidth, nullptr);
    worksheet_freeze_panes(sheet, 1, 0);
}

struct EndOfWorkbook
{
    void operator()(lxw_workbook *workbook) const { lxw_workbook_free(workbook); }
};

} // namespace

Result<void> writeTrialTableXlsx(const ResultTable &table, const OutputTarget &target)
{
    const auto output = ODO_TRY(OutputFile::open(target, FileKind::Xlsx));
    std::unique_ptr<lxw_workbook, EndOfWorkbook> workbook(workbook_new(output->temporary().c_str()));
    lxw_worksheet *sheet = workbook ? workbook_add_worksheet(workbook.get(), "Trials") : nullptr;
    if (!sheet)
        return output->failure("out of memory");
    const CellFormats formats(*workbook);
    fillHeader(*sheet, table, formats);
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        fillRow(*sheet, i, table, formats);
    constexpr double nameWidth = 18, numberWidth = 14, remarksWidth = 80;
    const auto first = static_cast<lxw_col_t>(facts.size());
    const auto behind = static_cast<lxw_col_t>(first + table.variables.size() + 2 * table.columns.size());
    worksheet_set_column(sheet, 0, first, nameWidth, nullptr);
    worksheet_set_column(sheet, first, behind, numberWidth, nullptr);
    worksheet_set_column(sheet, behind + 1, behind + 1, remarksWidth, nullptr);
    worksheet_freeze_panes(sheet, 1, 1);
    worksheet_autofilter(sheet, 0, 0, static_cast<lxw_row_t>(table.rows.size()), behind + 1);
    if (!table.statistics.empty())
        addStatistics(*workbook, table, formats);
    // frees it, whatever the outcome
    if (const lxw_error problem = workbook_close(workbook.release()); problem != LXW_NO_ERROR)
        return output->failure(lxw_strerror(problem));
    return output->commit();
}

} // namespace odo
