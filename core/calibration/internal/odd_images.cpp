// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/odd_images.h"

#include "core/base/percentile.h"
#include "core/calibration/internal/outlier_corners.h"
#include "core/calibration/internal/plane_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace odo {

namespace {

constexpr std::size_t leastForMajority = 6;
constexpr double mostOdd = 0.4;                       // of the images
constexpr double oddFocalSigmas = 8, oddZoom = 0.015; // of the focal length
constexpr double nowhereTimes = 8, nowherePx = 1.5;   // the usual distance, and at least
constexpr double fitsTimes = 2, leastUsualPx = 0.05;  // of a distance
constexpr int mostRounds = 6, robustRounds = 2;
constexpr double cauchyTimes = 2;  // σ of a coordinate
constexpr double alikeTimes = 1.5; // the usual distance
constexpr double misreadSigmas = 6;
constexpr double medianOfNormal = 0.6745;

/// How an image fits the lens of the others, and which focal length it has by itself.
struct ImageFit
{
    double distancePx = std::numeric_limits<double>::infinity(); ///< median of its corners
    std::optional<double> focalPx;
    double focalSigmas = 0; ///< off that of the others, in σ of its own
    double ownRmsPx = 0;    ///< with that focal length
};

using Members = std::vector<std::size_t>;

/// A fit to some of the views that heeds what disagrees little. all: a fit to all of them, to start from.
std::optional<LensFit> robustFit(const std::vector<BoardView> &views, const Members &members,
                                 const LensFit &all, const JobControl &control)
{
    std::vector<BoardView> some;
    LensStart start{all.intrinsics, {}, all.print};
    for (const std::size_t view : members) {
        some.push_back(views[view]);
        start.cameraFromBoard.push_back(all.cameraFromBoard[view]);
    }
    auto fit = fitIntrinsics(some, start, {}, control);
    for (int round = 0; fit && round < robustRounds; ++round)
        fit = fitIntrinsics(some, {fit->intrinsics, fit->cameraFromBoard, fit->print},
                            {.cauchyPx = cauchyTimes * robustSigmaPx(*fit)}, control);
    return fit;
}

double medianResidualPx(const std::vector<Eigen::Vector2d> &residuals)
{
    std::vector<double> distances;
    for (const Eigen::Vector2d &residual : residuals)
        distances.push_back(residual.norm());
    return upperMedian(std::move(distances));
}

/// The view without the corners that are misread under a lens.
BoardView soundPart(const BoardView &view, const LensFit &lens, double sigmaPx, const RigidTransform &near)
{
    const LensStart start{lens.intrinsics, {near}, lens.print};
    const auto pose =
        fitIntrinsics({view}, start, {.cauchyPx = cauchyTimes * sigmaPx, .holdLens = true}, JobControl());
    if (!pose)
        return view;
    std::vector<std::size_t> far;
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        if (pose->residualsPx.front()[i].norm() > misreadSigmas * sigmaPx)
            far.push_back(i);
    }
    return 2 * far.size() < view.pixels.size() ? withoutCorners({view}, {far}).front() : view;
}

ImageFit fitOf(const BoardView &view, const LensFit &lens, double sigmaPx, const RigidTransform &near)
{
    ImageFit image;
    if (const auto pose = fitPose(view, lens, near))
        image.distancePx = medianResidualPx(pose->residualsPx.front());
    const auto camera = CameraModel::create(lens.intrinsics);
    const auto own = fitPlanePose(pairsOf(view), *camera, FocalLength::Free);
    if (!own || !own->focalSigmaPx)
        return image;
    image.focalPx = own->camera.intrinsics().fxPx;
    image.ownRmsPx = own->rmsPx;
    const double atUnitNoise = *own->focalSigmaPx / std::max(1.0, own->sigmaPx);
    image.focalSigmas = std::abs(*image.focalPx - lens.intrinsics.fxPx) / (atUnitNoise * sigmaPx);
    return image;
}

/// What is usual among the members.
struct Usual
{
    double distancePx, focalSigmas;
};

Usual usualOf(const std::vector<ImageFit> &images, const Members &members)
{
    std::vector<double> distances, sigmas{medianOfNormal};
    for (const std::size_t view : members) {
        distances.push_back(images[view].distancePx);
        if (images[view].focalPx)
            sigmas.push_back(images[view].focalSigmas);
    }
    return {upperMedian(std::move(distances)),
            std::max(1.0, upperMedian(std::move(sigmas)) / medianOfNormal)};
}

Message reasonIn(const ImageFit &image, const Usual &usual, const LensFit &lens)
{
    const double focalPx = lens.intrinsics.fxPx;
    if (image.focalPx && image.focalSigmas > oddFocalSigmas * usual.focalSigmas &&
        std::abs(*image.focalPx / focalPx - 1) > oddZoom &&
        image.ownRmsPx < fitsTimes * std::max(usual.distancePx, leastUsualPx))
        return joined(
            {ODO_TEXT("calibration.other_focal_length", "it gives a focal length of %1, the other images %2")(
                 quantity(*image.focalPx, 0, "px"), quantity(focalPx, 0, "px")),
             ODO_TEXT("calibration.of_other_camera", "it is of another camera, zoom or focus")},
            Join::Colon);
    if (image.distancePx > std::max(nowherePx, nowhereTimes * usual.distancePx))
        return ODO_TEXT("calibration.corners_nowhere_near",
                        "its corners are %1 from where the other images predict them, theirs %2")(
            quantity(image.distancePx, 1, "px"), quantity(usual.distancePx, 1, "px"));
    return {};
}

std::vector<OddImage> oddUnder(const LensFit &lens, const std::vector<BoardView> &views,
                               const Members &members, const LensFit &all)
{
    const double sigmaPx = robustSigmaPx(lens);
    std::vector<ImageFit> images;
    for (std::size_t view = 0; view < views.size(); ++view)
        images.push_back(fitOf(soundPart(views[view], lens, sigmaPx, all.cameraFromBoard[view]), lens,
                               sigmaPx, all.cameraFromBoard[view]));
    const Usual usual = usualOf(images, members);
    std::vector<OddImage> odd;
    for (std::size_t view = 0; view < views.size(); ++view) {
        if (Message reason = reasonIn(images[view], usual, lens); !reason.isEmpty())
            odd.push_back({view, std::move(reason)});
    }
    return odd;
}

/// Whether all images fit about alike, so that none can be odd.
bool areAlike(const LensFit &all)
{
    std::vector<double> medians;
    for (const auto &residuals : all.residualsPx)
        medians.push_back(medianResidualPx(residuals));
    return *std::ranges::max_element(medians) < alikeTimes * upperMedian(medians);
}

std::vector<OddImage> oddAmong(const std::vector<BoardView> &views, const LensFit &all,
                               const JobControl &control)
{
    Members members(views.size());
    std::iota(members.begin(), members.end(), std::size_t(0));
    std::vector<OddImage> odd;
    for (int round = 0; round < mostRounds; ++round) {
        const auto lens = robustFit(views, members, all, control);
        if (!lens)
            return {};
        odd = oddUnder(*lens, views, members, all);
        if (static_cast<double>(odd.size()) >= mostOdd * static_cast<double>(views.size()))
            return {};
        Members kept;
        for (std::size_t view = 0; view < views.size(); ++view) {
            if (std::ranges::find(odd, view, &OddImage::view) == odd.end())
                kept.push_back(view);
        }
        if (kept == members)
            break;
        members = std::move(kept);
    }
    return odd;
}

} // namespace

std::vector<OddImage> oddImages(const std::vector<BoardView> &views, std::vector<LensStart> &starts,
                                const JobControl &control)
{
    if (views.size() < leastForMajority)
        return {};
    std::vector<LensStart> fitted = starts;
    std::optional<LensFit> all;
    for (LensStart &start : fitted) {
        auto fit = start.intrinsics.model == LensModel::Rational && starts.size() > 1
                       ? std::nullopt
                       : fitIntrinsics(views, start, {}, control);
        if (!fit)
            continue;
        start = {fit->intrinsics, fit->cameraFromBoard, fit->print};
        if (!all || robustSigmaPx(*fit) < robustSigmaPx(*all))
            all = std::move(fit);
    }
    if (all && !areAlike(*all))
        return oddAmong(views, *all, control);
    starts = std::move(fitted);
    return {};
}

} // namespace odo
