// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/backups.h"

namespace odo {

/// How projects are backed up, as the preferences have it. GUI thread.
BackupPlan chosenBackupPlan();
void chooseBackupPlan(const BackupPlan &plan);

} // namespace odo
