// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/truth_accuracy.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr Nanoseconds sameTime = std::chrono::microseconds(100);
constexpr double sigmas95 = 1.96;

std::ptrdiff_t truthIndex(const TruthSeries &truth, Nanoseconds time)
{
    const auto after = std::lower_bound(truth.times.begin(), truth.times.end(), time - sameTime);
    if (after == truth.times.end() || *after > time + sameTime)
        return -1;
    return after - truth.times.begin();
}

} // namespace

TruthAccuracy compareWithTruth(const Profile &profile, const TruthSeries &truth)
{
    TruthAccuracy sum;
    for (std::size_t i = 0; i < profile.points.size(); ++i) {
        const ProfilePoint &point = profile.points[i];
        const std::ptrdiff_t found = truthIndex(truth, profile.samples[i].time);
        if (!point.valid || found < 0)
            continue;
        const auto k = static_cast<std::size_t>(found);
        const Eigen::Vector2d error = point.position - truth.positions[k];
        ++sum.compared;
        sum.positionRmsM += error.squaredNorm();
        sum.velocityRmsMps += (point.velocity - truth.velocities[k]).squaredNorm();
        sum.accelerationRmsMps2 += (point.acceleration - truth.accelerations[k]).squaredNorm();
        sum.insideX95 += std::abs(error.x()) <= sigmas95 * point.sigmaXM;
        sum.insideY95 += std::abs(error.y()) <= sigmas95 * point.sigmaYM;
        sum.insideSpeed95 += std::abs(point.speedMps - truth.velocities[k].norm()) <= sigmas95 * point.sigmaSpeedMps;
    }
    if (sum.compared == 0)
        return sum;
    const double n = double(sum.compared);
    return {sum.compared,
            std::sqrt(sum.positionRmsM / n),
            std::sqrt(sum.velocityRmsMps / n),
            std::sqrt(sum.accelerationRmsMps2 / n),
            sum.insideX95 / n,
            sum.insideY95 / n,
            sum.insideSpeed95 / n};
}

} // namespace odo
