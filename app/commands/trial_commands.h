// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"
#include "core/exchange/table/track_reading.h"
#include "core/project/records.h"
#include "core/workflow/track/view_synchronisation.h"

namespace odo {

/// `import` of finished tracks, and the options that go with them alone.
Result<void> importTracks(const CommandCall &call);
QList<QCommandLineOption> trackReadingOptions();
/// What they say; WrongCall for a value that none of them has.
Result<TrackReading> trackReadingOf(const CommandCall &call);
/// WrongCall where one of them was given without a track; --time-unit goes with --times too.
Result<void> refuseTrackOptions(const CommandCall &call);

/// --rate, within its limits.
Result<double> frameRateOf(const CommandCall &call);
/// Advice to give it.
Message giveRateOption();
/// --sync, of the views but the first; empty: it was not given.
Result<std::vector<ViewStep>> stepsOf(const CommandCall &call);
/// --time-unit.
Result<std::optional<TimeUnit>> timeUnitOf(const CommandCall &call);
/// Advice on what a file leaves open, as an option of `import`; any other as it is.
Message adviceAsOption(const Message &advice);

/// Where a track came from, as `import` and `show` print it.
QJsonObject importedTrackJson(const ImportedTrack &source);
QString importedTrackText(const ImportedTrack &source);

} // namespace odo
