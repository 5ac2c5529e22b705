// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/message.h"
#include "core/project/records.h"

#include <string>
#include <string_view>
#include <vector>

namespace odo {

class Project;

/// How far a result can be relied on. Doubtful: read the reason first. Bad: do not use it.
enum class CheckLevel { Pass, Doubtful, Bad };
/// "pass", "doubtful", "bad": how the command line says it.
std::string_view wordOf(CheckLevel level);

/// The outcome of one check of a trial.
struct TrialCheck
{
    std::string code; ///< stable, such as "views_agree"
    CheckLevel level = CheckLevel::Pass;
    Message text; ///< a whole sentence; of a check that was passed what was checked
};

/// What the checks of a trial say; docs/trust.md explains what each can know.
struct TrialVerdict
{
    std::vector<TrialCheck> checks; ///< each code once at least, in a fixed order

    /// The worst of them. Pass without any.
    CheckLevel level() const;
};

/// Checks the results of a trial from what the project holds of it: views that agree, time measured,
/// synchronisation, frame intervals, damaged frames, spikes, speeds, names, lenses, cameras that have not
/// moved, and stored results that are as computed. Without an analysis there are no checks. Errors: those of
/// the repositories. recordings: of the trial, in the order of its views. Project's thread.
Result<TrialVerdict> verdictOn(Project &project, const TrialRecord &trial,
                               const std::vector<const RecordingRecord *> &recordings,
                               const std::vector<AnalysisRecord> &analyses);

} // namespace odo
