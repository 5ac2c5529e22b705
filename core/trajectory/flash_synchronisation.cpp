// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/flash_synchronisation.h"

#include "core/base/units.h"
#include "core/base/upper_median.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double forAPair = 5.7;        ///< log-likelihood: ln 300
constexpr double againstAMiss = 2.3;    ///< ln 10
constexpr double clearLead = 5;         ///< ln 150
constexpr double shutterSigma = 0.1;    ///< of the frame interval
constexpr double toleranceSigmas = 4;
constexpr double usualRate = 2e-4; ///< by which clocks may differ while edges are paired
constexpr double shortestRateSpanS = 20;
constexpr std::size_t fewestForRate = 3;
constexpr std::size_t mostEdges = 200;  ///< more is a lamp that flickers, and tells nothing

struct Pair
{
    double firstS = 0, secondS = 0; ///< each by its own clock
    double variance = 0;            ///< of their difference, s²

    double offsetS() const { return firstS - secondS; }
};

/// What speaks for an offset, and against it.
struct Proposal
{
    double offsetS = 0;
    std::vector<Pair> pairs;
    std::size_t missed = 0;

    double likelihood() const { return forAPair * double(pairs.size()) - againstAMiss * double(missed); }
};

class EdgePairing
{
public:
    EdgePairing(const LightCourse &first, const LightCourse &second) : m_first(first), m_second(second) {}

    std::vector<Proposal> proposals() const
    {
        std::vector<Proposal> all;
        for (const LightEdge &a : m_first.edges) {
            for (const LightEdge &b : m_second.edges) {
                if (a.brighter == b.brighter)
                    all.push_back(proposal(a, b));
            }
        }
        return all;
    }

private:
    double varianceOf(const LightEdge &a, const LightEdge &b) const
    {
        return a.sigmaS * a.sigmaS + b.sigmaS * b.sigmaS;
    }
    double toleranceS(const LightEdge &a, const LightEdge &b, double sinceS) const
    {
        const double shutterS = shutterSigma * std::hypot(m_first.frameS, m_second.frameS);
        return toleranceSigmas * std::sqrt(varianceOf(a, b) + shutterS * shutterS) + usualRate * std::abs(sinceS);
    }
    /// Whether an edge at a time of a view is far enough from its ends to be seen.
    static bool isWithin(const LightCourse &view, double timeS)
    {
        const double marginS = 3 * view.frameS;
        return timeS > marginS && timeS < view.durationS - marginS;
    }

    /// The offset at which a and b are one, and what becomes of the other edges: each is paired with the nearest.
    Proposal proposal(const LightEdge &a, const LightEdge &b) const
    {
        Proposal result;
        result.offsetS = a.timeS - b.timeS;
        std::vector<bool> taken(m_second.edges.size(), false);
        for (const LightEdge &edge : m_first.edges) {
            const double there = edge.timeS - result.offsetS;
            std::optional<std::size_t> best;
            for (std::size_t i = 0; i < m_second.edges.size(); ++i) {
                const LightEdge &other = m_second.edges[i];
                const double apartS = std::abs(other.timeS - there);
                if (!taken[i] && other.brighter == edge.brighter &&
                    apartS < toleranceS(edge, other, edge.timeS - a.timeS) &&
                    (!best || apartS < std::abs(m_second.edges[*best].timeS - there)))
                    best = i;
            }
            if (best) {
                taken[*best] = true;
                const LightEdge &other = m_second.edges[*best];
                result.pairs.push_back({edge.timeS, other.timeS, varianceOf(edge, other)});
            } else if (isWithin(m_second, there)) {
                ++result.missed;
            }
        }
        for (std::size_t i = 0; i < m_second.edges.size(); ++i) {
            if (!taken[i] && isWithin(m_first, m_second.edges[i].timeS + result.offsetS))
                ++result.missed;
        }
        return result;
    }

    const LightCourse &m_first, &m_second;
};

/// Weighted least squares of firstS = offset + secondS · (1 − rate), or with the rate left at 0.
struct Line
{
    double offsetS = 0, rate = 0, offsetSigmaS = 0, rateSigma = 0;
};

Line lineThrough(const std::vector<Pair> &pairs, bool withRate)
{
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const Pair &pair : pairs) {
        const Eigen::Vector2d row(1, withRate ? -pair.secondS : 0.0);
        normal += row * row.transpose() / pair.variance;
        right += row * pair.offsetS() / pair.variance;
    }
    if (!withRate)
        normal(1, 1) = 1;
    const Eigen::Matrix2d covariance = normal.inverse();
    const Eigen::Vector2d solved = covariance * right;
    double chiSquare = 0;
    for (const Pair &pair : pairs) {
        const double residual = pair.offsetS() - solved.x() + (withRate ? solved.y() * pair.secondS : 0.0);
        chiSquare += residual * residual / pair.variance;
    }
    const double freedom = std::max(1.0, double(pairs.size()) - (withRate ? 2 : 1));
    const double scatter = std::sqrt(std::max(1.0, chiSquare / freedom));
    return {solved.x(), withRate ? solved.y() : 0.0, scatter * std::sqrt(covariance(0, 0)),
            withRate ? scatter * std::sqrt(covariance(1, 1)) : 0.0};
}

double spanS(const std::vector<Pair> &pairs)
{
    const auto [from, to] = std::minmax_element(
        pairs.begin(), pairs.end(), [](const Pair &a, const Pair &b) { return a.secondS < b.secondS; });
    return to->secondS - from->secondS;
}

ClipOffset flashOffset(const Proposal &proposal, double shutterS)
{
    const std::vector<Pair> &pairs = proposal.pairs;
    Line line = lineThrough(pairs, false);
    ClipOffset result;
    if (pairs.size() >= fewestForRate && spanS(pairs) > shortestRateSpanS) {
        const Line tilted = lineThrough(pairs, true);
        result.rateSigma = tilted.rateSigma;
        if (std::abs(tilted.rate) > 3 * tilted.rateSigma && std::abs(tilted.rate) < largestClockRate)
            line = tilted;
    }
    result.offsetS = line.offsetS;
    result.sigmaS = std::hypot(line.offsetSigmaS, shutterS);
    result.rate = line.rate;
    result.score = double(pairs.size()) / double(pairs.size() + proposal.missed);
    return result;
}

/// Whether two proposals pair the same edges, some of them at least. They come from different pairs, and their offsets
/// differ by what the clocks gained from one to the other.
bool isSame(const Proposal &a, const Proposal &b)
{
    return std::any_of(a.pairs.begin(), a.pairs.end(), [&b](const Pair &pair) {
        return std::any_of(b.pairs.begin(), b.pairs.end(), [&pair](const Pair &other) {
            return pair.firstS == other.firstS && pair.secondS == other.secondS;
        });
    });
}

} // namespace

LightCourse lightCourseOf(const std::vector<LightLevel> &levels)
{
    LightCourse course{findLightEdges(levels), 0, 0};
    std::vector<double> intervals;
    for (std::size_t i = 1; i < levels.size(); ++i)
        intervals.push_back(toSeconds(levels[i].time - levels[i - 1].time));
    if (!intervals.empty()) {
        course.frameS = upperMedian(std::move(intervals));
        course.durationS = toSeconds(levels.back().time) + course.frameS;
    }
    return course;
}

Result<ClipOffset> estimateFlashOffset(const LightCourse &first, const LightCourse &second)
{
    if (first.edges.empty() && second.edges.empty())
        return undeterminedOffset("neither view shows a flash of light");
    if (first.edges.empty() || second.edges.empty())
        return undeterminedOffset("only one of the views shows a flash of light");
    if (std::max(first.edges.size(), second.edges.size()) > mostEdges)
        return undeterminedOffset("the light flickers");
    const std::vector<Proposal> proposals = EdgePairing(first, second).proposals();
    const auto best = std::max_element(
        proposals.begin(), proposals.end(),
        [](const Proposal &a, const Proposal &b) { return a.likelihood() < b.likelihood(); });
    if (best == proposals.end() || best->likelihood() <= 0)
        return undeterminedOffset("the flashes of light in the views do not belong together");
    for (const Proposal &rival : proposals) {
        if (!isSame(*best, rival) && rival.likelihood() > best->likelihood() - clearLead)
            return undeterminedOffset("the flashes of light fit alike at offsets of " +
                                      formatNumber(best->offsetS, 2) + " s and " +
                                      formatNumber(rival.offsetS, 2) + " s");
    }
    return flashOffset(*best, shutterSigma * std::hypot(first.frameS, second.frameS));
}

} // namespace odo
