// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/strangers.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// A stranger is looked for so soon after the loss that the robot cannot be so far from where it was (in
/// radii).
constexpr double soonAfterLossS = 0.2, fartherThanRobotRadii = 4.0;
constexpr double shiftRadii = 0.25, areaSpan = 0.3; ///< of one that stands still; the latter in ln
constexpr double leastArea = 0.25;                  ///< of the robot's
constexpr std::size_t mostStrangers = 8;

} // namespace

void Strangers::note(const TrackedFrame &frame, const std::vector<Blob> &blobs, const LostRobot &lost)
{
    std::erase_if(m_strangers, [&](const Stranger &stranger) {
        return std::none_of(blobs.begin(), blobs.end(), [&](const Blob &blob) {
            return (frame.grid().toLuma(blob.centre()) - stranger.centrePx).norm() <
                   shiftRadii * lost.radiusPx;
        });
    });
    if (!lost.justLost || lost.sinceS >= soonAfterLossS)
        return;
    m_strangers.clear();
    for (const Blob &blob : blobs) {
        const Eigen::Vector2d centre = frame.grid().toLuma(blob.centre());
        const double areaPx = blob.area() * frame.lumaPerSample();
        if (m_strangers.size() < mostStrangers && areaPx > leastArea * lost.areaPx &&
            (centre - lost.placePx).norm() > fartherThanRobotRadii * lost.radiusPx)
            m_strangers.push_back({centre, areaPx});
    }
}

bool Strangers::contain(const TrackedFrame &frame, const Blob &blob, double radiusPx) const
{
    const Eigen::Vector2d centre = frame.grid().toLuma(blob.centre());
    const double areaPx = blob.area() * frame.lumaPerSample();
    return std::any_of(m_strangers.begin(), m_strangers.end(), [&](const Stranger &stranger) {
        return (centre - stranger.centrePx).norm() < shiftRadii * radiusPx &&
               std::abs(std::log(areaPx / stranger.areaPx)) < areaSpan;
    });
}

} // namespace odo
