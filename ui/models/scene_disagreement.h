// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/view_disagreement.h"
#include "ui/models/explanation.h"

#include <vector>

namespace odo {

/// Of each robot of a scene; without places where it was not tracked. Pure, any thread; a millisecond for a
/// thousand frames.
std::vector<ViewDisagreement> disagreementsOf(const TrialScene &scene);

/// "RMS 3.2 mm, median 2.5 mm" and what the stated errors let expect, in two lines.
QString disagreementWords(const ViewDisagreement &disagreement);

Explanation explainDisagreement(const TrialScene &scene, std::size_t robot,
                                const ViewDisagreement &disagreement);

} // namespace odo
