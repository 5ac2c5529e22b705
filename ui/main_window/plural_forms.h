// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QCoreApplication;

namespace odo {

/// Lets words that are counted have their English plural forms ("1 team", "2 teams"): without it tr("%n team(s)") shows its
/// brackets. Once, before the first window; GUI thread.
void installPluralForms(QCoreApplication &application);

} // namespace odo
