// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

namespace odo {

/// Lens models, by the names that ROS and OpenCV use for the same formulas.
enum class LensModel {
    Standard, ///< k1 k2 p1 p2 [k3]: Brown–Conrady, ROS "plumb_bob"
    Rational, ///< k1 k2 p1 p2 k3 k4 k5 k6: ROS "rational_polynomial"
    Fisheye,  ///< k1 k2 k3 k4: Kannala–Brandt 2006, ROS "equidistant"
};

/// The intrinsics of one camera at one image size. Pixels; pixel (0,0) is the centre of the top-left pixel.
struct Intrinsics
{
    int widthPx = 0, heightPx = 0;
    double fxPx = 0, fyPx = 0, cxPx = 0, cyPx = 0;
    LensModel model = LensModel::Standard;
    std::vector<double> distortion; ///< in the order named at LensModel; empty means none
    /// Covariance of (fx, fy, cx, cy, distortion...), or empty (0×0) where it is not known.
    Eigen::MatrixXd covariance;
};

/// Derivative of a pixel by the values of a lens, a column each of (fx, fy, cx, cy, distortion...).
using PixelByIntrinsics = Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::ColMajor, 2, 12>;

/// Maps between pixels and viewing directions of one camera, with lens distortion.
/// Camera frame: x right, y down, z forward. Immutable, safe to share between threads.
class CameraModel
{
public:
    /// Refuses non-finite values, non-positive focal lengths or sizes, and a wrong number of coefficients.
    static Result<CameraModel> create(Intrinsics intrinsics);
    /// A camera without distortion whose field of view is a guess: f = 1.2 · the longer side, centre in the
    /// middle.
    static CameraModel assumed(int widthPx, int heightPx);

    const Intrinsics &intrinsics() const { return m_intrinsics; }

    /// Pixel of a point in the camera frame (metres); nullopt behind the camera, or where the distortion
    /// polynomial has turned back (a point far outside the image that would fold into it).
    std::optional<Eigen::Vector2d> project(const Eigen::Vector3d &pointInCamera) const;

    /// As project, with the derivative of the pixel by the point (2×3).
    std::optional<Eigen::Vector2d> project(const Eigen::Vector3d &pointInCamera,
                                           Eigen::Matrix<double, 2, 3> &pixelByPoint) const;

    /// Derivative of project's pixel by the lens (2 × (4 + the number of coefficients)); to be asked only for
    /// points that project() has a pixel for.
    PixelByIntrinsics pixelByIntrinsics(const Eigen::Vector3d &pointInCamera) const;

    /// Direction (x, y, 1) in the camera frame seen by a pixel; for a fisheye beyond 90° (x, y, z) with unit
    /// norm. nullopt where the inversion does not converge (Newton, to 1e-12).
    std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d &pixel) const;

private:
    explicit CameraModel(Intrinsics intrinsics);
    std::optional<Eigen::Vector2d> projectFisheye(const Eigen::Vector3d &point,
                                                  Eigen::Matrix<double, 2, 3> &pixelByPoint) const;
    std::optional<Eigen::Vector3d> unprojectFisheye(const Eigen::Vector2d &distorted) const;

    Intrinsics m_intrinsics;
    std::array<double, 8> m_coefficients{}; ///< the distortion, padded with zeros
    double m_limit = 0; ///< radius in (x/z, y/z), for a fisheye the angle: where the distortion stops growing
};

} // namespace odo
