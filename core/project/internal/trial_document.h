// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/scoring.h"
#include "core/project/internal/document_fields.h"
#include "core/project/records.h"

#include <QCborMap>
#include <QJsonArray>

namespace odo {

class Project;

// Parts of SchoolDocument, on the project's thread. Errors: those of the repositories. What is read from
// elsewhere and is not sound is left to the fields, and is written into a transaction that its caller gives
// up.

Message publishAgain(); ///< advice

QCborMap taskDocument(const TaskRecord &task, const std::vector<Criterion> &scoring);
/// Without id and scoring.
TaskRecord taskIn(const DocumentFields &fields);
std::vector<Criterion> scoringIn(const DocumentFields &fields);
QCborMap robotDocument(const RobotRecord &robot);
/// The robot of that name, added where there is none.
Result<RecordId> robotFor(Project &project, const DocumentFields &fields);

Result<QCborMap> trialDocument(Project &project, const TrialRecord &trial);
/// Empty for a trial without recordings.
Result<QCborMap> recordingsDocument(Project &project, const TrialRecord &trial);
Result<QJsonArray> trialResults(Project &project, const TrialRecord &trial);
/// existing: 0 for a new trial.
Result<RecordId> storeTrial(Project &project, const DocumentFields &fields, RecordId existing,
                            const std::string &owner);

/// The newest analyses of a trial, whole runs with their ranges.
Result<QCborArray> analysesDocument(Project &project, RecordId trial);
Result<void> storeAnalyses(Project &project, const DocumentFields &trial, RecordId id);
QCborArray tracksDocument(Project &project, const TrialRecord &trial);
Result<void> storeTracks(Project &project, const DocumentFields &trial, RecordId id);

} // namespace odo
