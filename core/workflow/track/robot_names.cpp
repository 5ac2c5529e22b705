// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/robot_names.h"

#include "core/tracking/colour_tracker.h"
#include "core/trajectory/outline_doubt.h"

#include <algorithm>

namespace odo {

namespace {

std::vector<PointedOut> pointedOutIn(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                                     const std::vector<PointedOutRobot> &all)
{
    std::vector<PointedOut> here;
    for (const PointedOutRobot &one : all) {
        const auto robot = std::ranges::find(robots, one.robot, &RobotRecord::id);
        if (one.recording == view.recording.id && robot != robots.end())
            here.push_back({static_cast<std::size_t>(robot - robots.begin()), one.frame, one.pixel});
    }
    return here;
}

Error nothingThere(const RegisteredView &view, const PointedOut &told, const RobotRecord &robot)
{
    const auto frame = static_cast<std::size_t>(told.frame);
    const double timeS = frame < view.recording.frameTimes.size()
                             ? toSeconds(clockOf(view.recording).commonTime(view.recording.frameTimes[frame]))
                             : 0;
    return {ErrorCode::InvalidInput,
            ODO_TEXT("workflow.robot_in_view", "robot '%1' in view '%2'")(
                Named::robot(robot.name), Named::camera(view.recording.cameraName)),
            ODO_TEXT("workflow.nothing_stands_out",
                     "nothing stands out from the floor at %1,%2 at %3 for some frames")(
                quantity(told.pixel.x(), 0), quantity(told.pixel.y(), 0), quantity(timeS, 2, "s")),
            ODO_TEXT("workflow.point_out_whole_robot", "point it out where all of it is seen and it moves")};
}

} // namespace

NamedRobot namedRobot(const RobotRecord &robot)
{
    return {isFoundByColour({robot.name, robot.colour}) ? robot.colour : std::nullopt,
            shapeOf(robot).heightM};
}

Result<std::vector<NameDoubt>> settleNames(const std::vector<RegisteredView> &views,
                                           const std::vector<RobotRecord> &robots,
                                           std::vector<TrackedView> &tracked,
                                           const std::vector<PointedOutRobot> &pointedOut)
{
    std::vector<NamedRobot> named;
    for (const RobotRecord &robot : robots)
        named.push_back(namedRobot(robot));
    std::vector<NamedView> seen;
    for (std::size_t v = 0; v < views.size(); ++v) {
        NamedView &view = seen.emplace_back();
        view.floorView = views[v].floorView;
        view.startOffset = fromSeconds(views[v].recording.startOffsetS);
        view.clockRate = views[v].recording.clockRate;
        for (ObservationSeries &series : tracked[v].series)
            view.robots.push_back(std::move(series.observations));
        view.others = std::move(tracked[v].others);
        view.pointedOut = pointedOutIn(views[v], robots, pointedOut);
    }
    NameOutcome outcome = assignNames(seen, named);
    if (!outcome.nothingThere.empty()) {
        const auto &[view, number] = outcome.nothingThere.front();
        const PointedOut &told = seen[view].pointedOut[number];
        return tl::unexpected(nothingThere(views[view], told, robots[told.robot]));
    }
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t r = 0; r < robots.size(); ++r)
            tracked[v].series[r].observations = std::move(seen[v].robots[r]);
    }
    for (std::size_t r = 0; r < robots.size(); ++r) {
        std::vector<std::vector<Observation> *> its;
        for (TrackedView &view : tracked)
            its.push_back(&view.series[r].observations);
        doubtUntrimmed(its);
    }
    return std::move(outcome.doubts);
}

std::vector<std::vector<DoubtfulName>> doubtfulNamesOf(const std::vector<NameDoubt> &doubts,
                                                       const std::vector<RobotRecord> &robots)
{
    std::vector<std::vector<DoubtfulName>> all(robots.size());
    for (const NameDoubt &doubt : doubts) {
        DoubtfulName &stored = all[doubt.robot].emplace_back();
        stored.from = fromSeconds(doubt.fromS);
        stored.to = fromSeconds(doubt.toS);
        for (const std::size_t other : doubt.others) {
            stored.others.push_back(robots[other].id);
            stored.otherNames.push_back(robots[other].name);
        }
    }
    return all;
}

double doubtfulSeconds(const std::vector<DoubtfulName> &doubts)
{
    double seconds = 0;
    for (const DoubtfulName &doubt : doubts)
        seconds += toSeconds(doubt.to - doubt.from);
    return seconds;
}

} // namespace odo
