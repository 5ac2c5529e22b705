// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/curve_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace odo {

namespace {

using Complex = std::complex<double>;

/// ρ(s) = real·e⁻ˢ + Re(turning·e^{λs}), λ = e^{2πi/3}.
struct Modes
{
    double real = 0;
    Complex turning = 0;
};

const Complex turningRate(-0.5, std::numbers::sqrt3 / 2);

Modes modesOf(ErrorCourse course)
{
    switch (course) {
    case ErrorCourse::Position:
        return {0.5, {0.5, -std::numbers::sqrt3 / 2}};
    case ErrorCourse::Velocity:
        return {-1, {2, 0}};
    case ErrorCourse::Acceleration:
        return {0.5, {0.5, std::numbers::sqrt3 / 2}};
    case ErrorCourse::Independent:
        break;
    }
    return {};
}

double warpedStep(const CurvePoint &before, const CurvePoint &after)
{
    return std::max(0.0, after.timeS - before.timeS) * (before.errorRate + after.errorRate) / 2;
}

/// Σᵢⱼ gᵢgⱼᵀρᵢⱼ of a row g a point.
Eigen::MatrixXd correlatedSum(const Eigen::MatrixXd &rows, const Modes &modes,
                              std::span<const CurvePoint> points)
{
    const Eigen::Index width = rows.cols();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(width, width);
    Eigen::RowVectorXd fading = Eigen::RowVectorXd::Zero(width);    // Σ gⱼe⁻ˢ of the points before
    Eigen::RowVectorXcd turning = Eigen::RowVectorXcd::Zero(width); // Σ gⱼe^{λs}
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const Eigen::RowVectorXd row = rows.row(i);
        if (i > 0) {
            const auto point = points.begin() + i;
            const double apart = warpedStep(*(point - 1), *point);
            fading *= std::exp(-apart);
            turning *= std::exp(turningRate * apart);
        }
        const Eigen::RowVectorXd before = modes.real * fading + (modes.turning * turning).real();
        sum += row.transpose() * row + row.transpose() * before + before.transpose() * row;
        fading += row;
        turning += row.cast<Complex>();
    }
    return sum;
}

/// The weights on a series whose derivative, by central differences, is weighted so.
Eigen::MatrixXd onAntiderivative(std::span<const CurvePoint> points, const Eigen::MatrixXd &weights)
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(weights.rows(), weights.cols());
    const Eigen::Index last = weights.rows() - 1;
    for (Eigen::Index i = 0; i <= last; ++i) {
        const Eigen::Index from = std::max<Eigen::Index>(0, i - 1), to = std::min(last, i + 1);
        const double time =
            points[static_cast<std::size_t>(to)].timeS - points[static_cast<std::size_t>(from)].timeS;
        if (time <= 0)
            continue;
        result.row(to) += weights.row(i) / time;
        result.row(from) -= weights.row(i) / time;
    }
    return result;
}

} // namespace

double errorCorrelation(ErrorCourse course, double s)
{
    if (course == ErrorCourse::Independent)
        return s == 0 ? 1 : 0;
    const Modes modes = modesOf(course);
    return modes.real * std::exp(-s) + (modes.turning * std::exp(turningRate * s)).real();
}

double errorRate(double sigmaPosition, double sigmaVelocity)
{
    return sigmaPosition > 0 ? std::numbers::sqrt2 * sigmaVelocity / sigmaPosition : 0;
}

Eigen::MatrixXd errorCovariance(std::span<const CurvePoint> points, ErrorCourse course,
                                const Eigen::MatrixXd &weights)
{
    const bool byVelocity = course == ErrorCourse::Acceleration && points.size() > 1;
    Eigen::MatrixXd rows = byVelocity ? onAntiderivative(points, weights) : weights;
    for (std::size_t i = 0; i < points.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) *= byVelocity ? points[i].integralSigma : points[i].sigma;
    if (course == ErrorCourse::Independent)
        return rows.transpose() * rows;
    return correlatedSum(rows, modesOf(byVelocity ? ErrorCourse::Velocity : course), points);
}

double independentCount(std::span<const CurvePoint> points, ErrorCourse course)
{
    const auto count = static_cast<double>(points.size());
    if (course == ErrorCourse::Independent || points.size() < 2)
        return count;
    // ∫ρ²ds = 2π ∫S²du / (∫S du)² by Parseval, with S = 1/(1 + u⁶), u² S and u⁴ S.
    const double squares = course == ErrorCourse::Position ? 2.5 : course == ErrorCourse::Velocity ? 2 : 0.75;
    double warped = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        warped += warpedStep(points[i - 1], points[i]);
    return std::clamp(warped / squares, 1.0, count);
}

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
    const Message shapes[] = {ODO_TEXT("analysis.a_constant", "a constant"),
                              ODO_TEXT("analysis.a_straight_line", "a straight line"),
                              ODO_TEXT("analysis.a_parabola", "a parabola")};
    return fail(ErrorCode::Undetermined,
                ODO_TEXT("analysis.fit_of", "fit of %1")(shapes[static_cast<int>(shape)]),
                points == 1 ? ODO_TEXT("analysis.one_point_too_few", "%1 point is too few for it")(points)
                            : ODO_TEXT("analysis.points_too_few", "%1 points are too few for it")(points),
                ODO_TEXT("analysis.choose_longer_range", "choose a longer range"));
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
