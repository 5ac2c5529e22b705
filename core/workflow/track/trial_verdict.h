// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/project/verdict_repository.h"

#include <vector>

namespace odo {

class Project;

/// Checks the results of a trial from what the project holds of it: views that agree, time measured,
/// synchronisation, frame intervals, damaged frames, spikes, σ, speeds, names, lenses, cameras that have not
/// moved, and stored results that are as computed; with the acceptance that is stored. Without an analysis
/// there are no checks. Errors: those of the repositories. recordings: of the trial, in the order of its
/// views. Project's thread.
Result<TrialVerdict> verdictOn(Project &project, const TrialRecord &trial,
                               const std::vector<const RecordingRecord *> &recordings,
                               const std::vector<AnalysisRecord> &analyses);

} // namespace odo
