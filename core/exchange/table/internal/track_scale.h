// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/exchange/table/internal/raw_track.h"
#include "core/exchange/table/internal/understanding.h"

#include <vector>

namespace odo {

/// Brings coordinates whose columns are in several units into that of x.
void makeOneUnit(RawTrack &track);

/// Makes x and y the two coordinates that span the floor: those that a person says; else x and y, unless z
/// varies and one of them does not. TRC and KITTI are then read by what varies, of others it is an Error.
Result<void> chooseAxes(RawTrack &track, TrackFormat format, Understanding &how);

/// How many units of the track's coordinates make a metre: as a person, the header or the format says it;
/// else 1, where that gives speeds and a floor of a robot. Errors: an implausible speed, with the likely
/// unit; pixels without their length.
Result<double> unitsPerMetre(const RawTrack &track, TrackFormat format, const std::vector<Nanoseconds> &times,
                             Understanding &how);

} // namespace odo
