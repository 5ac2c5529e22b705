// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/capture/camera_source.h"
#include "core/simulation/renderer.h"

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>

namespace odo {

/// Releases frames at their time. Without a pace (tests) they come as fast as requested.
class Pace
{
public:
    enum class Kind { RealTime, None };
    using Start = std::optional<std::chrono::steady_clock::time_point>;
    /// start: where several are to keep step; otherwise it begins at the first call.
    explicit Pace(Kind kind, Start start = std::nullopt) : m_kind(kind), m_start(start) {}

    /// Waits until so much time has passed since the beginning. False once stopped.
    bool waitUntil(Nanoseconds time);
    /// How late it is by the clock; 0 without a pace. Call it after waitUntil.
    Nanoseconds lateness(Nanoseconds time) const;
    /// Any thread; wakes who waits.
    void stop();

private:
    const Kind m_kind;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    Start m_start;
    bool m_stopped = false;
};

/// A camera before which somebody holds a board: in each pose for a second, then moving on to the next within
/// half a second; from the start again after the last.
std::unique_ptr<CameraSource> simulatedBoardSource(CameraDescription description, CameraModel camera,
                                                   const SimulatedBoard &board,
                                                   std::vector<RigidTransform> cameraFromBoard,
                                                   Pace::Kind pace);

/// A camera of a scene that restarts when it is over. Cameras with the same start see it at the same
/// time. The robots that it is to show instead of the scene's drive as circlingRobots.
std::unique_ptr<CameraSource> simulatedSceneSource(CameraDescription description, SimulatedScene scene,
                                                   int camera, Pace::Kind pace,
                                                   Pace::Start start = std::nullopt);

/// A video file that plays as if it were a camera; it is lost at its end. Errors: those of VideoReader::open.
Result<std::unique_ptr<CameraSource>> openFileSource(const std::filesystem::path &file, Pace::Kind pace);

} // namespace odo
