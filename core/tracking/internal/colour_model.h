// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/blob_finder.h"
#include "core/tracking/internal/tracked_frame.h"

#include <vector>

namespace odo {

/// What is known of a robot's colour: first what was given, then what was seen of it, followed through
/// changes of light.
class ColourModel
{
public:
    ColourModel() = default;
    explicit ColourModel(const Chroma &given);

    const Chroma &given() const { return m_given; }
    const ChromaDensity &givenDensity() const { return m_givenDensity; }
    bool isLearned() const { return m_learned; }
    /// The chroma the robot is expected to show now.
    Chroma expected() const;
    /// The robot's density now, of sum one (given, or as learned); what others must differ from.
    ChromaDensity density() const;

    /// The same, once learned, with what dimmer and brighter light makes of it: not of sum one.
    ChromaDensity densityUnderOtherLight() const;

    /// The share of a frame (passed as its density) that looks like the given colour: 0 to 1.
    double shareAlike(const ChromaDensity &image) const;

    /// A table from the given colour. Without regard to the background it finds more, and more that is wrong.
    ChromaTable givenColourTable(const ChromaDensity *background) const;

    /// Learns the colour from the samples of a mask that are in the frame.
    void learn(const ChromaGrid &grid, const RegionMask &mask, const Chroma &mean);
    /// Follows the light. True when the colour has moved so far from what the table was built for that it
    /// should be built again.
    bool follow(const Chroma &seen);
    /// Builds the table for the colour as it is now. The background is a density of sum about one, without
    /// the robot.
    void buildTable(const ChromaDensity &background);
    const ChromaTable &table() const { return m_table; }

private:
    float leastAlike() const;

    Chroma m_given = Chroma::Zero(), m_mean = Chroma::Zero();
    bool m_learned = false;
    ChromaDensity m_givenDensity;
    ChromaDensity m_density;           ///< as learned
    ChromaDensity m_smeared;           ///< the same under other light
    double m_scale = 1, m_turnRad = 0; ///< of the present colour against the learned one
    double m_tableScale = 1, m_tableTurnRad = 0;
    ChromaTable m_table;
};

/// A robot as it was when it was lost.
struct LostRobot
{
    Eigen::Vector2d positionPx = Eigen::Vector2d::Zero(); ///< where it should be now
    double radiusPx = 0, areaPx = 0;
    double sinceS = 0;     ///< since it was last seen
    bool justLost = false; ///< this is the first frame without it
};

/// What has a robot's colour elsewhere at the moment of its loss is not the robot, as long as it stays there.
class Strangers
{
public:
    void clear() { m_strangers.clear(); }
    /// Forgets those that are gone; at the moment of the loss, notes all that are there.
    void note(const TrackedFrame &frame, const std::vector<Blob> &blobs, const LostRobot &lost);
    bool contain(const TrackedFrame &frame, const Blob &blob, double radiusPx) const;

private:
    struct Stranger
    {
        Eigen::Vector2d centrePx;
        double areaPx = 0;
    };
    std::vector<Stranger> m_strangers;
};

} // namespace odo
