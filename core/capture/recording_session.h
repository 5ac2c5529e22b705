// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/view_recorder.h"

namespace odo {

/// A camera that is to be recorded, and where to.
struct RecordedCamera
{
    std::unique_ptr<CameraSource> source;
    std::filesystem::path file;
};

/// What became of a recording of several views.
struct RecordingOutcome
{
    std::vector<ViewRecording> views; ///< in the order of the cameras
    PairFigures pairs;
};

/// Records several cameras at once and watches how well they are in step. Lives on one thread.
class RecordingSession
{
public:
    /// One camera at least, the first of which the others are paired with. Begins at once.
    explicit RecordingSession(std::vector<RecordedCamera> cameras);
    ~RecordingSession();

    /// Of the view that has the fewest.
    std::uint64_t frames() const;
    /// A camera or the disk has failed: it is time to finish.
    bool hasEnded() const;
    /// Ends it and waits until all is on the disk. Once.
    RecordingOutcome finish();

private:
    void pair(std::size_t view, TimedFrame frame);

    std::mutex m_mutex; ///< guards the synchroniser
    std::optional<Synchroniser> m_synchroniser;
    std::vector<std::unique_ptr<ViewRecorder>> m_views;
};

} // namespace odo
