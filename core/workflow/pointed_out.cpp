// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/pointed_out.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/tracking/colour_tracker.h"

#include <algorithm>

namespace odo {

namespace {

constexpr double longestAsideS = 0.1; // between the time told and the picture meant

/// The recording's frame that is nearest to a time of the trial.
std::optional<std::int64_t> frameAt(const RecordingRecord &recording, double timeS)
{
    const std::vector<Nanoseconds> &times = recording.frameTimes;
    const ViewClock clock = clockOf(recording);
    const auto asideS = [&](Nanoseconds own) { return std::abs(toSeconds(clock.commonTime(own)) - timeS); };
    const auto nearest = std::ranges::min_element(times, {}, asideS);
    if (nearest == times.end() || !(asideS(*nearest) <= longestAsideS))
        return std::nullopt;
    return nearest - times.begin();
}

Result<PointedOutRobot> resolved(const RobotPointer &pointer, const RobotRecord &robot, const std::vector<RegisteredView> &views)
{
    const std::string what = "robot '" + robot.name + "' pointed out in view '" + pointer.view + "'";
    if (isFoundByColour({robot.name, robot.colour}))
        return fail(ErrorCode::InvalidInput, what, "it is found by its colour", "pick its colour again, or take the colour from it");
    const auto view = std::ranges::find_if(views, [&](const RegisteredView &one) { return one.recording.cameraName == pointer.view; });
    if (view == views.end())
        return fail(ErrorCode::NotFound, what, "the trial has no such view", "name one of its cameras");
    const auto frame = frameAt(view->recording, pointer.timeS);
    if (!frame)
        return fail(ErrorCode::InvalidInput, what, "the view has no picture at that time", "name a time within the trial, in seconds");
    const auto isWithin = [](double at, int size) { return at >= 0 && at <= size - 1; };
    if (!isWithin(pointer.pixel.x(), view->recording.widthPx) || !isWithin(pointer.pixel.y(), view->recording.heightPx))
        return fail(ErrorCode::InvalidInput, what, "the place lies outside the picture", "name it in pixels from the picture's top left corner");
    return PointedOutRobot{robot.id, view->recording.id, *frame, pointer.pixel};
}

} // namespace

Result<std::vector<PointedOutRobot>> pointedOutRobots(Project &project, const TrialRecord &trial, const std::vector<RegisteredView> &views,
                                                      const std::vector<RobotRecord> &robots, const std::vector<RobotPointer> &pointers)
{
    auto all = project.trials().pointedOut(trial.id);
    if (!all)
        return all;
    for (const RobotPointer &pointer : pointers) {
        const auto robot = std::ranges::find(robots, pointer.robot, &RobotRecord::name);
        if (robot == robots.end())
            return fail(ErrorCode::NotFound, "robot '" + pointer.robot + "'", "it is not tracked in trial '" + trial.name + "'", "name one of its robots");
        if (pointer.view.empty()) {
            std::erase_if(*all, [&](const PointedOutRobot &one) { return one.robot == robot->id; });
            continue;
        }
        const auto told = resolved(pointer, *robot, views);
        if (!told)
            return tl::unexpected(told.error());
        std::erase_if(*all, [&](const PointedOutRobot &one) { return one.robot == told->robot && one.recording == told->recording; });
        all->push_back(*told);
    }
    return all;
}

} // namespace odo
