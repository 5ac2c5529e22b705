// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curves/trend_curves.h"

#include "core/analysis/quantity_curve.h"
#include "ui/models/figure_text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <memory>

namespace odo {

namespace {

class TrendChartWords
{
    Q_DECLARE_TR_FUNCTIONS(TrendPainting)
};

double msOf(Instant instant)
{
    return static_cast<double>(instant.time_since_epoch().count());
}

QDate dayOf(double ms)
{
    return QDateTime::fromMSecsSinceEpoch(qint64(ms)).date();
}

ChartCurve runsOf(const TeamStanding &team)
{
    ChartCurve runs;
    runs.kind = ChartCurve::Kind::Points;
    runs.ink = ChartInk::Text;
    runs.widthPx = 2;
    CurveRun points;
    for (const TeamRun &run : team.runs)
        points.points.emplace_back(msOf(run.date), CurveValue{run.metric.value, 0});
    runs.runs = {std::move(points)};
    return runs;
}

ChartCurve progressOf(const TeamStanding &team, double fromMs, double toMs)
{
    const double from = team.progress.change ? team.progress.atStart : team.progress.median;
    const double to = from + (team.progress.change ? team.progress.change->value : 0);
    ChartCurve line;
    line.ink = ChartInk::Accent;
    line.widthPx = 2;
    line.dash = team.progress.isBeyondSpread ? Qt::SolidLine : Qt::DashLine;
    line.hasBand = team.progress.spread.has_value();
    const double sigma = team.progress.spread.value_or(0) / coverage95; // the spread is shown once
    line.runs = {CurveRun{0, {BandPoint(fromMs, {from, sigma}), BandPoint(toMs, {to, sigma})}}};
    return line;
}

} // namespace

ChartDrawing trendDrawing(const TeamStanding &team)
{
    const double firstMs = msOf(team.runs.front().date), lastMs = msOf(team.runs.back().date);
    auto content = std::make_shared<ChartContent>();
    content->curves = {progressOf(team, firstMs, std::max(lastMs, firstMs + 1)), runsOf(team)};
    const auto [low, high] = std::ranges::minmax(team.figures.values);
    const double spread = team.progress.spread.value_or(0);
    content->range = {low - spread, high + spread};
    const Metric &metric = team.runs.front().metric;
    const QString name = metricName(metric.name);
    ChartDrawing drawing;
    drawing.content = std::move(content);
    drawing.axes.style = ChartStyle::Dates;
    drawing.axes.left = metric.unit == "1"
                            ? name
                            : TrendChartWords::tr("%1 in %2").arg(name, QString::fromStdString(metric.unit));
    drawing.low = double(dayOf(firstMs).startOfDay().toMSecsSinceEpoch());
    drawing.high = double(dayOf(lastMs).addDays(1).startOfDay().toMSecsSinceEpoch());
    return drawing;
}

} // namespace odo
