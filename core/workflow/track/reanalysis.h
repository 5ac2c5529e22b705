// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class TrackJob;

/// Samples of a trial from one time to another, both inside.
struct SampleGroup
{
    double fromS = 0, toS = 0;
    SampleFlags reasons = 0; ///< one of which they have; 0: whatever they have
};

/// A manual override of a sample of a trial, or of several at once.
struct OverrideRequest
{
    enum class Word {
        Spike, ///< it is not to be used
        Valid, ///< it is to be used, whatever speaks against it
        Clear, ///< removes the manual override
    };
    std::string trial;
    std::string robot;                 ///< empty: the only one that was tracked in the trial
    std::optional<double> timeS;       ///< the nearest frame is meant; or else
    std::optional<std::int64_t> frame; ///< of the first view
    Word word = Word::Spike;
    std::vector<std::int64_t> frames = {}; ///< instead of one: of the first view
    /// Instead of one: of these, those that the word changes.
    std::optional<SampleGroup> group = {};
};

/// Whether a word changes what becomes of a sample. Pure.
bool isChangedBy(OverrideRequest::Word word, const Sample &sample);

struct OverrideOutcome
{
    std::string robot;
    std::size_t count = 0; ///< samples
    /// Of the first of them.
    std::int64_t frame = 0;
    Nanoseconds time{0};
    SampleFlags flags = 0; ///< in the new analysis
    AnalysisRecord analysis;
};

/// Stores manual overrides of samples and reanalyses the stored observations with them, as one change; older
/// analyses stay. Errors: the robot was not tracked, no frame at that time, nothing measured there, nothing
/// to remove, no such sample in a group, another sample was overridden between prepare and commit.
class OverrideJob : public Job
{
public:
    explicit OverrideJob(OverrideRequest request);
    ~OverrideJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const OverrideOutcome &outcome() const { return m_outcome; } ///< after commit

private:
    OverrideRequest m_request;
    RecordId m_trial = 0, m_robot = 0;
    std::vector<ManualOverride> m_before, m_overrides;
    std::unique_ptr<TrackJob> m_analysis;
    OverrideOutcome m_outcome;
};

/// A metric before and after; nullopt where one of the two analyses has none.
struct MetricChange
{
    std::string name, unit;
    std::optional<double> before, after;
    std::optional<double> sigma; ///< of the later, or else of the earlier
};

/// What another analysis of the same observations changes for one robot.
struct ProfileChange
{
    std::vector<MetricChange> metrics; ///< in the order of the earlier, then those that are new
    std::size_t compared = 0;          ///< positions that both have
    double largestShiftM = 0, rmsShiftM = 0;
    Nanoseconds largestAt{0};
    std::size_t spikesBefore = 0, spikesAfter = 0;
    Message words; ///< one sentence for a person
};

/// Compares frame by frame, where both are valid. Pure; any thread.
ProfileChange changeBetween(const Profile &before, const Profile &after);

/// What analysing a trial again changes for one of its robots.
struct ReprocessedRobot
{
    std::string name;
    ProfileChange change;
};

/// Analyses the stored observations of a trial again with the registrations in force, and shows what that
/// changes. Stores nothing until keep() is called: a person checks first. NotFound where the trial was never
/// tracked.
class ReprocessJob : public Job
{
public:
    explicit ReprocessJob(std::string trial);
    ~ReprocessJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    const std::string &trial() const { return m_trial; }
    const std::vector<ReprocessedRobot> &robots() const { return m_robots; } ///< after run
    /// Stores the new analyses beside the old ones, as the current ones; one transaction, on the project's
    /// thread.
    Result<void> keep(Project &project);

private:
    std::string m_trial;
    std::vector<std::pair<std::string, Profile>> m_before; ///< by robot
    std::unique_ptr<TrackJob> m_analysis;
    std::vector<ReprocessedRobot> m_robots;
};

} // namespace odo
