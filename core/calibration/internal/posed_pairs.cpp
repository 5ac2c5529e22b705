// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/posed_pairs.h"

#include "core/base/percentile.h"
#include "core/calibration/internal/outlier_corners.h"
#include "core/calibration/internal/pair_verdict.h"
#include "core/calibration/internal/plane_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double samePixelPx = 1e-3;

/// The pose of a board by one camera alone, its outlier corners hardly heeded.
std::optional<PlanePose> robustPose(const BoardView &view, const CameraModel &camera)
{
    const std::vector<PointPair> pairs = pairsOf(view);
    auto pose = fitPlanePose(pairs, camera, FocalLength::Known);
    for (int round = 0; pose && round < 5; ++round) {
        std::vector<double> distances;
        const RigidTransform cameraFromBoard = pose->worldFromCamera.inverse();
        for (const PointPair &pair : pairs) {
            const auto pixel =
                camera.project(cameraFromBoard * Vector3d(pair.source.x(), pair.source.y(), 0));
            distances.push_back(pixel ? (*pixel - pair.target).norm() : 0);
        }
        const double scale = std::max(1e-6, 2 * upperMedian(distances) / medianOfRayleigh);
        std::vector<Eigen::Matrix2d> weights;
        for (const double distance : distances)
            weights.emplace_back(Eigen::Matrix2d::Identity() / std::hypot(1.0, distance / scale));
        pose = fitPlanePose(pairs, camera, FocalLength::Known, weights);
    }
    return pose ? std::optional(std::move(*pose)) : std::nullopt;
}

std::vector<Vector2d> residualsOf(const BoardView &view, const CameraModel &camera,
                                  const RigidTransform &cameraFromBoard)
{
    std::vector<Vector2d> residuals;
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        const Vector2d &point = view.pointsOnBoard[i];
        const auto pixel = camera.project(cameraFromBoard * Vector3d(point.x(), point.y(), 0));
        residuals.push_back(pixel ? Vector2d(view.pixels[i] - *pixel) : Vector2d(1e6, 1e6));
    }
    return residuals;
}

/// All views of one camera, posed by it alone with its lens held, as a fit of that lens would give them.
LensFit heldFit(const std::vector<BoardView> &views, const CameraModel &camera,
                const std::vector<RigidTransform> &cameraFromBoard)
{
    LensFit fit;
    fit.intrinsics = camera.intrinsics();
    fit.cameraFromBoard = cameraFromBoard;
    for (std::size_t i = 0; i < views.size(); ++i) {
        fit.residualsPx.push_back(residualsOf(views[i], camera, cameraFromBoard[i]));
        fit.imageSquares.push_back(0);
        for (const Vector2d &residual : fit.residualsPx.back())
            fit.imageSquares.back() += residual.squaredNorm();
        fit.squares += fit.imageSquares.back();
    }
    return fit;
}

bool areOneImage(const BoardView &a, const BoardView &b)
{
    return a.pixels.size() == b.pixels.size() &&
           std::ranges::equal(a.pixels, b.pixels, [](const Vector2d &one, const Vector2d &other) {
               return (one - other).norm() < samePixelPx;
           });
}

void addPosed(const BoardPair &pair, const CameraModel &a, const CameraModel &b,
              std::vector<PosedPair> &posed, std::vector<RejectedPair> &rejected)
{
    const auto reject = [&](Message reason) {
        rejected.push_back({pair.a.source, pair.b.source, std::move(reason)});
    };
    for (const BoardView *view : {&pair.a, &pair.b})
        if (view->pixels.size() < leastCornersOfView)
            return reject(ODO_TEXT("calibration.pair_lacks_board",
                                   "the board was not found in '%1'")(Named::file(view->source)));
    if (areOneImage(pair.a, pair.b))
        return reject(ODO_TEXT("calibration.pair_is_one_image", "both are the same image"));
    const auto poseA = robustPose(pair.a, a), poseB = robustPose(pair.b, b);
    if (!poseA || !poseB)
        return reject(ODO_TEXT("calibration.pair_without_pose", "the corners in '%1' determine no pose")(
            Named::file(poseA ? pair.b.source : pair.a.source)));
    posed.push_back({{pair.a, pair.b}, poseA->worldFromCamera.inverse(), poseB->worldFromCamera.inverse()});
}

/// Leaves misread corners out, and measures what each image leaves alone.
PosedPairs withSoundCorners(std::vector<PosedPair> pairs, const CameraModel &a, const CameraModel &b)
{
    PosedPairs posed;
    double freedom = 0, freeSquares = 0;
    posed.leftOut.assign(pairs.size(), 0);
    posed.squares.assign(pairs.size(), 0);
    for (const bool isB : {false, true}) {
        const CameraModel &camera = isB ? b : a;
        std::vector<BoardView> views;
        std::vector<RigidTransform> poses;
        for (const PosedPair &pair : pairs) {
            views.push_back(isB ? pair.boards.b : pair.boards.a);
            poses.push_back(isB ? pair.bFromBoard : pair.aFromBoard);
        }
        const LensFit fit = heldFit(views, camera, poses);
        const CornerMarks misread =
            misreadCorners(views, fit, cornersBeyond(fit, outlierLimitPx(medianSigmaPx(fit))));
        const std::vector<BoardView> sound = withoutCorners(views, misread);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            posed.leftOut[i] += misread[i].size();
            RigidTransform &pose = isB ? pairs[i].bFromBoard : pairs[i].aFromBoard;
            if (const auto again =
                    refinePlanePose(pairsOf(sound[i]), camera, FocalLength::Known, pose.inverse()))
                pose = again->worldFromCamera.inverse();
            for (const Vector2d &residual : residualsOf(sound[i], camera, pose))
                posed.squares[i] += residual.squaredNorm();
            freedom += 2.0 * double(sound[i].pixels.size()) - 6;
            (isB ? pairs[i].boards.b : pairs[i].boards.a) = sound[i];
        }
    }
    for (const double squares : posed.squares)
        freeSquares += squares;
    posed.sigmaPx = std::sqrt(freeSquares / std::max(1.0, freedom));
    posed.pairs = std::move(pairs);
    return posed;
}

/// RMS of single poses, of all views of a camera by a lens; infinite where one has none.
double loneRmsPx(const std::vector<PosedPair> &pairs, bool ofB, const CameraModel &lens)
{
    double squares = 0, count = 0;
    for (const PosedPair &pair : pairs) {
        const BoardView &view = ofB ? pair.boards.b : pair.boards.a;
        const auto pose = fitPlanePose(pairsOf(view), lens, FocalLength::Known);
        if (!pose)
            return std::numeric_limits<double>::infinity();
        squares += pose->rmsPx * pose->rmsPx * double(view.pixels.size());
        count += double(view.pixels.size());
    }
    return std::sqrt(squares / std::max(1.0, count));
}

/// Refuses images that each fit the other camera's lens better.
Result<void> checkNotSwapped(const std::vector<PosedPair> &pairs, const CameraModel &a, const CameraModel &b)
{
    constexpr double clearly = 0.6, leastPx = 0.5;
    const double own = std::max(loneRmsPx(pairs, false, a), loneRmsPx(pairs, true, b));
    const double other = std::max(loneRmsPx(pairs, false, b), loneRmsPx(pairs, true, a));
    if (own > leastPx && other < clearly * own)
        return refusePair(ODO_TEXT("calibration.pair_swapped",
                                   "the images of each camera fit the lens calibration of the other one (%1 "
                                   "instead of %2 RMS)")(quantity(other, 2, "px"), quantity(own, 2, "px")),
                          ODO_TEXT("calibration.swap_pair", "swap the images of the two cameras"),
                          ErrorCode::InvalidInput);
    return {};
}

} // namespace

Result<PosedPairs> posedPairs(const std::vector<BoardPair> &pairs, const CameraModel &a, const CameraModel &b,
                              std::vector<RejectedPair> &rejected, const JobControl &control)
{
    std::vector<PosedPair> posed;
    for (const BoardPair &pair : pairs) {
        if (control.isCancelled())
            return cancelled(relationOfCameras());
        addPosed(pair, a, b, posed, rejected);
    }
    if (posed.empty())
        return refusePair(noPairHasBoard(pairs.size(), rejected), showBoardToBoth());
    ODO_TRY(checkNotSwapped(posed, a, b));
    return withSoundCorners(std::move(posed), a, b);
}

} // namespace odo
