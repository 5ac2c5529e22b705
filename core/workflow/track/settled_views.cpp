// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/settled_views.h"

#include "core/tracking/colour_tracker.h"
#include "core/trajectory/view_disagreement.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/internal/shadow_choice.h"

#include <algorithm>
#include <cmath>

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

Error nothingThere(const RegisteredView &view, const PointedOut &given, const RobotRecord &robot)
{
    const auto frame = static_cast<std::size_t>(given.frame);
    const double timeS = frame < view.recording.frameTimes.size()
                             ? toSeconds(clockOf(view.recording).commonTime(view.recording.frameTimes[frame]))
                             : 0;
    return {ErrorCode::InvalidInput,
            ODO_TEXT("workflow.robot_in_view", "robot '%1' in view '%2'")(
                Named::robot(robot.name), Named::camera(view.recording.cameraName)),
            ODO_TEXT("workflow.nothing_stands_out", "no foreground object was found at pixel %1,%2 at %3")(
                quantity(given.pixel.x(), 0), quantity(given.pixel.y(), 0), quantity(timeS, 2, "s")),
            ODO_TEXT("workflow.point_out_whole_robot",
                     "point it out where the whole robot is visible and moving")};
}

} // namespace

NamedRobot namedRobot(const RobotRecord &robot)
{
    return {isFoundByColour({robot.name, robot.colour}) ? robot.colour : std::nullopt,
            shapeOf(robot).heightM};
}

Result<std::vector<NameAmbiguity>> settleNames(const std::vector<RegisteredView> &views,
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
        const PointedOut &given = seen[view].pointedOut[number];
        return tl::unexpected(nothingThere(views[view], given, robots[given.robot]));
    }
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t r = 0; r < robots.size(); ++r)
            tracked[v].series[r].observations = std::move(seen[v].robots[r]);
    }
    for (std::size_t r = 0; r < robots.size(); ++r) {
        std::vector<std::vector<Observation> *> its;
        for (TrackedView &view : tracked)
            its.push_back(&view.series[r].observations);
        uncertaintyUntrimmed(its);
    }
    return std::move(outcome.ambiguities);
}

std::vector<std::vector<AmbiguousName>> ambiguousNamesOf(const std::vector<NameAmbiguity> &ambiguities,
                                                         const std::vector<RobotRecord> &robots)
{
    std::vector<std::vector<AmbiguousName>> all(robots.size());
    for (const NameAmbiguity &ambiguity : ambiguities) {
        AmbiguousName &stored = all[ambiguity.robot].emplace_back();
        stored.from = fromSeconds(ambiguity.fromS);
        stored.to = fromSeconds(ambiguity.toS);
        for (const std::size_t other : ambiguity.others) {
            stored.others.push_back(robots[other].id);
            stored.otherNames.push_back(robots[other].name);
        }
    }
    return all;
}

double ambiguousSeconds(const std::vector<AmbiguousName> &ambiguities)
{
    double seconds = 0;
    for (const AmbiguousName &ambiguity : ambiguities)
        seconds += toSeconds(ambiguity.to - ambiguity.from);
    return seconds;
}

Result<SettledViews> trackAndSettle(const std::vector<RegisteredView> &views,
                                    const std::vector<RobotRecord> &robots, const JobControl &control,
                                    const std::vector<PointedOutRobot> &pointedOut)
{
    constexpr double firstPart = 0.7, nextShare = 0.3; // of the job, and of what is left of it
    double done = 0;
    const auto tracked = [&](double part, const auto &track) -> Result<SettledViews> {
        auto seen = ODO_TRY(track(partOf(control, done, done + part)));
        done += part;
        control.report(done, ODO_TEXT("workflow.settling_names", "assigning names to the robots"));
        auto ambiguities = ODO_TRY(settleNames(views, robots, seen, pointedOut));
        return SettledViews{std::move(seen), std::move(ambiguities)};
    };
    bool inParts = false;
    auto best = tracked(firstPart, [&](const JobControl &part) {
        auto seen = trackViews(views, robots, part);
        inParts = seen && isInParts(*seen); // before the names are settled, which takes the others away
        return seen;
    });
    if (!best)
        return best;
    ShadowChoice choice(views, robots, *best, [&](const Background::Shadow &shadow) -> Result<SettledViews> {
        if (control.isCancelled())
            return cancelled(trackingSubject());
        return tracked(nextShare * (1 - done), [&](const JobControl &part) {
            return trackAgain(views, robots, best->views, shadow, part);
        });
    });
    choice.search(inParts);
    if (control.isCancelled())
        return cancelled(trackingSubject());
    choice.addUncertainty();
    return best;
}

} // namespace odo
