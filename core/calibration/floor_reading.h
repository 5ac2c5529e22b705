// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A floor position read from one pixel. Metres.
struct ReadPosition
{
    Eigen::Vector2d pointInWorld = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< of pose, lens and pixel together, m²
    Eigen::Vector2d sigmaM() const { return covariance.diagonal().cwiseSqrt(); }
};

/// A labelled image point with its floor position; nullopt where it has none.
struct LocatedPoint
{
    std::string label;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    std::optional<ReadPosition> position;
};

/// σ of one coordinate of a pixel that a person reads, in pixels: what the registration's own residuals say
/// of a marker's (markSigmaPx), at least usualMarkSigmaPx: nobody reads a point better than a marker.
double readSigmaPx(const FloorRegistration &registration);

/// Reads floor positions from pixels of a registered camera, with their whole σ: of the pose, of the lens,
/// and of the reading itself (readSigmaPx).
///
/// A lens estimated from the floor has its covariance. One that was assumed by an older version gets one as
/// wide as ordinary lenses differ (assumedLensSpread), as far as the registration's markers still leave it
/// open: given the pixels, of σ s, the lens keeps (Σ⁻¹ + JᵀPJ / s²)⁻¹, with J the markers' pixels by the lens
/// and P the part of the residuals that no pose explains (Gaussian conditioning). Between the markers it adds
/// little, away from them much.
///
/// World axes as FloorView. Immutable, safe to share between threads.
class FloorReading
{
public:
    /// camera: the lens that the registration was made with. pixels: those it was made from.
    FloorReading(const FloorRegistration &registration, const CameraModel &camera,
                 const std::vector<MarkerPixel> &pixels, bool areIntrinsicsAssumed);

    double pixelSigmaPx() const { return m_pixelSigmaPx; }
    const FloorView &view() const { return m_view; }

    /// nullopt at or beyond the horizon or within 1° of it, where the lens model cannot be inverted, and on a
    /// plane z = heightM that the ray does not meet.
    std::optional<ReadPosition> at(const Eigen::Vector2d &pixel, double heightM = 0) const;

    /// All points, each with its position where it has one, in their order.
    std::vector<LocatedPoint> located(const std::vector<MarkerPixel> &points, double heightM = 0) const;

private:
    double m_pixelSigmaPx;
    FloorView m_view;
};

} // namespace odo
