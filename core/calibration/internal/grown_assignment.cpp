// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/grown_assignment.h"

#include "core/base/job_control.h"
#include "core/base/percentile.h"
#include "core/calibration/internal/neighbours.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int nothing = GrownAssignment::nothing;
constexpr std::size_t markerNeighbours = 12, shapeNeighbours = 10, basisNeighbours = 6;
constexpr std::size_t mostSeedMarkers = 12, mostBases = 4, fewSeedMarkers = 6; // few, of small seeds
constexpr std::size_t fewNeighbours = 5, farNeighbours = 8; // of a marker about which many are hidden
constexpr std::size_t leastMatched = 8, leastSupport = 3;
constexpr std::array<std::size_t, 3> seedSizes{6, 5, 4}; // of those neighbours and the marker, tried in turn
constexpr double mostUnround = 2;  // ratio of a seed's axes, in the plane in which its shape is round
constexpr double seedReach = 0.3;  // of the distance to the neighbour
constexpr double growReach = 0.25; // of the distance to the nearest neighbour
constexpr double leastGrowReachPx = 1.5;
constexpr double mostAreaRatio = 2.5;                                   // of a marker and its neighbours
constexpr double leastOutlier = 0.03, mostOutlier = 0.15, ofMedian = 4; // of the same, from the prediction
constexpr double mostGrownMisfit = 0.08;
constexpr std::size_t spareMisses = 8; // beyond half of the steps, before a growth ends

double crossOf(const Vector2d &a, const Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

class Growth
{
public:
    Growth(const std::vector<Vector2d> &markers, const std::vector<MarkerShapeSeen> &shapes,
           const std::vector<int> &known, const Vector2d &size)
        : m_markers(markers), m_shapes(shapes), m_known(known), m_size(size)
    {
        for (std::size_t i = 0; i < markers.size(); ++i)
            m_aroundMarker.push_back(nearestTo(i, markers.size(), markerNeighbours, [&](std::size_t j) {
                return (markers[j] - markers[i]).norm();
            }));
        for (std::size_t i = 0; i < shapes.size(); ++i)
            m_aroundShape.push_back(nearestTo(i, shapes.size(), shapeNeighbours, [&](std::size_t j) {
                return (shapes[i].round * (shapes[j].pixel - shapes[i].pixel)).norm();
            }));
    }

    std::vector<GrownAssignment> run();

private:
    using Pairs = std::vector<std::pair<int, int>>; ///< marker and shape

    std::vector<int> seedMarkers() const;
    std::vector<std::pair<int, int>> basesOf(int marker) const;
    void trySeeds(std::size_t seedSize);
    void trySeed(int marker, const std::pair<int, int> &basis, int shape, std::size_t seedSize);
    Pairs supportOf(int marker, int shape, const Matrix2d &map) const;
    bool isKnownAlready(const Pairs &seed) const;
    bool mayBeShape(int marker, int shape) const;
    std::optional<GrownAssignment> grown(const Pairs &seed) const;
    std::optional<int> shapeNear(int marker, const GrownAssignment &state, const std::vector<bool> &used,
                                 const Vector2d &pixel, double reachPx) const;
    std::optional<Vector2d> predictedPixel(int marker, const GrownAssignment &state, bool fromAfar) const;
    void complete(GrownAssignment &state, std::vector<bool> &used) const;
    double spacingAt(int marker, const GrownAssignment &state, const Vector2d &pixel) const;
    void judge(GrownAssignment &state) const;
    bool isInImage(const Vector2d &pixel) const;

    const std::vector<Vector2d> &m_markers;
    const std::vector<MarkerShapeSeen> &m_shapes;
    const std::vector<int> &m_known;
    const Vector2d m_size;
    std::vector<std::vector<int>> m_aroundMarker, m_aroundShape;
    std::vector<GrownAssignment> m_found;
    std::size_t m_most = 0;
};

const Vector2d &at(const std::vector<Vector2d> &positions, int index)
{
    return positions[static_cast<std::size_t>(index)];
}

bool Growth::isInImage(const Vector2d &pixel) const
{
    return pixel.x() > 0 && pixel.y() > 0 && pixel.x() < m_size.x() && pixel.y() < m_size.y();
}

/// A known one alone; else some in the middle, then some spread over the layout.
std::vector<int> Growth::seedMarkers() const
{
    for (std::size_t i = 0; i < m_known.size(); ++i) {
        if (m_known[i] != nothing)
            return {static_cast<int>(i)};
    }
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d &marker : m_markers)
        middle += marker / static_cast<double>(m_markers.size());
    std::vector<int> order(m_markers.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](int i) { return (at(m_markers, i) - middle).norm(); });
    std::vector<int> seeds;
    for (std::size_t i = 0; i < mostSeedMarkers; ++i)
        seeds.push_back(order[i * (order.size() - 1) / mostSeedMarkers]);
    return seeds;
}

/// Pairs of near neighbours, in anticlockwise order, not in a line with the marker.
std::vector<std::pair<int, int>> Growth::basesOf(int marker) const
{
    std::vector<std::pair<int, int>> bases;
    const auto &around = m_aroundMarker[static_cast<std::size_t>(marker)];
    const std::size_t count = std::min(basisNeighbours, around.size());
    for (std::size_t j = 1; j < count && bases.size() < mostBases; ++j) {
        for (std::size_t i = 0; i < j && bases.size() < mostBases; ++i) {
            const Vector2d a = at(m_markers, around[i]) - at(m_markers, marker),
                           b = at(m_markers, around[j]) - at(m_markers, marker);
            const double turn = crossOf(a, b);
            if (std::abs(turn) < 0.5 * a.norm() * b.norm())
                continue;
            bases.push_back(turn > 0 ? std::pair(around[i], around[j]) : std::pair(around[j], around[i]));
        }
    }
    return bases;
}

bool Growth::mayBeShape(int marker, int shape) const
{
    const int fixed = m_known[static_cast<std::size_t>(marker)];
    return fixed != nothing ? fixed == shape : std::ranges::find(m_known, shape) == m_known.end();
}

/// The neighbours of a marker that have a shape where an affine map puts them.
Growth::Pairs Growth::supportOf(int marker, int shape, const Matrix2d &map) const
{
    Pairs pairs{{marker, shape}};
    const auto &around = m_aroundMarker[static_cast<std::size_t>(marker)];
    const Vector2d &origin = m_shapes[static_cast<std::size_t>(shape)].pixel;
    for (std::size_t i = 0; i < std::min(basisNeighbours, around.size()); ++i) {
        const Vector2d offset = map * (at(m_markers, around[i]) - at(m_markers, marker));
        int nearest = nothing;
        double away = seedReach * offset.norm();
        for (const int other : m_aroundShape[static_cast<std::size_t>(shape)]) {
            const double distance =
                (m_shapes[static_cast<std::size_t>(other)].pixel - origin - offset).norm();
            if (distance < away && mayBeShape(around[i], other)) {
                away = distance;
                nearest = other;
            }
        }
        const bool isUsed = std::ranges::any_of(pairs, [&](const auto &p) { return p.second == nearest; });
        if (nearest != nothing && !isUsed)
            pairs.emplace_back(around[i], nearest);
    }
    return pairs;
}

/// What was found already begins like this.
bool Growth::isKnownAlready(const Pairs &seed) const
{
    return std::ranges::any_of(m_found, [&](const GrownAssignment &found) {
        return std::ranges::count_if(seed, [&](const auto &pair) {
                   return found.shapes[static_cast<std::size_t>(pair.first)] == pair.second;
               }) >= 3;
    });
}

void Growth::trySeed(int marker, const std::pair<int, int> &basis, int shape, std::size_t seedSize)
{
    const MarkerShapeSeen &seen = m_shapes[static_cast<std::size_t>(shape)];
    Matrix2d from;
    from << at(m_markers, basis.first) - at(m_markers, marker),
        at(m_markers, basis.second) - at(m_markers, marker);
    const Matrix2d inverse = from.inverse();
    for (const int one : m_aroundShape[static_cast<std::size_t>(shape)]) {
        for (const int other : m_aroundShape[static_cast<std::size_t>(shape)]) {
            Matrix2d to;
            to << m_shapes[static_cast<std::size_t>(one)].pixel - seen.pixel,
                m_shapes[static_cast<std::size_t>(other)].pixel - seen.pixel;
            // Rows of an image run down: what turns left on the floor turns right in it.
            if (one == other || !(to.determinant() < 0))
                continue;
            const Matrix2d map = to * inverse;
            const Vector2d axes = Eigen::JacobiSVD<Matrix2d>(seen.round * map).singularValues();
            if (seen.areaPx > 0 && axes(0) > mostUnround * axes(1))
                continue;
            const Pairs seed = supportOf(marker, shape, map);
            if (seed.size() < seedSize || isKnownAlready(seed))
                continue;
            if (auto found = grown(seed)) {
                m_most = std::max(m_most, found->matched);
                m_found.push_back(std::move(*found));
            }
        }
    }
}

/// fromAfar: from others where few of the neighbours are there.
std::optional<Vector2d> Growth::predictedPixel(int marker, const GrownAssignment &state, bool fromAfar) const
{
    std::vector<std::pair<Vector2d, Vector2d>> pairs;
    const auto add = [&](int other) {
        const int shape = state.shapes[static_cast<std::size_t>(other)];
        if (shape != nothing)
            pairs.emplace_back(at(m_markers, other), m_shapes[static_cast<std::size_t>(shape)].pixel);
    };
    std::ranges::for_each(m_aroundMarker[static_cast<std::size_t>(marker)], add);
    if (fromAfar && pairs.size() < fewNeighbours) {
        pairs.clear();
        const auto of = static_cast<std::size_t>(marker);
        const auto away = [&](std::size_t i) {
            return state.shapes[i] == nothing ? std::numeric_limits<double>::infinity()
                                              : (m_markers[i] - m_markers[of]).norm();
        };
        std::ranges::for_each(nearestTo(of, m_markers.size(), farNeighbours, away), add);
    }
    return pairs.size() < leastSupport ? std::nullopt : predictedByNeighbours(at(m_markers, marker), pairs);
}

/// Pixels to the nearest neighbour of a marker.
double Growth::spacingAt(int marker, const GrownAssignment &state, const Vector2d &pixel) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const int other : m_aroundMarker[static_cast<std::size_t>(marker)]) {
        const int shape = state.shapes[static_cast<std::size_t>(other)];
        if (shape != nothing)
            least = std::min(least, (m_shapes[static_cast<std::size_t>(shape)].pixel - pixel).norm());
    }
    return least;
}

std::optional<int> Growth::shapeNear(int marker, const GrownAssignment &state, const std::vector<bool> &used,
                                     const Vector2d &pixel, double reachPx) const
{
    std::vector<double> areas;
    for (const int other : m_aroundMarker[static_cast<std::size_t>(marker)]) {
        const int shape = state.shapes[static_cast<std::size_t>(other)];
        if (shape != nothing && m_shapes[static_cast<std::size_t>(shape)].areaPx > 0)
            areas.push_back(m_shapes[static_cast<std::size_t>(shape)].areaPx);
    }
    std::ranges::sort(areas);
    const double usual = areas.empty() ? 0 : areas[areas.size() / 2];
    std::optional<int> nearest;
    for (std::size_t i = 0; i < m_shapes.size(); ++i) {
        const double away = (m_shapes[i].pixel - pixel).norm(), area = m_shapes[i].areaPx;
        const bool isAlike =
            usual == 0 || area == 0 || (area < mostAreaRatio * usual && usual < mostAreaRatio * area);
        if (away < reachPx && isAlike && !used[i] && mayBeShape(marker, static_cast<int>(i))) {
            reachPx = away;
            nearest = static_cast<int>(i);
        }
    }
    return nearest;
}

std::optional<GrownAssignment> Growth::grown(const Pairs &seed) const
{
    GrownAssignment state{std::vector<int>(m_markers.size(), nothing), 0, 0};
    std::vector<bool> used(m_shapes.size(), false), done(m_markers.size(), false);
    std::vector<int> support(m_markers.size(), 0);
    std::priority_queue<std::pair<int, int>> next; // those with the most neighbours first
    const auto give = [&](int marker, int shape) {
        state.shapes[static_cast<std::size_t>(marker)] = shape;
        used[static_cast<std::size_t>(shape)] = true;
        done[static_cast<std::size_t>(marker)] = true;
        ++state.matched;
        for (const int other : m_aroundMarker[static_cast<std::size_t>(marker)])
            next.emplace(++support[static_cast<std::size_t>(other)], other);
    };
    for (const auto &[marker, shape] : seed)
        give(marker, shape);
    std::size_t missed = 0;
    while (!next.empty()) {
        const int marker = next.top().second;
        next.pop();
        if (done[static_cast<std::size_t>(marker)])
            continue;
        const auto pixel = predictedPixel(marker, state, false);
        if (!pixel)
            continue;
        done[static_cast<std::size_t>(marker)] = true;
        if (!isInImage(*pixel))
            continue;
        const double reachPx = std::max(leastGrowReachPx, growReach * spacingAt(marker, state, *pixel));
        if (const auto shape = shapeNear(marker, state, used, *pixel, reachPx))
            give(marker, *shape);
        else if (++missed > state.matched - seed.size() + spareMisses ||
                 m_markers.size() - missed + 1 < m_most)
            return std::nullopt;
    }
    if (state.matched < leastMatched)
        return std::nullopt;
    judge(state);
    if (state.matched < leastMatched || !(state.misfit < mostGrownMisfit))
        return std::nullopt;
    complete(state, used);
    judge(state);
    if (state.matched < leastMatched || !(state.misfit < mostGrownMisfit))
        return std::nullopt;
    return state;
}

/// What was predicted before all its neighbours were there, or could not be.
void Growth::complete(GrownAssignment &state, std::vector<bool> &used) const
{
    for (std::size_t before = 0; before < state.matched;) {
        before = state.matched;
        for (int marker = 0; marker < static_cast<int>(m_markers.size()); ++marker) {
            int &to = state.shapes[static_cast<std::size_t>(marker)];
            const auto pixel = to == nothing ? predictedPixel(marker, state, true) : std::nullopt;
            if (!pixel || !isInImage(*pixel))
                continue;
            const double reachPx = std::max(leastGrowReachPx, growReach * spacingAt(marker, state, *pixel));
            if (const auto shape = shapeNear(marker, state, used, *pixel, reachPx)) {
                to = *shape;
                used[static_cast<std::size_t>(to)] = true;
                ++state.matched;
            }
        }
    }
}

/// Takes away what its neighbours do not predict, worst first, and measures the rest.
void Growth::judge(GrownAssignment &state) const
{
    for (;;) {
        std::vector<double> shares;
        double worst = 0, worstPx = 0;
        int odd = nothing;
        for (int marker = 0; marker < static_cast<int>(m_markers.size()); ++marker) {
            const int shape = state.shapes[static_cast<std::size_t>(marker)];
            const auto pixel = shape == nothing ? std::nullopt : predictedPixel(marker, state, true);
            if (!pixel)
                continue;
            const Vector2d &seen = m_shapes[static_cast<std::size_t>(shape)].pixel;
            const double away = (*pixel - seen).norm();
            shares.push_back(away / spacingAt(marker, state, seen));
            if (shares.back() > worst) {
                worst = shares.back();
                worstPx = away;
                odd = marker;
            }
        }
        state.misfit = std::numeric_limits<double>::infinity();
        if (shares.empty())
            return;
        const double squares = std::inner_product(shares.begin(), shares.end(), shares.begin(), 0.0);
        state.misfit = std::sqrt(squares / static_cast<double>(shares.size()));
        const double limit = std::clamp(ofMedian * upperMedian(std::move(shares)), leastOutlier, mostOutlier);
        if (worst < limit || worstPx < leastGrowReachPx)
            return;
        state.shapes[static_cast<std::size_t>(odd)] = nothing;
        --state.matched;
    }
}

void Growth::trySeeds(std::size_t seedSize)
{
    std::vector<int> seeds = seedMarkers();
    if (seedSize == seedSizes.back() && seeds.size() > fewSeedMarkers)
        seeds.resize(fewSeedMarkers);
    for (const int marker : seeds) {
        for (const auto &basis : basesOf(marker)) {
            for (int shape = 0; shape < static_cast<int>(m_shapes.size()); ++shape) {
                endIfCancelled();
                if (mayBeShape(marker, shape))
                    trySeed(marker, basis, shape, seedSize);
            }
        }
        // Whatever fits as well has this marker, too.
        if (m_most == m_markers.size())
            return;
    }
}

std::vector<GrownAssignment> Growth::run()
{
    // What fits as well as another has as many neighbours in their positions.
    for (const std::size_t seedSize : seedSizes) {
        if (2 * m_most < m_markers.size())
            trySeeds(seedSize);
    }
    std::ranges::stable_sort(m_found, [](const GrownAssignment &a, const GrownAssignment &b) {
        return std::pair(-static_cast<long>(a.matched), a.misfit) <
               std::pair(-static_cast<long>(b.matched), b.misfit);
    });
    std::vector<GrownAssignment> different;
    for (GrownAssignment &one : m_found) {
        if (std::ranges::none_of(different, [&](const auto &other) { return other.shapes == one.shapes; }))
            different.push_back(std::move(one));
    }
    return different;
}

} // namespace

std::vector<GrownAssignment> growAssignments(const std::vector<Vector2d> &markers,
                                             const std::vector<MarkerShapeSeen> &shapes,
                                             const std::vector<int> &known, const Vector2d &imageSizePx)
{
    if (markers.size() < leastMatched || shapes.size() < leastMatched)
        return {};
    return Growth(markers, shapes, known, imageSizePx).run();
}

} // namespace odo
