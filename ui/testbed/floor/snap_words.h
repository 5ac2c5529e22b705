// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_snap.h"

#include <QString>

namespace odo {

/// What a click was taken for, in a word or two: "tape crossing"; "by hand" where nothing was near.
QString snappedWords(SnappedMarker::Kind kind);

} // namespace odo
