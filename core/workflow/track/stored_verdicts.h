// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/project/verdict_repository.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Computes the verdict on a trial from what the project holds, stores it, in the transaction that changed
/// results, and returns it. made: its analyses that were just stored; of other robots they are read.
/// Project's thread.
Result<TrialVerdict> storeVerdict(Project &project, const TrialRecord &trial,
                                  const std::vector<AnalysisRecord> &made);

/// Computes the verdicts on trials; leaves out those that cannot be read, which is said where they are
/// opened. Reads all their series: some 10 ms each. Errors: Cancelled, in a CancelScope. On the thread of the
/// project, which may be open for reading only.
Result<std::vector<StoredVerdict>> computeVerdicts(Project &project, const std::vector<RecordId> &trials);

/// Stores what computeVerdicts() gave, in one transaction; what is out of date by now counts no more anyway.
Result<void> storeVerdicts(Project &project, const std::vector<StoredVerdict> &verdicts);

/// Both for all trials whose verdict is missing: at the end of a command that changes what verdicts follow
/// from.
Result<void> storeMissingVerdicts(Project &project);

/// The verdicts on trials that are analysed, without the checks that were passed; those that are not stored
/// are computed, which takes its time after an update. As computeVerdicts().
Result<std::map<RecordId, TrialVerdict>> trialVerdicts(Project &project, const std::set<RecordId> &trials);

/// Lets a doubtful result count like one without a doubt, for a reason; a change that can be undone. It ends
/// when another check becomes doubtful. Errors: NotFound for a trial that is not there or not tracked;
/// InvalidInput for a blank reason, for a bad verdict and for one that is not doubtful.
Result<void> acceptVerdict(Project &project, const std::string &trial, const std::string &reason);

/// NotFound where it was not accepted.
Result<void> withdrawAcceptance(Project &project, const std::string &trial);

} // namespace odo
