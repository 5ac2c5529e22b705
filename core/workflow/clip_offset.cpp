// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/clip_offset.h"

#include "core/workflow/robot_names.h"

#include <algorithm>

namespace odo {

namespace {

constexpr double longestOffsetS = 10;

std::vector<std::vector<MotionTrack>> tracksOf(const std::vector<RegisteredView> &views,
                                               const std::vector<RobotRecord> &robots,
                                               const std::vector<TrackedView> &tracked)
{
    std::vector<NamedRobot> named;
    std::vector<std::string> names;
    for (const RobotRecord &robot : robots) {
        named.push_back(namedRobot(robot));
        names.push_back(robot.name);
    }
    std::vector<NamedView> seen;
    for (std::size_t v = 0; v < views.size(); ++v) {
        std::vector<NamedView> alone(1); // how the views' clocks lie is not known yet: each decides by itself which of what moves the robots are
        alone.front().floorView = views[v].floorView;
        for (const ObservationSeries &series : tracked[v].series)
            alone.front().robots.push_back(series.observations);
        alone.front().others = tracked[v].others;
        if (!tracked[v].others.empty())
            assignNames(alone, named);
        seen.push_back(std::move(alone.front()));
    }
    return motionTracks(seen, named, names);
}

std::string whyNoTracks(const RegisteredView &view, const std::vector<RobotRecord> &robots)
{
    if (!view.floorView)
        return "camera '" + view.recording.cameraName + "' is not registered to the floor";
    return robots.empty() ? "the project has no robot to look for" : std::string();
}

} // namespace

Result<std::vector<Result<FoundOffset>>> findClipOffsets(const std::vector<RegisteredView> &views,
                                                         const std::vector<RobotRecord> &robots,
                                                         const JobControl &control)
{
    const auto registered =
        std::count_if(views.begin(), views.end(), [](const RegisteredView &view) { return view.floorView; });
    const bool canTrack = views.front().floorView && registered > 1 && !robots.empty();
    const auto tracked =
        trackViews(views, canTrack ? robots : std::vector<RobotRecord>{}, control, WithLight::Measured);
    if (!tracked)
        return tl::unexpected(tracked.error());
    std::vector<std::vector<MotionTrack>> tracks(views.size());
    if (canTrack)
        tracks = tracksOf(views, robots, *tracked);
    std::vector<ClipEvidence> evidence;
    for (std::size_t v = 0; v < views.size(); ++v)
        evidence.push_back(
            {std::move(tracks[v]), whyNoTracks(views[v], robots), lightCourseOf((*tracked)[v].light)});

    std::vector<Result<FoundOffset>> found;
    for (std::size_t v = 1; v < views.size(); ++v)
        found.push_back(findClipOffset(evidence.front(), evidence[v], {0, longestOffsetS}));
    return found;
}

} // namespace odo
