// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/fusion.h"

#include "core/base/upper_median.h"
#include "core/trajectory/kalman_smoother.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>

namespace odo {

namespace {

// What stays of the silhouette's form and the clocks after the correction of the height.
constexpr double modelSigmaM = 0.003;
// However badly the views agree on the whole, half a robot apart is never the same place.
constexpr double largestSigmaM = 0.03;
// Enough for any floor; groups are enumerated.
constexpr std::size_t mostViews = 12;

Eigen::Matrix2d differenceCovariance(const FloorPosition &a, const FloorPosition &b)
{
    return totalCovariance(a) + totalCovariance(b) + Eigen::Matrix2d::Identity() * (2 * modelSigmaM * modelSigmaM);
}

double distanceSquared(const FloorPosition &a, const FloorPosition &b)
{
    const Eigen::Vector2d d = a.pointInWorld - b.pointInWorld;
    return d.dot(differenceCovariance(a, b).inverse() * d);
}

} // namespace

Eigen::Matrix2d totalCovariance(const FloorPosition &place)
{
    return place.pixelCovariance + place.calibrationCovariance;
}

FusedPosition fuse(std::span<const ViewPosition> positions)
{
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    for (const ViewPosition &one : positions)
        information += totalCovariance(one.place).inverse();
    const Eigen::Matrix2d covariance = information.inverse();

    FusedPosition fused;
    for (const ViewPosition &one : positions) {
        const Eigen::Matrix2d weight = covariance * totalCovariance(one.place).inverse();
        fused.position += weight * one.place.pointInWorld;
        fused.covariance += weight * one.place.pixelCovariance * weight.transpose();
        fused.commonCovariance += weight * one.place.calibrationCovariance * weight.transpose();
        fused.displacementPerMetreHeight += weight * one.place.displacementPerMetreHeight;
        fused.views |= 1u << one.view;
    }
    return fused;
}

double largestDistance(std::span<const ViewPosition> positions)
{
    double largest = 0;
    for (std::size_t a = 0; a < positions.size(); ++a) {
        for (std::size_t b = a + 1; b < positions.size(); ++b)
            largest =
                std::max(largest, (positions[a].place.pointInWorld - positions[b].place.pointInWorld).norm());
    }
    return largest;
}

AgreementGate::AgreementGate(const std::vector<std::vector<Sighting>> &views)
{
    std::vector<double> distances, variances;
    for (std::size_t a = 0; a < views.size(); ++a) {
        for (std::size_t b = a + 1; b < views.size(); ++b) {
            for (std::size_t i = 0; i < std::min(views[a].size(), views[b].size()); ++i) {
                if (!views[a][i].seen || !views[b][i].seen)
                    continue;
                distances.push_back(distanceSquared(views[a][i].place, views[b][i].place));
                variances.push_back(differenceCovariance(views[a][i].place, views[b][i].place).trace() / 2);
            }
        }
    }
    if (distances.empty())
        return;
    constexpr double medianOfChiSquared2 = 1.3863;
    m_scale = std::max(1.0, upperMedian(std::move(distances)) / medianOfChiSquared2);
    const double variance = upperMedian(std::move(variances));
    m_scale = std::max(1.0, std::min(m_scale, largestSigmaM * largestSigmaM / variance));
}

bool AgreementGate::agree(const ViewPosition &a, const ViewPosition &b) const
{
    return distanceSquared(a.place, b.place) <= refusalGate * m_scale;
}

std::vector<ViewPosition> AgreementGate::largestAgreeingGroup(std::span<const ViewPosition> positions) const
{
    const std::size_t count = std::min(positions.size(), mostViews);
    std::vector<ViewPosition> best;
    double bestVariance = 0;
    for (unsigned members = 1; members < (1u << count); ++members) {
        if (static_cast<std::size_t>(std::popcount(members)) < best.size())
            continue;
        std::vector<ViewPosition> group;
        for (std::size_t i = 0; i < count; ++i) {
            if (members & (1u << i))
                group.push_back(positions[i]);
        }
        bool allAgree = true;
        for (std::size_t i = 0; allAgree && i < group.size(); ++i) {
            for (std::size_t j = i + 1; allAgree && j < group.size(); ++j)
                allAgree = agree(group[i], group[j]);
        }
        if (!allAgree)
            continue;
        const FusedPosition fused = fuse(group);
        const double variance = (fused.covariance + fused.commonCovariance).trace();
        if (group.size() > best.size() || variance < bestVariance) {
            best = group;
            bestVariance = variance;
        }
    }
    return best;
}

} // namespace odo
