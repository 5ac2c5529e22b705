// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/curve_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace odo {

namespace {

std::vector<CurvePoint> usablePoints(std::span<const CurvePoint> points)
{
    std::vector<CurvePoint> usable;
    for (const CurvePoint &point : points)
        if (point.sigma > 0 && std::isfinite(point.sigma) && std::isfinite(point.value))
            usable.push_back(point);
    return usable;
}

/// 1 + 2Σρₖ of the normalised residuals, up to the first lag that is not positive.
double neighbourFactorOf(const Eigen::VectorXd &residuals)
{
    const Eigen::Index count = residuals.size();
    const double squares = residuals.squaredNorm();
    double factor = 1;
    for (Eigen::Index lag = 1; squares > 0 && lag < count / 2; ++lag) {
        const double product = residuals.tail(count - lag).dot(residuals.head(count - lag));
        // The chance correlation of independent residuals is no reason to widen.
        if (product <= squares / std::sqrt(static_cast<double>(count)))
            break;
        factor += 2 * product / squares;
    }
    return factor;
}

/// From powers of u = (t − mid)/half, in which the equations are well conditioned, to powers of t − t₀.
Eigen::Matrix3d fromScaled(double halfS, double midS)
{
    const double m = -midS; // u·half = τ + m with τ = t − t₀ and mid counted from t₀
    Eigen::Matrix3d powers = Eigen::Matrix3d::Zero();
    powers.col(0) << 1, 0, 0;
    powers.col(1) << m / halfS, 1 / halfS, 0;
    powers.col(2) << m * m / (halfS * halfS), 2 * m / (halfS * halfS), 1 / (halfS * halfS);
    return powers;
}

tl::unexpected<Error> tooShort(std::size_t points, FitShape shape)
{
    const char *const names[] = {"a constant", "a straight line", "a parabola"};
    return fail(ErrorCode::Undetermined, std::string("fit of ") + names[static_cast<int>(shape)],
                std::to_string(points) + (points == 1 ? " point is" : " points are") + " too few for it",
                "choose a longer range");
}

} // namespace

double CurveFit::at(double timeS) const
{
    const double t = timeS - originS;
    return coefficients[0] + t * (coefficients[1] + t * coefficients[2]);
}

double CurveFit::sigma(int coefficient) const
{
    return std::sqrt(std::max(0.0, covariance(coefficient, coefficient)));
}

double CurveFit::sigmaAt(double timeS) const
{
    const double t = timeS - originS;
    const Eigen::Vector3d slope(1, t, t * t);
    return std::sqrt(std::max(0.0, slope.dot(covariance * slope)));
}

FitVerdict verdictOf(const CurveFit &fit)
{
    // The mean of ν squares scatters by √(2/ν).
    const double spread = std::sqrt(2 / std::max(1.0, fit.independentCount / fit.neighbourFactor));
    if (fit.reducedChiSquared() > 1 + 2 * spread)
        return FitVerdict::Departs;
    return fit.reducedChiSquared() < 1 - 2 * spread ? FitVerdict::Closer : FitVerdict::Describes;
}

Result<CurveFit> fitCurve(std::span<const CurvePoint> all, ErrorCourse course, FitShape shape)
{
    const std::vector<CurvePoint> points = usablePoints(all);
    const int width = static_cast<int>(shape) + 1;
    const auto count = static_cast<Eigen::Index>(points.size());
    if (count <= width || points.back().timeS <= points.front().timeS)
        return tooShort(points.size(), shape);
    CurveFit fit;
    fit.shape = shape;
    fit.points = points.size();
    fit.originS = points.front().timeS;
    const double half = (points.back().timeS - fit.originS) / 2;
    Eigen::MatrixXd rows(count, width);
    Eigen::VectorXd values(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const CurvePoint &point = points[static_cast<std::size_t>(i)];
        const double u = (point.timeS - fit.originS) / half - 1;
        for (int power = 0; power < width; ++power)
            rows(i, power) = std::pow(u, power) / point.sigma;
        values[i] = point.value / point.sigma;
    }
    const Eigen::MatrixXd normal = rows.transpose() * rows;
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    const Eigen::VectorXd scaled = solver.solve(rows.transpose() * values);
    if (!scaled.allFinite() || solver.rcond() < 1e-12)
        return tooShort(points.size(), shape);
    const Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd::Identity(width, width));
    Eigen::MatrixXd weights = rows; // of each point's error in the equations
    for (Eigen::Index i = 0; i < count; ++i)
        weights.row(i) /= points[static_cast<std::size_t>(i)].sigma;
    const Eigen::MatrixXd correlated = errorCovariance(points, course, weights);
    const Eigen::VectorXd residuals = values - rows * scaled;
    fit.chiSquared = residuals.squaredNorm();
    fit.expectedChiSquared = static_cast<double>(count) - (inverse * correlated).trace();
    fit.independentCount = independentCount(points, course);
    // A range shorter than the errors' own time: the fit would follow the error.
    if (fit.expectedChiSquared <= 0)
        return tooShort(points.size(), shape);
    if (course == ErrorCourse::Independent)
        fit.neighbourFactor = neighbourFactorOf(residuals);
    const Eigen::Matrix3d back = fromScaled(half, half);
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    covariance.topLeftCorner(width, width) = fit.neighbourFactor * (inverse * correlated * inverse);
    Eigen::Vector3d padded = Eigen::Vector3d::Zero();
    padded.head(width) = scaled;
    fit.coefficients = back * padded;
    fit.covariance = back * covariance * back.transpose();
    double squares = 0;
    for (Eigen::Index i = 0; i < count; ++i)
        squares += std::pow(residuals[i] * points[static_cast<std::size_t>(i)].sigma, 2);
    fit.rms = std::sqrt(squares / static_cast<double>(count));
    return fit;
}

} // namespace odo
