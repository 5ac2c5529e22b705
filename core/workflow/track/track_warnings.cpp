// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/track_warnings.h"

#include "core/base/percentile.h"
#include "core/trajectory/occlusions.h"
#include "core/trajectory/view_disagreement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace odo {

namespace {

constexpr double mostOfPicture = 0.10; ///< larger no robot is in a picture that shows its task
constexpr double hardlyEver = 0.05;    ///< of the frames
constexpr double doubtfulStepS = 0.005;
const std::string changedResults =
    "its results are not those that its analysis gave: they were changed in the file; run odograph check, or "
    "analyse the trial again";

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
    std::vector<std::string> sentences;
    if (!analysis.views.empty()) // of an imported track no camera could be moved
        sentences = describeUnseenStretches(analysis.profile, analysis.options.longestBridgedGap);
    if (analysis.proof == AnalysisRecord::Proof::Broken)
        sentences.insert(sentences.begin(), changedResults);
    if (const std::string apart = viewsApartSentence(analysis.profile); !apart.empty())
        sentences.push_back(apart);
    if (!analysis.doubtfulNames.empty())
        sentences.push_back(doubtfulNamesSentence(analysis.doubtfulNames, analysis.robotName) +
                            "; give each a colour of its own");
    for (std::string &sentence : sentences)
        sentence = robotInTrial(analysis.robotName, trialName) + ": " + sentence;
    return sentences;
}

std::string viewsApartSentence(const Profile &profile)
{
    static constexpr double mostApart = 0.1; // of what several views saw
    ViewsApart found = viewsApart(profile.samples);
    if (double(found.apartM.size()) <= mostApart * double(found.seen))
        return {};
    const std::string where = "in " + std::to_string(found.apartM.size()) + " of " +
                              std::to_string(found.seen) + " pictures the views ";
    const double medianM = upperMedian(std::move(found.apartM));
    if (medianM > farApartM)
        return where + "have it at places far apart: one of them follows something else, or is not where it "
                       "was registered; look at the outlines, and tell the robot's colour or "
                       "keep others out of the pictures";
    return where + "contradict one another: they put it " + formatNumber(1000 * medianM, 1) +
           " mm apart; a camera was moved after it was registered, the views are out of step, or the robot's "
           "height is not what was told; register the cameras again";
}

std::string doubtfulNamesSentence(std::span<const DoubtfulName> doubts, const std::string &robotName)
{
    if (doubts.empty())
        return {};
    std::set<std::string> others;
    for (const DoubtfulName &doubt : doubts)
        others.insert(doubt.otherNames.begin(), doubt.otherNames.end());
    const std::string howOften =
        doubts.size() > 1 ? " (the first of " + std::to_string(doubts.size()) + " times)" : "";
    const std::string when = "from " + formatNumber(toSeconds(doubts.front().from), 2) + " s to " +
                             formatNumber(toSeconds(doubts.front().to), 2) + " s" + howOften;
    if (others.empty())
        return when + " it is doubtful whether this is " + robotName + " or another robot of its look";
    std::string names = robotName;
    for (auto other = others.begin(); std::next(other) != others.end(); ++other)
        names += ", " + *other;
    return when + " it is doubtful whether this is " + names + " or " + *others.rbegin();
}

std::vector<std::string> stepWarnings(const std::string &trialName,
                                      const std::vector<const RecordingRecord *> &used)
{
    std::vector<std::string> sentences;
    for (const RecordingRecord *one : used) {
        const RecordingRecord &view = *one;
        if (used.size() < 2 || view.position == 0)
            continue;
        const std::string what = "view '" + view.cameraName + "' in trial '" + trialName + "': ";
        const bool found = isStepMeasured(view);
        if (!found && view.syncMethod != "told")
            sentences.push_back(what + "it is not synchronised but taken as begun together with the first "
                                       "view, so that a moving robot "
                                       "is not where the two views put it; import the videos again "
                                       "and let the offset be found, or tell it");
        else if (found && view.startOffsetSigmaS > doubtfulStepS)
            sentences.push_back(
                what + "it is in step to " + formatNumber(1e3 * view.startOffsetSigmaS, 0) +
                " ms only, which is " + formatNumber(1e3 * view.startOffsetSigmaS, 0) +
                " mm at 1 m/s; let the robot turn, or flash the room's light, where both cameras see it");
    }
    return sentences;
}

std::vector<std::string> stepWarnings(const std::string &trialName, const std::vector<RegisteredView> &views)
{
    std::vector<const RecordingRecord *> used;
    for (const RegisteredView &view : views) {
        if (view.floorView)
            used.push_back(&view.recording);
    }
    return stepWarnings(trialName, used);
}

std::optional<FloorColour> floorColourOf(const RobotRecord &robot, const std::string &trialName,
                                         const std::vector<RegisteredView> &views,
                                         const std::vector<TrackedView> &tracked, std::size_t robotIndex)
{
    if (!robot.colour)
        return std::nullopt;
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
                        "its colour " + robot.colour->toString() + " is also that of the floor (" +
                            std::to_string(std::lround(100 * share)) + " % of view " +
                            views[worst].recording.cameraName + "'s picture)",
                        "put a plate of another colour on it, or tell the colour it really has"},
                       partFound(tracked, robotIndex) < hardlyEver};
}

} // namespace odo
