// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curves/comparison_curves.h"

#include "core/analysis/quantity_curve.h"
#include "ui/models/number_text.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <memory>
#include <numeric>

namespace odo {

namespace {

/// The curves of one run out of its values at the stations: what counts, and what is within the uncertainty.
/// Where one turns into the other, both have the point between.
struct RunCurves
{
    ChartCurve sure, faint;
};

template <class ValueAt>
RunCurves curvesOf(const ComparisonScene &scene, std::size_t run, bool canBeFaint, const ValueAt &valueAt)
{
    RunCurves curves;
    for (ChartCurve *curve : {&curves.sure, &curves.faint}) {
        curve->group = curve->position = int(run);
        curve->dash = seriesDash(int(run));
        curve->hasBand = true;
    }
    curves.faint.ink = ChartInk::Muted;
    const RunComparison &comparison = scene.compared.comparison;
    ChartCurve *open = nullptr; // to which the point before belongs
    for (std::size_t station = 0; station < comparison.distancesM.size(); ++station) {
        const std::optional<Difference> value = valueAt(station);
        if (!value) {
            open = nullptr;
            continue;
        }
        ChartCurve &curve = canBeFaint && !value->isSignificant() ? curves.faint : curves.sure;
        const BandPoint point(comparison.distanceM(station), {value->value, value->sigma});
        if (open && open != &curve)
            open->runs.back().points.push_back(point);
        if (open != &curve)
            curve.runs.emplace_back();
        curve.runs.back().points.push_back(point);
        open = &curve;
    }
    return curves;
}

RunCurves speedCurves(const ComparisonScene &scene, std::size_t run)
{
    const double perSi = shownUnits().speed.perSi;
    return curvesOf(scene, run, false, [&](std::size_t station) -> std::optional<Difference> {
        const auto &at = scene.compared.comparison.runs[run].stations[station];
        return at ? std::optional(Difference{perSi * at->speedMps, perSi * at->sigmaSpeedMps}) : std::nullopt;
    });
}

RunCurves differenceCurves(const ComparisonScene &scene, std::size_t run)
{
    return curvesOf(scene, run, true, [&](std::size_t station) {
        return scene.compared.comparison.timeDifference(run, station);
    });
}

/// Where neither is ahead.
ChartCurve evenLine(const PathSpan &span)
{
    ChartCurve line;
    line.ink = ChartInk::Muted;
    line.widthPx = 1;
    line.group = -1;
    line.runs = {CurveRun{0, {BandPoint(span.lowM, {}), BandPoint(span.highM, {})}}};
    return line;
}

ValueRange rangeOf(const std::vector<ChartCurve> &curves, Compared what)
{
    double low = 0, high = 0;
    for (const ChartCurve &curve : curves)
        for (const CurveRun &run : curve.runs)
            for (const BandPoint &point : run.points) {
                low = std::min(low, double(point.value));
                high = std::max(high, double(point.value));
            }
    return {low, high - low < 1e-3 ? low + (what == Compared::Speed ? 1 : 0.1) : high};
}

std::optional<CurveValue> speedAt(const ComparisonScene &scene, std::size_t run, double distanceM)
{
    const RunComparison &comparison = scene.compared.comparison;
    const auto arrival = comparison.runs[run].arrivals.at(comparison.originM + distanceM);
    const double perSi = shownUnits().speed.perSi;
    return arrival ? std::optional(CurveValue{perSi * arrival->speedMps, perSi * arrival->sigmaSpeedMps})
                   : std::nullopt;
}

} // namespace

QString comparedUnit(Compared what)
{
    return what == Compared::Speed ? shownUnits().speed.name : QStringLiteral("s");
}

ChartAxes comparedAxes(Compared what)
{
    return {shownUnits().distance, comparedUnit(what)};
}

PathSpan comparedSpan(const ComparisonScene &scene)
{
    const RunComparison &comparison = scene.compared.comparison;
    if (comparison.distancesM.empty())
        return {};
    return {comparison.distanceM(0), comparison.distanceM(comparison.distancesM.size() - 1)};
}

ChartContentPtr comparedContent(const ComparisonScene &scene, Compared what,
                                const std::vector<std::size_t> &runs)
{
    auto content = std::make_shared<ChartContent>();
    if (what == Compared::TimeDifference)
        content->curves.push_back(evenLine(comparedSpan(scene)));
    for (const std::size_t run : runs) {
        if (run == 0 && what == Compared::TimeDifference)
            continue; // the others are later than this one
        RunCurves curves = what == Compared::Speed ? speedCurves(scene, run) : differenceCurves(scene, run);
        content->curves.push_back(std::move(curves.faint));
        content->curves.push_back(std::move(curves.sure));
    }
    content->range = rangeOf(content->curves, what);
    return content;
}

ChartContentPtr comparedContent(const ComparisonScene &scene, Compared what)
{
    std::vector<std::size_t> runs(scene.runCount());
    std::iota(runs.begin(), runs.end(), std::size_t(0));
    return comparedContent(scene, what, runs);
}

std::optional<CurveValue> differenceAt(const ComparisonScene &scene, std::size_t run, double distanceM)
{
    const RunComparison &comparison = scene.compared.comparison;
    if (run == 0)
        return std::nullopt;
    const auto difference = comparison.timeDifferenceAt(run, comparison.originM + distanceM);
    return difference ? std::optional(CurveValue{difference->value, difference->sigma}) : std::nullopt;
}

std::optional<CurveValue> comparedAt(const ComparisonScene &scene, Compared what, std::size_t run,
                                     double distanceM)
{
    return what == Compared::Speed ? speedAt(scene, run, distanceM) : differenceAt(scene, run, distanceM);
}

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

/// A point each of those whose verdict is doubtful, or of the others.
ChartCurve runsOf(const TeamStanding &team, bool isDoubtful)
{
    ChartCurve runs;
    runs.kind = ChartCurve::Kind::Points;
    runs.ink = isDoubtful ? ChartInk::Spike : ChartInk::Text;
    runs.widthPx = 2;
    CurveRun points;
    for (const TeamRun &run : team.runs)
        if (run.isDoubtful == isDoubtful)
            points.points.emplace_back(msOf(run.date), CurveValue{run.metric.value, 0});
    if (!points.points.empty())
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
    content->curves = {progressOf(team, firstMs, std::max(lastMs, firstMs + 1)), runsOf(team, false),
                       runsOf(team, true)};
    const auto [low, high] = std::ranges::minmax(team.statistics.values);
    const double spread = team.progress.spread.value_or(0);
    content->range = {low - spread, high + spread};
    const Metric &metric = team.runs.front().metric;
    const QString name = metricName(metric.name);
    ChartDrawing drawing;
    drawing.content = std::move(content);
    drawing.axes.style = ChartStyle::Dates;
    drawing.axes.left = metric.unit == "1"
                            ? name
                            : TrendChartWords::tr("%1 in %2")
                                  .arg(name, metric.unit == "points" ? TrendChartWords::tr("points")
                                                                     : QString::fromStdString(metric.unit));
    drawing.low = double(dayOf(firstMs).startOfDay().toMSecsSinceEpoch());
    drawing.high = double(dayOf(lastMs).addDays(1).startOfDay().toMSecsSinceEpoch());
    return drawing;
}

} // namespace odo
