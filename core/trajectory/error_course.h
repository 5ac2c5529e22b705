// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>

namespace odo {

/// How the errors of a curve at different times hang together: not at all (measurements), or as those of a
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

/// One time of a curve: value with its σ, and how its error hangs together with its neighbours'.
struct CurvePoint
{
    double timeS = 0, value = 0, sigma = 0;
    double errorRate = 0;     ///< ω₀, 1/s
    double integralSigma = 0; ///< of an acceleration: σ of the velocity
};

/// Covariance of Σ fᵢeᵢ, e the errors of the points and fᵢ a row a point of weights: Σᵢⱼ fᵢfⱼᵀ σᵢσⱼ ρᵢⱼ with
/// s = ∫ω₀dt between two points. An acceleration's error is taken as the difference of the velocity's next to
/// it (its own is too rough for a sum in the place of an integral). Its time grows with the number of points,
/// not with its square: ρ is a sum of exponentials. points in order of time.
Eigen::MatrixXd errorCovariance(std::span<const CurvePoint> points, ErrorCourse course,
                                const Eigen::MatrixXd &weights);

/// As how many independent ones the points' errors count for a mean of squares, n²/Σρᵢⱼ², with the integral
/// of ρ² in place of the sum; from 1 to the number of points.
double independentCount(std::span<const CurvePoint> points, ErrorCourse course);

} // namespace odo
