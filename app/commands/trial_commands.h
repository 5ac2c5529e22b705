// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"
#include "core/project/records.h"

namespace odo {

/// `import` of finished tracks: the part of the call behind its options.
Result<void> importTracks(const CommandCall &call,
                          const std::vector<std::pair<std::string, std::string>> &tracks);

/// Where a track came from, as `import` and `show` print it.
QJsonObject importedTrackJson(const ImportedTrack &source);
QString importedTrackText(const ImportedTrack &source);

} // namespace odo
