// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_session.h"
#include "core/files/temporary.h"
#include "core/project/project_locks.h"
#include "core/project/records.h"
#include "core/workflow/job.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// When a run started, by this machine's steady clock.
struct RunStart
{
    Nanoseconds at{0};   ///< the button, the gate, or what else started it
    Nanoseconds from{0}; ///< since when it is recorded: at, or before
};

/// The variable of a trial with the time of its start, in seconds since its first frame. Only a trial
/// that was recorded from earlier on has it.
inline const std::string startVariable = "start_s";

/// A trial that is being recorded. It is in the project from its start, and once a second the times of what
/// has reached the disk are added, so that whatever happens to the program RecoverJob finds it whole but for
/// the last second.
///
/// Ending it is this job: run stops the recording, which takes as long as the disk does, and commit completes
/// the trial, but for the hashes of its files, which HashJob makes. One that is cancelled, or fails, is
/// completed by RecoverJob at the next opening.
class LiveTrial : public Job
{
public:
    /// Adds the trial and begins to record. trial: name, team, task, robots and notes. cameras: the name of
    /// each view of the session; those that are new are added. The session must outlive the recording, and do
    /// nothing else meanwhile. start: nullopt: now. On the project's thread. Errors: AlreadyExists (the name,
    /// or a recording that goes on); NotFound; Io.
    static Result<std::shared_ptr<LiveTrial>> begin(Project &project, TrialRecord trial,
                                                    const std::vector<std::string> &cameras,
                                                    CaptureSession &session,
                                                    std::optional<RunStart> start = std::nullopt);
    ~LiveTrial() override; ///< ends the recording

    /// Adds what has reached the disk since. Once a second, on the project's thread. After an error it tries
    /// again the next time.
    Result<void> append(Project &project);
    /// Gives the trial up: ends the recording and leaves nothing behind. On the project's thread.
    Result<void> discard(Project &project);

    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const TrialRecord &trial() const { return m_trial; }
    const std::vector<RecordingRecord> &recordings() const
    {
        return m_recordings;
    }                                                             ///< after run: of views with frames
    const RecordingOutcome &outcome() const { return m_outcome; } ///< after run: of all views of the session
    const std::vector<Message> &warnings() const { return m_warnings; } ///< after run
    void addWarning(Message warning) { m_warnings.push_back(std::move(warning)); }

private:
    struct View
    {
        RecordingRecord record;
        ClaimedFile file;
        RecordedTimes pending;                ///< on the disk, and not yet in the project
        std::size_t frames = 0, readings = 0; ///< in the project
        Nanoseconds first{0}, last{0};        ///< arrival
    };
    LiveTrial(CaptureSession &session, std::unique_ptr<RecordingLock> lock)
        : m_session(session), m_lock(std::move(lock))
    {
    }
    Result<void> addTo(Project &project, const std::vector<std::string> &cameras);
    Result<void> store(Project &project);
    Result<void> appendPending(Project &project) const;
    Error withoutFrames() const;
    std::map<std::string, std::string> startVariables() const;
    void warnOf(const ViewRecording &view, const std::string &camera, bool byWire);
    std::optional<Message> keptLess(const ViewRecording &view) const;

    CaptureSession &m_session;
    std::unique_ptr<RecordingLock> m_lock;
    TrialRecord m_trial;
    std::optional<RunStart> m_start;
    std::vector<View> m_views;
    std::vector<RecordId> m_newCameras;
    std::vector<RecordingRecord> m_recordings;
    RecordingOutcome m_outcome;
    std::vector<Message> m_warnings;
    bool m_recording = false;
    bool m_delivering = false; ///< a camera, as the recording was stopped
};

} // namespace odo
