// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

namespace odo {

/// The wall clock, as moments are stored. Any thread.
inline Instant instantNow()
{
    return std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
}

} // namespace odo
