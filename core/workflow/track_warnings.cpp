// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track_warnings.h"

#include "core/trajectory/unseen_stretches.h"

#include <cmath>

namespace odo {

namespace {

constexpr double mostOfPicture = 0.10; ///< larger no robot is in a picture that shows its task
constexpr double hardlyEver = 0.05;    ///< of the frames

double partFound(const std::vector<TrackedView> &tracked, std::size_t robot)
{
    std::size_t found = 0, frames = 0;
    for (const TrackedView &view : tracked) {
        for (const Observation &observation : view.series[robot].observations) {
            found += observation.found;
            ++frames;
        }
    }
    return frames > 0 ? double(found) / double(frames) : 0;
}

} // namespace

std::string robotInTrial(const std::string &robotName, const std::string &trialName)
{
    return "robot '" + robotName + "' in trial '" + trialName + "'";
}

std::vector<std::string> analysisWarnings(const AnalysisRecord &analysis, const std::string &trialName)
{
    auto sentences = describeUnseenStretches(analysis.profile, analysis.options.longestBridgedGap);
    for (std::string &sentence : sentences)
        sentence = robotInTrial(analysis.robotName, trialName) + ": " + sentence;
    return sentences;
}

std::optional<FloorColour> floorColourOf(const RobotRecord &robot, const std::string &trialName,
                                         const std::vector<RegisteredView> &views,
                                         const std::vector<TrackedView> &tracked, std::size_t robotIndex)
{
    std::size_t worst = 0;
    double share = 0;
    for (std::size_t v = 0; v < tracked.size(); ++v) {
        if (robotIndex < tracked[v].sharesAlike.size() && tracked[v].sharesAlike[robotIndex] > share) {
            share = tracked[v].sharesAlike[robotIndex];
            worst = v;
        }
    }
    if (share <= mostOfPicture)
        return std::nullopt;
    return FloorColour{{ErrorCode::Undetermined, robotInTrial(robot.name, trialName),
                        "its colour " + robot.colour.toString() + " is also that of the floor (" +
                            std::to_string(std::lround(100 * share)) + " % of view " +
                            views[worst].recording.cameraName + "'s picture)",
                        "put a plate of another colour on it, or tell the colour it really has"},
                       partFound(tracked, robotIndex) < hardlyEver};
}

} // namespace odo
