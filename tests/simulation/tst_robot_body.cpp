// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/robot_body.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <optional>
#include <random>
#include <set>

using namespace odo;

namespace {

using Vector = Eigen::Vector3d;

/// How far along a ray it first meets a part, in the robot's frame; worked out without any polygon.
std::optional<double> hit(const RobotPart &part, const Vector &from, const Vector &along)
{
    // of a·t² + 2b·t + c = 0
    const auto firstOf = [](double a, double b, double c) -> std::optional<std::pair<double, double>> {
        const double d = b * b - a * c;
        if (d <= 0)
            return std::nullopt;
        return std::pair((-b - std::sqrt(d)) / a, (-b + std::sqrt(d)) / a);
    };
    const Vector away = from - part.centreM;
    const double radius = part.sizeM.x() / 2;
    if (part.shape == SimulatedShape::Sphere) {
        const auto found = firstOf(along.dot(along), along.dot(away), away.dot(away) - radius * radius);
        return found ? std::optional(found->first) : std::nullopt;
    }
    // A prism: what lies between the slabs of its axes, of a round one also inside its circle.
    double enters = -1e9, leaves = 1e9;
    const int axis = part.shape == SimulatedShape::Cylinder ? 2
                     : part.shape == SimulatedShape::Wheel  ? 1
                                                            : -1;
    for (int i = 0; i < 3; ++i) {
        if (axis >= 0 && i != axis)
            continue;
        const double a = (-part.sizeM[i] / 2 - away[i]) / along[i],
                     b = (part.sizeM[i] / 2 - away[i]) / along[i];
        enters = std::max(enters, std::min(a, b));
        leaves = std::min(leaves, std::max(a, b));
    }
    if (axis >= 0) {
        Vector across = along, start = away;
        across[axis] = start[axis] = 0;
        const auto found = firstOf(across.dot(across), across.dot(start), start.dot(start) - radius * radius);
        if (!found)
            return std::nullopt;
        enters = std::max(enters, found->first);
        leaves = std::min(leaves, found->second);
    }
    return enters < leaves ? std::optional(enters) : std::nullopt;
}

/// The part that a ray meets first; −1: none.
int metBy(const std::vector<RobotPart> &parts, const Vector &from, const Vector &along)
{
    int met = -1;
    double nearest = 1e9;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (const auto at = hit(parts[i], from, along); at && *at < nearest) {
            nearest = *at;
            met = static_cast<int>(i);
        }
    return met;
}

bool isIn(const BodyFace &face, const Vector &from, const Vector &along)
{
    int left = 0;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const Vector a = face.corners[i] - from, b = face.corners[(i + 1) % face.corners.size()] - from;
        left += a.cross(b).dot(along) > 0;
    }
    return left == 0 || left == static_cast<int>(face.corners.size());
}

SimulatedRobot rover()
{
    SimulatedRobot robot;
    robot.heightM = 0.2;
    const auto add = [&robot](SimulatedShape shape, Vector centre, Vector size) {
        const auto code = static_cast<std::uint8_t>(40 * (robot.parts.size() + 1));
        robot.parts.push_back(
            {shape, {code, static_cast<std::uint8_t>(255 - code), 0}, std::move(centre), std::move(size)});
    };
    add(SimulatedShape::Box, {0, 0, 0.045}, {0.22, 0.14, 0.046});
    add(SimulatedShape::Box, {0.02, 0, 0.08}, {0.1, 0.1, 0.024});
    add(SimulatedShape::Cylinder, {-0.05, 0.03, 0.118}, {0.02, 0.02, 0.1});
    add(SimulatedShape::Wheel, {0.06, 0.09, 0.035}, {0.07, 0.03, 0.07});
    add(SimulatedShape::Wheel, {0.06, -0.09, 0.035}, {0.07, 0.03, 0.07});
    add(SimulatedShape::Sphere, {-0.14, 0, 0.02}, {0.04, 0.04, 0.04});
    return robot;
}

} // namespace

class TestRobotBody : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void ofPartsTheNearestIsSeenAndNoneTwice_data()
    {
        QTest::addColumn<QList<double>>("camera");
        QTest::addColumn<double>("heading");
        QTest::newRow("from before") << QList<double>{2.2, 0.3, 1.9} << 0.0;
        QTest::newRow("from the side") << QList<double>{0.2, -1.6, 1.2} << 0.7;
        QTest::newRow("from behind, low") << QList<double>{-1.9, 0.4, 0.35} << 2.9;
        QTest::newRow("from above") << QList<double>{0.03, -0.04, 2.5} << -1.1;
    }
    void ofPartsTheNearestIsSeenAndNoneTwice()
    {
        QFETCH(QList<double>, camera);
        QFETCH(double, heading);
        const SimulatedRobot robot = rover();
        const Vector from(camera[0], camera[1], camera[2]);
        MotionState state;
        state.position = {0.11, -0.07};
        state.headingRad = heading;
        const std::vector<BodyFace> faces = visibleFaces(robot, state, from);
        const Eigen::AngleAxisd turn(-heading, Vector::UnitZ());
        const Vector origin(state.position.x(), state.position.y(), 0);
        const auto met = [&](const Vector &target) {
            return metBy(robot.parts, turn * (from - origin), turn * (target - from));
        };
        // what is cut lies on the body still, not before it; circles are polygons a little larger
        for (const BodyFace &face : faces) {
            for (const Vector &corner : face.corners) {
                const Vector inRobot = turn * (corner - origin);
                QVERIFY(std::ranges::any_of(robot.parts, [&](const RobotPart &part) {
                    return (inRobot.array() > part.lower().array() - 5e-4).all() &&
                           (inRobot.array() < part.upper().array() + 5e-4).all();
                }));
            }
        }
        std::mt19937 random(5);
        std::uniform_real_distribution<double> position(-0.2, 0.2), height(0, 0.2);
        std::set<int> seen;
        for (int i = 0; i < 20'000; ++i) {
            const Vector target = origin + Vector(position(random), position(random), height(random));
            const int part = met(target);
            constexpr double edge = 3e-4; // of the circles' polygons, and of rounding
            if (met(target + Vector(edge, 0, 0)) != part || met(target - Vector(edge, 0, 0)) != part ||
                met(target + Vector(0, edge, 0)) != part || met(target - Vector(0, edge, 0)) != part ||
                met(target + Vector(0, 0, edge)) != part || met(target - Vector(0, 0, edge)) != part)
                continue;
            std::vector<const BodyFace *> found;
            for (const BodyFace &face : faces)
                if (isIn(face, from, target - from))
                    found.push_back(&face);
            QCOMPARE(found.size(), std::size_t(part < 0 ? 0 : 1));
            if (part < 0)
                continue;
            seen.insert(part);
            // shaded, of the same hue
            const RgbColour &own = robot.parts[static_cast<std::size_t>(part)].colour;
            QVERIFY(std::abs(found.front()->colour[0] * own.green - found.front()->colour[1] * own.red) <
                    1e-2f);
        }
        QVERIFY(seen.size() >= 4);
    }

    /// A ray from the camera to the image meets what the ray from the mirrored camera meets.
    void theImageInTheFloorIsTheBodyFromBelow()
    {
        const SimulatedRobot robot = rover();
        MotionState state;
        state.headingRad = 0.4;
        const Vector camera(1.2, -1.4, 1.6);
        double lowest = 0;
        for (const BodyFace &face : mirroredFaces(robot, state, camera)) {
            for (const Vector &corner : face.corners) {
                const Vector along = corner - camera, onFloor = camera + along * (camera.z() / -along.z());
                QVERIFY(along.z() < 0); // looked at through the floor
                lowest = std::min(lowest, -onFloor.norm());
            }
        }
        QVERIFY(lowest > -0.5); // and it is where the robot stands
    }

    void aShadowLiesWhereTheLightIsHidden()
    {
        const SimulatedRobot robot = rover();
        MotionState state;
        state.position = {0.3, 0.2};
        state.headingRad = 0.9;
        const Vector light(-0.4, 0.8, 1.1), origin(state.position.x(), state.position.y(), 0);
        const auto pieces = castShadow(robot, state, light);
        const Eigen::AngleAxisd turn(-state.headingRad, Vector::UnitZ());
        std::mt19937 random(9);
        std::uniform_real_distribution<double> position(-0.4, 0.4);
        int dark = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Vector point = origin + Vector(position(random), position(random), 0);
            const auto isHidden = [&](const Vector &at) {
                return metBy(robot.parts, turn * (at - origin), turn * (light - at)) >= 0;
            };
            constexpr double edge = 5e-4;
            const bool hidden = isHidden(point);
            if (isHidden(point + Vector(edge, 0, 0)) != hidden ||
                isHidden(point - Vector(edge, 0, 0)) != hidden ||
                isHidden(point + Vector(0, edge, 0)) != hidden ||
                isHidden(point - Vector(0, edge, 0)) != hidden)
                continue;
            const auto found =
                std::count_if(pieces.begin(), pieces.end(), [&](const std::vector<Vector> &piece) {
                    return isIn({piece, {}}, light, point - light);
                });
            QCOMPARE(found, hidden ? 1 : 0);
            dark += hidden;
        }
        QVERIFY(dark > 500);
    }
};

ODOGRAPH_TEST(TestRobotBody, QCoreApplication)
#include "tst_robot_body.moc"
