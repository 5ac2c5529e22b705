// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/comparison_curves.h"

#include "ui/models/shown_units.h"

#include <algorithm>

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
            return at ? std::optional(Difference{perSi * at->speedMps, perSi * at->sigmaSpeedMps}) : std::nullopt;
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

} // namespace odo
