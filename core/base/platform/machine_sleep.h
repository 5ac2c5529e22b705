// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

namespace odo {

/// How long the machine has slept since it was started, while std::chrono::steady_clock stood still. In a
/// source of its own, so that a test can have the machine sleep by defining it itself. Never fails. Any
/// thread.
Nanoseconds machineSlept();

} // namespace odo
