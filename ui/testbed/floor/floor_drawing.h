// SPDX-License-Identifier: GPL-3.0-or-later
// What all drawings of a testbed's floor have in common.
#pragma once

namespace odo {

inline constexpr double floorGridM = 0.5;
inline constexpr double markerGrabPx = 12; ///< as near as this a press takes hold of a marker

} // namespace odo
