// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/silhouette_parts.h"

#include "core/geometry/silhouette.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace odo {

namespace {

constexpr double edgeSigmaPx = 0.3, edgeLengthPx = 5, centreSigmaPx = 0.05;
constexpr double mostOfBody = 0.3; // of its area: what is larger is no fragment of it
// between a body and a fragment, in sides of the body
constexpr double mostFragmentGap = 0.12, mostShadowGap = 0.5;
constexpr double mostGrown = 3; // of a body's hull, by all of its fragments
// and by slender ones, which may be of a cable: length over width
constexpr double mostGrownBySlender = 1.25, slender = 3;
constexpr double mostGap = 4; // between parts of one body, in sides of the smaller one
// between a body and what may stand on it, in sides of the body
constexpr double mostBesideGap = 0.8;

/// Between two boxes; 0 where they touch.
double gapPx(const PixelRect &a, const PixelRect &b)
{
    const int x = std::max({a.x0 - b.x1, b.x0 - a.x1, 0}), y = std::max({a.y0 - b.y1, b.y0 - a.y1, 0});
    return std::hypot(x, y);
}

bool isFragmentOf(const SeenSilhouette &body, const SeenSilhouette &small)
{
    const double side = std::sqrt(body.moments.areaPx2);
    const bool hangsTogether = small.shadowPiece == body.shadowPiece;
    return small.moments.areaPx2 < mostOfBody * body.moments.areaPx2 &&
           gapPx(body.box, small.box) < (hangsTogether ? mostShadowGap : mostFragmentGap) * side;
}

double mostGrownBy(const SeenSilhouette &part)
{
    const Eigen::Vector2d spread =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(part.moments.covariancePx2, Eigen::EigenvaluesOnly)
            .eigenvalues();
    return spread[1] > slender * slender * spread[0] ? mostGrownBySlender : mostGrown;
}

bool mayBelongTogether(const SeenSilhouette &a, const SeenSilhouette &b)
{
    return gapPx(a.box, b.box) < mostGap * std::sqrt(std::min(a.moments.areaPx2, b.moments.areaPx2));
}

/// A silhouette and those behind it that its shadow connects with it.
std::vector<std::size_t> sharingShadow(const std::vector<SeenSilhouette> &seen, std::size_t first)
{
    std::vector<std::size_t> sharing;
    for (std::size_t i = first; i < seen.size(); ++i)
        if (seen[i].shadowPiece == seen[first].shadowPiece)
            sharing.push_back(i);
    return sharing;
}

} // namespace

void measureHull(SeenSilhouette &silhouette, std::vector<Eigen::Vector2d> edgePoints)
{
    silhouette.hullPx = convexHull(std::move(edgePoints));
    silhouette.moments = polygonMoments(silhouette.hullPx);
    const RegionMoments &moments = silhouette.moments;
    silhouette.supportPx = supportOf(silhouette.hullPx, moments.centrePx);
    // An edge is uncertain by some part of a pixel, alike over some pixels of it, and pulls the centre by its
    // distance from it.
    const double perimeter = 4 * std::sqrt(moments.areaPx2);
    silhouette.centreCovariancePx2 =
        moments.covariancePx2 *
        (4 * edgeSigmaPx * edgeSigmaPx * edgeLengthPx * perimeter / (moments.areaPx2 * moments.areaPx2));
    silhouette.centreCovariancePx2.diagonal().array() += centreSigmaPx * centreSigmaPx;
}

void joinFragments(std::vector<SeenSilhouette> &seen)
{
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const SeenSilhouette body = seen[i];
        for (;;) { // that by which the hull grows least first: what is too far out keeps no other away
            std::optional<SeenSilhouette> least;
            std::size_t part = 0;
            for (std::size_t j = i + 1; j < seen.size(); ++j) {
                if (!isFragmentOf(body, seen[j]))
                    continue;
                SeenSilhouette whole = joined(seen, {i, j});
                if (whole.moments.areaPx2 > mostGrownBy(seen[j]) * body.moments.areaPx2)
                    continue;
                if (!least || whole.moments.areaPx2 < least->moments.areaPx2) {
                    least = std::move(whole);
                    part = j;
                }
            }
            if (!least)
                break;
            least->regions = 1;
            least->shadowPiece = body.shadowPiece;
            seen[i] = std::move(*least);
            seen.erase(seen.begin() + std::ptrdiff_t(part));
        }
    }
}

void joinByShadow(std::vector<SeenSilhouette> &seen)
{
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::vector<std::size_t> parts = sharingShadow(seen, i);
        if (parts.size() == 1)
            continue;
        SeenSilhouette whole = joined(seen, parts);
        whole.regions = 1;
        whole.shadowPiece = seen[i].shadowPiece;
        for (std::size_t k = parts.size() - 1; k > 0; --k)
            seen.erase(seen.begin() + std::ptrdiff_t(parts[k]));
        seen[i] = std::move(whole);
    }
}

void noteApart(std::vector<SeenSilhouette> &seen)
{
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const std::vector<std::size_t> parts = sharingShadow(seen, i);
        if (parts.size() == 1 || seen[i].shadowAmbiguity.apart > 0)
            continue;
        const double wholePx2 = joined(seen, parts).moments.areaPx2;
        for (const std::size_t part : parts)
            seen[part].shadowAmbiguity.apart = float(1 - seen[part].moments.areaPx2 / wholePx2);
    }
}

void noteBeside(std::vector<SeenSilhouette> &seen)
{
    for (std::size_t j = 1; j < seen.size(); ++j) {
        SeenSilhouette *nearest = nullptr;
        double leastGap = mostBesideGap;
        for (std::size_t i = 0; i < j; ++i) {
            const double gap = gapPx(seen[i].box, seen[j].box) / std::sqrt(seen[i].moments.areaPx2);
            if (seen[j].moments.areaPx2 < mostOfBody * seen[i].moments.areaPx2 && gap < leastGap) {
                nearest = &seen[i];
                leastGap = gap;
            }
        }
        if (nearest)
            nearest->isTrimmed = true;
    }
}

std::vector<std::vector<std::size_t>> groupsOfParts(const std::vector<SeenSilhouette> &seen)
{
    std::vector<std::size_t> group(seen.size());
    std::iota(group.begin(), group.end(), std::size_t(0));
    for (std::size_t i = 0; i < seen.size(); ++i)
        for (std::size_t j = i + 1; j < seen.size(); ++j)
            if (group[i] != group[j] && mayBelongTogether(seen[i], seen[j]))
                std::ranges::replace(group, group[j], group[i]);
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t g = 0; g < seen.size(); ++g) {
        std::vector<std::size_t> parts;
        for (std::size_t i = 0; i < seen.size(); ++i)
            if (group[i] == g)
                parts.push_back(i);
        if (parts.size() > 1)
            groups.push_back(std::move(parts));
    }
    return groups;
}

SeenSilhouette joined(const std::vector<SeenSilhouette> &seen, const std::vector<std::size_t> &parts)
{
    SeenSilhouette whole;
    std::vector<Eigen::Vector2d> points;
    double area = 0;
    whole.box = seen[parts.front()].box;
    whole.clearShare = 0;
    whole.regions = int(parts.size());
    for (const std::size_t part : parts) {
        const SeenSilhouette &one = seen[part];
        points.insert(points.end(), one.hullPx.begin(), one.hullPx.end());
        whole.box = whole.box.united(one.box);
        whole.touchesBorder |= one.touchesBorder;
        whole.isTrimmed |= one.isTrimmed;
        whole.meanChroma += one.moments.areaPx2 * one.meanChroma;
        whole.clearShare += one.moments.areaPx2 * one.clearShare;
        area += one.moments.areaPx2;
    }
    whole.meanChroma /= area;
    whole.clearShare /= area;
    for (const std::size_t part : parts)
        whole.shadowAmbiguity.addPart(seen[part].shadowAmbiguity, float(seen[part].moments.areaPx2 / area));
    measureHull(whole, std::move(points));
    return whole;
}

} // namespace odo
