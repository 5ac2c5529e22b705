// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/track/trial_verdict.h"

#include "core/analysis/metrics.h"
#include "core/base/percentile.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/trajectory/view_disagreement.h"
#include "core/workflow/track/frame_damage.h"
#include "core/workflow/track/frame_steps.h"
#include "core/workflow/track/registered_scene.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/track/view_tracking.h"
#include "core/workflow/trial_sources.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace odo {

namespace {

// What a careful person would still accept, and what nobody should use.
constexpr double doubtfulSpikes = 0.05, badSpikes = 0.25; // of the used samples
constexpr double doubtfulTracked = 0.8, badTracked = 0.4; // used samples of all
constexpr double badGaps = 0.5;                           // of the time between first and last sighting
constexpr double longFrame = 4, longFrameS = 0.2;         // of the usual interval, and at least
constexpr double fastestMps = 15, hardestMps2 = 100;      // no classroom robot
// σ of the positions: of the distance between the farthest of them, and at least
constexpr double doubtfulSigma = 0.04, badSigma = 0.1, leastDoubtfulM = 0.01, leastBadM = 0.05;
constexpr const char *resultsIntact = "results_intact", *viewsAgree = "views_agree",
                     *timeMeasured = "time_measured", *synchronised = "synchronised",
                     *framesRegular = "frames_regular", *framesDecoded = "frames_decoded",
                     *fewSpikes = "few_spikes", *positionsPrecise = "positions_precise",
                     *motionPossible = "motion_possible", *nameKnown = "name_known",
                     *lensKnown = "lens_known", *cameraStill = "camera_still";

class Checks
{
public:
    void add(const char *code, CheckLevel level, Message text)
    {
        m_verdict.checks.push_back({code, level, std::move(text)});
    }
    /// Where no check with this code has found anything.
    void pass(const char *code, Message text)
    {
        if (std::ranges::find(m_verdict.checks, code, &TrialCheck::code) == m_verdict.checks.end())
            add(code, CheckLevel::Pass, std::move(text));
    }
    TrialVerdict take() { return std::move(m_verdict); }

private:
    TrialVerdict m_verdict;
};

MessageArgument percent(double share)
{
    return quantity(100 * share, 0, "%");
}

/// Of each sample whether it is used; of a long track, whose samples are not held, by their flags.
std::vector<char> usedSamples(const Profile &profile)
{
    std::vector<char> used;
    used.reserve(profile.points.size());
    for (const Sample &sample : profile.samples)
        used.push_back(isUsed(sample));
    for (const SampleFlags flags : profile.flags)
        used.push_back(!isRejected(flags));
    return used;
}

/// Of the samples from the first to the last that is used: a robot may come later and leave earlier.
double usedShare(const std::vector<char> &used)
{
    const auto first = std::ranges::find(used, 1);
    if (first == used.end())
        return 1;
    const auto last = std::find(used.rbegin(), used.rend(), 1).base();
    return double(std::count(first, last, 1)) / double(last - first);
}

/// The time before the first and after the last position, where the robot was moving then, and it is as long
/// as a gap.
double missedAtEndsS(const Profile &profile, double measuredWithGapsS)
{
    constexpr double leastS = 1.5;
    const auto duration = std::ranges::find(profile.metrics, "duration", &Metric::name);
    if (duration == profile.metrics.end() || !duration->isAtLeast || profile.samples.empty())
        return 0;
    const double missedS =
        toSeconds(profile.samples.back().time - profile.samples.front().time) - measuredWithGapsS;
    return missedS < leastS ? 0 : missedS;
}

void checkTime(const AnalysisRecord &analysis, const Message &robot, Checks &checks)
{
    const Profile &profile = analysis.profile;
    double gapsS = 0;
    for (const TimeSpan &gap : profile.gaps)
        gapsS += toSeconds(gap.end - gap.begin);
    gapsS += missedAtEndsS(profile, profile.measuredS + gapsS);
    const double wholeS = profile.measuredS + gapsS;
    if (gapsS > 0)
        checks.add(
            timeMeasured, gapsS > badGaps * wholeS ? CheckLevel::Bad : CheckLevel::Doubtful,
            joined({robot, ODO_TEXT("workflow.measured_in_part",
                                    "%1 of %2 were measured; lengths, times and maxima are at least as "
                                    "large as stated")(quantity(profile.measuredS, 1, "s"),
                                                       quantity(wholeS, 1, "s"))},
                   Join::Colon));
    const double share = usedShare(usedSamples(profile));
    if (share < doubtfulTracked)
        checks.add(timeMeasured, share < badTracked ? CheckLevel::Bad : CheckLevel::Doubtful,
                   joined({robot, ODO_TEXT("workflow.measured_frames",
                                           "only %1 of the frames give a position")(percent(share))},
                          Join::Colon));
}

void checkMotion(const AnalysisRecord &analysis, const Message &robot, Checks &checks)
{
    const Profile &profile = analysis.profile;
    const auto used = double(std::max<std::ptrdiff_t>(1, std::ranges::count(usedSamples(profile), 1)));
    const double spikes = double(profile.spikes.size()) / used;
    if (spikes > doubtfulSpikes)
        checks.add(fewSpikes, spikes > badSpikes ? CheckLevel::Bad : CheckLevel::Doubtful,
                   joined({robot, ODO_TEXT("workflow.many_spikes", "%1 spikes in %2 positions")(
                                      profile.spikes.size(), static_cast<std::int64_t>(used))},
                          Join::Colon));
    const double speed = metricValue(profile, "max_speed"), accel = metricValue(profile, "p95_accel");
    if (speed > fastestMps || accel > hardestMps2)
        checks.add(motionPossible, CheckLevel::Doubtful,
                   joined({robot, ODO_TEXT("workflow.hardly_possible",
                                           "a robot hardly moves at %1 with %2; check units and scale")(
                                      quantity(speed, 1, "m/s"), quantity(accel, 0, "m/s²"))},
                          Join::Colon));
}

/// Half of the positions are more uncertain than a run of that extent allows.
void checkPrecision(const Profile &profile, const Message &robot, Checks &checks)
{
    std::vector<double> sigmas;
    Eigen::AlignedBox2d floor;
    for (const ProfilePoint &point : profile.points) {
        if (!point.valid)
            continue;
        sigmas.push_back(std::max(point.sigmaXM, point.sigmaYM));
        floor.extend(point.position);
    }
    if (sigmas.empty())
        return;
    const double sigmaM = upperMedian(std::move(sigmas)), extentM = floor.diagonal().norm();
    if (sigmaM <= std::max(leastDoubtfulM, doubtfulSigma * extentM))
        return;
    checks.add(positionsPrecise,
               sigmaM > std::max(leastBadM, badSigma * extentM) ? CheckLevel::Bad : CheckLevel::Doubtful,
               joined({robot, ODO_TEXT("workflow.positions_uncertain",
                                       "its positions are known to ±%1 only, in a run over %2")(
                                  quantity(1e3 * sigmaM, 0, "mm"), quantity(extentM, 1, "m"))},
                      Join::Colon));
}

/// Doubtful where the cause is known, which the stated errors then hold; else bad.
void checkViews(const AnalysisRecord &analysis, const Message &robot, Checks &checks)
{
    Message apart = viewsApartSentence(analysis.profile, analysis.views);
    if (apart.isEmpty())
        return;
    const auto &known = analysis.profile.contradiction;
    const bool isHeld = known && !known->causes.empty() && known->apartM < farApartM;
    checks.add(viewsAgree, isHeld ? CheckLevel::Doubtful : CheckLevel::Bad,
               joined({robot, std::move(apart)}, Join::Colon));
}

void checkAnalysis(const AnalysisRecord &analysis, const std::string &trial, Checks &checks)
{
    const Message robot = robotInTrialSubject(analysis.robotName, trial);
    if (analysis.proof == AnalysisRecord::Proof::Broken)
        checks.add(resultsIntact, CheckLevel::Bad, joined({robot, changedResults()}, Join::Colon));
    checkViews(analysis, robot, checks);
    checkTime(analysis, robot, checks);
    checkMotion(analysis, robot, checks);
    checkPrecision(analysis.profile, robot, checks);
    if (!analysis.ambiguousNames.empty())
        checks.add(
            nameKnown, CheckLevel::Doubtful,
            joined({robot, ambiguousNamesText(analysis.ambiguousNames, analysis.robotName)}, Join::Colon));
}

/// noted: what tracking found; it says more of the interval before its frame.
void checkFrames(const RecordingRecord &view, const std::vector<FrameStep> &noted, const std::string &trial,
                 Checks &checks)
{
    std::vector<double> intervals;
    for (std::size_t i = 1; i < view.frameTimes.size(); ++i)
        intervals.push_back(toSeconds(view.frameTimes[i] - view.frameTimes[i - 1]));
    if (intervals.empty())
        return;
    for (const FrameStep &step : noted)
        if (step.frame > 0 && step.frame <= std::ssize(intervals))
            intervals[std::size_t(step.frame - 1)] = 0;
    const double longest = *std::ranges::max_element(intervals), usual = upperMedian(std::move(intervals));
    if (longest > std::max(longFrameS, longFrame * usual))
        checks.add(framesRegular, CheckLevel::Doubtful,
                   joined({viewInTrialSubject(view.cameraName, trial),
                           ODO_TEXT("workflow.frames_missing",
                                    "%1 without a frame, where %2 is usual; frames are missing, or its time "
                                    "stamps jump")(quantity(longest, 2, "s"), quantity(usual, 3, "s"))},
                          Join::Colon));
}

void checkDecoding(const ObservationSeries &series, const RecordingRecord &view, const std::string &trial,
                   Checks &checks)
{
    const std::size_t frames = view.frameTimes.size();
    const std::int64_t damaged = damageOf(series.observations, view.frameTimes).frames;
    if (damaged == 0)
        return;
    checks.add(framesDecoded,
               double(damaged) > badGaps * double(frames) ? CheckLevel::Bad : CheckLevel::Doubtful,
               joined({viewInTrialSubject(view.cameraName, trial),
                       ODO_TEXT("workflow.frames_not_decoded",
                                "%1 of its %2 frames are damaged and were not measured")(damaged, frames)},
                      Join::Colon));
}

void checkSynchronisation(const RecordingRecord &view, const RecordingRecord &first, const std::string &trial,
                          Checks &checks)
{
    if (Message sentence = clockRateSentence(view, first, view.clockRate); !sentence.isEmpty())
        checks.add(synchronised, CheckLevel::Doubtful,
                   joined({viewInTrialSubject(view.cameraName, trial), std::move(sentence)}, Join::Colon));
    if (Message sentence = stepWarning(trial, view); !sentence.isEmpty())
        checks.add(synchronised, isStepMeasured(view) ? CheckLevel::Doubtful : CheckLevel::Bad,
                   std::move(sentence));
}

void checkRegistration(const RegistrationRecord &registration, const std::string &camera, Checks &checks)
{
    if (intrinsicsSourceOf(registration.assumedIntrinsics, registration.intrinsics != 0) ==
        IntrinsicsSource::Assumed)
        checks.add(lensKnown, CheckLevel::Doubtful,
                   wholeMessage(cameraSubject(camera),
                                ODO_TEXT("workflow.assumed_lens", "its lens was neither calibrated nor "
                                                                  "determined by the floor's markers"),
                                ODO_TEXT("workflow.calibrate_and_reanalyse",
                                         "calibrate the lens, register the camera again and reanalyse")));
    if (registration.lastCheck && registration.lastCheck->outcome == RegistrationCheck::Outcome::CameraMoved)
        checks.add(cameraStill, CheckLevel::Doubtful,
                   wholeMessage(cameraSubject(camera),
                                ODO_TEXT("workflow.moved_since",
                                         "it was found moved by %1 since the registration that was used")(
                                    quantity(registration.lastCheck->shiftPx, 1, "px")),
                                ODO_TEXT("workflow.use_earlier_registration",
                                         "if it moved before this trial, register it again and reanalyse")));
}

/// A view's frames, and what its tracking found: damaged, missing and doubled ones, and that its camera was
/// moved meanwhile.
Result<void> checkRecording(Project &project, const AnalysisRecord &analysis, const RecordingRecord &view,
                            bool isUsed, const std::string &trial, Checks &checks)
{
    const auto series = ODO_TRY(project.trials().currentObservations(view.id, analysis.robot));
    const bool isTracked = isUsed && series;
    std::vector<FrameStep> noted = isTracked ? notedSteps(*series) : std::vector<FrameStep>{};
    checkFrames(view, noted, trial, checks);
    if (!isTracked)
        return {};
    checkDecoding(*series, view, trial, checks);
    std::erase_if(noted, [](const FrameStep &step) { return step.kind == FrameStep::Kind::Fields; });
    for (Message &sentence : stepSentences(trial, view, noted))
        checks.add(framesRegular, CheckLevel::Doubtful, std::move(sentence));
    if (const auto move = storedMove(*series))
        checks.add(cameraStill, CheckLevel::Doubtful, movedSentence(trial, view, *move));
    const RecordId registration = analysis.registrations[std::size_t(view.position)];
    if (const auto shiftPx = notedShift(*series, registration))
        checks.add(cameraStill, CheckLevel::Doubtful, shiftedSentence(trial, view, *shiftPx));
    return {};
}

/// A view that hardly ever found a robot which was in its image: nothing then checks what the others
/// measured.
Result<void> checkSharing(Project &project, const AnalysisRecord &analysis, const RecordingRecord &view,
                          const std::string &trial, Checks &checks)
{
    constexpr double leastShare = 0.3, margin = 0.05; // of the positions; of the image
    constexpr int leastPositions = 10;
    const auto number = std::size_t(view.position);
    if (number >= analysis.registrations.size() || analysis.registrations[number] == 0)
        return {};
    const auto registration = ODO_TRY(project.cameras().registration(analysis.registrations[number]));
    const auto floorView = ODO_TRY(floorViewAt(project, registration, view));
    if (!floorView)
        return {};
    const Eigen::Vector2d size(view.widthPx, view.heightPx);
    const Eigen::AlignedBox2d image(margin * size, (1 - margin) * size);
    int inImage = 0, found = 0;
    for (const Sample &sample : analysis.profile.samples) {
        const auto pixel = isUsed(sample)
                               ? floorView->pixelFromWorld({sample.position->x(), sample.position->y(), 0})
                               : std::nullopt;
        if (!pixel || !image.contains(*pixel))
            continue;
        ++inImage;
        found += int(sample.views >> view.position & 1U);
    }
    if (inImage >= leastPositions && found < leastShare * inImage)
        checks.add(viewsAgree, CheckLevel::Doubtful,
                   joined({viewInTrialSubject(view.cameraName, trial),
                           ODO_TEXT("workflow.hardly_found",
                                    "it found robot '%1' in only %2 of the frames in which it should be "
                                    "visible, and the other positions are not checked by a second view")(
                               Named::robot(analysis.robotName), percent(double(found) / inImage))},
                          Join::Colon));
    return {};
}

/// Whether words are in a message or in what it is put together from.
bool says(const Message &message, std::string_view code)
{
    const auto isIn = [&](const MessageArgument &argument) {
        return std::ranges::any_of(argument.parts, [&](const Message &part) { return says(part, code); });
    };
    return message.code() == code || std::ranges::any_of(message.arguments, isIn);
}

/// Of a track that states no accuracy the scatter is all that can be judged.
Result<void> passScatter(Project &project, const TrialRecord &trial, Checks &checks)
{
    const auto tracks = ODO_TRY(importedTracksOf(project, trial));
    if (std::ranges::any_of(tracks, [](const ImportedTrack &track) {
            return says(track.reading, "workflow.slow_errors_not_seen");
        }))
        checks.pass(positionsPrecise,
                    ODO_TEXT("workflow.passed_scatter",
                             "positions scatter little for the run's extent; errors that change slowly do "
                             "not show, and are covered only where the accuracy of the source is given"));
    return {};
}

void passTheRest(bool isFilmed, std::size_t views, Checks &checks)
{
    checks.pass(resultsIntact, ODO_TEXT("workflow.passed_results", "the stored results are as computed"));
    checks.pass(timeMeasured, ODO_TEXT("workflow.passed_time", "the robots were measured all the time"));
    checks.pass(fewSpikes, ODO_TEXT("workflow.passed_spikes", "few positions are spikes"));
    checks.pass(positionsPrecise,
                ODO_TEXT("workflow.passed_precision", "positions are precise for the run's extent"));
    checks.pass(motionPossible, ODO_TEXT("workflow.passed_motion", "speeds and accelerations are possible"));
    if (!isFilmed)
        return;
    checks.pass(nameKnown, ODO_TEXT("workflow.passed_names", "no robot could be another one"));
    checks.pass(framesRegular, ODO_TEXT("workflow.passed_frames", "the frames came at regular intervals"));
    checks.pass(framesDecoded, ODO_TEXT("workflow.passed_decoding", "all frames could be decoded"));
    checks.pass(lensKnown, ODO_TEXT("workflow.passed_lens",
                                    "the lenses are calibrated, or estimated from the floor's markers"));
    checks.pass(cameraStill, ODO_TEXT("workflow.passed_cameras", "no camera was found moved"));
    if (views < 2)
        return;
    checks.pass(viewsAgree, ODO_TEXT("workflow.passed_views", "the views agree"));
    checks.pass(synchronised, ODO_TEXT("workflow.passed_synchronisation", "the views are synchronised"));
}

/// An analysis as it was stored, with why its views contradict each other: that is found once more from the
/// stored observations. nullopt where it is known, where they agree and where it cannot be found.
Result<std::optional<AnalysisRecord>>
withContradiction(Project &project, const AnalysisRecord &analysis,
                  const std::vector<const RecordingRecord *> &recordings)
{
    const Profile &profile = analysis.profile;
    if (profile.contradiction || viewsApart(profile.samples).apartM.empty() ||
        recordings.size() != analysis.registrations.size())
        return std::nullopt;
    std::vector<ViewTrack> views;
    for (std::size_t v = 0; v < recordings.size(); ++v) {
        const RecordingRecord &recording = *recordings[v];
        ViewTrack view{recording.cameraName, {}, fromSeconds(recording.startOffsetS), {}};
        view.clockRate = recording.clockRate;
        view.startOffsetSigmaS = recording.startOffsetSigmaS;
        if (analysis.registrations[v] != 0) {
            const auto registration = ODO_TRY(project.cameras().registration(analysis.registrations[v]));
            view.floorView = ODO_TRY(floorViewAt(project, registration, recording));
        }
        auto series = ODO_TRY(project.trials().currentObservations(recording.id, analysis.robot));
        const auto shiftPx =
            series ? notedShift(*series, analysis.registrations[v]) : std::optional<double>();
        if (shiftPx && view.floorView)
            view.floorView = widenedByShift(*view.floorView, *shiftPx);
        if (series)
            view.observations = std::move(series->observations);
        views.push_back(std::move(view));
    }
    const auto robot = ODO_TRY(project.robots().get(analysis.robot));
    RobotShape shape = shapeOf(robot);
    shape.heightM = profile.heightEstimated ? std::nullopt : std::optional(profile.heightM);
    auto contradiction = contradictionOf(views, shape);
    if (!contradiction)
        return std::nullopt;
    AnalysisRecord known = analysis;
    known.profile.contradiction = std::move(contradiction);
    return known;
}

} // namespace

Result<TrialVerdict> verdictOn(Project &project, const TrialRecord &trial,
                               const std::vector<const RecordingRecord *> &recordings,
                               const std::vector<AnalysisRecord> &analyses)
{
    if (analyses.empty())
        return TrialVerdict{};
    Checks checks;
    for (const AnalysisRecord &analysis : analyses) {
        const auto known = ODO_TRY(withContradiction(project, analysis, recordings));
        checkAnalysis(known ? *known : analysis, trial.name, checks);
    }
    const std::vector<std::size_t> used = usedViews(analyses.front(), recordings.size());
    for (std::size_t view = 0; view < recordings.size(); ++view) {
        const bool isUsed = std::ranges::find(used, view) != used.end();
        ODO_TRY(checkRecording(project, analyses.front(), *recordings[view], isUsed, trial.name, checks));
    }
    for (const std::size_t view : used) {
        const auto registration =
            ODO_TRY(project.cameras().registration(analyses.front().registrations[view]));
        checkRegistration(registration, recordings[view]->cameraName, checks);
        for (const AnalysisRecord &analysis : analyses)
            if (used.size() > 1 && !analysis.profile.samples.empty())
                ODO_TRY(checkSharing(project, analysis, *recordings[view], trial.name, checks));
    }
    for (std::size_t i = 0; used.size() > 1 && i < used.size(); ++i)
        checkSynchronisation(*recordings[used[i]], *recordings.front(), trial.name, checks);
    ODO_TRY(passScatter(project, trial, checks));
    passTheRest(!recordings.empty(), used.size(), checks);
    TrialVerdict verdict = checks.take();
    verdict.acceptance = ODO_TRY(project.verdicts().acceptance(trial.id));
    return verdict;
}

} // namespace odo
