// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/lens_fit.h"
#include "core/calibration/plane_pose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t viewsForFocal = 8;

std::vector<PointPair> pairsOf(const BoardView &view)
{
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < view.pixels.size(); ++i)
        pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
    return pairs;
}

CameraModel cameraOf(int widthPx, int heightPx, LensModel model, double focalPx)
{
    Intrinsics intrinsics = CameraModel::assumed(widthPx, heightPx).intrinsics();
    intrinsics.fxPx = intrinsics.fyPx = focalPx;
    intrinsics.model = model;
    return CameraModel::create(intrinsics).value_or(CameraModel::assumed(widthPx, heightPx));
}

/// Zhang 2000, equations 3 and 4, over all views, with the principal point in the middle and one focal
/// length.
std::optional<double> closedFormFocal(const std::vector<BoardView> &views, int widthPx, int heightPx)
{
    const Vector2d middle(0.5 * (widthPx - 1), 0.5 * (heightPx - 1));
    const double side = std::max(widthPx, heightPx);
    double products = 0, squares = 0;
    for (const BoardView &view : views) {
        std::vector<PointPair> pairs = pairsOf(view);
        for (PointPair &pair : pairs)
            pair.target = (pair.target - middle) / side;
        const auto homography = Homography::estimate(pairs);
        if (!homography)
            continue;
        const double length = homography->matrix().leftCols<2>().norm();
        const Vector3d a = homography->matrix().col(0) / length, b = homography->matrix().col(1) / length;
        const Vector2d factors(a.head<2>().dot(b.head<2>()),
                               a.head<2>().squaredNorm() - b.head<2>().squaredNorm());
        const Vector2d constants(a.z() * b.z(), a.z() * a.z() - b.z() * b.z());
        products -= factors.dot(constants);
        squares += factors.squaredNorm();
    }
    const double inverseSquare = products / squares;
    if (!(inverseSquare > 0) || !std::isfinite(inverseSquare))
        return std::nullopt;
    return side / std::sqrt(inverseSquare);
}

/// A start with one focal length, and how badly its plane poses fit.
struct Trial
{
    LensStart start;
    std::vector<std::size_t> withoutPose;
    double badness = std::numeric_limits<double>::infinity();
};

/// Poses of every step-th view.
Trial tried(const std::vector<BoardView> &views, const CameraModel &camera, std::size_t step)
{
    Trial trial{{camera.intrinsics(), {}}, {}, {}};
    double squares = 0;
    for (std::size_t i = 0; i < views.size(); i += step) {
        const auto pose = fitPlanePose(pairsOf(views[i]), camera, FocalLength::Known);
        if (!pose) {
            trial.withoutPose.push_back(i);
            continue;
        }
        trial.start.cameraFromBoard.push_back(pose->worldFromCamera.inverse());
        squares += pose->rmsPx * pose->rmsPx;
    }
    // Fewer lost pictures first, then the better fit.
    const double side = std::max(camera.intrinsics().widthPx, camera.intrinsics().heightPx);
    if (!trial.start.cameraFromBoard.empty())
        trial.badness = squares / static_cast<double>(trial.start.cameraFromBoard.size()) +
                        side * side * static_cast<double>(trial.withoutPose.size());
    return trial;
}

} // namespace

std::optional<LensStart> startLens(const std::vector<BoardView> &views, int widthPx, int heightPx,
                                   LensModel model, std::vector<std::size_t> &withoutPose)
{
    const double side = std::max(widthPx, heightPx);
    std::vector<double> focals{0.35 * side, 0.6 * side, 1.0 * side, 1.7 * side, 3.0 * side};
    if (const auto closed = closedFormFocal(views, widthPx, heightPx))
        focals.push_back(std::clamp(*closed, 0.2 * side, 20 * side));
    const auto bestOf = [&](std::size_t step) {
        Trial best;
        for (const double focal : focals) {
            Trial trial = tried(views, cameraOf(widthPx, heightPx, model, focal), step);
            if (trial.badness < best.badness)
                best = std::move(trial);
        }
        return best;
    };
    // Some of the views tell the focal length; only where others then lack a pose all of them are asked.
    const std::size_t step = std::max<std::size_t>(1, views.size() / viewsForFocal);
    Trial start = bestOf(step);
    if (step > 1 && std::isfinite(start.badness))
        start = tried(views, cameraOf(widthPx, heightPx, model, start.start.intrinsics.fxPx), 1);
    if (step > 1 && !start.withoutPose.empty())
        start = bestOf(1);
    withoutPose = std::move(start.withoutPose);
    if (!std::isfinite(start.badness))
        return std::nullopt;
    return std::move(start.start);
}

} // namespace odo
