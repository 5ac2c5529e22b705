// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

#include <cmath>

namespace odo::test {

/// A robot's positions as they were measured and smoothed, one by one, without its velocity.
struct MeasuredTrack
{
    std::vector<Sample> samples;
    std::vector<ProfilePoint> points;

    void add(double timeS, const Eigen::Vector2d &position, double ownM, double commonM = 0,
             bool isValid = true)
    {
        Sample sample;
        sample.time = fromSeconds(timeS);
        sample.position = position;
        sample.covariance = ownM * ownM * Eigen::Matrix2d::Identity();
        sample.commonCovariance = commonM * commonM * Eigen::Matrix2d::Identity();
        samples.push_back(sample);
        ProfilePoint point{};
        point.position = position;
        point.velocity = point.acceleration = Eigen::Vector2d::Zero();
        point.sigmaXM = point.sigmaYM = std::hypot(ownM, commonM);
        point.valid = isValid;
        points.push_back(point);
    }
};

} // namespace odo::test
