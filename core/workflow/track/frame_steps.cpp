// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/frame_steps.h"

#include "core/base/error.h"
#include "core/synchronisation/frame_conversion.h"
#include "core/video/frame_times.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <iterator>

namespace odo {

namespace {

// behind the tracker's version in a series
constexpr const char *lostWords = "; lost ", *doubledWords = "; doubled ", *leapWords = "; leap ",
                     *stoodWords = "; stood ", *repeatedWords = "; repeated ", *frozenWords = "; frozen ",
                     *fieldsWords = "; fields ", *combedWords = "; combed ";
constexpr std::size_t mostNoted = 30; ///< of a view; more say nothing else
constexpr std::size_t mostSaid = 3;   ///< one by one
constexpr double leastOfFrame = 0.6;  ///< that times are corrected by

const char *wordsOf(FrameStep::Kind kind)
{
    switch (kind) {
    case FrameStep::Kind::Lost:
        return lostWords;
    case FrameStep::Kind::Doubled:
        return doubledWords;
    case FrameStep::Kind::Stood:
        return stoodWords;
    case FrameStep::Kind::Repeated:
        return repeatedWords;
    case FrameStep::Kind::Frozen:
        return frozenWords;
    case FrameStep::Kind::Fields:
        return fieldsWords;
    case FrameStep::Kind::Combed:
        return combedWords;
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
        return (step.kind == FrameStep::Kind::Doubled || step.kind == FrameStep::Kind::Frozen) &&
               frame < step.frame && frame >= step.frame - step.frames;
    });
}

std::vector<FrameTrack> tracksIn(const RegisteredView &view, const std::vector<RobotRecord> &robots,
                                 const TrackedView &tracked)
{
    std::vector<FrameTrack> tracks;
    for (std::size_t r = 0; view.floorView && r < tracked.series.size(); ++r)
        tracks.push_back(frameTrack(*view.floorView, shapeOf(robots[r]).heightM.value_or(0),
                                    tracked.series[r].observations));
    return tracks;
}

/// Gives the recording and all that was tracked new times; isDoubled: whether a frame repeats the one before.
template <class IsDoubled>
void retime(RegisteredView &view, TrackedView &tracked, std::vector<Nanoseconds> frameTimes,
            const IsDoubled &isDoubled)
{
    const auto newTime = [&, &before = view.recording.frameTimes](Nanoseconds old) {
        const auto at = std::size_t(std::ranges::lower_bound(before, old) - before.begin());
        return at < frameTimes.size() ? frameTimes[at] : old;
    };
    for (LightLevel &light : tracked.light)
        light.time = newTime(light.time);
    if (tracked.cameraMove)
        tracked.cameraMove->time = newTime(tracked.cameraMove->time);
    view.recording.frameTimes = std::move(frameTimes);
    const auto correct = [&](std::vector<Observation> &observations) {
        stampAsRecorded(observations, view.recording.frameTimes);
        for (Observation &seen : observations)
            seen.duplicateFrame = seen.duplicateFrame || isDoubled(seen.frame);
    };
    for (ObservationSeries &series : tracked.series)
        correct(series.observations);
    for (std::vector<Observation> &observations : tracked.others)
        correct(observations);
}

/// One view's frames of a converted video: their times as taken. Gives whether times changed.
bool correctConversion(RegisteredView &view, const std::vector<RobotRecord> &robots, TrackedView &tracked,
                       std::vector<FrameStep> &steps)
{
    const auto conversion = findConversion(tracksIn(view, robots, tracked), view.recording.frameTimes);
    if (!conversion)
        return false;
    FrameStep &step = steps.emplace_back();
    step.kind = FrameStep::Kind::Repeated;
    step.frames = conversion->every;
    step.frame = conversion->first;
    if (conversion->isTimed)
        return false;
    retime(view, tracked, convertedTimes(*conversion, view.recording.frameTimes), [&](std::int64_t frame) {
        return frame > 0 && (frame - conversion->first) % conversion->every == 0;
    });
    return true;
}

/// Corrects lost and doubled frames; gives whether times changed.
bool correctSteps(RegisteredView &view, const std::vector<RobotRecord> &robots, TrackedView &tracked,
                  std::vector<FrameStep> &steps)
{
    const auto found = findFrameSteps(tracksIn(view, robots, tracked), view.recording.frameTimes);
    std::ranges::copy_if(found, std::back_inserter(steps),
                         [](const FrameStep &step) { return step.step.lengthS == 0; });
    const ClockRepair repair = repairOf(found);
    std::vector<Nanoseconds> times = view.recording.frameTimes;
    for (Nanoseconds &time : times)
        time = fromSeconds(repair.timeS(toSeconds(time)));
    retime(view, tracked, std::move(times), [&](std::int64_t frame) { return isDoubledIn(found, frame); });
    return !repair.steps.empty();
}

/// Where a recording's times go on otherwise than the file's stamps, by most of a frame or more. A camera's
/// rate that was given scales all of them.
std::vector<FrameStep> correctedSteps(const std::vector<Nanoseconds> &fileTimes,
                                      const std::vector<Nanoseconds> &frameTimes)
{
    const double usualS = toSeconds(spacingOf(frameTimes).usual),
                 stampedS = toSeconds(spacingOf(fileTimes).usual);
    std::vector<FrameStep> steps;
    std::int64_t repeats = 0;
    for (std::size_t i = 1; i < std::min(fileTimes.size(), frameTimes.size()) && stampedS > 0; ++i) {
        const double intervalS = toSeconds(frameTimes[i] - frameTimes[i - 1]);
        const double addedS = intervalS - usualS / stampedS * toSeconds(fileTimes[i] - fileTimes[i - 1]);
        if (addedS < -leastOfFrame * usualS && intervalS < (1 - leastOfFrame) * usualS) {
            ++repeats;
            continue;
        }
        FrameStep step;
        step.frame = static_cast<std::int64_t>(i);
        step.kind = addedS > leastOfFrame * usualS ? FrameStep::Kind::Lost : FrameStep::Kind::Doubled;
        step.frames = step.kind == FrameStep::Kind::Lost ? std::lround(addedS / usualS) : repeats;
        if (step.frames > 0)
            steps.push_back(step);
        repeats = 0;
    }
    return steps;
}

} // namespace

std::vector<RecordingRecord> correctFrameTimes(std::vector<RegisteredView> &views,
                                               const std::vector<RobotRecord> &robots,
                                               std::vector<TrackedView> &tracked)
{
    std::vector<RecordingRecord> changed;
    for (std::size_t v = 0; v < views.size(); ++v) {
        std::vector<FrameStep> steps;
        const bool isConverted = correctConversion(views[v], robots, tracked[v], steps),
                   isCorrected = correctSteps(views[v], robots, tracked[v], steps);
        if (isConverted || isCorrected)
            changed.push_back(views[v].recording);
        for (const FrameStep &step : correctedSteps(tracked[v].fileTimes, views[v].recording.frameTimes))
            steps.push_back(step);
        if (tracked[v].interlace != Interlace::None)
            steps.emplace_back().kind =
                tracked[v].interlace == Interlace::Fields ? FrameStep::Kind::Fields : FrameStep::Kind::Combed;
        std::ranges::stable_sort(steps, {}, &FrameStep::frame);
        for (ObservationSeries &series : tracked[v].series)
            note(steps, series.algorithm);
    }
    return changed;
}

std::vector<FrameStep> notedSteps(const ObservationSeries &series)
{
    std::vector<FrameStep> steps;
    using enum FrameStep::Kind;
    for (const auto kind : {Fields, Combed, Repeated, Lost, Doubled, Stood, Frozen, Leap}) {
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

std::vector<Nanoseconds> leapTimes(const ObservationSeries &series,
                                   const std::vector<Nanoseconds> &frameTimes)
{
    std::vector<Nanoseconds> times;
    for (const FrameStep &step : notedSteps(series))
        if (const auto frame = static_cast<std::size_t>(step.frame);
            step.kind == FrameStep::Kind::Leap && frame < frameTimes.size())
            times.push_back(frameTimes[frame]);
    return times;
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
    case FrameStep::Kind::Stood:
        return step.frames == 1
                   ? ODO_TEXT(
                         "workflow.one_frame_stood",
                         "after %1 the robot rests for a frame and then goes on at the same speed: either "
                         "the frame repeats the one before and later times are too late, or the robot "
                         "stopped; times were not corrected")(std::move(at))
                   : ODO_TEXT(
                         "workflow.frames_stood",
                         "after %1 the robot rests for %2 frames and then goes on at the same speed: either "
                         "the frames repeat the one before and later times are too late, or the robot "
                         "stopped; times were not corrected")(std::move(at), step.frames);
    case FrameStep::Kind::Repeated:
        return ODO_TEXT("workflow.video_converted",
                        "one frame in %1 repeats the one before, because the video was converted to a higher "
                        "frame rate; its frames were given the times at which they were taken")(step.frames);
    case FrameStep::Kind::Frozen:
        return ODO_TEXT("workflow.frames_frozen",
                        "after %1 %2 frames show the same image while the robot went on; they were not "
                        "measured")(std::move(at), step.frames);
    case FrameStep::Kind::Fields:
        return measuredByFields();
    case FrameStep::Kind::Combed:
        return ODO_TEXT(
            "workflow.interlaced_whole",
            "it is interlaced, but was measured by whole frames, of which each shows two moments; "
            "import it as a new trial to have each field measured at its own time");
    case FrameStep::Kind::Leap:
        break;
    }
    return ODO_TEXT("workflow.robot_leaps",
                    "after %1 the robot is suddenly %2 away: frames are missing for an unknown time, or "
                    "another object was tracked; nothing was measured across it")(
        std::move(at), quantity(1e3 * step.leapM, 0, "mm"));
}

} // namespace

std::vector<Message> stepSentences(const std::string &trialName, const RecordingRecord &view,
                                   const std::vector<FrameStep> &steps)
{
    const auto at = [&](const FrameStep &step) {
        const auto before = std::size_t(std::max<std::int64_t>(
            0, step.frame - 1 -
                   (step.kind == FrameStep::Kind::Doubled || step.kind == FrameStep::Kind::Stood ||
                            step.kind == FrameStep::Kind::Frozen
                        ? step.frames
                        : 0)));
        const bool isKnown = before < view.frameTimes.size();
        return quantity(isKnown ? toSeconds(clockOf(view).commonTime(view.frameTimes[before])) : 0, 2, "s");
    };
    std::vector<Message> sentences;
    for (std::size_t i = 0; i < std::min(steps.size(), mostSaid); ++i)
        sentences.push_back(
            joined({viewInTrialSubject(view.cameraName, trialName), stepWords(steps[i], at(steps[i]))},
                   Join::Colon));
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
