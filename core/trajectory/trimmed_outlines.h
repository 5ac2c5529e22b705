// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/observation.h"

#include <vector>

namespace odo {

/// Doubts the whole outlines of a robot whose thin parts (a cable, a mast) were left out of many others: there they lie before or behind its body and
/// cannot be told from it. Such outlines are not used to learn its form, and tell its place only roughly. views: what each view saw of one robot, as
/// tracked. Pure.
void doubtUntrimmed(const std::vector<std::vector<Observation> *> &views);

} // namespace odo
