// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/own_metric.h"

#include "core/analysis/metric_table.h"
#include "core/base/units.h"
#include "core/exchange/internal/formula.h"
#include "core/project/names.h"

#include <QString>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>

namespace odo {

namespace {

Message metricNamed(const std::string &name)
{
    return ODO_TEXT("exchange.own_metric", "own metric '%1'")(name);
}

/// "max_speed", "Energie_kinetisch": also beyond ASCII.
bool isWord(const std::string &name)
{
    return !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0 &&
           std::ranges::all_of(name, [](char sign) {
               const auto byte = static_cast<unsigned char>(sign);
               return byte >= 0x80 || std::isalnum(byte) != 0 || sign == '_';
           });
}

/// What a row has by a name: a metric, or a variable that is a number.
std::optional<Metric> valueOf(const ResultTable &table, const TrialTableRow &row, const std::string &name)
{
    for (std::size_t i = 0; i < row.metrics.size(); ++i)
        if (table.columns[i].metric == name && row.metrics[i])
            return row.metrics[i];
    const auto variable = row.trial.variables.find(name);
    if (variable == row.trial.variables.end())
        return std::nullopt;
    const auto number = parseNumber(variable->second);
    return number ? std::optional(Metric{name, "1", *number, 0.0}) : std::nullopt;
}

std::optional<Metric> computed(const ResultTable &table, const TrialTableRow &row, const OwnMetric &own,
                               const Formula &formula)
{
    std::vector<Metric> inputs;
    std::vector<double> values;
    for (const std::string &name : formula.names()) {
        auto input = valueOf(table, row, name);
        if (!input)
            return std::nullopt;
        values.push_back(input->value);
        inputs.push_back(std::move(*input));
    }
    const auto outcome = formula.evaluate(values);
    if (!outcome || row.robot.empty())
        return std::nullopt;
    Metric metric{own.name, own.unit, outcome->value, 0.0};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double slope = outcome->slopes[i];
        if (inputs[i].isAtLeast && slope < 0)
            return std::nullopt;
        metric.isAtLeast = metric.isAtLeast || (inputs[i].isAtLeast && slope > 0);
        metric.sigma = metric.sigma && inputs[i].sigma
                           ? std::optional(std::hypot(*metric.sigma, slope * *inputs[i].sigma))
                           : std::nullopt;
    }
    return metric;
}

} // namespace

Result<void> checkOwnMetric(const OwnMetric &metric)
{
    const Message advice = ODO_TEXT("exchange.own_metric_name", "give it a name of letters, digits and _");
    if (!isWord(metric.name))
        return fail(ErrorCode::InvalidInput, metricNamed(metric.name),
                    ODO_TEXT("exchange.own_metric_no_word", "its name is not a single word"), advice);
    constexpr int longest = 60;
    for (const std::string &text : {metric.name, metric.unit})
        if (QString::fromStdString(text).size() > longest)
            return fail(ErrorCode::InvalidInput,
                        metricNamed(firstCharacters(QString::fromStdString(text), longest).toStdString()),
                        ODO_TEXT("exchange.own_metric_long", "its name or unit has more than 60 characters"),
                        advice);
    if (metricKind(metric.name))
        return fail(ErrorCode::InvalidInput, metricNamed(metric.name),
                    ODO_TEXT("exchange.own_metric_known", "Odograph has a metric of that name"), advice);
    ODO_TRY(Formula::parse(metric.formula));
    return {};
}

Result<void> addOwnMetrics(ResultTable &table, std::span<const OwnMetric> metrics)
{
    for (const OwnMetric &own : metrics) {
        ODO_TRY(checkOwnMetric(own));
        const auto formula = ODO_TRY(Formula::parse(own.formula));
        std::set<std::string> known(table.variables.begin(), table.variables.end());
        for (const TrialTableColumn &column : table.columns)
            known.insert(column.metric);
        if (known.contains(own.name))
            return fail(ErrorCode::AlreadyExists, metricNamed(own.name),
                        ODO_TEXT("exchange.own_metric_twice", "a metric or variable has that name"),
                        ODO_TEXT("exchange.own_metric_other", "give it another name"));
        for (const std::string &name : formula.names())
            if (!known.contains(name))
                return fail(
                    ErrorCode::NotFound, metricNamed(own.name),
                    ODO_TEXT("exchange.own_metric_input", "no trial has a metric or variable '%1'")(name),
                    ODO_TEXT("exchange.own_metric_choose", "choose from %1")(
                        listed({known.begin(), known.end()}, MessageArgument::Kind::Label,
                               MessageArgument::Joint::Comma)));
        std::vector<std::optional<Metric>> column;
        for (const TrialTableRow &row : table.rows)
            column.push_back(computed(table, row, own, formula));
        table.columns.push_back({own.name, own.unit.empty() ? std::string("1") : own.unit});
        for (std::size_t row = 0; row < table.rows.size(); ++row) {
            if (column[row])
                column[row]->unit = table.columns.back().unit;
            table.rows[row].metrics.push_back(std::move(column[row]));
        }
    }
    return {};
}

} // namespace odo
