// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/scene.h"
#include "tests/acceptance/scenes/seeded_draw.h"

#include <vector>

namespace odo::test {

/// From which corner of the floor a camera looks.
enum class Corner { NearLeft, NearRight, FarLeft, FarRight };
using Corners = std::vector<Corner>;
const Corners nearSide{Corner::NearLeft, Corner::NearRight}, across{Corner::NearLeft, Corner::FarRight};

/// A floor of 3 m × 2.2 m with the markers O, U, V, D and a camera about 2 m high, 1280×720, 30 frames/s, for
/// each corner, at a drawn place and with a drawn focal length, so that it sees all markers. Cameras are
/// called A, B, C in this order and start 0 to 33 ms after A (only B does; the others start with A).
SimulatedScene drawnTestbed(SeededDraw &draw, const Corners &corners);

/// The same floor with two more markers, M and N, in the middle of the long sides; camera A sees the left
/// part up to some way over the middle, camera B the right part.
SimulatedScene drawnHandOverTestbed(SeededDraw &draw);

/// The same with its two cameras, at the near side, at other heights over the floor and with the focal
/// lengths that see all markers from there.
SimulatedScene drawnTestbedFrom(SeededDraw &draw, double lowestM, double highestM);

/// Whether a point of the floor lies in the camera's picture, with a border.
bool isInImage(const FloorView &view, const Eigen::Vector3d &pointInWorld, double borderPx);

} // namespace odo::test
