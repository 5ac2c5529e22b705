// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsic_calibration.h"

#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/calibration_evidence.h"
#include "core/calibration/internal/lens_choice.h"
#include "core/calibration/internal/lens_plausibility.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/print_fit.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/repeated_views.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double significantSigmas = 3;
constexpr double mostDisagreeing = 0.25; // of the corners: with more it is not known which of them are right

tl::unexpected<Error> tooFew(std::size_t usable)
{
    return refuseCalibration(
        ODO_TEXT("calibration.too_few_pictures",
                 "calibration needs three images of the board, %1 can be used")(usable),
        ODO_TEXT("calibration.take_ten", "take ten or more, the board tilted differently in each"));
}

tl::unexpected<Error> noLensFits(Message advice)
{
    return refuseCalibration(ODO_TEXT("calibration.no_lens_fits", "no lens model fits these images"),
                             std::move(advice));
}

/// Fills in the residuals of an image under a lens and a pose, and its RMS over the corners that count.
void judge(CalibrationImage &image, const CameraModel &camera, const BoardShape &print,
           const RigidTransform &cameraFromBoard)
{
    image.residualsPx.clear();
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < image.view.pixels.size(); ++i) {
        const auto pixel = camera.project(cameraFromBoard * print.at(image.view.pointsOnBoard[i]));
        image.residualsPx.push_back(pixel ? Eigen::Vector2d(image.view.pixels[i] - *pixel)
                                          : Eigen::Vector2d::Constant(std::nan("")));
        if (!pixel || std::ranges::binary_search(image.leftOut, i))
            continue;
        squares += image.residualsPx.back().squaredNorm();
        ++count;
    }
    image.rmsPx = count > 0 ? std::sqrt(squares / count) : 0;
}

std::optional<RigidTransform> poseOf(const BoardView &view, const CameraModel &camera)
{
    const auto pose = fitPlanePose(pairsOf(view), camera, FocalLength::Known);
    return pose ? std::optional(pose->worldFromCamera.inverse()) : std::nullopt;
}

/// A k3 of a standard lens that may be nothing is left out: it takes part of the focal length with it.
/// enlarged: by how much the fit's σ are to be larger than stated.
LensFitOptions simplestOf(const LensFit &fit, double enlarged)
{
    LensFitOptions options;
    const Intrinsics &lens = fit.intrinsics;
    if (lens.model == LensModel::Standard && lens.distortion.size() > sixthOrder)
        options.holdSixthOrder =
            std::abs(lens.distortion[sixthOrder]) <
            significantSigmas * enlarged * std::sqrt(lens.covariance(4 + sixthOrder, 4 + sixthOrder));
    return options;
}

/// The lens with k3 = 0. It keeps the covariance with k3 unknown.
LensFit withoutSixthOrder(const std::vector<BoardView> &views, LensFit fit, const JobControl &control)
{
    LensStart start{fit.intrinsics, fit.cameraFromBoard, fit.print};
    start.intrinsics.distortion[sixthOrder] = 0;
    auto simpler = fitIntrinsics(views, start, {.holdSixthOrder = true}, control);
    if (!simpler)
        return fit;
    simpler->intrinsics.covariance = std::move(fit.intrinsics.covariance);
    return std::move(*simpler);
}

/// From the fit to all corners to the outcome: outliers, halves, checks, values, words. views: those of the
/// images in `calibration` that are used, in their order. usualLensPx: as in LensFitOptions, of the fit.
Result<void> finish(IntrinsicCalibration &calibration, const std::vector<BoardView> &views, LensFit fit,
                    CornerMarks outliers, double usualLensPx, const JobControl &control)
{
    CornerMarks misread = misreadCorners(views, fit, outliers);
    if (auto shaped = usualLensPx > 0 ? std::nullopt : fitWithPrint(views, misread, fit, control)) {
        fit = std::move(*shaped);
        outliers = outlyingCorners(views, fit, control);
        misread = misreadCorners(views, fit, outliers);
    }
    ODO_TRY(checkOneCamera(views, fit, control));
    std::size_t corners = 0;
    for (const BoardView &view : views)
        corners += view.pixels.size();
    calibration.disagreeingPart = static_cast<double>(countOf(outliers)) / static_cast<double>(corners);
    if (calibration.disagreeingPart >= mostDisagreeing)
        return refuseCalibration(
            ODO_TEXT("calibration.corners_disagree", "%1 of the corners do not agree with the others")(
                percentOf(calibration.disagreeingPart)),
            ODO_TEXT("calibration.check_pictures", "check that all images are sharp, of one flat board and "
                                                   "of one camera at one zoom and focus"));
    const CornerMarks leftOut =
        calibration.disagreeingPart <= mostLeftOut ? std::move(misread) : CornerMarks(views.size());
    const std::vector<BoardView> counted = withoutCorners(views, leftOut);
    if (countOf(leftOut) > 0) {
        auto again = fitIntrinsics(counted, {fit.intrinsics, fit.cameraFromBoard, fit.print},
                                   {.freePrint = fit.estimatesPrint(), .usualLensPx = usualLensPx}, control);
        if (again)
            fit = std::move(*again);
    }
    // What the usual lens alone holds is as uncertain as before misread corners were left out.
    const double enlarged = std::max(scatterFactor(fit), usualLensPx / fit.sigmaPx);
    const Message dominating = enlarged > 1 ? dominatingImage(counted, fit) : Message();
    const LensFitOptions simplest =
        usualLensPx > 0 ? LensFitOptions{.usualLensPx = usualLensPx} : simplestOf(fit, enlarged);
    calibration.printStretch = fit.print.values[BoardShape::Stretch];
    calibration.printBulgeM = fit.print.bulgeM();
    if (simplest.holdSixthOrder)
        fit = withoutSixthOrder(counted, std::move(fit), control);
    ODO_TRY(checkPositions(views, fit.intrinsics.widthPx, fit.intrinsics.heightPx));
    control.report(0.6, ODO_TEXT("calibration.checking_halves", "checking the halves against each other"));
    const auto halves = holdOut(counted, fit, simplest, control);
    if (control.isCancelled())
        return cancelled(cannotBeCalibrated());
    const double sigma = enlarged * ODO_TRY(checkDetermined(counted, fit, simplest, halves, control));
    fit.intrinsics.covariance *= enlarged * enlarged;
    calibration.unlikely = joined({implausible(counted, fit, control), dominating}, Join::Space);

    calibration.intrinsics = fit.intrinsics;
    calibration.rmsPx = fit.rmsPx();
    calibration.onFloor = expectedOnFloor(fit.intrinsics);
    if (halves) {
        calibration.crossValidationPx = halves->rmsPx;
        calibration.halvesApart = apartOnFloor(halves->lenses[0], halves->lenses[1]);
    }
    const auto camera = CameraModel::create(fit.intrinsics);
    std::size_t next = 0;
    for (CalibrationImage &image : calibration.images) {
        image.outliers.clear();
        image.leftOut.clear();
        if (image.used) {
            image.outliers = outliers[next];
            image.leftOut = leftOut[next];
            judge(image, *camera, fit.print, fit.cameraFromBoard[next++]);
        } else if (const auto pose = poseOf(image.view, *camera)) {
            judge(image, *camera, fit.print, *pose);
        }
    }
    calibration.verdict = calibrationVerdict(calibration, sigma);
    control.report(1, ODO_TEXT("calibration.done", "done"));
    return {};
}

/// A calibration with one of the models, or why it failed.
struct Attempt
{
    IntrinsicCalibration calibration;
    Result<void> solved;
    std::optional<LensModel> model; ///< none where no model fits
};

Message usualLensAssumed()
{
    return ODO_TEXT("calibration.usual_lens", "the images leave it open, so square pixels, an optical centre "
                                              "near the middle and a usual distortion were assumed");
}

Message othersUndetermined()
{
    return ODO_TEXT("calibration.others_undetermined", "the images do not determine any other model");
}

/// begun: with its images; isGiven: the one model of the starts was asked for.
Attempt attempt(const IntrinsicCalibration &begun, const std::vector<BoardView> &used,
                const std::vector<LensStart> &starts, bool isGiven, const JobControl &control)
{
    auto choice = chooseLens(used, starts, control);
    if (control.isCancelled())
        return {begun, cancelled(cannotBeCalibrated()), {}};
    if (!choice)
        return {begun,
                noLensFits(ODO_TEXT("calibration.check_one_camera",
                                    "check that all are of one camera, at one zoom and focus")),
                {}};
    Attempt attempt{begun, {}, choice->fit.intrinsics.model};
    attempt.calibration.modelTrials = std::move(choice->trials);
    attempt.calibration.modelReason =
        isGiven || starts.size() > 1 ? std::move(choice->reason)
        : used.size() < leastViewsForHalves
            ? ODO_TEXT("calibration.too_few_to_compare", "too few images to compare it with other models")
            : othersUndetermined();
    attempt.solved =
        finish(attempt.calibration, used, std::move(choice->fit), std::move(choice->outliers), 0, control);
    return attempt;
}

/// Where the images leave a standard lens open, the usual values fill in: `best` stays where that fits as
/// little. begun: with its images.
void orUsualLens(Attempt &best, const IntrinsicCalibration &begun, const std::vector<BoardView> &used,
                 const LensStart &start, const JobControl &control)
{
    if (best.solved || !best.model || best.solved.error().code != ErrorCode::Undetermined ||
        start.intrinsics.model != LensModel::Standard)
        return;
    const auto open = fitIntrinsics(used, start, {}, control);
    if (!open)
        return;
    const double sigmaPx = open->sigmaPx * scatterFactor(*open);
    auto fit = fitIntrinsics(used, start, {.usualLensPx = sigmaPx}, control);
    if (!fit)
        return;
    CornerMarks outliers = outlyingCorners(used, *fit, control);
    Attempt attempt{begun, {}, LensModel::Standard};
    attempt.calibration.modelReason = usualLensAssumed();
    attempt.solved =
        finish(attempt.calibration, used, std::move(*fit), std::move(outliers), sigmaPx, control);
    if (attempt.solved)
        best = std::move(attempt);
}

/// From the corners to the outcome.
Result<void> solve(IntrinsicCalibration &calibration, const std::vector<BoardView> &views, int widthPx,
                   int heightPx, std::optional<LensModel> model, const JobControl &control)
{
    CalibrationEvidence evidence = evidenceFrom(views, widthPx, heightPx, model, calibration);
    const std::vector<BoardView> &used = evidence.views;
    if (used.size() < leastViews || evidence.starts.empty())
        return tooFew(used.size());
    control.report(0.1,
                   ODO_TEXT("calibration.fitting_lens", "fitting the lens model to %1 images")(used.size()));
    dropOddImages(evidence, calibration, control);
    const LensStart plainest = evidence.starts.front();
    Attempt best = attempt(calibration, used, evidence.starts, model.has_value(), control);
    // What a richer model leaves undetermined a plainer one may not.
    for (Attempt last = best;
         !last.solved && last.model && last.solved.error().code == ErrorCode::Undetermined;) {
        const auto refused = std::ranges::find_if(
            evidence.starts, [&](const LensStart &start) { return start.intrinsics.model == *last.model; });
        evidence.starts.erase(refused, evidence.starts.end());
        if (evidence.starts.empty())
            break;
        last = attempt(calibration, used, evidence.starts, false, control);
        if (last.solved)
            best = last;
    }
    orUsualLens(best, calibration, used, plainest, control);
    calibration = std::move(best.calibration);
    return best.solved;
}

/// The same from chosen images of the calibration, from its own intrinsics on.
Result<void> solveAgain(IntrinsicCalibration &calibration, const std::vector<std::size_t> &images,
                        const JobControl &control)
{
    const auto camera = ODO_TRY(CameraModel::create(calibration.intrinsics));
    std::vector<BoardView> chosen, used;
    std::vector<CalibrationImage *> chosenImages;
    for (std::size_t i = 0; i < calibration.images.size(); ++i) {
        CalibrationImage &image = calibration.images[i];
        image.used = false;
        image.repeats = image.contradicts = {};
        if (std::ranges::find(images, i) == images.end())
            continue;
        chosen.push_back(image.view);
        chosenImages.push_back(&image);
    }
    const BoardPositions positions = positionsIn(chosen);
    LensStart start{calibration.intrinsics, {}};
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        chosenImages[i]->repeats = repeatOf(chosen, positions, i);
        const auto pose = chosenImages[i]->repeats.isEmpty() ? poseOf(chosen[i], camera) : std::nullopt;
        chosenImages[i]->used = pose.has_value();
        if (!pose)
            continue;
        used.push_back(chosen[i]);
        start.cameraFromBoard.push_back(*pose);
    }
    if (used.size() < leastViews)
        return tooFew(used.size());
    auto fit = fitIntrinsics(used, start, {}, control);
    if (control.isCancelled())
        return cancelled(cannotBeCalibrated());
    if (!fit)
        return noLensFits(ODO_TEXT("calibration.choose_others", "choose others"));
    CornerMarks outliers = outlyingCorners(used, *fit, control);
    Attempt again{calibration, {}, calibration.intrinsics.model};
    if (calibration.modelReason == usualLensAssumed())
        again.calibration.modelReason = othersUndetermined();
    again.solved = finish(again.calibration, used, std::move(*fit), std::move(outliers), 0, control);
    orUsualLens(again, calibration, used, start, control);
    calibration = std::move(again.calibration);
    return again.solved;
}

/// A refusal says how many images count for nothing.
Result<IntrinsicCalibration> outcomeOf(const Result<void> &solved, IntrinsicCalibration calibration)
{
    if (solved)
        return calibration;
    Error error = solved.error();
    const std::size_t repeats = calibration.imagesRepeated();
    if (error.code == ErrorCode::Undetermined && repeats > 0)
        error.why =
            joined({std::move(error.why), repeatedImages(repeats, repeats + calibration.imagesUsed())},
                   Join::Semicolon);
    return tl::unexpected(std::move(error));
}

} // namespace

std::size_t IntrinsicCalibration::imagesUsed() const
{
    return static_cast<std::size_t>(std::ranges::count_if(images, &CalibrationImage::used));
}

std::size_t IntrinsicCalibration::imagesRepeated() const
{
    return static_cast<std::size_t>(std::ranges::count_if(
        images, [](const CalibrationImage &image) { return !image.repeats.isEmpty(); }));
}

std::vector<RejectedImage> IntrinsicCalibration::imagesContradicting() const
{
    std::vector<RejectedImage> contradicting;
    for (const CalibrationImage &image : images) {
        if (!image.contradicts.isEmpty())
            contradicting.push_back({image.view.source, image.contradicts});
    }
    return contradicting;
}

std::size_t IntrinsicCalibration::cornersLeftOut() const
{
    std::size_t count = 0;
    for (const CalibrationImage &image : images)
        count += image.leftOut.size();
    return count;
}

Result<IntrinsicCalibration> calibrateIntrinsics(const std::vector<BoardView> &views, int widthPx,
                                                 int heightPx, std::optional<LensModel> model,
                                                 const JobControl &control)
{
    if (widthPx <= 0 || heightPx <= 0)
        return fail(ErrorCode::InvalidInput, cannotBeCalibrated(),
                    ODO_TEXT("calibration.picture_without_size", "the image has no size"),
                    ODO_TEXT("calibration.use_camera_pictures", "use images from the camera"));
    IntrinsicCalibration calibration;
    const auto solved = solve(calibration, views, widthPx, heightPx, model, control);
    return outcomeOf(solved, std::move(calibration));
}

Result<IntrinsicCalibration> recalibrate(const IntrinsicCalibration &reference,
                                         const std::vector<std::size_t> &images, const JobControl &control)
{
    IntrinsicCalibration calibration = reference;
    calibration.crossValidationPx = 0;
    calibration.halvesApart.reset();
    const auto solved = solveAgain(calibration, images, control);
    return outcomeOf(solved, std::move(calibration));
}

std::vector<std::size_t> imagesWithin(const IntrinsicCalibration &calibration, double mostRmsPx)
{
    std::vector<std::size_t> within;
    for (std::size_t i = 0; i < calibration.images.size(); ++i) {
        if (calibration.images[i].rmsPx <= mostRmsPx)
            within.push_back(i);
    }
    return within;
}

} // namespace odo
