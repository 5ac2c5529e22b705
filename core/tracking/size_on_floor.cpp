// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/size_on_floor.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double largestM = 1.2; // of what is taken for a robot

} // namespace

std::optional<SizeOnFloor> sizeOnFloor(const FloorView &view, const PixelRect &box)
{
    const double middleX = (box.x0 + box.x1 - 1) / 2.0, bottomY = box.y1 - 1;
    const auto foot = view.floorFromPixel({middleX, bottomY}, 0), left = view.floorFromPixel({double(box.x0), bottomY}, 0);
    const auto right = view.floorFromPixel({double(box.x1 - 1), bottomY}, 0);
    if (!foot || !left || !right)
        return std::nullopt;
    const Eigen::Vector3d camera = view.cameraInWorld();
    const auto farEnd = view.floorFromPixel({middleX, double(box.y0)}, 0);
    // The ray of its upper edge above its foot; one that never meets the floor passes above the camera's height.
    const double footAway = (*foot - camera.head<2>()).norm();
    const double heightM = farEnd ? camera.z() * (1 - footAway / std::max(footAway, (*farEnd - camera.head<2>()).norm())) : camera.z();
    const double depthM = farEnd ? (*farEnd - *foot).norm() : HUGE_VAL;
    return SizeOnFloor{(*right - *left).norm(), std::min(depthM, heightM)};
}

bool isTooLargeForRobot(const FloorView &view, const PixelRect &box)
{
    const auto size = sizeOnFloor(view, box);
    return size && std::max(size->widthM, size->reachM) > largestM;
}

} // namespace odo
