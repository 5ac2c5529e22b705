// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <span>

namespace odo {

/// How the errors of a curve at different times are correlated: not at all (measurements), or as those of a
/// smoothed position and of its first and second derivative.
enum class ErrorCourse { Independent, Position, Velocity, Acceleration };

/// Correlation of two errors that lie s = ω₀·|t₁ − t₂| apart.
///
/// A position that is smoothed as one that is driven by white jerk of density q, measured with white noise of
/// density r = σ²Δt, has in the midst of a track an error of the spectrum r/(1 + (ω/ω₀)⁶), ω₀⁶ = q/r (the
/// error of the optimum smoother, S·r/(S + r) with S = q/ω⁶: Van Trees 1968, § 6.2). Its inverse transform is
/// ½[e⁻ˢ + e⁻ˢᐟ²(cos bs + √3 sin bs)], b = √3/2; of the velocity's error minus its second derivative,
/// 2e⁻ˢᐟ²cos bs − e⁻ˢ; of the acceleration's the fourth, ½[e⁻ˢ + e⁻ˢᐟ²(cos bs − √3 sin bs)]. The variances
/// are rω₀/3, rω₀³/6, rω₀⁵/3. Independent: 1 at s = 0, else 0.
double errorCorrelation(ErrorCourse course, double s);

/// ω₀ = √2 σᵥ/σₓ of a point, 1/s, from the σ of its position (without what is common to the track) and of its
/// velocity; 0 where they are not known. What of a position's error changes only as the robot moves makes σₓ
/// larger, and so its errors last longer; differences of raw positions have so the mean that they must have.
double errorRate(double sigmaPosition, double sigmaVelocity);

/// One time of a curve: value with its σ, and how its error is correlated with its neighbours'.
struct CurvePoint
{
    double timeS = 0, value = 0, sigma = 0;
    double errorRate = 0;     ///< ω₀, 1/s
    double integralSigma = 0; ///< of an acceleration: σ of the velocity
};

/// Covariance of Σ fᵢeᵢ, e the errors of the points and fᵢ a row a point of weights: Σᵢⱼ fᵢfⱼᵀ σᵢσⱼ ρᵢⱼ with
/// s = ∫ω₀dt between two points. The error of an acceleration is approximated by the difference of
/// neighbouring velocity errors (its own is too rough to replace an integral by a sum). Its time grows with
/// the number of points, not with its square: ρ is a sum of exponentials. points in order of time.
Eigen::MatrixXd errorCovariance(std::span<const CurvePoint> points, ErrorCourse course,
                                const Eigen::MatrixXd &weights);

/// As how many independent ones the points' errors count for a mean of squares, n²/Σρᵢⱼ², with the integral
/// of ρ² in place of the sum; from 1 to the number of points.
double independentCount(std::span<const CurvePoint> points, ErrorCourse course);

/// What is fitted to a curve; the number is the degree of the polynomial.
enum class FitShape { Constant = 0, Line = 1, Parabola = 2 };

/// value(t) = c₀ + c₁(t − t₀) + c₂(t − t₀)², t₀ the time of the first point.
struct CurveFit
{
    FitShape shape = FitShape::Constant;
    double originS = 0; ///< t₀
    Eigen::Vector3d coefficients{
        Eigen::Vector3d::Zero()}; ///< unit of the value, a second, a second²; 0 beyond the shape
    Eigen::Matrix3d covariance{Eigen::Matrix3d::Zero()};
    double rms = 0;                ///< of the residuals, unweighted
    double chiSquared = 0;         ///< Σ(residual/σ)²
    double expectedChiSquared = 0; ///< what the stated σ let expect of it: the degrees of freedom
    double independentCount = 0;   ///< as of independentCount
    double neighbourFactor =
        1; ///< Independent: on the variances, for residuals that are correlated after all; else 1
    std::size_t points = 0; ///< that were fitted

    double at(double timeS) const;
    double sigma(int coefficient) const;
    double sigmaAt(double timeS) const;
    /// χ² per degree of freedom.
    double reducedChiSquared() const { return expectedChiSquared > 0 ? chiSquared / expectedChiSquared : 0; }
};

/// Whether the shape describes the curve within its uncertainty.
enum class FitVerdict {
    Describes, ///< the curve departs from it no more than its σ explains
    Departs,   ///< by more than two standard deviations of χ² more: the shape is not that of the motion
    Closer,    ///< by as much less: the stated σ are larger than the scatter
};
FitVerdict verdictOf(const CurveFit &fit);

/// The polynomial with the least Σ(residual/σ)² (Aitken 1935 for independent errors). Its covariance is that
/// of this estimate under correlated errors as given (errorCovariance), (GᵀG)⁻¹GᵀRG(GᵀG)⁻¹ with G the rows
/// over σ and R the correlations: a smoothed curve's neighbours share their error, and counting each as
/// independent would promise far too much. Independent errors: if the residuals are correlated nevertheless
/// (outlines change slowly; the shape may be wrong), the variances are multiplied by 1 + 2Σρₖ of the
/// residuals' autocorrelation up to its first change of sign, at least 1. What is common to all points
/// (calibration) is not in it. Points whose σ is 0 are left out. all: in order of time. Errors: Undetermined
/// when no more points, or no more independent times, are left than there are coefficients.
Result<CurveFit> fitCurve(std::span<const CurvePoint> all, ErrorCourse course, FitShape shape);

} // namespace odo
