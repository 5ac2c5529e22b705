// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/internal/clip_offsets.h"

#include "core/project/project.h"
#include "core/project/project_words.h"
#include "core/project/repositories.h"
#include "core/video/sound_track.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/frame_steps.h"
#include "core/workflow/track/registered_scene.h"
#include "core/workflow/track/settled_views.h"
#include "core/workflow/track/view_tracking.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace odo {

namespace {

constexpr double longestOffsetS = 10; ///< by the motion

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
        // the views' time offsets are not known yet: each decides alone which moving things are the robots
        std::vector<NamedView> alone(1);
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

Message whyNoTracks(const RegisteredView &view, const std::vector<RobotRecord> &robots)
{
    if (!view.floorView)
        return ODO_TEXT("workflow.camera_not_on_floor", "camera '%1' is not registered to the floor")(
            Named::camera(view.recording.cameraName));
    return robots.empty() ? noRobotToTrack() : Message();
}

bool isAsked(const ClipOffsetSearch &search, OffsetSource source)
{
    return std::ranges::any_of(search.sources, [source](OffsetSource allowed) {
        return allowed == OffsetSource::Any || allowed == source;
    });
}

/// What the views' frames tell: tracks and light; and what was wrong with the times of the frames.
Result<void> readFrames(std::vector<RegisteredView> &views, const ClipOffsetSearch &search,
                        const JobControl &control, std::vector<ClipEvidence> &evidence,
                        std::vector<Message> &frameSteps)
{
    const auto registered =
        std::ranges::count_if(views, [](const RegisteredView &view) { return view.floorView.has_value(); });
    const bool canTrack = isAsked(search, OffsetSource::Motion) && views.front().floorView &&
                          registered > 1 && !search.robots.empty();
    auto tracked = ODO_TRY(trackViews(views, canTrack ? search.robots : std::vector<RobotRecord>{}, control,
                                      WithLight::Measured));
    if (canTrack) {
        std::vector<std::size_t> byFields;
        if (search.mayTakeFields)
            byFields = takeFields(views, tracked, control.cancel);
        if (!byFields.empty())
            tracked = ODO_TRY(trackViews(views, search.robots, control, WithLight::Measured));
        for (std::size_t v = 0; v < views.size(); ++v)
            if (tracked[v].interlace == Interlace::Fields && std::ranges::find(byFields, v) == byFields.end())
                tracked[v].interlace = Interlace::None; // said already
        correctFrameTimes(views, search.robots, tracked);
        frameSteps = frameStepWarnings(search.trial, views, tracked);
        auto tracks = tracksOf(views, search.robots, tracked);
        for (std::size_t v = 0; v < views.size(); ++v)
            evidence[v].tracks = std::move(tracks[v]);
    }
    for (std::size_t v = 0; v < views.size(); ++v) {
        evidence[v].whyNoTracks = whyNoTracks(views[v], search.robots);
        evidence[v].light = lightCourseOf(tracked[v].light);
    }
    return {};
}

Message whyNoSound(const RegisteredView &view, const Error &error)
{
    const MessageArgument camera = Named::camera(view.recording.cameraName);
    if (error.code == ErrorCode::NotFound)
        return ODO_TEXT("workflow.view_without_sound", "view '%1' has no sound")(camera);
    return ODO_TEXT("workflow.sound_unreadable", "the sound of view '%1' cannot be read (%2)")(camera,
                                                                                               error.why);
}

/// The sound of the first view, and of those that are to be found by it.
Result<void> readSounds(const std::vector<RegisteredView> &views, const ClipOffsetSearch &search,
                        const JobControl &control, std::vector<ClipEvidence> &evidence)
{
    for (std::size_t v = 0; v < views.size(); ++v) {
        evidence[v].microphone = search.microphones[v];
        if (search.isSlowMotion) {
            evidence[v].whyNoSound = ODO_TEXT("workflow.sound_of_slow_motion",
                                              "sound cannot be compared in clips that play in slow motion");
            continue;
        }
        auto track = readSound(views[v].file, control.cancel);
        if (!track && track.error().code == ErrorCode::Cancelled)
            return tl::unexpected(track.error());
        if (track)
            evidence[v].sound = std::make_shared<SoundCourse>(soundCourseOf(std::move(*track)));
        else
            evidence[v].whyNoSound = whyNoSound(views[v], track.error());
    }
    return {};
}

/// Once a view shows that the first one's stamps are uneven, all are compared with the repaired ones.
FoundClocks clocksFrom(std::vector<ClipEvidence> evidence, const std::vector<OffsetSource> &sources)
{
    FoundClocks found;
    for (std::size_t v = 1; v < evidence.size(); ++v) {
        auto offset = findClipOffset(evidence.front(), evidence[v], {0, longestOffsetS}, sources[v - 1]);
        if (offset && !offset->clock.first.steps.empty() && !found.first) {
            found.first = offset->clock.first;
            for (MotionTrack &track : evidence.front().tracks)
                for (TimedPosition &position : track.positions)
                    position.timeS = found.first->timeS(position.timeS);
            found.views.clear();
            v = 0;
            continue;
        }
        found.views.push_back(std::move(offset));
    }
    return found;
}

} // namespace

Result<std::optional<MicrophonePosition>> microphonePositionOf(Project &project, const RegisteredView &view)
{
    if (!view.floorView || !view.registration)
        return std::nullopt;
    const LayoutRecord layout = ODO_TRY(project.layouts().get(view.registration->layout));
    Eigen::AlignedBox2d floor;
    for (const Marker &marker : layout.layout.markers)
        floor.extend(marker.pointInWorld);
    if (floor.isEmpty())
        return std::nullopt;
    return MicrophonePosition{view.floorView->cameraInWorld(), floor.center(), floor.diagonal().norm() / 2};
}

Result<FoundClocks> findClipOffsets(std::vector<RegisteredView> &views, const ClipOffsetSearch &search,
                                    const JobControl &control)
{
    std::vector<ClipEvidence> evidence(views.size());
    std::vector<Message> frameSteps;
    if (isAsked(search, OffsetSource::Motion) || isAsked(search, OffsetSource::Flash))
        ODO_TRY(readFrames(views, search, control, evidence, frameSteps));
    if (isAsked(search, OffsetSource::Sound))
        ODO_TRY(readSounds(views, search, control, evidence));
    FoundClocks found = clocksFrom(std::move(evidence), search.sources);
    found.frameSteps = std::move(frameSteps);
    return found;
}

} // namespace odo
