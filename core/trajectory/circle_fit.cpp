// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/circle_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <numbers>
#include <vector>

namespace odo {

namespace {

constexpr std::size_t fewestPoints = 10;
constexpr double leastTurnRad = 2 * std::numbers::pi / 3;
constexpr double largestRelativeRms = 0.03;
constexpr int steps = 10;

/// |p − c|² = R² is linear in c and R² − |c|².
Eigen::Vector3d algebraicCircle(std::span<const Eigen::Vector2d> path, const Eigen::Vector2d &origin)
{
    Eigen::MatrixX3d rows(path.size(), 3);
    Eigen::VectorXd squares(path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Eigen::Vector2d p = path[i] - origin;
        rows.row(static_cast<Eigen::Index>(i)) << 2 * p.x(), 2 * p.y(), 1;
        squares[static_cast<Eigen::Index>(i)] = p.squaredNorm();
    }
    const Eigen::Vector3d solved = rows.colPivHouseholderQr().solve(squares);
    return {solved.x() + origin.x(), solved.y() + origin.y(),
            std::sqrt(std::max(0.0, solved.z() + solved.head<2>().squaredNorm()))};
}

/// How many neighbours share one error.
double correlatedPoints(const std::vector<double> &distances)
{
    double variance = 0;
    for (const double d : distances)
        variance += d * d;
    double sum = 1;
    for (std::size_t lag = 1; variance > 0 && lag < distances.size() / 2; ++lag) {
        double product = 0;
        for (std::size_t i = lag; i < distances.size(); ++i)
            product += distances[i] * distances[i - lag];
        if (product <= 0)
            break;
        sum += 2 * product / variance;
    }
    return sum;
}

double turnOf(std::span<const Eigen::Vector2d> path, const Eigen::Vector2d &centre)
{
    double turn = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Eigen::Vector2d a = path[i - 1] - centre, b = path[i] - centre;
        turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(turn);
}

} // namespace

std::optional<CircleFit> fitCircle(std::span<const Eigen::Vector2d> path)
{
    if (path.size() < fewestPoints)
        return std::nullopt;
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d &point : path)
        origin += point / static_cast<double>(path.size());
    Eigen::Vector3d circle = algebraicCircle(path, origin);
    std::vector<double> distances(path.size());
    Eigen::Matrix3d normal;
    for (int step = 0; step < steps; ++step) {
        normal.setZero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < path.size(); ++i) {
            const Eigen::Vector2d outwards = path[i] - circle.head<2>();
            const double radius = outwards.norm();
            if (!(radius > 0))
                return std::nullopt;
            const Eigen::Vector3d slope(outwards.x() / radius, outwards.y() / radius, 1);
            distances[i] = radius - circle.z();
            normal += slope * slope.transpose();
            right += slope * distances[i];
        }
        circle += normal.ldlt().solve(right);
        if (!circle.allFinite())
            return std::nullopt;
    }
    CircleFit fit;
    fit.centre = circle.head<2>();
    fit.radiusM = circle.z();
    double squares = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        distances[i] = (path[i] - fit.centre).norm() - fit.radiusM;
        squares += distances[i] * distances[i];
    }
    fit.rmsM = std::sqrt(squares / static_cast<double>(path.size() - 3));
    const Eigen::Matrix3d inverse = normal.ldlt().solve(Eigen::Matrix3d::Identity());
    fit.sigmaRadiusM = fit.rmsM * std::sqrt(std::max(0.0, inverse(2, 2)) * correlatedPoints(distances));
    if (!(fit.radiusM > 0) || fit.rmsM > largestRelativeRms * fit.radiusM ||
        turnOf(path, fit.centre) < leastTurnRad)
        return std::nullopt;
    return fit;
}

} // namespace odo
