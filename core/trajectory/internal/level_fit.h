// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/silhouette.h"
#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/body_direction.h"
#include "core/trajectory/internal/body_outline.h"

#include <array>
#include <ceres/jet.h>
#include <cmath>
#include <optional>
#include <vector>

namespace odo {

/// A guess that a fit begins with, for it ends in the solid that is next to it.
struct LevelStart
{
    /// by how much the lowest level is larger than the middle one, and that than the highest, as a share
    double taper = 0;
    double topShift = 0; ///< of the highest level along the heading, as a share of the length
};

struct LevelFit
{
    SolidShape shape;   ///< Form::Levels
    double widerPx = 0; ///< by how much all outlines are drawn too wide
    double misfit = 0;  ///< RMS of what it leaves of the supports, over their σ of half a pixel
    double sigmaTopM = 0;
    double lastingPx = 0;        ///< RMS of what the solid leaves of the outlines' centroids
    std::vector<BodyPose> poses; ///< at the times it was fitted to, in order
};

/// The outlines that a solid of levels is fitted to.
std::vector<CommonOutlines> levelTimes(const std::vector<ViewTrack> &views);

/// The convex solid of three levels whose silhouettes a robot's outlines are, if a box is not enough:
/// clearance, a chassis, wheels, a narrower upper part, round corners. Fitted jointly with a pose for each of
/// some forty times by weighted least squares of the outlines' supports over all views (Ceres, Cauchy's
/// loss), from the box that is known and the directions that the body then had. The convex hull of a
/// silhouette is the silhouette of the body's convex hull, so only outlines that are hulls show the body of a
/// robot with wheels and gaps. A given height and size are kept. axes: directed (directedAxes). sightings:
/// where the box was seen; a moving robot mostly heads along its path (motionAt). nullopt: too few outlines,
/// or nothing better was found. Pure. times: levelTimes(views), which several fits share.
std::optional<LevelFit> fitLevels(const std::vector<CommonOutlines> &times,
                                  const std::vector<ViewTrack> &views,
                                  const std::vector<std::vector<BodyAxis>> &axes,
                                  const std::vector<std::vector<Sighting>> &sightings, const SolidShape &box,
                                  const RobotShape &given, const LevelStart &start);

inline double valueOf(double number)
{
    return number;
}
template <class T, int n>
double valueOf(const ceres::Jet<T, n> &number)
{
    return number.a;
}

/// A level of a solid as SolidLevel, of numbers that may carry their derivatives (ceres::Jet).
template <class T>
struct LevelOf
{
    T height, front, back, left, right;
};
template <class T>
using LevelsOf = std::array<LevelOf<T>, 3>;

/// The levels of a solid of levels.
template <class T>
LevelsOf<T> levelsOfShape(const SolidShape &shape)
{
    LevelsOf<T> levels;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const SolidLevel &level = shape.levels[i];
        levels[i] = {T(level.heightM), T(level.frontM), T(level.backM), T(level.leftM), T(level.rightM)};
    }
    return levels;
}

/// How far the image of a solid of levels reaches in each direction, max of n·pixel over its outline (its
/// support function about the image's origin): of each level the middles of its round corners, and about
/// each a circle on the level's plane. pose: x, y, heading. more(k, slope): what the body reaches farther
/// than the solid in direction k, px, where slope is the derivative of that reach by a point of the body,
/// px/m in the world's frame, along which the plane that touches it faces. false: a corner lies behind the
/// camera, or where the lens model folds.
template <class T, class More>
bool reachOfLevels(const FloorView &view, const LevelsOf<T> &levels, const T &roundShare, const T *pose,
                   std::array<T, supportDirections> &reach, const More &more)
{
    using std::sin, std::cos, std::min;
    // whose image is an ellipse about that of its middle to some hundredths of a pixel
    constexpr double smallCircleM = 0.02;
    struct Corner
    {
        T x{}, y{}, z{}, radius{};
        Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
        /// of the pixel by the point
        Eigen::Matrix<double, 2, 3> slope = Eigen::Matrix<double, 2, 3>::Zero();
    };
    std::array<Corner, 12> corners;
    auto next = corners.begin();
    const T forwardX = cos(pose[2]), forwardY = sin(pose[2]);
    for (const LevelOf<T> &level : levels) {
        const T radius = roundShare * min(T(level.front + level.back), T(level.left + level.right)) / 2.0;
        for (const T &along : {T(level.front - radius), T(radius - level.back)}) {
            for (const T &across : {T(level.left - radius), T(radius - level.right)}) {
                Corner &corner = *next++;
                corner.x = pose[0] + along * forwardX - across * forwardY;
                corner.y = pose[1] + along * forwardY + across * forwardX;
                corner.z = level.height;
                corner.radius = radius;
                const auto pixel = view.pixelFromWorld(
                    {valueOf(corner.x), valueOf(corner.y), valueOf(corner.z)}, corner.slope);
                if (!pixel)
                    return false;
                corner.pixel = *pixel;
            }
        }
    }
    for (std::size_t k = 0; k < supportDirections; ++k) {
        const Eigen::Vector2d direction = supportDirection(k);
        const Corner *farthest = nullptr;
        double most = -HUGE_VAL;
        for (const Corner &corner : corners) {
            const double ofCircle = (corner.slope.template leftCols<2>().transpose() * direction).norm();
            if (const double here = direction.dot(corner.pixel) + valueOf(corner.radius) * ofCircle;
                here > most) {
                farthest = &corner;
                most = here;
            }
        }
        // The point of the circle that reaches farthest; where it is on the circle does not change the reach,
        // to first order.
        Eigen::Vector3d slope = farthest->slope.transpose() * direction;
        const Eigen::Vector2d outward = slope.head<2>().normalized();
        T x = farthest->x + farthest->radius * outward.x(), y = farthest->y + farthest->radius * outward.y();
        const Eigen::Vector3d middle(valueOf(farthest->x), valueOf(farthest->y), valueOf(farthest->z));
        Eigen::Vector3d about = middle;
        Eigen::Vector2d pixel = farthest->pixel;
        if (valueOf(farthest->radius) > smallCircleM) {
            about = {valueOf(x), valueOf(y), middle.z()};
            Eigen::Matrix<double, 2, 3> there;
            const auto exact = view.pixelFromWorld(about, there);
            if (!exact)
                return false;
            pixel = *exact;
            slope = there.transpose() * direction;
            // as seen from here, not from the circle's middle
            const Eigen::Vector2d touching = slope.head<2>().normalized();
            x = farthest->x + farthest->radius * touching.x();
            y = farthest->y + farthest->radius * touching.y();
        }
        reach[k] = direction.dot(pixel) + slope.x() * (x - about.x()) + slope.y() * (y - about.y()) +
                   slope.z() * (farthest->z - about.z()) + more(k, slope);
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

/// How far an outline was seen to reach in each direction against how far a solid's reaches, over the σ and
/// limited. support: about the centre. widerPx: by how much all outlines are drawn too wide.
template <class T>
void reachDifferences(const std::vector<float> &support, const Eigen::Vector2d &centrePx, const T &widerPx,
                      const std::array<T, supportDirections> &reach, T *differences)
{
    for (std::size_t k = 0; k < supportDirections; ++k) {
        const double seen = double(support[k]) + supportDirection(k).dot(centrePx);
        differences[k] = limitedDifference(T((seen - widerPx - reach[k]) / supportSigmaPx));
    }
}

} // namespace odo
