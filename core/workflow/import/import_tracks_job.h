// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/track_file.h"
#include "core/project/records.h"
#include "core/trajectory/imported_track.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace odo {

struct ImportTracksSettings
{
    std::string trial;
    std::vector<std::pair<std::string, std::filesystem::path>> tracks; ///< robot's name and file
    std::string team;                                                  ///< made when new; empty: none
    std::string task;                                                  ///< must be there; empty: none
    std::optional<Instant> date;                                       ///< empty: now
    TrackReading reading = {};                                         ///< what a person says of the files
    std::optional<double> sigmaM = {};        ///< accuracy of the positions, which no scatter need show
    std::filesystem::path standardInput = {}; ///< the file, if any, that holds what came from there
};

/// Brings finished tracks of one trial into the project, which then has no video: they are analysed like our
/// own (profile, spikes, metrics, by the task), and so they can be again. The imported positions are the raw
/// measurement. A robot that the project does not know is made. The trial's time is the files' where that
/// begins in the first hour, else it counts from the earliest position. Errors beside those of readTrackFile:
/// a file of several tracks without one of the robot's name.
class ImportTracksJob : public Job
{
public:
    explicit ImportTracksJob(ImportTracksSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    struct Imported
    {
        RobotRecord robot;
        ImportedTrack source;    ///< without samples
        AnalysisRecord analysis; ///< its profile has flags in place of samples
    };
    const TrialRecord &trial() const { return m_trial; } ///< after commit
    /// after run; with their numbers after commit
    const std::vector<Imported> &imported() const { return m_imported; }
    /// Whole sentences on what the user should know although the import succeeded.
    const std::vector<Message> &warnings() const { return m_warnings; }

private:
    Result<void> checkTracks() const;
    Result<void> readTask(Project &project);
    Result<void> readRobots(Project &project);
    Result<void> readFiles(const JobControl &control);
    void setClock();
    void makeSamples(std::size_t robot);
    SampleSource samplesOf(std::size_t robot, std::span<const SampleFlags> flags = {}) const;
    Result<void> analyse(std::size_t robot);
    Result<void> store(Project &project);

    ImportTracksSettings m_settings;
    std::optional<TaskRecord> m_task;
    std::vector<FileTrack> m_read;        ///< one a robot; empty once there are its samples
    std::vector<ImportedSeries> m_series; ///< one a robot
    std::vector<double> m_roundingM;      ///< one a robot: σ that the scatter does not show
    Nanoseconds m_zero{0};                ///< what the files' clock showed where the trial's time is 0
    /// of all positions, the trial's frames; of one robot's track they are its lines
    std::vector<Nanoseconds> m_times;
    JobControl m_control; ///< of run; storing long tracks asks it too
    std::vector<Imported> m_imported;
    TrialRecord m_trial;
    std::vector<Message> m_warnings;
};

} // namespace odo
