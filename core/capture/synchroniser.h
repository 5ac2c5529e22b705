// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/camera_source.h"
#include "core/capture/capture_health.h"

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace odo {

/// A captured frame with the time at which it was taken, by this machine's steady clock.
struct TimedFrame
{
    CapturedFrame captured;
    Nanoseconds taken{0};
};

/// Frames of several views that were taken together: one of the first view and, of each other view, the one
/// that is nearest to it in time, where there is one.
struct FrameSet
{
    std::vector<std::optional<TimedFrame>> views;
};

/// How well the views are synchronised. A pair is a frame of the first view with one of another view.
struct PairStatistics
{
    std::uint64_t pairs = 0;
    std::uint64_t unpaired = 0; ///< frames of any view that were left without a partner
    /// Of each pair, in seconds: how much later the other view's frame was taken.
    std::vector<double> errorsS;
};

/// Finds which frames of several cameras belong together, by when they were taken, never by when or in
/// which order they arrived. Two frames belong together when each is the other's nearest and they lie no
/// further apart than the tolerance. A set is given out as soon as no frame that is still to come could be
/// nearer, or when it has waited for the longest time allowed: one camera that stalls does not hold up the
/// others for longer. Not thread-safe.
class Synchroniser
{
public:
    struct Settings
    {
        std::size_t views = 2;
        Nanoseconds tolerance{0};   ///< half a frame interval for cameras that run free
        Nanoseconds longestWait{0}; ///< by host time, from when a frame was taken
    };
    explicit Synchroniser(Settings settings);

    /// Frames of one view come in the order in which they were taken; one that does not is counted as
    /// unpaired and dropped.
    void add(std::size_t view, TimedFrame frame);
    /// Sets that are complete, or have waited long enough at this host time, in the order of the first view.
    std::vector<FrameSet> take(Nanoseconds now);
    /// The end: all that are left.
    std::vector<FrameSet> takeRest();

    /// The statistics since they were last taken.
    PairStatistics takeStatistics();

private:
    bool isDecided(Nanoseconds time, Nanoseconds now) const;
    FrameSet takeFirst();
    std::optional<TimedFrame> takePartner(std::size_t view, Nanoseconds time,
                                          std::optional<Nanoseconds> following);
    void dropUnpaired(std::size_t view);

    const Settings m_settings;
    std::vector<std::deque<TimedFrame>> m_waiting; ///< of each view
    std::vector<std::optional<Nanoseconds>> m_newest;
    PairStatistics m_statistics;
};

/// Pairs the frames of live cameras, and monitors how well the views are synchronised. Any thread.
class FramePairing
{
public:
    explicit FramePairing(Synchroniser::Settings settings);

    void add(std::size_t view, TimedFrame frame, Nanoseconds now);
    PairHealth health(Nanoseconds now) const;

private:
    struct PairError
    {
        Nanoseconds at;
        double errorS;
    };

    const Nanoseconds m_tolerance;
    mutable std::mutex m_mutex; ///< guards what follows
    Synchroniser m_synchroniser;
    std::deque<PairError> m_recent;
    std::uint64_t m_pairs = 0, m_unpaired = 0;
};

/// How the frames of several views pair, by when they were taken; each view's in order.
PairStatistics pairStatistics(const std::vector<std::vector<Nanoseconds>> &takenOfViews,
                              Nanoseconds tolerance);

} // namespace odo
