// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/evaluation/internal/log_stretch.h"

#include <cmath>

namespace odo {

namespace {

constexpr double noiseFloorMps = 1e-5; // of numbers alone

void takeOut(Eigen::Ref<Eigen::VectorXd> column, const Eigen::VectorXd &direction)
{
    const double squares = direction.squaredNorm();
    if (squares > 0)
        column -= direction * (direction.dot(column) / squares);
}

void centreRows(Eigen::Ref<Eigen::VectorXd> column)
{
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
        auto values = column(Eigen::seq(axis, Eigen::last, 2));
        values.array() -= values.mean();
    }
}

/// Rows turned by an angle about their origin.
Eigen::VectorXd turnedRows(const Eigen::VectorXd &rows, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    Eigen::VectorXd result(rows.size());
    for (Eigen::Index i = 0; i < rows.size(); i += 2) {
        result[i] = c * rows[i] - s * rows[i + 1];
        result[i + 1] = s * rows[i] + c * rows[i + 1];
    }
    return result;
}

/// The angle by which rows are turned to lie on others.
double angleBetween(const Eigen::VectorXd &rows, const Eigen::VectorXd &others)
{
    double along = 0, across = 0;
    for (Eigen::Index i = 0; i < rows.size(); i += 2) {
        along += rows[i] * others[i] + rows[i + 1] * others[i + 1];
        across += rows[i] * others[i + 1] - rows[i + 1] * others[i];
    }
    return std::atan2(across, along);
}

/// How rows change where their path bends evenly along its length; across: they when turned by a right angle.
Eigen::VectorXd bentOf(const Eigen::VectorXd &across)
{
    Eigen::VectorXd bent = Eigen::VectorXd::Zero(across.size());
    double pathM = 0;
    for (Eigen::Index i = 2; i < across.size(); i += 2) {
        const Eigen::Vector2d step = across.segment<2>(i) - across.segment<2>(i - 2);
        bent.segment<2>(i) = bent.segment<2>(i - 2) + (pathM + step.norm() / 2) * step;
        pathM += step.norm();
    }
    centreRows(bent);
    return bent;
}

} // namespace

LogStretch stretchOf(const std::vector<TimedPair> &pairs, double middleS, double scale)
{
    const auto rows = Eigen::Index(2 * pairs.size());
    Eigen::VectorXd log(rows), measured(rows), velocity(rows), byRate(rows);
    LogStretch stretch;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto at = Eigen::Index(2 * i);
        const TimedPair &pair = pairs[i];
        const double sinceS = pair.logS - middleS;
        log.segment<2>(at) = pair.log;
        measured.segment<2>(at) = pair.measured.position;
        velocity.segment<2>(at) = pair.measured.velocity;
        byRate.segment<2>(at) = pair.measured.velocity * sinceS;
        const double variance =
            pair.measured.sigmaVelocityMps * pair.measured.sigmaVelocityMps + noiseFloorMps * noiseFloorMps;
        stretch.noise += 2 * variance;
        stretch.noiseOfRate += 2 * variance * sinceS * sinceS;
        stretch.timesS.push_back(pair.logS);
    }
    for (Eigen::VectorXd *column : {&log, &measured, &velocity, &byRate})
        centreRows(*column);
    log = scale * turnedRows(log, angleBetween(log, measured));
    stretch.left = measured - log;
    stretch.columns.resize(rows, 3);
    stretch.columns << velocity, byRate, -log;
    const Eigen::VectorXd across = turnedRows(log, std::acos(0.0));
    Eigen::VectorXd bent = bentOf(across);
    takeOut(bent, across);
    for (const Eigen::VectorXd &own : {across, bent}) {
        takeOut(stretch.left, own);
        for (Eigen::Index column = 0; column < 3; ++column)
            takeOut(stretch.columns.col(column), own);
    }
    const double share = stretch.freedom() / double(rows);
    stretch.noise *= share;
    stretch.noiseOfRate *= share;
    return stretch;
}

} // namespace odo
