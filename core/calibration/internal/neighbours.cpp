// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/neighbours.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr double perspectivePrior = 0.3; // how much the scale may change over a neighbourhood

} // namespace

std::vector<int> nearestTo(std::size_t of, std::size_t count, std::size_t most,
                           const std::function<double(std::size_t)> &away)
{
    std::vector<std::pair<double, int>> order;
    for (std::size_t i = 0; i < count; ++i) {
        if (i != of)
            order.emplace_back(away(i), static_cast<int>(i));
    }
    most = std::min(most, order.size());
    std::ranges::partial_sort(order, order.begin() + static_cast<std::ptrdiff_t>(most));
    std::vector<int> nearest;
    for (std::size_t i = 0; i < most; ++i)
        nearest.push_back(order[i].second);
    return nearest;
}

std::optional<Vector2d> predictedByNeighbours(const Vector2d &position,
                                              const std::vector<std::pair<Vector2d, Vector2d>> &pairs)
{
    double reach = 0, extent = 0;
    const Vector2d origin = pairs.front().second;
    for (const auto &[from, to] : pairs) {
        reach = std::max(reach, (from - position).norm());
        extent = std::max(extent, (to - origin).norm());
    }
    Eigen::Matrix<double, 8, 8> normal = Eigen::Matrix<double, 8, 8>::Zero();
    Eigen::Matrix<double, 8, 1> right = Eigen::Matrix<double, 8, 1>::Zero();
    for (const auto &[from, to] : pairs) {
        const Vector2d p = (from - position) / reach, q = (to - origin) / extent;
        const double weight = 1 / (0.2 + p.squaredNorm());
        Eigen::Matrix<double, 8, 1> u, v;
        u << p.x(), p.y(), 1, 0, 0, 0, -q.x() * p.x(), -q.x() * p.y();
        v << 0, 0, 0, p.x(), p.y(), 1, -q.y() * p.x(), -q.y() * p.y();
        normal += weight * (u * u.transpose() + v * v.transpose());
        right += weight * (q.x() * u + q.y() * v);
    }
    // A pixel or so of noise against the scale's change.
    const double stiff = std::pow(0.01 / perspectivePrior, 2);
    normal.diagonal().head<6>().array() += 1e-9;
    normal(6, 6) += stiff;
    normal(7, 7) += stiff;
    const Eigen::Matrix<double, 8, 1> map = normal.ldlt().solve(right);
    const Vector2d image = origin + extent * Vector2d(map(2), map(5));
    return image.allFinite() ? std::optional(image) : std::nullopt;
}

} // namespace odo
