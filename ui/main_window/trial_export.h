// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>

class QWidget;

namespace odo {

class Project;

/// Asks for a robot (where there are several), a format and a file, and writes the trial's newest track
/// there. Gives what there is to say; an empty text when the person thought better of it.
Result<QString> exportTrial(Project &project, const QString &trial, QWidget &window);

} // namespace odo
