// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/guidance.h"

#include "core/project/project.h"
#include "core/project/project_words.h"
#include "core/project/repositories.h"
#include "core/workflow/track/internal/robot_pointers.h"

#include <algorithm>
#include <tuple>

namespace odo {

namespace {

Message guidanceOfView(const std::string &view)
{
    return ODO_TEXT("workflow.guidance_of_view", "guidance in view '%1'")(Named::camera(view));
}

/// Corners a little beyond the frame are moved onto its edge: that is where a person means them.
Result<std::vector<Eigen::Vector2d>> cornersInFrame(const GivenGuidance &given,
                                                    const RecordingRecord &recording)
{
    const Eigen::Vector2d largest(recording.widthPx - 1, recording.heightPx - 1);
    const double beside = 0.1 * largest.maxCoeff();
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector2d &corner : given.pointsPx) {
        const Eigen::Vector2d inside = corner.cwiseMax(Eigen::Vector2d::Zero()).cwiseMin(largest);
        if (!((corner - inside).norm() <= beside))
            return fail(ErrorCode::InvalidInput, guidanceOfView(given.view),
                        ODO_TEXT("workflow.corner_off_frame", "a corner is outside the frame"),
                        ODO_TEXT("workflow.name_place_in_pixels",
                                 "give it in pixels from the frame's top left corner"));
        corners.push_back(inside);
    }
    return corners;
}

/// The frames from one time to another; nullopt: none is.
std::optional<std::pair<std::int64_t, std::int64_t>> framesWithin(const RecordingRecord &recording,
                                                                  double fromS, double toS)
{
    const ViewClock clock = clockOf(recording);
    std::optional<std::pair<std::int64_t, std::int64_t>> frames;
    for (std::size_t i = 0; i < recording.frameTimes.size(); ++i) {
        const double timeS = toSeconds(clock.commonTime(recording.frameTimes[i]));
        if (timeS < fromS || timeS > toS)
            continue;
        const auto frame = static_cast<std::int64_t>(i);
        frames = {frames ? frames->first : frame, frame};
    }
    return frames;
}

tl::unexpected<Error> hasNoFrameThen(const GivenGuidance &given)
{
    return fail(ErrorCode::InvalidInput, guidanceOfView(given.view),
                ODO_TEXT("workflow.no_picture_then", "the view has no frame at that time"),
                ODO_TEXT("workflow.name_time_within_trial", "name a time within the trial, in seconds"));
}

/// robot: 0 where none is given.
Result<GuidanceItem> resolvedIn(const RecordingRecord &recording, const GivenGuidance &given, RecordId robot)
{
    GuidanceItem item;
    item.kind = given.kind;
    item.recording = recording.id;
    item.robot = robot;
    item.pointsPx = ODO_TRY(cornersInFrame(given, recording));
    if (given.kind == GuidanceItem::Kind::Point) {
        const auto frame = frameAt(recording, given.fromS);
        if (!frame)
            return hasNoFrameThen(given);
        item.fromFrame = item.toFrame = *frame;
        item.sigmaPx = given.sigmaPx;
    } else if (given.kind == GuidanceItem::Kind::Hidden) {
        const auto frames = framesWithin(recording, given.fromS, given.toS);
        if (!frames)
            return hasNoFrameThen(given);
        std::tie(item.fromFrame, item.toFrame) = *frames;
    }
    return item;
}

/// Of a robot in certain frames, not of all that is seen.
bool isByHand(GuidanceItem::Kind kind)
{
    return kind == GuidanceItem::Kind::Point || kind == GuidanceItem::Kind::Hidden;
}

Result<RecordId> robotOf(Project &project, const TrialRecord &trial, const GivenGuidance &given)
{
    if (!isByHand(given.kind) || (given.robot.empty() && given.kind == GuidanceItem::Kind::Hidden))
        return RecordId(0);
    const auto robot = ODO_TRY(project.robots().find(given.robot));
    if (std::ranges::find(trial.robots, robot.id) == trial.robots.end())
        return fail(ErrorCode::NotFound, robotSubject(given.robot),
                    ODO_TEXT("workflow.not_tracked_in_trial",
                             "it is not tracked in trial '%1'")(Named::trial(trial.name)),
                    ODO_TEXT("workflow.name_its_robot", "name one of its robots"));
    return robot.id;
}

/// In the view that is named; of Hidden without one in all views that have frames then.
Result<std::vector<GuidanceItem>> resolved(Project &project, const TrialRecord &trial,
                                           const std::vector<RecordingRecord> &recordings,
                                           const GivenGuidance &given)
{
    const auto robot = ODO_TRY(robotOf(project, trial, given));
    std::vector<GuidanceItem> items;
    if (given.view.empty() && given.kind == GuidanceItem::Kind::Hidden) {
        for (const RecordingRecord &recording : recordings)
            if (auto item = resolvedIn(recording, given, robot))
                items.push_back(std::move(*item));
        if (items.empty())
            return hasNoFrameThen(given);
        return items;
    }
    const auto recording = std::ranges::find(recordings, given.view, &RecordingRecord::cameraName);
    if (recording == recordings.end())
        return fail(ErrorCode::NotFound, guidanceOfView(given.view),
                    ODO_TEXT("workflow.no_such_view", "the trial has no such view"),
                    ODO_TEXT("workflow.name_its_camera", "name one of its cameras"));
    items.push_back(ODO_TRY(resolvedIn(*recording, given, robot)));
    return items;
}

/// A point in place of that of the same frame.
void addTo(EditedGuidance &edited, const GuidanceItem &item)
{
    const auto isReplaced = [&](const GuidanceItem &other) {
        return item.kind == GuidanceItem::Kind::Point && other.kind == item.kind &&
               other.recording == item.recording && other.robot == item.robot &&
               other.fromFrame == item.fromFrame;
    };
    for (const GuidanceItem &other : edited.all)
        if (isReplaced(other) && other.id != 0)
            edited.removed.push_back(other.id);
    std::erase_if(edited.all, isReplaced);
    edited.isByHandChanged |= isByHand(item.kind);
    edited.all.push_back(item);
}

Message guidanceWords(const std::string &trial)
{
    return ODO_TEXT("workflow.change_guidance", "change the guidance of %1")(Named::trial(trial));
}

} // namespace

Result<EditedGuidance> editedGuidance(Project &project, const TrialRecord &trial,
                                      const std::vector<RecordingRecord> &recordings,
                                      const GuidanceEdit &edit)
{
    EditedGuidance edited;
    edited.all = ODO_TRY(project.guidance().of(trial.id));
    const auto isRemoved = [&](const GuidanceItem &item) {
        return edit.clearsAll || std::ranges::find(edit.removed, item.id) != edit.removed.end();
    };
    for (const GuidanceItem &item : edited.all) {
        if (!isRemoved(item))
            continue;
        edited.removed.push_back(item.id);
        edited.isByHandChanged |= isByHand(item.kind);
    }
    std::erase_if(edited.all, isRemoved);
    for (const GivenGuidance &given : edit.added) {
        const auto items = ODO_TRY(resolved(project, trial, recordings, given));
        for (const GuidanceItem &item : items)
            addTo(edited, item);
    }
    return edited;
}

Result<void> storeGuidance(Project &project, const EditedGuidance &edited)
{
    for (const RecordId item : edited.removed)
        ODO_TRY(project.guidance().remove(item));
    for (const GuidanceItem &item : edited.all)
        if (item.id == 0)
            ODO_TRY(project.guidance().add(item));
    return {};
}

Result<void> changeGuidance(Project &project, const std::string &trial, const GuidanceEdit &edit)
{
    const auto record = ODO_TRY(project.trials().find(trial));
    const auto recordings = ODO_TRY(project.trials().recordings(record.id));
    const auto edited = ODO_TRY(editedGuidance(project, record, recordings, edit));
    return project.change(guidanceWords(record.name), [&] { return storeGuidance(project, edited); });
}

Result<bool> isGuidanceNew(Project &project, const TrialRecord &trial)
{
    const auto items = ODO_TRY(project.guidance().of(trial.id));
    const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
    for (const RecordingRecord &recording : recordings) {
        const std::string note = noteOf(searchedAreaOf(items, recording.id));
        for (const RecordId robot : trial.robots) {
            const auto algorithm = ODO_TRY(project.trials().currentAlgorithm(recording.id, robot));
            if (algorithm && areaNoteIn(*algorithm) != note)
                return true;
        }
    }
    return false;
}

bool haveFrames(const std::vector<GuidanceItem> &items)
{
    return std::ranges::any_of(items, isByHand, &GuidanceItem::kind);
}

std::optional<ObservationSeries> correctedByHand(const ObservationSeries &tracked,
                                                 const std::vector<GuidanceItem> &items)
{
    ObservationSeries corrected = tracked;
    std::size_t points = 0, hidden = 0;
    for (const GuidanceItem &item : items) {
        if (!isByHand(item.kind) || item.recording != tracked.recording ||
            (item.robot != 0 && item.robot != tracked.robot))
            continue;
        auto one = std::ranges::lower_bound(corrected.observations, item.fromFrame, {}, &Observation::frame);
        for (; one != corrected.observations.end() && one->frame <= item.toFrame; ++one) {
            Observation instead;
            instead.frame = one->frame;
            instead.time = one->time;
            if (item.kind == GuidanceItem::Kind::Point) {
                const double sigma = item.sigmaPx;
                instead.found = instead.isByHand = true;
                instead.score = 1;
                instead.ellipse = {item.pointsPx.front(), sigma, sigma, 0};
                instead.centreCovariancePx2 = Eigen::Matrix2d::Identity() * sigma * sigma;
            }
            *one = instead;
            ++(instead.found ? points : hidden);
        }
    }
    if (points + hidden == 0)
        return std::nullopt;
    corrected.algorithm +=
        handNote + std::to_string(points) + " points, " + std::to_string(hidden) + " frames not visible";
    return corrected;
}

std::vector<ManualOverride> withPointsByHand(std::vector<ManualOverride> overrides,
                                             const std::vector<ViewTrack> &views)
{
    const auto timeInFirst = [&](const Observation &one) { return timeOf(views.front(), one); };
    const std::vector<Observation> &first = views.front().observations;
    for (const ViewTrack &view : views) {
        for (const Observation &point : view.observations) {
            if (!point.isByHand || first.empty())
                continue;
            const Nanoseconds time = timeOf(view, point);
            auto sample = std::ranges::lower_bound(first, time, {}, timeInFirst);
            if (sample == first.end() ||
                (sample != first.begin() && time - timeInFirst(*(sample - 1)) < timeInFirst(*sample) - time))
                --sample;
            if (std::ranges::find(overrides, sample->frame, &ManualOverride::frame) == overrides.end())
                overrides = withOverride(std::move(overrides), {sample->frame, false});
        }
    }
    return overrides;
}

std::vector<PointedOutRobot> marksOf(const std::vector<PointedOutRobot> &all, RecordId recording)
{
    std::vector<PointedOutRobot> own;
    std::ranges::copy_if(all, std::back_inserter(own),
                         [recording](const PointedOutRobot &mark) { return mark.recording == recording; });
    return own;
}

SearchedArea searchedAreaOf(const std::vector<GuidanceItem> &items, RecordId recording)
{
    SearchedArea area;
    for (const GuidanceItem &item : items) {
        if (item.recording != recording)
            continue;
        if (item.kind == GuidanceItem::Kind::Search)
            area.search.push_back(item.pointsPx);
        else if (item.kind == GuidanceItem::Kind::Ignore)
            area.ignored.push_back(item.pointsPx);
    }
    return area;
}

} // namespace odo
