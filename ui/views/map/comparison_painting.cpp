// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map/comparison_painting.h"

#include "ui/models/figure_text.h"
#include "ui/views/charts/profile_curve.h"
#include "ui/views/widgets/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <optional>

namespace odo {

namespace {

/// A curve out of the values at the stations; where it turns faint or back, both stretches have the point
/// between.
template <class ValueAt>
DistanceCurve curveOf(const ComparisonScene &scene, std::size_t run, bool isNeverNegative,
                      const ValueAt &valueAt)
{
    DistanceCurve curve{run, {}};
    const RunComparison &comparison = scene.compared.comparison;
    bool isOpen = false;
    for (std::size_t station = 0; station < comparison.waysM.size(); ++station) {
        const std::optional<Difference> value = valueAt(station);
        if (!value) {
            isOpen = false;
            continue;
        }
        const bool faint = !isNeverNegative && !value->isSignificant();
        const BandPoint point(comparison.distanceM(station), {value->value, value->sigma});
        if (isOpen && curve.stretches.back().faint != faint)
            curve.stretches.back().curve.points.push_back(point);
        if (!isOpen || curve.stretches.back().faint != faint)
            curve.stretches.push_back({{}, faint});
        curve.stretches.back().curve.points.push_back(point);
        isOpen = true;
    }
    return curve;
}

} // namespace

QString comparedUnit(Compared what)
{
    return what == Compared::Speed ? shownUnits().speed.name : QStringLiteral("s");
}

std::vector<DistanceCurve> speedCurves(const ComparisonScene &scene)
{
    std::vector<DistanceCurve> curves;
    const double perSi = shownUnits().speed.perSi;
    for (std::size_t run = 0; run < scene.runCount(); ++run)
        curves.push_back(curveOf(scene, run, true, [&](std::size_t station) -> std::optional<Difference> {
            const auto &at = scene.compared.comparison.runs[run].stations[station];
            return at ? std::optional(Difference{perSi * at->speedMps, perSi * at->sigmaSpeedMps})
                      : std::nullopt;
        }));
    return curves;
}

std::vector<DistanceCurve> differenceCurves(const ComparisonScene &scene)
{
    std::vector<DistanceCurve> curves;
    for (std::size_t run = 1; run < scene.runCount(); ++run)
        curves.push_back(curveOf(scene, run, false, [&](std::size_t station) {
            return scene.compared.comparison.timeDifference(run, station);
        }));
    return curves;
}

std::vector<DistanceCurve> comparedCurves(const ComparisonScene &scene, Compared what)
{
    return what == Compared::Speed ? speedCurves(scene) : differenceCurves(scene);
}

std::optional<CurveValue> speedAt(const ComparisonScene &scene, std::size_t run, double distanceM)
{
    const RunComparison &comparison = scene.compared.comparison;
    const auto arrival = comparison.runs[run].arrivals.at(comparison.originM + distanceM);
    const double perSi = shownUnits().speed.perSi;
    return arrival ? std::optional(CurveValue{perSi * arrival->speedMps, perSi * arrival->sigmaSpeedMps})
                   : std::nullopt;
}

std::optional<CurveValue> differenceAt(const ComparisonScene &scene, std::size_t run, double distanceM)
{
    const RunComparison &comparison = scene.compared.comparison;
    if (run == 0)
        return std::nullopt;
    const auto difference = comparison.timeDifferenceAt(run, comparison.originM + distanceM);
    return difference ? std::optional(CurveValue{difference->value, difference->sigma}) : std::nullopt;
}

namespace {

constexpr double gateHalfPx = 17, closestPx = 0.8;
constexpr int mostDashed = 20000; // points of a way

QPainterPath wayOf(const Profile &profile, const MapPlan &plan)
{
    QPainterPath way;
    std::optional<QPointF> last;
    for (const ProfilePoint &point : profile.points) {
        if (!point.valid) {
            last.reset();
            continue;
        }
        const QPointF at = plan.fromWorld(point.position);
        if (!last)
            way.moveTo(at);
        else if (QLineF(*last, at).length() < closestPx)
            continue;
        else
            way.lineTo(at);
        last = at;
    }
    return way;
}

} // namespace

ChartPlot comparedPlot(const QRectF &rect, const ComparisonScene *scene, Compared what,
                       const std::vector<DistanceCurve> &curves)
{
    double low = 0, high = 0;
    for (const DistanceCurve &curve : curves)
        for (const DistanceCurve::Stretch &stretch : curve.stretches)
            for (const BandPoint &point : stretch.curve.points) {
                low = std::min(low, double(point.value));
                high = std::max(high, double(point.value));
            }
    if (high - low < 1e-3)
        high = low + (what == Compared::Speed ? 1 : 0.1);
    ChartPlot plot{rect, 0, 1, coveringTicks(low, high, std::max(2, int(rect.height() / 23)))};
    if (scene && !scene->compared.comparison.waysM.empty()) {
        const RunComparison &comparison = scene->compared.comparison;
        plot.low = comparison.distanceM(0);
        plot.high = comparison.distanceM(comparison.waysM.size() - 1);
    }
    return plot;
}

void drawComparedCurves(QPainter &painter, const ChartPlot &plot, Compared what,
                        const std::vector<DistanceCurve> &curves, const QFont &font, const QPalette &palette)
{
    const QColor faint = ThemeColours::of(palette).muted;
    drawChartAxes(painter, plot, shownUnits().distance, font, palette);
    painter.setRenderHint(QPainter::Antialiasing, false);
    if (what == Compared::TimeDifference) { // neither is ahead on this line
        painter.setPen(QPen(faint, 1));
        painter.drawLine(plot.at(plot.low, 0), plot.at(plot.high, 0));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (const DistanceCurve &curve : curves)
        for (const DistanceCurve::Stretch &stretch : curve.stretches)
            drawCurveRun(
                painter, plot, stretch.curve,
                {stretch.faint ? faint : seriesColour(int(curve.run), palette), seriesDash(int(curve.run))});
}

void drawWays(QPainter &painter, const MapPlan &plan, const ComparisonScene &scene,
              const std::vector<std::size_t> &runs, const QPalette &palette)
{
    for (auto each = runs.rbegin(); each != runs.rend(); ++each) {
        const std::size_t run = *each;
        const QPainterPath way = wayOf(scene.profile(run), plan);
        // Dashes of a very long way take long to paint, and cover one another.
        const Qt::PenStyle dash = way.elementCount() < mostDashed ? seriesDash(int(run)) : Qt::SolidLine;
        QColor rim = ThemeColours::of(palette).mapGround;
        rim.setAlpha(170);
        painter.strokePath(way, QPen(rim, 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.strokePath(way,
                           QPen(seriesColour(int(run), palette), 2.2, dash, Qt::RoundCap, Qt::RoundJoin));
    }
}

QLineF pathGateLine(const MapPlan &plan, const ReferencePath &path, const PathGate &gate)
{
    const PathPoint at = pointAt(path, gate.stationM);
    const QPointF middle = plan.fromWorld(at.position),
                  across(-at.direction.y(), -at.direction.x()); // Y is up on the floor
    return {middle - gateHalfPx * across, middle + gateHalfPx * across};
}

void drawPathGate(QPainter &painter, const QLineF &line, const QString &name, bool isChosen,
                  const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const QColor colour = isChosen ? colours.accent : colours.text;
    painter.setPen(QPen(colours.mapGround, 5.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    painter.setPen(QPen(colour, isChosen ? 3.5 : 2.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(line);
    painter.setBrush(colours.card);
    painter.drawEllipse(line.center(), 4, 4);
    const QFontMetricsF metrics(painter.font());
    const QPointF end = line.y1() < line.y2() ? line.p1() : line.p2();
    const QRectF box(end.x() - metrics.horizontalAdvance(name) / 2 - 3, end.y() - metrics.height() - 2,
                     metrics.horizontalAdvance(name) + 6, metrics.height());
    QColor ground = colours.mapGround;
    ground.setAlpha(200);
    painter.fillRect(box, ground);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, name);
}

} // namespace odo
