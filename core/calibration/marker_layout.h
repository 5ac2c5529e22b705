// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace odo {

/// A labelled point on the floor, metres in the world frame (z = 0).
struct Marker
{
    std::string label;
    Eigen::Vector2d pointInWorld;
};

/// A named set of markers.
struct MarkerLayout
{
    std::string name;
    std::vector<Marker> markers;
};

/// A marker as a camera sees it. Luma pixels.
struct MarkerPixel
{
    std::string label;
    Eigen::Vector2d pixel;
};

/// The advice where several share a label.
Message labelEachMarker();
Message labelEachPoint();

} // namespace odo
