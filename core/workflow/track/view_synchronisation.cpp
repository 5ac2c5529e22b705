// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/view_synchronisation.h"

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/video/frame_times.h"
#include "core/workflow/shared_words.h"
#include "core/workflow/track/internal/clip_offsets.h"
#include "core/workflow/track/track_warnings.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// By what a view's offset is to be found; nullopt: it is not.
std::optional<OffsetSource> sourceOf(SyncBy how)
{
    switch (how) {
    case SyncBy::Automatic:
        return OffsetSource::Any;
    case SyncBy::Motion:
        return OffsetSource::Motion;
    case SyncBy::Flash:
        return OffsetSource::Flash;
    case SyncBy::Sound:
        return OffsetSource::Sound;
    case SyncBy::None:
    case SyncBy::Given:
    case SyncBy::Kept:
        break;
    }
    return std::nullopt;
}

const char *methodOf(OffsetSource source)
{
    return source == OffsetSource::Sound ? "audio" : source == OffsetSource::Flash ? "flash" : "auto";
}

/// Nothing is known of the clock but its steps.
void resetStep(RecordingRecord &recording, const ViewStep &step)
{
    recording.syncMethod = step.how == SyncBy::Given       ? "told"
                           : step.how == SyncBy::Automatic ? "open"
                                                           : "none";
    recording.startOffsetS = step.how == SyncBy::Given ? step.offsetS : 0;
    recording.startOffsetSigmaS = 0;
    recording.clockRate = 0;
}

/// Moves the frame times to where they were taken, and says so.
void repairTimes(RecordingRecord &recording, const ClockRepair &repair, std::vector<Message> &sentences)
{
    for (Nanoseconds &time : recording.frameTimes)
        time = fromSeconds(repair.timeS(toSeconds(time)));
    for (const ClockStep &step : repair.steps)
        sentences.push_back(joined({ODO_TEXT("workflow.times_of_view",
                                             "time stamps of view '%1'")(Named::camera(recording.cameraName)),
                                    clockStepSentence(step)},
                                   Join::Colon));
}

/// Stores what was found of one view's clock.
void takeOffset(RecordingRecord &recording, const RecordingRecord &first, const FoundOffset &offset,
                const Message &what, std::vector<Message> &sentences)
{
    for (const Message &remark : offset.remarks)
        sentences.push_back(joined({what, remark}, Join::Colon));
    repairTimes(recording, offset.clock.second, sentences);
    if (Message sentence = clockRateSentence(recording, first, offset.clock.rate); !sentence.isEmpty())
        sentences.push_back(joined({what, std::move(sentence)}, Join::Colon));
    recording.syncMethod = methodOf(offset.from);
    recording.startOffsetS = offset.clock.offsetS;
    recording.startOffsetSigmaS = offset.clock.sigmaS;
    recording.clockRate = offset.clock.rate;
}

double durationOf(const RecordingRecord &recording)
{
    return recording.frameTimes.empty() ? 0 : toSeconds(recording.frameTimes.back());
}

/// By the frames themselves: fields of interlaced ones come at twice the rate that the file states. 0 of one.
double measuredRate(const RecordingRecord &recording)
{
    const Nanoseconds usual = spacingOf(recording.frameTimes).usual;
    return usual > Nanoseconds(0) ? 1 / toSeconds(usual) : 0;
}

Result<bool> isSlowMotion(const std::vector<RegisteredView> &views, const CancelToken &cancel)
{
    bool isSlow = false;
    for (const RegisteredView &view : views) {
        const auto reader = ODO_TRY(VideoReader::open(view.file, cancel, knownRecording(view.recording)));
        const std::vector<Nanoseconds> &times = reader->info().frameTimes;
        isSlow = isSlow ||
                 (!times.empty() && isPlayedOtherwise(toSeconds(times.back()), durationOf(view.recording)));
    }
    return isSlow;
}

Result<void> findOffsets(std::vector<RegisteredView> &views, const std::vector<std::size_t> &sought,
                         const SyncRequest &request, TrialRecord &trial, std::vector<Message> &sentences,
                         const JobControl &control)
{
    const bool isSlow = ODO_TRY(request.isSlowMotion ? Result<bool>(*request.isSlowMotion)
                                                     : isSlowMotion(views, control.cancel));
    ClipOffsetSearch search{request.trial,        {}, request.robots, {request.microphones.front()}, isSlow,
                            request.mayTakeFields};
    std::vector<RegisteredView> compared{views.front()};
    for (const std::size_t view : sought) {
        compared.push_back(views[view]);
        search.sources.push_back(*sourceOf(request.steps[view - 1].how));
        search.microphones.push_back(request.microphones[view]);
    }
    auto [found, frameSteps, firstRepair] = ODO_TRY(findClipOffsets(compared, search, control));
    std::ranges::move(frameSteps, std::back_inserter(sentences));
    RecordingRecord &first = views.front().recording;
    first.frameTimes = compared.front().recording.frameTimes;
    if (firstRepair)
        repairTimes(first, *firstRepair, sentences);
    for (std::size_t i = 0; i < sought.size(); ++i) {
        RecordingRecord &recording = views[sought[i]].recording;
        recording.frameTimes = compared[i + 1].recording.frameTimes;
        const Result<FoundOffset> &offset = found[i];
        const Message what = ODO_TEXT("workflow.synchronisation_of_view",
                                      "synchronisation of view '%1'")(Named::camera(recording.cameraName));
        if (!offset &&
            (search.sources[i] != OffsetSource::Any || request.otherwise == SyncRequest::Otherwise::Fail))
            return fail(offset.error().code, what, offset.error().why, offset.error().advice);
        if (!offset) {
            const Message open =
                ODO_TEXT("workflow.sought_when_tracked", "%1; tracking tries again")(offset.error().why);
            sentences.push_back(wholeMessage(what, open, offset.error().advice));
            continue;
        }
        takeOffset(recording, first, *offset, what, sentences);
        if (sought[i] == 1) {
            trial.syncRateSigma = offset->clock.rateSigma;
            trial.syncScore = offset->clock.score;
        }
    }
    return {};
}

} // namespace

bool isPlayedOtherwise(double playsS, double tookS)
{
    return std::abs(tookS - playsS) > 0.01 * playsS;
}

Result<std::vector<ViewStep>> stepsFor(const Message &what, std::size_t views, std::vector<ViewStep> given)
{
    const std::size_t others = views - 1;
    const bool forAll =
        given.empty() || (given.size() == 1 && (others == 0 || given.front().how != SyncBy::Given));
    if (given.size() != others && !forAll)
        return fail(
            ErrorCode::InvalidInput, what,
            ODO_TEXT("workflow.offsets_of_other_count",
                     "the number of views is %1, the number of offsets %2")(others + 1, given.size()),
            ODO_TEXT("workflow.give_offset_for_each",
                     "give one offset for each view but the first, like --sync 0.1,0.2, or use --sync auto"));
    if (forAll)
        given.resize(others, given.empty() ? ViewStep{} : given.front());
    return given;
}

bool isAnythingSought(const SyncRequest &request)
{
    return std::ranges::any_of(request.steps,
                               [](const ViewStep &step) { return sourceOf(step.how).has_value(); });
}

Result<std::vector<std::optional<MicrophonePosition>>>
microphonePositions(Project &project, const std::vector<RegisteredView> &views)
{
    std::vector<std::optional<MicrophonePosition>> positions;
    for (const RegisteredView &view : views)
        positions.push_back(ODO_TRY(microphonePositionOf(project, view)));
    return positions;
}

Result<std::vector<Message>> synchroniseViews(std::vector<RegisteredView> &views, const SyncRequest &request,
                                              TrialRecord &trial, const JobControl &control)
{
    std::vector<Message> sentences;
    std::vector<std::size_t> sought;
    for (std::size_t view = 1; view < views.size(); ++view) {
        const ViewStep &step = request.steps[view - 1];
        if (step.how == SyncBy::Kept)
            continue;
        resetStep(views[view].recording, step);
        if (view == 1) {
            trial.syncRateSigma = 0;
            trial.syncScore = step.how == SyncBy::Given ? 1 : 0;
        }
        if (sourceOf(step.how))
            sought.push_back(view);
    }
    if (!sought.empty())
        ODO_TRY(findOffsets(views, sought, request, trial, sentences, control));
    trial.syncMethod = "none";
    if (views.size() > 1) {
        const RecordingRecord &second = views[1].recording;
        trial.syncMethod = second.syncMethod;
        trial.syncOffsetS = second.startOffsetS;
        trial.syncOffsetSigmaS = second.startOffsetSigmaS;
        trial.syncRate = second.clockRate;
    }
    return sentences;
}

std::vector<RecordingRecord> recordingsOf(const std::vector<RegisteredView> &views)
{
    std::vector<RecordingRecord> recordings;
    std::ranges::transform(views, std::back_inserter(recordings), &RegisteredView::recording);
    return recordings;
}

std::vector<RecordingRecord> retimedRecordings(const std::vector<RegisteredView> &before,
                                               const std::vector<RegisteredView> &views)
{
    std::vector<RecordingRecord> retimed;
    for (std::size_t v = 0; v < views.size(); ++v)
        if (views[v].recording.frameTimes != before[v].recording.frameTimes)
            retimed.push_back(views[v].recording);
    return retimed;
}

Result<std::vector<Message>> commonTimeWarnings(const Message &what,
                                                const std::vector<RecordingRecord> &recordings)
{
    std::vector<Message> sentences;
    const RecordingRecord &first = recordings.front();
    const double firstEndS = durationOf(first);
    for (std::size_t view = 1; view < recordings.size(); ++view) {
        const RecordingRecord &other = recordings[view];
        const double startS = other.startOffsetS, endS = startS + durationOf(other);
        const double commonS = std::min(endS, firstEndS) - std::max(startS, 0.0);
        const MessageArgument firstName = Named::camera(first.cameraName),
                              otherName = Named::camera(other.cameraName);
        if (commonS <= 0)
            return fail(ErrorCode::InvalidInput, what,
                        ODO_TEXT("workflow.no_common_time",
                                 "views '%1' and '%2' do not overlap with a time offset of %3")(
                            firstName, otherName, quantity(startS, 2, "s")),
                        ODO_TEXT("workflow.check_files_and_offset", "check the files and the --sync offset"));
        const auto warn = [&](Message why, Message advice) {
            sentences.push_back(
                wholeMessage(ODO_TEXT("workflow.two_views", "views '%1' and '%2'")(firstName, otherName),
                             std::move(why), std::move(advice)));
        };
        if (commonS < 0.9 * std::max(firstEndS, durationOf(other)))
            warn(ODO_TEXT("workflow.little_common_time", "%1 and %2 long, %3 in common")(
                     quantity(firstEndS, 2, "s"), quantity(durationOf(other), 2, "s"),
                     quantity(commonS, 2, "s")),
                 ODO_TEXT("workflow.check_views_of_one_run",
                          "only one view measures the rest, so check that both belong to one run"));
        const double a = measuredRate(first), b = measuredRate(other);
        const bool isLabelWrong = std::abs(other.clockRate) > largestClockRate; // said already
        if (a > 0 && b > 0 && std::abs(a - b) > 0.02 * a && !isLabelWrong)
            warn(ODO_TEXT("workflow.unequal_rates", "%1 and %2")(std::lround(a),
                                                                 quantity(std::round(b), 0, "frames/s")),
                 ODO_TEXT("workflow.check_rate",
                          "views are matched by time: check --rate if one is in slow motion"));
    }
    return sentences;
}

} // namespace odo
