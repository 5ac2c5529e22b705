// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/measured_places.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

double correlationOf(const Sample &sample)
{
    const double product = sample.covariance(0, 0) * sample.covariance(1, 1);
    return sample.position && product > 0 ? std::clamp(sample.covariance(0, 1) / std::sqrt(product), -1.0, 1.0) : 0;
}

} // namespace

std::vector<MeasuredPlace> measuredPlaces(const std::vector<Sample> &samples,
                                          const std::vector<ProfilePoint> &points)
{
    std::vector<MeasuredPlace> places;
    Eigen::Matrix2d common = Eigen::Matrix2d::Zero(); // of the last used sample
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (samples[i].position && !isRejected(samples[i].flags))
            common = samples[i].commonCovariance;
        if (!points[i].valid)
            continue;
        MeasuredPlace place;
        place.timeS = toSeconds(samples[i].time);
        place.point = &points[i];
        place.common = common;
        const double x = std::max(0.0, std::pow(points[i].sigmaXM, 2) - common(0, 0));
        const double y = std::max(0.0, std::pow(points[i].sigmaYM, 2) - common(1, 1));
        const double both = correlationOf(samples[i]) * std::sqrt(x * y);
        place.own << x, both, both, y;
        place.joined = i > 0 && points[i - 1].valid;
        places.push_back(place);
    }
    return places;
}

double sigmaAlong(const Eigen::Matrix2d &covariance, const Eigen::Vector2d &direction)
{
    return std::sqrt(std::max(0.0, direction.dot(covariance * direction)));
}

} // namespace odo
