// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/common_outlines.h"

#include "core/trajectory/body_outline.h"
#include "core/trajectory/view_clock.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr std::size_t leastTimes = 5;
constexpr Nanoseconds longestStep = std::chrono::milliseconds(120);

bool isClear(const Observation &observation)
{
    const Ellipse &ellipse = observation.ellipse;
    return observation.found && !observation.duplicateFrame && !observation.touchesBorder &&
           observation.score >= leastOutlineScore && ellipse.centrePx.allFinite() &&
           std::isfinite(ellipse.angleRad) && ellipse.semiMinorPx > 0 && std::isfinite(ellipse.semiMajorPx) &&
           observation.areaPx > 0 && std::isfinite(observation.areaPx);
}

/// A blend of two outlines.
CommonOutlines::Outline between(const FloorView *view, const Observation &before, const Observation &behind, double fraction)
{
    const RegionMoments a = outlineMoments(before), b = outlineMoments(behind);
    CommonOutlines::Outline outline{view,
                                    {(1 - fraction) * a.areaPx2 + fraction * b.areaPx2, (1 - fraction) * a.centrePx + fraction * b.centrePx,
                                     (1 - fraction) * a.covariancePx2 + fraction * b.covariancePx2},
                                    {}};
    const std::vector<float> &from = before.supportPx, &to = behind.supportPx;
    for (std::size_t k = 0; k < from.size() && from.size() == to.size(); ++k)
        outline.supportPx.push_back(float((1 - fraction) * from[k] + fraction * to[k]));
    return outline;
}

std::optional<CommonOutlines::Outline> outlineAt(const ViewTrack &view, Nanoseconds time)
{
    const auto after = std::lower_bound(view.observations.begin(), view.observations.end(), time,
                                        [&view](const Observation &observation, Nanoseconds t) {
                                            return timeOf(view, observation) < t;
                                        });
    if (after == view.observations.end() || !isClear(*after))
        return std::nullopt;
    const Nanoseconds behind = timeOf(view, *after);
    if (behind == time)
        return CommonOutlines::Outline{&*view.floorView, outlineMoments(*after), after->supportPx};
    if (after == view.observations.begin() || !isClear(*(after - 1)))
        return std::nullopt;
    const Nanoseconds before = timeOf(view, *(after - 1));
    if (behind - before > longestStep)
        return std::nullopt;
    const double fraction = toSeconds(time - before) / toSeconds(behind - before);
    return between(&*view.floorView, *(after - 1), *after, fraction);
}

CommonOutlines outlinesAt(const std::vector<ViewTrack> &views, Nanoseconds time)
{
    CommonOutlines common;
    common.time = time;
    for (const ViewTrack &view : views) {
        if (!view.floorView)
            continue;
        if (auto outline = outlineAt(view, time))
            common.outlines.push_back(std::move(*outline));
    }
    return common;
}

std::vector<CommonOutlines> spread(const std::vector<ViewTrack> &views, const std::vector<Nanoseconds> &times,
                                   std::size_t most)
{
    std::vector<CommonOutlines> chosen;
    const std::size_t count = std::min(times.size(), most);
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(outlinesAt(views, times[count > 1 ? i * (times.size() - 1) / (count - 1) : 0]));
    return chosen;
}

} // namespace

std::vector<CommonOutlines> commonOutlines(const std::vector<ViewTrack> &views, std::size_t most)
{
    std::vector<Nanoseconds> several, single;
    for (const ViewTrack &view : views) {
        if (!view.floorView)
            continue;
        for (const Observation &observation : view.observations) {
            if (!isClear(observation))
                continue;
            const Nanoseconds time = timeOf(view, observation);
            const std::size_t seeing = outlinesAt(views, time).outlines.size();
            if (seeing > 0)
                (seeing > 1 ? several : single).push_back(time);
        }
        // The other views' times add little to those of the first that saw it together with others.
        if (several.size() >= leastTimes)
            return spread(views, several, most);
    }
    return spread(views, single, most);
}

} // namespace odo
