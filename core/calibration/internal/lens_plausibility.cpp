// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/lens_plausibility.h"

#include "core/calibration/internal/calibration_checks.h"
#include "core/calibration/internal/print_fit.h"
#include "core/calibration/internal/wording.h"

#include <cmath>

namespace odo {

namespace {

constexpr double unlikelyStretch = 0.01; // of a focal length
constexpr double provenPart = 0.25;      // of the difference: σ of the print's stretch
constexpr double unlikelyOffset = 0.1;   // of the image's width
constexpr double significant = 3;        // σ
constexpr double mostOfPulls = 0.5;      // of the squares of all images' pulls

/// Whether the images determine the print's stretch, and it does not explain the difference.
bool provesPrint(const std::vector<BoardView> &views, const LensFit &fit, double difference,
                 const JobControl &control)
{
    if (fit.estimatesPrint())
        return true;
    const auto shaped = fitIntrinsics(views, {fit.intrinsics, fit.cameraFromBoard, plainPrintOf(views)},
                                      {.freePrint = true}, control);
    if (!shaped)
        return false;
    const double sigma = std::sqrt(shaped->printCovariance(BoardShape::Stretch, BoardShape::Stretch));
    return sigma < provenPart * difference &&
           std::abs(shaped->print.values[BoardShape::Stretch]) < 0.5 * difference;
}

Message stretched(const std::vector<BoardView> &views, LensFit &fit, const JobControl &control)
{
    Intrinsics &lens = fit.intrinsics;
    const double difference = std::abs(lens.fxPx / lens.fyPx - 1);
    if (difference < unlikelyStretch)
        return {};
    const Message differ = ODO_TEXT("calibration.focal_lengths_differ",
                                    "The focal lengths across and down differ by %1")(percentOf(difference));
    if (provesPrint(views, fit, difference, control))
        return joined({differ, ODO_TEXT("calibration.pixels_not_square",
                                        "the camera's pixels are not square, or its images were rescaled")},
                      Join::Colon);
    const double px = lens.fxPx - lens.fyPx;
    lens.covariance(0, 0) += px * px;
    lens.covariance(1, 1) += px * px;
    return joined({differ, ODO_TEXT("calibration.print_may_be_stretched",
                                    "measure the squares of the print in both directions, for it may be "
                                    "stretched, and take images with the board turned by 90 degrees")},
                  Join::Colon);
}

Message offCentre(const Intrinsics &lens)
{
    const double offPx =
        std::hypot(lens.cxPx - 0.5 * (lens.widthPx - 1), lens.cyPx - 0.5 * (lens.heightPx - 1));
    const double sigmaPx = std::sqrt(lens.covariance(2, 2) + lens.covariance(3, 3));
    if (offPx < unlikelyOffset * lens.widthPx || offPx < significant * sigmaPx)
        return {};
    return joined({ODO_TEXT("calibration.centre_is_off",
                            "The optical centre is %1 off the image's middle")(quantity(offPx, 0, "px")),
                   ODO_TEXT("calibration.image_may_be_cropped",
                            "if these images were cropped, the videos must be cropped alike")},
                  Join::Colon);
}

} // namespace

Message implausible(const std::vector<BoardView> &views, LensFit &fit, const JobControl &control)
{
    const Message print = stretched(views, fit, control), centre = offCentre(fit.intrinsics);
    return joined({print.isEmpty() ? print : sentence(print), centre.isEmpty() ? centre : sentence(centre)},
                  Join::Space);
}

Message dominatingImage(const std::vector<BoardView> &views, const LensFit &fit)
{
    for (const int value : {0, 2, 3}) {
        double squares = 0;
        std::size_t most = 0;
        for (std::size_t i = 0; i < fit.withoutImage.size(); ++i) {
            squares += std::pow(fit.withoutImage[i][value], 2);
            if (std::abs(fit.withoutImage[i][value]) > std::abs(fit.withoutImage[most][value]))
                most = i;
        }
        if (squares <= 0 || std::pow(fit.withoutImage[most][value], 2) < mostOfPulls * squares)
            continue;
        const double byPx = fit.withoutImage[most][value];
        const MessageText &words = value == 0
                                       ? ODO_TEXT("calibration.without_it_focal",
                                                  "Check %1: without it the focal length changes by %2.")
                                       : ODO_TEXT("calibration.without_it_centre",
                                                  "Check %1: without it the optical centre moves by %2.");
        return words(views[most].source, quantity(std::abs(byPx), 1, "px"));
    }
    return {};
}

} // namespace odo
