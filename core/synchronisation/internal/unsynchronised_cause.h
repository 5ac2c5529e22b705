// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/synchronisation/internal/constant_lag.h"

#include <optional>

namespace odo {

/// "the robot stood still", or ran straight at constant speed, if a view's track alone shows that it gives no
/// time offset; else empty. Pure.
Message uniformMotion(const std::vector<TimedPosition> &track);

/// Why two tracks are not synchronised, where no relation of their clocks explains them: each cause is tested
/// before it is named. Pure.
Message unsynchronisedCause(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                            const ConstantLag &constant, const OffsetRange &range);

} // namespace odo
