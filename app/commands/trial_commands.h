// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"
#include "core/project/records.h"

namespace odo {

/// `import` of finished tracks, and the options that go with them alone.
Result<void> importTracks(const CommandCall &call);
QList<QCommandLineOption> trackReadingOptions();
/// WrongCall where one of them was given without a track.
Result<void> refuseTrackOptions(const CommandCall &call);

/// --rate, within its limits.
Result<double> frameRateOf(const CommandCall &call);
/// Advice to give it.
Message giveRateOption();

/// Where a track came from, as `import` and `show` print it.
QJsonObject importedTrackJson(const ImportedTrack &source);
QString importedTrackText(const ImportedTrack &source);

} // namespace odo
