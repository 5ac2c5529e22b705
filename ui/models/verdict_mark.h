// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/verdict_repository.h"
#include "ui/models/number_text.h"

#include <QStringList>

namespace odo {

/// How every list, window and report shows the verdict on a trial: a sign, a word and a colour.
Badge verdictBadge(const TrialVerdict &verdict);
/// The word alone.
QString shownVerdict(const TrialVerdict &verdict);

/// A sentence for each check that was not passed, and the reason why that was accepted.
QStringList verdictReasons(const TrialVerdict &verdict);

/// The reasons, or that all checks were passed.
QString verdictText(const TrialVerdict &verdict);

} // namespace odo
