// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_session.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <string>
#include <utility>
#include <vector>

namespace odo {

struct RecordSettings
{
    std::string trial;
    std::vector<std::pair<std::string, std::string>> cameras; ///< camera's name and its address, first view first
    double seconds = 10;
    std::vector<std::string> robots;
};

/// Records a trial from cameras: every picture of every view to the disk, the views put in step by the cameras' clocks. A
/// recording that fails or is cancelled leaves no file behind; one whose camera is lost on the way, or whose file has
/// ended, keeps what there is and says so.
class RecordJob : public Job
{
public:
    explicit RecordJob(RecordSettings settings);
    ~RecordJob() override;
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const TrialRecord &trial() const { return m_trial; }                            ///< after commit
    const std::vector<RecordingRecord> &recordings() const { return m_recordings; } ///< after run
    const RecordingOutcome &outcome() const { return m_outcome; }                   ///< after run
    const std::vector<std::string> &warnings() const { return m_warnings; }         ///< after run

private:
    Result<void> checkSettings(Project &project);
    Result<std::vector<std::unique_ptr<CameraSource>>> openCameras();
    Result<void> waitForPictures(const CaptureSession &session, const JobControl &control);
    void waitWhileRecording(const CaptureSession &session, const JobControl &control);
    Result<void> keep(const ViewRecording &view, std::size_t index, const JobControl &control);
    tl::unexpected<Error> noPicture(std::ptrdiff_t view, const std::string &why) const;
    void warnOf(const ViewRecording &view, const std::string &camera);
    void removeFiles();

    RecordSettings m_settings;
    std::filesystem::path m_mediaFolder;
    std::vector<std::filesystem::path> m_files;
    std::vector<RecordId> m_robots;
    TrialRecord m_trial;
    std::vector<RecordingRecord> m_recordings;
    RecordingOutcome m_outcome;
    std::vector<std::string> m_warnings;
    bool m_committed = false;
};

} // namespace odo
