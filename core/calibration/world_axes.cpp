// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/world_axes.h"

#include "core/base/units.h"
#include "core/calibration/internal/wording.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

using Eigen::Vector2d;

tl::unexpected<Error> refuse(const MarkerLayout &layout, std::string why, std::string advice)
{
    return fail(ErrorCode::InvalidInput, "the axes of layout '" + layout.name + "' cannot be changed",
                std::move(why), std::move(advice));
}

Result<Vector2d> placeOf(const MarkerLayout &layout, const std::string &label)
{
    const auto marker = std::ranges::find(layout.markers, label, &Marker::label);
    if (marker != layout.markers.end())
        return marker->pointInWorld;
    std::vector<std::string> labels;
    for (const Marker &each : layout.markers)
        labels.push_back(each.label);
    return refuse(layout, "it has no marker " + label, "name one of " + listed(labels));
}

Result<double> turnOf(const MarkerLayout &layout, const AxesChange &change)
{
    if (!change.xAlong)
        return -change.turnDegrees * EIGEN_PI / 180;
    if (change.turnDegrees != 0)
        return refuse(layout, "both an angle and a pair of markers were given for X", "give one of them");
    const auto from = placeOf(layout, change.xAlong->first), to = placeOf(layout, change.xAlong->second);
    if (!from)
        return tl::unexpected(from.error());
    if (!to)
        return tl::unexpected(to.error());
    const Vector2d along = *to - *from;
    if (!(along.norm() > 0))
        return refuse(layout, "the markers that X is to run along lie at one place",
                      "name two that lie apart");
    return -std::atan2(along.y(), along.x());
}

Result<Vector2d> originOf(const MarkerLayout &layout, const AxesChange &change)
{
    if (change.originMarker.empty())
        return change.originM.value_or(Vector2d::Zero());
    if (change.originM)
        return refuse(layout, "both a marker and a point were given for the origin", "give one of them");
    const auto place = placeOf(layout, change.originMarker);
    return place ? Result<Vector2d>(change.lengthFactor * *place) : place;
}

} // namespace

Vector2d AxesTransform::operator*(const Vector2d &pointInOldWorld) const
{
    return Eigen::Rotation2Dd(turnRad) * (scale * pointInOldWorld) + shiftM;
}

Result<double> lengthFactorFrom(const std::string &unit)
{
    if (unit == "mm")
        return 1;
    if (unit == "cm")
        return 10;
    if (unit == "m")
        return 1000;
    if (unit == "inch")
        return 25.4;
    return fail(ErrorCode::InvalidInput, "unit '" + unit + "'", "it is not known", "use mm, cm, m or inch");
}

Result<AxesTransform> axesTransformOf(const MarkerLayout &layout, const AxesChange &change)
{
    if (!(change.lengthFactor > 0) || !std::isfinite(change.lengthFactor))
        return refuse(layout,
                      "a length factor of " + formatNumber(change.lengthFactor, 3) + " makes no floor",
                      "give a number above 0");
    if (change.reverseX != change.reverseY)
        return refuse(
            layout,
            std::string("reversing ") + (change.reverseX ? "X" : "Y") +
                " alone would mirror the floor, and no camera above it sees it so",
            "reverse both (a half turn), or turn the axes; if the layout was written down mirrored, "
            "correct its signs and add it anew");
    const auto origin = originOf(layout, change);
    if (!origin)
        return tl::unexpected(origin.error());
    const auto turn = turnOf(layout, change);
    if (!turn)
        return tl::unexpected(turn.error());
    if (!origin->allFinite() || !std::isfinite(*turn))
        return refuse(layout, "the origin or the angle is not a finite number", "give plain numbers");
    AxesTransform transform{change.lengthFactor, *turn + (change.reverseX ? std::numbers::pi : 0.0),
                            Vector2d::Zero()};
    transform.shiftM = -(Eigen::Rotation2Dd(transform.turnRad) * *origin);
    return transform;
}

MarkerLayout transformed(const MarkerLayout &layout, const AxesTransform &newFromOld)
{
    MarkerLayout result = layout;
    for (Marker &marker : result.markers)
        marker.pointInWorld = newFromOld * marker.pointInWorld;
    return result;
}

FloorRegistration transformed(const FloorRegistration &registration, const AxesTransform &newFromOld)
{
    FloorRegistration result = registration;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(newFromOld.turnRad, Eigen::Vector3d::UnitZ()));
    const Eigen::Vector3d shift(newFromOld.shiftM.x(), newFromOld.shiftM.y(), 0);
    result.worldFromCamera.rotation = (turn * registration.worldFromCamera.rotation).normalized();
    result.worldFromCamera.translation =
        newFromOld.scale * (turn * registration.worldFromCamera.translation) + shift;
    // The rotation vector is one of the world frame, so it turns with it.
    Eigen::Matrix<double, 6, 6> byOld = Eigen::Matrix<double, 6, 6>::Zero();
    byOld.topLeftCorner<3, 3>() = turn.toRotationMatrix();
    byOld.bottomRightCorner<3, 3>() = newFromOld.scale * turn.toRotationMatrix();
    result.poseCovariance = byOld * registration.poseCovariance * byOld.transpose();
    result.rmsM *= newFromOld.scale;
    result.floorSigmaM *= newFromOld.scale;
    for (MarkerError &marker : result.markers)
        marker.errorM *= newFromOld.scale;
    result.verdict += " The world axes were changed afterwards";
    if (newFromOld.scale != 1)
        result.verdict += ", and all lengths multiplied by " + formatNumber(newFromOld.scale, 4);
    result.verdict += ".";
    return result;
}

} // namespace odo
