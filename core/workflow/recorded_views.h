// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <filesystem>
#include <vector>

namespace odo {

/// A view whose recording has ended.
struct EndedView
{
    RecordingRecord record; ///< id and camera; the rest is filled in
    std::filesystem::path file;
    std::vector<Nanoseconds> taken; ///< of each picture, by one clock for all views
    double clockSigmaS = 0;
    bool clockKnown = true; ///< false: taken is right against itself alone
};

/// Frame times, rate, sync and size of the views that have pictures, the first of which is the first view.
/// The hash is left to HashJob. Errors: Io.
Result<std::vector<RecordingRecord>> describeRecordings(const std::vector<EndedView> &views);

/// Duration and sync of a trial with these recordings, one at least.
void describeTrial(TrialRecord &trial, const std::vector<RecordingRecord> &recordings);

} // namespace odo
