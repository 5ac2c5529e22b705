// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/view_tracking.h"

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/shortage.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/tracking/background.h"
#include "core/tracking/robot_tracker.h"
#include "core/trajectory/solid_choice.h"
#include "core/video/frame_stream.h"
#include "core/video/planes/field_motion.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/frame_damage.h"
#include "core/workflow/track/frame_steps.h"
#include "core/workflow/track/internal/seeded_tracking.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <mutex>
#include <optional>

namespace odo {

namespace {

constexpr double wantedPerSecond = 10; // frames that are searched
constexpr std::size_t learnedAhead = 4;

} // namespace

/// The background of a recording, from some ten frames a second of all of it. nullopt: it has no frame.
/// onImage: after each frame. Errors: a recording that is missing or is no video; cancelled.
Result<std::optional<Background>> learnBackground(const RegisteredView &view, const CancelToken &cancel,
                                                  const std::function<void()> &onImage)
{
    auto stream = ODO_TRY(FrameStream::open(view.file, learnedAhead, cancel, knownRecording(view.recording)));
    const std::int64_t step =
        std::max<std::int64_t>(1, std::llround(stream->info().framesPerSecond / wantedPerSecond));
    BackgroundLearner learner;
    while (true) {
        if (cancel.isCancelled())
            return cancelled(trackingSubject());
        auto frame = ODO_TRY(stream->pop());
        if (!frame)
            return learner.learned();
        if (frame->index % step == 0)
            learner.add(*frame);
        onImage();
    }
}

namespace {

// of what found the robot
constexpr const char *colourVersion = "colour-ellipse 1", *silhouetteVersion = "silhouette 1";
constexpr std::size_t framesAhead = 8;
constexpr std::size_t othersFollowed = 5; // that may be robots of any look

/// Counts the frames of all views and reports now and then; any thread.
class SharedProgress
{
public:
    /// from, to: the part of the job that its frames are.
    SharedProgress(const JobControl &control, std::int64_t total, double from, double to)
        : m_control(control), m_total(std::max<std::int64_t>(total, 1)), m_from(from), m_to(to)
    {
    }

    void countFrame()
    {
        const std::int64_t done = ++m_done;
        if (done % 20 != 0)
            return;
        const std::lock_guard lock(m_mutex); // the caller's function need not be thread-safe
        m_control.report(m_from + (m_to - m_from) * double(done) / double(m_total),
                         ODO_TEXT("workflow.tracking_picture", "tracking, frame %1 of %2")(done, m_total));
    }

private:
    const JobControl &m_control;
    const std::int64_t m_total;
    const double m_from, m_to;
    std::atomic<std::int64_t> m_done{0};
    std::mutex m_mutex;
};

std::vector<TrackTarget> targetsOf(const std::vector<RobotRecord> &robots)
{
    std::vector<TrackTarget> targets;
    for (const RobotRecord &robot : robots)
        targets.push_back({robot.name, robot.colour});
    return targets;
}

/// None without a robot. background: learned where it is needed and not known.
Result<std::unique_ptr<RobotTracker>> trackerFor(const RegisteredView &view,
                                                 const std::vector<TrackTarget> &targets,
                                                 const JobControl &control, SharedProgress &progress,
                                                 std::optional<Background> &background)
{
    if (targets.empty())
        return nullptr;
    if (needsBackground(targets) && !background) {
        auto learned = learnBackground(view, control.cancel, [&progress] { progress.countFrame(); });
        if (!learned)
            return tl::unexpected(learned.error());
        background = std::move(*learned);
    }
    return RobotTracker::create(targets, background, view.floorView, othersFollowed, view.area);
}

/// Behind the tracker's version in a series.
constexpr const char *movedWords = "; camera moved";

/// Leaves out what a camera saw after it was moved: where that is on the floor is not known.
void leaveOutMoved(TrackedView &tracked, const std::optional<CameraMove> &move)
{
    if (!move)
        return;
    tracked.cameraMove = move;
    const auto leaveOut = [&](std::vector<Observation> &observations) {
        for (Observation &one : observations)
            one.found = one.found && one.time <= move->time;
    };
    for (ObservationSeries &series : tracked.series) {
        leaveOut(series.observations);
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), "%s %.2f px after %lld ns", movedWords, move->shiftPx,
                      static_cast<long long>(move->time.count()));
        series.algorithm += text.data();
    }
    for (std::vector<Observation> &observations : tracked.others)
        leaveOut(observations);
}

/// About the robot that moved most since the frame before; empty where none is seen in both.
PixelRect fastestIn(const std::vector<ObservationSeries> &before, const std::vector<Observation> &seen)
{
    constexpr double around = 2; // semi-axes
    PixelRect region;
    double most = 0;
    for (std::size_t r = 0; r < seen.size(); ++r) {
        if (before[r].observations.empty() || !before[r].observations.back().found || !seen[r].found)
            continue;
        const Eigen::Vector2d &centre = seen[r].ellipse.centrePx;
        const double movedPx = (centre - before[r].observations.back().ellipse.centrePx).norm(),
                     reach = movedPx + around * seen[r].ellipse.semiMajorPx;
        if (movedPx > most) {
            most = movedPx;
            region = {int(centre.x() - reach), int(centre.y() - reach), int(centre.x() + reach),
                      int(centre.y() + reach)};
        }
    }
    return region;
}

Interlace interlaceOf(const VideoInfo &info, const FieldMotion &fields)
{
    if (info.areFields)
        return Interlace::Fields;
    const FieldMotion::Kind kind = fields.kind();
    return kind == FieldMotion::Kind::TopFirst || kind == FieldMotion::Kind::BottomFirst ? Interlace::Whole
                                                                                         : Interlace::None;
}

Result<TrackedView> trackView(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                              const std::vector<TrackTarget> &targets, const JobControl &control,
                              SharedProgress &progress, WithLight light, std::optional<Background> background)
{
    const auto tracker = ODO_TRY(trackerFor(view, targets, control, progress, background));
    auto reader = ODO_TRY(VideoReader::open(view.file, control.cancel, knownRecording(view.recording)));
    // Decoding only what the tracker will look at is so much cheaper that a thread that decodes ahead, and
    // cannot know it, would be slower.
    const bool byRegion = tracker && reader->decodesRegions();
    FrameStream stream(std::move(reader), byRegion ? 0 : framesAhead);

    TrackedView tracked;
    tracked.fileTimes = stream.info().frameTimes;
    tracked.background = std::move(background);
    LightMeter lightMeter;
    CameraWatch watch;
    FieldMotion fields;
    for (std::size_t r = 0; r < robots.size(); ++r)
        tracked.series.push_back(
            {view.recording.id,
             robots[r].id,
             (needsBackground({targets[r]}) ? silhouetteVersion : colourVersion) + noteOf(view.area),
             {}});
    const std::vector<Nanoseconds> &times = view.recording.frameTimes;
    for (ObservationSeries &series : tracked.series)
        series.observations.reserve(times.size());
    std::size_t next = 0;
    for (;;) {
        if (control.isCancelled())
            return cancelled(trackingSubject());
        auto frame = ODO_TRY(
            stream.pop(byRegion && next < times.size() ? tracker->neededRegion(times[next]) : std::nullopt));
        if (!frame)
            break;
        // The times kept in the project are the truth, whatever becomes of the file.
        const auto index = static_cast<std::size_t>(frame->index);
        if (index < times.size())
            frame->time = times[index];
        next = index + 1;
        if (light == WithLight::Measured)
            tracked.light.push_back(lightMeter.measure(*frame));
        if (tracker)
            watch.add(*frame);
        const std::vector<Observation> observations =
            tracker ? tracker->track(*frame, seedsIn(view, robots, frame->index))
                    : std::vector<Observation>{};
        if (!stream.info().areFields && !fields.isClear())
            fields.add(*frame, fastestIn(tracked.series, observations));
        for (std::size_t r = 0; r < observations.size(); ++r)
            tracked.series[r].observations.push_back(observations[r]);
        const std::vector<Observation> none, &others = tracker ? tracker->others() : none;
        tracked.others.resize(others.size());
        for (std::size_t i = 0; i < others.size(); ++i)
            tracked.others[i].push_back(others[i]);
        ++tracked.frames;
        progress.countFrame();
    }
    tracked.decodeCpuTime = stream.decodeCpuTime();
    tracked.interlace = interlaceOf(stream.info(), fields);
    if (tracker)
        ODO_TRY(followBackwards(view, robots, targets, tracked, control.cancel));
    leaveOutMoved(tracked, watch.move());
    if (tracker)
        tracked.sharesAlike = tracker->sharesAlike();
    return tracked;
}

/// The part of a job in which everything is tracked, and that in which it is done once more where that is
/// needed.
struct JobPart
{
    double from = 0, to = 0;
};
constexpr JobPart firstPass{0, 0.6}, secondPass{0.6, 0.95}, onlyPass{0, 1};

Result<std::vector<TrackedView>> trackTargets(const std::vector<RegisteredView> &views,
                                              const std::vector<RobotRecord> &robots,
                                              const std::vector<TrackTarget> &targets,
                                              const JobControl &control, const JobPart &part, WithLight light,
                                              std::vector<std::optional<Background>> backgrounds = {})
{
    backgrounds.resize(views.size());
    std::int64_t total = 0;
    for (const RegisteredView &view : views)
        total += static_cast<std::int64_t>(view.recording.frameTimes.size());
    // for which everything is read twice
    if (needsBackground(targets) &&
        std::ranges::any_of(backgrounds, [](const auto &known) { return !known; }))
        total *= 2;
    SharedProgress progress(control, total, part.from, part.to);

    std::vector<Result<TrackedView>> results(views.size(), TrackedView{});
    sideBySide(views.size(), [&](std::size_t v) {
        results[v] =
            trackView(views[v], robots, targets, control, progress, light, std::move(backgrounds[v]));
    });

    std::vector<TrackedView> tracked;
    for (auto &result : results) {
        if (!result)
            return tl::unexpected(result.error());
        tracked.push_back(std::move(*result));
    }
    return tracked;
}

/// Whether a robot was measured by its silhouette, not by its colour.
bool isBySilhouette(const std::vector<TrackedView> &tracked, std::size_t robot)
{
    return std::ranges::any_of(tracked, [robot](const TrackedView &view) {
        return std::ranges::any_of(view.series[robot].observations,
                                   [](const Observation &one) { return !one.supportPx.empty(); });
    });
}

double explainedShareOf(const std::vector<RegisteredView> &views, std::vector<TrackedView> &tracked,
                        const RobotRecord &robot, std::size_t number)
{
    std::vector<ViewTrack> tracks = takeViewTracks(views, tracked, number);
    const double share = explainedShare(tracks, shapeOf(robot));
    returnObservations(std::move(tracks), tracked, number);
    return share;
}

} // namespace

Result<std::vector<TrackedView>> trackViews(const std::vector<RegisteredView> &views,
                                            const std::vector<RobotRecord> &robots, const JobControl &control,
                                            WithLight light)
{
    constexpr double mostlyExplained = 0.95, clearlyMore = 0.03, farMore = 0.3;
    std::vector<TrackTarget> targets = targetsOf(robots);
    auto tracked = trackTargets(views, robots, targets, control, firstPass, light);
    std::vector<std::pair<std::size_t, double>> partly; // robots, and how much is explained of them
    for (std::size_t r = 0; tracked && r < robots.size(); ++r) {
        if (!isFoundByColour(targets[r]) || robots[r].heightMode == RobotRecord::Height::Free ||
            !isEverSeen(views, *tracked, r))
            continue;
        if (floorColourOf(robots[r], {}, views, *tracked, r)) // so it distinguishes nothing
            continue;
        const double share = explainedShareOf(views, *tracked, robots[r], r);
        if (share >= mostlyExplained)
            continue;
        targets[r].wholeOutline = true;
        partly.emplace_back(r, share);
    }
    if (partly.empty())
        return tracked;
    auto whole = ODO_TRY(trackTargets(views, robots, targets, control, secondPass, WithLight::Ignored));
    for (std::size_t v = 0; v < views.size(); ++v)
        (*tracked)[v].background = std::move(whole[v].background);
    for (const auto &[r, share] : partly) {
        // Where a board hides the robot for a while neither is explained, and its whole outline is hidden
        // more often.
        const double explained = explainedShareOf(views, whole, robots[r], r);
        if (explained < share + (explained >= mostlyExplained ? clearlyMore : farMore))
            continue;
        for (std::size_t v = 0; v < views.size(); ++v)
            (*tracked)[v].series[r] = std::move(whole[v].series[r]);
    }
    return tracked;
}

std::vector<std::size_t> takeFields(std::vector<RegisteredView> &views,
                                    const std::vector<TrackedView> &tracked, const CancelToken &cancel)
{
    std::vector<std::size_t> taken;
    for (std::size_t v = 0; v < views.size(); ++v) {
        RecordingRecord &recording = views[v].recording;
        if (tracked[v].interlace != Interlace::Whole)
            continue;
        KnownRecording byFields = knownRecording(recording);
        byFields.frames *= 2;
        const auto reader = VideoReader::open(views[v].file, cancel, byFields);
        if (!reader || (*reader)->info().frameTimes.size() != byFields.frames)
            continue;
        recording.frameTimes = fieldTimes(recording.frameTimes);
        taken.push_back(v);
    }
    return taken;
}

Result<std::vector<TrackedView>> trackAgain(const std::vector<RegisteredView> &views,
                                            const std::vector<RobotRecord> &robots,
                                            const std::vector<TrackedView> &before,
                                            const Background::Shadow &shadow, const JobControl &control)
{
    std::vector<TrackTarget> targets = targetsOf(robots);
    for (std::size_t r = 0; r < robots.size(); ++r)
        targets[r].wholeOutline = isBySilhouette(before, r);
    std::vector<std::optional<Background>> backgrounds;
    for (const TrackedView &view : before) {
        backgrounds.push_back(view.background);
        if (backgrounds.back())
            backgrounds.back()->shadow = shadow;
    }
    auto again =
        trackTargets(views, robots, targets, control, onlyPass, WithLight::Ignored, std::move(backgrounds));
    for (std::size_t v = 0; again && v < views.size(); ++v) {
        (*again)[v].light = before[v].light;
        for (std::size_t r = 0; r < robots.size(); ++r)
            if (isFoundByColour(targets[r]) && !targets[r].wholeOutline)
                (*again)[v].series[r] = before[v].series[r];
    }
    return again;
}

bool isEverSeen(const std::vector<RegisteredView> &views, const std::vector<TrackedView> &tracked,
                std::size_t robot)
{
    for (std::size_t v = 0; v < views.size(); ++v) {
        const auto &observations = tracked[v].series[robot].observations;
        if (views[v].floorView && std::ranges::any_of(observations, &Observation::found))
            return true;
    }
    return false;
}

std::optional<CameraMove> storedMove(const ObservationSeries &series)
{
    const std::size_t at = series.algorithm.find(movedWords);
    double shiftPx = 0;
    long long time = 0;
    if (at == std::string::npos || std::sscanf(series.algorithm.c_str() + at + std::strlen(movedWords),
                                               " %lf px after %lld ns", &shiftPx, &time) != 2)
        return std::nullopt;
    return CameraMove{Nanoseconds(time), shiftPx};
}

std::vector<ViewTrack> takeViewTracks(const std::vector<RegisteredView> &views,
                                      std::vector<TrackedView> &tracked, std::size_t robot)
{
    std::vector<ViewTrack> tracks;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const RecordingRecord &recording = views[v].recording;
        std::vector<Observation> observations = std::move(tracked[v].series[robot].observations);
        insertDamaged(observations, recording.frameTimes);
        tracks.push_back({recording.cameraName, views[v].floorView, fromSeconds(recording.startOffsetS),
                          std::move(observations), recording.clockRate, recording.startOffsetSigmaS,
                          leapTimes(tracked[v].series[robot], recording.frameTimes)});
    }
    return tracks;
}

void returnObservations(std::vector<ViewTrack> tracks, std::vector<TrackedView> &tracked, std::size_t robot)
{
    for (std::size_t v = 0; v < tracks.size(); ++v) {
        removeDamaged(tracks[v].observations);
        tracked[v].series[robot].observations = std::move(tracks[v].observations);
    }
}

RobotShape shapeOf(const RobotRecord &robot)
{
    RobotShape shape;
    if (robot.heightMode == RobotRecord::Height::Given)
        shape.heightM = robot.heightM;
    shape.heightVaries = robot.heightMode == RobotRecord::Height::Free;
    shape.lengthM = robot.lengthM;
    shape.widthM = robot.widthM;
    shape.referenceM = robot.referenceM;
    return shape;
}

AnalysisRecord newAnalysis(const TrialRecord &trial, const RobotRecord &robot,
                           const std::vector<RegisteredView> &views, AnalysisOptions options)
{
    AnalysisRecord analysis;
    analysis.trial = trial.id;
    analysis.robot = robot.id;
    analysis.robotName = robot.name;
    analysis.made = instantNow();
    analysis.softwareVersion = ODOGRAPH_VERSION;
    analysis.options = std::move(options);
    for (const RegisteredView &view : views) {
        analysis.registrations.push_back(view.registration ? view.registration->id : 0);
        analysis.views.push_back(view.recording.cameraName);
    }
    return analysis;
}

void stampAsRecorded(std::vector<Observation> &observations, const std::vector<Nanoseconds> &frameTimes)
{
    for (Observation &seen : observations)
        if (const auto frame = static_cast<std::size_t>(seen.frame); frame < frameTimes.size())
            seen.time = frameTimes[frame];
}

Result<std::vector<TrackedView>> storedObservations(Project &project, const std::string &trialName,
                                                    const std::vector<RegisteredView> &views,
                                                    const std::vector<RobotRecord> &robots, StoredAs which)
{
    std::vector<TrackedView> stored(views.size());
    for (const RobotRecord &robot : robots) {
        bool known = false;
        for (std::size_t v = 0; v < views.size(); ++v) {
            const RecordId recording = views[v].recording.id;
            auto series = ODO_TRY(
                project.trials().currentObservations(recording, robot.id, which == StoredAs::Tracked));
            known |= series.has_value();
            if (series)
                stampAsRecorded(series->observations, views[v].recording.frameTimes);
            stored[v].series.push_back(series ? std::move(*series)
                                              : ObservationSeries{recording, robot.id, {}, {}});
            stored[v].frames = std::max(
                stored[v].frames, static_cast<std::int64_t>(stored[v].series.back().observations.size()));
        }
        if (!known)
            return fail(
                ErrorCode::NotFound, robotInTrialSubject(robot.name, trialName), nothingToAnalyseAgain(),
                ODO_TEXT("workflow.run_track_without_again", "run odograph track without --again first"));
    }
    return stored;
}

namespace {

constexpr double mostRefused = 0.2;

/// The part of the measured positions that is refused as spikes.
double refusedShare(const Profile &profile)
{
    constexpr SampleFlags spike =
        flagBit(SampleFlag::Jump) | flagBit(SampleFlag::SpeedLimit) | flagBit(SampleFlag::AccelerationLimit);
    double measured = 0, refused = 0;
    const auto count = [&](bool isMeasured, SampleFlags flags) {
        measured += isMeasured;
        refused += isMeasured && (flags & spike) != 0;
    };
    for (const Sample &sample : profile.samples)
        count(sample.position.has_value(), sample.flags);
    for (const SampleFlags flags : profile.flags)
        count(!hasFlag(flags, SampleFlag::Lost), flags);
    return measured > 0 ? refused / measured : 0;
}

} // namespace

Result<TaskAnalysis> analyseByTask(const MakeProfile &make, const AnalysisOptions &options,
                                   const std::optional<TaskRecord> &task)
{
    const AnalysisOptions byTask = task ? withTask(options, task->task) : options;
    auto profile = make(byTask);
    const bool limited = task && (task->task.limits.maxSpeedMps || task->task.limits.maxAccelMps2);
    const double refused = profile ? refusedShare(*profile) : 1;
    if (!limited || refused <= mostRefused) {
        if (!profile)
            return tl::unexpected(profile.error());
        return TaskAnalysis{std::move(*profile), byTask, {}};
    }
    Task free = task->task;
    free.limits = {};
    const AnalysisOptions withoutLimits = withTask(options, free);
    auto second = make(withoutLimits);
    if (second && refusedShare(*second) < refused / 2) {
        const MessageArgument name = Named::task(task->name);
        const Message why =
            profile
                ? ODO_TEXT("workflow.beyond_limits",
                           "%1 of the samples exceed the limits of task '%2', so the limits were ignored")(
                      quantity(std::round(100 * refused), 0, "%"), name)
                : ODO_TEXT("workflow.nearly_all_beyond_limits",
                           "nearly all samples exceed the limits of task '%1', so the limits were ignored")(
                      name);
        return TaskAnalysis{std::move(*second), withoutLimits,
                            joined({why, ODO_TEXT("workflow.give_limits_of_fastest",
                                                  "give the task the limits of its fastest robot")},
                                   Join::Semicolon)};
    }
    if (!profile)
        return tl::unexpected(profile.error());
    return TaskAnalysis{std::move(*profile), byTask, {}};
}

} // namespace odo
