// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/trajectory/error_course.h"

#include <Eigen/Core>
#include <span>

namespace odo {

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
        1; ///< Independent: on the variances, for residuals that hang together after all; else 1
    std::size_t points = 0; ///< that were fitted

    double at(double timeS) const;
    double sigma(int coefficient) const;
    double sigmaAt(double timeS) const;
    /// χ² per degree of freedom.
    double reducedChiSquared() const { return expectedChiSquared > 0 ? chiSquared / expectedChiSquared : 0; }
};

/// Whether the shape describes the curve within its errors.
enum class FitVerdict {
    Describes, ///< the curve departs from it no more than its errors explain
    Departs,   ///< by more than two standard deviations of χ² more: the shape is not that of the motion
    Closer,    ///< by as much less: the stated σ are larger than the scatter
};
FitVerdict verdictOf(const CurveFit &fit);

/// The polynomial with the least Σ(residual/σ)² (Aitken 1935 for independent errors). Its covariance is that
/// of this estimate under errors that hang together as told (errorCovariance), (GᵀG)⁻¹GᵀRG(GᵀG)⁻¹ with G the
/// rows over σ and R the correlations: a smoothed curve's neighbours share their error, and counting each as
/// independent would promise far too much. Independent errors: if the residuals hang together nevertheless
/// (outlines change slowly; the shape may be wrong), the variances are multiplied by 1 + 2Σρₖ of the
/// residuals' autocorrelation up to its first change of sign, at least 1. What is common to all points
/// (calibration) is not in it. Points whose σ is 0 are left out. all: in order of time. Errors:
/// Undetermined when no more points, or no more independent times, are left than there are coefficients.
Result<CurveFit> fitCurve(std::span<const CurvePoint> all, ErrorCourse course, FitShape shape);

} // namespace odo
