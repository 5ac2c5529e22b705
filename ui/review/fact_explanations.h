// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/gate_passages.h"
#include "ui/models/explanation.h"

#include <optional>

namespace odo {

/// "How was this computed?" of the facts of a trial's card that are measured.

/// The times at which a robot passed the gates.
Explanation explainPassages(const TrialScene &scene, std::size_t robot, const QString &value);
/// A whole lap, or run from start to finish.
Explanation explainLap(const TrialScene &scene, std::size_t robot, const Lap &lap, const QString &what);
/// Several figures of one kind beneath one another: those whose names begin so ("cross_track", "zone_").
Explanation explainFigures(const TrialScene &scene, std::size_t robot, const QString &what, const QString &value, const std::string &stem);
/// How a view was put in step with the first; nullopt: it was told, or taken as begun together, and nothing was computed.
std::optional<Explanation> explainStep(const SceneView &view, const QString &value);
/// The robot's height; nullopt: it was told.
std::optional<Explanation> explainHeight(const TrialScene &scene, std::size_t robot);

} // namespace odo
