// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/dot_centre.h"

#include <array>

namespace odo {

using Eigen::Vector2d;

std::optional<Vector2d> dotCentre(const EllipseOutline &outline, const FloorView &view)
{
    constexpr int corners = 48;
    std::array<Vector2d, corners> floor;
    for (int i = 0; i < corners; ++i) {
        const auto place = view.floorFromPixel(outline.pointAt(2 * EIGEN_PI * i / corners), 0);
        if (!place)
            return std::nullopt;
        floor[static_cast<std::size_t>(i)] = *place;
    }
    Vector2d sum = Vector2d::Zero();
    double area = 0;
    for (std::size_t i = 0; i < corners; ++i) {
        const Vector2d a = floor[i] - floor[0], b = floor[(i + 1) % corners] - floor[0];
        const double part = a.x() * b.y() - a.y() * b.x();
        area += part;
        sum += part * (a + b) / 3;
    }
    const Vector2d middle = floor[0] + sum / area;
    return view.pixelFromWorld({middle.x(), middle.y(), 0});
}

} // namespace odo
