// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/view_disagreement.h"

#include "core/trajectory/floor_positions.h"
#include "core/trajectory/fusion.h"
#include "core/trajectory/view_interpolation.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// Each registered view's sightings at the samples' times.
std::vector<std::vector<Sighting>> sightingsOf(const Profile &profile, const std::vector<ViewTrack> &views)
{
    std::vector<Nanoseconds> times;
    for (const Sample &sample : profile.samples)
        times.push_back(sample.time);
    std::vector<std::vector<Sighting>> all;
    for (const ViewTrack &view : views)
        if (view.floorView)
            all.push_back(sightingsAt(times, placeObservations(view, silhouettePlaneM(profile.heightM))));
    return all;
}

/// The two largest variances of the views that saw the robot there, m²; 0: fewer than two.
double expectedSquare(const std::vector<std::vector<Sighting>> &views, std::size_t sample)
{
    double largest = 0, second = 0;
    for (const std::vector<Sighting> &view : views) {
        const Sighting &sighting = view[sample];
        if (!sighting.seen)
            continue;
        const double variance = totalCovariance(sighting.place).trace();
        second = std::max(second, std::min(largest, variance));
        largest = std::max(largest, variance);
    }
    return second > 0 ? largest + second : 0;
}

void count(ViewDisagreement &result)
{
    if (result.places.empty())
        return;
    std::vector<double> apart;
    double squares = 0, expected = 0;
    for (const Disagreement &place : result.places) {
        apart.push_back(place.apartM);
        squares += place.apartM * place.apartM;
        expected += place.expectedM * place.expectedM;
    }
    const auto number = static_cast<double>(apart.size());
    result.rmsM = std::sqrt(squares / number);
    result.expectedRmsM = std::sqrt(expected / number);
    std::sort(apart.begin(), apart.end());
    result.medianM = (apart[(apart.size() - 1) / 2] + apart[apart.size() / 2]) / 2;
    result.largestM = apart.back();
}

} // namespace

ViewDisagreement disagreementOf(const Profile &profile, const std::vector<ViewTrack> &views,
                                double stepSigmaS)
{
    ViewDisagreement result;
    const auto sightings = sightingsOf(profile, views);
    for (std::size_t i = 0; i < profile.samples.size(); ++i) {
        const Sample &sample = profile.samples[i];
        const double square = expectedSquare(sightings, i);
        if (!sample.viewDisagreementM || !sample.position || isRejected(sample.flags) || square <= 0)
            continue;
        const double step = profile.points[i].valid ? profile.points[i].speedMps * stepSigmaS : 0;
        result.places.push_back(
            {sample.time, *sample.position, *sample.viewDisagreementM, std::sqrt(square + step * step)});
    }
    count(result);
    return result;
}

} // namespace odo
