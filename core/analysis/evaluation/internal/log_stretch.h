// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/evaluation/internal/measured_course.h"

#include <Eigen/Core>
#include <vector>

namespace odo {

/// What turns, bends and shifts a stretch by itself.
inline constexpr double stretchParameters = 4;

/// Of the offset, the rate and the scale.
using ClockColumns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// A part of the log with the measured poses at its times, linearised about a clock and a scale: two rows a
/// pose. What turning, bending and shifting the stretch can explain is taken out of all columns.
struct LogStretch
{
    std::vector<double> timesS;
    Eigen::VectorXd left;
    ClockColumns columns;
    double noise = 0; ///< Σ of the variances of the velocities in its rows
    double noiseOfRate = 0;
    double trust = 1; ///< against the other stretches, by the inverse of the variance that is left

    /// How much of what tells the time is no noise, 0 to 1: a stretch at constant speed has no say.
    double relevance() const
    {
        const double squares = columns.col(0).squaredNorm();
        const double share = squares > noise ? 1 - noise / squares : 0;
        return share * share;
    }
    double weight() const { return trust * relevance(); }

    double freedom() const { return double(left.size()) - stretchParameters; }
    double variance() const { return left.squaredNorm() / freedom(); }
    Eigen::Matrix3d information() const { return columns.transpose() * columns; }
};

/// A position of the log with the measured pose at its time.
struct TimedPair
{
    double logS = 0;
    Eigen::Vector2d log;
    CoursePose measured;
};

/// The least-squares problem of some pairs in a row. middleS: of the log's clock, about which the rate turns
/// it.
LogStretch stretchOf(const std::vector<TimedPair> &pairs, double middleS, double scale);

} // namespace odo
