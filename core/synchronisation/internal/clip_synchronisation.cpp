// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/clip_synchronisation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

namespace odo {

namespace {

constexpr double halfWindowS = 0.2;      // of the smoothing: robots do not turn sharply within it
constexpr double longestBridgeS = 0.15;  // positions further apart are not joined
constexpr double restCorrelationS = 0.5; // of what is left when the tracks lie on one another
constexpr std::size_t fewestPairs = 30;
constexpr double scaleSigma = 0.01;   // a given height that is 6 cm wrong, seen from cameras at 2 and at 3 m
constexpr double largestScale = 0.05; // more is no height: a motion in the opposite direction, say
constexpr double closestRivalS = 0.5; // nearer ones are the same
constexpr std::size_t searchedPairs = 1000; // on the grid
constexpr double finestStepS = 1.0 / 60;    // robots move evenly within it

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

/// The means of neighbouring positions of a fast camera: they carry the same information, and the search time
/// falls with the square of their number. A group ends at a gap.
std::vector<TimedPosition> thinned(const std::vector<TimedPosition> &track)
{
    const double stepS = medianStepS(track);
    const auto inAGroup = stepS > 0 ? static_cast<std::size_t>(1.01 * finestStepS / stepS) : 1;
    if (inAGroup < 2)
        return track;
    std::vector<TimedPosition> means;
    for (std::size_t begin = 0, end = 0; begin < track.size(); begin = end) {
        TimedPosition sum{0, Eigen::Vector2d::Zero()};
        do {
            sum.timeS += track[end].timeS;
            sum.pointInWorld += track[end].pointInWorld;
            ++end;
        } while (end < track.size() && end - begin < inAGroup &&
                 track[end].timeS - track[end - 1].timeS < finestStepS);
        const auto count = static_cast<double>(end - begin);
        means.push_back({sum.timeS / count, sum.pointInWorld / count});
    }
    return means;
}

struct PositionAndVelocity
{
    Eigen::Vector2d point, velocity;
    double velocityVariance =
        0; ///< of both components together, from how the positions scatter about the parabola
};

/// The track at a time, by a parabola fitted to what lies within ±0.2 s, nearer positions weighing more
/// (local quadratic regression, Cleveland 1979). Plain interpolation between two noisy positions will not do:
/// its noise is least half-way between them, which draws the offset towards half frames. nullopt outside the
/// track and where it has a gap.
std::optional<PositionAndVelocity> trackAt(const std::vector<TimedPosition> &track, double timeS)
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
    double squares = 0;
    for (auto p = begin; p != end; ++p) {
        const double u = (p->timeS - timeS) / halfWindowS;
        squares += (p->pointInWorld - parabola.transpose() * Eigen::Vector3d(1, u, u * u)).squaredNorm();
    }
    const double variance = squares / std::max(1.0, double(end - begin) - 3);
    const double gain = solver.solve(Eigen::Vector3d(0, 1, 0)).y() / (halfWindowS * halfWindowS);
    return PositionAndVelocity{parabola.row(0).transpose(), parabola.row(1).transpose() / halfWindowS,
                               variance * gain};
}

/// How the second view's times are mapped to the first's.
struct ClockGuess
{
    double offsetS = 0, rate = 0;
};

/// The two tracks at equal times under a guess.
struct Pairs
{
    std::vector<double> sinceStartS;                              ///< of the second clip
    std::vector<Eigen::Vector2d> differences, velocities, points; ///< points about their mean
    std::vector<double> velocityVariances;
    double motionVariance = 0; ///< m², of the second track's positions about their mean

    std::size_t size() const { return differences.size(); }
};

Pairs pairsAt(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
              const ClockGuess &guess, std::size_t stride)
{
    Pairs pairs;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
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
        mean += other->point;
    }
    mean /= std::max(1.0, double(pairs.size()));
    for (Eigen::Vector2d &point : pairs.points) {
        point -= mean;
        pairs.motionVariance += point.squaredNorm() / double(pairs.size());
    }
    return pairs;
}

/// How well the tracks match under a guess, and how to improve it.
struct Agreement
{
    double variance = 0;                                   ///< m², of what shift and scale leave
    Eigen::Vector2d step = Eigen::Vector2d::Zero();        ///< Gauss–Newton step of offset and rate
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero(); ///< on offset and rate, per m² of noise
};

/// One linear least-squares problem in (offset, rate, shift x, shift y, scale). Near the guess the difference
/// changes by +v for each second of offset and by −v·u for each unit of rate, u the time since the clip's
/// start. noiseM2: variance of an independent residual, against which the scale's prior weighs.
Agreement agreementOf(const Pairs &pairs, bool withRate, double noiseM2)
{
    using Rows = Eigen::Matrix<double, 2, 5>;
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
    Eigen::Matrix2d fromNoise = Eigen::Matrix2d::Zero();
    const auto rowsOf = [&](std::size_t i) {
        Rows rows;
        rows << pairs.velocities[i], -pairs.velocities[i] * (withRate ? pairs.sinceStartS[i] : 0.0),
            Eigen::Matrix2d::Identity(), pairs.points[i];
        return rows;
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Rows rows = rowsOf(i);
        normal += rows.transpose() * rows;
        right -= rows.transpose() * pairs.differences[i];
        const Eigen::Vector2d lever(1, withRate ? -pairs.sinceStartS[i] : 0.0);
        fromNoise += pairs.velocityVariances[i] * lever * lever.transpose();
    }
    normal(4, 4) += noiseM2 / (scaleSigma * scaleSigma);
    Agreement result;
    if (pairs.size() == 0)
        return result;
    const Eigen::LDLT<Eigen::Matrix3d> nuisance(Eigen::Matrix3d(normal.bottomRightCorner<3, 3>()));
    const Eigen::Matrix<double, 3, 2> coupling = normal.bottomLeftCorner<3, 2>();
    Eigen::Vector3d left = nuisance.solve(right.tail<3>());
    // The points lie about their mean, so that the shift does not depend on the scale.
    left.z() = std::clamp(left.z(), -largestScale, largestScale);
    for (std::size_t i = 0; i < pairs.size(); ++i)
        result.variance +=
            (pairs.differences[i] + rowsOf(i).rightCols<3>() * left).squaredNorm() / double(pairs.size());

    Eigen::Matrix2d schur = normal.topLeftCorner<2, 2>() - coupling.transpose() * nuisance.solve(coupling);
    Eigen::Vector2d gradient = right.head<2>() - coupling.transpose() * left;
    result.information = schur - fromNoise;
    if (!withRate) {
        schur(1, 1) = 1;
        gradient.y() = 0;
    }
    const Eigen::Vector2d step = schur.ldlt().solve(gradient);
    if (step.allFinite())
        result.step = step;
    return result;
}

/// Variance of one residual as if each stood alone, though neighbours share what is left.
double independentVariance(double variance, double frameS)
{
    const double least = 1e-6; // never surer than 1 mm of disagreement
    return std::max(variance, least) / 2 * std::max(1.0, restCorrelationS / frameS);
}

struct Candidate
{
    double offsetS = 0;
    double variance = 0;
};

/// The best offset on the grid, and the best one of those away from it to which every way leads uphill.
struct GridSearch
{
    std::optional<Candidate> best, rival;
};

GridSearch searchGrid(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                      double frameS, const OffsetRange &range)
{
    const std::size_t stride = 1 + first.size() / searchedPairs;
    const std::size_t enough = std::max(fewestPairs, std::min(first.size(), second.size()) / 2) / stride;
    const double stepS = frameS / 2;
    std::vector<Candidate> candidates;
    const int steps = int(std::ceil(range.halfWidthS / stepS));
    for (int i = -steps; i <= steps; ++i) {
        const double offsetS = range.middleS + i * stepS;
        const Pairs pairs = pairsAt(first, second, {offsetS, 0}, stride);
        if (pairs.size() >= enough)
            candidates.push_back(
                {offsetS, agreementOf(pairs, false, independentVariance(0, frameS)).variance});
    }
    GridSearch found;
    for (const Candidate &c : candidates) {
        if (!found.best || c.variance < found.best->variance)
            found.best = c;
    }
    for (std::size_t i = 1; i + 1 < candidates.size(); ++i) {
        const Candidate &c = candidates[i];
        const bool lowest =
            c.variance <= candidates[i - 1].variance && c.variance <= candidates[i + 1].variance;
        if (lowest && std::abs(c.offsetS - found.best->offsetS) > closestRivalS &&
            (!found.rival || c.variance < found.rival->variance))
            found.rival = c;
    }
    return found;
}

/// A guess bettered as far as it goes.
struct Fit
{
    ClockGuess clock;
    Agreement agreement;
    double motionVariance = 0;
};

/// Gauss–Newton from a guess.
Fit refine(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
           ClockGuess guess, bool withRate, double frameS)
{
    double noise = independentVariance(0, frameS);
    Fit fit;
    for (int iteration = 0; iteration < 20; ++iteration) {
        const Pairs pairs = pairsAt(first, second, guess, 1);
        fit = {guess, agreementOf(pairs, withRate, noise), pairs.motionVariance};
        noise = independentVariance(fit.agreement.variance, frameS);
        const Eigen::Vector2d step = fit.agreement.step;
        if (iteration > 1 && std::abs(step.x()) < 1e-6 && std::abs(step.y()) < 1e-8)
            break;
        guess.offsetS += std::clamp(step.x(), -frameS, frameS);
        guess.rate = std::clamp(guess.rate + step.y(), -2 * largestClockRate, 2 * largestClockRate);
    }
    return fit;
}

ClipOffset offsetFrom(const Fit &fit, double frameS)
{
    const double noise = independentVariance(fit.agreement.variance, frameS),
                 given = fit.agreement.information(0, 0);
    ClipOffset result;
    result.offsetS = fit.clock.offsetS;
    result.sigmaS = given > 0 ? std::sqrt(noise / given) : 1e9;
    result.score =
        fit.motionVariance > 0 ? std::clamp(1 - fit.agreement.variance / fit.motionVariance, 0.0, 1.0) : 0;
    return result;
}

/// Fits the rate as well, if the motion determines it.
ClipOffset withRate(const ClipOffset &plain, const Fit &plainFit, const Fit &fit, double frameS)
{
    const Eigen::Matrix2d &given = fit.agreement.information;
    ClipOffset result = plain;
    if (given(0, 0) <= 0 || given(1, 1) <= 0 || given.determinant() <= 0)
        return result;
    const Eigen::Matrix2d covariance = independentVariance(fit.agreement.variance, frameS) * given.inverse();
    result.rateSigma = std::sqrt(covariance(1, 1));
    if (std::abs(fit.clock.rate) <= 3 * result.rateSigma || std::abs(fit.clock.rate) > largestClockRate ||
        fit.agreement.variance >= plainFit.agreement.variance)
        return result;
    result = offsetFrom(fit, frameS);
    result.sigmaS = std::sqrt(covariance(0, 0));
    result.rate = fit.clock.rate;
    result.rateSigma = std::sqrt(covariance(1, 1));
    return result;
}

} // namespace

Message clipsSubject()
{
    return ODO_TEXT("synchronisation.of_clips", "synchronisation of the clips");
}

tl::unexpected<Error> undeterminedOffset(Message why)
{
    return fail(ErrorCode::Undetermined, clipsSubject(), std::move(why),
                ODO_TEXT("synchronisation.flash_lights",
                         "flash the room lights once while both cameras record, or give --sync SECONDS"));
}

Result<ClipOffset> estimateClipOffset(const std::vector<TimedPosition> &firstTrack,
                                      const std::vector<TimedPosition> &secondTrack, const OffsetRange &range)
{
    if (firstTrack.size() < fewestPairs || secondTrack.size() < fewestPairs)
        return undeterminedOffset(ODO_TEXT("synchronisation.seldom_seen",
                                           "one view saw the robot in fewer than %1 frames")(fewestPairs));
    const std::vector<TimedPosition> first = thinned(firstTrack), second = thinned(secondTrack);
    const double frameS = std::max(medianStepS(first), 1e-3);
    const GridSearch grid = searchGrid(first, second, frameS, range);
    if (!grid.best)
        return undeterminedOffset(
            ODO_TEXT("synchronisation.seldom_together", "the views rarely saw the robot at the same time"));

    const Fit fit = refine(first, second, {grid.best->offsetS, 0}, false, frameS);
    const ClipOffset plain = offsetFrom(fit, frameS);
    if (plain.sigmaS > frameS)
        return undeterminedOffset(
            ODO_TEXT("synchronisation.every_offset_fits",
                     "the robot stood still or ran straight at constant speed, so every time offset fits"));
    if (plain.score < 0.8)
        return undeterminedOffset(
            ODO_TEXT("synchronisation.tracks_differ", "the views' tracks do not resemble one another"));
    if (std::abs(plain.offsetS - range.middleS) > range.halfWidthS + frameS)
        return undeterminedOffset(ODO_TEXT("synchronisation.no_offset_fits",
                                           "the views' tracks do not match at any time offset tried"));
    if (grid.rival) {
        const Fit rival = refine(first, second, {grid.rival->offsetS, 0}, false, frameS);
        if (std::abs(rival.clock.offsetS - plain.offsetS) > closestRivalS / 2 &&
            rival.agreement.variance < 2 * std::max(fit.agreement.variance, 1e-6))
            return undeterminedOffset(joined(
                {ODO_TEXT("synchronisation.motion_repeats", "the motion repeats itself"),
                 ODO_TEXT("synchronisation.offsets_fit_alike", "time offsets of %1 and %2 fit equally well")(
                     quantity(plain.offsetS, 6, "s"), quantity(rival.clock.offsetS, 6, "s"))},
                Join::Colon));
    }
    return withRate(plain, fit, refine(first, second, fit.clock, true, frameS), frameS);
}

} // namespace odo
