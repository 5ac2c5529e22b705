// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/sync_passport.h"
#include "ui/models/explanation.h"
#include "ui/models/trial_scene.h"

#include <QString>
#include <QStringList>

namespace odo {

/// What is computed of a trial as it is shown, in lines.

/// What the synchronisation of the views is worth in this run (core/workflow/track/sync_passport.h).
SyncPassport passportOf(const TrialScene &scene);
/// Whole sentences; none of a trial with one view.
QStringList passportLines(const SyncPassport &passport);
Explanation explainPassport(const TrialScene &scene, const QString &value);
/// "±1.4 mm at the top speed"; empty where it is not known. view: from 1 on.
QString costText(const SyncPassport &passport, std::size_t view);

/// How long a robot was in each zone of its task, how often it entered, and when first
/// (core/analysis/zone_visits.h); none where it was measured by another course.
QStringList zoneVisitLines(const TrialScene &scene, std::size_t robot);

} // namespace odo
