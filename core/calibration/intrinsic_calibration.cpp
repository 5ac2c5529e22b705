// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsic_calibration.h"

#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/calibration/board_placement.h"
#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/lens_choice.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace odo {

namespace {

constexpr std::size_t leastViews = 3;
constexpr double mostDisagreeing = 0.25; // of the corners: with more it is not known which of them are right

/// Why a view cannot be used and what to do; empty where it can.
Message faultOf(const BoardView &view)
{
    const std::size_t corners = std::min(view.pixels.size(), view.pointsOnBoard.size());
    if (corners < leastCornersOfView || view.pixels.size() != view.pointsOnBoard.size())
        return joined({ODO_TEXT("calibration.too_few_corners",
                                "it has %1 corners of the board, six are needed")(corners),
                       ODO_TEXT("calibration.show_more_of_it", "show more of it")},
                      Join::Colon);
    if (!std::ranges::all_of(view.pixels, [](const auto &p) { return p.allFinite(); }) ||
        !std::ranges::all_of(view.pointsOnBoard, [](const auto &p) { return p.allFinite(); }))
        return joined({ODO_TEXT("calibration.corner_no_number", "a corner of it is not a number"),
                       ODO_TEXT("calibration.find_board_again", "detect the board in it again")},
                      Join::Colon);
    return {};
}

/// The usable views; the others go to `rejected` with a reason.
std::vector<BoardView> usableViews(const std::vector<BoardView> &views, std::vector<RejectedImage> &rejected)
{
    std::vector<BoardView> usable;
    for (const BoardView &view : views) {
        Message fault = faultOf(view);
        if (fault.isEmpty())
            usable.push_back(view);
        else
            rejected.push_back({view.source, std::move(fault)});
    }
    return usable;
}

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

/// Starts of the models for the same views; views are dropped that have no pose under any model, and models
/// under which more views have none than under another.
std::vector<LensStart> startsFor(std::vector<BoardView> &views, int widthPx, int heightPx,
                                 std::optional<LensModel> model, std::vector<RejectedImage> &rejected)
{
    std::vector<LensModel> models{LensModel::Standard, LensModel::Fisheye, LensModel::Rational};
    if (model)
        models = {*model};
    else if (views.size() < leastViewsForHalves)
        models = {LensModel::Standard};
    std::vector<std::vector<std::size_t>> withoutPose(models.size());
    std::vector<std::optional<LensStart>> starts;
    std::size_t fewest = views.size();
    for (std::size_t i = 0; i < models.size(); ++i) {
        // A rational lens begins as a standard one.
        if (models[i] == LensModel::Rational && !model) {
            starts.push_back(starts.front());
            withoutPose[i] = withoutPose.front();
            if (starts.back())
                starts.back()->intrinsics.model = LensModel::Rational;
        } else {
            starts.push_back(startLens(views, widthPx, heightPx, models[i], withoutPose[i]));
        }
        if (starts.back())
            fewest = std::min(fewest, withoutPose[i].size());
    }
    std::vector<LensStart> kept;
    std::vector<std::size_t> dropped;
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (!starts[i] || withoutPose[i].size() > fewest || (!kept.empty() && withoutPose[i] != dropped))
            continue;
        dropped = withoutPose[i];
        kept.push_back(std::move(*starts[i]));
    }
    for (auto index = dropped.rbegin(); index != dropped.rend(); ++index) {
        rejected.push_back(
            {views[*index].source,
             joined({ODO_TEXT("calibration.corners_not_flat", "its corners do not match a flat board"),
                     ODO_TEXT("calibration.glue_board", "glue the board onto something stiff")},
                    Join::Colon)});
        views.erase(views.begin() + static_cast<std::ptrdiff_t>(*index));
    }
    return kept;
}

/// Fills in the residuals of an image under a lens and a pose, and its RMS over the corners that count.
void judge(CalibrationImage &image, const CameraModel &camera, const RigidTransform &cameraFromBoard)
{
    image.residualsPx.clear();
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < image.view.pixels.size(); ++i) {
        const Eigen::Vector2d &point = image.view.pointsOnBoard[i];
        const auto pixel = camera.project(cameraFromBoard * Eigen::Vector3d(point.x(), point.y(), 0));
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
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < view.pixels.size(); ++i)
        pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
    const auto pose = fitPlanePose(pairs, camera, FocalLength::Known);
    return pose ? std::optional(pose->worldFromCamera.inverse()) : std::nullopt;
}

/// From the fit to all corners to the outcome: outliers, halves, checks, values, words. views: those of the
/// images in `calibration` that are used, in their order.
Result<void> finish(IntrinsicCalibration &calibration, const std::vector<BoardView> &views, LensFit fit,
                    const CornerMarks &outliers, const JobControl &control)
{
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
    const CornerMarks leftOut = calibration.disagreeingPart <= mostOutliers
                                    ? singleCorners(views, fit, outliers)
                                    : CornerMarks(views.size());
    const std::vector<BoardView> counted = withoutCorners(views, leftOut);
    if (countOf(leftOut) > 0) {
        auto again = fitLens(counted, {fit.intrinsics, fit.cameraFromBoard}, {}, control);
        if (again)
            fit = std::move(*again);
    }
    control.report(0.6, ODO_TEXT("calibration.checking_halves", "checking the halves against each other"));
    const auto halves = holdOut(counted, fit, control);
    if (control.isCancelled())
        return cancelled(cannotBeCalibrated());
    const auto sigma = ODO_TRY(checkDetermined(counted, fit, halves, control));

    ODO_TRY(checkPositions(views, fit.intrinsics.widthPx, fit.intrinsics.heightPx));

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
            judge(image, *camera, fit.cameraFromBoard[next++]);
        } else if (const auto pose = poseOf(image.view, *camera)) {
            judge(image, *camera, *pose);
        }
    }
    calibration.verdict = calibrationVerdict(calibration, sigma);
    control.report(1, ODO_TEXT("calibration.done", "done"));
    return {};
}

} // namespace

std::size_t IntrinsicCalibration::imagesUsed() const
{
    return static_cast<std::size_t>(std::ranges::count_if(images, &CalibrationImage::used));
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
    std::vector<BoardView> used = usableViews(views, calibration.rejected);
    if (used.size() < leastViews)
        return tooFew(used.size());
    const auto starts = startsFor(used, widthPx, heightPx, model, calibration.rejected);
    if (used.size() < leastViews || starts.empty())
        return tooFew(used.size());
    control.report(0.1,
                   ODO_TEXT("calibration.fitting_lens", "fitting the lens model to %1 images")(used.size()));
    auto choice = chooseLens(used, starts, control);
    if (control.isCancelled())
        return cancelled(cannotBeCalibrated());
    if (!choice)
        return noLensFits(ODO_TEXT("calibration.check_one_camera",
                                   "check that all are of one camera, at one zoom and focus"));
    for (const BoardView &view : used)
        calibration.images.push_back({view, true, 0, {}, {}, {}});
    calibration.modelTrials = std::move(choice->trials);
    calibration.modelReason =
        model || used.size() >= leastViewsForHalves
            ? std::move(choice->reason)
            : ODO_TEXT("calibration.too_few_to_compare", "too few images to compare it with other models");
    ODO_TRY(finish(calibration, used, std::move(choice->fit), choice->outliers, control));
    return calibration;
}

Result<IntrinsicCalibration> recalibrate(const IntrinsicCalibration &reference,
                                         const std::vector<std::size_t> &images, const JobControl &control)
{
    IntrinsicCalibration calibration = reference;
    calibration.crossValidationPx = 0;
    calibration.halvesApart.reset();
    const auto camera = ODO_TRY(CameraModel::create(reference.intrinsics));
    std::vector<BoardView> used;
    LensStart start{reference.intrinsics, {}};
    for (std::size_t i = 0; i < calibration.images.size(); ++i) {
        CalibrationImage &image = calibration.images[i];
        const auto pose =
            std::ranges::find(images, i) == images.end() ? std::nullopt : poseOf(image.view, camera);
        image.used = pose.has_value();
        if (!pose)
            continue;
        used.push_back(image.view);
        start.cameraFromBoard.push_back(*pose);
    }
    if (used.size() < leastViews)
        return tooFew(used.size());
    auto fit = fitLens(used, start, {}, control);
    if (control.isCancelled())
        return cancelled(cannotBeCalibrated());
    if (!fit)
        return noLensFits(ODO_TEXT("calibration.choose_others", "choose others"));
    const CornerMarks outliers = outlyingCorners(used, *fit, control);
    ODO_TRY(finish(calibration, used, std::move(*fit), outliers, control));
    return calibration;
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

namespace {

constexpr std::size_t fewViews = 10;
constexpr double goodM = 0.005, usableM = 0.015; // at worst on the floor, σ
constexpr double goodFocal = 0.005, usableFocal = 0.015, goodPx = 1, usablePx = 2;
constexpr double leastCoverage = 0.5; // of the image
constexpr double outlying = 3;        // times the median of the images' RMS

MessageArgument roundMillimetres(double metres)
{
    const double mm = toMillimetres(metres);
    return quantity(mm, mm < 10 ? 1 : 0, "mm");
}

std::vector<const CalibrationImage *> usedImages(const IntrinsicCalibration &calibration)
{
    std::vector<const CalibrationImage *> used;
    for (const CalibrationImage &image : calibration.images) {
        if (image.used)
            used.push_back(&image);
    }
    return used;
}

double coveredPart(const IntrinsicCalibration &calibration)
{
    std::vector<BoardView> views;
    for (const CalibrationImage *image : usedImages(calibration))
        views.push_back(image->view);
    return coverageOf(views, {}, calibration.intrinsics.widthPx, calibration.intrinsics.heightPx)
        .coveredPart();
}

Message graded(const IntrinsicCalibration &calibration, double focalSigma, double covered, Message clauses)
{
    const double worstM = calibration.onFloor ? calibration.onFloor->worstM : 1;
    const bool trusted = calibration.disagreeingPart <= mostOutliers;
    if (worstM < goodM && focalSigma < goodFocal && calibration.rmsPx < goodPx && trusted &&
        calibration.imagesUsed() >= fewViews && covered >= leastCoverage)
        return goodVerdict(std::move(clauses));
    if (worstM < usableM && focalSigma < usableFocal && calibration.rmsPx < usablePx)
        return usableVerdict(std::move(clauses));
    return ODO_TEXT("calibration.poor", "Poor: %1.")(std::move(clauses));
}

Message floorClause(const IntrinsicCalibration &calibration)
{
    if (!calibration.onFloor)
        return ODO_TEXT("calibration.no_millimetres",
                        "no value in millimetres: this calibration holds for only part of the image");
    const FloorExpectation &floor = *calibration.onFloor;
    return ODO_TEXT("calibration.lens_on_floor",
                    "±%1 in the middle and at most ±%2 (%3) on %4, from the lens calibration alone")(
        roundMillimetres(floor.middleM), roundMillimetres(floor.worstM), floor.worstWhere,
        typicalTestbedWords());
}

/// How the images fit, and how their halves do.
Message fitClauses(const IntrinsicCalibration &calibration, double focalSigma)
{
    const std::size_t images = calibration.imagesUsed();
    const MessageArgument rms = quantity(calibration.rmsPx, 2, "px"),
                          focal = quantity(calibration.intrinsics.fxPx, 1, "px"),
                          sigma = percentOf(focalSigma);
    if (!(calibration.crossValidationPx > 0) && calibration.halvesApart)
        return ODO_TEXT("calibration.pictures_fit_halves_apart",
                        "%1 images fit to %2, focal length %3 ± %4, halves at most %5 apart on that floor")(
            images, rms, focal, sigma, roundMillimetres(calibration.halvesApart->worstM));
    Message fit = ODO_TEXT("calibration.pictures_fit",
                           "%1 images fit to %2, focal length %3 ± %4")(images, rms, focal, sigma);
    if (!(calibration.crossValidationPx > 0))
        return fit;
    const MessageArgument predicted = quantity(calibration.crossValidationPx, 2, "px");
    Message halves =
        calibration.halvesApart
            ? ODO_TEXT("calibration.halves_foretell_apart",
                       "each half of the images predicts the other to %1, at most %2 apart on that floor")(
                  predicted, roundMillimetres(calibration.halvesApart->worstM))
            : ODO_TEXT("calibration.halves_foretell",
                       "each half of the images predicts the other to %1")(predicted);
    return joined({std::move(fit), std::move(halves)}, Join::Semicolon);
}

/// The images with the highest counts.
struct Where
{
    MessageArgument images; ///< "left02.jpg (6) and left09.jpg (3)", those with most of it first
    bool isAll;             ///< no other image has any
};

Where whereOf(const IntrinsicCalibration &calibration,
              const std::function<std::size_t(const CalibrationImage &)> &counted)
{
    constexpr std::size_t mostNamed = 3;
    std::vector<const CalibrationImage *> with = usedImages(calibration);
    std::erase_if(with, [&](const CalibrationImage *image) { return counted(*image) == 0; });
    std::ranges::stable_sort(with, std::ranges::greater{},
                             [&](const CalibrationImage *image) { return counted(*image); });
    std::vector<Message> names;
    for (const CalibrationImage *image : with) {
        if (names.size() < mostNamed)
            names.push_back(
                ODO_TEXT("calibration.picture_with_corners", "%1 (%2)")(image->view.source, counted(*image)));
    }
    return {listed(std::move(names)), with.size() <= mostNamed};
}

Message disagreeingWords(const IntrinsicCalibration &calibration)
{
    const Where where =
        whereOf(calibration, [](const CalibrationImage &image) { return image.outliers.size(); });
    const MessageText &disagree =
        where.isAll ? ODO_TEXT("calibration.disagree_in", "%1 of the corners disagree, in %2")
                    : ODO_TEXT("calibration.disagree_most_in", "%1 of the corners disagree, most in %2");
    return joined(
        {disagree(quantity(100 * calibration.disagreeingPart, 0, "%"), where.images),
         joined(
             {ODO_TEXT("calibration.were_kept", "they were kept"),
              ODO_TEXT("calibration.look_at_pictures",
                       "check these images and leave out those that are blurred, bent or of another board.")},
             Join::Semicolon)},
        Join::Colon);
}

Message leftOutWords(const IntrinsicCalibration &calibration)
{
    const std::size_t count = calibration.cornersLeftOut();
    if (count == 0)
        return {};
    const Where where =
        whereOf(calibration, [](const CalibrationImage &image) { return image.leftOut.size(); });
    if (count == 1)
        return ODO_TEXT("calibration.corner_left_out", "1 outlier corner was left out, in %1.")(where.images);
    const MessageText &words =
        where.isAll ? ODO_TEXT("calibration.corners_left_out_in", "%1 outlier corners were left out, in %2.")
                    : ODO_TEXT("calibration.corners_left_out_most_in",
                               "%1 outlier corners were left out, most in %2.");
    return words(count, where.images);
}

/// About neighbouring outlier corners.
Message keptWords(const IntrinsicCalibration &calibration)
{
    const auto kept = [](const CalibrationImage &image) {
        return image.outliers.size() - image.leftOut.size();
    };
    std::size_t count = 0;
    for (const CalibrationImage &image : calibration.images)
        count += kept(image);
    if (count == 0)
        return {};
    const Where where = whereOf(calibration, kept);
    const MessageText &words =
        where.isAll
            ? ODO_TEXT("calibration.corners_kept_in", "%1 neighbouring outlier corners were kept, in %2")
            : ODO_TEXT("calibration.corners_kept_most_in",
                       "%1 neighbouring outlier corners were kept, most in %2");
    return joined({words(count, where.images),
                   ODO_TEXT("calibration.leave_out_pictures",
                            "leave out these images if the board is bent, cut or covered there.")},
                  Join::Colon);
}

Message outlierWords(const IntrinsicCalibration &calibration)
{
    if (calibration.disagreeingPart <= 0)
        return {};
    if (calibration.disagreeingPart > mostOutliers)
        return disagreeingWords(calibration);
    return joined({leftOutWords(calibration), keptWords(calibration)}, Join::Space);
}

/// The image whose misfit is an outlier, if there is one.
Message outlierImage(const IntrinsicCalibration &calibration)
{
    std::vector<double> rms;
    const CalibrationImage *worst = nullptr;
    for (const CalibrationImage *image : usedImages(calibration)) {
        rms.push_back(image->rmsPx);
        if (worst == nullptr || image->rmsPx > worst->rmsPx)
            worst = image;
    }
    if (worst == nullptr || worst->rmsPx <= outlying * upperMedian(rms))
        return {};
    return joined({ODO_TEXT("calibration.look_at", "Check %1")(worst->view.source),
                   ODO_TEXT("calibration.picture_stands_out",
                            "its %1 is an outlier.")(quantity(worst->rmsPx, 2, "px"))},
                  Join::Colon);
}

Message lensWords(const IntrinsicCalibration &calibration)
{
    const LensModel model = calibration.intrinsics.model;
    const MessageText &name =
        model == LensModel::Standard   ? ODO_TEXT("calibration.standard_lens", "Standard lens")
        : model == LensModel::Rational ? ODO_TEXT("calibration.rational_lens", "Rational lens")
                                       : ODO_TEXT("calibration.fisheye_lens", "Fisheye lens");
    return sentence(joined({name, calibration.modelReason}, Join::Colon));
}

Message coverageWords(double covered)
{
    if (covered >= leastCoverage)
        return {};
    return joined({ODO_TEXT("calibration.picture_covered",
                            "The board covered only %1 of the image")(quantity(100 * covered, 0, "%")),
                   ODO_TEXT("calibration.show_near_edges", "show the board near its edges too.")},
                  Join::Colon);
}

} // namespace

Message calibrationVerdict(const IntrinsicCalibration &calibration, double focalSigma)
{
    const double covered = coveredPart(calibration);
    Message more;
    if (calibration.imagesUsed() < fewViews)
        more = ODO_TEXT("calibration.more_pictures",
                        "More images (%1 or more) would make it more certain.")(fewViews);
    return joined(
        {graded(calibration, focalSigma, covered,
                joined({floorClause(calibration), fitClauses(calibration, focalSigma)}, Join::Semicolon)),
         lensWords(calibration), outlierWords(calibration), std::move(more), coverageWords(covered),
         outlierImage(calibration)},
        Join::Space);
}

} // namespace odo
