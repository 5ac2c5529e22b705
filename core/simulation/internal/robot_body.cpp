// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/robot_body.h"

#include "core/geometry/floor_view.h"
#include "core/geometry/silhouette.h"
#include "core/simulation/internal/polygon_layer.h"
#include "core/simulation/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <vector>

namespace odo {

/// A flat convex face, corners in order, anticlockwise seen from outside.
struct SolidFace
{
    std::vector<Eigen::Vector3d> corners;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< outward

    bool isSeenFrom(const Eigen::Vector3d &position) const
    {
        return normal.dot(position - corners.front()) > 0;
    }
};

/// The base of an upright part, or the outline of any other seen from above; anticlockwise.
std::vector<Eigen::Vector2d> outlineFromAbove(const RobotPart &part);

/// The sides of a regular prism that stands for a cylinder.
constexpr int cylinderSides = 96;

namespace {

constexpr int wheelSides = 48;

/// Of the regular polygon of the circle's area: with 96 sides its corners lie 0.04 % outside, the middles of
/// its sides inside.
std::vector<Eigen::Vector2d> circle(double diameterM, int sides)
{
    const double step = 2 * std::numbers::pi / sides;
    const double radius = diameterM / 2 * std::sqrt(step / std::sin(step));
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < sides; ++i)
        points.emplace_back(radius * std::cos(i * step), radius * std::sin(i * step));
    return points;
}

std::vector<Eigen::Vector2d> rectangle(double length, double width)
{
    const double l = length / 2, w = width / 2;
    return {{l, w}, {-l, w}, {-l, -w}, {l, -w}};
}

SolidFace faceOf(std::vector<Eigen::Vector3d> corners)
{
    const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalized();
    return {std::move(corners), normal};
}

/// Both ends and the sides of a prism. position: of a point of the outline at the lower (0) or upper
/// (1) end.
template <class Position>
std::vector<SolidFace> prism(const std::vector<Eigen::Vector2d> &outline, const Position &position)
{
    std::vector<Eigen::Vector3d> lower, upper;
    for (const Eigen::Vector2d &point : outline) {
        lower.push_back(position(point, 0));
        upper.push_back(position(point, 1));
    }
    std::vector<SolidFace> faces{faceOf(upper), faceOf({lower.rbegin(), lower.rend()})};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t next = (i + 1) % outline.size();
        faces.push_back(faceOf({lower[i], lower[next], upper[next], upper[i]}));
    }
    return faces;
}

/// What the camera sees of a sphere is bounded by the circle in which the cone of its tangents touches it.
SolidFace discOf(const RobotPart &sphere, const Eigen::Vector3d &cameraInRobot)
{
    const Eigen::Vector3d away = cameraInRobot - sphere.centreM;
    const double distance = away.norm(), radius = sphere.sizeM.x() / 2;
    const Eigen::Vector3d normal = away / distance;
    const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(normal).normalized(),
                          up = normal.cross(right);
    const Eigen::Vector3d middle = sphere.centreM + normal * (radius * radius / distance);
    const double discRadius = radius * std::sqrt(1 - radius * radius / (distance * distance));
    SolidFace disc{{}, normal};
    for (const Eigen::Vector2d &point : circle(2 * discRadius, cylinderSides))
        disc.corners.emplace_back(middle + right * point.x() + up * point.y());
    return disc;
}

} // namespace

/// The faces of a part, in the robot's frame. Round ones are regular prisms of the circle's area
/// (cylinderSides); a sphere, seen as a disc from anywhere, is the disc that a camera at this position
/// sees.
std::vector<SolidFace> facesOf(const RobotPart &part, const Eigen::Vector3d &cameraInRobot)
{
    if (part.shape == SimulatedShape::Sphere)
        return {discOf(part, cameraInRobot)};
    if (part.shape == SimulatedShape::Wheel) // its outline runs in the plane of x and z
        return prism(circle(part.sizeM.x(), wheelSides),
                     [&part](const Eigen::Vector2d &point, int end) -> Eigen::Vector3d {
                         return part.centreM +
                                Eigen::Vector3d(point.x(), (0.5 - end) * part.sizeM.y(), point.y());
                     });
    return prism(outlineFromAbove(part), [&part](const Eigen::Vector2d &point, int end) {
        return Eigen::Vector3d(point.x(), point.y(), end == 0 ? part.lower().z() : part.upper().z());
    });
}

std::vector<Eigen::Vector2d> outlineFromAbove(const RobotPart &part)
{
    const bool isRound = part.shape == SimulatedShape::Cylinder || part.shape == SimulatedShape::Sphere;
    std::vector<Eigen::Vector2d> outline =
        isRound ? circle(part.sizeM.x(), cylinderSides) : rectangle(part.sizeM.x(), part.sizeM.y());
    for (Eigen::Vector2d &point : outline)
        point += part.centreM.head<2>();
    return outline;
}

namespace {

std::vector<RobotPart> partsOf(const SimulatedRobot &robot)
{
    if (!robot.parts.empty())
        return robot.parts;
    return {{robot.shape,
             robot.colour,
             {0, 0, robot.heightM / 2},
             {robot.lengthM, robot.shape == SimulatedShape::Cylinder ? robot.lengthM : robot.widthM,
              robot.heightM}}};
}

std::vector<Eigen::Vector2d> grown(const std::vector<Eigen::Vector2d> &outline, double marginM)
{
    constexpr int arcSteps = 4;
    std::vector<Eigen::Vector2d> result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d &corner = outline[i];
        const Eigen::Vector2d in = corner - outline[(i + outline.size() - 1) % outline.size()];
        const Eigen::Vector2d out = outline[(i + 1) % outline.size()] - corner;
        const double from = std::atan2(-in.x(), in.y()),
                     turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        const int steps = outline.size() > 8 ? 0 : arcSteps;
        for (int k = 0; k <= steps; ++k) {
            const double angle = from + (steps > 0 ? turn * k / steps : turn / 2);
            result.emplace_back(corner + marginM * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    return result;
}

/// From the robot's frame to the world's.
RigidTransform worldFromRobot(const MotionState &state)
{
    return {Eigen::Quaterniond(Eigen::AngleAxisd(state.headingRad, Eigen::Vector3d::UnitZ())),
            {state.position.x(), state.position.y(), 0}};
}

/// Daylight from one side of the room, and a good deal from everywhere; little from below.
float shadeOf(const Eigen::Vector3d &normalInWorld)
{
    constexpr double below = 0.4;
    const Eigen::Vector2d light = Eigen::Vector2d(-0.5, -0.85).normalized();
    const Eigen::Vector2d across = normalInWorld.head<2>();
    const double up = normalInWorld.z();
    if (across.norm() < 1e-9)
        return up > 0 ? 1.f : static_cast<float>(below);
    const double side = 0.66 + 0.12 * across.normalized().dot(light);
    return static_cast<float>(std::lerp(side, up > 0 ? 1.0 : below, up * up));
}

/// Directions from a camera as points of a plane before it: flat pieces stay flat, and what is convex stays
/// convex.
class Sight
{
public:
    Sight(const Eigen::Vector3d &camera, const Eigen::Vector3d &towards) : m_camera(camera)
    {
        m_ahead = (towards - camera).normalized();
        m_right = m_ahead.cross(Eigen::Vector3d::UnitZ()).normalized();
        m_up = m_right.cross(m_ahead);
    }

    ConvexPolygon of(const std::vector<Eigen::Vector3d> &corners) const
    {
        ConvexPolygon polygon;
        for (const Eigen::Vector3d &corner : corners) {
            const Eigen::Vector3d away = corner - m_camera;
            polygon.emplace_back(Eigen::Vector2d(m_right.dot(away), m_up.dot(away)) / m_ahead.dot(away));
        }
        return polygon;
    }
    /// A part of a flat face, back on it. Of one that is seen from its edge rounding must not lead beyond it.
    std::vector<Eigen::Vector3d> onFace(const ConvexPolygon &polygon, const SolidFace &face) const
    {
        double least = std::numeric_limits<double>::max(), most = 0;
        for (const Eigen::Vector3d &corner : face.corners) {
            least = std::min(least, m_ahead.dot(corner - m_camera));
            most = std::max(most, m_ahead.dot(corner - m_camera));
        }
        const double away = face.normal.dot(face.corners.front() - m_camera);
        std::vector<Eigen::Vector3d> corners;
        for (const Eigen::Vector2d &point : polygon) {
            const Eigen::Vector3d along = m_ahead + point.x() * m_right + point.y() * m_up;
            const double depth = away / face.normal.dot(along);
            corners.emplace_back(m_camera + (depth >= least ? std::min(depth, most) : least) * along);
        }
        return corners;
    }

private:
    Eigen::Vector3d m_camera, m_ahead, m_right, m_up;
};

/// What of a polygon lies outside all others.
std::vector<ConvexPolygon> leftOf(const ConvexPolygon &polygon, const std::vector<ConvexPolygon> &others)
{
    std::vector<ConvexPolygon> pieces{polygon};
    for (const ConvexPolygon &other : others) {
        std::vector<ConvexPolygon> left;
        for (const ConvexPolygon &piece : pieces)
            std::ranges::move(outsideOf(other, piece), std::back_inserter(left));
        pieces = std::move(left);
    }
    return pieces;
}

/// What is left of a face behind what is nearer. One that is not hidden stays as it is.
std::vector<std::vector<Eigen::Vector3d>>
visiblePieces(const SolidFace &face, const std::vector<ConvexPolygon> &nearer, const Sight &sight)
{
    const ConvexPolygon whole = sight.of(face.corners);
    const std::vector<ConvexPolygon> pieces = leftOf(whole, nearer);
    if (pieces.size() == 1 && pieces.front() == whole)
        return {face.corners};
    std::vector<std::vector<Eigen::Vector3d>> corners;
    for (const ConvexPolygon &piece : pieces)
        corners.push_back(sight.onFace(piece, face));
    return corners;
}

/// Whether a part surely hides nothing of another one: a plane along the robot's axes parts them, and the
/// camera is on the other's side.
bool hidesNothingOf(const RobotPart &part, const RobotPart &other, const Eigen::Vector3d &camera)
{
    constexpr double touching = 1e-9;
    for (int axis = 0; axis < 3; ++axis) {
        if (other.lower()[axis] >= part.upper()[axis] - touching && camera[axis] >= other.lower()[axis])
            return true;
        if (other.upper()[axis] <= part.lower()[axis] + touching && camera[axis] <= other.upper()[axis])
            return true;
    }
    return false;
}

std::vector<RobotPart> nearestFirst(std::vector<RobotPart> parts, const Eigen::Vector3d &camera)
{
    std::vector<RobotPart> sorted;
    while (!parts.empty()) {
        auto next = std::find_if(parts.begin(), parts.end(), [&](const RobotPart &part) {
            return std::all_of(parts.begin(), parts.end(), [&](const RobotPart &other) {
                return &other == &part || hidesNothingOf(other, part, camera);
            });
        });
        if (next == parts.end())
            next = std::min_element(parts.begin(), parts.end(), [&](const RobotPart &a, const RobotPart &b) {
                return (a.centreM - camera).norm() < (b.centreM - camera).norm();
            });
        sorted.push_back(*next);
        parts.erase(next);
    }
    return sorted;
}

} // namespace

std::vector<BodyFace> visibleFaces(const SimulatedRobot &robot, const MotionState &state,
                                   const Eigen::Vector3d &cameraInWorld)
{
    const RigidTransform toWorld = worldFromRobot(state);
    const Eigen::Vector3d camera = toWorld.inverse() * cameraInWorld;
    const std::vector<RobotPart> parts = nearestFirst(partsOf(robot), camera);
    const Sight sight(camera, {0, 0, robot.heightM / 2});
    std::vector<ConvexPolygon> nearer; ///< the outlines of the parts before
    std::vector<BodyFace> faces;
    for (const RobotPart &part : parts) {
        std::vector<Eigen::Vector3d> all;
        for (const SolidFace &face : facesOf(part, camera)) {
            all.insert(all.end(), face.corners.begin(), face.corners.end());
            if (!face.isSeenFrom(camera))
                continue;
            const Rgb colour = toRgb(part.colour) * shadeOf(toWorld.rotation * face.normal);
            for (std::vector<Eigen::Vector3d> &corners : visiblePieces(face, nearer, sight)) {
                for (Eigen::Vector3d &corner : corners)
                    corner = toWorld * corner;
                faces.push_back({std::move(corners), colour});
            }
        }
        nearer.push_back(convexHull(sight.of(all)));
    }
    return faces;
}

std::vector<BodyFace> mirroredFaces(const SimulatedRobot &robot, const MotionState &state,
                                    const Eigen::Vector3d &cameraInWorld)
{
    const auto mirror = [](Eigen::Vector3d &point) { point.z() = -point.z(); };
    Eigen::Vector3d camera = cameraInWorld;
    mirror(camera); // which sees of the robot what the camera sees of the image
    std::vector<BodyFace> faces = visibleFaces(robot, state, camera);
    for (BodyFace &face : faces)
        std::ranges::for_each(face.corners, mirror);
    return faces;
}

std::vector<std::vector<Eigen::Vector3d>> castShadow(const SimulatedRobot &robot, const MotionState &state,
                                                     const Eigen::Vector3d &lightInWorld)
{
    const RigidTransform toWorld = worldFromRobot(state);
    const Eigen::Vector3d light = toWorld.inverse() * lightInWorld;
    std::vector<ConvexPolygon> shadows, pieces;
    for (const RobotPart &part : partsOf(robot)) {
        if (part.upper().z() >= light.z())
            continue;
        std::vector<Eigen::Vector2d> points;
        for (const SolidFace &face : facesOf(part, light))
            for (const Eigen::Vector3d &corner : face.corners)
                points.emplace_back(light.head<2>() +
                                    (corner - light).head<2>() * (light.z() / (light.z() - corner.z())));
        const ConvexPolygon shadow = convexHull(std::move(points));
        std::ranges::copy(leftOf(shadow, shadows), std::back_inserter(pieces));
        shadows.push_back(shadow);
    }
    std::vector<std::vector<Eigen::Vector3d>> onFloor;
    for (const ConvexPolygon &piece : pieces) {
        std::vector<Eigen::Vector3d> &corners = onFloor.emplace_back();
        for (const Eigen::Vector2d &point : piece)
            corners.push_back(toWorld * Eigen::Vector3d(point.x(), point.y(), 0));
    }
    return onFloor;
}

std::vector<Eigen::Vector3d> footprint(const SimulatedRobot &robot, const MotionState &state, double marginM)
{
    std::vector<Eigen::Vector2d> outline;
    for (const RobotPart &part : partsOf(robot)) {
        const std::vector<Eigen::Vector2d> own = outlineFromAbove(part);
        outline.insert(outline.end(), own.begin(), own.end());
    }
    const RigidTransform toWorld = worldFromRobot(state);
    std::vector<Eigen::Vector3d> result;
    for (const Eigen::Vector2d &point : grown(convexHull(std::move(outline)), marginM))
        result.push_back(toWorld * Eigen::Vector3d(point.x(), point.y(), 0));
    return result;
}

} // namespace odo
