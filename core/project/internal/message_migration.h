// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace odo {

struct ProjectConnection;

/// The step to format 16: turns the English sentences that a project holds into stored messages, and keeps
/// right the digests of analyses that go over them. In the transaction of the step. What a later format adds
/// to a digest must not be missing here: AnalysisDigests reads the tables as they are in format 16.
Result<void> storeMessages(ProjectConnection &connection);

} // namespace odo
