// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/clock_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double restCorrelationS = 0.5; // of what is left when the tracks lie on one another
constexpr double searchedRate = 0.03;    // beyond what is taken, for a rate at the end is none
constexpr double scaleSigma = 0.01;   // a given height that is 6 cm wrong, seen from cameras at 2 and at 3 m
constexpr double largestScale = 0.05; // more is no height: a motion in the opposite direction, say

/// The integral of the autocorrelation, up to where it falls to a twentieth.
double correlationS(const std::vector<Eigen::Vector2d> &remaining, const std::vector<double> &timesS,
                    double variance)
{
    const std::size_t count = remaining.size();
    if (count < 2 * fewestPairs || variance <= 0)
        return restCorrelationS;
    const double stepS = (timesS.back() - timesS.front()) / double(count - 1);
    double sum = 1;
    for (std::size_t lag = 1; lag < count / 4; ++lag) {
        double product = 0;
        for (std::size_t i = lag; i < count; ++i)
            product += remaining[i].dot(remaining[i - lag]);
        const double correlation = product / double(count - lag) / variance;
        if (correlation < 0.05)
            break;
        sum += 2 * correlation;
        if (sum * stepS > restCorrelationS)
            break;
    }
    return sum * stepS;
}

} // namespace

Pairs pairsAt(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
              const ClockGuess &guess, std::size_t stride)
{
    Pairs pairs;
    for (std::size_t i = 0; i < first.size(); i += stride) {
        const double sinceStartS = first[i].timeS - guess.offsetS;
        const auto other = trackAt(second, sinceStartS * (1 + guess.rate));
        if (!other)
            continue;
        pairs.sinceStartS.push_back(sinceStartS);
        pairs.differences.emplace_back(first[i].pointInWorld - other->point);
        pairs.velocities.push_back(other->velocity);
        pairs.velocityVariances.push_back(other->velocityVariance);
        pairs.points.push_back(other->point);
        pairs.middle += other->point;
    }
    pairs.middle /= std::max(1.0, double(pairs.size()));
    for (Eigen::Vector2d &point : pairs.points) {
        point -= pairs.middle;
        pairs.motionVariance += point.squaredNorm() / double(pairs.size());
    }
    return pairs;
}

Agreement agreementOf(const Pairs &pairs, bool withRate, const std::vector<LagChange> &changes,
                      double noiseM2)
{
    const auto clock = static_cast<Eigen::Index>(2 + changes.size()), all = clock + 3;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(all, all);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(all);
    Eigen::MatrixXd fromNoise = Eigen::MatrixXd::Zero(clock, clock);
    Eigen::MatrixXd rows(2, all);
    Eigen::VectorXd lever(clock);
    const auto setRows = [&](std::size_t i) {
        lever[0] = 1;
        lever[1] = withRate ? -pairs.sinceStartS[i] : 0.0;
        for (std::size_t c = 0; c < changes.size(); ++c)
            lever[Eigen::Index(2 + c)] = pairs.sinceStartS[i] > changes[c].fromS ? 1 : 0;
        rows << pairs.velocities[i] * lever.transpose(), Eigen::Matrix2d::Identity(), pairs.points[i];
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        setRows(i);
        normal.noalias() += rows.transpose().lazyProduct(rows);
        right.noalias() -= rows.transpose().lazyProduct(pairs.differences[i]);
        fromNoise += pairs.velocityVariances[i] * lever * lever.transpose();
    }
    normal(all - 1, all - 1) += noiseM2 / (scaleSigma * scaleSigma);
    Agreement result;
    result.step = Eigen::VectorXd::Zero(clock);
    result.information = Eigen::MatrixXd::Zero(clock, clock);
    if (pairs.size() == 0)
        return result;
    const Eigen::LDLT<Eigen::Matrix3d> nuisance(Eigen::Matrix3d(normal.bottomRightCorner<3, 3>()));
    const Eigen::MatrixXd coupling = normal.bottomLeftCorner(3, clock);
    Eigen::Vector3d left = nuisance.solve(right.tail<3>());
    // The points lie about their mean, so that the shift does not depend on the scale.
    left.z() = std::clamp(left.z(), -largestScale, largestScale);
    result.lie = {-left.head<2>(), pairs.middle, -left.z()};
    std::vector<Eigen::Vector2d> remaining;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        remaining.emplace_back(pairs.differences[i] + left.head<2>() + left.z() * pairs.points[i]);
        result.leftM2.push_back(remaining.back().squaredNorm());
        result.variance += result.leftM2.back() / double(pairs.size());
    }
    result.correlatedS = correlationS(remaining, pairs.sinceStartS, result.variance);

    Eigen::MatrixXd schur =
        normal.topLeftCorner(clock, clock) - coupling.transpose() * nuisance.solve(coupling);
    Eigen::VectorXd gradient = right.head(clock) - coupling.transpose() * left;
    result.information = schur - fromNoise;
    if (!withRate) {
        schur(1, 1) = 1;
        gradient[1] = 0;
    }
    const Eigen::VectorXd step = schur.ldlt().solve(gradient);
    result.predicted = result.variance;
    if (step.allFinite()) {
        result.step = step;
        result.predicted -= gradient.dot(step) / double(pairs.size());
    }
    return result;
}

double independentVariance(double variance, double frameS)
{
    const double least = 1e-6; // never surer than 1 mm of disagreement
    return std::max(variance, least) / 2 * std::max(1.0, restCorrelationS / frameS);
}

Fit refine(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
           ClockGuess guess, bool withRate, double frameS)
{
    double noise = independentVariance(0, frameS);
    Fit fit;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const Pairs pairs = pairsAt(first, second, guess, 1);
        fit = {guess, agreementOf(pairs, withRate, {}, noise), pairs.motionVariance, pairs.size()};
        noise = independentVariance(fit.agreement.variance, frameS);
        const Eigen::VectorXd step = fit.agreement.step;
        if (iteration > 1 && std::abs(step[0]) < 1e-6 && std::abs(step[1]) < 1e-8)
            break;
        guess.offsetS += std::clamp(step[0], -frameS, frameS);
        guess.rate = std::clamp(guess.rate + step[1], -searchedRate, searchedRate);
    }
    return fit;
}

} // namespace odo
