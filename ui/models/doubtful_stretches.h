// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/time_span.h"
#include "ui/models/trial_scene.h"

#include <QString>
#include <vector>

namespace odo {

/// A stretch of a trial in which less than usual is known of a robot, and why.
struct DoubtfulStretch
{
    /// Name: which of several robots it is. Occlusion: a view did not measure all of it.
    enum class Kind { Name, Occlusion };

    std::size_t robot = 0; ///< index into TrialScene::robots
    TimeSpan span;
    Kind kind = Kind::Name;
    QString reason;   ///< "hidden behind Blue 1 in view A"; of a name until when it is doubtful
    QString sentence; ///< "Red 2: hidden behind Blue 1 in view A (3.20 s to 3.90 s)"
};

/// "hidden behind Blue 1 in view A (3.20 s to 3.90 s)", in the language of the windows.
QString occlusionText(const Occlusion &occlusion);
/// Of all robots, in order of time; in the language of the windows.
std::vector<DoubtfulStretch> doubtfulStretches(const TrialScene &scene);
/// What is said of those at a time, or so near to it, for a tool tip; empty: nothing.
QString doubtfulWordsAt(const std::vector<DoubtfulStretch> &stretches, Nanoseconds time, Nanoseconds reach = Nanoseconds{0});

} // namespace odo
