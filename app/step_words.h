// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QString>
#include <QStringList>

namespace odo {

/// One line for each view but the first: how it was put in step with the first one, and to how much:
/// "View B: in step to 0.3 ms, found from the motion; begun 413.7 ms later". None for a single view.
QStringList stepSentences(const std::vector<RecordingRecord> &views);

} // namespace odo
