// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QString>
#include <vector>

namespace odo {

/// Whether teams that have a pseudonym are shown by it, on this computer and in every mode alike. Remembered.
/// Any thread.
bool arePseudonymsShown();
void showPseudonyms(bool shown);

/// The one place that decides by which name a team is shown.
QString shownTeam(const std::string &name, const std::string &pseudonym);
QString shownTeam(const TrialRecord &trial); ///< empty without a team
QString shownTeam(const TeamRecord &team);

/// An error of the core ("team 'Anna and Ben': …") with the pseudonyms of teams in the place of their quoted names, and without the
/// quoted names of their members, where pseudonyms are shown.
Error shownError(Error error, const std::vector<TeamRecord> &teams);

} // namespace odo
