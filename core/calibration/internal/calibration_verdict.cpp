// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/percentile.h"
#include "core/base/units.h"
#include "core/calibration/board_placement.h"
#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/intrinsic_calibration.h"

#include <algorithm>
#include <functional>

namespace odo {

namespace {

constexpr std::size_t fewViews = 10;
constexpr double goodM = 0.005, usableM = 0.015; // at worst on the floor, σ
constexpr double goodFocal = 0.005, usableFocal = 0.015, goodPx = 1, usablePx = 2;
constexpr double leastCoverage = 0.5;                        // of the image
constexpr double leastStretch = 0.003, leastBulgeM = 0.0003; // of a print, that is worth a word
constexpr double outlying = 3;                               // times the median of the images' RMS

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
        return std::size_t(std::ranges::count_if(image.outliers, [&](std::size_t corner) {
            return !std::ranges::binary_search(image.leftOut, corner);
        }));
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
    if (calibration.disagreeingPart > mostLeftOut)
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

/// "Left out: image7.jpg (it is of another camera)."
Message contradictingWords(const IntrinsicCalibration &calibration)
{
    constexpr std::size_t mostNamed = 3;
    const std::vector<RejectedImage> all = calibration.imagesContradicting();
    if (all.empty())
        return {};
    std::vector<Message> named;
    for (const RejectedImage &image : all) {
        if (named.size() < mostNamed)
            named.push_back(ODO_TEXT("calibration.image_and_reason", "%1 (%2)")(image.file, image.reason));
    }
    if (all.size() <= mostNamed)
        return ODO_TEXT("calibration.images_left_out", "Left out: %1.")(listed(std::move(named)));
    return ODO_TEXT("calibration.images_left_out_among",
                    "%1 images were left out, among them %2.")(all.size(), listed(std::move(named)));
}

/// What the images say about the print, where it is not a board of equal squares on a plane.
Message printWords(const IntrinsicCalibration &calibration)
{
    const double stretch = calibration.printStretch, bulgeM = calibration.printBulgeM;
    Message stretched, bent;
    if (std::abs(stretch) >= leastStretch)
        stretched = ODO_TEXT("calibration.print_is_stretched",
                             "The print's squares are %1 %2 from row to row than from column to column: "
                             "measure the squares in both directions.")(
            quantity(100 * std::abs(stretch), 1, "%"), stretch > 0
                                                           ? ODO_TEXT("calibration.longer", "longer")
                                                           : ODO_TEXT("calibration.shorter", "shorter"));
    if (bulgeM >= leastBulgeM)
        bent = ODO_TEXT("calibration.print_is_bent",
                        "The board is not flat, it bulges by %1: glue it onto something stiff.")(
            quantity(toMillimetres(bulgeM), 1, "mm"));
    if (stretched.isEmpty() && bent.isEmpty())
        return {};
    return joined({std::move(stretched), std::move(bent),
                   ODO_TEXT("calibration.print_was_heeded", "The calibration allows for this.")},
                  Join::Space);
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

Message repeatedImages(std::size_t repeats, std::size_t images)
{
    if (repeats == 1)
        return ODO_TEXT("calibration.image_repeats", "1 of %1 images shows the board in the same position as "
                                                     "another one, and each position counts once")(images);
    return ODO_TEXT("calibration.images_repeat",
                    "%1 of %2 images show the board in the same position as "
                    "another one, and each position counts once")(repeats, images);
}

Message calibrationVerdict(const IntrinsicCalibration &calibration, double focalSigma)
{
    const double covered = coveredPart(calibration);
    Message more, repeated;
    if (const std::size_t repeats = calibration.imagesRepeated(); repeats > 0)
        repeated = sentence(repeatedImages(repeats, repeats + calibration.imagesUsed()));
    if (calibration.imagesUsed() < fewViews)
        more = ODO_TEXT("calibration.more_pictures",
                        "More images (%1 or more) would make it more certain.")(fewViews);
    return joined(
        {graded(calibration, focalSigma, covered,
                joined({floorClause(calibration), fitClauses(calibration, focalSigma)}, Join::Semicolon)),
         lensWords(calibration), calibration.unlikely, printWords(calibration), std::move(repeated),
         contradictingWords(calibration), outlierWords(calibration), std::move(more), coverageWords(covered),
         outlierImage(calibration)},
        Join::Space);
}

} // namespace odo
