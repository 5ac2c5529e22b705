// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/world_axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

using Eigen::Vector2d;

tl::unexpected<Error> refuse(const MarkerLayout &layout, Message why, Message advice)
{
    return fail(ErrorCode::InvalidInput,
                ODO_TEXT("calibration.axes_not_changed",
                         "the axes of layout '%1' cannot be changed")(Named::layout(layout.name)),
                std::move(why), std::move(advice));
}

Message giveOneOfThem()
{
    return ODO_TEXT("calibration.give_one_of_them", "give one of them");
}

Result<Vector2d> positionOf(const MarkerLayout &layout, const std::string &label)
{
    const auto marker = std::ranges::find(layout.markers, label, &Marker::label);
    if (marker != layout.markers.end())
        return marker->pointInWorld;
    std::vector<std::string> labels;
    for (const Marker &each : layout.markers)
        labels.push_back(each.label);
    return refuse(layout, ODO_TEXT("calibration.no_such_marker", "it has no marker %1")(Named::marker(label)),
                  ODO_TEXT("calibration.name_one_marker",
                           "name one of %1")(listed(labels, MessageArgument::Kind::Marker)));
}

Result<double> turnOf(const MarkerLayout &layout, const AxesChange &change)
{
    if (!change.xAlong)
        return -change.turnDegrees * EIGEN_PI / 180;
    if (change.turnDegrees != 0)
        return refuse(
            layout,
            ODO_TEXT("calibration.two_directions", "both an angle and a pair of markers were given for X"),
            giveOneOfThem());
    const Vector2d from = ODO_TRY(positionOf(layout, change.xAlong->first)),
                   to = ODO_TRY(positionOf(layout, change.xAlong->second));
    const Vector2d along = to - from;
    if (!(along.norm() > 0))
        return refuse(
            layout,
            ODO_TEXT("calibration.x_without_length", "the two markers for the X axis have the same position"),
            ODO_TEXT("calibration.name_two_apart", "name two at different positions"));
    return -std::atan2(along.y(), along.x());
}

Result<Vector2d> originOf(const MarkerLayout &layout, const AxesChange &change)
{
    if (change.originMarker.empty())
        return change.originM.value_or(Vector2d::Zero());
    if (change.originM)
        return refuse(
            layout,
            ODO_TEXT("calibration.two_origins", "both a marker and a point were given for the origin"),
            giveOneOfThem());
    const auto position = positionOf(layout, change.originMarker);
    return position ? Result<Vector2d>(change.lengthFactor * *position) : position;
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
    return fail(ErrorCode::InvalidInput, ODO_TEXT("calibration.unit", "unit '%1'")(unit),
                ODO_TEXT("calibration.unit_unknown", "it is not known"),
                ODO_TEXT("calibration.use_known_unit", "use mm, cm, m or inch"));
}

Result<AxesTransform> axesTransformOf(const MarkerLayout &layout, const AxesChange &change)
{
    if (!(change.lengthFactor > 0) || !std::isfinite(change.lengthFactor))
        return refuse(layout,
                      ODO_TEXT("calibration.length_factor",
                               "a length factor of %1 is not possible")(quantity(change.lengthFactor, 3)),
                      ODO_TEXT("calibration.give_positive_number", "give a number above 0"));
    if (change.reverseX != change.reverseY)
        return refuse(
            layout,
            change.reverseX
                ? ODO_TEXT("calibration.reversed_x_alone",
                           "reversing X alone would mirror the floor; no camera above it sees it that way")
                : ODO_TEXT("calibration.reversed_y_alone",
                           "reversing Y alone would mirror the floor; no camera above it sees it that way"),
            joined({ODO_TEXT("calibration.reverse_both", "reverse both (a half turn), or turn the axes"),
                    ODO_TEXT("calibration.layout_written_mirrored",
                             "if the layout was written down mirrored, correct its signs and add it again")},
                   Join::Semicolon));
    const auto origin = ODO_TRY(originOf(layout, change));
    const auto turn = ODO_TRY(turnOf(layout, change));
    if (!origin.allFinite() || !std::isfinite(turn))
        return refuse(
            layout, ODO_TEXT("calibration.axes_no_number", "the origin or the angle is not a finite number"),
            ODO_TEXT("calibration.give_plain_numbers", "give plain numbers"));
    AxesTransform transform{change.lengthFactor, turn + (change.reverseX ? std::numbers::pi : 0.0),
                            Vector2d::Zero()};
    transform.shiftM = -(Eigen::Rotation2Dd(transform.turnRad) * origin);
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
    result.verdict =
        joined({std::move(result.verdict),
                newFromOld.scale == 1
                    ? ODO_TEXT("calibration.axes_changed", "The world axes were changed afterwards.")
                    : ODO_TEXT("calibration.axes_changed_and_scaled",
                               "The world axes were changed afterwards, and all lengths multiplied by %1.")(
                          quantity(newFromOld.scale, 4))},
               Join::Space);
    return result;
}

} // namespace odo
