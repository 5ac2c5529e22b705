// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_fit.h"

#include "core/geometry/homography.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr std::size_t leastMarkers = 4;
constexpr double leastFitShare = 0.6; // of the markers seen
constexpr std::size_t leastChanceTags = 4;
constexpr int mostSamples = 300;
constexpr double leastFitReachPx = 6, reachOfExtent = 0.03; // an unknown lens bends that much
constexpr double mostStretch = 1.25;                        // of a tag's sides on the floor
constexpr int groupRounds = 4;

const std::array<Vector2d, 4> tagCorners{Vector2d(-1, -1), Vector2d(1, -1), Vector2d(1, 1), Vector2d(-1, 1)};

/// Pixels without the lens's distortion.
class IdealPixels
{
public:
    explicit IdealPixels(const std::optional<CameraModel> &camera) : m_camera(camera) {}

    std::optional<Vector2d> of(const Vector2d &pixel) const
    {
        if (!m_camera)
            return pixel;
        const auto ray = m_camera->unproject(pixel);
        if (!ray || !(ray->z() > 0.1))
            return std::nullopt;
        return Vector2d(m_camera->intrinsics().fxPx * ray->hnormalized());
    }
    std::optional<Vector2d> back(const Vector2d &ideal) const
    {
        if (!m_camera)
            return ideal;
        return m_camera->project((ideal / m_camera->intrinsics().fxPx).homogeneous());
    }

private:
    const std::optional<CameraModel> &m_camera;
};

std::vector<PointPair> pairsOf(const MarkerLayout &layout, const std::vector<TagSighting> &sightings,
                               const IdealPixels &ideal)
{
    std::vector<PointPair> pairs;
    for (const TagSighting &sighting : sightings) {
        if (const auto pixel = ideal.of(sighting.pixel))
            pairs.push_back({layout.markers[sighting.marker].pointInWorld, *pixel, {}});
    }
    return pairs;
}

bool isSimilar(double a, double b)
{
    return a < mostStretch * b && b < mostStretch * a;
}

/// The side of a tag that is seen from above and a square on the floor.
std::optional<double> squareSideM(const SeenTag &tag, const Homography &floorFromIdeal,
                                  const IdealPixels &ideal)
{
    std::array<Vector2d, 4> floor;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto pixel = ideal.of((tag.pixelFromTag * tagCorners[i].homogeneous()).hnormalized());
        const auto point = pixel ? floorFromIdeal.map(*pixel) : std::nullopt;
        if (!point)
            return std::nullopt;
        floor[i] = *point;
    }
    const Vector2d across = floor[2] - floor[0], aside = floor[3] - floor[1];
    const double side = (floor[1] - floor[0]).norm();
    if (across.x() * aside.y() - across.y() * aside.x() < 0 && isSimilar(across.norm(), aside.norm()) &&
        isSimilar(side, (floor[2] - floor[1]).norm()))
        return side;
    return std::nullopt;
}

/// All tags of a sighting are squares on the floor, of about this side unless it is 0.
bool areSquares(const TagSighting &sighting, double sideM, const Homography &floorFromIdeal,
                const IdealPixels &ideal)
{
    return std::ranges::all_of(sighting.tags, [&](const SeenTag &tag) {
        const auto side = squareSideM(tag, floorFromIdeal, ideal);
        return side && (sideM == 0 || isSimilar(*side, sideM));
    });
}

/// As TagFit says.
std::vector<TagSighting> contradictingOf(const std::vector<TagSighting> &sightings,
                                         const std::vector<TagSighting> &inliers,
                                         const Homography &floorFromIdeal, const IdealPixels &ideal)
{
    std::vector<double> sidesM;
    for (const TagSighting &inlier : inliers) {
        for (const SeenTag &tag : inlier.tags)
            sidesM.push_back(squareSideM(tag, floorFromIdeal, ideal).value_or(0));
    }
    if (sidesM.empty())
        return {};
    std::ranges::sort(sidesM);
    std::vector<TagSighting> contradicting;
    for (const TagSighting &sighting : sightings) {
        if (std::ranges::find(inliers, sighting.marker, &TagSighting::marker) == inliers.end() &&
            std::ranges::find(contradicting, sighting.marker, &TagSighting::marker) == contradicting.end() &&
            areSquares(sighting, sidesM[sidesM.size() / 2], floorFromIdeal, ideal))
            contradicting.push_back(sighting);
    }
    return contradicting;
}

/// The nearest sighting of each marker that agrees with a map, by indices.
std::vector<std::size_t> inliersOf(const Homography &idealFromFloor, const MarkerLayout &layout,
                                   const std::vector<TagSighting> &sightings, const IdealPixels &ideal,
                                   double reachPx)
{
    const Homography back = idealFromFloor.inverse();
    std::vector<std::size_t> inliers;
    std::vector<double> away(layout.markers.size(), reachPx);
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        const TagSighting &sighting = sightings[i];
        const auto pixel = ideal.of(sighting.pixel);
        const auto predicted = idealFromFloor.map(layout.markers[sighting.marker].pointInWorld);
        if (!pixel || !predicted || !((*pixel - *predicted).norm() < away[sighting.marker]) ||
            !areSquares(sighting, 0, back, ideal))
            continue;
        away[sighting.marker] = (*pixel - *predicted).norm();
        std::erase_if(inliers, [&](std::size_t other) { return sightings[other].marker == sighting.marker; });
        inliers.push_back(i);
    }
    return inliers;
}

/// Four sightings of different markers; fewer where luck would have it.
std::vector<TagSighting> sampleOf(const std::vector<TagSighting> &sightings, std::mt19937 &random)
{
    std::vector<TagSighting> sample;
    for (int attempt = 0; attempt < 40 && sample.size() < leastMarkers; ++attempt) {
        const TagSighting &one = sightings[random() % sightings.size()];
        if (std::ranges::find(sample, one.marker, &TagSighting::marker) == sample.end())
            sample.push_back(one);
    }
    return sample;
}

std::size_t markersOf(const std::vector<TagSighting> &sightings)
{
    std::set<std::size_t> markers;
    for (const TagSighting &sighting : sightings)
        markers.insert(sighting.marker);
    return markers.size();
}

} // namespace

std::vector<TagSighting> sightingsOf(const TagRule &rule, const std::vector<SeenTag> &tags)
{
    std::vector<TagSighting> sightings;
    for (const TaggedPoint &point : rule.points) {
        std::vector<std::vector<SeenTag>> seen;
        for (const TagName &name : point.tags) {
            auto &of = seen.emplace_back();
            std::ranges::copy_if(tags, std::back_inserter(of), [&](const SeenTag &tag) {
                return TagName{tag.family, tag.number} == name;
            });
        }
        if (std::ranges::any_of(seen, &std::vector<SeenTag>::empty))
            continue;
        if (seen.size() == 1) {
            for (const SeenTag &tag : seen.front()) {
                const Vector2d at =
                    point.corner ? tagCorners[static_cast<std::size_t>(*point.corner)] : Vector2d(0, 0);
                sightings.push_back(
                    {point.marker, (tag.pixelFromTag * at.homogeneous()).hnormalized(), {tag}});
            }
            continue;
        }
        TagSighting group{point.marker, Vector2d::Zero(), {}};
        for (const auto &of : seen) {
            group.tags.push_back(of.front());
            group.pixel += of.front().pixel / static_cast<double>(seen.size());
        }
        sightings.push_back(std::move(group));
    }
    return sightings;
}

bool TagFit::isAccepted() const
{
    if (inliers.size() < leastMarkers ||
        static_cast<double>(inliers.size()) < leastFitShare * static_cast<double>(seen))
        return false;
    // One square that reads as a tag by chance gives four corners.
    std::set<TagName> byChance, others;
    for (const TagSighting &sighting : inliers) {
        for (const SeenTag &tag : sighting.tags)
            (isReadByChance(tag.family) ? byChance : others).insert({tag.family, tag.number});
    }
    return !others.empty() || byChance.size() >= leastChanceTags;
}

TagFit fitTags(const MarkerLayout &layout, const TagRule &rule, const std::vector<TagSighting> &sightings,
               const std::optional<CameraModel> &camera)
{
    TagFit fit;
    fit.seen = markersOf(sightings);
    if (rule.points.size() < leastMarkers || fit.seen < leastMarkers)
        return fit;
    const IdealPixels ideal(camera);
    std::vector<Vector2d> pixels;
    for (const PointPair &pair : pairsOf(layout, sightings, ideal))
        pixels.push_back(pair.target);
    const double reachPx = std::max(leastFitReachPx, reachOfExtent * extentOf(pixels));
    std::mt19937 random(1);
    std::vector<std::size_t> best;
    const auto tryMap = [&](const std::vector<TagSighting> &some) {
        const auto map = Homography::estimate(pairsOf(layout, some, ideal));
        if (!map)
            return;
        auto inliers = inliersOf(*map, layout, sightings, ideal, reachPx);
        if (inliers.size() > best.size())
            best = std::move(inliers);
    };
    const int samples = sightings.size() == leastMarkers ? 1 : mostSamples;
    for (int i = 0; i < samples && best.size() < fit.seen; ++i)
        tryMap(sampleOf(sightings, random));
    const auto chosen = [&] {
        std::vector<TagSighting> some;
        for (const std::size_t i : best)
            some.push_back(sightings[i]);
        return some;
    };
    tryMap(chosen());
    fit.inliers = chosen();
    std::ranges::sort(fit.inliers, {}, &TagSighting::marker);
    if (const auto map = Homography::estimate(pairsOf(layout, fit.inliers, ideal)))
        fit.contradicting = contradictingOf(sightings, fit.inliers, map->inverse(), ideal);
    return fit;
}

void refineGroups(const MarkerLayout &layout, std::vector<TagSighting> &sightings,
                  const std::optional<CameraModel> &camera)
{
    const IdealPixels ideal(camera);
    const auto isGroup = [](const TagSighting &sighting) { return sighting.tags.size() > 1; };
    for (int round = 0; round < groupRounds && std::ranges::any_of(sightings, isGroup); ++round) {
        const auto map = Homography::estimate(pairsOf(layout, sightings, ideal));
        if (!map)
            return;
        const Homography back = map->inverse();
        for (TagSighting &sighting : sightings) {
            if (!isGroup(sighting))
                continue;
            Vector2d mean = Vector2d::Zero();
            for (const SeenTag &tag : sighting.tags) {
                const auto pixel = ideal.of(tag.pixel);
                const auto point = pixel ? back.map(*pixel) : std::nullopt;
                if (!point)
                    return;
                mean += *point / static_cast<double>(sighting.tags.size());
            }
            const auto middle = map->map(mean);
            const auto pixel = middle ? ideal.back(*middle) : std::nullopt;
            if (!pixel)
                return;
            sighting.pixel = *pixel;
        }
    }
}

} // namespace odo
