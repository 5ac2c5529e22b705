// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/print_fit.h"

#include "core/calibration/internal/calibration_checks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double worthHoldingOut = 0.98; // of the squares
constexpr double scatters = 2;           // of the variance found by so many images

} // namespace

BoardShape plainPrintOf(const std::vector<BoardView> &views)
{
    Eigen::AlignedBox2d box;
    for (const BoardView &view : views) {
        for (const Eigen::Vector2d &point : view.pointsOnBoard)
            box.extend(point);
    }
    return {box.center(), box.sizes().maxCoeff(), {}};
}

std::optional<LensFit> fitWithPrint(const std::vector<BoardView> &views, const CornerMarks &misread,
                                    const LensFit &flat, const JobControl &control)
{
    if (views.size() < leastViewsForHalves)
        return std::nullopt;
    const LensFitOptions options{.freePrint = true};
    const std::vector<BoardView> sound = withoutCorners(views, misread);
    const auto plain = countOf(misread) == 0
                           ? std::optional(flat)
                           : fitIntrinsics(sound, {flat.intrinsics, flat.cameraFromBoard}, {}, control);
    const auto shaped =
        fitIntrinsics(sound, {flat.intrinsics, flat.cameraFromBoard, plainPrintOf(views)}, options, control);
    if (!plain || !shaped || !isDetermined(*shaped) || shaped->squares > worthHoldingOut * plain->squares)
        return std::nullopt;
    const auto worse = holdOut(sound, *plain, {}, control),
               better = holdOut(sound, *shaped, options, control);
    if (!worse || !better || !predictsClearlyWorse(*worse, *better))
        return std::nullopt;
    return fitIntrinsics(views, {shaped->intrinsics, shaped->cameraFromBoard, shaped->print}, options,
                         control);
}

double scatterFactor(const LensFit &fit)
{
    if (fit.clusterCovariance.size() == 0)
        return 1;
    const auto images = static_cast<double>(fit.withoutImage.size());
    const Eigen::ArrayXd larger = fit.clusterCovariance.diagonal().head<4>().array() /
                                  fit.intrinsics.covariance.diagonal().head<4>().array();
    double factor = 1;
    for (const double pair : {larger.head<2>().mean(), larger.tail<2>().mean()}) {
        if (pair > 1 + scatters * std::sqrt(1 / images))
            factor = std::max(factor, pair);
    }
    return std::sqrt(factor);
}

} // namespace odo
