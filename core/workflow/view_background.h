// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/tracking/background.h"
#include "core/workflow/registered_view.h"

#include <functional>
#include <optional>

namespace odo {

/// The background of a recording, from some ten frames a second of all of it. nullopt: it has no frame. onPicture: after each frame.
/// Errors: a recording that is missing or is no video; cancelled.
Result<std::optional<Background>> learnBackground(const RegisteredView &view, const CancelToken &cancel, const std::function<void()> &onPicture);

} // namespace odo
