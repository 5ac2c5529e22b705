// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/clip_offset.h"

#include "core/workflow/view_tracking.h"

namespace odo {

namespace {

constexpr double longestOffsetS = 10;
constexpr double sureScore = 0.5; // of an observation; doubtful ones only blur the answer

std::vector<TimedPosition> floorTrack(const FloorView &view, const ObservationSeries &series, double heightM)
{
    std::vector<TimedPosition> track;
    for (const Observation &observation : series.observations) {
        if (!observation.found || observation.score < sureScore || observation.touchesBorder)
            continue;
        if (const auto point = view.floorFromPixel(observation.ellipse.centrePx, heightM / 2))
            track.push_back({toSeconds(observation.time), *point});
    }
    return track;
}

} // namespace

Result<ClipOffset> clipOffsetFromMotion(const RegisteredView &first, const RegisteredView &second,
                                        const std::vector<RobotRecord> &robots, const JobControl &control)
{
    const auto impossible = [](const std::string &why, const std::string &advice) {
        return fail(ErrorCode::Undetermined, "synchronisation of the clips", why, advice);
    };
    for (const RegisteredView *view : {&first, &second}) {
        if (!view->floorView)
            return impossible("camera '" + view->recording.cameraName + "' is not registered to the floor",
                              "register it first, or give the offset with --sync SECONDS");
    }
    if (robots.empty())
        return impossible("the project has no robot to look for", "add the robot first, or give --sync SECONDS");

    const auto tracked = trackViews({first, second}, robots, control);
    if (!tracked)
        return tl::unexpected(tracked.error());
    Result<ClipOffset> best = impossible("no robot was seen", "check the robots' colours, or give --sync SECONDS");
    for (std::size_t r = 0; r < robots.size(); ++r) {
        const double heightM = robots[r].heightM.value_or(0);
        const auto offset = estimateClipOffset(floorTrack(*first.floorView, (*tracked)[0].series[r], heightM),
                                               floorTrack(*second.floorView, (*tracked)[1].series[r], heightM),
                                               longestOffsetS);
        if (!best || (offset && offset->sigmaS < best->sigmaS)) {
            if (offset || !best)
                best = offset;
        }
    }
    return best;
}

} // namespace odo
