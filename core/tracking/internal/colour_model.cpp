// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/colour_model.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double dimmer = 0.6, brighter = 1.35; ///< smear of the table about the present colour
constexpr double learnedUncertainty = 2e-3, givenUncertainty = 1e-4;
constexpr double leastLikeness = 0.4; ///< to the given colour, without regard to the background
constexpr double followGain = 0.25;
constexpr double scaleStep = 0.06, turnStepRad = 0.035; ///< before the table is built again
constexpr double leastScale = 0.35, mostScale = 2.5, mostTurnRad = 0.4;

} // namespace

ColourModel::ColourModel(const Chroma &given)
    : m_given(given), m_givenDensity(densityOfGivenColour(given)), m_density(m_givenDensity)
{
}

Chroma ColourModel::expected() const
{
    if (!m_learned)
        return m_given;
    const double c = std::cos(m_turnRad), s = std::sin(m_turnRad);
    return m_scale * Chroma(c * m_mean.x() - s * m_mean.y(), s * m_mean.x() + c * m_mean.y());
}

ChromaDensity ColourModel::density() const
{
    ChromaDensity now = m_learned ? m_density.transformed(m_scale, m_turnRad) : m_density;
    now.normalise();
    return now;
}

ChromaDensity ColourModel::densityUnderOtherLight() const
{
    return m_learned ? m_smeared.transformed(m_scale, m_turnRad) : m_density;
}

/// The part of the given density that no longer resembles the given colour.
float ColourModel::leastAlike() const
{
    float highest = 0;
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin)
        highest = std::max(highest, m_givenDensity[bin]);
    return static_cast<float>(leastLikeness) * highest;
}

double ColourModel::shareAlike(const ChromaDensity &image) const
{
    const float least = leastAlike();
    double share = 0;
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin) {
        if (m_givenDensity[bin] > least)
            share += image[bin];
    }
    return share;
}

ChromaTable ColourModel::givenColourTable(const ChromaDensity *background) const
{
    if (background)
        return {m_givenDensity, *background, static_cast<float>(givenUncertainty)};
    return {m_givenDensity, ChromaDensity(), leastAlike()};
}

void ColourModel::learn(const ChromaGrid &grid, const RegionMask &mask, const Chroma &mean)
{
    m_density = ChromaDensity();
    const ChromaRect area = mask.area.clippedTo(grid.bounds());
    for (int y = area.top; y < area.bottom; ++y) {
        const std::uint8_t *inside = mask.row(y) - mask.area.left;
        for (int x = area.left; x < area.right; ++x) {
            if (inside[x])
                m_density[ChromaDensity::binOf(grid.u.at(x, y), grid.v.at(x, y))] += 1;
        }
    }
    m_density.normalise();
    m_density.blur(2);
    m_smeared = m_density.underOtherLight(dimmer, brighter);
    m_mean = mean;
    m_learned = true;
    m_scale = 1;
    m_turnRad = 0;
}

bool ColourModel::follow(const Chroma &seen)
{
    const double cross = m_mean.x() * seen.y() - m_mean.y() * seen.x();
    const double turn = std::clamp(std::atan2(cross, m_mean.dot(seen)), -mostTurnRad, mostTurnRad);
    const double scale = std::clamp(seen.norm() / std::max(m_mean.norm(), 1.0), leastScale, mostScale);
    m_scale += followGain * (scale - m_scale);
    m_turnRad += followGain * (turn - m_turnRad);
    return std::abs(std::log(m_scale / m_tableScale)) > scaleStep ||
           std::abs(m_turnRad - m_tableTurnRad) > turnStepRad;
}

void ColourModel::buildTable(const ChromaDensity &background)
{
    m_table = {m_smeared.transformed(m_scale, m_turnRad), background, static_cast<float>(learnedUncertainty)};
    m_tableScale = m_scale;
    m_tableTurnRad = m_turnRad;
}

namespace {

/// The search for a stranger comes so soon after the loss that the robot cannot be so far from where it was
/// (in radii).
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
            (centre - lost.positionPx).norm() > fartherThanRobotRadii * lost.radiusPx)
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
