// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/exposure.h"

#include "core/simulation/internal/robot_body.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {
namespace {

constexpr double subStepPx = 0.5;
constexpr int mostSubSteps = 48;

/// The share of [from, from + length] that lies in the exposure.
double shareOfExposure(double timeS, double exposureS, double fromS, double lengthS)
{
    if (exposureS <= 0)
        return timeS >= fromS && timeS < fromS + lengthS ? 1.0 : 0.0;
    const double start = std::max(fromS, timeS - exposureS / 2),
                 end = std::min(fromS + lengthS, timeS + exposureS / 2);
    return std::clamp((end - start) / exposureS, 0.0, 1.0);
}

class Exposure
{
public:
    Exposure(const SimulatedScene &scene, int camera, const ImageOutline &outline, double timeS)
        : m_scene(scene), m_camera(camera), m_view(scene.cameras[static_cast<std::size_t>(camera)].view),
          m_exposureS(scene.cameras[static_cast<std::size_t>(camera)].sensor.exposureS),
          m_readoutS(scene.cameras[static_cast<std::size_t>(camera)].sensor.readoutS), m_outline(outline),
          m_timeS(timeS)
    {
    }

    std::vector<PaintedThing> things() const
    {
        std::vector<PaintedThing> result;
        for (const LocalLight &light : m_scene.localLights)
            keep(localLightThing(light), result);
        for (const Reflection &reflection : m_scene.reflections)
            if (reflection.camera < 0 || reflection.camera == m_camera)
                keep(reflectionThing(reflection), result);
        for (const SimulatedRobot *body : bodies()) {
            keep(mirrorThing(*body), result);
            keep(shadowThing(*body), result);
            for (const Lamp &lamp : m_scene.lamps)
                keep(castShadowThing(*body, lamp), result);
        }
        for (const Standing &standing : farthestFirst())
            keep(standing.robot ? robotThing(*standing.robot) : occluderThing(*standing.occluder), result);
        return result;
    }

private:
    /// One upright thing on the floor: a robot, a bystander or an occluder.
    struct Standing
    {
        const SimulatedRobot *robot = nullptr;
        const Occluder *occluder = nullptr;
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    };

    /// Robots and bystanders.
    std::vector<const SimulatedRobot *> bodies() const
    {
        std::vector<const SimulatedRobot *> all;
        for (const auto *some : {&m_scene.robots, &m_scene.bystanders})
            for (const SimulatedRobot &body : *some)
                all.push_back(&body);
        return all;
    }

    void keep(PaintedThing thing, std::vector<PaintedThing> &result) const
    {
        if (thing.pieces.empty())
            return;
        thing.bounds = boundsOf(thing.pieces.front().outline);
        for (const PaintedPiece &piece : thing.pieces)
            thing.bounds = thing.bounds.united(boundsOf(piece.outline));
        thing.bounds = thing.bounds.clipped(m_outline.imageRect());
        if (!thing.bounds.isEmpty())
            result.push_back(std::move(thing));
    }

    void addPiece(PaintedThing &thing, std::span<const Eigen::Vector3d> corners, const Rgb &colour,
                  double weight) const
    {
        std::vector<Eigen::Vector2d> outline = m_outline.of(corners);
        if (outline.size() >= 3)
            thing.pieces.push_back({std::move(outline), colour, weight});
    }

    PaintedThing reflectionThing(const Reflection &reflection) const
    {
        PaintedThing thing;
        const double share = shareOfExposure(m_timeS, m_exposureS, reflection.startS, reflection.durationS);
        if (share <= 0)
            return thing;
        addPiece(thing, discOnFloor(reflection.position, reflection.radiusM), toRgb(reflection.colour),
                 share);
        return thing;
    }

    PaintedThing localLightThing(const LocalLight &light) const
    {
        constexpr int rings = 24; // whose opacities add up to the middle's
        PaintedThing thing;
        const double share = std::clamp((m_timeS - light.startS) / light.rampS, 0.0, 1.0);
        for (int i = 0; i < rings && share > 0; ++i)
            addPiece(thing, discOnFloor(light.position, light.radiusM * (i + 1) / rings),
                     light.strength > 0 ? Rgb(255, 255, 255, 0) : Rgb(Rgb::Zero()),
                     share * std::abs(light.strength) / rings);
        return thing;
    }

    static std::vector<Eigen::Vector3d> discOnFloor(const Eigen::Vector2d &middle, double radiusM)
    {
        constexpr int corners = 48;
        std::vector<Eigen::Vector3d> disc;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * std::numbers::pi * i / corners;
            disc.emplace_back(middle.x() + radiusM * std::cos(angle), middle.y() + radiusM * std::sin(angle),
                              0.0);
        }
        return disc;
    }

    /// How much later than the frame's middle a rolling shutter sees a point.
    double rowDelayS(const Eigen::Vector3d &point) const
    {
        const auto pixel = m_readoutS > 0 ? m_view.pixelFromWorld(point) : std::nullopt;
        const int rows = m_view.camera().intrinsics().heightPx;
        return pixel ? m_readoutS * (std::clamp(pixel->y() / (rows - 1), 0.0, 1.0) - 0.5) : 0;
    }

    /// When a rolling shutter sees a body's middle.
    double seenAtS(const SimulatedRobot &robot) const
    {
        const Eigen::Vector2d middle = robot.motion->at(m_timeS).position;
        return m_timeS + rowDelayS({middle.x(), middle.y(), robot.heightM / 2});
    }

    /// Where a rolling shutter sees a point of a body that is here at a time near seenAtS: right to first
    /// order.
    Eigen::Vector3d rolled(const Eigen::Vector3d &point, const Eigen::Vector2d &velocity,
                           double bodySeenAtS) const
    {
        if (m_readoutS <= 0)
            return point;
        const double laterS = m_timeS + rowDelayS(point) - bodySeenAtS;
        return {point.x() + laterS * velocity.x(), point.y() + laterS * velocity.y(), point.z()};
    }

    /// The moments at which a moving robot is painted: so many that it moves half a pixel from one to the
    /// next, each in the middle of its part of the exposure, so that the mean is right to second order.
    std::vector<double> subSteps(const SimulatedRobot &robot, double middleS) const
    {
        const MotionState start = robot.motion->at(middleS - m_exposureS / 2);
        const MotionState end = robot.motion->at(middleS + m_exposureS / 2);
        const auto pixelOf = [this, &robot](const MotionState &state) {
            return m_view.pixelFromWorld({state.position.x(), state.position.y(), robot.heightM / 2});
        };
        const auto from = pixelOf(start), to = pixelOf(end);
        if (m_exposureS <= 0 || !from || !to)
            return {middleS};
        const double turnPx =
            std::abs(std::remainder(end.headingRad - start.headingRad, 2 * std::numbers::pi)) * 50;
        const double distancePx = (*to - *from).norm() + turnPx;
        const int count = std::clamp(static_cast<int>(std::ceil(distancePx / subStepPx)), 1, mostSubSteps);
        std::vector<double> times;
        for (int i = 0; i < count; ++i)
            times.push_back(middleS + m_exposureS * ((i + 0.5) / count - 0.5));
        return times;
    }

    PaintedThing shadowThing(const SimulatedRobot &robot) const
    {
        // Nested outlines whose opacities add up: dark at the foot, fading out over a third of the height.
        constexpr int rings = 6;
        constexpr double highestM = 0.3;
        PaintedThing thing;
        if (m_scene.floor.shadowStrength <= 0)
            return thing;
        const MotionState state = robot.motion->at(seenAtS(robot));
        for (int i = 0; i < rings; ++i)
            addPiece(thing,
                     footprint(robot, state, std::min(robot.heightM, highestM) * 0.4 * (i + 0.5) / rings),
                     Rgb::Zero(), m_scene.floor.shadowStrength / rings);
        return thing;
    }

    /// The lamp as points of light, which together make its soft shadow.
    PaintedThing castShadowThing(const SimulatedRobot &robot, const Lamp &lamp) const
    {
        constexpr int points = 12;
        PaintedThing thing;
        const MotionState state = robot.motion->at(seenAtS(robot));
        for (int i = 0; i < points; ++i) {
            // Evenly spread over the disc (H. Vogel 1979).
            const double radius = lamp.radiusM * std::sqrt((i + 0.5) / points),
                         angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
            const Eigen::Vector3d light =
                lamp.positionM + Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
            for (const std::vector<Eigen::Vector3d> &piece : castShadow(robot, state, light))
                addPiece(thing, piece, Rgb::Zero(), lamp.strength / points);
        }
        return thing;
    }

    PaintedThing mirrorThing(const SimulatedRobot &robot) const
    {
        PaintedThing thing;
        if (m_scene.floor.gloss > 0)
            addFaces(thing, robot, mirroredFaces, m_scene.floor.gloss);
        return thing;
    }

    PaintedThing robotThing(const SimulatedRobot &robot) const
    {
        PaintedThing thing;
        addFaces(thing, robot, visibleFaces, 1.0);
        return thing;
    }

    void addFaces(PaintedThing &thing, const SimulatedRobot &robot,
                  std::vector<BodyFace> (*facesOf)(const SimulatedRobot &, const MotionState &,
                                                   const Eigen::Vector3d &),
                  double weight) const
    {
        const double seenS = seenAtS(robot);
        const MotionState seen = robot.motion->at(seenS);
        // What hides what hardly changes while a body moves by its blur: it is found once, and moved.
        const std::vector<BodyFace> faces = facesOf(robot, seen, m_view.cameraInWorld());
        const std::vector<double> times = subSteps(robot, seenS);
        std::vector<Eigen::Vector3d> moved;
        for (const double time : times) {
            const MotionState state = robot.motion->at(time);
            const Eigen::Rotation2Dd turn(state.headingRad - seen.headingRad);
            for (const BodyFace &face : faces) {
                moved = face.corners;
                for (Eigen::Vector3d &corner : moved) {
                    corner.head<2>() = state.position + turn * (corner.head<2>() - seen.position);
                    corner = rolled(corner, state.velocity, seenS);
                }
                addPiece(thing, moved, face.colour, weight / static_cast<double>(times.size()));
            }
        }
    }

    PaintedThing occluderThing(const Occluder &occluder) const
    {
        PaintedThing thing;
        const double share = shareOfExposure(m_timeS, m_exposureS, occluder.startS, occluder.durationS);
        if (share <= 0)
            return thing;
        const Eigen::Vector2d &a = occluder.from, &b = occluder.to;
        const std::vector<Eigen::Vector3d> board = {{a.x(), a.y(), 0},
                                                    {b.x(), b.y(), 0},
                                                    {b.x(), b.y(), occluder.heightM},
                                                    {a.x(), a.y(), occluder.heightM}};
        addPiece(thing, board, toRgb(occluder.colour), share);
        return thing;
    }

    double distance(const Standing &standing) const
    {
        return (standing.middle - m_view.cameraInWorld().head<2>()).norm();
    }

    /// Whether a must be painted after b. A robot and a board: by the side of the board that the robot is on.
    bool isBefore(const Standing &a, const Standing &b) const
    {
        if ((a.occluder != nullptr) == (b.occluder != nullptr))
            return distance(a) < distance(b);
        if (b.occluder)
            return !isBefore(b, a);
        const Eigen::Vector2d along = a.occluder->to - a.occluder->from;
        const Eigen::Vector2d normal(-along.y(), along.x());
        const Eigen::Vector2d camera = m_view.cameraInWorld().head<2>();
        return normal.dot(camera - a.middle) * normal.dot(b.middle - a.middle) < 0;
    }

    std::vector<Standing> farthestFirst() const
    {
        std::vector<Standing> left, sorted;
        for (const SimulatedRobot *body : bodies())
            left.push_back({body, nullptr, body->motion->at(m_timeS).position});
        for (const Occluder &occluder : m_scene.occluders)
            left.push_back({nullptr, &occluder, (occluder.from + occluder.to) / 2});
        while (!left.empty()) {
            // "Before" is no total order once boards are there: take one that hides nothing of what is left.
            auto next = std::find_if(left.begin(), left.end(), [&](const Standing &candidate) {
                return std::none_of(left.begin(), left.end(), [&](const Standing &other) {
                    return &other != &candidate && isBefore(candidate, other);
                });
            });
            if (next == left.end())
                next =
                    std::max_element(left.begin(), left.end(), [this](const Standing &a, const Standing &b) {
                        return distance(a) < distance(b);
                    });
            sorted.push_back(*next);
            left.erase(next);
        }
        return sorted;
    }

    const SimulatedScene &m_scene;
    const int m_camera;
    const FloorView &m_view;
    const double m_exposureS, m_readoutS;
    const ImageOutline &m_outline;
    const double m_timeS;
};

} // namespace

std::vector<PaintedThing> thingsInExposure(const SimulatedScene &scene, int camera,
                                           const ImageOutline &outline, double timeS)
{
    return Exposure(scene, camera, outline, timeS).things();
}

double lightInExposure(const std::vector<LightChange> &lights, double exposureS, double timeS)
{
    double gain = 1;
    for (const LightChange &light : lights)
        gain *= 1 + (light.gain - 1) * shareOfExposure(timeS, exposureS, light.startS, light.durationS);
    return gain;
}

double gainInExposure(const SensorModel &sensor, double timeS)
{
    // The mean of a sine over the exposure is the sine at its middle times sin(x)/x.
    const double x = std::numbers::pi * sensor.flickerHz * sensor.exposureS;
    const double smoothing = std::abs(x) < 1e-9 ? 1.0 : std::sin(x) / x;
    const double flicker =
        sensor.flickerAmplitude * smoothing * std::sin(2 * std::numbers::pi * sensor.flickerHz * timeS);
    return (1.0 + sensor.gainDriftPerS * timeS) * (1.0 + flicker);
}

} // namespace odo
