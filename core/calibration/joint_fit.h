// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera_model.h"
#include "core/geometry/rigid_transform.h"

#include <optional>
#include <string>
#include <vector>

namespace odo {

struct JointPoint
{
    std::string label;
    Eigen::Vector2d place;  ///< measured, or to begin with; metres on the floor
    bool isMeasured = true; ///< its place has the tape's prior
};

struct JointObservation
{
    std::size_t camera, point;
    Eigen::Vector2d pixel;
};

/// Cameras over points of the floor, some of known place.
struct JointProblem
{
    struct Camera
    {
        CameraModel model;
        RigidTransform worldFromCamera;
    };
    std::vector<Camera> cameras;
    std::vector<JointPoint> points;
    std::vector<JointObservation> observations;
    double sigmaPx = 0.3, tapeSigmaM = 0.002;
};

struct JointFit
{
    std::vector<RigidTransform> poses;
    std::vector<Eigen::Matrix<double, 6, 6>> poseCovariances; ///< as FloorView's
    std::vector<Eigen::Vector2d> places;
    std::vector<Eigen::Matrix2d> placeCovariances;
    double cost = 0;         ///< sum of squares, each over its σ
    double pixelSquares = 0; ///< sum of squared distances in the pictures
    double pixelFreedom = 0; ///< how many of the pixels' coordinates the fit left free (2n − trace of their hat matrix)
};

/// Least squares over poses and places (core/geometry/least_squares.h). nullopt where they are not determined.
std::optional<JointFit> fitJointly(const JointProblem &problem);

} // namespace odo
