// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"
#include "core/school/hub_address.h"

namespace odo {

/// The school's hub that a positional argument names. WrongCall where it names none.
Result<HubAddress> hubAddressAt(const CommandCall &call, int index);

} // namespace odo
