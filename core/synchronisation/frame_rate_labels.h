// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

namespace odo {

/// By how much a clip's clock seems to run fast (below 0: slow) where its file states one of the usual frame
/// rates for another, from half to twice as many; without 0.
std::vector<double> labelRates();

/// The usual frame rate at which a clip was recorded whose file states another, and whose clock therefore
/// seems to run fast by a rate. nullopt: neither is a usual one, or they are the same.
std::optional<double> rateBehindLabel(double statedRate, double clockRate);

} // namespace odo
