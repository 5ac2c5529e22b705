// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tracking/silhouette.h"

#include "core/simulation/internal/robot_body.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// A corner of the body: where it is in an undistorted picture, and in the world.
struct Corner
{
    Eigen::Vector2d onPlane;
    Eigen::Vector3d inWorld;
};

/// Andrew 1979.
std::vector<Corner> hullOf(std::vector<Corner> corners)
{
    std::sort(corners.begin(), corners.end(), [](const Corner &a, const Corner &b) {
        return a.onPlane.x() < b.onPlane.x() ||
               (a.onPlane.x() == b.onPlane.x() && a.onPlane.y() < b.onPlane.y());
    });
    std::vector<Corner> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t start = hull.size();
        for (const Corner &corner : corners) {
            while (hull.size() >= start + 2 && cross(hull.back().onPlane - hull[hull.size() - 2].onPlane,
                                                     corner.onPlane - hull.back().onPlane) <= 0)
                hull.pop_back();
            hull.push_back(corner);
        }
        hull.pop_back();
        std::reverse(corners.begin(), corners.end());
    }
    return hull;
}

} // namespace

PolygonMoments exactMoments(std::span<const Eigen::Vector2d> polygon)
{
    PolygonMoments moments;
    const Eigen::Vector2d origin = polygon.front();
    double twice = 0;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d p = polygon[i] - origin, q = polygon[(i + 1) % polygon.size()] - origin;
        const double c = cross(p, q);
        twice += c;
        first += c * (p + q) / 3;
        second += c * (p * p.transpose() + q * q.transpose() + (p + q) * (p + q).transpose()) / 12;
    }
    moments.area = std::abs(twice) / 2;
    const Eigen::Vector2d mean = first / twice;
    moments.centre = origin + mean;
    moments.covariance = second / twice - mean * mean.transpose();
    return moments;
}

std::vector<Eigen::Vector2d> silhouette(const SimulatedScene &scene, std::size_t robot, int camera,
                                        std::int64_t frame)
{
    const FloorView &view = scene.cameras[static_cast<std::size_t>(camera)].view;
    const SimulatedRobot &body = scene.robots[robot];
    const MotionState state = body.motion->at(frameSceneTime(scene, camera, frame));
    std::vector<Corner> corners;
    for (const BodyFace &face : visibleFaces(body, state, view.cameraInWorld())) {
        for (const Eigen::Vector3d &corner : face.corners) {
            const Eigen::Vector3d inCamera = view.cameraFromWorld() * corner;
            corners.push_back({inCamera.head<2>() / inCamera.z(), corner});
        }
    }
    const std::vector<Corner> hull = hullOf(std::move(corners));
    std::vector<Eigen::Vector2d> outline;
    constexpr int parts = 8;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        for (int k = 0; k < parts; ++k) {
            const double part = double(k) / parts;
            const Eigen::Vector3d point =
                (1 - part) * hull[i].inWorld + part * hull[(i + 1) % hull.size()].inWorld;
            outline.push_back(view.pixelFromWorld(point).value());
        }
    }
    return outline;
}

Eigen::Matrix2d covarianceOf(const Ellipse &ellipse)
{
    const Eigen::Vector2d axis(std::cos(ellipse.angleRad), std::sin(ellipse.angleRad));
    const Eigen::Vector2d across(-axis.y(), axis.x());
    return ellipse.semiMajorPx * ellipse.semiMajorPx / 4 * axis * axis.transpose() +
           ellipse.semiMinorPx * ellipse.semiMinorPx / 4 * across * across.transpose();
}

} // namespace odo
