// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

namespace odo {

class Project;

/// Everything a job could change in a project, one line each: its records with the numbers of the newest
/// ones, and the files beside it. Equal before and after: the project was left as it was.
QStringList contentOf(Project &project);

} // namespace odo
