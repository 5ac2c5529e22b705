// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/planned_registration.h"

#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/intrinsics_influence.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace odo {

using Eigen::Vector2d;
using Eigen::Vector3d;

bool isWithin(const Vector2d &pixel, const Intrinsics &lens)
{
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= lens.widthPx - 0.5 &&
           pixel.y() <= lens.heightPx - 0.5;
}

RigidTransform lookingAt(const Vector3d &position, const Vector2d &aimM, const Vector2d &across)
{
    const Vector3d forward = (Vector3d(aimM.x(), aimM.y(), 0) - position).normalized(),
                   right(across.x(), across.y(), 0);
    Eigen::Matrix3d axes;
    axes << right, forward.cross(right), forward;
    return {Eigen::Quaterniond(axes), position};
}

FloorScore floorScore(std::span<const FloorView> views, const FloorGrid &grid, double sigmaPx, double heightM,
                      double anywhereM)
{
    FloorScore score{0, 0, accuracyMap(views, grid, sigmaPx, heightM).fusedSigmaM};
    for (double &sigma : score.sigmaM) {
        sigma = std::hypot(sigma, anywhereM);
        score.unseen += std::isnan(sigma);
        score.worstM = std::isnan(sigma) ? score.worstM : std::max(score.worstM, sigma);
    }
    return score;
}

tl::unexpected<Error> noPlannedCamera(Message why, Message advice)
{
    return fail(ErrorCode::InvalidInput, ODO_TEXT("calibration.planned_camera", "the planned camera"),
                std::move(why), std::move(advice));
}

Result<FloorView> registeredByMarkers(const FloorView &exact, const MarkerLayout &layout, double sigmaPx)
{
    std::vector<PointPair> pairs;
    std::vector<std::string> seen;
    std::vector<Vector2d> onFloor;
    for (const Marker &marker : layout.markers) {
        const auto pixel = exact.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
        if (!pixel || !isWithin(*pixel, exact.camera().intrinsics()))
            continue;
        pairs.push_back({marker.pointInWorld, *pixel, marker.label});
        seen.push_back(marker.label);
        onFloor.push_back(marker.pointInWorld);
    }
    if (seen.size() < 4)
        return noPlannedCamera(
            ODO_TEXT("calibration.planned_sees_too_few",
                     "it would see only %1 of the layout's markers (%2), four are needed")(
                seen.size(), listed(seen, MessageArgument::Kind::Marker)),
            ODO_TEXT("calibration.move_planned_back", "move it back or up, or choose a wider lens"));
    const auto pose = fitPlanePose(pairs, exact.camera(), FocalLength::Known);
    if (!pose)
        return noPlannedCamera(joined({ODO_TEXT("calibration.planned_not_held",
                                                "the markers it would see do not determine its pose"),
                                       pose.error().why},
                                      Join::Colon),
                               pose.error().advice);
    const Eigen::Matrix<double, 6, 6> covariance = sigmaPx * sigmaPx * pose->inverseNormal;
    return FloorView(exact.camera(), exact.worldFromCamera(), covariance,
                     poseByIntrinsics(exact.camera(), exact.worldFromCamera(), onFloor));
}

} // namespace odo
