// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/table/track_reading.h"
#include "core/files/temporary.h"
#include "core/project/records.h"
#include "core/workflow/import/internal/view_source.h"
#include "core/workflow/job.h"
#include "core/workflow/track/view_synchronisation.h"
#include "core/workflow/trial_sources.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace odo {

struct ImportSettings
{
    std::string trial;
    /// camera's name and file, first view first; or several files, as recordingSourceOf() reads it
    std::vector<std::pair<std::string, std::filesystem::path>> videos;
    /// camera's name and a table of when its frames were taken (readFrameTimes), in place of its file's times
    std::vector<std::pair<std::string, std::filesystem::path>> times;
    std::optional<TimeUnit> timeUnit; ///< of those tables, where they do not say it
    std::vector<ViewStep> steps;      ///< of the views but the first, as stepsFor reads them
    std::string team;                 ///< made when new; empty: none
    std::string task;
    std::vector<std::string> robots;
    std::optional<double> rate;  ///< of the camera, where the file's frame rate is another
    std::optional<Instant> date; ///< empty: when the views were filmed (filmedAt), or now
};

/// How the file of a view is coded.
struct ViewCoding
{
    std::string codec; ///< libav's name, e.g. "h264"
    int bitDepth = 8;
    bool variableRate = false; ///< intervals differ by more than 10 % of the median
};

/// Brings the videos of one trial into the project: each is copied beside it (with its hash), or made there
/// of the chapters or images that it consists of; its frame times are read, and the views are synchronised.
/// An import that fails or is cancelled removes what it made, and only that. Where the robot's motion shows
/// that a file's time stamps are wrong (lost or doubled frames, a pause, a jump), the stored frame times are
/// those at which the frames were taken, and a warning says so.
class ImportTrialJob : public Job
{
public:
    explicit ImportTrialJob(ImportSettings settings);
    ~ImportTrialJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const TrialRecord &trial() const { return m_trial; }                            ///< after commit
    const std::vector<RecordingRecord> &recordings() const { return m_recordings; } ///< after run
    const std::vector<ViewCoding> &codings() const { return m_codings; } ///< of recordings(), in their order
    /// What the user should know although the import succeeded: unequal lengths, no synchronisation, damaged
    /// ends.
    const std::vector<Message> &warnings() const { return m_warnings; }

private:
    Result<void> readVideo(std::size_t view, const CancelToken &cancel);
    Result<void> fitView(RegisteredView &view, const std::optional<Intrinsics> &intrinsics);
    Result<void> copyVideo(std::size_t view, const JobControl &control);
    Result<void> synchronise(const JobControl &control);

    ImportSettings m_settings;
    std::filesystem::path m_mediaFolder;
    bool m_folderWasThere = true;
    std::vector<ViewSource> m_sources;
    std::vector<RegisteredView> m_views;
    SyncRequest m_sync;
    std::vector<std::optional<Intrinsics>>
        m_viewIntrinsics; ///< of each view: that of its registration, or in force
    TrialRecord m_trial;
    std::vector<RecordingRecord> m_recordings;
    std::vector<ViewCoding> m_codings;
    std::vector<ClaimedFile> m_files; ///< until they are the trial's
    std::vector<Message> m_warnings;
};

} // namespace odo
