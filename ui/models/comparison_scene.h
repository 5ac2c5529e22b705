// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/compare_trials.h"
#include "ui/models/trial_scene.h"

#include <QStringList>
#include <memory>
#include <vector>

namespace odo {

/// Everything that Compare shows of its runs: an immutable value, safe to share with any thread.
struct ComparisonScene
{
    CompareSettings settings;          ///< that it was made by
    std::vector<TrialScenePtr> scenes; ///< one a run
    std::vector<std::size_t> robots;   ///< of each run its robot in its scene
    ComparedTrials trials;
    TrialComparison compared;

    std::size_t runCount() const { return scenes.size(); }
    const RobotRecord &robot(std::size_t run) const { return scenes[run]->robots[robots[run]].robot; }
    const Profile &profile(std::size_t run) const { return trials.runs[run].analysis.profile; }
    std::string name(std::size_t run) const { return runName(trials.runs[run]); }
    QStringList names() const; ///< of all runs
    /// The common time, 0 at what counts as the same moment, and a run's own.
    Nanoseconds ownTime(std::size_t run, Nanoseconds common) const;
    Nanoseconds commonTime(std::size_t run, Nanoseconds own) const;
    /// From the earliest frame of all runs to the last one, at the first run's interval: the time line of the
    /// comparison.
    std::vector<Nanoseconds> frameTimes() const;
    /// How far along the common path a run is, distance 0 as in the comparison.
    double distanceAt(std::size_t run, Nanoseconds common) const;
    /// Where a run is; nullopt where it is not known.
    const ProfilePoint *pointAt(std::size_t run, Nanoseconds common) const;
    /// The rectangle of the floor that matters to any of them.
    Eigen::AlignedBox2d floorBounds() const;
};

using ComparisonScenePtr = std::shared_ptr<const ComparisonScene>;

/// Reads and compares, on the project's thread. Errors: those of loadTrialScene, readComparedTrials and
/// compareTrials.
Result<ComparisonScenePtr> loadComparisonScene(Project &project, const CompareSettings &settings);

} // namespace odo
