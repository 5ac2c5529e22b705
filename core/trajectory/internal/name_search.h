// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/internal/name_evidence.h"

#include <vector>

namespace odo {

/// What is known of the robots beside the evidence; better in the second round than in the first.
struct NameKnowledge
{
    double planeM = 0;        ///< height at which the views should agree
    double floorSigmaM = 0.1; ///< how well
    bool viewsAgree = true;   ///< false: their clocks or registrations are wrong; the floor is not asked
    /// Mean chroma of each name in each view, looks[view][name]; empty in the first round, zero where
    /// unknown.
    std::vector<std::vector<Eigen::Vector2d>> looks;
    std::vector<double> sizesM; ///< of each name, as of TrackletOf; likewise
};

/// Two tracklets of one view that got one name, where another way to name the tracklets explains the evidence
/// nearly as well.
struct AmbiguousLink
{
    std::size_t before = 0, behind = 0;
    /// that the second one has by that way; may be its own where only what lies between is named otherwise
    std::size_t otherName = 0;
};

struct FoundNames
{
    /// of each tracklet of the evidence: an index among the robots considered, or their number where it is no
    /// robot
    std::vector<std::size_t> names;
    std::vector<AmbiguousLink> ambiguities;
};

/// The likeliest names. Tracklets of one view that overlap in time never share a name.
FoundNames searchNames(const NameEvidence &evidence, std::size_t views, const NameKnowledge &knowledge);

} // namespace odo
