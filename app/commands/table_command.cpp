// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/commands.h"
#include "core/base/file_system.h"
#include "core/exchange/own_metric.h"
#include "core/workflow/trials/trial_table_reading.h"

#include <QJsonArray>
#include <QSet>

namespace odo {

namespace {

QJsonObject rowJson(const ResultTable &table, const TrialTableRow &row)
{
    QJsonObject metrics;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::optional<Metric> &metric = row.metrics[i];
        const QString name = QString::fromStdString(table.columns[i].metric);
        if (metric)
            metrics.insert(name, QJsonObject{{QStringLiteral("value"), metric->value},
                                             {QStringLiteral("sigma"), optionalJson(metric->sigma)},
                                             {QStringLiteral("unit"), QString::fromStdString(metric->unit)},
                                             {QStringLiteral("at_least"), metric->isAtLeast}});
        else if (!metrics.contains(name))
            metrics.insert(name, QJsonValue());
    }
    return {{QStringLiteral("trial"), QString::fromStdString(row.trial.name)},
            {QStringLiteral("team"), QString::fromStdString(row.trial.teamName)},
            {QStringLiteral("class"), QString::fromStdString(row.trial.className)},
            {QStringLiteral("task"), QString::fromStdString(row.trial.task)},
            {QStringLiteral("robot"),
             row.robot.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(row.robot))},
            {QStringLiteral("date"), dateText(row.trial.date)},
            {QStringLiteral("verdict"), row.verdict ? verdictLevelJson(*row.verdict) : QJsonValue()},
            {QStringLiteral("different_course"), row.isMeasuredOtherwise},
            {QStringLiteral("metrics"), metrics}};
}

QJsonArray rowsJson(const ResultTable &table)
{
    QJsonArray rows;
    for (const TrialTableRow &row : table.rows)
        rows.append(rowJson(table, row));
    return rows;
}

Result<TrialTableChoice> choiceOf(const CommandCall &call)
{
    TrialTableChoice choice{
        call.value(option::ofClass), call.value(option::task), call.value(option::team), {}};
    QSet<QString> metrics;
    for (const QString &value : call.values(option::metrics))
        for (const QString &metric : value.split(u',', Qt::SkipEmptyParts))
            if (const QString name = metric.trimmed(); !metrics.contains(name)) {
                metrics.insert(name);
                choice.metrics.push_back(name.toStdString());
            }
    if (call.isSet(option::metrics) && choice.metrics.empty())
        return call.wrongCall(ODO_TEXT("app.no_metric_named", "--metrics names no metric"));
    return choice;
}

/// "energy J=0.5 * mass * max_speed^2"
Result<std::vector<OwnMetric>> formulasOf(const CommandCall &call)
{
    std::vector<OwnMetric> metrics;
    for (const QString &value : call.values(option::formula)) {
        const QString left = value.section(u'=', 0, 0).simplified();
        if (!value.contains(u'='))
            return call.wrongCall(
                ODO_TEXT("app.formula_is", "--formula is like 'energy J=0.5 * mass * max_speed^2'"));
        metrics.push_back({left.section(u' ', 0, 0).toStdString(), left.section(u' ', 1).toStdString(),
                           value.section(u'=', 1).toStdString()});
        if (const auto fine = checkOwnMetric(metrics.back()); !fine)
            return tl::unexpected(fine.error());
    }
    return metrics;
}

Result<ResultTable> tableOf(Project &project, const TrialTableChoice &choice,
                            const std::vector<OwnMetric> &formulas)
{
    auto table = ODO_TRY(readTrialTable(project, choice));
    ODO_TRY(addOwnMetrics(table, formulas));
    return table;
}

enum class Form { Csv, Xlsx };

/// By the name's ending; what is printed is CSV.
Result<Form> formOf(const CommandCall &call, const QString &file)
{
    if (file == standardOutput || file.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive))
        return Form::Csv;
    if (file.endsWith(QStringLiteral(".xlsx"), Qt::CaseInsensitive))
        return Form::Xlsx;
    return call.wrongCall(
        ODO_TEXT("app.table_is_csv_or_xlsx", "'%1' is neither a .csv nor an .xlsx file")(file.toStdString()));
}

Result<void> writeTable(const ResultTable &table, Form form, CsvStyle style, const OutputTarget &target)
{
    if (form == Form::Xlsx)
        return writeTrialTableXlsx(table, target);
    return writeOutput(target, [&](const TextSink &sink) { return writeTrialTableCsv(table, style, sink); });
}

} // namespace

Result<void> runTable(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("table"),
         QStringLiteral("P.odo [--class C] [--task TASK] [--team T] [--metrics METRIC[,...]] -o "
                        "FILE.csv|FILE.xlsx|- [--force] [--csv-style analysis|international|continental] "
                        "[--formula NAME[ UNIT]=FORMULA]..."),
         1, 1,
         outputOptions(QStringLiteral("The file to write, .csv or .xlsx.")) +
             QList<QCommandLineOption>{
                 {option::ofClass, QStringLiteral("Only trials of this class."), QStringLiteral("C")},
                 {option::task, QStringLiteral("Only trials of this task."), QStringLiteral("TASK")},
                 {option::team, QStringLiteral("Only trials of this team."), QStringLiteral("T")},
                 {option::metrics,
                  QStringLiteral("These metrics in this order, separated by commas; default: all."),
                  QStringLiteral("METRIC[,...]")},
                 {option::formula,
                  QStringLiteral("One more metric, computed from others and from variables of the trials."),
                  QStringLiteral("NAME[ UNIT]=FORMULA")},
                 csvStyleOption()}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const QString file = QString::fromStdString(call.value(option::output));
    if (!call.isSet(option::output) && !call.json())
        return call.missing(option::output);
    const auto style = ODO_TRY(csvStyleOf(call));
    const auto form = call.isSet(option::output) ? formOf(call, file) : Form::Csv;
    if (!form)
        return tl::unexpected(form.error());
    if (*form == Form::Xlsx && call.isSet(option::csvStyle))
        return call.wrongCall(ODO_TEXT("app.style_is_of_csv", "--csv-style goes with a CSV file"));
    const auto choice = ODO_TRY(choiceOf(call));
    const auto formulas = ODO_TRY(formulasOf(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const CancelScope scope(&cancel); // verdicts that are not stored take their time
    if (!call.isSet(option::output)) {
        const auto table = ODO_TRY(tableOf(*project, choice, formulas));
        call.answer({{QStringLiteral("trials"), rowsJson(table)}}, {});
        return {};
    }
    const auto output = ODO_TRY(
        CommandOutput::of(call, file, *form == Form::Xlsx ? FileKind::Xlsx : FileKind::Csv, project.get()));
    const auto table = ODO_TRY(tableOf(*project, choice, formulas));
    ODO_TRY(writeTable(table, *form, style, output.target()));
    return output.finish(
        call, {{QStringLiteral("file"), file}, {QStringLiteral("trials"), rowsJson(table)}},
        QStringLiteral("Wrote %1, %2.").arg(file, counted(table.rows.size(), QStringLiteral("row"))));
}

} // namespace odo
