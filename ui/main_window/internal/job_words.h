// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/synchronise_job.h"
#include "core/workflow/track/track_job.h"

#include <QString>
#include <vector>

namespace odo {

/// What a job that has ended did, in sentences for a person, with its warnings.
QString importedWords(const TrialRecord &trial, const std::vector<Message> &warnings);
QString trackedWords(const TrackOutcome &outcome);
QString synchronisedWords(const SynchroniseJob &job);

} // namespace odo
