// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/picture_outline.h"

#include <cassert>
#include <cmath>

namespace odo {
namespace {

// Bending of a mild lens is about 1e-4 / px: the sagitta of such an edge is 16² · 1e-4 / 8 = 0.003 px at
// most.
constexpr double edgeStepPx = 16.0;
// How far beyond the picture's border, relative to its half size, polygons are cut.
constexpr double frustumMargin = 0.06;

/// The range of x/z and y/z that the picture's border sees.
struct DirectionBounds
{
    Eigen::Vector2d lower{1e9, 1e9}, upper{-1e9, -1e9};
};

DirectionBounds directionsOfBorder(const CameraModel &camera)
{
    const double w = camera.intrinsics().widthPx - 0.5, h = camera.intrinsics().heightPx - 0.5;
    DirectionBounds bounds;
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i) {
        const double x = -0.5 + (w + 0.5) * i / steps, y = -0.5 + (h + 0.5) * i / steps;
        for (const Eigen::Vector2d &pixel : {Eigen::Vector2d(x, -0.5), Eigen::Vector2d(x, h),
                                             Eigen::Vector2d(-0.5, y), Eigen::Vector2d(w, y)}) {
            const auto direction = camera.unproject(pixel);
            if (!direction || direction->z() <= 1e-3)
                continue;
            const Eigen::Vector2d ratio = direction->head<2>() / direction->z();
            bounds.lower = bounds.lower.cwiseMin(ratio);
            bounds.upper = bounds.upper.cwiseMax(ratio);
        }
    }
    assert(bounds.lower.x() < bounds.upper.x() && bounds.lower.y() < bounds.upper.y());
    const Eigen::Vector2d margin = frustumMargin * (bounds.upper - bounds.lower) / 2;
    return {bounds.lower - margin, bounds.upper + margin};
}

} // namespace

PictureOutline::PictureOutline(CameraModel camera, RigidTransform cameraFromSource)
    : m_camera(std::move(camera)), m_cameraFromSource(std::move(cameraFromSource))
{
    const DirectionBounds b = directionsOfBorder(m_camera);
    m_inward = {{1, 0, -b.lower.x()}, {-1, 0, b.upper.x()}, {0, 1, -b.lower.y()}, {0, -1, b.upper.y()}};
}

PixelRect PictureOutline::pictureRect() const
{
    return {0, 0, m_camera.intrinsics().widthPx, m_camera.intrinsics().heightPx};
}

std::vector<Eigen::Vector3d> PictureOutline::clipped(std::vector<Eigen::Vector3d> polygon) const
{
    // Sutherland and Hodgman 1974: one plane after the other.
    for (const Eigen::Vector3d &inward : m_inward) {
        std::vector<Eigen::Vector3d> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double da = inward.dot(a), db = inward.dot(b);
            if (da >= 0)
                kept.push_back(a);
            if ((da >= 0) != (db >= 0))
                kept.emplace_back(a + (b - a) * (da / (da - db)));
        }
        polygon = std::move(kept);
    }
    return polygon;
}

std::vector<Eigen::Vector2d> PictureOutline::of(std::span<const Eigen::Vector3d> polygon) const
{
    std::vector<Eigen::Vector3d> inCamera;
    inCamera.reserve(polygon.size() + 4);
    for (const Eigen::Vector3d &point : polygon)
        inCamera.push_back(m_cameraFromSource * point);
    inCamera = clipped(std::move(inCamera));

    std::vector<Eigen::Vector2d> outline;
    for (std::size_t i = 0; i < inCamera.size(); ++i) {
        const Eigen::Vector3d &a = inCamera[i], &b = inCamera[(i + 1) % inCamera.size()];
        const auto start = m_camera.project(a), end = m_camera.project(b);
        if (!start || !end)
            return {};
        outline.push_back(*start);
        const int steps = std::max(1, static_cast<int>(std::ceil((*end - *start).norm() / edgeStepPx)));
        for (int k = 1; k < steps; ++k) {
            const auto between = m_camera.project(a + (b - a) * (static_cast<double>(k) / steps));
            if (between)
                outline.push_back(*between);
        }
    }
    return outline;
}

PixelRect boundsOf(std::span<const Eigen::Vector2d> outline)
{
    if (outline.empty())
        return {};
    Eigen::Vector2d lower = outline.front(), upper = outline.front();
    for (const Eigen::Vector2d &point : outline) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    return {static_cast<int>(std::floor(lower.x() + 0.5)), static_cast<int>(std::floor(lower.y() + 0.5)),
            static_cast<int>(std::ceil(upper.x() + 0.5)) + 1,
            static_cast<int>(std::ceil(upper.y() + 0.5)) + 1};
}

} // namespace odo
