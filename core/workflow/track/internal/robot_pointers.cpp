// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/internal/robot_pointers.h"

#include "core/project/project.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double longestAsideS = 0.1; // between the given time and the frame meant

} // namespace

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

namespace {

Result<PointedOutRobot> resolved(const RobotPointer &pointer, const RobotRecord &robot,
                                 const std::vector<RegisteredView> &views)
{
    const Message what = ODO_TEXT("workflow.robot_pointed_out", "robot '%1' pointed out in view '%2'")(
        Named::robot(robot.name), Named::camera(pointer.view));
    const auto view = std::ranges::find_if(
        views, [&](const RegisteredView &one) { return one.recording.cameraName == pointer.view; });
    if (view == views.end())
        return fail(ErrorCode::NotFound, what,
                    ODO_TEXT("workflow.no_such_view", "the trial has no such view"),
                    ODO_TEXT("workflow.name_its_camera", "name one of its cameras"));
    const auto frame = frameAt(view->recording, pointer.timeS);
    if (!frame)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("workflow.no_picture_then", "the view has no frame at that time"),
                    ODO_TEXT("workflow.name_time_within_trial", "name a time within the trial, in seconds"));
    const auto isWithin = [](double at, int size) { return at >= 0 && at <= size - 1; };
    if (!isWithin(pointer.pixel.x(), view->recording.widthPx) ||
        !isWithin(pointer.pixel.y(), view->recording.heightPx))
        return fail(
            ErrorCode::InvalidInput, what,
            ODO_TEXT("workflow.outside_picture", "the position is outside the frame"),
            ODO_TEXT("workflow.name_place_in_pixels", "give it in pixels from the frame's top left corner"));
    return PointedOutRobot{robot.id, view->recording.id, *frame, pointer.pixel};
}

} // namespace

Result<std::vector<PointedOutRobot>> pointedOutRobots(Project &project, const TrialRecord &trial,
                                                      const std::vector<RegisteredView> &views,
                                                      const std::vector<RobotRecord> &robots,
                                                      const std::vector<RobotPointer> &pointers)
{
    auto all = ODO_TRY(project.trials().pointedOut(trial.id));
    for (const RobotPointer &pointer : pointers) {
        const auto robot = std::ranges::find(robots, pointer.robot, &RobotRecord::name);
        if (robot == robots.end())
            return fail(ErrorCode::NotFound, robotSubject(pointer.robot),
                        ODO_TEXT("workflow.not_tracked_in_trial",
                                 "it is not tracked in trial '%1'")(Named::trial(trial.name)),
                        ODO_TEXT("workflow.name_its_robot", "name one of its robots"));
        if (pointer.view.empty()) {
            std::erase_if(all, [&](const PointedOutRobot &one) { return one.robot == robot->id; });
            continue;
        }
        const auto given = ODO_TRY(resolved(pointer, *robot, views));
        std::erase_if(all, [&](const PointedOutRobot &one) {
            return one.robot == given.robot && one.recording == given.recording &&
                   (!pointer.isFurther || one.frame == given.frame);
        });
        all.push_back(given);
    }
    return all;
}

} // namespace odo
