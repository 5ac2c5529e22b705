// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "core/trajectory/occlusions.h"
#include "core/workflow/job.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace odo {

/// Where a person says that a robot of any look is in a picture of the trial.
struct RobotPointer
{
    std::string robot;
    /// its camera; empty: what was said of the robot before is taken back
    std::string view;
    double timeS = 0;                                ///< of the trial; the nearest picture is meant
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< luma pixels
};

struct TrackSettings
{
    std::vector<std::string> robots;  ///< names; empty: those of the trial, or else all of the project
    std::optional<Smoother> smoother; ///< empty: Rts, or with `again` that of the robot's newest analysis
    /// Nothing is decoded: the newest stored observations are analysed anew, with what is in force now
    /// (registrations, the robot's size, overrules).
    bool again = false;
    std::map<std::string, std::vector<Overrule>> overrules; ///< by robot, in place of the stored ones
    /// kept with the trial, in place of what was said of the same robot and view
    std::vector<RobotPointer> pointers;
};

/// What tracking gave for one robot, as the command line prints it.
struct TrackedRobot
{
    std::string name;
    std::int64_t frames = 0;  ///< of the first view
    std::int64_t tracked = 0; ///< of them, with a position
    bool isFoundByColour = false;
    /// for how long it could not be told from others of its look; empty with `again` where no such time is
    /// stored
    std::optional<double> doubtfulS;
    std::vector<Occlusion> occlusions; ///< when which view did not measure the whole of it
    AnalysisRecord analysis;
};

struct TrackOutcome
{
    std::string trial;
    std::vector<TrackedRobot> robots;
    double wallS = 0;
    double decodeS = 0;            ///< CPU time of the decoding threads
    double framesPerSecond = 0;    ///< of pictures of all views
    std::vector<Message> warnings; ///< whole sentences: what makes the figures doubtful, and what to do
};

/// Tracks the robots of a trial in all its views and analyses them by its task: observations and a new
/// analysis each are stored. What a person has overruled or pointed out stays in force. Of a trial whose
/// tracks were imported there is nothing to track: it can only be analysed `again`, from the imported
/// positions; InvalidInput otherwise.
class TrackJob : public Job
{
public:
    TrackJob(std::string trial, TrackSettings settings);
    ~TrackJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const TrackOutcome &outcome() const; ///< after run; the analyses have their numbers after commit

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace odo
