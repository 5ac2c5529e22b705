// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/plane_pose.h"

#include "core/calibration/internal/pose_step.h"
#include "core/calibration/internal/wording.h"
#include "core/geometry/least_squares.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace odo {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double worstFocalSigma = 0.1; // of the focal length
constexpr double widestFocal = 0.3;     // of the longer side: 118° across
constexpr double longestFocal = 10;     // of the longer side: 6° across
constexpr double mostDegreesFromAxis =
    80; // beyond it a ray is no point of a plane ahead that a fit could use

struct PoseState
{
    RigidTransform worldFromCamera;
    double focalScale = 1;
};

CameraModel scaled(const CameraModel &camera, double focalScale)
{
    Intrinsics intrinsics = camera.intrinsics();
    intrinsics.fxPx *= focalScale;
    intrinsics.fyPx *= focalScale;
    if (focalScale != 1)
        intrinsics.covariance.resize(0, 0);
    return CameraModel::create(std::move(intrinsics)).value_or(camera);
}

using Weights = std::span<const Eigen::Matrix2d>;

/// Residuals in pixels (or weighted ones) over (rotation, position[, log of the focal length]).
LeastSquaresProblem<PoseState> problemOf(std::span<const PointPair> pairs, const CameraModel &camera,
                                         FocalLength focal, Weights weights)
{
    const Eigen::Index parameters = focal == FocalLength::Free ? 7 : 6;
    LeastSquaresProblem<PoseState> problem;
    problem.evaluate = [pairs, camera, parameters, weights](
                           const PoseState &state, Eigen::VectorXd &residuals, Eigen::MatrixXd *byStep) {
        residuals.resize(static_cast<Eigen::Index>(2 * pairs.size()));
        if (byStep)
            byStep->resize(residuals.size(), parameters);
        const CameraModel current = parameters == 7 ? scaled(camera, state.focalScale) : camera;
        const Vector2d centre(camera.intrinsics().cxPx, camera.intrinsics().cyPx);
        const Matrix3d cameraAxes = state.worldFromCamera.rotation.conjugate().toRotationMatrix();
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const Vector3d fromCamera =
                Vector3d(pairs[i].source.x(), pairs[i].source.y(), 0) - state.worldFromCamera.translation;
            Eigen::Matrix<double, 2, 3> pixelByPoint;
            const auto pixel = current.project(cameraAxes * fromCamera, pixelByPoint);
            if (!pixel)
                return false;
            const auto row = static_cast<Eigen::Index>(2 * i);
            const Eigen::Matrix2d weight = weights.empty() ? Eigen::Matrix2d::Identity() : weights[i];
            residuals.segment<2>(row) = weight * (*pixel - pairs[i].target);
            if (!byStep)
                continue;
            const Eigen::Matrix<double, 2, 3> pixelByWorld = weight * pixelByPoint * cameraAxes;
            for (int axis = 0; axis < 3; ++axis)
                byStep->block<2, 1>(row, axis) = -pixelByWorld * Vector3d::Unit(axis).cross(fromCamera);
            byStep->block<2, 3>(row, 3) = -pixelByWorld;
            if (parameters == 7)
                byStep->block<2, 1>(row, 6) = weight * (*pixel - centre);
        }
        return true;
    };
    problem.move = [parameters](const PoseState &state, const Eigen::VectorXd &step) {
        PoseState moved{stepped(state.worldFromCamera, step.head<6>()), state.focalScale};
        if (parameters == 7)
            moved.focalScale *= std::exp(std::clamp(step(6), -1.0, 1.0));
        return moved;
    };
    return problem;
}

/// How much longer the focal length is than assumed, from two orthogonal axes of one length (least squares
/// over both of Zhang's equations); nullopt where they contradict one another.
std::optional<double> focalScaleOf(const Homography &raysFromPlane)
{
    const Vector3d a = raysFromPlane.matrix().col(0), b = raysFromPlane.matrix().col(1);
    const Vector2d factors(a.x() * b.x() + a.y() * b.y(),
                           a.head<2>().squaredNorm() - b.head<2>().squaredNorm());
    const Vector2d constants(a.z() * b.z(), a.z() * a.z() - b.z() * b.z());
    const double inverseSquare = -factors.dot(constants) / factors.squaredNorm();
    if (!(inverseSquare > 0) || !std::isfinite(inverseSquare))
        return std::nullopt;
    return 1 / std::sqrt(inverseSquare);
}

tl::unexpected<Error> noPose(Message why, Message advice)
{
    return fail(ErrorCode::Undetermined, ODO_TEXT("calibration.no_pose", "no pose"), std::move(why),
                std::move(advice));
}

Result<Homography> raysFromPlane(std::span<const PointPair> pairs, const CameraModel &camera)
{
    std::vector<PointPair> rays;
    for (const PointPair &pair : pairs) {
        const auto ray = camera.unproject(pair.target);
        const double cosine = ray ? ray->normalized().z() : 0;
        if (!(cosine > std::cos(mostDegreesFromAxis * EIGEN_PI / 180)))
            return noPose(
                ODO_TEXT("calibration.marker_against_lens",
                         "this camera's lens model cannot project %1")(Named::marker(pair.label)),
                ODO_TEXT("calibration.check_pixel_and_lens", "check its pixel and the camera's intrinsics"));
        rays.push_back({pair.source, ray->hnormalized(), pair.label});
    }
    return Homography::estimate(rays);
}

/// The pose over the rays of a homography whose focal length is wrong by a factor.
RigidTransform startOf(const Homography &raysFromPlane, double focalScale)
{
    Matrix3d matrix = raysFromPlane.matrix();
    matrix.topRows<2>() /= focalScale;
    return poseFromHomography(Homography(matrix));
}

std::optional<PlanePose> refined(std::span<const PointPair> pairs, const CameraModel &camera,
                                 FocalLength focal, const PoseState &start, Weights weights)
{
    const LeastSquaresProblem<PoseState> problem = problemOf(pairs, camera, focal, weights);
    const PoseState best = minimise(problem, start);
    Eigen::VectorXd residuals;
    Eigen::MatrixXd byStep;
    if (!problem.evaluate(best, residuals, &byStep))
        return std::nullopt;
    PlanePose pose{scaled(camera, best.focalScale), best.worldFromCamera, {}, 0, 0, {}};
    const Eigen::MatrixXd normal = byStep.transpose() * byStep;
    pose.inverseNormal = Eigen::Matrix<double, 6, 6>(normal.topLeftCorner<6, 6>()).inverse();
    const auto freedom = static_cast<double>(residuals.size() - byStep.cols());
    pose.sigmaPx = freedom > 0 ? std::sqrt(residuals.squaredNorm() / freedom) : 0;
    if (!weights.empty())
        problemOf(pairs, camera, focal, {}).evaluate(best, residuals, nullptr);
    pose.rmsPx = std::sqrt(residuals.squaredNorm() / static_cast<double>(pairs.size()));
    if (!pose.inverseNormal.allFinite())
        return std::nullopt;
    if (focal == FocalLength::Free)
        pose.focalSigmaPx = std::sqrt(std::max(0.0, normal.inverse()(6, 6))) * std::max(1.0, pose.sigmaPx) *
                            pose.camera.intrinsics().fxPx;
    return pose;
}

bool isCredible(const PlanePose &pose)
{
    const Intrinsics &intrinsics = pose.camera.intrinsics();
    const double side = std::max(intrinsics.widthPx, intrinsics.heightPx);
    return pose.focalSigmaPx && *pose.focalSigmaPx < worstFocalSigma * intrinsics.fxPx &&
           intrinsics.fxPx > widestFocal * side && intrinsics.fxPx < longestFocal * side;
}

} // namespace

RigidTransform poseFromHomography(const Homography &raysFromPlane)
{
    const Matrix3d &h = raysFromPlane.matrix();
    const double scale = 2 / (h.col(0).norm() + h.col(1).norm());
    Matrix3d axes;
    axes << scale * h.col(0), scale * h.col(1), scale * scale * h.col(0).cross(h.col(1));
    const Eigen::JacobiSVD<Matrix3d> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose(); // det(axes) > 0 by construction
    return RigidTransform{Eigen::Quaterniond(rotation), scale * h.col(2)}.inverse();
}

Result<PlanePose> fitPlanePose(std::span<const PointPair> pairs, const CameraModel &camera, FocalLength focal,
                               Weights weights)
{
    const auto rays = ODO_TRY(raysFromPlane(pairs, camera));
    if (focal == FocalLength::Free) {
        // The closed form is weak against noise; where it fails the refinement starts from the focal length
        // given.
        const double scale = focalScaleOf(rays).value_or(1);
        const auto free = refined(pairs, camera, FocalLength::Free, {startOf(rays, scale), scale}, weights);
        if (free && isCredible(*free))
            return *free;
    }
    if (const auto pose = refined(pairs, camera, FocalLength::Known, {startOf(rays, 1), 1}, weights))
        return *pose;
    return noPose(pointsUndetermined(), ODO_TEXT("calibration.spread_points",
                                                 "spread the points over the floor, not along a line"));
}

std::optional<PlanePose> refinePlanePose(std::span<const PointPair> pairs, const CameraModel &camera,
                                         FocalLength focal, const RigidTransform &worldFromCamera)
{
    return refined(pairs, camera, focal, {worldFromCamera, 1}, {});
}

} // namespace odo
