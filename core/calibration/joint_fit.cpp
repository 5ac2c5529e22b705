// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/joint_fit.h"

#include "core/geometry/least_squares.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct JointState
{
    std::vector<RigidTransform> poses;
    std::vector<Vector2d> places;
};

/// Rows: two an observation, then two a measured point. Columns: six a camera, then two a point.
LeastSquaresProblem<JointState> problemOf(const JointProblem &problem)
{
    LeastSquaresProblem<JointState> squares;
    squares.evaluate = [&problem](const JointState &state, Eigen::VectorXd &residuals,
                                  Eigen::MatrixXd *byStep) {
        const auto cameras = static_cast<Eigen::Index>(problem.cameras.size());
        const auto points = static_cast<Eigen::Index>(problem.points.size());
        const auto observations = static_cast<Eigen::Index>(problem.observations.size());
        residuals = Eigen::VectorXd::Zero(2 * observations + 2 * points);
        if (byStep)
            *byStep = Eigen::MatrixXd::Zero(residuals.size(), 6 * cameras + 2 * points);
        for (Eigen::Index i = 0; i < observations; ++i) {
            const JointObservation &seen = problem.observations[static_cast<std::size_t>(i)];
            const RigidTransform &pose = state.poses[seen.camera];
            const Vector2d &place = state.places[seen.point];
            const Eigen::Matrix3d cameraAxes = pose.rotation.conjugate().toRotationMatrix();
            const Vector3d fromCamera = Vector3d(place.x(), place.y(), 0) - pose.translation;
            Eigen::Matrix<double, 2, 3> pixelByPoint;
            const auto pixel = problem.cameras[seen.camera].model.project(cameraAxes * fromCamera, pixelByPoint);
            if (!pixel)
                return false;
            residuals.segment<2>(2 * i) = (*pixel - seen.pixel) / problem.sigmaPx;
            if (!byStep)
                continue;
            const Eigen::Matrix<double, 2, 3> byWorld = pixelByPoint * cameraAxes / problem.sigmaPx;
            const auto column = static_cast<Eigen::Index>(6 * seen.camera);
            for (int axis = 0; axis < 3; ++axis)
                byStep->block<2, 1>(2 * i, column + axis) = byWorld * fromCamera.cross(Vector3d::Unit(axis));
            byStep->block<2, 3>(2 * i, column + 3) = -byWorld;
            byStep->block<2, 2>(2 * i, 6 * cameras + static_cast<Eigen::Index>(2 * seen.point)) = byWorld.leftCols<2>();
        }
        for (Eigen::Index i = 0; i < points; ++i) {
            const JointPoint &point = problem.points[static_cast<std::size_t>(i)];
            if (!point.isMeasured)
                continue;
            const Eigen::Index row = 2 * observations + 2 * i;
            residuals.segment<2>(row) = (state.places[static_cast<std::size_t>(i)] - point.place) / problem.tapeSigmaM;
            if (byStep)
                byStep->block<2, 2>(row, 6 * cameras + 2 * i) = Eigen::Matrix2d::Identity() / problem.tapeSigmaM;
        }
        return true;
    };
    squares.move = [](const JointState &state, const Eigen::VectorXd &step) {
        JointState moved = state;
        for (std::size_t i = 0; i < moved.poses.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(6 * i);
            const Vector3d turn = step.segment<3>(at);
            if (turn.norm() > 0)
                moved.poses[i].rotation = (Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) *
                                           moved.poses[i].rotation)
                                              .normalized();
            moved.poses[i].translation += step.segment<3>(at + 3);
        }
        for (std::size_t i = 0; i < moved.places.size(); ++i)
            moved.places[i] += step.segment<2>(static_cast<Eigen::Index>(6 * moved.poses.size() + 2 * i));
        return moved;
    };
    return squares;
}

} // namespace

std::optional<JointFit> fitJointly(const JointProblem &problem)
{
    JointState start;
    for (const JointProblem::Camera &camera : problem.cameras)
        start.poses.push_back(camera.worldFromCamera);
    for (const JointPoint &point : problem.points)
        start.places.push_back(point.place);
    const auto squares = problemOf(problem);
    const JointState best = minimise(squares, start);
    Eigen::VectorXd residuals;
    Eigen::MatrixXd byStep;
    if (!squares.evaluate(best, residuals, &byStep))
        return std::nullopt;
    const Eigen::MatrixXd normal = byStep.transpose() * byStep;
    // Scaled to a unit diagonal, or metres and radians would hide a singular matrix.
    const Eigen::VectorXd scale = normal.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::FullPivLU<Eigen::MatrixXd> factors(scale.asDiagonal() * normal * scale.asDiagonal());
    if (!factors.isInvertible())
        return std::nullopt;
    const Eigen::MatrixXd covariance = scale.asDiagonal() * factors.inverse() * scale.asDiagonal();
    JointFit fit{best.poses, {}, best.places, {}, residuals.squaredNorm(), 0, 0};
    const auto rows = static_cast<Eigen::Index>(2 * problem.observations.size());
    fit.pixelSquares = residuals.head(rows).squaredNorm() * problem.sigmaPx * problem.sigmaPx;
    const Eigen::MatrixXd ofPixels = byStep.topRows(rows);
    fit.pixelFreedom = static_cast<double>(rows) - (ofPixels * covariance).cwiseProduct(ofPixels).sum();
    for (std::size_t i = 0; i < best.poses.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * i);
        fit.poseCovariances.emplace_back(covariance.block<6, 6>(at, at));
        if (!(best.poses[i].translation.z() > 0))
            return std::nullopt;
    }
    for (std::size_t i = 0; i < best.places.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * best.poses.size() + 2 * i);
        fit.placeCovariances.emplace_back(covariance.block<2, 2>(at, at));
    }
    return fit;
}

} // namespace odo
