// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace odo {

/// exp(−x²/2): how well something agrees that lies x standard deviations away.
double bellOf(double x);

/// 0 to 1: how much a region of these second moments and this area looks like one solid piece. An ellipse
/// fills the ellipse of its moments wholly, a rectangle to 95 %; branches, rings and scattered samples much
/// less; tape is too long.
double compactness(const Eigen::Matrix2d &covariance, double area);

/// 0 to 1: how plausible it is that a robot takes this fraction of the picture.
double sizeLikelihood(double fractionOfPicture);

} // namespace odo
