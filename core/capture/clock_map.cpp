// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/clock_map.h"

#include "core/base/percentile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace odo {

namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds memory = 30s, oneArrivalEach = 250ms;
constexpr std::size_t fewestLatches = 3;
constexpr Nanoseconds shortestRoundTrip = 1us; // none is better known than that
// Between the two halves of a round trip there may be this share of it.
constexpr double roundTripAsymmetry = 0.25;

/// A point of a fit: device time since the newest one, and host − device less the newest one's.
struct Point
{
    double deviceS, behindS;
};

template <class Readings>
std::vector<Point> pointsOf(const Readings &readings)
{
    std::vector<Point> points;
    const auto &newest = readings.back();
    for (const auto &one : readings)
        points.push_back({toSeconds(one.device - newest.device),
                          toSeconds((one.host - one.device) - (newest.host - newest.device))});
    return points;
}

double slope(const Point &a, const Point &b)
{
    return (b.behindS - a.behindS) / (b.deviceS - a.deviceS);
}

/// Of points in order of device time: those of the lower hull (Andrew 1979, the lower half).
std::vector<Point> lowerHull(const std::vector<Point> &points)
{
    std::vector<Point> hull;
    for (const Point &point : points) {
        while (hull.size() >= 2 && slope(hull[hull.size() - 2], hull.back()) >= slope(hull.back(), point))
            hull.pop_back();
        hull.push_back(point);
    }
    return hull;
}

double meanDevice(const std::vector<Point> &points)
{
    double sum = 0;
    for (const Point &point : points)
        sum += point.deviceS;
    return sum / static_cast<double>(points.size());
}

/// The slope of the hull's edge over a device time; 0 for a single point.
double slopeOver(const std::vector<Point> &hull, double deviceS)
{
    for (std::size_t i = 1; i < hull.size(); ++i) {
        if (hull[i].deviceS >= deviceS)
            return slope(hull[i - 1], hull[i]);
    }
    return 0;
}

} // namespace

Nanoseconds ClockFit::hostTime(Nanoseconds deviceTime) const
{
    const Nanoseconds since = deviceTime - device;
    return host + since + fromSeconds(rate * toSeconds(since));
}

void ClockMap::restartIfSet(std::optional<Nanoseconds> &last, Nanoseconds device, Nanoseconds host)
{
    const bool backwards = last && device < *last;
    // A frame may be late by any time, but is never early.
    const bool jumped = m_fit && m_fit->hostTime(device) - host > largestClockJump;
    if (backwards || jumped) {
        m_arrivals.clear();
        m_latches.clear();
        m_lastArrival.reset();
        m_lastLatch.reset();
        m_fit.reset();
        ++m_epoch;
    }
    last = device;
}

void ClockMap::addArrival(Nanoseconds device, Nanoseconds host)
{
    restartIfSet(m_lastArrival, device, host);
    const auto behind = [](const Arrival &one) { return one.host - one.device; };
    const Arrival arrival{device, host};
    const bool sameQuarter =
        !m_arrivals.empty() && device / oneArrivalEach == m_arrivals.back().device / oneArrivalEach;
    if (!sameQuarter)
        m_arrivals.push_back(arrival);
    else if (behind(arrival) < behind(m_arrivals.back()))
        m_arrivals.back() = arrival;
    else
        return;
    while (m_arrivals.front().device < device - memory)
        m_arrivals.pop_front();
    refit();
}

void ClockMap::addLatch(Nanoseconds device, Nanoseconds before, Nanoseconds after)
{
    const Nanoseconds host = before + (after - before) / 2;
    restartIfSet(m_lastLatch, device, after); // like a frame it may be late, and is never early
    m_latches.push_back({device, host, after - before});
    while (m_latches.front().device < device - memory)
        m_latches.pop_front();
    refit();
}

void ClockMap::refit()
{
    if (const auto latched = fitLatches())
        m_fit = latched;
    else if (!m_arrivals.empty())
        m_fit = fitArrivals();
}

ClockFit ClockMap::fitArrivals() const
{
    const std::vector<Point> points = pointsOf(m_arrivals);
    ClockFit fit;
    fit.rate =
        std::clamp(slopeOver(lowerHull(points), meanDevice(points)), -fastestClockRate, fastestClockRate);
    double lowest = 0; // of host − device at the newest point, for a line of this slope below all points
    for (const Point &point : points)
        lowest = std::min(lowest, point.behindS - fit.rate * point.deviceS);
    std::vector<double> above;
    for (const Point &point : points)
        above.push_back(point.behindS - fit.rate * point.deviceS - lowest);
    fit.sigmaS = upperMedian(std::move(above));
    fit.device = m_arrivals.back().device;
    fit.host = m_arrivals.back().host + fromSeconds(lowest);
    return fit;
}

/// The line of least squares, each reading weighed by how well its round trip bounds it: one that was held up
/// counts next to nothing, and those far apart in time still determine the rate when few were quick.
std::optional<ClockFit> ClockMap::fitLatches() const
{
    if (m_latches.size() < fewestLatches)
        return std::nullopt;
    const std::vector<Point> points = pointsOf(m_latches);
    std::vector<double> weights;
    double weight = 0, middle = 0, behind = 0, shortestS = toSeconds(m_latches.front().roundTrip);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double roundTripS = toSeconds(std::max(m_latches[i].roundTrip, shortestRoundTrip));
        weights.push_back(1 / std::pow(roundTripAsymmetry * roundTripS, 2));
        weight += weights[i];
        middle += weights[i] * points[i].deviceS;
        behind += weights[i] * points[i].behindS;
        shortestS = std::min(shortestS, roundTripS);
    }
    middle /= weight;
    behind /= weight;
    double spread = 0, product = 0, squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        spread += weights[i] * (points[i].deviceS - middle) * (points[i].deviceS - middle);
        product += weights[i] * (points[i].deviceS - middle) * (points[i].behindS - behind);
    }
    ClockFit fit;
    fit.source = ClockFit::Source::Latch;
    fit.rate = spread > 0 ? std::clamp(product / spread, -fastestClockRate, fastestClockRate) : 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        squares +=
            weights[i] * std::pow(points[i].behindS - behind - fit.rate * (points[i].deviceS - middle), 2);
    const double scatter = std::max(1.0, squares / static_cast<double>(points.size() - 2));
    const double atNewest = 1 / weight + (spread > 0 ? middle * middle / spread : 0);
    fit.sigmaS = std::hypot(std::sqrt(scatter * atNewest), roundTripAsymmetry * shortestS);
    fit.device = m_latches.back().device;
    fit.host = m_latches.back().host + fromSeconds(behind - fit.rate * middle);
    return fit;
}

} // namespace odo
