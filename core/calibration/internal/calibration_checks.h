// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/lens_fit.h"

#include <array>

namespace odo {

/// Under so many views halves say nothing.
constexpr std::size_t leastViewsForHalves = 6;

/// Share of the corners beyond which outliers are kept: with more it is not known which of them are right.
constexpr double mostLeftOut = 0.1;

/// Each half of the images (every other one) under the intrinsics of the other half; only the poses adapt.
struct HeldOut
{
    double rmsPx = 0;                     ///< over the corners that can be predicted
    std::size_t unpredicted = 0;          ///< images without a pose under the other half's intrinsics
    std::vector<double> imageMeanSquares; ///< px², one an image; infinite where it is not predicted
    std::array<Intrinsics, 2> lenses;     ///< of the even and of the odd images
    double predictionPx() const;          ///< rmsPx; infinite where an image is not predicted
    double focalDifference() const;       ///< relative
};

/// all: the fit to all views, from which the halves are started; options: of their fits. nullopt under six
/// views, where a half led nowhere, and when cancelled.
std::optional<HeldOut> holdOut(const std::vector<BoardView> &views, const LensFit &all,
                               const LensFitOptions &options, const JobControl &control);

/// Whether a simpler model of the same views predicts held-out images worse than a richer one by more than
/// chance among the images explains, and by enough to matter.
bool predictsClearlyWorse(const HeldOut &simpler, const HeldOut &richer);

/// What the errors of a calibration are about.
Message cannotBeCalibrated();

tl::unexpected<Error> refuseCalibration(Message why, Message advice);

/// "0.20 %"
MessageArgument percentOf(double part);

/// The part of the image that the box about all corners covers.
double boxOfCorners(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// Where in the image the middle of all corners is: "upper left", "middle".
Message positionOfCorners(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// Refuses images that always show the board in the same part.
Result<void> checkPositions(const std::vector<BoardView> &views, int widthPx, int heightPx);

/// Refuses images that fall into two groups which are fitted far better by a lens each, of different focal
/// lengths.
Result<void> checkOneCamera(const std::vector<BoardView> &views, const LensFit &fit,
                            const JobControl &control);

/// Whether the focal length is known well enough for use, by its σ.
bool isDetermined(const LensFit &fit);

/// Refuses a fit that its images do not determine, and gives σ of its focal length over itself otherwise.
/// options: of the fit.
Result<double> checkDetermined(const std::vector<BoardView> &views, const LensFit &fit,
                               const LensFitOptions &options, const std::optional<HeldOut> &halves,
                               const JobControl &control);

} // namespace odo
