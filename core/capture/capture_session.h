// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/base/steady_now.h"
#include "core/capture/capture_health.h"
#include "core/capture/synchroniser.h"
#include "core/video/frame_times.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace odo {

/// The camera delivered nothing for a while.
struct RecordingGap
{
    std::size_t before = 0; ///< the frame after it, by its index in the file
    Nanoseconds length{0};  ///< from the arrival of the frame before
    Error why;
};

/// What became of one view's recording.
struct ViewRecording
{
    std::filesystem::path file;
    FrameFormat format;
    RecordedTimes times;
    std::vector<Nanoseconds>
        taken;              ///< of each frame in the file, by this machine's steady clock; derived from times
    double clockSigmaS = 0; ///< of all of these alike
    std::uint64_t frames = 0;     ///< that the camera delivered
    std::uint64_t lostOnWire = 0; ///< gaps in the camera's own count
    /// that this program or the disk was too slow for; not what `problem` cost
    std::uint64_t lostByUs = 0;
    /// of each frame, from when it was taken to when it was written; of one from before the recording began,
    /// from then on
    std::vector<double> latenciesS;
    std::vector<RecordingGap> gaps;
    double longestWaitS = 0;      ///< that a frame waited for the disk
    std::optional<Error> problem; ///< why it ended by itself
    /// Arrival of the oldest frame that was still in memory, where earlier ones were wanted and had been
    /// dropped because those kept of this view would have exceeded their share of it.
    std::optional<Nanoseconds> keptOnlyFrom;
};

/// What became of a recording of several views.
struct RecordingOutcome
{
    std::vector<ViewRecording> views; ///< in the order of the cameras
    PairStatistics pairs;             ///< of the frames recorded
};

/// When recorded frames were taken, by this machine's steady clock.
struct DerivedTimes
{
    std::vector<Nanoseconds> taken; ///< one for each frame, increasing
    double sigmaS = 0;              ///< of all of them alike
};

/// Derives when each frame was taken from the raw times of a recording: the camera's clock as ClockMap
/// learns it, with what came before and after. Pure.
DerivedTimes deriveTimes(const RecordedTimes &times);

/// The advice where a file that is needed for a recording is no longer there.
Message reconnectDisk();

class FramePairing;
class ViewCapture;
class ViewWriter;

/// What a subscriber takes frames from: pop() waits for the next and gives nullopt once the session has
/// ended; dropped() says how many he was too slow for. close() ends the subscription.
using FrameFeed = BoundedQueue<TimedFrame>;

struct CaptureSettings
{
    /// How much is kept back in memory, coded, so that a recording can begin before it was asked for. 0:
    /// none, and frames are only coded while a recording goes on.
    Nanoseconds preRoll = std::chrono::seconds(3);
    DiskWatch disk = {};
    /// The most memory for preRoll, of all views together; each has the same share. Beyond it the oldest
    /// frames are dropped.
    std::size_t preRollBytes = 512'000'000;
};

/// Runs several cameras at once, for as long as it lives: shows and tracks their frames live, reports how
/// well they work and are synchronised at any time, and on demand writes every frame of every view to the
/// disk.
///
/// If a camera is missing, the session waits for it while the others go on. For each view, a thread takes
/// the frames, a second one codes them (those of a camera that codes them itself stay as they came), a
/// third one writes while a recording goes on. What finds its queue to the disk full is counted, never
/// waited for, so that a slow disk does not make a camera lose frames unnoticed; a subscriber who is too slow
/// loses the oldest ones, and the recording none.
///
/// startRecording, stopRecording and the end of the session are for one thread at a time; everything else for
/// any, at any time.
class CaptureSession
{
public:
    /// One camera at least, the first of which the others are paired with. Begins at once, and returns at
    /// once.
    explicit CaptureSession(std::vector<std::unique_ptr<CameraSource>> cameras,
                            CaptureSettings settings = {});
    /// Ends a recording as stopRecording does, and all subscriptions. Waits for a camera that hangs no
    /// longer than a second.
    ~CaptureSession();
    CaptureSession(const CaptureSession &) = delete;
    CaptureSession &operator=(const CaptureSession &) = delete;

    std::size_t viewCount() const { return m_views.size(); }
    const CameraDescription &description(std::size_t view) const;
    /// The controls of a camera with their current values. May take seconds where it does not answer. Errors:
    /// Unavailable.
    Result<std::vector<CameraControl>> controls(std::size_t view) const;

    /// The robots that simulated cameras show from their next frames on (CameraSource::showRobots).
    void showRobots(const std::vector<RobotAppearance> &robots);

    /// Every frame of a view as it arrives, with its time as known by then. capacity: how many may wait.
    std::shared_ptr<FrameFeed> subscribeFrames(std::size_t view, std::size_t capacity = 1);

    /// A value that was true just now; cheap, never waits for a camera or the disk.
    CaptureHealth health() const;

    /// The remaining recording time on the disk of a folder, at what the cameras send now, before a
    /// recording starts; nullopt while that is not known, and without a pre-roll. Asks the disk: quick for
    /// one in this machine.
    std::optional<double> remainingSeconds(const std::filesystem::path &folder) const;
    /// Keeps frames in memory for so long from now on, instead of CaptureSettings::preRoll.
    void setPreRoll(Nanoseconds preRoll);
    /// The share of a view in CaptureSettings::preRollBytes.
    std::size_t preRollBytesOfView() const { return m_preRollBytesOfView; }
    /// Records all views from so long ago, each to its own new MKV file, as far as frames are kept; these
    /// come first, without a gap or a repeated frame before those that arrive now. Holds the cameras'
    /// automatics still. Returns at once: what cannot be written shows in health(). Not while one goes on.
    void startRecording(const std::vector<std::filesystem::path> &files,
                        Nanoseconds preRoll = Nanoseconds(0));
    bool isRecording() const;
    /// What has reached the disk of a view since the last call: what a project keeps of it while it is being
    /// recorded.
    RecordedTimes takeWritten(std::size_t view);
    /// Ends the recording with the frames that have arrived by now, and waits until they are on the disk.
    /// Only while one goes on.
    RecordingOutcome stopRecording();

private:
    std::optional<RecordingWarning> sleep(Nanoseconds now) const;

    Nanoseconds m_tolerance{0};
    const DiskWatch m_disk;
    const std::size_t m_preRollBytesOfView;
    std::shared_ptr<FramePairing> m_pairing;
    std::vector<std::shared_ptr<ViewCapture>>
        m_views;                ///< shared with their threads, which a hanging camera may outlive us with
    mutable std::mutex m_mutex; ///< guards what follows
    std::vector<std::shared_ptr<ViewWriter>> m_writers; ///< none while nothing is recorded
    mutable Nanoseconds m_slept = machineSlept();       ///< when it was last looked
    mutable std::optional<RecordingWarning> m_sleep;    ///< the last one
};

} // namespace odo
