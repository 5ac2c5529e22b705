// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/zone_visits.h"

#include "core/analysis/internal/zone_stretches.h"
#include "core/analysis/motion_stretches.h"

#include <cmath>

namespace odo {

namespace {

/// σ of the moment of an entry: the track's own noise, and the edge moved by the calibration's σ.
double sigmaOfEntry(const std::vector<Standing> &standings, const Stretch &entry)
{
    const double shift = commonSigmaM(standings);
    const auto entryAt = [&](double shiftM) {
        for (const Stretch &stretch : stretchesBeyond(standings, shiftM))
            if (stretch.toS >= entry.fromS)
                return stretch.fromS;
        return entry.fromS; // with the edge there it does not enter
    };
    return std::hypot(std::sqrt(entry.beginVariance), std::abs(entryAt(shift) - entryAt(-shift)) / 2);
}

ZoneVisits visitsOf(const Zone &zone, const std::vector<MeasuredPosition> &positions)
{
    ZoneVisits result;
    result.zone = zone.name;
    const std::vector<Standing> standings = standingsOf(zone, ZoneSide::Inside, positions);
    const std::vector<Stretch> stretches = stretchesBeyond(standings, 0);
    const StretchTimeSigma sigma = sigmaOfTime(standings, stretches);
    result.insideS = {timeOf(stretches), std::hypot(std::sqrt(sigma.ownVariance), sigma.commonS)};
    for (const Stretch &stretch : stretches) {
        result.visits.push_back({fromSeconds(stretch.fromS), fromSeconds(stretch.toS)});
        const bool begins = stretch.first == 0, isEntry = !begins && standings[stretch.first].joined;
        result.beginsInside = result.beginsInside || begins;
        result.entries += isEntry ? 1 : 0;
        if (result.latencyS)
            continue;
        result.latencyS = CurveValue{stretch.fromS - standings.front().timeS,
                                     begins ? 0 : sigmaOfEntry(standings, stretch)};
    }
    return result;
}

} // namespace

std::vector<ZoneVisits> findZoneVisits(const std::vector<Zone> &zones, const std::vector<Sample> &samples,
                                       const std::vector<ProfilePoint> &points)
{
    const std::vector<MeasuredPosition> positions = measuredPositions(samples, points);
    const bool hasGaps = !gapsBetween(validInstants(samples, points)).empty();
    std::vector<ZoneVisits> all;
    for (const Zone &zone : zones) {
        all.push_back(visitsOf(zone, positions));
        all.back().isAtLeast = hasGaps;
    }
    return all;
}

} // namespace odo
