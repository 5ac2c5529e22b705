// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/analyser.h"
#include "core/trajectory/internal/fused_track.h"
#include "core/trajectory/internal/height_estimation.h"
#include "core/trajectory/internal/kalman_smoother.h"

#include <optional>
#include <vector>

namespace odo {

/// A view of a live track: its camera, on the floor where it is registered.
struct LiveView
{
    std::string camera;
    std::optional<FloorView> floorView; ///< empty: it is shown, but does not help to find the position
};

/// Where a robot is, as far as it can be known at once. World frame, SI.
struct LivePosition
{
    /// The measurement, as the analysis of a recording fuses it; its time is on the clock that the
    /// observations came with.
    Sample sample;
    /// By the causal filter, which takes no sample that is rejected or lies too far off; points that are not
    /// valid: it does not know the robot (yet, or any more).
    ProfilePoint point;
    bool isSpike = false; ///< there is a position that the filter did not take
};

/// One robot's path, measured while it drives, with what the analysis of a recording uses too: each view's
/// observation is projected onto the plane of the robot's height, all views are interpolated to a common
/// time, and fused; a Kalman filter of the same model as the smoother's, its noise fitted to the last
/// seconds, gives position and velocity without looking ahead.
///
/// The common time is the newest one that every view has reached; a view that lags by more than a fifth of a
/// second, or two and a half intervals, has stalled, and the others go on without it. What the solid's form
/// shows (core/trajectory/solid_choice.h) is left to the analysis: beside it a live position of a body of 60
/// mm differs by some millimetres. Not thread-safe.
class LiveTrack
{
public:
    LiveTrack(std::vector<LiveView> views, RobotShape shape);

    /// The next observation of a view, in order of time on a clock common to all views. Gives the position of
    /// a common time that has been reached by it, if one has.
    std::optional<LivePosition> add(std::size_t view, const Observation &observation);

    const PlaneChoice &plane() const { return m_plane; }

private:
    std::optional<Nanoseconds> commonTime() const;
    Nanoseconds usualInterval() const;
    void choosePlaneAgain();
    void fitNoiseAgain();
    LivePosition positionAt(Nanoseconds time);
    void filter(LivePosition &position);

    std::vector<ViewTrack> m_views;                 ///< the last observations of each
    std::vector<std::vector<Sighting>> m_sightings; ///< of each view at the common times of the last seconds
    std::vector<Nanoseconds> m_times;
    std::vector<std::int64_t> m_numbers;
    std::int64_t m_next = 0;

    const RobotShape m_shape;
    PlaneChoice m_plane;
    std::int64_t m_planeChosenAt = -1;

    MotionFilter m_filter{MotionNoise()};
    std::vector<TrackNode> m_nodes; ///< the last measured ones
    MotionNoise m_noise;
    int m_refused = 0; ///< samples in a row that the filter did not take
    double m_travelM = 0;
};

/// Reports while a robot drives when it passes the gates of its task, by the same rule as the analysis
/// (findPassages), with what is known a moment later. Not thread-safe.
class LiveGates
{
public:
    explicit LiveGates(std::vector<Gate> gates) : m_gates(std::move(gates)) {}

    /// The passages that this position makes certain; positions come in order of time.
    std::vector<GatePassage> add(const LivePosition &position);
    /// All since the beginning, in order of time.
    const std::vector<GatePassage> &passages() const { return m_passages; }
    void forget();

private:
    bool isKnown(const GatePassage &passage) const;

    std::vector<Gate> m_gates;
    std::vector<Sample> m_samples;      ///< of the last seconds
    std::vector<ProfilePoint> m_points; ///< the same
    std::vector<GatePassage> m_passages;
};

} // namespace odo
