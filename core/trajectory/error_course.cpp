// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/error_course.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

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

} // namespace odo
