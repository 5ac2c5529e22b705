// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"

#include <optional>
#include <string_view>

namespace odo {

/// The axes that a track is exported in. Floor: those of the marker layout. Start: the origin is where the
/// run begins, X is the direction in which it first moves, and the time begins there.
enum class TrackFrame { Floor, Start };
/// "floor", "start"; nullopt for another word.
std::optional<TrackFrame> trackFrameFromWord(std::string_view word);

/// A profile in other axes: positions, velocities, accelerations, headings and the σ along its axes (without
/// the correlation of the two axes of the floor, which a profile does not have). Lengths, speeds and metrics
/// are the same in all axes. σ stay those on the floor: what the start itself is uncertain by is not added. A
/// robot that never moves clearly keeps the floor's directions, a run without a valid point all of the
/// floor's. Pure.
Profile inFrame(Profile profile, TrackFrame frame);

} // namespace odo
