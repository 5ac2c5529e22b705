// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsic_calibration.h"

#include "core/base/units.h"
#include "core/calibration/lens_fit.h"
#include "core/calibration/plane_pose.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace odo {

namespace {

constexpr const char *what = "the camera cannot be calibrated";
constexpr std::size_t leastViews = 3, leastViewsForHalves = 6, fewViews = 10;
constexpr double leastTurn = 8;          // degrees between the most different poses of the board
constexpr double worstFocalSigma = 0.03; // of the focal length
constexpr double probe = 1.3; // by how much the focal length is changed to see whether the pictures mind
constexpr double leastCoverage = 0.5; // of the picture
constexpr double standingOut = 3;     // times the median of the pictures' RMS

struct Halves
{
    double rmsPx = 0;
    double focalDifference = 0; ///< relative
};

tl::unexpected<Error> refuse(std::string why, std::string advice)
{
    return fail(ErrorCode::Undetermined, what, std::move(why), std::move(advice));
}

std::string percent(double part)
{
    return formatNumber(100 * part, part < 0.01 ? 2 : 1) + " %";
}

bool isUsable(const BoardView &view)
{
    if (view.pixels.size() < 6 || view.pixels.size() != view.pointsOnBoard.size())
        return false;
    return std::ranges::all_of(view.pixels, [](const auto &p) { return p.allFinite(); }) &&
           std::ranges::all_of(view.pointsOnBoard, [](const auto &p) { return p.allFinite(); });
}

double rmsOf(const LensFit &fit, const std::vector<BoardView> &views)
{
    std::size_t count = 0;
    for (const BoardView &view : views)
        count += view.pixels.size();
    return std::sqrt(fit.squares / static_cast<double>(count));
}

/// The largest angle between the board's normals of any two pictures, degrees.
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
double focalSigma(const std::vector<BoardView> &views, const LensFit &fit, const JobControl &control)
{
    const double curvature = std::sqrt(fit.intrinsics.covariance(0, 0)) / fit.intrinsics.fxPx;
    double sigma = curvature;
    for (double factor : {1 / probe, probe}) {
        LensStart start{fit.intrinsics, fit.cameraFromBoard};
        start.intrinsics.fxPx *= factor;
        start.intrinsics.fyPx *= factor;
        for (RigidTransform &pose : start.cameraFromBoard)
            pose.translation.z() *= factor; // the same size in the picture
        const auto other = fitLens(views, start, true, control);
        if (!other)
            continue;
        const double worse =
            std::max(0.0, other->squares - fit.squares) / (fit.sigmaPx * fit.sigmaPx + 1e-12);
        sigma = std::max(sigma, std::abs(factor - 1) / std::sqrt(worse + 1e-12));
    }
    return sigma;
}

std::optional<LensFit> fitHalf(const std::vector<BoardView> &half, const LensFit &all,
                               const JobControl &control)
{
    std::vector<std::size_t> withoutPose;
    const auto start =
        startLens(half, all.intrinsics.widthPx, all.intrinsics.heightPx, all.intrinsics.model, withoutPose);
    if (!start || !withoutPose.empty())
        return std::nullopt;
    return fitLens(half, *start, false, control);
}

/// Each half of the pictures under the lens that the other half gives: only the poses may adapt.
Halves crossValidate(const std::vector<BoardView> &views, const LensFit &all, const JobControl &control)
{
    if (views.size() < leastViewsForHalves)
        return {};
    std::vector<BoardView> halves[2];
    for (std::size_t i = 0; i < views.size(); ++i)
        halves[i % 2].push_back(views[i]);
    const std::optional<LensFit> fits[] = {fitHalf(halves[0], all, control),
                                           fitHalf(halves[1], all, control)};
    if (!fits[0] || !fits[1])
        return {};
    double squares = 0, count = 0;
    for (std::size_t half = 0; half < 2; ++half) {
        const auto camera = CameraModel::create(fits[1 - half]->intrinsics);
        for (const BoardView &view : halves[half]) {
            std::vector<PointPair> pairs;
            for (std::size_t i = 0; i < view.pixels.size(); ++i)
                pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
            const auto pose = fitPlanePose(pairs, *camera, FocalLength::Known);
            if (!pose)
                continue;
            squares += pose->rmsPx * pose->rmsPx * static_cast<double>(pairs.size());
            count += static_cast<double>(pairs.size());
        }
    }
    const double one = fits[0]->intrinsics.fxPx, other = fits[1]->intrinsics.fxPx;
    return {count > 0 ? std::sqrt(squares / count) : 0, std::abs(one - other) / (0.5 * (one + other))};
}

/// The part of the picture, in 8 × 6 fields, in which a corner was seen.
double coverage(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    constexpr int across = 8, down = 6;
    std::set<int> fields;
    for (const BoardView &view : views) {
        for (const Eigen::Vector2d &pixel : view.pixels) {
            const int x = std::clamp(static_cast<int>(pixel.x() * across / widthPx), 0, across - 1);
            const int y = std::clamp(static_cast<int>(pixel.y() * down / heightPx), 0, down - 1);
            fields.insert(y * across + x);
        }
    }
    return static_cast<double>(fields.size()) / (across * down);
}

/// The picture whose misfit stands out from the others, if one does.
std::string oddPicture(const IntrinsicCalibration &calibration)
{
    std::vector<double> rms;
    for (const auto &picture : calibration.pictureRmsPx)
        rms.push_back(picture.second);
    std::ranges::sort(rms);
    const auto worst =
        std::ranges::max_element(calibration.pictureRmsPx, {}, &std::pair<std::string, double>::second);
    if (worst->second <= standingOut * rms[rms.size() / 2])
        return "";
    return " Look at " + worst->first + ": its " + formatNumber(worst->second, 2) + " px stand out.";
}

std::string verdictOf(const IntrinsicCalibration &calibration, const std::vector<BoardView> &views,
                      double sigma)
{
    const Intrinsics &in = calibration.intrinsics;
    const double covered = coverage(views, in.widthPx, in.heightPx);
    const bool good =
        sigma < 0.005 && calibration.rmsPx < 1 && views.size() >= fewViews && covered >= leastCoverage;
    const bool usable = sigma < 0.015 && calibration.rmsPx < 2;
    std::string verdict = good ? "Good: " : usable ? "Usable: " : "Poor: ";
    verdict += std::to_string(views.size()) + " pictures fit to " + formatNumber(calibration.rmsPx, 2) +
               " px, focal length " + formatNumber(in.fxPx, 1) + " px ± " + percent(sigma);
    if (calibration.crossValidationPx > 0)
        verdict += "; each half of them foretells the other to " +
                   formatNumber(calibration.crossValidationPx, 2) + " px";
    verdict += ".";
    if (views.size() < fewViews)
        verdict += " More pictures (" + std::to_string(fewViews) + " or more) would make it surer.";
    if (covered < leastCoverage)
        verdict += " Only " + formatNumber(100 * covered, 0) +
                   " % of the picture was covered: show the board near its edges too.";
    return verdict + oddPicture(calibration);
}

Result<double> checkDetermined(const std::vector<BoardView> &views, const LensFit &fit, const Halves &halves,
                               const JobControl &control)
{
    const std::string all = "all " + std::to_string(views.size()) + " pictures";
    const std::string advice = "take pictures with the board tilted by 30 to 45 degrees, to each side";
    if (largestTurn(fit) < leastTurn)
        return refuse(
            all + " show the board in nearly the same attitude, which does not determine the focal length",
            advice);
    const double sigma = focalSigma(views, fit, control);
    if (control.isCancelled())
        return cancelled(what);
    if (!(sigma < worstFocalSigma))
        return refuse("the pictures determine the focal length only to " + percent(sigma) +
                          ": the board is seen too nearly frontal",
                      advice);
    if (halves.focalDifference > 3 * worstFocalSigma)
        return refuse("two halves of the pictures give focal lengths that differ by " +
                          percent(halves.focalDifference),
                      advice);
    return sigma;
}

/// The views that can be used; the others are told with a reason.
std::vector<BoardView> usableViews(const std::vector<BoardView> &views,
                                   std::vector<RejectedPicture> &rejected)
{
    std::vector<BoardView> usable;
    for (const BoardView &view : views) {
        if (isUsable(view))
            usable.push_back(view);
        else
            rejected.push_back({view.source, "fewer than six corners, or one that is not a number"});
    }
    return usable;
}

} // namespace

Result<IntrinsicCalibration> calibrateIntrinsics(const std::vector<BoardView> &views, int widthPx,
                                                 int heightPx, LensModel model, const JobControl &control)
{
    if (widthPx <= 0 || heightPx <= 0)
        return fail(ErrorCode::InvalidInput, what, "the picture has no size", "use pictures of the camera");
    IntrinsicCalibration calibration;
    std::vector<BoardView> used = usableViews(views, calibration.rejected);
    std::vector<std::size_t> withoutPose;
    const auto start = startLens(used, widthPx, heightPx, model, withoutPose);
    for (auto index = withoutPose.rbegin(); index != withoutPose.rend(); ++index) {
        calibration.rejected.push_back({used[*index].source, "the corners do not lie as on a flat board"});
        used.erase(used.begin() + static_cast<std::ptrdiff_t>(*index));
    }
    if (used.size() < leastViews || !start)
        return refuse("three pictures of the board are needed, " + std::to_string(used.size()) +
                          " can be used",
                      "take ten or more, the board tilted differently in each");
    control.report(0.1, "fitting the lens to " + std::to_string(used.size()) + " pictures");
    const auto fit = fitLens(used, *start, false, control);
    if (control.isCancelled())
        return cancelled(what);
    if (!fit)
        return refuse("no lens fits these pictures",
                      "check that all are of one camera, at one zoom and focus");
    control.report(0.5, "checking halves against one another");
    const Halves halves = crossValidate(used, *fit, control);
    if (control.isCancelled())
        return cancelled(what);
    const auto sigma = checkDetermined(used, *fit, halves, control);
    if (!sigma)
        return tl::unexpected(sigma.error());

    calibration.intrinsics = fit->intrinsics;
    calibration.rmsPx = rmsOf(*fit, used);
    calibration.crossValidationPx = halves.rmsPx;
    for (std::size_t i = 0; i < used.size(); ++i)
        calibration.pictureRmsPx.emplace_back(
            used[i].source, std::sqrt(fit->pictureSquares[i] / static_cast<double>(used[i].pixels.size())));
    calibration.verdict = verdictOf(calibration, used, *sigma);
    control.report(1, "done");
    return calibration;
}

} // namespace odo
