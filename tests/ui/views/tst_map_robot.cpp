// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QTest>
#include <cmath>
#include <numbers>

using namespace odo;

namespace {

const QColor robotColour(0, 114, 178);

/// A robot of 300 × 200 mm.
RobotRecord sizedRobot()
{
    RobotRecord robot;
    robot.lengthM = 0.3;
    robot.widthM = 0.2;
    return robot;
}

struct Map
{
    MapPlan plan;
    QImage image{400, 400, QImage::Format_RGB32};

    explicit Map(const MapRobot &robot)
    {
        plan.size = image.size();
        image.fill(Qt::gray);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        drawMapRobot(painter, plan, robot, palette());
    }
    static QPalette palette() { return {QColor(240, 240, 240)}; }
    QColor at(const Eigen::Vector2d &point) const
    {
        return image.pixelColor(plan.fromWorld(point).toPoint());
    }
    /// The lines may lie between two pixels, which then have a little of what is beside them.
    bool hasCross(const Eigen::Vector2d &point) const
    {
        const QColor text = ThemeColours::of(palette()).text;
        return apart(at(point), text) < 0.3 * apart(robotColour, text);
    }
    static int apart(const QColor &a, const QColor &b)
    {
        return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
    }
    bool hasRobot(const Eigen::Vector2d &point) const { return at(point) == robotColour; }
    bool isEmpty(const Eigen::Vector2d &point) const { return at(point) == QColor(Qt::gray); }
};

} // namespace

class TestMapRobot : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theFootprintLiesAroundTheCentre()
    {
        const RobotRecord record = sizedRobot();
        const Map map({&record, {0.5, 0.5}, 0, 0, 0.0, robotColour, {}});
        QVERIFY(map.hasRobot({0.5, 0.5}) && !map.hasCross({0.5, 0.5}));
        QVERIFY(map.hasRobot({0.37, 0.42}) && map.hasRobot({0.63, 0.58}));
        QVERIFY(map.isEmpty({0.32, 0.5}) && map.isEmpty({0.5, 0.63}));
    }

    void aMovedPointHasACrossAndTheFootprintLiesBesideIt_data()
    {
        QTest::addColumn<double>("heading");
        for (const int degrees : {0, 90, 180, 215})
            QTest::addRow("%d", degrees) << degrees * std::numbers::pi / 180;
    }

    void aMovedPointHasACrossAndTheFootprintLiesBesideIt()
    {
        QFETCH(double, heading);
        const RobotRecord record = sizedRobot();
        const Eigen::Vector2d point(0.5, 0.5), reference(0.12, 0.05);
        MapRobot robot{&record, point, 0, 0, heading, robotColour, {}};
        robot.referenceM = reference;
        const Map map(robot);
        const Eigen::Rotation2Dd turn(heading);
        const auto onRobot = [&](double forward, double left) {
            return Eigen::Vector2d(point + turn * (Eigen::Vector2d(forward, left) - reference));
        };
        QVERIFY(map.hasCross(point));
        for (const auto &[forward, left] :
             {std::pair(0.0, 0.0), {-0.13, -0.08}, {-0.13, 0.08}, {0.13, -0.08}})
            QVERIFY2(map.hasRobot(onRobot(forward, left)),
                     qPrintable(QStringLiteral("%1 %2").arg(forward).arg(left)));
        for (const auto &[forward, left] : {std::pair(-0.18, 0.0), {0.0, 0.13}, {0.0, -0.13}})
            QVERIFY2(map.isEmpty(onRobot(forward, left)),
                     qPrintable(QStringLiteral("%1 %2").arg(forward).arg(left)));
    }

    void withoutAHeadingOrASizeTheDotItselfHasTheCross()
    {
        const RobotRecord sized = sizedRobot(), unsized;
        for (const auto &[record, heading] :
             {std::pair(&sized, std::optional<double>()), {&unsized, std::optional(0.0)}}) {
            MapRobot robot{record, {0.5, 0.5}, 0, 0, heading, robotColour, {}};
            robot.referenceM = {0.2, 0};
            const Map map(robot);
            QVERIFY(map.hasCross({0.5, 0.5}));
            QVERIFY(map.isEmpty({0.3, 0.5}));
        }
    }

    void aPictureOfTheFootprintSaysItsSize()
    {
        RobotFootprint footprint;
        QCOMPARE(footprint.words(), QStringLiteral("No size given. Drawn as 220 × 160 mm"));
        footprint.setRobot(sizedRobot());
        QCOMPARE(footprint.words(), QStringLiteral("300 × 200 mm"));
        RobotRecord half = sizedRobot();
        half.widthM.reset();
        half.referenceM = {2, -2}; // far beside it: all of it is seen still
        footprint.setRobot(half);
        QCOMPARE(footprint.words(), QStringLiteral("No size given. Drawn as 220 × 160 mm"));
        footprint.resize(footprint.sizeHint());
        QVERIFY(!footprint.grab().isNull());
    }
};

ODOGRAPH_TEST(TestMapRobot, QApplication)
#include "tst_map_robot.moc"
