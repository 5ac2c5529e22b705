// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/clip_synchronisation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double halfWindowS = 0.2;      // of the smoothing: robots do not turn sharply within it
constexpr double longestBridgeS = 0.15;  // positions further apart are not joined
constexpr double correlationTimeS = 0.5; // of what is left when the tracks lie on one another
constexpr std::size_t fewestPairs = 30;

tl::unexpected<Error> undetermined(const std::string &why)
{
    return fail(ErrorCode::Undetermined, "synchronisation of the clips", why,
                "give the offset by hand, with --sync SECONDS");
}

double medianStepS(const std::vector<TimedPosition> &track)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < track.size(); ++i)
        steps.push_back(track[i].timeS - track[i - 1].timeS);
    if (steps.empty())
        return 0;
    std::nth_element(steps.begin(), steps.begin() + std::ptrdiff_t(steps.size() / 2), steps.end());
    return steps[steps.size() / 2];
}

struct PlaceAndVelocity
{
    Eigen::Vector2d point, velocity;
};

/// The track at a time, by a parabola fitted to what lies within ±0.2 s, nearer positions weighing more (local quadratic
/// regression, Cleveland 1979). Plain interpolation between two noisy positions will not do: its noise is least half-way
/// between them, which draws the offset towards half frames. nullopt outside the track and where it has a gap.
std::optional<PlaceAndVelocity> trackAt(const std::vector<TimedPosition> &track, double timeS)
{
    const auto isBefore = [](const TimedPosition &p, double t) { return p.timeS < t; };
    const auto begin = std::lower_bound(track.begin(), track.end(), timeS - halfWindowS, isBefore);
    const auto end = std::lower_bound(begin, track.end(), timeS + halfWindowS, isBefore);
    if (begin == end || begin->timeS > timeS - halfWindowS / 2 || (end - 1)->timeS < timeS + halfWindowS / 2)
        return std::nullopt;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
    for (auto p = begin; p != end; ++p) {
        if (p != begin && p->timeS - (p - 1)->timeS > longestBridgeS)
            return std::nullopt;
        const double u = (p->timeS - timeS) / halfWindowS;
        const double weight = std::pow(1 - std::abs(u * u * u), 3);
        const Eigen::Vector3d powers(1, u, u * u);
        normal += weight * powers * powers.transpose();
        right += weight * powers * p->pointInWorld.transpose();
    }
    const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
    if (solver.info() != Eigen::Success || solver.vectorD().minCoeff() < 1e-6 * solver.vectorD().maxCoeff())
        return std::nullopt;
    const Eigen::Matrix<double, 3, 2> parabola = solver.solve(right);
    return PlaceAndVelocity{parabola.row(0).transpose(), parabola.row(1).transpose() / halfWindowS};
}

/// How well the tracks lie on one another at one offset.
struct Agreement
{
    std::size_t pairs = 0;
    double variance = 0;       ///< m², of the difference about its mean
    double velocitySpread = 0; ///< Σ|v − mean v|², the information on the offset
    double step = 0;           ///< Gauss–Newton step of the offset
    double motionVariance = 0; ///< m², of the second track's positions about their mean
};

Agreement agreementAt(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second, double offsetS)
{
    std::vector<Eigen::Vector2d> differences, velocities, points;
    for (const TimedPosition &p : first) {
        if (const auto other = trackAt(second, p.timeS - offsetS)) {
            differences.push_back(p.pointInWorld - other->point);
            velocities.push_back(other->velocity);
            points.push_back(other->point);
        }
    }
    Agreement result;
    result.pairs = differences.size();
    if (differences.empty())
        return result;
    Eigen::Vector2d meanDifference = Eigen::Vector2d::Zero(), meanVelocity = meanDifference, meanPoint = meanDifference;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        meanDifference += differences[i];
        meanVelocity += velocities[i];
        meanPoint += points[i];
    }
    const double n = double(differences.size());
    meanDifference /= n;
    meanVelocity /= n;
    meanPoint /= n;
    double gradient = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        const Eigen::Vector2d residual = differences[i] - meanDifference;
        const Eigen::Vector2d velocity = velocities[i] - meanVelocity;
        result.variance += residual.squaredNorm() / n;
        result.velocitySpread += velocity.squaredNorm();
        result.motionVariance += (points[i] - meanPoint).squaredNorm() / n;
        gradient += residual.dot(velocity);
    }
    // d(residual)/d(offset) = +velocity, for the second track is read at t − offset.
    result.step = result.velocitySpread > 0 ? -gradient / result.velocitySpread : 0;
    return result;
}

struct Candidate
{
    double offsetS = 0;
    double variance = 0;
};

/// The best offset on the grid, and the best one at least half a second away from it.
struct GridSearch
{
    std::optional<Candidate> best, rival;
};

GridSearch searchGrid(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second, double stepS,
                      double longestOffsetS)
{
    const std::size_t enough = std::max(fewestPairs, std::min(first.size(), second.size()) / 2);
    std::vector<Candidate> candidates;
    const int steps = int(std::ceil(longestOffsetS / stepS));
    for (int i = -steps; i <= steps; ++i) {
        const Agreement agreement = agreementAt(first, second, i * stepS);
        if (agreement.pairs >= enough)
            candidates.push_back({i * stepS, agreement.variance});
    }
    GridSearch found;
    for (const Candidate &c : candidates) {
        if (!found.best || c.variance < found.best->variance)
            found.best = c;
    }
    for (const Candidate &c : candidates) {
        if (std::abs(c.offsetS - found.best->offsetS) > 0.5 && (!found.rival || c.variance < found.rival->variance))
            found.rival = c;
    }
    return found;
}

/// Gauss–Newton from a point of the grid.
double refine(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second, double offsetS,
              double frameS)
{
    for (int iteration = 0; iteration < 10; ++iteration) {
        const double step = agreementAt(first, second, offsetS).step;
        offsetS += std::clamp(step, -frameS, frameS);
        if (std::abs(step) < 1e-6)
            break;
    }
    return offsetS;
}

} // namespace

Result<ClipOffset> estimateClipOffset(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                                      double longestOffsetS)
{
    if (first.size() < fewestPairs || second.size() < fewestPairs)
        return undetermined("one view saw the robot in fewer than " + std::to_string(fewestPairs) + " pictures");
    const double frameS = std::max(medianStepS(first), 1e-3);
    const GridSearch grid = searchGrid(first, second, frameS / 2, longestOffsetS);
    if (!grid.best)
        return undetermined("the views hardly ever saw the robot at the same time");

    const double offsetS = refine(first, second, grid.best->offsetS, frameS);
    const Agreement there = agreementAt(first, second, offsetS);
    const double independent = std::max(1.0, correlationTimeS / frameS);
    const double noise = std::max(there.variance, 1e-6); // never surer than 1 mm of disagreement
    ClipOffset result;
    result.offsetS = offsetS;
    result.sigmaS = there.velocitySpread > 0 ? std::sqrt(noise * independent / 2 / there.velocitySpread) : 1e9;
    result.score = there.motionVariance > 0 ? std::clamp(1 - there.variance / there.motionVariance, 0.0, 1.0) : 0;
    if (result.sigmaS > frameS)
        return undetermined("the robot stood still or ran straight at constant speed, so every offset fits");
    if (result.score < 0.8)
        return undetermined("the views' tracks do not resemble one another");
    if (!grid.rival)
        return result;
    const double rivalS = refine(first, second, grid.rival->offsetS, frameS);
    if (agreementAt(first, second, rivalS).variance < 2 * noise)
        return undetermined("the motion repeats itself: offsets of " + std::to_string(offsetS) + " s and " + std::to_string(rivalS) +
                            " s fit alike");
    return result;
}

} // namespace odo
