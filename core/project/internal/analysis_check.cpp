// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/analysis_check.h"

#include "core/analysis/metrics.h"
#include "core/analysis/task_metrics.h"
#include "core/base/error.h"
#include "core/geometry/floor_view.h"
#include "core/project/internal/analysis_digest.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/words.h"
#include "core/project/project_words.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace odo {

namespace {

// what rounding leaves is less by far, what anybody notices is more
constexpr double relativeDifference = 1e-6;

Message restoreOrTrackAgain()
{
    return ODO_TEXT("project.restore_or_track_again",
                    "restore the project from a backup copy, or track the trial again");
}

Message wordsOf(DigestPart part, const std::string &name)
{
    const MessageArgument robot = Named::robot(name);
    switch (part) {
    case DigestPart::Measurements:
        return ODO_TEXT("project.measurements_changed",
                        "the measurements have changed since robot '%1' was analysed")(robot);
    case DigestPart::Recordings:
        return ODO_TEXT("project.recordings_changed",
                        "the recordings or their synchronisation have changed since robot '%1' was analysed")(
            robot);
    case DigestPart::Registrations:
        return ODO_TEXT("project.registrations_changed",
                        "the registrations have changed since robot '%1' was analysed")(robot);
    case DigestPart::Task:
        return ODO_TEXT("project.task_changed", "the task has changed since robot '%1' was analysed")(robot);
    case DigestPart::Positions:
        return ODO_TEXT("project.positions_changed",
                        "the stored positions of robot '%1' differ from those of its analysis")(robot);
    case DigestPart::Results:
        return ODO_TEXT(
            "project.results_changed",
            "the stored metrics, spikes or settings of robot '%1' differ from those of its analysis")(robot);
    }
    return {};
}

bool differ(double a, double b)
{
    return std::abs(a - b) > relativeDifference * std::max({std::abs(a), std::abs(b), 1e-3});
}

MessageArgument withUnit(double value, const Metric &metric)
{
    return quantity(value, 6, metric.unit == "1" ? "" : metric.unit);
}

/// Checks one trial after the other, with what they share.
class AnalysisCheck
{
public:
    AnalysisCheck(Project &project, const ProjectConnection &connection, bool isThorough,
                  std::vector<ProjectProblem> &problems)
        : m_project(project), m_connection(connection), m_isThorough(isThorough), m_problems(problems),
          m_digests(connection)
    {
    }

    Result<void> prepare();
    Result<void> look(const TrialName &trial);

private:
    struct Measured
    {
        RecordId recording = 0, robot = 0; ///< recording 0: an imported track
    };
    struct Newest
    {
        RecordId analysis = 0, robot = 0;
        std::string robotName;
    };
    void report(Message what, Message advice)
    {
        m_problems.push_back({std::move(what), m_where, std::move(advice)});
    }
    void report(const Error &error, Message advice)
    {
        report(wholeMessage(error.what, error.why), std::move(advice));
    }
    struct Proved
    {
        std::set<RecordId> measured, analysed; ///< robots
    };
    Result<void> compareDigests(const Newest &newest, Proved &proved);
    void checkMeasurements(const TrialName &trial);
    void checkObservations(const RecordingRecord &recording, RecordId robot);
    void checkMetrics(const TrialName &trial);
    void compareMetrics(const AnalysisRecord &analysis);

    Project &m_project;
    const ProjectConnection &m_connection;
    const bool m_isThorough;
    std::vector<ProjectProblem> &m_problems;
    AnalysisDigests m_digests;
    std::map<RecordId, std::vector<Newest>> m_newest;     ///< by trial
    std::map<RecordId, std::vector<Measured>> m_measured; ///< by trial
    std::map<RecordId, std::string> m_robotNames;
    std::map<RecordId, TaskRecord> m_tasks;
    /// analyses made with other manual overrides than their trial has now
    std::set<RecordId> m_overriddenSince;
    std::set<RecordId> m_otherRange; ///< analyses of another range than their trial has
    std::set<RecordId> m_changed;    ///< analyses of the trial whose results differ from their digests
    Message m_where;
};

/// Reads of all trials which robots were measured and analysed, and with which manual overrides.
Result<void> AnalysisCheck::prepare()
{
    Statement newest(
        m_connection,
        QStringLiteral("SELECT trial_id, MAX(analysis.id), robot_id, robot.name FROM analysis JOIN robot "
                       "ON robot.id=robot_id GROUP BY trial_id, robot_id"));
    auto read = newest.eachRow([this](const Statement &row) -> Result<void> {
        m_newest[row.integer(0)].push_back({row.integer(1), row.integer(2), row.text(3)});
        return {};
    });
    if (!read)
        return read;
    Statement measured(
        m_connection,
        QStringLiteral(
            "SELECT DISTINCT trial_id, recording_id, robot_id FROM observation_series JOIN recording "
            "ON recording.id=recording_id UNION SELECT DISTINCT trial_id, 0, robot_id FROM imported_track"));
    read = measured.eachRow([this](const Statement &row) -> Result<void> {
        m_measured[row.integer(0)].push_back({row.integer(1), row.integer(2)});
        return {};
    });
    if (!read)
        return read;
    Statement overridden(
        m_connection,
        QStringLiteral(
            "WITH newest AS (SELECT MAX(id) AS id, trial_id, robot_id FROM analysis GROUP BY trial_id, "
            "robot_id), "
            "used AS (SELECT id, frame, is_spike FROM analysis_overrule JOIN newest ON id=analysis_id), "
            "now AS (SELECT id, frame, is_spike FROM overrule JOIN newest USING (trial_id, robot_id)) "
            "SELECT id FROM (SELECT * FROM now EXCEPT SELECT * FROM used) UNION "
            "SELECT id FROM (SELECT * FROM used EXCEPT SELECT * FROM now)"));
    read = overridden.eachRow([this](const Statement &row) -> Result<void> {
        m_overriddenSince.insert(row.integer(0));
        return {};
    });
    if (!read)
        return read;
    Statement ranged(
        m_connection,
        QStringLiteral(
            "SELECT analysis.id FROM analysis JOIN trial ON trial.id=trial_id WHERE analysis.id IN "
            "(SELECT MAX(id) FROM analysis GROUP BY trial_id, robot_id) AND "
            "(analysis.range_from_ns IS NOT trial.range_from_ns OR "
            "analysis.range_to_ns IS NOT trial.range_to_ns)"));
    read = ranged.eachRow([this](const Statement &row) -> Result<void> {
        m_otherRange.insert(row.integer(0));
        return {};
    });
    if (!read)
        return read;
    const auto robots = m_project.robots().all();
    for (const RobotRecord &robot : robots.value_or(std::vector<RobotRecord>()))
        m_robotNames[robot.id] = robot.name;
    const auto tasks = m_project.tasks().all();
    for (const TaskRecord &task : tasks.value_or(std::vector<TaskRecord>()))
        m_tasks[task.id] = task;
    return {};
}

Result<void> AnalysisCheck::compareDigests(const Newest &newest, Proved &proved)
{
    const auto outcome = ODO_TRY(m_digests.compare(newest.analysis, allDigestParts));
    for (const DigestPart part : outcome.changed)
        report(wordsOf(part, newest.robotName), restoreOrTrackAgain());
    if (!outcome.isKept)
        return {};
    const auto holds = [&](DigestPart part) {
        return std::ranges::find(outcome.changed, part) == outcome.changed.end();
    };
    if (holds(DigestPart::Measurements))
        proved.measured.insert(newest.robot);
    if (std::ranges::all_of(shownDigestParts, holds))
        proved.analysed.insert(newest.robot);
    else
        m_changed.insert(newest.analysis);
    return {};
}

Result<void> AnalysisCheck::look(const TrialName &trial)
{
    m_where = trialSubject(trial.name);
    m_changed.clear();
    Proved proved;
    for (const Newest &newest : m_newest[trial.id]) {
        ODO_TRY(compareDigests(newest, proved));
        if (m_overriddenSince.contains(newest.analysis))
            report(ODO_TEXT("project.overrides_changed",
                            "the manual overrides have changed since robot '%1' was analysed")(
                       Named::robot(newest.robotName)),
                   restoreOrTrackAgain());
        if (m_otherRange.contains(newest.analysis))
            report(ODO_TEXT("project.range_changed",
                            "the trial's range has changed since robot '%1' was analysed")(
                       Named::robot(newest.robotName)),
                   restoreOrTrackAgain());
    }
    if (m_isThorough || !std::ranges::all_of(m_measured[trial.id], [&](const Measured &one) {
            return proved.measured.contains(one.robot);
        }))
        checkMeasurements(trial);
    if (m_isThorough || !std::ranges::all_of(m_newest[trial.id], [&](const Newest &one) {
            return proved.analysed.contains(one.robot);
        }))
        checkMetrics(trial);
    return {};
}

void AnalysisCheck::checkMeasurements(const TrialName &trial)
{
    const auto recordings = m_project.trials().recordings(trial.id);
    if (!recordings)
        return report(recordings.error(), restoreProject());
    for (const Measured &measured : m_measured[trial.id]) {
        const auto recording = std::ranges::find(*recordings, measured.recording, &RecordingRecord::id);
        if (recording != recordings->end()) {
            checkObservations(*recording, measured.robot);
            continue;
        }
        if (const auto track = m_project.trials().currentImportedTrack(trial.id, measured.robot); !track)
            report(track.error(), restoreProject());
    }
}

void AnalysisCheck::checkObservations(const RecordingRecord &recording, RecordId robot)
{
    const auto series = m_project.trials().currentObservations(recording.id, robot);
    if (!series)
        return report(series.error(), trackTrialAgain());
    if (!*series)
        return;
    const auto frames = static_cast<std::int64_t>(recording.frameTimes.size());
    const auto &observations = (*series)->observations;
    const bool outside = std::ranges::any_of(
        observations, [frames](const Observation &o) { return o.frame < 0 || o.frame >= frames; });
    if (outside || static_cast<std::int64_t>(observations.size()) > frames)
        report(ODO_TEXT("project.observations_do_not_fit",
                        "view '%1' has %2 frames, but the observations of '%3' (%4) do not fit them")(
                   Named::camera(recording.cameraName), frames, Named::robot(m_robotNames[robot]),
                   observations.size()),
               trackTrialAgain());
}

void AnalysisCheck::checkMetrics(const TrialName &trial)
{
    const auto analyses = m_project.analyses().current(trial.id);
    if (!analyses)
        return report(analyses.error(), trackTrialAgain());
    for (const AnalysisRecord &analysis : *analyses) {
        // What another version computed otherwise, and stored with a digest that is right, nobody has
        // changed.
        const bool isRight =
            analysis.proof != AnalysisRecord::Proof::NotKept && !m_changed.contains(analysis.id);
        if (!isRight || analysis.softwareVersion == ODOGRAPH_VERSION)
            compareMetrics(analysis);
    }
}

void AnalysisCheck::compareMetrics(const AnalysisRecord &analysis)
{
    const Profile &profile = analysis.profile;
    std::vector<Metric> computed = measureRun(profile.samples, profile.points);
    if (const auto task = m_tasks.find(analysis.task); task != m_tasks.end()) {
        const TaskMetrics metrics = measureTask(task->second.task, profile.samples, profile.points);
        computed.insert(computed.end(), metrics.metrics.begin(), metrics.metrics.end());
    }
    const MessageArgument robot = Named::robot(analysis.robotName);
    for (const Metric &stored : profile.metrics) {
        const auto its = std::ranges::find(computed, stored.name, &Metric::name);
        if (its == computed.end())
            report(ODO_TEXT("project.metric_without_source",
                            "metric '%1' of robot '%2' is stored, but its positions give none")(stored.name,
                                                                                                robot),
                   trackTrialAgain());
        else if (stored.unit != its->unit || differ(stored.value, its->value))
            report(ODO_TEXT("project.metric_differs",
                            "metric '%1' of robot '%2' is stored as %3, its positions give %4")(
                       stored.name, robot, withUnit(stored.value, stored), withUnit(its->value, *its)),
                   trackTrialAgain());
        else if (stored.sigma.has_value() != its->sigma.has_value() ||
                 differ(stored.sigma.value_or(0), its->sigma.value_or(0)))
            report(
                ODO_TEXT("project.metric_sigma_differs",
                         "the standard deviation of metric '%1' of robot '%2' is stored as %3, its positions "
                         "give %4")(stored.name, robot, withUnit(stored.sigma.value_or(0), stored),
                                    withUnit(its->sigma.value_or(0), *its)),
                trackTrialAgain());
    }
    if (!m_changed.contains(analysis.id))
        return; // a metric that an older version did not know yet is missing rightly
    for (const Metric &metric : computed) {
        if (std::ranges::find(profile.metrics, metric.name, &Metric::name) == profile.metrics.end())
            report(ODO_TEXT("project.metric_missing",
                            "metric '%1' of robot '%2' is missing, its positions give %3")(
                       metric.name, robot, withUnit(metric.value, metric)),
                   trackTrialAgain());
    }
}

} // namespace

Result<void> checkAnalyses(Project &project, const ProjectConnection &connection, bool isThorough,
                           const JobControl &control, std::vector<ProjectProblem> &problems)
{
    const auto trials = ODO_TRY(project.trials().names());
    AnalysisCheck check(project, connection, isThorough, problems);
    ODO_TRY(check.prepare());
    double done = 0;
    for (const TrialName &trial : trials) {
        if (control.isCancelled())
            return cancelled(projectCheck());
        control.report(done++ / double(trials.size()),
                       ODO_TEXT("project.checking", "checking %1")(Named::trial(trial.name)));
        if (trial.unfinished)
            continue;
        if (auto looked = check.look(trial); !looked)
            problems.push_back({wholeMessage(looked.error().what, looked.error().why),
                                trialSubject(trial.name), trackTrialAgain()});
    }
    return {};
}

namespace {

bool isOther(double a, double b)
{
    constexpr double relative = 1e-6; // rounding leaves far less, and nobody notices so little
    return std::abs(a - b) > relative * std::max({std::abs(a), std::abs(b), 1e-3});
}

/// The last of packed frame times; nothing where they cannot be read, which other checks report.
std::optional<Nanoseconds> lastOf(const QByteArray &packedTimes)
{
    std::vector<Nanoseconds> times;
    if (!unpackTimes(packedTimes, {}, times) || times.empty())
        return std::nullopt;
    return times.back();
}

/// The last time of the newest imported tracks of a trial.
std::optional<Nanoseconds> endOfTracks(const ProjectConnection &connection, RecordId trial)
{
    Statement last(
        connection,
        QStringLiteral("SELECT samples FROM imported_track_chunk AS chunk WHERE track_id IN "
                       "(SELECT MAX(id) FROM imported_track WHERE trial_id=? GROUP BY robot_id) AND position="
                       "(SELECT MAX(position) FROM imported_track_chunk WHERE track_id=chunk.track_id)"));
    std::optional<Nanoseconds> end;
    const auto read = last.bind(trial).eachRow([&end](const Statement &row) -> Result<void> {
        std::vector<Sample> samples;
        ODO_TRY(unpackSamples(row.blob(0), {}, samples));
        if (!samples.empty())
            end = std::max(end.value_or(Nanoseconds(0)), samples.back().time);
        return {};
    });
    return read ? end : std::nullopt;
}

Result<void> checkTrials(const ProjectConnection &connection, std::vector<ProjectProblem> &problems)
{
    Statement trials(
        connection,
        QStringLiteral("SELECT trial.id, trial.name, duration_s, first.id, trial.sync_method, sync_offset_s, "
                       "sync_offset_sigma_s, sync_rate, "
                       "second.id, second.sync_method, second.start_offset_s, second.start_offset_sigma_s, "
                       "second.clock_rate, "
                       "(SELECT times FROM frame_time_chunk WHERE recording_id=first.id ORDER BY position "
                       "DESC LIMIT 1) FROM trial "
                       "LEFT JOIN recording AS first ON first.trial_id=trial.id AND first.position=0 "
                       "LEFT JOIN recording AS second ON second.trial_id=trial.id AND second.position=1 "
                       "WHERE state='complete' ORDER BY trial.id"));
    return trials.eachRow([&](const Statement &row) -> Result<void> {
        const Message where = trialSubject(row.name(1));
        const bool isRecorded = row.integer(3) != 0;
        const double durationS = row.real(2);
        const auto end = isRecorded ? lastOf(row.blob(13)) : endOfTracks(connection, row.integer(0));
        if (end && isOther(durationS, toSeconds(*end)))
            problems.push_back(
                {(isRecorded ? ODO_TEXT("project.duration_of_recordings_differs",
                                        "its duration is stored as %1, its recordings last %2")
                             : ODO_TEXT("project.duration_of_tracks_differs",
                                        "its duration is stored as %1, its imported tracks last %2"))(
                     quantity(durationS, 3, "s"), quantity(toSeconds(*end), 3, "s")),
                 where, restoreProject()});
        // then offset, its standard deviation and rate of the trial and of its second view
        constexpr int method = 4, secondId = 8;
        const bool hasSecond = row.integer(secondId) != 0;
        bool isSame = hasSecond ? row.text(method) == row.text(secondId + 1)
                                : row.text(method).empty() || row.text(method) == "none";
        for (int figure = 1; figure <= 3; ++figure)
            isSame = isSame &&
                     !isOther(row.real(method + figure), hasSecond ? row.real(secondId + 1 + figure) : 0);
        if (!isSame)
            problems.push_back(
                {hasSecond ? ODO_TEXT("project.synchronisation_differs",
                                      "its stored synchronisation differs from that of its second view")
                           : ODO_TEXT("project.synchronisation_of_one_view",
                                      "a synchronisation is stored, but it has no second view"),
                 where, restoreProject()});
        return {};
    });
}

double rmsOf(const std::vector<MarkerError> &markers, double MarkerError::*error)
{
    double squares = 0;
    for (const MarkerError &marker : markers)
        squares += marker.*error * marker.*error;
    return std::sqrt(squares / static_cast<double>(markers.size()));
}

/// The errors of its markers by pose, lens and layout; empty where one cannot be computed.
std::vector<MarkerError> computedErrors(const RegistrationRecord &record, Intrinsics lens,
                                        const MarkerLayout &layout)
{
    const auto camera = CameraModel::create(std::move(lens));
    if (!camera)
        return {};
    const FloorView view(*camera, record.registration.worldFromCamera, record.registration.poseCovariance);
    std::vector<MarkerError> computed;
    for (const MarkerError &stored : record.registration.markers) {
        const auto location = std::ranges::find(layout.markers, stored.label, &Marker::label);
        const auto seen = std::ranges::find(record.pixels, stored.label, &MarkerPixel::label);
        if (location == layout.markers.end() || seen == record.pixels.end())
            return {};
        const auto floor = view.floorFromPixel(seen->pixel, 0);
        const auto back = view.pixelFromWorld({location->pointInWorld.x(), location->pointInWorld.y(), 0});
        if (!floor || !back)
            return {};
        computed.push_back(
            {stored.label, (*floor - location->pointInWorld).norm(), (*back - seen->pixel).norm()});
    }
    return computed;
}

/// Either the RMS fits the errors, or the errors fit the markers. A joint registration leaves uncertain
/// markers out of its RMS, and its pixel errors refer to markers that it moved; after the axes were changed,
/// an older registration no longer fits the layout.
bool fitsItsMarkers(const FloorRegistration &registration, const std::vector<MarkerError> &computed)
{
    const auto isComputed = [&](double MarkerError::*error) {
        return std::ranges::equal(
            registration.markers, computed,
            [error](const MarkerError &a, const MarkerError &b) { return !isOther(a.*error, b.*error); });
    };
    if (isOther(registration.rmsM, rmsOf(registration.markers, &MarkerError::errorM)))
        return isComputed(&MarkerError::errorM);
    return !isOther(registration.rmsPx, rmsOf(registration.markers, &MarkerError::errorPx)) ||
           isComputed(&MarkerError::errorPx);
}

void checkRegistration(Project &project, const CameraRecord &camera, std::vector<ProjectProblem> &problems)
{
    const auto record = project.cameras().currentRegistration(camera.id);
    // one that cannot be read is reported elsewhere
    if (!record || !*record || (*record)->registration.markers.empty())
        return;
    const auto layout = project.layouts().get((*record)->layout);
    const auto intrinsics = project.cameras().allIntrinsics(camera.id);
    if (!layout || !intrinsics)
        return;
    const auto used = std::ranges::find(*intrinsics, (*record)->intrinsics, &IntrinsicsRecord::id);
    const Intrinsics &lens =
        used != intrinsics->end() ? used->calibration.intrinsics : (*record)->assumedIntrinsics;
    if (!fitsItsMarkers((*record)->registration, computedErrors(**record, lens, layout->layout)))
        problems.push_back(
            {ODO_TEXT("project.marker_errors_differ",
                      "the stored marker errors of registration %1 differ from those of its markers")(
                 (*record)->id),
             cameraSubject(camera.name),
             ODO_TEXT("project.restore_or_register_again",
                      "restore the project from a backup copy, or register the camera again")});
}

/// That what is in force of a camera is its own. table: of revisions. words: with the number of one and the
/// camera that it belongs to.
Result<void> checkChoices(const ProjectConnection &connection, const char *table, const MessageText &words,
                          std::vector<ProjectProblem> &problems)
{
    Statement choices(
        connection,
        QStringLiteral("SELECT camera.name, chosen.id, owner.name FROM camera JOIN %1 AS chosen ON "
                       "chosen.id=camera.%1_id "
                       "JOIN camera AS owner ON owner.id=chosen.camera_id WHERE owner.id<>camera.id")
            .arg(QLatin1String(table)));
    return choices.eachRow([&](const Statement &row) -> Result<void> {
        problems.push_back(
            {words(row.integer(1), Named::camera(row.name(2))), cameraSubject(row.name(0)),
             ODO_TEXT("project.choose_its_own",
                      "choose one of its own (odograph revisions P.odo CAMERA --use), or restore "
                      "the project from a backup copy")});
        return {};
    });
}

} // namespace

Result<void> checkDerivedMetrics(Project &project, const ProjectConnection &connection,
                                 std::vector<ProjectProblem> &problems)
{
    ODO_TRY(checkTrials(connection, problems));
    if (auto checked = checkChoices(
            connection, "intrinsics",
            ODO_TEXT(
                "project.others_calibration_chosen",
                "calibration %1 was chosen for it but belongs to camera '%2'; its own newest one is used"),
            problems);
        !checked)
        return checked;
    if (auto checked = checkChoices(
            connection, "registration",
            ODO_TEXT(
                "project.others_registration_chosen",
                "registration %1 was chosen for it but belongs to camera '%2'; its own newest one is used"),
            problems);
        !checked)
        return checked;
    const auto cameras = ODO_TRY(project.cameras().all());
    for (const CameraRecord &camera : cameras)
        checkRegistration(project, camera, problems);
    return {};
}

} // namespace odo
