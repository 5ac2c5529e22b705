// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"

#include <span>
#include <vector>

namespace odo {

/// Sets ByHand on the samples that a person has judged: with Jump where it is called a spike, without any
/// flag that rejects where it is called valid. Samples without a position have nothing to judge and stay as
/// they are. Whoever flags samples afterwards leaves those alone.
void applyOverrules(std::vector<Sample> &samples, std::span<const Overrule> overrules);

/// The list with one more word, in place of an older one on the same frame, in order of the frames.
std::vector<Overrule> withOverrule(std::vector<Overrule> overrules, Overrule added);

/// The list without any word on a frame.
std::vector<Overrule> withoutOverrule(std::vector<Overrule> overrules, std::int64_t frame);

} // namespace odo
