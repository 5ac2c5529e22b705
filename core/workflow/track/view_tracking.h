// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/project/records.h"
#include "core/tracking/background.h"
#include "core/tracking/camera_watch.h"
#include "core/workflow/trial_sources.h"

#include <functional>
#include <optional>
#include <vector>

namespace odo {

/// What the frames of a view are where the camera took fields.
enum class Interlace {
    None,
    Fields, ///< its fields: two for each coded frame, each of its own moment
    Whole   ///< as coded, with two moments in each: the file says nothing of fields, or they were counted so
};

/// What one view gave: a series of observations for each robot, in the robots' order.
struct TrackedView
{
    std::vector<ObservationSeries> series;
    /// Likewise of each other thing that was followed, where a robot is of any look: it may be the robot
    /// (settleNames).
    std::vector<std::vector<Observation>> others;
    std::int64_t frames = 0;
    std::vector<Nanoseconds> fileTimes; ///< of all frames, by the file's own stamps; empty of stored series
    Interlace interlace = Interlace::None;
    Nanoseconds decodeCpuTime{0};
    /// Of each robot: the part of the first frame with its given colour. Empty where nothing was decoded.
    std::vector<double> sharesAlike;
    /// The camera was moved; from then on nothing is measured in this view.
    std::optional<CameraMove> cameraMove;
    std::vector<LightLevel> light;        ///< of every frame, where it was asked for
    std::optional<Background> background; ///< by which robots were found, where one was needed
};

enum class WithLight { Ignored, Measured };

/// Decodes and tracks all views at once, a thread to track and a thread to decode for each; MJPEG is decoded
/// by the thread that tracks, which alone knows what part of the next frame it needs. Without a robot only
/// the light is measured. A robot whose coloured outlines no box, cylinder or plate explains (it has wheels,
/// parts of other colours, openings) is tracked once more by its whole silhouette, identified by its colour,
/// and measured that way if it explains more. Touches no project. Errors: a recording that is missing or is
/// no video; cancelled.
Result<std::vector<TrackedView>> trackViews(const std::vector<RegisteredView> &views,
                                            const std::vector<RobotRecord> &robots, const JobControl &control,
                                            WithLight light = WithLight::Ignored);

/// Gives views that were tracked whole, though each frame holds two moments (Interlace::Whole), the times of
/// their fields, where the reader finds fields in the file, too: tracked again they are measured field by
/// field. Frames are then counted otherwise, so nothing may be stored of the trial yet. Gives their numbers.
std::vector<std::size_t> takeFields(std::vector<RegisteredView> &views,
                                    const std::vector<TrackedView> &tracked, const CancelToken &cancel);

/// Tracks once more what trackViews measured by its silhouette, before the same backgrounds, as if shadows
/// looked like that. All other series stay as they are.
Result<std::vector<TrackedView>> trackAgain(const std::vector<RegisteredView> &views,
                                            const std::vector<RobotRecord> &robots,
                                            const std::vector<TrackedView> &before,
                                            const Background::Shadow &shadow, const JobControl &control);

/// What a stored series says of its camera's move; nullopt: it was not moved, or not watched.
std::optional<CameraMove> storedMove(const ObservationSeries &series);

/// Whether any registered view found a robot, by its number, in any frame.
bool isEverSeen(const std::vector<RegisteredView> &views, const std::vector<TrackedView> &tracked,
                std::size_t robot);

/// One robot's part of what trackViews gave, ready to be analysed: with the damaged frames, as such in which
/// nothing was found. Its observations are moved there, not copied: an hour of them is 16 MB a view.
/// returnObservations gives them back as they were.
std::vector<ViewTrack> takeViewTracks(const std::vector<RegisteredView> &views,
                                      std::vector<TrackedView> &tracked, std::size_t robot);
void returnObservations(std::vector<ViewTrack> tracks, std::vector<TrackedView> &tracked, std::size_t robot);

RobotShape shapeOf(const RobotRecord &robot);

/// An analysis with its provenance filled in and its profile still empty.
AnalysisRecord newAnalysis(const TrialRecord &trial, const RobotRecord &robot,
                           const std::vector<RegisteredView> &views, AnalysisOptions options);

/// Gives observations the times of their frames as they are now: they may have been corrected since
/// (correctFrameTimes).
void stampAsRecorded(std::vector<Observation> &observations, const std::vector<Nanoseconds> &frameTimes);

enum class StoredAs {
    InForce, ///< with what was corrected by hand
    Tracked  ///< without
};

/// What trackViews once gave and the project has kept: the newest observations of each robot in each view,
/// none where a view was never tracked. NotFound for a robot that no view was tracked for. Project's thread.
Result<std::vector<TrackedView>> storedObservations(Project &project, const std::string &trialName,
                                                    const std::vector<RegisteredView> &views,
                                                    const std::vector<RobotRecord> &robots,
                                                    StoredAs which = StoredAs::InForce);

/// A profile with the options that it was made with in the end.
struct TaskAnalysis
{
    Profile profile;
    AnalysisOptions options;
    /// empty, or why the task's limits were left out: "what: why; do this" from the why on
    Message caveat;
};

/// Makes a profile with the options it is given.
using MakeProfile = std::function<Result<Profile>(const AnalysisOptions &)>;

/// An analysis by a task, if there is one. Limits that refuse more than a fifth of what was measured are none
/// of this robot's: then it is made once more without them, and says so. As pure as `make`.
Result<TaskAnalysis> analyseByTask(const MakeProfile &make, const AnalysisOptions &options,
                                   const std::optional<TaskRecord> &task);

} // namespace odo
