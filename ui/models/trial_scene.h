// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/scoring.h"
#include "core/base/error.h"
#include "core/geometry/floor_view.h"
#include "core/project/guidance_repository.h"
#include "core/project/records.h"
#include "core/trajectory/occlusions.h"
#include "core/workflow/track/trial_verdict.h"

#include <Eigen/Geometry>
#include <QString>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// The last point at or before a time; -1 before the first one, and where the profile does not know.
std::ptrdiff_t pointIndexAt(const Profile &profile, Nanoseconds time);

/// The part of a run that a time is in: its profile, or what is before or after its range.
const Profile &partAt(const AnalysisRecord &analysis, Nanoseconds time);

/// Heading of the body at a point, radians, where it was measured; else the direction of motion, and while
/// the robot stands still the last one. nullopt: neither is known, nor was before.
std::optional<double> drivenHeadingAt(const Profile &profile, std::ptrdiff_t index);

class Project;

/// One view of a trial as the windows show it.
struct SceneView
{
    std::string camera;
    RecordingRecord recording;                     ///< its frame times are there even when the file is lost
    std::filesystem::path file;                    ///< absolute
    std::optional<FloorView> floorView;            ///< empty: the camera is not registered
    std::optional<FloorRegistration> registration; ///< as floorView
    Nanoseconds startOffset{0}; ///< how much later its first frame was taken than the first view's
    double clockRate = 0;       ///< by how much its clock runs faster than the first view's
};

/// One robot of a trial.
struct SceneRobot
{
    RobotRecord robot;
    std::optional<AnalysisRecord> analysis;             ///< the newest; empty: not tracked yet
    std::vector<std::vector<Observation>> observations; ///< one list a view, in order of frames; may be empty
    /// when which view did not measure all of it, in order of time
    std::vector<Occlusion> occlusions;
};

/// Everything that Review shows of one trial: an immutable value, made on the project's thread and safe to
/// share with any other. World frame and SI throughout.
struct TrialScene
{
    TrialRecord trial;
    std::vector<SceneView> views;
    std::vector<SceneRobot> robots;
    std::optional<MarkerLayout> layout;  ///< of the first registered view
    std::optional<Task> task;            ///< that was to be driven
    RecordId taskId = 0;                 ///< of it; 0: none
    std::vector<Criterion> scoring;      ///< of it; empty: it is not scored
    std::vector<ImportedTrack> imported; ///< where its tracks came from; empty: our own views measured them
    std::vector<PointedOutRobot> pointedOut; ///< by a person
    std::vector<GuidanceItem> guidance;      ///< by a person
    /// Whether the views were tracked by other areas than those given now; a new tracking uses them.
    bool isGuidanceNew = false;
    TrialVerdict verdict;                   ///< on its results
    std::vector<Nanoseconds> importedTimes; ///< of all samples then, in order

    /// Frame times of the first view, which is the time line of the trial; of imported tracks their times.
    const std::vector<Nanoseconds> &frameTimes() const;
    /// The frame of a view nearest to a time of the first view; nullopt before its first or after its last
    /// frame by more than an interval (cameras that started together are still a part of one apart).
    std::optional<std::int64_t> frameAt(std::size_t view, Nanoseconds time) const;
    /// When a frame of a view was taken, on the first view's clock.
    Nanoseconds timeOf(std::size_t view, std::int64_t frame) const;
    /// What a view saw of a robot in a frame; nullptr when nothing.
    const Observation *observationAt(std::size_t view, std::size_t robot, std::int64_t frame) const;
    /// The robot's height over the floor that was used for its positions; 0 before an analysis.
    double heightM(std::size_t robot) const;
    /// What its positions are of: forward and left from its footprint's centre. The centre for imported
    /// tracks.
    Eigen::Vector2d referenceM(std::size_t robot) const;
    /// The rectangle of the floor that matters: markers, the task and valid track points; a unit square where
    /// there are none.
    Eigen::AlignedBox2d floorBounds() const;
    /// A marker of the layout by its label.
    std::optional<Eigen::Vector2d> marker(const std::string &label) const;
};

using TrialScenePtr = std::shared_ptr<const TrialScene>;

/// Reads a trial on the project's thread. The registrations are those of the analysis, or else those in
/// force; both are in the present axes of their layout (bringToPresentAxes). Errors: NotFound with the names
/// there are; those of the repositories.
Result<TrialScenePtr> loadTrialScene(Project &project, const std::string &trialName);

} // namespace odo
