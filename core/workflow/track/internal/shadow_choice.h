// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/settled_views.h"

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace odo {

/// Whether what was followed in some view is in parts that a shadow connects: any of it may be the robot.
/// Before the names are settled.
bool isInParts(const std::vector<TrackedView> &tracked);

/// What was tracked of one robot.
struct Outlines
{
    std::size_t robot = 0;
    double found = 0;             ///< observations
    std::optional<double> misfit; ///< of the solid that explains their outlines best
};

/// Searches the shadows that are on the floor of a trial: a shadow and a side of a robot look alike in a
/// single frame, but not in a whole run: a shadow does not turn with the robot, and has no height. One
/// thread.
class ShadowChoice
{
public:
    /// Tracks once more, as if shadows looked like that.
    using TrackAgain = std::function<Result<SettledViews>(const Background::Shadow &)>;

    /// best: as tracked with usual shadows; becomes what is kept. All must outlive this.
    ShadowChoice(const std::vector<RegisteredView> &views, const std::vector<RobotRecord> &robots,
                 SettledViews &best, TrackAgain again);

    /// Tries others where much of a robot may be shadow, or much beside it robot. What cannot be tracked
    /// again stays as it is.
    void search(bool inParts);
    /// Adds to the observations that are kept how far others that are nearly as likely are from them. The
    /// darkest shadow is known to a part alone, so those with a little darker and lighter ones are, unless
    /// solids explain them much less.
    void addUncertainty();

private:
    /// What was found with shadows that were tried, of one robot.
    struct Tried
    {
        Background::Shadow shadow;
        Outlines outlines;
        double evenShare = 1; ///< of the kept misfit, where both would be as likely
        std::vector<std::map<std::int64_t, Eigen::Vector2d>> centres; ///< of each view, by frame
    };

    bool tryShadow(const Background::Shadow &shadow, std::vector<Outlines> &known, double share);
    bool tryDarkest(float darkest, std::vector<Outlines> &known, double share);
    void searchNearby();
    Outlines outlinesOf(SettledViews &seen, std::size_t robot) const;
    std::vector<Outlines> uncertain(float ShadowAmbiguity::*share, double misfitOfNone);
    double likelihoodOf(const Tried &other, const Outlines &kept) const;

    const std::vector<RegisteredView> &m_views;
    const std::vector<RobotRecord> &m_robots;
    SettledViews &m_best;
    TrackAgain m_again;
    Background::Shadow m_shadow; ///< that m_best was tracked with
    std::vector<Tried> m_tried;
};

} // namespace odo
