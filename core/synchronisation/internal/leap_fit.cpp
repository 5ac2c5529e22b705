// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/synchronisation/internal/leap_fit.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int momentsTried = 8;       // of an interval
constexpr std::size_t sidePoints = 6; // that a parabola goes through

/// A polynomial through points, about a time.
struct Curve
{
    Eigen::MatrixX2d coefficients;
    Eigen::MatrixXd spread; ///< (XᵀX)⁻¹
    double aboutS = 0, squaredSum = 0;
    Eigen::Index freedom = 0; ///< of each coordinate

    Eigen::VectorXd powersAt(double timeS) const
    {
        Eigen::VectorXd powers(coefficients.rows());
        double power = 1;
        for (Eigen::Index k = 0; k < powers.size(); ++k, power *= timeS - aboutS)
            powers[k] = power;
        return powers;
    }
    Eigen::Vector2d at(double timeS) const { return coefficients.transpose() * powersAt(timeS); }
    Eigen::Vector2d velocityAt(double timeS) const
    {
        Eigen::VectorXd slopes = Eigen::VectorXd::Zero(coefficients.rows());
        double power = 1;
        for (Eigen::Index k = 1; k < slopes.size(); ++k, power *= timeS - aboutS)
            slopes[k] = double(k) * power;
        return coefficients.transpose() * slopes;
    }
    /// Of a coordinate there, in variances of the noise.
    double varianceAt(double timeS) const
    {
        const Eigen::VectorXd powers = powersAt(timeS);
        return powers.dot(spread * powers);
    }
};

Curve curveThrough(const std::vector<TimedPixel> &points, Eigen::Index degree, double aboutS)
{
    Curve curve;
    curve.aboutS = aboutS;
    const auto count = Eigen::Index(points.size());
    curve.coefficients.resize(std::min(degree, count - 2) + 1, 2);
    Eigen::MatrixXd powers(count, curve.coefficients.rows());
    Eigen::MatrixX2d values(count, 2);
    for (Eigen::Index i = 0; i < count; ++i) {
        powers.row(i) = curve.powersAt(points[std::size_t(i)].timeS).transpose();
        values.row(i) = points[std::size_t(i)].px.transpose();
    }
    const Eigen::HouseholderQR<Eigen::MatrixXd> decomposed(powers);
    curve.coefficients = decomposed.solve(values);
    curve.spread = (powers.transpose() * powers).inverse();
    curve.squaredSum = (values - powers * curve.coefficients).squaredNorm();
    curve.freedom = count - curve.coefficients.rows();
    return curve;
}

/// The largest change from one step to the next, of steps as long as the usual interval.
double irregularity(const std::vector<TimedPixel> &points, double usualS)
{
    double largest = 0;
    for (std::size_t i = 2; i < points.size(); ++i) {
        const Eigen::Vector2d before =
            (points[i - 1].px - points[i - 2].px) / (points[i - 1].timeS - points[i - 2].timeS);
        const Eigen::Vector2d behind =
            (points[i].px - points[i - 1].px) / (points[i].timeS - points[i - 1].timeS);
        largest = std::max(largest, (behind - before).norm() * usualS);
    }
    return largest;
}

Eigen::Vector2d beyondSegment(const Eigen::Vector2d &point, const Eigen::Vector2d &from,
                              const Eigen::Vector2d &to)
{
    const Eigen::Vector2d along = to - from;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0;
    return point - from - share * along;
}

std::vector<TimedPixel> joinedWith(const AroundInterval &around, double delayS)
{
    std::vector<TimedPixel> points = around.before;
    for (TimedPixel point : around.behind) {
        point.timeS += delayS;
        points.push_back(point);
    }
    return points;
}

Curve delayedCurve(const AroundInterval &around, double delayS)
{
    const double middleS = (around.before.back().timeS + around.behind.front().timeS + delayS) / 2;
    return curveThrough(joinedWith(around, delayS), 3, middleS);
}

} // namespace

LeapTest leapTest(const AroundInterval &around, double usualS)
{
    const auto near = [](std::size_t all) { return std::ptrdiff_t(std::min(all, sidePoints)); };
    const std::vector<TimedPixel> before(around.before.end() - near(around.before.size()),
                                         around.before.end()),
        behind(around.behind.begin(), around.behind.begin() + near(around.behind.size()));
    const double fromS = before.back().timeS, toS = behind.front().timeS;
    const Curve left = curveThrough(before, 2, fromS), right = curveThrough(behind, 2, toS);
    LeapTest test;
    const auto varianceOf = [](const Curve &curve) {
        return curve.squaredSum / double(2 * std::max<Eigen::Index>(1, curve.freedom));
    };
    test.noisePx =
        std::sqrt(std::max({around.noisePx * around.noisePx, varianceOf(left), varianceOf(right)}));
    test.apart = HUGE_VAL;
    for (int i = 0; i <= momentsTried; ++i) {
        const double atS = fromS + (toS - fromS) * i / momentsTried;
        const double sigma = test.noisePx * std::sqrt(left.varianceAt(atS) + right.varianceAt(atS));
        test.apart = std::min(test.apart, (right.at(atS) - left.at(atS)).norm() / sigma);
    }
    const Eigen::Vector2d in = left.velocityAt(fromS), out = right.velocityAt(toS);
    test.excessPx =
        beyondSegment(behind.front().px - before.back().px, in * (toS - fromS), out * (toS - fromS));
    test.irregularPx = std::max(irregularity(before, usualS), irregularity(behind, usualS));
    test.stepPx = ((in + out) / 2).norm() * usualS;
    test.fastestPx = std::max(in.norm(), out.norm()) * usualS;
    return test;
}

std::optional<DelayFit> fitDelay(const AroundInterval &around, double noisePx, double leastS, double mostS,
                                 double stepS)
{
    const auto sumAt = [&](double delayS) { return delayedCurve(around, delayS).squaredSum; };
    const int steps = int(std::ceil((mostS - leastS) / stepS));
    double least = HUGE_VAL;
    int best = 0;
    for (int i = 0; i <= steps; ++i) {
        const double sum = sumAt(leastS + i * stepS);
        if (sum < least) {
            least = sum;
            best = i;
        }
    }
    if (best == 0 || best == steps)
        return std::nullopt;
    DelayFit fit;
    fit.delayS = leastS + best * stepS;
    // parabolas through three delays, ever nearer
    double curvature = 0;
    for (double h = stepS; h > stepS / 20; h /= 3) {
        const double before = sumAt(fit.delayS - h), here = sumAt(fit.delayS), behind = sumAt(fit.delayS + h);
        curvature = (before - 2 * here + behind) / (h * h);
        if (!(curvature > 0))
            return std::nullopt;
        fit.delayS += std::clamp((before - behind) / (2 * h * curvature), -h, h);
    }
    const Curve curve = delayedCurve(around, fit.delayS);
    const double noise = noisePx * noisePx,
                 remaining = curve.squaredSum / double(std::max<Eigen::Index>(1, 2 * curve.freedom - 1));
    fit.misfit = remaining / noise;
    fit.sigmaS = std::sqrt(2 * std::max(noise, remaining) / curvature);
    fit.gain = (sumAt(0) - curve.squaredSum) / noise;
    return fit;
}

} // namespace odo
