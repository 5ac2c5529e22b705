// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/exchange/table/internal/raw_track.h"
#include "core/exchange/table/internal/understanding.h"

#include <vector>

namespace odo {

/// Where a localisation restarts, its positions leap and go on from elsewhere: no robot drove that. So
/// many rows around the leap are forgotten that no gap is bridged across it, and said so. unitsPerMetre: of
/// the track's coordinates. Error: more breaks than a track can have and still be one.
Result<void> openBreaks(RawTrack &track, const std::vector<Nanoseconds> &times, double unitsPerMetre,
                        Understanding &how);

} // namespace odo
