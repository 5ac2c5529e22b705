// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"

#include <deque>
#include <optional>

namespace odo {

/// No clock runs faster or slower than this.
inline constexpr double fastestClockRate = 500e-6;
/// A clock that is further than this from where it is expected, apart from its rate, was reset.
inline constexpr Nanoseconds largestClockJump = std::chrono::milliseconds(50);

/// How a camera's clock relates to this machine's.
struct ClockFit
{
    enum class Source {
        Arrival, ///< from when frames arrived: late by exposure and transfer, the same for all frames
        Latch    ///< from reading the camera's clock: no such lateness
    };
    Source source = Source::Arrival;
    Nanoseconds device{0}, host{0}; ///< two readings at one time
    double rate = 0;                ///< by how much the camera's clock runs slower than the host's
    double sigmaS = 0;              ///< of the host time given, but for the lateness of Source::Arrival

    Nanoseconds hostTime(Nanoseconds deviceTime) const;
};

/// Learns, while frames come in, how the time stamps of a camera's own clock translate into this machine's
/// steady clock.
///
/// From arrivals: a frame cannot arrive before it was taken and often arrives late, so the truth lies at
/// the lower edge of host − device over device. The line is the one below all points with the least sum of
/// distances to them, which is the edge of their lower convex hull at their mean device time (Moon, Skelly
/// and Towsley 1999, "Estimation and removal of clock skew from network delay measurements"). A least-squares
/// line would be dragged by every delay: 50 to 75 ppm.
///
/// From latches, which are preferred as soon as three are there: the camera's clock is read and lies between
/// two readings of ours; by least squares, each weighed by how short its round trip was.
///
/// Both forget what is older than 30 s, so that a quartz that warms up is followed. A device time that goes
/// backwards, or that jumps against ours by more than largestClockJump, is a clock that was reset: all is
/// forgotten and a new epoch begins. The rate is held at fastestClockRate. Not thread-safe.
class ClockMap
{
public:
    /// A frame with the camera's time stamp arrived.
    void addArrival(Nanoseconds device, Nanoseconds host);
    /// The camera's clock was read; the answer came between these two times of ours.
    void addLatch(Nanoseconds device, Nanoseconds before, Nanoseconds after);

    /// nullopt before the first arrival or the third latch.
    const std::optional<ClockFit> &fit() const { return m_fit; }
    /// How often a reset of the camera's clock was found.
    int epoch() const { return m_epoch; }

private:
    struct Arrival
    {
        Nanoseconds device, host;
    };
    struct Latch
    {
        Nanoseconds device, host, roundTrip;
    };
    void restartIfSet(std::optional<Nanoseconds> &last, Nanoseconds device, Nanoseconds host);
    void refit();
    ClockFit fitArrivals() const;
    std::optional<ClockFit> fitLatches() const;

    std::deque<Arrival> m_arrivals; ///< the least late one of each quarter of a second
    std::deque<Latch> m_latches;
    std::optional<Nanoseconds> m_lastArrival, m_lastLatch; ///< device times; each kind comes in order
    std::optional<ClockFit> m_fit;
    int m_epoch = 0;
};

} // namespace odo
