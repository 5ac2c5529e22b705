// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/assignment_search.h"

#include "core/calibration/internal/plane_pose.h"
#include "core/geometry/floor_view.h"
#include "core/geometry/homography.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>

namespace odo {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t mostShapes = 20;     // the largest ones; four of 20 in order are 116280
constexpr std::size_t mostQuadruples = 12; // of labels, in case some are hidden
constexpr std::size_t mostRefined = 1200;
constexpr double hintReachPx = 20;
constexpr double leastFitPx = 1.5, worstFit = 0.004; // of the markers' extent in the image
constexpr double roughly = 0.05;                     // of the same: the closed form, before it is refined
constexpr double mostSizes = 1.35;                   // of the largest marker on the floor, of the smallest

double turn(const Vector2d &a, const Vector2d &b, const Vector2d &c)
{
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The map of four points onto four, third row's last value 1; nullopt where they do not determine one.
std::optional<Matrix3d> exactMap(const std::array<Vector2d, 4> &from, const std::array<Vector2d, 4> &to)
{
    Eigen::Matrix<double, 8, 8> matrix;
    Eigen::Matrix<double, 8, 1> right;
    for (int i = 0; i < 4; ++i) {
        const Vector2d &p = from[static_cast<std::size_t>(i)], &q = to[static_cast<std::size_t>(i)];
        matrix.row(2 * i) << p.x(), p.y(), 1, 0, 0, 0, -q.x() * p.x(), -q.x() * p.y();
        matrix.row(2 * i + 1) << 0, 0, 0, p.x(), p.y(), 1, -q.y() * p.x(), -q.y() * p.y();
        right.segment<2>(2 * i) = q;
    }
    const Eigen::Matrix<double, 8, 1> h = matrix.partialPivLu().solve(right);
    if (!h.allFinite())
        return std::nullopt;
    Matrix3d map;
    map << h(0), h(1), h(2), h(3), h(4), h(5), h(6), h(7), 1;
    return map;
}

} // namespace

AssignmentSearch::AssignmentSearch(const MarkerLayout &layout, const CameraModel &camera,
                                   bool intrinsicsKnown)
    : m_layout(layout), m_camera(camera), m_known(intrinsicsKnown), m_fixed(layout.markers.size(), nothing)
{
}

void AssignmentSearch::addShapes(const std::vector<RoundMarker> &shapes)
{
    for (const RoundMarker &shape : shapes) {
        if (m_candidates.size() < mostShapes)
            add(shape.centrePx, shape.outline.area());
    }
}

void AssignmentSearch::fix(const std::vector<MarkerPixel> &hints)
{
    for (const MarkerPixel &hint : hints) {
        const auto label = std::ranges::find(m_layout.markers, hint.label, &Marker::label);
        if (label == m_layout.markers.end())
            continue;
        int nearest = nothing;
        double nearestPx = hintReachPx;
        for (std::size_t i = 0; i < m_candidates.size(); ++i) {
            const double away = (m_candidates[i].pixel - hint.pixel).norm();
            if (away < nearestPx) {
                nearestPx = away;
                nearest = static_cast<int>(i);
            }
        }
        if (nearest == nothing && add(hint.pixel, 0))
            nearest = static_cast<int>(m_candidates.size()) - 1;
        m_fixed[static_cast<std::size_t>(label - m_layout.markers.begin())] = nearest;
    }
}

/// All assignments that fit, best first.
std::vector<AssignmentSearch::Solution> AssignmentSearch::solutions()
{
    std::vector<Vector2d> pixels;
    for (const Candidate &candidate : m_candidates)
        pixels.push_back(candidate.pixel);
    m_extentPx = extentOf(pixels);
    for (const auto &labels : labelQuadruples())
        tryShapes(labels);
    refine();
    std::ranges::sort(m_solutions, [](const Solution &a, const Solution &b) {
        return std::tuple(-static_cast<int>(a.matched), !a.sizesAgree, a.rmsPx) <
               std::tuple(-static_cast<int>(b.matched), !b.sizesAgree, b.rmsPx);
    });
    return m_solutions;
}

bool AssignmentSearch::add(const Vector2d &pixel, double areaPx)
{
    const auto ray = m_camera.unproject(pixel);
    if (!ray || !(ray->z() > 0.1))
        return false;
    m_candidates.push_back({pixel, ray->hnormalized(), areaPx});
    return true;
}

double AssignmentSearch::flatness(const Four &four) const
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t left = 0; left < 4; ++left) {
        const auto at = [&](std::size_t i) { return position(four[(left + i) % 4]); };
        least = std::min(least, std::abs(turn(at(1), at(2), at(3))));
    }
    return least;
}

/// Labels to begin with, those that span the most first.
std::vector<AssignmentSearch::Four> AssignmentSearch::labelQuadruples() const
{
    std::vector<Four> all;
    const int count = static_cast<int>(m_layout.markers.size());
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b)
            for (int c = b + 1; c < count; ++c)
                for (int d = c + 1; d < count; ++d)
                    all.push_back({a, b, c, d});
    std::ranges::sort(all, std::greater(), [this](const Four &four) { return flatness(four); });
    std::erase_if(all, [this](const Four &four) { return !(flatness(four) > 0); });
    if (all.size() > mostQuadruples)
        all.resize(mostQuadruples);
    return all;
}

bool AssignmentSearch::mayBe(int label, int candidate) const
{
    const int fixed = m_fixed[static_cast<std::size_t>(label)];
    if (fixed != nothing)
        return fixed == candidate;
    return std::ranges::find(m_fixed, candidate) == m_fixed.end();
}

void AssignmentSearch::tryShapes(const Four &labels)
{
    const int count = static_cast<int>(m_candidates.size());
    Four chosen{};
    for (chosen[0] = 0; chosen[0] < count; ++chosen[0]) {
        if (!mayBe(labels[0], chosen[0]))
            continue;
        for (chosen[1] = 0; chosen[1] < count; ++chosen[1]) {
            if (chosen[1] == chosen[0] || !mayBe(labels[1], chosen[1]))
                continue;
            for (chosen[2] = 0; chosen[2] < count; ++chosen[2]) {
                if (chosen[2] == chosen[0] || chosen[2] == chosen[1] || !mayBe(labels[2], chosen[2]) ||
                    !isSeenFromAbove(labels, chosen, 0, 1, 2))
                    continue;
                for (chosen[3] = 0; chosen[3] < count; ++chosen[3]) {
                    if (chosen[3] == chosen[0] || chosen[3] == chosen[1] || chosen[3] == chosen[2] ||
                        !mayBe(labels[3], chosen[3]) || !isSeenFromAbove(labels, chosen, 0, 1, 3) ||
                        !isSeenFromAbove(labels, chosen, 0, 2, 3) ||
                        !isSeenFromAbove(labels, chosen, 1, 2, 3))
                        continue;
                    tryPose(labels, chosen);
                }
            }
        }
    }
}

/// Rows of an image run down: what turns left on the floor turns right in it, whatever the perspective.
bool AssignmentSearch::isSeenFromAbove(const Four &labels, const Four &chosen, std::size_t i, std::size_t j,
                                       std::size_t k) const
{
    const auto ray = [&](std::size_t n) { return m_candidates[static_cast<std::size_t>(chosen[n])].ray; };
    return turn(position(labels[i]), position(labels[j]), position(labels[k])) *
               turn(ray(i), ray(j), ray(k)) <
           0;
}

void AssignmentSearch::tryPose(const Four &labels, const Four &chosen)
{
    std::array<Vector2d, 4> from, to;
    for (std::size_t i = 0; i < 4; ++i) {
        from[i] = position(labels[i]);
        to[i] = m_candidates[static_cast<std::size_t>(chosen[i])].ray;
    }
    auto map = exactMap(from, to);
    if (!map)
        return;
    if ((*map * from[0].homogeneous()).z() < 0)
        *map = -*map;
    for (const Vector2d &point : from) {
        if (!((*map * point.homogeneous()).z() > 0))
            return;
    }
    if (m_known && !isPoseLike(*map, from, to))
        return;
    const Assignment assignment = completed(*map, labels, chosen);
    if (m_seen.insert(assignment).second)
        m_rough.push_back(assignment);
}

/// A camera of this lens can have made the map: within what the refinement can correct.
bool AssignmentSearch::isPoseLike(const Matrix3d &map, const std::array<Vector2d, 4> &from,
                                  const std::array<Vector2d, 4> &to) const
{
    const RigidTransform pose = poseFromHomography(Homography(map));
    if (!(pose.translation.z() > 0))
        return false;
    const RigidTransform cameraFromWorld = pose.inverse();
    double squares = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector3d point = cameraFromWorld * Vector3d(from[i].x(), from[i].y(), 0);
        if (!(point.z() > 0))
            return false;
        squares += (Vector2d(point.hnormalized()) - to[i]).squaredNorm() / 4;
    }
    return std::sqrt(squares) * m_camera.intrinsics().fxPx < std::max(4.0, roughly * m_extentPx);
}

/// The other labels' candidates, near their projected positions.
AssignmentSearch::Assignment AssignmentSearch::completed(const Matrix3d &map, const Four &labels,
                                                         const Four &chosen) const
{
    Assignment assignment(m_layout.markers.size(), nothing);
    for (std::size_t i = 0; i < 4; ++i)
        assignment[static_cast<std::size_t>(labels[i])] = chosen[i];
    const double reach = std::max(3.0, 5 * worstFit * m_extentPx) / m_camera.intrinsics().fxPx;
    for (int label = 0; label < static_cast<int>(assignment.size()); ++label) {
        int &to = assignment[static_cast<std::size_t>(label)];
        const Vector3d mapped = map * position(label).homogeneous();
        if (to != nothing || !(mapped.z() > 0))
            continue;
        double nearest = reach;
        for (int i = 0; i < static_cast<int>(m_candidates.size()); ++i) {
            const double away =
                (m_candidates[static_cast<std::size_t>(i)].ray - Vector2d(mapped.hnormalized())).norm();
            if (away < nearest && mayBe(label, i) && std::ranges::find(assignment, i) == assignment.end()) {
                nearest = away;
                to = i;
            }
        }
    }
    return assignment;
}

std::size_t AssignmentSearch::matchedBy(const Assignment &assignment)
{
    return static_cast<std::size_t>(std::ranges::count_if(assignment, [](int to) { return to != nothing; }));
}

void AssignmentSearch::refine()
{
    std::ranges::stable_sort(m_rough, std::greater(), matchedBy);
    if (m_rough.size() > mostRefined)
        m_rough.resize(mostRefined);
    for (const Assignment &assignment : m_rough) {
        // Fewer markers than what has fitted already cannot win.
        if (!m_solutions.empty() && matchedBy(assignment) < m_solutions.front().matched)
            break;
        std::vector<PointPair> pairs;
        std::vector<Vector2d> pixels;
        for (std::size_t label = 0; label < assignment.size(); ++label) {
            if (assignment[label] == nothing)
                continue;
            pixels.push_back(pixel(assignment[label]));
            pairs.push_back(
                {position(static_cast<int>(label)), pixels.back(), m_layout.markers[label].label});
        }
        const auto pose = fitPlanePose(pairs, m_camera, m_known ? FocalLength::Known : FocalLength::Free);
        if (!pose || !(pose->worldFromCamera.translation.z() > 0) ||
            pose->rmsPx > std::max(leastFitPx, worstFit * extentOf(pixels)))
            continue;
        m_solutions.push_back({assignment, pairs.size(), sizesAgree(assignment, *pose), pose->rmsPx});
    }
}

/// Markers are printed in one size.
bool AssignmentSearch::sizesAgree(const Assignment &assignment, const PlanePose &pose) const
{
    const FloorView view(pose.camera, pose.worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (int to : assignment) {
        if (to == nothing || m_candidates[static_cast<std::size_t>(to)].areaPx == 0)
            continue;
        // Of one pixel's square; its root's root is the side that a pixel has on the floor.
        const auto at = view.locate(pixel(to), Eigen::Matrix2d::Identity(), 0);
        if (!at)
            return false;
        const double floorPerPixel = std::sqrt(std::max(0.0, at->pixelCovariance.determinant()));
        const double size = std::sqrt(m_candidates[static_cast<std::size_t>(to)].areaPx * floorPerPixel);
        least = std::min(least, size);
        most = std::max(most, size);
    }
    return !(most > mostSizes * least);
}

} // namespace odo
