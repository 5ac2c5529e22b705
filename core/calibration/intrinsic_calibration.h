// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/calibration/board_detection.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/camera_model.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

struct RejectedImage
{
    std::string file;
    Message reason; ///< a clause
};

/// An image of a calibration, with its residuals.
struct CalibrationImage
{
    BoardView view;   ///< its corners as seen, all of them
    bool used = true; ///< false: left out; its values then come from the intrinsics of the others
    /// A clause, where it was left out because it shows the board in the same position as one that is used
    /// (positionsIn). Not stored.
    Message repeats;
    /// A clause, where it was left out because it contradicts the others, as one of another camera does. Not
    /// stored.
    Message contradicts;
    double rmsPx = 0; ///< of its corners that count: sqrt(mean of squared distances)
    /// One a corner: seen minus predicted, pixels. An arrow from the predicted position to the seen one.
    std::vector<Eigen::Vector2d> residualsPx;
    std::vector<std::size_t> outliers; ///< indices of the outlier corners, ascending
    std::vector<std::size_t> leftOut;  ///< those of them that do not count
};

/// How well a lens model predicts held-out images.
struct ModelTrial
{
    LensModel model = LensModel::Standard;
    /// RMS of each half's corners under the other half's lens; infinite where it cannot predict all
    double heldOutPx = 0;
};

/// The outcome of a calibration.
struct IntrinsicCalibration
{
    Intrinsics intrinsics;
    /// By which share the print's squares are longer from row to row than from column to column, and how far
    /// the board bulges; 0 where equal squares on a plane predict held-out images as well. Not stored.
    double printStretch = 0, printBulgeM = 0;
    Message unlikely; ///< what is unlikely about the lens, in sentences; empty of a likely one. Not stored.
    /// over all corners that count, sqrt(mean of squared distances)
    double rmsPx = 0;
    std::vector<CalibrationImage> images; ///< used or left out; in the order given
    std::vector<RejectedImage> rejected;  ///< those that cannot be used
    /// RMS of each half's corners under the other half's intrinsics; 0 under 6 views
    double crossValidationPx = 0;
    /// What the uncertainty of the lens alone leaves on the floor of a typical testbed, σ; none for an
    /// imported lens.
    std::optional<FloorExpectation> onFloor;
    /// How far the lenses of the two halves are apart on that floor; none under 6 views.
    std::optional<FloorExpectation> halvesApart;
    std::vector<ModelTrial> modelTrials; ///< the compared models; empty if the model was given
    Message modelReason;                 ///< why this model, a clause: "as specified"; "no other model fits"
    /// Share of the outlier corners in the used images. Beyond a tenth they were all kept.
    double disagreeingPart = 0;
    Message verdict; ///< the grade, millimetres on the floor, then pixels, then what to do

    std::size_t imagesUsed() const;
    std::size_t imagesRepeated() const;
    std::vector<RejectedImage> imagesContradicting() const;
    std::size_t cornersLeftOut() const;
};

/// Up to this share of the corners may disagree in a good calibration.
constexpr double mostOutliers = 0.03;

/// Zhang 2000 with Levenberg–Marquardt refinement (Ceres), all views jointly.
///
/// model: nullopt chooses among Standard, Rational and Fisheye: the simplest whose error on held-out images
/// is within a margin of the best one's (two standard errors of the paired differences of the images' RMS,
/// and 1 %; after the one-standard-error rule of Breiman et al. 1984, section 3.4.3). Under six views
/// Standard.
///
/// Corners whose residual is beyond 5 robust σ (median of the distances) of a fit that heeds them little
/// (Cauchy's loss) are left out when they are at most a tenth of all; more are kept. Where the rest of
/// an image lies on a flat board, an outer row or column with many of them (a narrower outer square, a cut)
/// is left out as a whole. Where it does not, three or more side by side are kept,
/// for they are a sign of a bent board. The verdict says how many, where, and what was done.
///
/// A standard lens whose k3 is within 3 σ of nothing gets k3 = 0, with the covariance of an unknown k3: the
/// focal length would follow it.
///
/// Images of another camera, zoom or focus than most are left out and named, where they are fewer than two
/// fifths (oddImages). Where a print that is stretched, skew or bent, the same in all images, predicts
/// held-out images clearly better than a board of equal squares on a plane, it is estimated with the lens.
///
/// The covariance is the larger of two: from the residuals' σ, and from the scatter of the images' pulls,
/// where that is more than chance explains, for the errors of an image's corners may have much in common.
///
/// Of images that show the board in the same position one counts (positionsIn), for the fit, its uncertainty,
/// the halves and all else; the verdict and a refusal say how many others there are.
///
/// Where the images leave every model open, a standard lens is fitted of which the usual values (UsualLens:
/// square pixels, a centre near the middle, an ordinary distortion; nothing of the focal length) count beside
/// the corners, with the covariance that follows; the verdict says so.
///
/// Refuses, with the reason: fewer than three views, a focal length that stays open, all in one part of the
/// image, two focal lengths, halves that contradict each other, and a quarter of the corners or more that
/// disagree. Any thread; asks control for cancellation in each iteration of each fit.
Result<IntrinsicCalibration> calibrateIntrinsics(const std::vector<BoardView> &views, int widthPx,
                                                 int heightPx, std::optional<LensModel> model,
                                                 const JobControl &control);

/// The calibration again from chosen images of it (indices into reference.images), with its lens model,
/// started from its intrinsics, fast enough to follow a dragged slider. The images not chosen stay in the
/// answer with used = false. Refuses as calibrateIntrinsics does. Any thread; cancellable.
Result<IntrinsicCalibration> recalibrate(const IntrinsicCalibration &reference,
                                         const std::vector<std::size_t> &images, const JobControl &control);

/// The images whose RMS in this calibration is at most so large: for recalibrate, by a threshold.
std::vector<std::size_t> imagesWithin(const IntrinsicCalibration &calibration, double mostRmsPx);

/// The sentences of IntrinsicCalibration::verdict from all else in it. focalSigma: of the focal length over
/// itself.
Message calibrationVerdict(const IntrinsicCalibration &calibration, double focalSigma);

/// "33 of 36 images show the board in the same position as another one, and each position counts once".
Message repeatedImages(std::size_t repeats, std::size_t images);

} // namespace odo
