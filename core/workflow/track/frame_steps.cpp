// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/frame_steps.h"

#include "core/base/error.h"
#include "core/video/frame_times.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace odo {

namespace {

// behind the tracker's version in a series
constexpr const char *lostWords = "; lost ", *doubledWords = "; doubled ", *leapWords = "; leap ";
constexpr std::size_t mostNoted = 30; ///< of a view; more say nothing else
constexpr std::size_t mostSaid = 3;   ///< one by one

const char *wordsOf(FrameStep::Kind kind)
{
    switch (kind) {
    case FrameStep::Kind::Lost:
        return lostWords;
    case FrameStep::Kind::Doubled:
        return doubledWords;
    case FrameStep::Kind::Leap:
        break;
    }
    return leapWords;
}

void note(const std::vector<FrameStep> &steps, std::string &algorithm)
{
    for (std::size_t i = 0; i < std::min(steps.size(), mostNoted); ++i) {
        std::array<char, 80> text{};
        std::snprintf(text.data(), text.size(), "%s%lld before %lld (%.3f m)", wordsOf(steps[i].kind),
                      static_cast<long long>(steps[i].frames), static_cast<long long>(steps[i].frame),
                      steps[i].leapM);
        algorithm += text.data();
    }
}

/// The frames between the last that is sound and the one after a step.
bool isDoubledIn(const std::vector<FrameStep> &steps, std::int64_t frame)
{
    return std::ranges::any_of(steps, [frame](const FrameStep &step) {
        return step.kind == FrameStep::Kind::Doubled && frame < step.frame &&
               frame >= step.frame - step.frames;
    });
}

void correctOne(std::vector<Observation> &observations, const std::vector<Nanoseconds> &frameTimes,
                const std::vector<FrameStep> &steps)
{
    stampAsRecorded(observations, frameTimes);
    for (Observation &seen : observations)
        seen.duplicateFrame = seen.duplicateFrame || isDoubledIn(steps, seen.frame);
}

std::vector<FrameStep> stepsIn(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                               const TrackedView &tracked)
{
    if (!view.floorView)
        return {};
    std::vector<FrameTrack> tracks;
    for (std::size_t r = 0; r < tracked.series.size(); ++r)
        tracks.push_back(frameTrack(*view.floorView, shapeOf(robots[r]).heightM.value_or(0),
                                    tracked.series[r].observations));
    return findFrameSteps(tracks, view.recording.frameTimes);
}

void correct(RegisteredView &view, TrackedView &tracked, const std::vector<FrameStep> &steps)
{
    const ClockRepair repair = repairOf(steps);
    for (Nanoseconds &time : view.recording.frameTimes)
        time = fromSeconds(repair.timeS(toSeconds(time)));
    for (ObservationSeries &series : tracked.series)
        correctOne(series.observations, view.recording.frameTimes, steps);
    for (std::vector<Observation> &observations : tracked.others)
        correctOne(observations, view.recording.frameTimes, steps);
    if (tracked.cameraMove)
        tracked.cameraMove->time = fromSeconds(repair.timeS(toSeconds(tracked.cameraMove->time)));
}

} // namespace

std::vector<RecordingRecord> correctFrameTimes(std::vector<RegisteredView> &views,
                                               const std::vector<RobotRecord> &robots,
                                               std::vector<TrackedView> &tracked,
                                               const std::vector<std::vector<FrameStep>> &noted)
{
    std::vector<RecordingRecord> changed;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const std::vector<FrameStep> steps = stepsIn(views[v], robots, tracked[v]);
        if (!repairOf(steps).steps.empty()) {
            correct(views[v], tracked[v], steps);
            changed.push_back(views[v].recording);
        }
        std::vector<FrameStep> all = v < noted.size() ? noted[v] : std::vector<FrameStep>{};
        std::erase_if(all, [](const FrameStep &step) { return step.kind == FrameStep::Kind::Leap; });
        all.insert(all.end(), steps.begin(), steps.end());
        std::ranges::sort(all, {}, &FrameStep::frame);
        for (ObservationSeries &series : tracked[v].series)
            note(all, series.algorithm);
    }
    return changed;
}

std::vector<FrameStep> notedSteps(const ObservationSeries &series)
{
    std::vector<FrameStep> steps;
    for (const auto kind : {FrameStep::Kind::Lost, FrameStep::Kind::Doubled, FrameStep::Kind::Leap}) {
        const char *words = wordsOf(kind);
        for (std::size_t at = series.algorithm.find(words); at != std::string::npos;
             at = series.algorithm.find(words, at + 1)) {
            long long frames = 0, frame = 0;
            double leapM = 0;
            if (std::sscanf(series.algorithm.c_str() + at + std::strlen(words), "%lld before %lld (%lf m)",
                            &frames, &frame, &leapM) != 3)
                continue;
            FrameStep &step = steps.emplace_back();
            step.kind = kind;
            step.frames = frames;
            step.frame = frame;
            step.leapM = leapM;
        }
    }
    std::ranges::sort(steps, {}, &FrameStep::frame);
    return steps;
}

namespace {

/// One step: a predicate.
Message stepWords(const FrameStep &step, MessageArgument at)
{
    switch (step.kind) {
    case FrameStep::Kind::Lost:
        return step.frames == 1
                   ? ODO_TEXT("workflow.one_frame_missing",
                              "after %1 a frame is missing that its time stamps do not show: the robot moves "
                              "too far; later times were corrected")(std::move(at))
                   : ODO_TEXT("workflow.frames_missing_unseen",
                              "after %1 %2 frames are missing that its time stamps do not show: the robot "
                              "moves too far; later times were corrected")(std::move(at), step.frames);
    case FrameStep::Kind::Doubled:
        return step.frames == 1
                   ? ODO_TEXT("workflow.one_frame_doubled",
                              "after %1 a frame repeats the one before, and its time stamps count it as "
                              "time; later times were corrected")(std::move(at))
                   : ODO_TEXT("workflow.frames_doubled_unseen",
                              "after %1 %2 frames repeat the one before, and its time stamps count them as "
                              "time; later times were corrected")(std::move(at), step.frames);
    case FrameStep::Kind::Leap:
        break;
    }
    return ODO_TEXT("workflow.robot_leaps",
                    "after %1 the robot is suddenly %2 away: frames are missing, or another object was "
                    "tracked; speeds, paths and times across it are wrong")(
        std::move(at), quantity(1e3 * step.leapM, 0, "mm"));
}

} // namespace

std::vector<Message> stepSentences(const std::string &trialName, const RecordingRecord &view,
                                   const std::vector<FrameStep> &steps)
{
    const auto at = [&](const FrameStep &step) {
        const auto before = std::size_t(
            std::max<std::int64_t>(0, step.frame - 1 -
                                          (step.kind == FrameStep::Kind::Doubled ? step.frames : 0)));
        const bool isKnown = before < view.frameTimes.size();
        return quantity(isKnown ? toSeconds(clockOf(view).commonTime(view.frameTimes[before])) : 0, 2, "s");
    };
    std::vector<Message> sentences;
    for (std::size_t i = 0; i < std::min(steps.size(), mostSaid); ++i)
        sentences.push_back(joined(
            {viewInTrialSubject(view.cameraName, trialName), stepWords(steps[i], at(steps[i]))}, Join::Colon));
    if (steps.size() > mostSaid)
        sentences.push_back(
            joined({viewInTrialSubject(view.cameraName, trialName),
                    ODO_TEXT("workflow.more_frame_steps",
                             "up to %1 its frames are wrong at %2 more moments in the same way")(
                        at(steps.back()), steps.size() - mostSaid)},
                   Join::Colon));
    return sentences;
}

std::vector<Message> frameStepWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                       const std::vector<TrackedView> &tracked)
{
    std::vector<Message> sentences;
    for (std::size_t v = 0; v < views.size(); ++v) {
        if (tracked[v].series.empty())
            continue;
        for (Message &sentence :
             stepSentences(trialName, views[v].recording, notedSteps(tracked[v].series.front())))
            sentences.push_back(std::move(sentence));
    }
    return sentences;
}

} // namespace odo
