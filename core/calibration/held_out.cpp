// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/held_out.h"

#include "core/calibration/plane_pose.h"

#include <cmath>
#include <limits>

namespace odo {

namespace {

std::optional<LensFit> fitHalf(const std::vector<BoardView> &views, const LensFit &all, std::size_t half,
                               const JobControl &control)
{
    std::vector<BoardView> some;
    LensStart start{all.intrinsics, {}};
    for (std::size_t i = half; i < views.size(); i += 2) {
        some.push_back(views[i]);
        start.cameraFromBoard.push_back(all.cameraFromBoard[i]);
    }
    return fitLens(some, start, {}, control);
}

/// Mean of the squared distances of a view's corners under a lens, the pose adapted; infinite where there is
/// no pose.
double meanSquares(const BoardView &view, const CameraModel &camera, const RigidTransform &cameraFromBoard)
{
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < view.pixels.size(); ++i)
        pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
    if (const auto near = refinePlanePose(pairs, camera, FocalLength::Known, cameraFromBoard.inverse()))
        return near->rmsPx * near->rmsPx;
    const auto pose = fitPlanePose(pairs, camera, FocalLength::Known);
    return pose ? pose->rmsPx * pose->rmsPx : std::numeric_limits<double>::infinity();
}

} // namespace

double HeldOut::focalDifference() const
{
    return std::abs(lenses[0].fxPx - lenses[1].fxPx) / (0.5 * (lenses[0].fxPx + lenses[1].fxPx));
}

std::optional<HeldOut> holdOut(const std::vector<BoardView> &views, const LensFit &all,
                               const JobControl &control)
{
    if (views.size() < leastViewsForHalves)
        return std::nullopt;
    HeldOut heldOut;
    for (std::size_t half = 0; half < 2; ++half) {
        auto fit = fitHalf(views, all, half, control);
        if (!fit)
            return std::nullopt;
        heldOut.lenses[half] = std::move(fit->intrinsics);
    }
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (control.isCancelled())
            return std::nullopt;
        const auto camera = CameraModel::create(heldOut.lenses[1 - i % 2]);
        heldOut.pictureMeanSquares.push_back(meanSquares(views[i], *camera, all.cameraFromBoard[i]));
        if (!std::isfinite(heldOut.pictureMeanSquares.back())) {
            ++heldOut.unforetold;
            continue;
        }
        const auto corners = static_cast<double>(views[i].pixels.size());
        squares += heldOut.pictureMeanSquares.back() * corners;
        count += corners;
    }
    heldOut.rmsPx = count > 0 ? std::sqrt(squares / count) : 0;
    return heldOut;
}

} // namespace odo
