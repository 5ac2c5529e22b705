// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/track_warnings.h"

#include "core/base/error.h"
#include "core/base/percentile.h"
#include "core/synchronisation/frame_rate_labels.h"
#include "core/trajectory/occlusions.h"
#include "core/trajectory/view_disagreement.h"
#include "core/workflow/track/frame_damage.h"
#include "core/workflow/trial_sources.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

namespace odo {

namespace {

constexpr double mostOfImage = 0.10; ///< no robot is larger in a frame that shows its task
constexpr double hardlyEver = 0.05;  ///< of the frames
constexpr double ambiguousStepS = 0.005;
constexpr double unusualClockRate = 0.001;

double partFound(const std::vector<TrackedView> &tracked, std::size_t robot)
{
    std::size_t found = 0, frames = 0;
    for (const TrackedView &view : tracked) {
        for (const Observation &observation : view.series[robot].observations) {
            found += observation.found;
            ++frames;
        }
    }
    return frames > 0 ? double(found) / double(frames) : 0;
}

} // namespace

Message changedResults()
{
    return wholeMessage(
        ODO_TEXT("workflow.results_changed", "its results differ from those of its analysis"),
        ODO_TEXT("workflow.changed_in_file", "they were changed in the file"),
        ODO_TEXT("workflow.check_or_analyse_again", "run odograph check, or reanalyse the trial"));
}

std::vector<Message> analysisWarnings(const AnalysisRecord &analysis, const std::string &trialName)
{
    std::vector<Message> sentences;
    if (!analysis.views.empty())
        sentences = describeGaps(analysis.profile, analysis.options.longestBridgedGap);
    else // of an imported track no camera could be moved
        std::ranges::transform(analysis.profile.gaps, std::back_inserter(sentences), unmeasuredSentence);
    if (analysis.proof == AnalysisRecord::Proof::Broken)
        sentences.insert(sentences.begin(), changedResults());
    if (Message apart = viewsApartSentence(analysis.profile, analysis.views); !apart.isEmpty())
        sentences.push_back(std::move(apart));
    if (!analysis.ambiguousNames.empty())
        sentences.push_back(joined({ambiguousNamesText(analysis.ambiguousNames, analysis.robotName),
                                    ODO_TEXT("workflow.give_own_colours", "give each its own colour")},
                                   Join::Semicolon));
    for (Message &sentence : sentences)
        sentence =
            joined({robotInTrialSubject(analysis.robotName, trialName), std::move(sentence)}, Join::Colon);
    return sentences;
}

namespace {

/// What a cause says, and what to do about it.
std::pair<Message, Message> textOf(const ContradictionCause &cause, const std::vector<std::string> &views)
{
    using Kind = ContradictionCause::Kind;
    const auto named = [&](std::size_t view) {
        return Named::camera(view < views.size() ? views[view] : std::string());
    };
    const double ms = 1e3 * std::abs(cause.size); // or mm
    const Message synchronise =
        ODO_TEXT("workflow.synchronise_again", "synchronise the views again and reanalyse");
    switch (cause.kind) {
    case Kind::CameraMoved:
        if (cause.since)
            return {ODO_TEXT("workflow.cause_camera_moved_at", "camera %1 seems to have moved by %2 at %3")(
                        named(cause.view), quantity(cause.size, 1, "px"),
                        quantity(toSeconds(*cause.since), 1, "s")),
                    ODO_TEXT("workflow.use_time_before", "use the time before that only")};
        return {ODO_TEXT("workflow.cause_camera_moved",
                         "camera %1 seems to have moved by %2 since its registration")(
                    named(cause.view), quantity(cause.size, 1, "px")),
                ODO_TEXT("workflow.register_moved_again", "register it again and reanalyse")};
    case Kind::CamerasMoved:
        return {ODO_TEXT("workflow.cause_cameras_moved",
                         "cameras %1 and %2 seem to have moved since their registration")(
                    named(cause.view), named(cause.otherView)),
                ODO_TEXT("workflow.register_both_again", "register both again and reanalyse")};
    case Kind::Offset:
        return {ODO_TEXT("workflow.cause_offset", "the time offset of view %1 seems wrong by %2")(
                    named(cause.view), quantity(ms, 0, "ms")),
                synchronise};
    case Kind::ClockRate:
        return {ODO_TEXT("workflow.cause_clock_rate",
                         "the time offset of view %1 seems to change by %2 in each second")(
                    named(cause.view), quantity(ms, 2, "ms")),
                synchronise};
    case Kind::Height:
        break;
    }
    return {ODO_TEXT("workflow.cause_height",
                     "the height given for the robot seems wrong by about %1")(quantity(ms, 0, "mm")),
            ODO_TEXT("workflow.measure_height", "measure its height, enter it and reanalyse")};
}

Message explainedSentence(const ViewsContradiction &contradiction, const std::vector<std::string> &views)
{
    const auto [cause, advice] = textOf(contradiction.causes.front(), views);
    Message causes = cause;
    for (std::size_t i = 1; i < contradiction.causes.size(); ++i)
        causes = ODO_TEXT("workflow.cause_or_cause",
                          "%1, or %2")(std::move(causes), textOf(contradiction.causes[i], views).first);
    return wholeMessage(ODO_TEXT("workflow.views_contradict_by", "the views contradict each other by %1")(
                            quantity(1000 * contradiction.apartM, 1, "mm")),
                        causes, advice);
}

} // namespace

Message viewsApartSentence(const Profile &profile, const std::vector<std::string> &views)
{
    if (profile.contradiction && !profile.contradiction->causes.empty())
        return explainedSentence(*profile.contradiction, views);
    static constexpr double mostApart = 0.1; // of what several views saw
    ViewsApart found = viewsApart(profile.samples);
    const std::size_t apart = found.apartM.size();
    if (double(apart) <= mostApart * double(found.seen))
        return {};
    const double medianM = upperMedian(std::move(found.apartM));
    if (medianM > farApartM)
        return wholeMessage(
            ODO_TEXT("workflow.views_far_apart",
                     "in %1 of %2 frames the views show it at positions far apart")(apart, found.seen),
            ODO_TEXT("workflow.one_follows_something_else",
                     "one of them tracks another object, or has moved since its registration"),
            ODO_TEXT("workflow.look_at_outlines",
                     "check the outlines, and set the robot's colour or keep other objects out of view"));
    const Message cause =
        ODO_TEXT("workflow.why_views_contradict", "a camera has moved since its registration, the views are "
                                                  "not synchronised, or the robot's height is wrong");
    return wholeMessage(
        ODO_TEXT("workflow.views_contradict",
                 "in %1 of %2 frames the views contradict each other")(apart, found.seen),
        ODO_TEXT("workflow.views_put_it_apart",
                 "their floor positions differ by %1")(quantity(1000 * medianM, 1, "mm")),
        joined({cause, ODO_TEXT("workflow.register_cameras_again", "register the cameras again")},
               Join::Semicolon));
}

Message ambiguousNamesText(std::span<const AmbiguousName> ambiguities, const std::string &robotName)
{
    if (ambiguities.empty())
        return {};
    std::set<std::string> others;
    for (const AmbiguousName &ambiguity : ambiguities)
        others.insert(ambiguity.otherNames.begin(), ambiguity.otherNames.end());
    const MessageArgument from = quantity(toSeconds(ambiguities.front().from), 2, "s"),
                          to = quantity(toSeconds(ambiguities.front().to), 2, "s");
    const bool isOnce = ambiguities.size() == 1;
    if (others.empty())
        return isOnce ? ODO_TEXT("workflow.doubtful_name_unknown",
                                 "from %1 to %2 this may be %3 or another robot that looks the same")(
                            from, to, Named::robot(robotName))
                      : ODO_TEXT("workflow.doubtful_names_unknown",
                                 "from %1 to %2 (the first of %3 times) this may be %4 or another robot that "
                                 "looks the same")(from, to, ambiguities.size(), Named::robot(robotName));
    std::vector<std::string> names{robotName};
    names.insert(names.end(), others.begin(), std::prev(others.end()));
    const MessageArgument first = listed(names, MessageArgument::Kind::Robot, MessageArgument::Joint::Comma),
                          last = Named::robot(*others.rbegin());
    return isOnce ? ODO_TEXT("workflow.doubtful_name", "from %1 to %2 this may be %3 or %4")(from, to, first,
                                                                                             last)
                  : ODO_TEXT("workflow.doubtful_names",
                             "from %1 to %2 (the first of %3 times) this may be %4 or %5")(
                        from, to, ambiguities.size(), first, last);
}

std::vector<Message> damageWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                    const std::vector<TrackedView> &tracked)
{
    std::vector<Message> sentences;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const std::vector<Nanoseconds> &times = views[v].recording.frameTimes;
        const FrameDamage damage = damageOf(tracked[v].series.front().observations, times);
        if (damage.frames == 0)
            continue;
        sentences.push_back(
            wholeMessage(viewInTrialSubject(views[v].recording.cameraName, trialName),
                         ODO_TEXT("workflow.damaged_frames",
                                  "%1 of its %2 frames, from %3 to %4, are damaged and were not measured")(
                             damage.frames, times.size(), quantity(toSeconds(damage.span.begin), 1, "s"),
                             quantity(toSeconds(damage.span.end), 1, "s")),
                         ODO_TEXT("workflow.copy_file_again", "copy the file from the camera again")));
    }
    return sentences;
}

Message movedSentence(const std::string &trialName, const RecordingRecord &view, const CameraMove &move)
{
    return wholeMessage(
        viewInTrialSubject(view.cameraName, trialName),
        ODO_TEXT("workflow.camera_moved_during",
                 "the camera moved by %1 after %2; what it saw from then on was not measured")(
            quantity(move.shiftPx, 1, "px"),
            quantity(toSeconds(clockOf(view).commonTime(move.time)), 1, "s")),
        ODO_TEXT("workflow.fix_camera", "fix the camera, register it again and repeat the run"));
}

std::vector<Message> moveWarnings(const std::string &trialName, const std::vector<RegisteredView> &views,
                                  const std::vector<TrackedView> &tracked)
{
    std::vector<Message> sentences;
    for (std::size_t v = 0; v < views.size(); ++v)
        if (tracked[v].cameraMove)
            sentences.push_back(movedSentence(trialName, views[v].recording, *tracked[v].cameraMove));
    return sentences;
}

Message clockStepSentence(const ClockStep &step)
{
    const MessageArgument at = quantity(step.afterS, 2, "s"),
                          length = quantity(std::abs(step.lengthS), 3, "s");
    if (step.lengthS > 0)
        return ODO_TEXT(
            "workflow.frames_lost",
            "after %1 the frames of %2 are missing, because the camera paused or lost them; later "
            "times were corrected")(at, length);
    if (step.squeezedS > 0)
        return ODO_TEXT("workflow.frames_doubled",
                        "up to %1 frames repeat for %2; later times were corrected")(at, length);
    return ODO_TEXT("workflow.clock_jumped",
                    "at %1 the clock jumped ahead by %2; later times were corrected")(at, length);
}

Message clockRateSentence(const RecordingRecord &view, const RecordingRecord &first, double clockRate)
{
    if (std::abs(clockRate) < unusualClockRate)
        return {};
    const auto rateOf = [](double rate) {
        return quantity(rate, std::abs(rate - std::round(rate)) < 0.005 ? 0 : 2, "frames/s");
    };
    const auto taken = rateBehindLabel(view.framesPerSecond, clockRate),
               takenByFirst = rateBehindLabel(first.framesPerSecond, 1 / (1 + clockRate) - 1);
    const MessageArgument viewName = Named::camera(view.cameraName),
                          firstName = Named::camera(first.cameraName);
    if (taken && takenByFirst)
        return ODO_TEXT(
            "workflow.labels_wrong",
            "view '%1' was recorded at %2 (its file says %3), or view '%4' at %5 (its file says %6); "
            "speeds and times are by the file of view '%4'")(
            viewName, rateOf(*taken), rateOf(view.framesPerSecond), firstName, rateOf(*takenByFirst),
            rateOf(first.framesPerSecond));
    if (taken)
        return ODO_TEXT("workflow.label_wrong", "view '%1' was recorded at %2, its file says %3")(
            viewName, rateOf(*taken), rateOf(view.framesPerSecond));
    if (takenByFirst)
        return ODO_TEXT(
            "workflow.first_label_wrong",
            "view '%1' was recorded at %2, its file says %3, so speeds and times are wrong by %4")(
            firstName, rateOf(*takenByFirst), rateOf(first.framesPerSecond),
            quantity(100 * std::abs(clockRate), 1, "%"));
    return ODO_TEXT(
        "workflow.clocks_differ",
        "the clocks of views '%1' and '%2' differ by %3; speeds and times are by the clock of view "
        "'%1'")(firstName, viewName, quantity(100 * std::abs(clockRate), 2, "%"));
}

Message stepWarning(const std::string &trialName, const RecordingRecord &view)
{
    if (view.position == 0)
        return {};
    const Message what = viewInTrialSubject(view.cameraName, trialName);
    const bool found = isStepMeasured(view);
    const double sigmaMs = 1e3 * view.startOffsetSigmaS;
    if (!found && view.syncMethod != "told")
        return wholeMessage(
            what,
            ODO_TEXT("workflow.not_synchronised",
                     "it is not synchronised: the same start time as the first view was assumed, and "
                     "positions of a moving robot are wrong"),
            ODO_TEXT("workflow.synchronise_for_offset",
                     "synchronise it again with odograph trial set --sync auto, or enter the time offset"));
    if (found && view.startOffsetSigmaS > ambiguousStepS)
        return wholeMessage(
            what,
            ODO_TEXT("workflow.doubtful_step", "it is synchronised only to %1, which is %2 at 1 m/s")(
                quantity(sigmaMs, 0, "ms"), quantity(sigmaMs, 0, "mm")),
            ODO_TEXT("workflow.turn_or_flash",
                     "turn the robot, or flash the room light, in view of both cameras"));
    return {};
}

std::vector<Message> stepWarnings(const std::string &trialName,
                                  const std::vector<const RecordingRecord *> &used)
{
    std::vector<Message> sentences;
    for (std::size_t i = 0; used.size() > 1 && i < used.size(); ++i)
        if (Message sentence = stepWarning(trialName, *used[i]); !sentence.isEmpty())
            sentences.push_back(std::move(sentence));
    return sentences;
}

std::vector<std::size_t> usedViews(const AnalysisRecord &analysis, std::size_t views)
{
    std::vector<std::size_t> used;
    for (std::size_t view = 0; view < std::min(views, analysis.registrations.size()); ++view)
        if (analysis.registrations[view] != 0)
            used.push_back(view);
    return used;
}

std::vector<Message> stepWarnings(const std::string &trialName, const std::vector<RegisteredView> &views)
{
    std::vector<const RecordingRecord *> used;
    for (const RegisteredView &view : views) {
        if (view.floorView)
            used.push_back(&view.recording);
    }
    return stepWarnings(trialName, used);
}

std::optional<FloorColour> floorColourOf(const RobotRecord &robot, const std::string &trialName,
                                         const std::vector<RegisteredView> &views,
                                         const std::vector<TrackedView> &tracked, std::size_t robotIndex)
{
    if (!robot.colour)
        return std::nullopt;
    std::size_t worst = 0;
    double share = 0;
    for (std::size_t v = 0; v < tracked.size(); ++v) {
        if (robotIndex < tracked[v].sharesAlike.size() && tracked[v].sharesAlike[robotIndex] > share) {
            share = tracked[v].sharesAlike[robotIndex];
            worst = v;
        }
    }
    if (share <= mostOfImage)
        return std::nullopt;
    return FloorColour{
        {ErrorCode::Undetermined, robotInTrialSubject(robot.name, trialName),
         ODO_TEXT("workflow.floor_has_its_colour",
                  "its colour %1 is also the floor's (%2 of the frame in view %3)")(
             robot.colour->toString(), quantity(std::round(100 * share), 0, "%"),
             Named::camera(views[worst].recording.cameraName)),
         ODO_TEXT("workflow.put_plate_on_it", "put a plate of another colour on it, or set its true colour")},
        partFound(tracked, robotIndex) < hardlyEver};
}

} // namespace odo
