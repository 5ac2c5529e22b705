// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/renderer.h"

#include <cstdint>
#include <vector>

namespace odo {

/// Poses (cameraFromBoard) as a careful person would hold a board: spread over the picture, near and far, tilted up to
/// 40° to all sides, all corners in the picture. The same for a seed.
std::vector<RigidTransform> heldBoardPoses(const CameraModel &camera, const SimulatedBoard &board, int count,
                                           std::uint32_t seed);

} // namespace odo
