// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/clock_map.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// The current problem, and since when by this machine's steady clock.
struct RecordingWarning
{
    Error error;
    Nanoseconds since{0};
};

/// How a camera does at this moment. Counts are since the session began.
struct ViewHealth
{
    enum class State {
        Starting, ///< no frame has come yet
        Delivering,
        Waiting, ///< it does not deliver, and is used again as soon as it does
        Ended    ///< nothing more will come
    };
    State state = State::Starting;
    double framesPerSecond = 0; ///< over the last two seconds
    std::uint64_t delivered = 0;
    std::uint64_t lostOnWire = 0; ///< gaps in the camera's own count
    /// false: this program generates or reads its frames; no camera sends them
    bool hasWire = true;
    std::uint64_t lostByUs = 0; ///< that this program or the disk was too slow for
    CameraCounts source;        ///< damaged, resent, reconnections
    double latencyS = 0;        ///< of the last two seconds' frames, 95th percentile
    /// Whether exposure, gain, white balance and focus hold still; nullopt: not asked for yet.
    std::optional<bool> automaticsHeld;
    std::vector<Message> notHeld;  ///< names of what goes on changing by itself
    std::optional<ClockFit> clock; ///< with its source and σ; nullopt before the first frame
    std::optional<RecordingWarning> warning;
    std::optional<RecordingWarning> slow; ///< it delivers fewer frames per second than requested
};

/// How well the views are synchronised. Errors are of the last ten seconds: how much later the other view's
/// frame was taken.
struct PairHealth
{
    std::uint64_t pairs = 0, unpaired = 0;      ///< since the session began
    double medianS = 0, p95S = 0, largestS = 0; ///< of the errors without their sign; 0 without pairs
    double binS = 0;
    std::vector<std::uint32_t> histogram; ///< of the errors with their sign; the middle bin is centred on 0
};

/// How the disk keeps up with what is being recorded.
struct DiskHealth
{
    bool recording = false;
    double recordedS = 0;    ///< length of what is on the disk, of the view that has the least
    std::uint64_t bytes = 0; ///< written so far, all views
    double waiting = 0;      ///< how full the fullest queue to the disk is; 1: frames are being lost
    std::optional<double> secondsLeft; ///< until the disk is as full as it may get; nullopt: not known yet
    bool ended = false; ///< the recording of a view has ended by itself; what there is of it is kept
    /// Why it has ended; or that the disk is too slow, reported long before anything is lost.
    std::optional<RecordingWarning> warning;
};

struct CaptureHealth
{
    std::vector<ViewHealth> views; ///< in the order of the cameras
    PairHealth pairs;
    DiskHealth disk;
    /// That this machine slept while it recorded, until the recording has ended; else for some seconds.
    std::optional<RecordingWarning> sleep;
};

/// That this machine slept so long, and what that means.
Error machineSleptError(Nanoseconds howLong);
/// That a camera delivers only so many of the requested frames per second.
Error slowCameraError(const std::string &uri, double framesPerSecond, double asked);

/// "30.0 frames/s, none lost", or the problem.
Message healthWords(const ViewHealth &view);
/// "synchronised to 1.2 ms; at 2 m/s that is 2.4 mm"; 95 % of the pairs are within it.
Message synchronisationWords(double p95S);
/// Whether the frames of a kind of camera come by a cable or a network.
bool comesByWire(const std::string &kind);
/// "remaining recording time 42 min"; empty where not known.
Message remainingTimeText(const DiskHealth &disk);

struct DiskCapacity
{
    std::uint64_t free = 0; ///< bytes that may still be written
    std::uint64_t size = 0; ///< bytes of the whole disk
};

/// Of the disk that a folder is on; nullopt where the system does not say.
std::optional<DiskCapacity> diskCapacityOf(const std::filesystem::path &folder);

/// How full a recording may make its disk.
struct DiskWatch
{
    /// A recording ends by itself with so many bytes left, or with a twentieth of a disk that is small:
    /// enough for the project and everything else on this machine to go on.
    std::uint64_t mostReserved = 200'000'000;
    /// Asked once a second while recording, on the thread that writes.
    std::function<std::optional<DiskCapacity>(const std::filesystem::path &folder)> space = diskCapacityOf;

    /// Bytes that a recording may still take.
    std::uint64_t left(const DiskCapacity &disk) const;
    std::uint64_t reserved(const DiskCapacity &disk) const;
};

} // namespace odo
