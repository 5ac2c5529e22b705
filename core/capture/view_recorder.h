// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bounded_queue.h"
#include "core/capture/clock_map.h"
#include "core/capture/synchroniser.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace odo {

/// What became of one view's recording.
struct ViewRecording
{
    std::filesystem::path file;
    FrameFormat format;
    std::vector<Nanoseconds> taken;   ///< of each picture in the file, by this machine's steady clock
    std::uint64_t frames = 0;         ///< that the camera delivered
    std::uint64_t lostOnWire = 0;     ///< gaps in the camera's own count
    std::uint64_t lostByUs = 0;       ///< that the disk was too slow for
    std::vector<double> latenciesS;   ///< of each picture, from when it was taken to when it was written
    double clockSigmaS = 0;           ///< of all times alike
    std::optional<Error> problem;     ///< why it ended by itself
};

/// Records one camera: a thread of its own takes the pictures, another one codes and writes them. The queue between the two
/// has an end: what finds no room in it is counted, never waited for, so that a slow disk does not make the camera lose
/// pictures unseen.
class ViewRecorder
{
public:
    /// Called for each picture on the thread that takes them; must be quick.
    using OnFrame = std::function<void(TimedFrame)>;

    ViewRecorder(std::unique_ptr<CameraSource> camera, std::filesystem::path file, OnFrame onFrame);
    ~ViewRecorder(); ///< stops
    ViewRecorder(const ViewRecorder &) = delete;
    ViewRecorder &operator=(const ViewRecorder &) = delete;

    const CameraDescription &description() const { return m_camera->description(); }
    void start();
    /// Pictures that the camera has delivered so far. Any thread.
    std::uint64_t frames() const;
    /// True once the camera or the disk has failed. Any thread.
    bool hasEnded() const;
    /// Takes no more pictures. Any thread.
    void stop() { m_camera->stop(); }
    /// Stops, waits until all is on the disk, and tells what there is. Once.
    ViewRecording finish();

private:
    struct Pending
    {
        Frame frame;
        Nanoseconds device;
    };
    void takePictures();
    void writePictures();
    bool take(CapturedFrame captured);
    void fail(const Error &error);
    Result<void> write(const Pending &pending);
    Nanoseconds hostTime(Nanoseconds device) const;

    std::unique_ptr<CameraSource> m_camera;
    const OnFrame m_onFrame;
    BoundedQueue<Pending> m_queue;
    std::thread m_taker, m_writer;

    mutable std::mutex m_mutex; ///< guards what follows
    ViewRecording m_recording;
    ClockMap m_clock;
    std::optional<std::uint64_t> m_lastSequence;

    struct Output;
    std::unique_ptr<Output> m_output; ///< of the writing thread
};

} // namespace odo
