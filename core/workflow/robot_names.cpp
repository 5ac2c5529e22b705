// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/robot_names.h"

namespace odo {

std::vector<NameDoubt> settleNames(const std::vector<RegisteredView> &views, const std::vector<RobotRecord> &robots,
                 std::vector<TrackedView> &tracked)
{
    if (robots.size() < 2)
        return {};
    std::vector<NamedRobot> named;
    for (const RobotRecord &robot : robots)
        named.push_back({robot.colour, shapeOf(robot).heightM});
    std::vector<NamedView> seen;
    for (std::size_t v = 0; v < views.size(); ++v) {
        NamedView &view = seen.emplace_back();
        view.floorView = views[v].floorView;
        view.startOffset = fromSeconds(views[v].recording.startOffsetS);
        view.clockRate = views[v].recording.clockRate;
        for (ObservationSeries &series : tracked[v].series)
            view.robots.push_back(std::move(series.observations));
    }
    NameOutcome outcome = assignNames(seen, named);
    for (std::size_t v = 0; v < views.size(); ++v) {
        for (std::size_t r = 0; r < robots.size(); ++r)
            tracked[v].series[r].observations = std::move(seen[v].robots[r]);
    }
    return std::move(outcome.doubts);
}

std::vector<std::vector<DoubtfulName>> doubtfulNamesOf(const std::vector<NameDoubt> &doubts, const std::vector<RobotRecord> &robots)
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
