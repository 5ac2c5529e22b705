// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "core/workflow/trials/trial_range.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// What a person changes about a trial. What is not set stays.
struct TrialEdit
{
    std::optional<std::string> name = {};
    /// Empty: none. A team that the project doesn't have is added.
    std::optional<std::string> team = {};
    /// The class of the trial's team. A team without a class is put into it.
    std::optional<std::string> className = {};
    std::optional<Instant> date = {};
    std::optional<std::string> task = {}; ///< empty: none
    std::optional<std::vector<std::string>> robots = {};
    std::optional<std::string> notes = {};
    std::optional<std::vector<std::string>> tags = {};
    std::map<std::string, std::string> variables = {}; ///< empty: the trial loses it
    std::optional<RangeChoice> range = {};
};

bool isEmpty(const TrialEdit &edit);

/// Words of a change of several things.
Message editTrialWords(const std::string &trial);

/// Makes all of it one change, which can be undone; gives the trial as it is then. On the project's thread.
/// Errors, and nothing is changed: NotFound for a trial, task or robot that the project doesn't have;
/// AlreadyExists for a name that is taken; WrongCall for a date that is still to come; InvalidInput for a
/// team that belongs to another class than the trial, unless that class is given, or than the class that is
/// given, and for a class without a team; those of RangeJob.
Result<TrialRecord> editTrial(Project &project, RecordId trial, const TrialEdit &edit);

/// The same edit of several trials, as one change: all of them, or none. Gives them as they are then, in
/// order. Errors as editTrial, of the first trial that has one.
Result<std::vector<TrialRecord>> editTrials(Project &project, const std::vector<RecordId> &trials,
                                            const TrialEdit &edit);

/// Adds a trial as one change, and undoing it moves the trial to the bin: what was measured stays. add:
/// stores the trial with all that belongs to it, and gives its id. On the project's thread. Errors: those of
/// add.
Result<void> addTrial(Project &project, const Message &words, const std::function<Result<RecordId>()> &add);

/// Moves trials to the bin, or restores them from it, as one change. On the project's thread.
Result<void> setInBin(Project &project, const std::vector<TrialRecord> &trials, bool isInBin);

} // namespace odo
