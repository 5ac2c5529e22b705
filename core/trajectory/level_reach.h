// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/geometry/support.h"

#include <ceres/jet.h>

#include <array>
#include <cmath>
#include <vector>

namespace odo {

inline double valueOf(double number) { return number; }
template <class T, int n>
double valueOf(const ceres::Jet<T, n> &number) { return number.a; }

/// A level of a solid as SolidLevel, of numbers that may carry their derivatives (ceres::Jet).
template <class T>
struct LevelOf
{
    T height, front, back, left, right;
};
template <class T>
using LevelsOf = std::array<LevelOf<T>, 3>;

/// How far the picture of a solid of levels reaches in each direction, max of n·pixel over its outline (its support function about the picture's origin): of each level
/// the middles of its round corners, and about each the picture of a circle on the floor, which is an ellipse but for what perspective adds within it. pose: x, y,
/// heading. false: a corner lies behind the camera, or where the lens model folds. Derivatives leave out how the scale of the picture changes within the circle.
template <class T>
bool reachOfLevels(const FloorView &view, const LevelsOf<T> &levels, const T &roundShare, const T *pose, std::array<T, supportDirections> &reach)
{
    using std::sin, std::cos, std::min;
    struct Corner
    {
        T x, y, radius;
        Eigen::Vector2d pixel;
        Eigen::Matrix2d pixelByFloor;
    };
    std::array<Corner, 12> corners;
    auto next = corners.begin();
    const T forwardX = cos(pose[2]), forwardY = sin(pose[2]);
    for (const LevelOf<T> &level : levels) {
        const T radius = roundShare * min(T(level.front + level.back), T(level.left + level.right)) / 2.0;
        for (const T &along : {T(level.front - radius), T(radius - level.back)}) {
            for (const T &across : {T(level.left - radius), T(radius - level.right)}) {
                const T x = pose[0] + along * forwardX - across * forwardY, y = pose[1] + along * forwardY + across * forwardX;
                const Eigen::Vector3d point(valueOf(x), valueOf(y), valueOf(level.height));
                Eigen::Matrix<double, 2, 3> slope;
                const auto pixel = view.pixelFromWorld(point, slope);
                if (!pixel)
                    return false;
                const auto at = [&](int row) {
                    return (*pixel)(row) + slope(row, 0) * (x - point.x()) + slope(row, 1) * (y - point.y()) + slope(row, 2) * (level.height - point.z());
                };
                *next++ = {at(0), at(1), radius, *pixel, slope.template leftCols<2>()};
            }
        }
    }
    for (std::size_t k = 0; k < supportDirections; ++k) {
        const Eigen::Vector2d direction = supportDirection(k);
        const Corner *farthest = nullptr;
        double most = -HUGE_VAL, circle = 0;
        for (const Corner &corner : corners) {
            const double ofCircle = (corner.pixelByFloor.transpose() * direction).norm(), here = direction.dot(corner.pixel) + valueOf(corner.radius) * ofCircle;
            if (here > most) {
                farthest = &corner;
                most = here;
                circle = ofCircle;
            }
        }
        reach[k] = farthest->x * direction.x() + farthest->y * direction.y() + farthest->radius * circle;
    }
    return true;
}

/// A difference over its σ, of which what is far off counts less and less: the signed root of Cauchy's loss.
template <class T>
T limitedDifference(const T &sigmas)
{
    using std::log, std::sqrt, std::abs;
    constexpr double usual = 3;
    if (abs(sigmas) < 0.01)
        return sigmas;
    const T far = usual * sqrt(log(1.0 + sigmas * sigmas / (usual * usual)));
    return sigmas < 0.0 ? T(-far) : far;
}

/// The σ of how far an outline was seen to reach in a direction.
constexpr double supportSigmaPx = 0.5;

/// How far an outline was seen to reach in each direction against how far a solid's reaches, over the σ and limited. support: about the centre. widerPx,
/// lowerPx: by how much all outlines are drawn too wide and too far down.
template <class T>
void reachDifferences(const std::vector<float> &support, const Eigen::Vector2d &centrePx, const T &widerPx, const T &lowerPx,
                      const std::array<T, supportDirections> &reach, T *differences)
{
    for (std::size_t k = 0; k < supportDirections; ++k) {
        const Eigen::Vector2d direction = supportDirection(k);
        const double seen = double(support[k]) + direction.dot(centrePx);
        differences[k] = limitedDifference(T((seen - widerPx - lowerPx * direction.y() - reach[k]) / supportSigmaPx));
    }
}

} // namespace odo
