// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/floor_registration.h"

#include <string>
#include <vector>

namespace odo {

/// A camera registered to the layout by itself, to be registered again together with the others.
struct JointCamera
{
    std::string name;
    CameraModel camera;             ///< of the registration; held as it is
    RigidTransform worldFromCamera; ///< to begin with
    /// Markers of the layout, and points of the floor that are in no layout but that another camera sees
    /// under the same label.
    std::vector<MarkerPixel> pixels;
};

/// A marker's position from all cameras jointly.
struct JointMarker
{
    std::string label;
    int cameras = 0; ///< that see it
    /// from where it was measured to where the cameras see it
    Eigen::Vector2d offM = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< m², of offM
    bool isSuspicious = false; ///< measured wrongly or moved since: its measured position was left out
};

struct JointRegistration
{
    std::vector<FloorRegistration> registrations; ///< in the order of the cameras
    std::vector<JointMarker> markers;             ///< of the layout, those that a camera sees
    MarkerLayout otherPoints;                     ///< where the points lie that were in no layout
    double rmsPx = 0;                             ///< of all distances in the images
    /// sentences: "U is 23 mm off in all cameras: remeasure it.", "B sees U ..."
    std::vector<Message> caveats;
    Message verdict; ///< the sentences in `caveats`, or that all agree
};

/// Fits the poses of all cameras and the positions of all markers at once (Levenberg–Marquardt): pixels with
/// the noise that registerFloor gives a marker (0.3 px, weighed against the residuals), each marker's
/// position with the σ of the tape measure as a prior (Gaussian, both coordinates alike), other points
/// without one. Intrinsics are held. Bad data are left out: while leaving out one marker's measured position
/// lowers the sum of squares by more than 16 (χ² of two degrees of freedom: one in 3000 by chance), or
/// leaving out one camera's pixel of it by 24, the one that lowers it most goes and is named. poseCovariance
/// is the marginal one of each camera; the cameras' errors are correlated through the common markers.
///
/// Cameras that were registered by one image (all common markers within 0.3 px of each other, the same lens)
/// count as one: that image's errors are the same for all of them. They share the outcome, and the verdict
/// names them.
///
/// Refuses: fewer than two cameras, two of one name, cameras that have no marker or point in common, a camera
/// with fewer than three pixels that count, and what the fit does not determine. Pure; any thread.
Result<JointRegistration> registerJointly(const MarkerLayout &layout, const std::vector<JointCamera> &cameras,
                                          double tapeSigmaM = 0.002);

} // namespace odo
