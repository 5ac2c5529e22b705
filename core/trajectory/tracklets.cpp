// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/tracklets.h"

#include "core/base/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double leastScore = 0.2;
constexpr std::size_t leastFrames = 3, framesOfVelocity = 6;
constexpr double mostLinkCost = 12.0;
constexpr double accelerationRadii = 16.0; ///< per s²: 2 m/s² of a robot whose circle has a radius of 0.12 m
constexpr double placeSigmaRadii = 0.3, speedSigmaRadii = 0.5;

Tracklet::End endAt(const std::vector<Observation> &observations, std::size_t at, std::size_t inner,
                    const ViewClock &clock)
{
    const Observation &outermost = observations[at], &other = observations[inner];
    Tracklet::End end;
    end.timeS = toSeconds(clock.commonTime(outermost.time));
    end.positionPx = outermost.ellipse.centrePx;
    const double dt = toSeconds(outermost.time) - toSeconds(other.time);
    if (dt != 0)
        end.velocityPxPerS = (outermost.ellipse.centrePx - other.ellipse.centrePx) / dt;
    end.radiusPx = std::sqrt(std::max(1.0, outermost.areaPx) / std::numbers::pi);
    return end;
}

Tracklet trackletOf(const std::vector<Observation> &observations, std::size_t first, std::size_t last,
                    const ViewClock &clock)
{
    Tracklet tracklet{first, last, {}, {}, {}};
    tracklet.begin = endAt(observations, first, std::min(last, first + framesOfVelocity), clock);
    tracklet.end =
        endAt(observations, last, std::max(first + framesOfVelocity, last) - framesOfVelocity, clock);
    double coloured = 0;
    for (std::size_t i = first; i <= last; ++i) {
        const Eigen::Vector2d &chroma = observations[i].meanChroma;
        if (chroma.isZero())
            continue;
        tracklet.meanChroma += chroma;
        coloured += 1;
    }
    if (coloured > 0)
        tracklet.meanChroma /= coloured;
    return tracklet;
}

} // namespace

bool isSure(const Observation &observation)
{
    return observation.found && observation.score >= leastScore && observation.ellipse.centrePx.allFinite();
}

std::vector<Tracklet> cutIntoTracklets(const std::vector<Observation> &observations, const ViewClock &clock)
{
    std::vector<Tracklet> tracklets;
    for (std::size_t i = 0; i < observations.size(); ++i) {
        const std::size_t first = i;
        while (i < observations.size() && isSure(observations[i]))
            ++i;
        if (i >= first + leastFrames)
            tracklets.push_back(trackletOf(observations, first, i - 1, clock));
    }
    return tracklets;
}

double costOfJoining(const Tracklet::End &end, const Tracklet::End &begin)
{
    const double dt = std::max(0.0, begin.timeS - end.timeS);
    const double radius = std::max(1.0, std::min(end.radiusPx, begin.radiusPx));
    const double placeSigma = radius * (placeSigmaRadii + 0.25 * accelerationRadii * dt * dt);
    const double speedSigma = radius * (speedSigmaRadii + accelerationRadii * dt);
    const Eigen::Vector2d halfway = (begin.positionPx - 0.5 * dt * begin.velocityPxPerS) -
                                    (end.positionPx + 0.5 * dt * end.velocityPxPerS);
    const Eigen::Vector2d change = begin.velocityPxPerS - end.velocityPxPerS;
    return std::min(mostLinkCost, 0.5 * (halfway.squaredNorm() / (placeSigma * placeSigma) +
                                         change.squaredNorm() / (speedSigma * speedSigma)));
}

} // namespace odo
