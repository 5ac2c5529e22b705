// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/chained_registration.h"

#include "core/base/units.h"
#include "core/calibration/internal/marker_pairs.h"
#include "core/calibration/internal/plane_pose.h"
#include "core/calibration/internal/pose_step.h"
#include "core/calibration/internal/registration_words.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/homography.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double pixelSigma = 0.3;         // of a point picked or detected in an image
constexpr double nearestPointPixels = 1.0; // points closer than that are one and the same
constexpr double worstPointSigma = 0.05;   // of the points' extent on the floor

Message notRegisteredVia()
{
    return ODO_TEXT("calibration.not_registered_through",
                    "the camera cannot be registered via another camera");
}

tl::unexpected<Error> refuseReference(Message why, Message advice)
{
    return fail(ErrorCode::Undetermined, notRegisteredVia(), std::move(why), std::move(advice));
}

std::string imageSizePx(const CameraModel &camera)
{
    return sizeText(camera.intrinsics().widthPx, camera.intrinsics().heightPx);
}

Result<void> checkInImage(const SharedPoint &point, const Vector2d &pixel, const CameraModel &camera,
                          const Message &isOutside)
{
    const Intrinsics &lens = camera.intrinsics();
    if (!pixel.allFinite())
        return refuseReference(
            ODO_TEXT("calibration.point_pixel_no_number",
                     "the pixel of point %1 is not a finite number")(Named::marker(point.label)),
            correctPixels());
    if (pixel.x() < -1 || pixel.y() < -1 || pixel.x() > lens.widthPx || pixel.y() > lens.heightPx)
        return refuseReference(
            isOutside, ODO_TEXT("calibration.check_columns", "check which columns belong to which camera"));
    return {};
}

Result<void> checkPoints(const FloorView &reference, const Message &referenceName,
                         const std::vector<SharedPoint> &points, const CameraModel &camera)
{
    if (points.size() < 4)
        return refuseReference(
            joined({ODO_TEXT("calibration.four_shared_points",
                             "both cameras must see the same four points or more"),
                    ODO_TEXT("calibration.shared_points", "%1 given")(points.size())},
                   Join::Semicolon),
            ODO_TEXT("calibration.add_floor_points", "add floor points, such as corners of tiles"));
    std::set<std::string> labels;
    for (const SharedPoint &point : points) {
        const MessageArgument label = Named::marker(point.label);
        if (!labels.insert(point.label).second)
            return refuseReference(ODO_TEXT("calibration.point_twice", "point %1 appears twice")(label),
                                   labelEachPoint());
        ODO_TRY(checkInImage(point, point.pixel, camera,
                             ODO_TEXT("calibration.point_outside_own",
                                      "point %1 is outside the image of the camera to register (%2)")(
                                 label, imageSizePx(camera))));
        ODO_TRY(checkInImage(
            point, point.referencePixel, reference.camera(),
            ODO_TEXT("calibration.point_outside_through", "point %1 is outside the image of %2 (%3)")(
                label, referenceName, imageSizePx(reference.camera()))));
        for (const SharedPoint &other : points) {
            if (&other == &point)
                break;
            if ((other.pixel - point.pixel).norm() < nearestPointPixels ||
                (other.referencePixel - point.referencePixel).norm() < nearestPointPixels)
                return refuseReference(
                    ODO_TEXT("calibration.points_on_one_pixel",
                             "points %1 and %2 are on the same pixel")(Named::marker(other.label), label),
                    markWhereSeen());
        }
    }
    return {};
}

/// The points' floor positions by the other camera, and their pixels; nullopt if one has none.
std::optional<std::vector<PointPair>> laid(const FloorView &reference, const std::vector<SharedPoint> &points)
{
    std::vector<PointPair> pairs;
    for (const SharedPoint &point : points) {
        const auto position = reference.floorFromPixel(point.referencePixel, 0);
        if (!position)
            return std::nullopt;
        pairs.push_back({*position, point.pixel, point.label});
    }
    return pairs;
}

Result<void> checkHorizon(const FloorView &reference, const Message &referenceName,
                          const std::vector<SharedPoint> &points)
{
    for (const SharedPoint &point : points) {
        if (!reference.floorFromPixel(point.referencePixel, 0))
            return refuseReference(
                ODO_TEXT("calibration.point_beyond_through", "point %1 is at or beyond the horizon of %2")(
                    Named::marker(point.label), referenceName),
                ODO_TEXT("calibration.choose_floor_points", "choose points on the floor"));
    }
    return {};
}

/// Chains floor → rays of the other camera → rays of this one. Both cameras are above the floor, so both see
/// it the same way round.
Result<void> checkSide(const FloorView &reference, const Message &referenceName,
                       const std::vector<SharedPoint> &points, const CameraModel &camera)
{
    std::vector<PointPair> rays;
    for (const SharedPoint &point : points) {
        const auto from = reference.camera().unproject(point.referencePixel),
                   to = camera.unproject(point.pixel);
        if (!from || !to || !(from->z() > 0) || !(to->z() > 0))
            return refuseReference(
                ODO_TEXT("calibration.point_against_lens",
                         "the lens model cannot project point %1")(Named::marker(point.label)),
                ODO_TEXT("calibration.check_both_lenses",
                         "check its pixels and the intrinsics of both cameras"));
        rays.push_back({from->hnormalized(), to->hnormalized(), point.label});
    }
    const auto raysFromReference = Homography::estimate(rays);
    if (!raysFromReference)
        return refuseReference(raysFromReference.error().why, raysFromReference.error().advice);
    const Eigen::Matrix3d axes = reference.cameraFromWorld().rotation.toRotationMatrix();
    Eigen::Matrix3d referenceFromFloor;
    referenceFromFloor << axes.leftCols<2>(), reference.cameraFromWorld().translation;
    const std::array links{Homography(referenceFromFloor), *raysFromReference};
    const auto raysFromFloor = Homography::chain(links);
    if (!raysFromFloor)
        return refuseReference(raysFromFloor.error().why, raysFromFloor.error().advice);
    if (raysFromFloor->matrix().determinant() > 0)
        return refuseReference(
            ODO_TEXT("calibration.points_mirrored",
                     "the points are mirrored between the images of the two cameras"),
            ODO_TEXT("calibration.check_point_labels",
                     "check which label belongs to which point in %1 and in this camera")(referenceName));
    return {};
}

/// The inverse root of the covariance that each point's distance in the image has from the noise of both
/// pixels.
std::vector<Matrix2d> weightsOf(const FloorView &reference, const FloorView &view,
                                const std::vector<SharedPoint> &points, const std::vector<PointPair> &pairs)
{
    std::vector<Matrix2d> weights;
    const Matrix2d noise = pixelSigma * pixelSigma * Matrix2d::Identity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        Matrix2d covariance = noise;
        const auto position = reference.locate(points[i].referencePixel, noise, 0);
        const Vector3d pointInWorld(pairs[i].source.x(), pairs[i].source.y(), 0);
        Eigen::Matrix<double, 2, 3> pixelByPoint;
        if (position && view.camera().project(view.cameraFromWorld() * pointInWorld, pixelByPoint)) {
            const Matrix2d pixelByPosition =
                (pixelByPoint * view.cameraFromWorld().rotation.toRotationMatrix()).leftCols<2>();
            covariance += pixelByPosition * position->pixelCovariance * pixelByPosition.transpose();
        }
        weights.push_back(Eigen::SelfAdjointEigenSolver<Matrix2d>(covariance).operatorInverseSqrt());
    }
    return weights;
}

FloorView moved(const FloorView &view, const Vector6d &step)
{
    return FloorView(view.camera(), stepped(view.worldFromCamera(), step), view.poseCovariance());
}

Vector6d difference(const RigidTransform &to, const RigidTransform &from)
{
    const Eigen::AngleAxisd turn(to.rotation * from.rotation.conjugate());
    const double angle = turn.angle() > EIGEN_PI ? turn.angle() - 2 * EIGEN_PI : turn.angle();
    Vector6d step;
    step << angle * turn.axis(), to.translation - from.translation;
    return step;
}

/// What the other camera's pose covariance becomes in the fitted pose.
std::optional<Matrix6d> carried(const FloorView &reference, const std::vector<SharedPoint> &points,
                                const CameraModel &camera, const std::vector<Matrix2d> &weights)
{
    const Eigen::SelfAdjointEigenSolver<Matrix6d> root(reference.poseCovariance());
    Matrix6d sum = Matrix6d::Zero();
    for (int axis = 0; axis < 6; ++axis) {
        const Vector6d step =
            root.eigenvectors().col(axis) * std::sqrt(std::max(0.0, root.eigenvalues()(axis)));
        if (!(step.norm() > 0))
            continue;
        std::array<RigidTransform, 2> poses;
        for (int side = 0; side < 2; ++side) {
            const auto pairs = laid(moved(reference, side == 0 ? step : Vector6d(-step)), points);
            const auto pose = pairs ? fitPlanePose(*pairs, camera, FocalLength::Known, weights)
                                    : Result<PlanePose>(refuseReference({}, {}));
            if (!pose)
                return std::nullopt;
            poses[std::size_t(side)] = pose->worldFromCamera;
        }
        const Vector6d change = 0.5 * difference(poses[0], poses[1]);
        sum += change * change.transpose();
    }
    return sum;
}

/// The largest σ of the floor at any of the points.
double largestSigma(const FloorView &view, const std::vector<SharedPoint> &points)
{
    double largest = 0;
    for (const SharedPoint &point : points) {
        const auto position = view.locate(point.pixel, Matrix2d::Zero(), 0);
        if (position)
            largest = std::max(largest, largestSigmaM(*position));
    }
    return largest;
}

Result<void> measure(const std::vector<PointPair> &pairs, const FloorView &view,
                     FloorRegistration &registration)
{
    double squares = 0;
    registration.markers.clear();
    for (const PointPair &pair : pairs) {
        const auto seen = view.floorFromPixel(pair.target, 0);
        const auto back = view.pixelFromWorld({pair.source.x(), pair.source.y(), 0});
        if (!seen || !back)
            return refuseReference(
                ODO_TEXT("calibration.point_beyond_horizon",
                         "point %1 would be at or beyond the horizon")(Named::marker(pair.label)),
                ODO_TEXT("calibration.check_both_pixels", "check its pixels in both images"));
        const double errorM = (*seen - pair.source).norm();
        registration.markers.push_back({pair.label, errorM, (*back - pair.target).norm()});
        squares += errorM * errorM;
    }
    registration.rmsM = std::sqrt(squares / static_cast<double>(pairs.size()));
    return {};
}

Message verdictOf(const FloorRegistration &registration, const Message &referenceName, double sigmaM,
                  double referenceSigmaM, double spanM, bool intrinsicsKnown)
{
    const auto worst = std::ranges::max_element(registration.markers, {}, &MarkerError::errorM);
    std::vector<Message> sentences{registrationVerdict(
        std::max(registration.rmsM, sigmaM), spanM,
        ODO_TEXT("calibration.points_fit",
                 "via %1, %2 floor points fit to %3 RMS (worst %4, %5); floor uncertainty ±%6, of which %8 "
                 "contributes ±%7")(referenceName, registration.markers.size(),
                                    millimetres(registration.rmsM), Named::marker(worst->label),
                                    millimetres(worst->errorM), millimetres(sigmaM),
                                    millimetres(referenceSigmaM), referenceName))};
    if (registration.markers.size() == 4)
        sentences.push_back(hardlyChecked(
            ODO_TEXT("calibration.four_points_unchecked", "Four points are too few to check each other")));
    if (!intrinsicsKnown) {
        sentences.push_back(lensWords(registration.intrinsics));
        sentences.push_back(calibrateToRely());
    }
    return joined(std::move(sentences), Join::Space);
}

/// registerFloor's answer for the projected points: all its checks, the focal length if it is free, and the
/// initial pose.
Result<FloorRegistration> unweighted(const MarkerLayout &positions, const std::vector<MarkerPixel> &pixels,
                                     const CameraModel &camera, bool intrinsicsKnown)
{
    auto registration = registerFloor(positions, pixels, camera, intrinsicsKnown);
    if (registration)
        return registration;
    Error error = registration.error();
    error.what = notRegisteredVia();
    return tl::unexpected(error);
}

} // namespace

Result<ChainedRegistration> registerViaCamera(const FloorView &reference, const Message &referenceName,
                                              const std::vector<SharedPoint> &points,
                                              const CameraModel &camera, bool intrinsicsKnown)
{
    ODO_TRY(checkPoints(reference, referenceName, points, camera));
    ODO_TRY(checkHorizon(reference, referenceName, points));
    ODO_TRY(checkSide(reference, referenceName, points, camera));
    const std::vector<PointPair> pairs = *laid(reference, points);
    ChainedRegistration result;
    const std::vector<Vector2d> positions = positionsOf(pairs);
    for (const PointPair &pair : pairs) {
        result.positions.markers.push_back({pair.label, pair.source});
        result.pixels.push_back({pair.label, pair.target});
    }
    auto first = ODO_TRY(unweighted(result.positions, result.pixels, camera, intrinsicsKnown));
    result.registration = std::move(first);
    FloorRegistration &registration = result.registration;
    const auto lens = ODO_TRY(CameraModel::create(registration.intrinsics));
    const auto weights =
        weightsOf(reference, FloorView(lens, registration.worldFromCamera, Matrix6d::Zero()), points, pairs);
    const auto pose = fitPlanePose(pairs, lens, FocalLength::Known, weights);
    const auto common = carried(reference, points, lens, weights);
    if (!pose || !common)
        return refuseReference(pointsUndetermined(),
                               ODO_TEXT("calibration.spread_them", "spread them over the floor"));

    registration.worldFromCamera = pose->worldFromCamera;
    registration.rmsPx = pose->rmsPx;
    const double worse = std::max(1.0, pose->sigmaPx);
    registration.poseCovariance = worse * worse * pose->inverseNormal + *common;
    const FloorView view(lens, registration.worldFromCamera, registration.poseCovariance,
                         poseByIntrinsics(lens, registration.worldFromCamera, positions));
    ODO_TRY(measure(pairs, view, registration));
    const double sigmaM = largestSigma(view, points), spanM = extentOf(positions);
    if (sigmaM > worstPointSigma * spanM)
        return refuseReference(
            ODO_TEXT("calibration.floor_unsure",
                     "the floor uncertainty between the points is too large, ±%1")(millimetres(sigmaM)),
            ODO_TEXT("calibration.spread_or_register_better",
                     "spread the points over the floor, or register %1 better first")(referenceName));
    registration.floorSigmaM = sigmaM;
    const FloorView commonOnly(lens, registration.worldFromCamera, *common);
    registration.verdict = verdictOf(registration, referenceName, sigmaM, largestSigma(commonOnly, points),
                                     spanM, intrinsicsKnown);
    return result;
}

} // namespace odo
