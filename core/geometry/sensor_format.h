// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"

#include <optional>
#include <vector>

namespace odo {

/// How images of one size may show what those that a lens was calibrated with show, of another size of the
/// same sensor. Pixels count from the middle of the first one (docs/conventions.md), so scaling by s takes u
/// to s (u + 0.5) − 0.5.
struct SensorFormat
{
    /// Whole: all of it, scaled, with a codec's rows of padding or without. WholeWidth: as much cut off above
    /// as below; WholeHeight: as much on the left as on the right.
    enum class Kind { Whole, WholeWidth, WholeHeight } kind = Kind::Whole;
    int clockwiseDeg = 0; ///< 0, 90 or 270: by which a calibrated image is turned, before all else
    int widthPx = 0, heightPx = 0;
    double scaleX = 1, scaleY = 1;        ///< pixels for each calibrated one, after turning
    double cropLeftPx = 0, cropTopPx = 0; ///< calibrated pixels cut off, after turning

    /// Nothing else is usual: the same shape, the same way up.
    bool isDetermined() const { return kind == Kind::Whole && clockwiseDeg == 0; }
};

/// The usual ways from one size to another, the likeliest first: one where the shape is the same (within a
/// pixel of rounding; 1088, 544 and 368 rows also count as 1080, 540 and 360 with padding below), else as
/// much of the sensor as the shape can show; where width and height are rather exchanged, turned either way.
/// Empty for a size that is not positive.
std::vector<SensorFormat> sensorFormats(int fromWidthPx, int fromHeightPx, int toWidthPx, int toHeightPx);

/// The one format that is determined, which may change nothing; none where there are several, or only turned
/// or cropped ones.
std::optional<SensorFormat> determinedFormat(int fromWidthPx, int fromHeightPx, int toWidthPx,
                                             int toHeightPx);

/// Where a pixel of a calibrated image of this size is in the other format.
Eigen::Vector2d inFormat(const Eigen::Vector2d &pixel, int fromWidthPx, int fromHeightPx,
                         const SensorFormat &format);

/// The same lens for images of another format, with its covariance. Distortion coefficients belong to angles,
/// so scaling and cropping leave them; turning turns the tangential ones (p1, p2).
Intrinsics inFormat(const Intrinsics &intrinsics, const SensorFormat &format);

/// A lens whose images were enlarged about their middle by digital zoom or stabilisation.
Intrinsics enlarged(const Intrinsics &intrinsics, double factor);

/// A lens whose covariance also holds that its images may be enlarged by a factor of this σ about 1. Of a
/// covariance that is not known it makes one that knows of nothing else.
Intrinsics withEnlargementSigma(Intrinsics intrinsics, double sigma);

/// The mean of two lenses of one model, whose covariance also holds half their difference.
Intrinsics meanOf(const Intrinsics &one, const Intrinsics &other);

} // namespace odo
