// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace odo {

/// Radial distortion of a point, apart from tangential distortion. Coefficients as CameraModel keeps them.
/// The argument is the radius in (x/z, y/z), or the angle from the optical axis for a fisheye.
class LensCurve
{
public:
    /// fisheye: k1..k4 of Kannala and Brandt 2006, equation 6; otherwise k1 k2 p1 p2 k3 k4 k5 k6 of Brown and
    /// Conrady with OpenCV's rational denominator.
    LensCurve(const std::array<double, 8> &coefficients, bool fisheye) : m_k(coefficients), m_fisheye(fisheye)
    {
    }

    double value(double argument) const;
    double slope(double argument) const;
    /// The largest argument up to which the curve grows; infinity without distortion.
    double limit() const;
    /// The argument whose value is given, in [0, limit]; nullopt where the curve does not reach it.
    std::optional<double> inverse(double wanted, double limit) const;

private:
    std::array<double, 8> m_k;
    bool m_fisheye;
};

} // namespace odo
