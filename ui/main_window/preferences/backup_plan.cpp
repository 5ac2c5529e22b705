// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/preferences/backup_plan.h"

#include <QSettings>
#include <algorithm>

namespace odo {

namespace {
const QString dailyKey = QStringLiteral("backups/daily"), daysKey = QStringLiteral("backups/days");
} // namespace

BackupPlan chosenBackupPlan()
{
    const QSettings settings;
    BackupPlan plan;
    plan.isDaily = settings.value(dailyKey, plan.isDaily).toBool();
    plan.daysKept = std::clamp(settings.value(daysKey, plan.daysKept).toInt(), BackupPlan::fewestDays,
                               BackupPlan::mostDays);
    return plan;
}

void chooseBackupPlan(const BackupPlan &plan)
{
    QSettings settings;
    settings.setValue(dailyKey, plan.isDaily);
    settings.setValue(daysKey, plan.daysKept);
}

} // namespace odo
