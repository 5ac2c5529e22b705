// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/project/verdict_repository.h"
#include "core/trajectory/occlusions.h"
#include "core/workflow/job.h"
#include "core/workflow/track/guidance.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace odo {

/// Where a person has marked a robot of any look in a frame of the trial.
struct RobotPointer
{
    std::string robot;
    /// its camera; empty: removes the earlier marks of the robot
    std::string view;
    double timeS = 0;                                ///< of the trial; the nearest frame is meant
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< luma pixels
    bool isFurther = false;                          ///< earlier marks in other frames of the view stay
};

struct TrackSettings
{
    std::vector<std::string> robots;  ///< names; empty: those of the trial, or else all of the project
    std::optional<Smoother> smoother; ///< empty: Rts, or with `again` that of the robot's newest analysis
    /// Nothing is decoded: the newest stored observations are reanalysed with the current registrations,
    /// robot size and overrides.
    bool again = false;
    std::map<std::string, std::vector<ManualOverride>> overrides; ///< by robot, instead of the stored ones
    /// kept with the trial, replacing those of the same robot and view, or with isFurther of the same frame
    std::vector<RobotPointer> pointers;
    /// kept with the trial. Areas need the videos; points by hand and what is not visible are applied to the
    /// stored observations with `again`, as another series.
    GuidanceEdit guidance = {};
    /// The range that the trial gets, in place of its own; the inner one empty: none. With `again`; the
    /// registrations are then those of the newest analysis, for only what counts of the run changes.
    std::optional<std::optional<TimeSpan>> range = {};
};

/// What tracking gave for one robot, as the command line prints it.
struct TrackedRobot
{
    std::string name;
    std::int64_t frames = 0;  ///< of the first view
    std::int64_t tracked = 0; ///< of them, with a position
    bool isFoundByColour = false;
    /// for how long it was ambiguous among similar robots; empty with `again` where no such time is stored
    std::optional<double> ambiguousS;
    std::vector<Occlusion> occlusions; ///< when which view did not measure the whole of it
    AnalysisRecord analysis;
};

struct TrackOutcome
{
    std::string trial;
    std::vector<TrackedRobot> robots;
    double wallS = 0;
    double decodeS = 0;            ///< CPU time of the decoding threads
    double framesPerSecond = 0;    ///< of frames of all views
    std::vector<Message> warnings; ///< whole sentences: what makes the metrics uncertain, and what to do
    TrialVerdict verdict;          ///< on these results; after commit
};

/// Tracks the robots of a trial in all its views and analyses them by its task: observations and a new
/// analysis each are stored. A view whose time offset is still open (isSyncOpen) is synchronised first.
/// Manual overrides, marks and range stay in force: of a trial with a range, what is within it is analysed by
/// itself, and what is outside has no part in it. Of a trial whose tracks were imported there is nothing to
/// track: it can only be analysed `again`, from the imported positions; InvalidInput otherwise.
class TrackJob : public Job
{
public:
    TrackJob(std::string trial, TrackSettings settings);
    ~TrackJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    /// With `again`, between prepare and run: analyses the stored observations by the clocks and frame times
    /// of these recordings, which are to be stored before the commit.
    void synchroniseAs(const std::vector<RecordingRecord> &recordings);

    const TrackOutcome &outcome() const; ///< after run; the analyses have their numbers after commit

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
