// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace odo {

/// Exact state of a simulated robot: of its footprint's centre, world frame, SI.
struct MotionState
{
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    Eigen::Vector2d acceleration = Eigen::Vector2d::Zero();
    double headingRad =
        0; ///< of the robot's length axis; along the velocity, while standing the one it starts or ended with
};

/// A known trajectory, exact at every time: twice continuously differentiable. Immutable.
class Motion
{
public:
    virtual ~Motion() = default;
    /// Any time; before 0 s it stands still at its start.
    virtual MotionState at(double timeS) const = 0;
};

/// Rests, then runs from start to end with a smooth (quintic) ramp, then rests.
std::shared_ptr<const Motion> makeLineMotion(Eigen::Vector2d start, const Eigen::Vector2d &end, double startS,
                                             double durationS);
/// Circles anticlockwise from centre + (radius, 0), starting from rest over rampS to the steady angular
/// speed.
std::shared_ptr<const Motion> makeCircleMotion(Eigen::Vector2d centre, double radiusM, double speedMps,
                                               double rampS);
/// Lissajous figure eight (x = a·sin ωt, y = b·sin 2ωt), starting from rest over rampS.
std::shared_ptr<const Motion> makeFigureEightMotion(Eigen::Vector2d centre, double halfWidthM,
                                                    double halfHeightM, double periodS, double rampS);
/// Ellipse from a phase on (0 at centre + (halfWidth, 0)), anticlockwise, starting from rest over rampS.
std::shared_ptr<const Motion> makeEllipseMotion(Eigen::Vector2d centre, double halfWidthM, double halfHeightM,
                                                double periodS, double phaseRad, double rampS);
/// Legs between way points, each a smooth ramp of legS after a stop of pauseS; while it stops between two
/// legs it turns on the spot towards the next.
std::shared_ptr<const Motion> makeStopAndGoMotion(const std::vector<Eigen::Vector2d> &points, double legS,
                                                  double pauseS);
/// Twice continuously differentiable spline through points at equal time steps, at rest at both ends: knot
/// velocities and accelerations of the clamped cubic spline, joined by quintics.
std::shared_ptr<const Motion> makeSplineMotion(std::vector<Eigen::Vector2d> points, double stepS);

/// A change of the velocity, by a smooth (quintic) ramp.
struct VelocityChange
{
    double startS = 0, durationS = 0;
    Eigen::Vector2d deltaMps = Eigen::Vector2d::Zero();
};
/// Rests at start until the first change; the changes add up and may overlap. A short one is a collision.
/// The body keeps its heading, whichever way it is thrown.
std::shared_ptr<const Motion> makeVelocityMotion(Eigen::Vector2d start, double headingRad,
                                                 std::vector<VelocityChange> changes);

} // namespace odo
