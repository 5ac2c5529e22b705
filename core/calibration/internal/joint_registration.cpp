// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/joint_registration.h"

#include "core/base/units.h"
#include "core/calibration/floor_registration.h"
#include "core/calibration/internal/pose_step.h"
#include "core/calibration/internal/wording.h"
#include "core/calibration/intrinsics_influence.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"
#include "core/geometry/homography.h"
#include "core/geometry/least_squares.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace odo {

struct JointPoint
{
    std::string label;
    Eigen::Vector2d position; ///< measured, or to begin with; metres on the floor
    bool isMeasured = true;   ///< its position has the tape's prior
};

struct JointObservation
{
    std::size_t camera, point;
    Eigen::Vector2d pixel;
};

/// Cameras over floor points, some of known position.
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
    std::vector<Eigen::Vector2d> positions;
    std::vector<Eigen::Matrix2d> positionCovariances;
    double cost = 0;         ///< sum of squares, each over its σ
    double pixelSquares = 0; ///< sum of squared distances in the images
    /// how many of the pixels' coordinates the fit left free (2n − trace of their hat matrix)
    double pixelFreedom = 0;
};

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct JointState
{
    std::vector<RigidTransform> poses;
    std::vector<Vector2d> positions;
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
            const Vector2d &position = state.positions[seen.point];
            const Eigen::Matrix3d cameraAxes = pose.rotation.conjugate().toRotationMatrix();
            const Vector3d fromCamera = Vector3d(position.x(), position.y(), 0) - pose.translation;
            Eigen::Matrix<double, 2, 3> pixelByPoint;
            const auto pixel =
                problem.cameras[seen.camera].model.project(cameraAxes * fromCamera, pixelByPoint);
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
            byStep->block<2, 2>(2 * i, 6 * cameras + static_cast<Eigen::Index>(2 * seen.point)) =
                byWorld.leftCols<2>();
        }
        for (Eigen::Index i = 0; i < points; ++i) {
            const JointPoint &point = problem.points[static_cast<std::size_t>(i)];
            if (!point.isMeasured)
                continue;
            const Eigen::Index row = 2 * observations + 2 * i;
            residuals.segment<2>(row) =
                (state.positions[static_cast<std::size_t>(i)] - point.position) / problem.tapeSigmaM;
            if (byStep)
                byStep->block<2, 2>(row, 6 * cameras + 2 * i) =
                    Eigen::Matrix2d::Identity() / problem.tapeSigmaM;
        }
        return true;
    };
    squares.move = [](const JointState &state, const Eigen::VectorXd &step) {
        JointState moved = state;
        for (std::size_t i = 0; i < moved.poses.size(); ++i) {
            const auto at = static_cast<Eigen::Index>(6 * i);
            moved.poses[i] = stepped(moved.poses[i], step.segment<6>(at));
        }
        for (std::size_t i = 0; i < moved.positions.size(); ++i)
            moved.positions[i] += step.segment<2>(static_cast<Eigen::Index>(6 * moved.poses.size() + 2 * i));
        return moved;
    };
    return squares;
}

} // namespace

/// Least squares over poses and positions (core/geometry/least_squares.h). nullopt where they are not
/// determined.
std::optional<JointFit> fitJointly(const JointProblem &problem)
{
    JointState start;
    for (const JointProblem::Camera &camera : problem.cameras)
        start.poses.push_back(camera.worldFromCamera);
    for (const JointPoint &point : problem.points)
        start.positions.push_back(point.position);
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
    JointFit fit{best.poses, {}, best.positions, {}, residuals.squaredNorm(), 0, 0};
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
    for (std::size_t i = 0; i < best.positions.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(6 * best.poses.size() + 2 * i);
        fit.positionCovariances.emplace_back(covariance.block<2, 2>(at, at));
    }
    return fit;
}

namespace {

using Eigen::Vector2d;

constexpr double leastFall = 16; // of the sum of squares: χ² of two degrees of freedom, 1 in 3000
// leaving out one pixel of a marker cures part of its wrong position
constexpr double pixelHandicap = 8;
constexpr std::size_t leastPixels = 3;
// markers whose measured position counts: they hold the axes and the scale
constexpr std::size_t leastMeasured = 3;

tl::unexpected<Error> refuseJoint(Message why, Message advice, ErrorCode code = ErrorCode::Undetermined)
{
    return fail(code,
                ODO_TEXT("calibration.not_registered_together", "the cameras cannot be registered jointly"),
                std::move(why), std::move(advice));
}

class Joining
{
public:
    Joining(const MarkerLayout &layout, const std::vector<JointCamera> &cameras, double tapeSigmaM)
        : m_layout(layout), m_cameras(cameras)
    {
        m_problem.tapeSigmaM = tapeSigmaM;
    }

    Result<JointRegistration> join()
    {
        ODO_TRY(checkCameras());
        ODO_TRY(gather());
        auto fit = fitJointly(m_problem);
        if (!fit)
            return undetermined();
        leaveOutWhatDoesNotFit(*fit);
        m_problem.sigmaPx = markSigmaPx(fit->pixelSquares, fit->pixelFreedom);
        fit = fitJointly(m_problem);
        if (!fit)
            return undetermined();
        return outcomeOf(*fit);
    }

private:
    static tl::unexpected<Error> undetermined()
    {
        return refuseJoint(
            ODO_TEXT("calibration.cameras_undetermined", "the markers do not determine the camera positions"),
            spreadMarkers());
    }

    Result<void> checkCameras() const
    {
        if (m_cameras.size() < 2)
            return refuseJoint(ODO_TEXT("calibration.two_cameras_needed",
                                        "layout '%2' has %1 registered camera, two are needed")(
                                   m_cameras.size(), Named::layout(m_layout.name)),
                               ODO_TEXT("calibration.register_one_by_one",
                                        "first register the cameras one by one with this layout"));
        std::set<std::string> names;
        for (const JointCamera &camera : m_cameras) {
            if (!names.insert(camera.name).second)
                return refuseJoint(ODO_TEXT("calibration.camera_twice",
                                            "camera '%1' appears twice")(Named::camera(camera.name)),
                                   ODO_TEXT("calibration.name_each_camera", "name each camera once"));
        }
        return {};
    }

    /// Which points there are, and who sees them.
    Result<void> gather()
    {
        std::map<std::string, int> seenBy;
        for (const JointCamera &camera : m_cameras) {
            for (const MarkerPixel &pixel : camera.pixels)
                ++seenBy[pixel.label];
        }
        std::map<std::string, std::size_t> pointOf;
        for (const Marker &marker : m_layout.markers) {
            if (seenBy.contains(marker.label)) {
                pointOf[marker.label] = m_problem.points.size();
                m_problem.points.push_back({marker.label, marker.pointInWorld, true});
            }
        }
        m_markers = m_problem.points.size();
        for (std::size_t i = 0; i < m_cameras.size(); ++i) {
            const JointCamera &camera = m_cameras[i];
            m_problem.cameras.push_back({camera.camera, camera.worldFromCamera});
            const FloorView view(camera.camera, camera.worldFromCamera, Eigen::Matrix<double, 6, 6>::Zero());
            std::size_t counted = 0;
            for (const MarkerPixel &pixel : camera.pixels) {
                if (!pointOf.contains(pixel.label)) {
                    const auto position = view.floorFromPixel(pixel.pixel, 0);
                    if (seenBy[pixel.label] < 2 || !position)
                        continue; // it constrains nothing
                    pointOf[pixel.label] = m_problem.points.size();
                    m_problem.points.push_back({pixel.label, *position, false});
                }
                m_problem.observations.push_back({i, pointOf[pixel.label], pixel.pixel});
                ++counted;
            }
            if (counted < leastPixels)
                return refuseJoint(
                    ODO_TEXT("calibration.camera_sees_too_few",
                             "camera '%1' sees only %2 of the markers")(Named::camera(camera.name), counted),
                    ODO_TEXT("calibration.register_by_more", "register it with more of them first"));
        }
        const auto isShared = [](const auto &each) { return each.second >= 2; };
        if (std::ranges::none_of(seenBy, isShared))
            return refuseJoint(
                ODO_TEXT("calibration.no_common_marker", "no two of the cameras see the same marker"),
                ODO_TEXT("calibration.see_same_floor", "aim them at a common part of the floor"));
        return {};
    }

    void leaveOutWhatDoesNotFit(JointFit &fit)
    {
        for (;;) {
            std::optional<JointFit> best;
            JointProblem bestProblem;
            double bestCost = fit.cost - leastFall;
            const auto consider = [&](JointProblem &&other, double handicap) {
                auto again = fitJointly(other);
                if (again && again->cost + handicap < bestCost) {
                    bestCost = again->cost + handicap;
                    best = std::move(*again);
                    bestProblem = std::move(other);
                }
            };
            const auto measured =
                static_cast<std::size_t>(std::ranges::count_if(m_problem.points, &JointPoint::isMeasured));
            for (std::size_t i = 0; i < m_problem.points.size() && measured > leastMeasured; ++i) {
                if (!m_problem.points[i].isMeasured)
                    continue;
                JointProblem other = m_problem;
                other.points[i].isMeasured = false;
                consider(std::move(other), 0);
            }
            for (std::size_t i = 0; i < m_problem.observations.size(); ++i) {
                if (pixelsOf(m_problem.observations[i].camera) <= leastPixels + 1)
                    continue;
                JointProblem other = m_problem;
                other.observations.erase(other.observations.begin() + static_cast<std::ptrdiff_t>(i));
                consider(std::move(other), pixelHandicap);
            }
            if (!best)
                return;
            m_problem = std::move(bestProblem);
            fit = std::move(*best);
        }
    }

    std::size_t pixelsOf(std::size_t camera) const
    {
        return static_cast<std::size_t>(
            std::ranges::count(m_problem.observations, camera, &JointObservation::camera));
    }

    JointRegistration outcomeOf(const JointFit &fit) const
    {
        JointRegistration joint;
        joint.rmsPx = std::sqrt(fit.pixelSquares / static_cast<double>(m_problem.observations.size()));
        for (std::size_t i = 0; i < m_problem.points.size(); ++i) {
            const JointPoint &point = m_problem.points[i];
            if (i >= m_markers) {
                joint.otherPoints.markers.push_back({point.label, fit.positions[i]});
                continue;
            }
            JointMarker marker{point.label, 0, fit.positions[i] - point.position, fit.positionCovariances[i],
                               !point.isMeasured};
            for (const JointCamera &camera : m_cameras)
                marker.cameras += std::ranges::count(camera.pixels, point.label, &MarkerPixel::label) > 0;
            if (marker.isSuspicious)
                joint.caveats.push_back(uncertaintyOf(marker));
            joint.markers.push_back(std::move(marker));
        }
        for (std::size_t i = 0; i < m_cameras.size(); ++i)
            joint.registrations.push_back(registrationOf(i, fit, joint));
        joint.verdict = verdictOf(joint);
        for (FloorRegistration &registration : joint.registrations)
            registration.verdict = joined({std::move(registration.verdict), joint.verdict}, Join::Space);
        return joint;
    }

    static Message uncertaintyOf(const JointMarker &marker)
    {
        const MessageArgument label = Named::marker(marker.label),
                              off = quantity(toMillimetres(marker.offM.norm()), 0, "mm");
        if (marker.cameras > 1)
            return joined(
                {ODO_TEXT("calibration.marker_off_by_all", "%1 is %2 off in all cameras")(label, off),
                 ODO_TEXT("calibration.measure_it_again", "remeasure it.")},
                Join::Colon);
        return joined(
            {ODO_TEXT("calibration.marker_off_by_one", "%1 is %2 off in the one camera that sees it")(label,
                                                                                                      off),
             ODO_TEXT("calibration.measure_or_mark_again", "measure it, or mark it in the image, again.")},
            Join::Colon);
    }

    FloorRegistration registrationOf(std::size_t index, const JointFit &fit, JointRegistration &joint) const
    {
        const JointCamera &camera = m_cameras[index];
        FloorRegistration registration;
        registration.worldFromCamera = fit.poses[index];
        registration.poseCovariance = fit.poseCovariances[index];
        registration.intrinsics = camera.camera.intrinsics();
        const FloorView view(camera.camera, registration.worldFromCamera, registration.poseCovariance);
        double squaresPx = 0, squaresM = 0, counted = 0;
        for (const MarkerPixel &pixel : camera.pixels) {
            const auto point = std::ranges::find(m_problem.points, pixel.label, &JointPoint::label);
            if (point == m_problem.points.end())
                continue;
            const auto at = static_cast<std::size_t>(point - m_problem.points.begin());
            const Vector2d &position = fit.positions[at];
            const auto back = view.pixelFromWorld({position.x(), position.y(), 0});
            const auto seen = view.floorFromPixel(pixel.pixel, 0);
            if (!back || !seen)
                continue;
            const double errorPx = (*back - pixel.pixel).norm();
            const bool isUsed =
                std::ranges::any_of(m_problem.observations, [&](const JointObservation &each) {
                    return each.camera == index && each.point == at;
                });
            if (!isUsed)
                joint.caveats.push_back(joined(
                    {ODO_TEXT("calibration.camera_sees_elsewhere",
                              "%1 sees %2 %3 from where the others see it")(
                         Named::camera(camera.name), Named::marker(pixel.label), quantity(errorPx, 1, "px")),
                     ODO_TEXT("calibration.mark_there_again", "mark it again in that view.")},
                    Join::Colon));
            if (at >= m_markers)
                continue;
            // Against the measured position: that is what a person can check.
            const double errorM = (*seen - measuredPosition(pixel.label)).norm();
            registration.markers.push_back({pixel.label, errorM, errorPx});
            if (!isUsed || !point->isMeasured)
                continue;
            squaresPx += errorPx * errorPx;
            squaresM += errorM * errorM;
            ++counted;
        }
        registration.rmsPx = std::sqrt(squaresPx / std::max(1.0, counted));
        registration.rmsM = std::sqrt(squaresM / std::max(1.0, counted));
        registration.floorSigmaM = floorSigmaM(registration, camera.camera, camera.pixels);
        registration.verdict = registrationVerdict(
            std::max(registration.rmsM, registration.floorSigmaM), extentM(),
            ODO_TEXT("calibration.markers_fit_together",
                     "registered jointly with %1: %2 markers fit to %3 RMS; floor uncertainty ±%4")(
                others(index), registration.markers.size(), millimetres(registration.rmsM),
                millimetres(registration.floorSigmaM)));
        return registration;
    }

    const Vector2d &measuredPosition(const std::string &label) const
    {
        return std::ranges::find(m_layout.markers, label, &Marker::label)->pointInWorld;
    }

    double extentM() const
    {
        std::vector<Vector2d> positions;
        for (const Marker &marker : m_layout.markers)
            positions.push_back(marker.pointInWorld);
        return extentOf(positions);
    }

    MessageArgument others(std::size_t index) const
    {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < m_cameras.size(); ++i) {
            if (i != index)
                names.push_back(m_cameras[i].name);
        }
        return listed(names, MessageArgument::Kind::Camera);
    }

    static Message verdictOf(const JointRegistration &joint)
    {
        if (joint.caveats.empty())
            return ODO_TEXT("calibration.all_agree", "The markers and the cameras agree with each other.");
        return joined(joint.caveats, Join::Space);
    }

    const MarkerLayout &m_layout;
    const std::vector<JointCamera> &m_cameras;
    JointProblem m_problem;
    std::size_t m_markers = 0; ///< the first points are those of the layout
};

/// Whether one image registered two cameras: all markers that both see have the same pixels, nearer than one
/// marks them again.
bool isSameImage(const JointCamera &one, const JointCamera &other)
{
    std::size_t common = 0;
    for (const MarkerPixel &pixel : one.pixels) {
        const auto there = std::ranges::find(other.pixels, pixel.label, &MarkerPixel::label);
        if (there == other.pixels.end())
            continue;
        if ((pixel.pixel - there->pixel).norm() > usualMarkSigmaPx)
            return false;
        ++common;
    }
    return common >= leastPixels && one.name != other.name &&
           one.camera.intrinsics().fxPx == other.camera.intrinsics().fxPx;
}

/// Of each camera the first one whose image it was registered by.
std::vector<std::size_t> originalsOf(const std::vector<JointCamera> &cameras)
{
    std::vector<std::size_t> originals;
    for (const JointCamera &camera : cameras) {
        const auto same = std::ranges::find_if(cameras, [&](const JointCamera &other) {
            return &other == &camera || isSameImage(camera, other);
        });
        originals.push_back(static_cast<std::size_t>(same - cameras.begin()));
    }
    return originals;
}

} // namespace

Result<JointRegistration> registerJointly(const MarkerLayout &layout, const std::vector<JointCamera> &cameras,
                                          double tapeSigmaM)
{
    if (!(tapeSigmaM > 0) || !std::isfinite(tapeSigmaM))
        return refuseJoint(
            ODO_TEXT("calibration.tape_sigma_not_positive", "the σ of the tape measure is not above 0"),
            ODO_TEXT("calibration.give_tape_sigma", "give about 2 mm"), ErrorCode::InvalidInput);
    const std::vector<std::size_t> originals = originalsOf(cameras);
    std::vector<JointCamera> counting;
    std::vector<std::size_t> at; // of each camera that counts, and of those of its image
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        at.push_back(originals[i] == i ? counting.size() : at[originals[i]]);
        if (originals[i] == i)
            counting.push_back(cameras[i]);
    }
    auto joint = Joining(layout, counting, tapeSigmaM).join();
    if (!joint || counting.size() == cameras.size())
        return joint;
    const std::vector<FloorRegistration> registrations = std::move(joint->registrations);
    joint->registrations.clear();
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        joint->registrations.push_back(registrations[at[i]]);
        if (originals[i] == i)
            continue;
        const Message same = ODO_TEXT("calibration.cameras_of_one_image",
                                      "%1 and %2 have the same pixels and count as one camera.")(
            Named::camera(cameras[originals[i]].name), Named::camera(cameras[i].name));
        joint->verdict = joined({std::move(joint->verdict), same}, Join::Space);
        joint->registrations[i].verdict =
            joined({std::move(joint->registrations[i].verdict), same}, Join::Space);
        joint->registrations[originals[i]].verdict =
            joined({std::move(joint->registrations[originals[i]].verdict), same}, Join::Space);
    }
    return joint;
}

} // namespace odo
