// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/calibration_checks.h"

#include "core/base/units.h"
#include "core/calibration/internal/plane_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

constexpr double marginErrors = 2;  // standard errors of the mean difference
constexpr double marginPart = 0.01; // of the RMS: less is nothing that anybody would notice

std::optional<LensFit> fitHalf(const std::vector<BoardView> &views, const LensFit &all, std::size_t half,
                               const LensFitOptions &options, const JobControl &control)
{
    std::vector<BoardView> some;
    LensStart start{all.intrinsics, {}, all.print};
    for (std::size_t i = half; i < views.size(); i += 2) {
        some.push_back(views[i]);
        start.cameraFromBoard.push_back(all.cameraFromBoard[i]);
    }
    return fitIntrinsics(some, start, options, control);
}

} // namespace

double HeldOut::predictionPx() const
{
    return unpredicted == 0 ? rmsPx : std::numeric_limits<double>::infinity();
}

double HeldOut::focalDifference() const
{
    return std::abs(lenses[0].fxPx - lenses[1].fxPx) / (0.5 * (lenses[0].fxPx + lenses[1].fxPx));
}

std::optional<HeldOut> holdOut(const std::vector<BoardView> &views, const LensFit &all,
                               const LensFitOptions &options, const JobControl &control)
{
    if (views.size() < leastViewsForHalves)
        return std::nullopt;
    HeldOut heldOut;
    std::array<std::optional<LensFit>, 2> halves;
    for (std::size_t half = 0; half < 2; ++half) {
        halves[half] = fitHalf(views, all, half, options, control);
        if (!halves[half])
            return std::nullopt;
        heldOut.lenses[half] = halves[half]->intrinsics;
    }
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (control.isCancelled())
            return std::nullopt;
        const auto corners = static_cast<double>(views[i].pixels.size());
        const auto pose = fitPose(views[i], *halves[1 - i % 2], all.cameraFromBoard[i]);
        heldOut.imageMeanSquares.push_back(pose ? pose->squares / corners
                                                : std::numeric_limits<double>::infinity());
        if (!pose) {
            ++heldOut.unpredicted;
            continue;
        }
        squares += pose->squares;
        count += corners;
    }
    heldOut.rmsPx = count > 0 ? std::sqrt(squares / count) : 0;
    return heldOut;
}

bool predictsClearlyWorse(const HeldOut &simpler, const HeldOut &richer)
{
    if (!(simpler.predictionPx() > (1 + marginPart) * richer.predictionPx()))
        return false;
    if (!std::isfinite(simpler.predictionPx()))
        return true;
    const auto &worse = simpler.imageMeanSquares, &better = richer.imageMeanSquares;
    const auto count = static_cast<double>(worse.size());
    // Of each image's RMS, since squares would let one image drown the others.
    const auto gain = [&](std::size_t i) { return std::sqrt(worse[i]) - std::sqrt(better[i]); };
    double mean = 0, squares = 0;
    for (std::size_t i = 0; i < worse.size(); ++i)
        mean += gain(i) / count;
    for (std::size_t i = 0; i < worse.size(); ++i)
        squares += std::pow(gain(i) - mean, 2);
    return mean > marginErrors * std::sqrt(squares / (count - 1) / count);
}

namespace {

constexpr double leastTurn = 8;              // degrees between the most different poses of the board
constexpr double uncertainFocalSigma = 0.03; // of the focal length
// by how much the focal length is changed to see whether the images constrain it
constexpr double probe = 1.3;
constexpr double leastBox = 0.15; // of the image, that the board must have been moved over
constexpr std::size_t leastGroup = 3;
constexpr double suspiciousGain = 1.5, groupGain = 2; // of the sum of squares
constexpr double leastZoom = 0.02;                    // of the focal length

Message tiltAdvice()
{
    return ODO_TEXT("calibration.tilt_board",
                    "take images with the board tilted by 30 to 45 degrees, to each side");
}

/// The largest angle between the board's normals of any two images, degrees.
double largestTurn(const LensFit &fit)
{
    double least = 1;
    for (const RigidTransform &a : fit.cameraFromBoard) {
        for (const RigidTransform &b : fit.cameraFromBoard)
            least = std::min(
                least, (a.rotation * Eigen::Vector3d::UnitZ()).dot(b.rotation * Eigen::Vector3d::UnitZ()));
    }
    return std::acos(std::clamp(least, -1.0, 1.0)) * 180 / EIGEN_PI;
}

/// σ of the focal length over itself: the larger of the one from the curvature at the optimum and those from
/// the misfit at other focal lengths. The curvature alone is fooled by frontal views: with 12 of them OpenCV
/// states 0.1 % for a focal length that is wrong by a factor of 13.
double focalSigma(const std::vector<BoardView> &views, const LensFit &fit, const LensFitOptions &options,
                  const JobControl &control)
{
    const double curvature = std::sqrt(fit.intrinsics.covariance(0, 0)) / fit.intrinsics.fxPx;
    double sigma = curvature;
    for (double factor : {1 / probe, probe}) {
        LensStart start{fit.intrinsics, fit.cameraFromBoard, fit.print};
        start.intrinsics.fxPx *= factor;
        start.intrinsics.fyPx *= factor;
        for (RigidTransform &pose : start.cameraFromBoard)
            pose.translation.z() *= factor; // the same size in the image
        const auto other =
            fitIntrinsics(views, start, {.holdFocal = true, .usualLensPx = options.usualLensPx}, control);
        if (!other)
            continue;
        const double more = other->squares + other->unusualSquares - fit.squares - fit.unusualSquares;
        const double worse = std::max(0.0, more) / (fit.sigmaPx * fit.sigmaPx + 1e-12);
        sigma = std::max(sigma, std::abs(factor - 1) / std::sqrt(worse + 1e-12));
    }
    return sigma;
}

Eigen::AlignedBox2d boxOf(const std::vector<BoardView> &views)
{
    Eigen::AlignedBox2d box;
    for (const BoardView &view : views) {
        for (const Eigen::Vector2d &pixel : view.pixels)
            box.extend(pixel);
    }
    return box;
}

struct OwnFocal
{
    std::size_t view;
    double focalPx;
};

/// The focal length from each image alone, ascending; images that do not determine it are missing. squares:
/// the misfit that remains when each has its own.
std::vector<OwnFocal> ownFocals(const std::vector<BoardView> &views, const LensFit &fit, double &squares)
{
    std::vector<OwnFocal> focals;
    const auto camera = CameraModel::create(fit.intrinsics);
    squares = 0;
    for (std::size_t view = 0; view < views.size(); ++view) {
        const std::vector<PointPair> pairs = pairsOf(views[view]);
        const auto pose = fitPlanePose(pairs, *camera, FocalLength::Free);
        if (!pose || !pose->focalSigmaPx) {
            squares += fit.imageSquares[view];
            continue;
        }
        squares += pose->rmsPx * pose->rmsPx * static_cast<double>(pairs.size());
        focals.push_back({view, pose->camera.intrinsics().fxPx});
    }
    std::ranges::sort(focals, {}, &OwnFocal::focalPx);
    return focals;
}

std::optional<LensFit> fitGroup(const std::vector<BoardView> &views, const LensFit &fit,
                                const std::vector<OwnFocal> &group, const JobControl &control)
{
    std::vector<BoardView> some;
    std::vector<std::size_t> withoutPose;
    for (const OwnFocal &own : group)
        some.push_back(views[own.view]);
    const auto start =
        startLens(some, fit.intrinsics.widthPx, fit.intrinsics.heightPx, fit.intrinsics.model, withoutPose);
    return start && withoutPose.empty() ? fitIntrinsics(some, *start, {}, control) : std::nullopt;
}

} // namespace

Result<void> checkOneCamera(const std::vector<BoardView> &views, const LensFit &fit,
                            const JobControl &control)
{
    double ownSquares = 0;
    const std::vector<OwnFocal> focals = ownFocals(views, fit, ownSquares);
    if (focals.size() < 2 * leastGroup || fit.squares < suspiciousGain * ownSquares)
        return {};
    std::size_t split = leastGroup;
    const auto gap = [&](std::size_t i) { return focals[i].focalPx / focals[i - 1].focalPx; };
    for (std::size_t i = leastGroup; i + leastGroup <= focals.size(); ++i) {
        if (gap(i) > gap(split))
            split = i;
    }
    const auto middle = focals.begin() + static_cast<std::ptrdiff_t>(split);
    const auto lower = fitGroup(views, fit, {focals.begin(), middle}, control);
    const auto upper = fitGroup(views, fit, {middle, focals.end()}, control);
    if (!lower || !upper)
        return {};
    double together = 0;
    for (const OwnFocal &own : focals)
        together += fit.imageSquares[own.view];
    const double one = lower->intrinsics.fxPx, other = upper->intrinsics.fxPx;
    if (together < groupGain * (lower->squares + upper->squares) || std::abs(other / one - 1) < leastZoom)
        return {};
    return refuseCalibration(
        joined(
            {ODO_TEXT("calibration.two_focal_lengths", "the images do not agree on one focal length"),
             ODO_TEXT("calibration.focal_length_groups", "%1 give about %2, %3 (such as %4) give about %5")(
                 split, quantity(one, 0, "px"), focals.size() - split, views[focals[split].view].source,
                 quantity(other, 0, "px"))},
            Join::Colon),
        ODO_TEXT("calibration.use_one_camera", "use images of one camera at one zoom and focus"));
}

Message cannotBeCalibrated()
{
    return ODO_TEXT("calibration.cannot_be_calibrated", "the camera cannot be calibrated");
}

tl::unexpected<Error> refuseCalibration(Message why, Message advice)
{
    return fail(ErrorCode::Undetermined, cannotBeCalibrated(), std::move(why), std::move(advice));
}

MessageArgument percentOf(double part)
{
    return quantity(100 * part, part < 0.01 ? 2 : 1, "%");
}

double boxOfCorners(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    const Eigen::AlignedBox2d box = boxOf(views);
    return box.isEmpty() ? 0 : box.volume() / (static_cast<double>(widthPx) * heightPx);
}

Message positionOfCorners(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    const MessageText *const positions[3][3] = {{&ODO_TEXT("calibration.place_upper_left", "upper left"),
                                                 &ODO_TEXT("calibration.place_upper", "upper"),
                                                 &ODO_TEXT("calibration.place_upper_right", "upper right")},
                                                {&ODO_TEXT("calibration.place_left", "left"),
                                                 &ODO_TEXT("calibration.place_middle", "middle"),
                                                 &ODO_TEXT("calibration.place_right", "right")},
                                                {&ODO_TEXT("calibration.place_lower_left", "lower left"),
                                                 &ODO_TEXT("calibration.place_lower", "lower"),
                                                 &ODO_TEXT("calibration.place_lower_right", "lower right")}};
    const Eigen::AlignedBox2d box = boxOf(views);
    if (box.isEmpty())
        return *positions[1][1];
    const Eigen::Vector2d middle = box.center().cwiseQuotient(Eigen::Vector2d(widthPx, heightPx));
    const auto third = [](double share) { return share < 0.4 ? 0 : share > 0.6 ? 2 : 1; };
    return *positions[third(middle.y())][third(middle.x())];
}

Result<void> checkPositions(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    const double box = boxOfCorners(views, widthPx, heightPx);
    if (box >= leastBox)
        return {};
    return refuseCalibration(
        joined({ODO_TEXT("calibration.board_in_one_place",
                         "all %1 images show the board in one position, the %2 %3 of the image")(
                    views.size(), positionOfCorners(views, widthPx, heightPx), quantity(100 * box, 0, "%")),
                ODO_TEXT("calibration.lens_unknown_elsewhere", "the distortion elsewhere stays unknown")},
               Join::Colon),
        ODO_TEXT("calibration.show_everywhere",
                 "show the board in the middle and near each corner of the image, and closer"));
}

bool isDetermined(const LensFit &fit)
{
    return std::sqrt(fit.intrinsics.covariance(0, 0)) < uncertainFocalSigma * fit.intrinsics.fxPx;
}

Result<double> checkDetermined(const std::vector<BoardView> &views, const LensFit &fit,
                               const LensFitOptions &options, const std::optional<HeldOut> &halves,
                               const JobControl &control)
{
    // One tilt determines the focal length of square pixels about the image's middle.
    if (options.usualLensPx == 0 && largestTurn(fit) < leastTurn)
        return refuseCalibration(ODO_TEXT("calibration.same_attitude",
                                          "all %1 images show the board at nearly the same tilt, too "
                                          "little to determine the focal length")(views.size()),
                                 tiltAdvice());
    const double sigma = focalSigma(views, fit, options, control);
    if (control.isCancelled())
        return cancelled(cannotBeCalibrated());
    if (!(sigma < uncertainFocalSigma))
        return refuseCalibration(
            joined({ODO_TEXT("calibration.focal_length_unsure",
                             "the images determine the focal length only to %1")(percentOf(sigma)),
                    ODO_TEXT("calibration.too_frontal", "the board faces the camera too directly")},
                   Join::Colon),
            tiltAdvice());
    if (halves && halves->focalDifference() > 3 * uncertainFocalSigma)
        return refuseCalibration(ODO_TEXT("calibration.halves_contradict",
                                          "two halves of the images give focal lengths that differ by %1")(
                                     percentOf(halves->focalDifference())),
                                 tiltAdvice());
    return sigma;
}

} // namespace odo
