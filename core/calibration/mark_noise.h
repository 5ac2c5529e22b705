// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace odo {

/// σ of one coordinate of a marker's pixel, as it is believed of before any residual is seen.
inline constexpr double usualMarkSigmaPx = 0.3;

/// σ of one coordinate of a marker's pixel, in pixels, from the residuals of a fit: the sum of their squares
/// and how many of them are free. What is believed of it beforehand counts along with the weight of four
/// residuals: four markers leave two, which alone would often call the noise nearly nothing. The mean of both
/// variances by what each weighs is the posterior mean of the variance under a scaled inverse χ² prior
/// (Gelman et al., Bayesian Data Analysis, 2.6) of that mean and six degrees of freedom. Residuals beyond
/// three times that belief refute it, and speak alone. It holds for tags as well: the program finds them
/// better, but the layout's places were measured too. Any thread.
double markSigmaPx(double squaresPx2, double freedom);

} // namespace odo
