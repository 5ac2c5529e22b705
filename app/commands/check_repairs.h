// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_call.h"

namespace odo {

/// The options of odograph check that change something.
QList<QCommandLineOption> repairOptions();
/// Whether any of them is set.
bool asksForRepairs(const CommandCall &call);

/// What was done about files that are lost or belong to nobody.
struct MediaRepairs
{
    QJsonObject json;
    QStringList lines;
};
/// As the options ask: finds lost videos by their content, makes trials of stray ones, removes stray files. The project is open to write.
Result<MediaRepairs> repairMedia(const CommandCall &call, Project &project);

} // namespace odo
