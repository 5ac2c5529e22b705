// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/scoring.h"
#include "core/project/records.h"
#include "core/trajectory/imported_track.h"
#include "core/video/frame_times.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct ProjectConnection; ///< the open database; private to core/project

/// All repositories: plain synchronous calls on the project's thread. `find…` gives NotFound with a message
/// that names what there is instead; `add` gives AlreadyExists for a name that is taken, and the stored
/// record with its id.

class CameraRepository
{
public:
    explicit CameraRepository(ProjectConnection &connection);
    Result<CameraRecord> add(const CameraRecord &camera);
    Result<std::vector<CameraRecord>> all() const;
    Result<CameraRecord> find(const std::string &name) const;
    Result<CameraRecord> get(RecordId id) const;
    /// The address of the device that it is; empty: none.
    Result<void> setDevice(RecordId camera, const std::string &uri);
    /// Removes a camera that nothing refers to; fails for any other.
    Result<void> removeUnused(RecordId id);
    Result<IntrinsicsRecord> addIntrinsics(const IntrinsicsRecord &intrinsics);
    /// The one in force: the newest, unless another was chosen since. nullopt when the camera was never
    /// calibrated.
    Result<std::optional<IntrinsicsRecord>> currentIntrinsics(RecordId camera) const;
    /// Every calibration and import, the newest first.
    Result<std::vector<IntrinsicsRecord>> allIntrinsics(RecordId camera) const;
    Result<IntrinsicsRecord> intrinsics(RecordId id) const;
    Result<RegistrationRecord> addRegistration(const RegistrationRecord &registration);
    Result<std::optional<RegistrationRecord>> currentRegistration(RecordId camera) const;
    /// Every registration, the newest first.
    Result<std::vector<RegistrationRecord>> allRegistrations(RecordId camera) const;
    Result<RegistrationRecord> registration(RecordId id) const;
    /// Puts a revision in force again until the next one is added. NotFound for an id that is not there.
    Result<void> chooseIntrinsics(RecordId intrinsics);
    Result<void> chooseRegistration(RecordId registration);
    Result<void> addCheck(RecordId registration, const RegistrationCheck &check);

private:
    ProjectConnection &m_connection;
};

class LayoutRepository
{
public:
    explicit LayoutRepository(ProjectConnection &connection);
    Result<LayoutRecord> add(const MarkerLayout &layout);
    Result<std::vector<LayoutRecord>> all() const;
    Result<LayoutRecord> find(const std::string &name) const;
    Result<LayoutRecord> get(RecordId id) const;
    /// Moves the markers; the labels and their order must be the stored ones.
    Result<void> setPoints(const LayoutRecord &layout);

private:
    ProjectConnection &m_connection;
};

class RobotRepository
{
public:
    explicit RobotRepository(ProjectConnection &connection);
    Result<RobotRecord> add(const RobotRecord &robot);
    Result<std::vector<RobotRecord>> all() const;
    Result<RobotRecord> find(const std::string &name) const;
    Result<RobotRecord> get(RecordId id) const;
    /// Gives the robot of that id another name, colour, drawing colour, height or size; what was measured
    /// before stays as it is. AlreadyExists for a name that another robot has.
    Result<void> set(const RobotRecord &robot);
    /// InvalidInput where a trial has it. Teams lose it.
    Result<void> remove(RecordId robot);

private:
    ProjectConnection &m_connection;
};

class TeamRepository
{
public:
    explicit TeamRepository(ProjectConnection &connection);
    Result<TeamRecord> add(const TeamRecord &team);
    Result<std::vector<TeamRecord>> all() const;
    Result<TeamRecord> find(const std::string &name) const;
    /// Gives the team of that id another name, class (empty: none), pseudonym, other members or robots.
    /// AlreadyExists for a name that another team has, NotFound for a robot that is not there.
    Result<void> set(const TeamRecord &team);
    /// InvalidInput where a trial is its.
    Result<void> remove(RecordId team);
    /// Every class, in alphabetical order.
    Result<std::vector<std::string>> classes() const;

private:
    ProjectConnection &m_connection;
};

/// What depends on a task.
struct TaskUse
{
    int trials = 0;   ///< that have it, those in the bin too
    int analyses = 0; ///< that were measured by it
};
/// Whether a task is kept for analyses alone, as it was before it was changed: no trial has it, and it has
/// the name that TaskRepository::change gives.
bool isEarlierVersion(const TaskRecord &task, const TaskUse &use);

class TaskRepository
{
public:
    explicit TaskRepository(ProjectConnection &connection);
    /// InvalidInput for a task that cannot be measured (checkTask).
    Result<TaskRecord> add(const TaskRecord &task);
    Result<std::vector<TaskRecord>> all() const;
    Result<TaskRecord> find(const std::string &name) const;
    Result<TaskRecord> get(RecordId id) const;
    /// Those that nothing depends on are not in it.
    Result<std::map<RecordId, TaskUse>> uses() const;
    /// Tasks to choose from: without those that are archived or kept for analyses alone.
    Result<std::vector<TaskRecord>> current() const;
    Result<void> rename(RecordId task, const std::string &name);
    /// Out of the way, or back again; its trials stay as they are.
    Result<void> setArchived(RecordId task, bool archived);
    /// Gives a task another course; name, archive and scoring stay. A task is never altered in place: a
    /// new one takes over its name and its trials. Where analyses used the one before, it is kept
    /// for them as "NAME (version 1)", so that they stay true; else it goes. Gives the stored task, with
    /// another id unless nothing was to change.
    Result<TaskRecord> change(const TaskRecord &task);
    /// InvalidInput where a trial has it or an analysis was measured by it.
    Result<void> remove(RecordId task);
    /// How runs of the task are scored; empty: they are not.
    Result<std::vector<Criterion>> scoring(RecordId task) const;
    /// Replaces it. InvalidInput for one that cannot be computed (checkScoring).
    Result<void> setScoring(RecordId task, const std::vector<Criterion> &criteria);
    /// Of every task that is scored.
    Result<std::map<RecordId, std::vector<Criterion>>> scorings() const;

private:
    Result<void> moveAll(RecordId from, RecordId to);
    ProjectConnection &m_connection;
};

class TrialRepository
{
public:
    explicit TrialRepository(ProjectConnection &connection);
    /// A task of a name that is new becomes one without gates, path and limits.
    Result<TrialRecord> add(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings);
    /// As add, of a trial whose recording begins now: its files need not be there yet, and its frame times
    /// come later.
    Result<TrialRecord> begin(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings);
    /// More of a view's raw times, of a trial that is unfinished. They are kept for ever.
    Result<void> appendRawTimes(RecordId recording, const RecordedTimes &times);
    /// Empty for a recording that was imported.
    Result<RecordedTimes> rawTimes(RecordId recording) const;
    /// How long it has been recorded by now.
    Result<void> setDuration(RecordId trial, double durationS);
    /// Ends the recording: what is known now about the trial's sync and duration and about its recordings, by
    /// their ids. Of a recording that is not among them nothing came; its row goes. InvalidInput for a trial
    /// that is finished.
    Result<void> complete(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings);
    /// Of trials that have ended, those whose file's hash has not been made yet; their frame times are left
    /// out.
    Result<std::vector<RecordingRecord>> unhashed() const;
    Result<void> setHash(RecordId recording, const std::string &sha256);
    /// Corrects the frame times of finished recordings, and with those of a first view the trial's duration.
    Result<void> setFrameTimes(const std::vector<RecordingRecord> &recordings);
    /// Removes an unfinished trial: of one that was abandoned, or of which no frame was recorded.
    Result<void> removeUnfinished(RecordId trial);
    Result<std::vector<TrialRecord>> all() const; ///< newest first
    /// The next of them, after the last one of the page before (nullptr: the first page): count, and those of
    /// the same moment as the last. Empty at the end. For lists of thousands, which are read piece by piece.
    Result<std::vector<TrialRecord>> page(const TrialRecord *after, int count) const;
    Result<std::vector<TrialName>> names() const; ///< of all trials, newest first; cheap
    Result<TrialRecord> find(const std::string &name) const;
    Result<TrialRecord> get(RecordId id) const;
    /// AlreadyExists for a name that another trial has.
    Result<void> setName(RecordId trial, const std::string &name);
    /// 0: none.
    Result<void> setTeam(RecordId trial, RecordId team);
    Result<void> setDate(RecordId trial, Instant date);
    Result<void> setNotes(RecordId trial, const std::string &notes);
    Result<void> setRobots(RecordId trial, const std::vector<RecordId> &robots);
    /// By name; empty: none. Analyses that were made before stay.
    Result<void> setTask(RecordId trial, const std::string &task);
    /// Of a trial alone; its analyses keep theirs (RangeJob sets both). Empty: all of its time.
    Result<void> setRange(RecordId trial, const std::optional<TimeSpan> &range);
    Result<void> setStarred(RecordId trial, bool starred);
    /// Replaces its tags; each a name, in any order.
    Result<void> setTags(RecordId trial, const std::vector<std::string> &tags);
    /// Replaces its variables: names, and values of one line that are not empty.
    Result<void> setVariables(RecordId trial, const std::map<std::string, std::string> &variables);
    /// Every tag that a trial has, in alphabetical order.
    Result<std::vector<std::string>> tags() const;
    Result<void> setArchived(RecordId trial, bool archived);
    /// Into the bin, or out of it again.
    Result<void> setBinned(RecordId trial, bool binned);
    /// Removes a trial that lies in the bin for good, with its recordings' rows, observations and analyses;
    /// gives the paths of its recordings' files, which are for the caller to delete. It cannot be undone.
    /// InvalidInput outside of the bin.
    Result<std::vector<std::string>> removeForGood(RecordId trial);
    /// How much the recordings of the trials in the bin take on the disk.
    Result<std::int64_t> binnedBytes() const;
    /// Whether any trial has a recording in a file, by its path as recordings have it.
    Result<bool> isFileUsed(const std::string &path) const;
    Result<std::vector<RecordingRecord>> recordings(RecordId trial) const; ///< in the order of the views
    /// Those of all trials, without their frame times. Thousands take their time.
    Result<std::vector<RecordingRecord>> allRecordings() const;
    /// The newest one of a camera outside of the bin; nullopt where it has none.
    Result<std::optional<RecordingRecord>> newestRecording(RecordId camera) const;
    /// Where a recording's file lies now; what it is stays as it was stored.
    Result<void> setFile(RecordId recording, const std::filesystem::path &file);
    /// Replaces how the views are synchronised, the trial's and its recordings'.
    Result<void> setSync(const TrialRecord &trial, const std::vector<RecordingRecord> &recordings);
    /// A new series for a recording and robot joins the older ones; the newest in force is the current one.
    /// Undoing the change takes it out of force: it stays in the project.
    Result<void> addObservations(const ObservationSeries &series);
    /// asTracked: the newest that was not corrected by hand.
    Result<std::optional<ObservationSeries>> currentObservations(RecordId recording, RecordId robot,
                                                                 bool asTracked = false) const;
    /// Its algorithm alone; cheap.
    Result<std::optional<std::string>> currentAlgorithm(RecordId recording, RecordId robot) const;
    /// Manual overrides of samples of a robot; replaces the previous ones. At most one a frame.
    Result<void> setManualOverrides(RecordId trial, RecordId robot,
                                    const std::vector<ManualOverride> &overrides);
    /// In order of the frames.
    Result<std::vector<ManualOverride>> overrides(RecordId trial, RecordId robot) const;
    /// Where a person marked robots in the frames of a trial; replaces the previous marks. At most
    /// one a robot, recording and frame.
    Result<void> setPointedOut(RecordId trial, const std::vector<PointedOutRobot> &robots);
    Result<std::vector<PointedOutRobot>> pointedOut(RecordId trial) const;
    /// A track that was measured elsewhere; a newer one joins the older ones. InvalidInput for one without
    /// samples, of times that do not rise, or with a position or covariance that is no number. samples: in
    /// place of those of the track.
    Result<void> addImportedTrack(const ImportedTrack &track, const SampleSource &samples = {});
    /// The newest one; nullopt where there is none: the robot was tracked in recordings.
    /// Without samples: where it came from, and how it was read.
    Result<std::optional<ImportedTrack>> currentImportedTrack(RecordId trial, RecordId robot,
                                                              bool withSamples = true) const;
    Result<void> setTruth(const TruthSeries &truth);
    Result<std::optional<TruthSeries>> truth(RecordId trial, RecordId robot) const;

private:
    ProjectConnection &m_connection;
};

/// A robot's run in a trial of a task that is scored.
struct ScoredMetrics
{
    RecordId trial = 0, robot = 0, task = 0; ///< the task that the trial has
    bool isByTask = false; ///< its newest analysis was measured by it, or the task has no course (hasCourse)
    std::vector<Metric> metrics;
};

/// A trial whose task has a course (hasCourse) by which the newest analysis of a robot was not measured: it
/// was by another, by the course as it was before, or by none.
struct OtherwiseMeasured
{
    RecordId trial = 0;
    std::string name, task; ///< of the trial, and of the task it has
    bool binned = false;
};

class AnalysisRepository
{
public:
    explicit AnalysisRepository(ProjectConnection &connection);
    /// samples: in place of those of the profile, one for each of its points; not with a range.
    Result<AnalysisRecord> add(AnalysisRecord analysis, const SampleSource &samples = {});
    /// The newest analysis of each robot of the trial, with all its series, cut to its range, and whether
    /// they are as they were stored.
    Result<std::vector<AnalysisRecord>> current(RecordId trial) const;
    /// When it was ambiguous which robot an analysis is of, in order; outside of its range too.
    Result<std::vector<AmbiguousName>> ambiguousNames(RecordId analysis) const;
    /// Metrics alone, for lists: the newest of each robot, cheap.
    Result<std::vector<AnalysisRecord>> currentMetrics(RecordId trial) const;
    /// One metric of the newest analysis of each robot, of the trials from one moment to another (both belong
    /// to them), by its name.
    Result<std::vector<TrialMetric>> trialMetrics(const std::string &metric, Instant from, Instant to) const;
    /// What runs of scored tasks are scored by, of the newest analysis of each robot, of the trials from one
    /// moment to another (both belong to them): the metrics that the scoring names, and the counts of
    /// scoringMetrics().
    Result<std::vector<ScoredMetrics>> scoredMetrics(Instant from, Instant to) const;
    /// In order of their ids.
    Result<std::vector<OtherwiseMeasured>> trialsMeasuredOtherwise() const;
    /// How many of the newest analyses were made before digests were kept, so that nothing proves them.
    Result<std::int64_t> countWithoutDigest() const;
    /// The names of the metrics that there are, in alphabetical order.
    Result<std::vector<std::string>> metricNames() const;
    /// Names of the trials whose newest analyses were made with a registration, by its id.
    Result<std::map<RecordId, std::vector<std::string>>> trialsByRegistration() const;

private:
    ProjectConnection &m_connection;
};

} // namespace odo
