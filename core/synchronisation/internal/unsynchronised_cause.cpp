// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/unsynchronised_cause.h"

#include "core/base/percentile.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double noiseTimes = 3, leastLeftM = 0.004; ///< of what a uniform motion may leave
constexpr double restM = 0.01;
constexpr double sameFormShare = 0.002, farBetter = 10; ///< of the motion's variance; than by a shift
constexpr double formStepS = 0.05;
constexpr double shortestOverlapS = 2, sameRunScore = 0.98;
constexpr std::size_t formPoints = 200;

/// How well a free affine map of the second track makes it the first at a lag: the mean square of what is
/// left, m², of at least half of the positions.
struct FormFit
{
    double lagS = 0, leftM2 = HUGE_VAL, motionM2 = 0;
};

FormFit formAt(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second, double lagS)
{
    const std::size_t stride = 1 + first.size() / formPoints;
    FormFit fit;
    fit.lagS = lagS;
    std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> pairs;
    for (std::size_t i = 0; i < first.size(); i += stride) {
        if (const auto other = trackAt(second, first[i].timeS - lagS))
            pairs.emplace_back(first[i].pointInWorld, other->point);
    }
    if (pairs.size() < std::max<std::size_t>(fewestPairs, first.size() / 2) / stride)
        return fit;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const auto &[a, b] : pairs) {
        const Eigen::Vector3d row(1, b.x(), b.y());
        normal += row * row.transpose();
        right += row * a.transpose();
        mean += a / double(pairs.size());
    }
    const Eigen::Matrix<double, 3, 2> map = normal.ldlt().solve(right);
    fit.leftM2 = 0;
    for (const auto &[a, b] : pairs) {
        fit.leftM2 +=
            (a - map.transpose() * Eigen::Vector3d(1, b.x(), b.y())).squaredNorm() / double(pairs.size());
        fit.motionM2 += (a - mean).squaredNorm() / double(pairs.size());
    }
    return fit;
}

/// Whether the tracks have one form that is not in one place, size and direction.
bool isSameForm(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                const ConstantLag &constant, const OffsetRange &range)
{
    FormFit best;
    for (double lagS = range.middleS - range.halfWidthS; lagS < range.middleS + range.halfWidthS;
         lagS += formStepS) {
        if (const FormFit fit = formAt(first, second, lagS); fit.leftM2 < best.leftM2)
            best = fit;
    }
    const double shiftedM2 =
        constant.failure == NoLag::RarelyTogether ? HUGE_VAL : constant.fit.agreement.variance;
    return best.leftM2 < sameFormShare * best.motionM2 && farBetter * best.leftM2 < shiftedM2;
}

/// How long the tracks have something in common if they do so for less than half of the shorter one; 0: they
/// don't.
double shortOverlapS(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second)
{
    const double frameS = std::max(medianStepS(first), 1e-3);
    const auto enough = static_cast<std::size_t>(shortestOverlapS / frameS);
    const double lowestS = first.front().timeS - second.back().timeS + shortestOverlapS,
                 highestS = first.back().timeS - second.front().timeS - shortestOverlapS;
    double least = HUGE_VAL, lagS = 0;
    for (double at = lowestS; at < highestS; at += frameS) {
        const Pairs pairs = pairsAt(first, second, {at, 0}, 1);
        if (pairs.size() < enough)
            continue;
        const double left = agreementOf(pairs, false, {}, independentVariance(0, frameS)).variance;
        if (left < least) {
            least = left;
            lagS = at;
        }
    }
    if (least == HUGE_VAL)
        return 0;
    const Fit fit = refine(first, second, {lagS, 0}, false, frameS);
    const double noise = std::hypot(whiteNoiseM(first), whiteNoiseM(second)),
                 most = std::max(noiseTimes * noise, leastLeftM),
                 information = fit.agreement.information(0, 0);
    const bool isKnown = information > 0 && std::sqrt(independentVariance(fit.agreement.variance, frameS) /
                                                      information) < frameS;
    const bool isSame = fit.agreement.variance < (1 - sameRunScore) * fit.motionVariance &&
                        fit.agreement.variance < 2 * most * most;
    return isKnown && isSame ? double(fit.pairs) * frameS : 0;
}

} // namespace

Message uniformMotion(const std::vector<TimedPosition> &track)
{
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d right = Eigen::Matrix2d::Zero();
    for (const TimedPosition &position : track) {
        const Eigen::Vector2d row(1, position.timeS);
        normal += row * row.transpose();
        right += row * position.pointInWorld.transpose();
    }
    const Eigen::Matrix2d line = normal.ldlt().solve(right);
    double left = 0;
    for (const TimedPosition &position : track)
        left +=
            (position.pointInWorld - line.transpose() * Eigen::Vector2d(1, position.timeS)).squaredNorm() /
            double(2 * track.size());
    const double noiseM = whiteNoiseM(track);
    if (std::sqrt(left) > std::max(noiseTimes * noiseM, leastLeftM))
        return {};
    const double wayM = line.row(1).norm() * (track.back().timeS - track.front().timeS);
    if (wayM < std::max(restM, noiseTimes * noiseM))
        return ODO_TEXT("synchronisation.robot_rested", "the robot stood still, so every time offset fits");
    return ODO_TEXT("synchronisation.robot_ran_straight",
                    "the robot ran straight at constant speed, so every time offset fits");
}

Message unsynchronisedCause(const std::vector<TimedPosition> &first, const std::vector<TimedPosition> &second,
                            const ConstantLag &constant, const OffsetRange &range)
{
    if (constant.failure == NoLag::Repeats)
        return joined(
            {ODO_TEXT("synchronisation.motion_repeats", "the motion repeats itself"),
             ODO_TEXT("synchronisation.offsets_fit_alike", "time offsets of %1 and %2 fit equally well")(
                 quantity(constant.offset.offsetS, 6, "s"), quantity(constant.rivalS, 6, "s"))},
            Join::Colon);
    const double noise = std::hypot(whiteNoiseM(first), whiteNoiseM(second)),
                 most = std::max(noiseTimes * noise, 2 * leastLeftM);
    if (constant.failure == NoLag::EveryOffset && constant.fit.agreement.variance < 2 * most * most)
        return ODO_TEXT("synchronisation.motion_too_even",
                        "the robot turned and changed its speed too little to give the time offset");
    if (isSameForm(first, second, constant, range))
        return ODO_TEXT("synchronisation.views_distorted",
                        "the views show the same run, but with another size or direction: a camera has moved "
                        "since its registration, or the videos are exchanged");
    if (const double commonS = shortOverlapS(first, second); commonS > 0)
        return ODO_TEXT("synchronisation.short_overlap",
                        "the views seem to have only %1 in common, which is too short to be sure")(
            quantity(commonS, 1, "s"));
    if (constant.failure == NoLag::RarelyTogether)
        return ODO_TEXT("synchronisation.seldom_together", "the views rarely saw the robot at the same time");
    return ODO_TEXT(
        "synchronisation.different_runs",
        "the views' tracks match at no time offset, frame rate or pause tried, so the videos may be "
        "of different runs");
}

} // namespace odo
