// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/camera_pair.h"

namespace odo {

/// What errors of a pair of cameras are about.
Message relationOfCameras();
tl::unexpected<Error> refusePair(Message why, Message advice, ErrorCode code = ErrorCode::Undetermined);

// Why, and what to do.
Message noRelation();
Message noPairHasBoard(std::size_t pairs, const std::vector<RejectedPair> &rejected);
Message pairsContradict(const CameraPair &pair);
Message showBoardToBoth();
Message takeAtSameMoment();

/// The sentences of CameraPair::verdict from all else in it.
Message pairVerdict(const CameraPair &pair);

} // namespace odo
