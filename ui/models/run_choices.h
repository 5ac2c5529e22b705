// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/compare_trials.h"

#include <QList>
#include <QString>
#include <optional>
#include <span>

namespace odo {

/// A run that can be compared, and what it is called in lists.
struct RunChoice
{
    CompareSettings::Run run;
    QString words;
};

/// The runs of trials, newest first, that are not in the bin, in the order of time: one a trial, or one for
/// each of its robots.
QList<RunChoice> runChoices(std::span<const TrialRecord> trials);

/// Where runs stand among the choices, each place at most once; one that does not is left out. A robot that
/// is not named is any.
QList<int> placesOf(const QList<RunChoice> &choices, std::span<const CompareSettings::Run> runs);

/// What a trial suggests itself to be compared with: the newest other trial of the same task that was
/// tracked, or else the newest other one that was. trials: newest first. On the project's thread. Errors:
/// those of the repositories.
Result<std::optional<std::string>> partnerOf(Project &project, std::span<const TrialRecord> trials,
                                             const std::string &name);

} // namespace odo
