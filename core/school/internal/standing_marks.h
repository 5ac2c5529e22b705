// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QJsonObject>
#include <map>
#include <string>

namespace odo {

class Project;

/// How a trial counts in standings, as the hub keeps it: as a sound result, as one with a mark, or not at
/// all, for its results are bad or were measured by another course than its task has now.
namespace standingWord {
constexpr const char *pass = "pass", *doubtful = "doubtful", *bad = "bad", *otherwise = "otherwise";
} // namespace standingWord

/// What standings need of each trial that is not in the bin, beyond its own document: it may change without
/// it, with an acceptance or another scoring. {standing, scores{robot: {value, sigma}}}, by the trials. On
/// the project's thread. Errors: those of the repositories and of trialVerdicts().
Result<std::map<RecordId, QJsonObject>> standingMarks(Project &project);

} // namespace odo
