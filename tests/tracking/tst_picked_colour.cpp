// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/tracking/chroma.h"
#include "core/tracking/colour_tracker.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace odo;

namespace {

constexpr RgbColour wood{176, 148, 112}, red{215, 35, 40}, blue{31, 111, 208};

SimulatedScene sceneWith(RgbColour robotColour, RgbColour floorColour)
{
    SimulatedScene scene = demoTestbed(4);
    scene.durationS = 0.2;
    scene.floor.colour = floorColour;
    SimulatedRobot robot;
    robot.name = std::string("r");
    robot.colour = robotColour;
    robot.motion = makeLineMotion({1.5, 1.1}, {1.6, 1.1}, 0, 5);
    scene.robots.push_back(robot);
    // Blue tape beside it, in reach of the frame around the box.
    scene.floor.patches.push_back({blue, {{1.1, 0.85}, {1.9, 0.85}, {1.9, 0.89}, {1.1, 0.89}}});
    return scene;
}

/// A box round the pictures of points about a place of the floor.
PixelRect boxAbout(const SimulatedScene &scene, const Eigen::Vector2d &position, double reachM)
{
    PixelRect box{10000, 10000, 0, 0};
    for (const double dx : {-reachM, reachM}) {
        for (const double dy : {-reachM, reachM}) {
            const auto pixel =
                scene.cameras[0].view.pixelFromWorld({position.x() + dx, position.y() + dy, 0});
            box = {std::min(box.x0, int(pixel->x())), std::min(box.y0, int(pixel->y())),
                   std::max(box.x1, int(pixel->x())), std::max(box.y1, int(pixel->y()))};
        }
    }
    return box;
}

} // namespace

/// The colour of a robot that a box was drawn round, against that which it was rendered in.
class TestPickedColour : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aCodedColourComesBack()
    {
        for (const bool fullRange : {false, true}) {
            for (const YuvMatrix matrix : {YuvMatrix::Bt601, YuvMatrix::Bt709}) {
                FrameFormat format;
                format.fullRange = fullRange;
                format.matrix = matrix;
                for (const RgbColour colour :
                     {red, blue, wood, RgbColour{0, 0, 0}, RgbColour{255, 255, 255}}) {
                    const double kr = matrix == YuvMatrix::Bt709 ? 0.2126 : 0.299,
                                 kb = matrix == YuvMatrix::Bt709 ? 0.0722 : 0.114;
                    const double luma = kr * colour.red + (1 - kr - kb) * colour.green + kb * colour.blue;
                    const double coded = fullRange ? luma : 16 + luma * 219 / 255;
                    QCOMPARE(
                        QString::fromStdString(colourOf(coded, chromaOf(colour, format), format).toString()),
                        QString::fromStdString(colour.toString()));
                }
            }
        }
    }

    void theRobotsColourIsFound_data()
    {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("floor");
        QTest::addColumn<double>("reachM");
        const QString grey = QStringLiteral("#b6b1a6"), wooden = QStringLiteral("#b09470");
        for (const double reachM :
             {0.13, 0.2, 0.3}) { // close, loose, and far too large: 0.26 m × 0.19 m in 0.6 m
            const QByteArray size = QByteArray::number(reachM);
            QTest::newRow("red " + size) << "#d72328" << grey << reachM;
            QTest::newRow("blue, with tape of its colour near " + size) << "#1f6fd0" << grey << reachM;
            QTest::newRow("green " + size) << "#1f9d4d" << grey << reachM;
            QTest::newRow("pale yellow " + size) << "#d8cc80" << grey << reachM;
            QTest::newRow("red on wood " + size) << "#d72328" << wooden << reachM;
            QTest::newRow("violet on wood " + size) << "#7040a0" << wooden << reachM;
        }
    }
    void theRobotsColourIsFound()
    {
        QFETCH(QString, robot);
        QFETCH(QString, floor);
        QFETCH(double, reachM);
        const RgbColour truth = *parseColour(robot.toStdString());
        const SimulatedScene scene = sceneWith(truth, *parseColour(floor.toStdString()));
        const Frame frame = SceneRenderer(scene, 0).render(0);
        const auto picked = pickColour(frame, boxAbout(scene, {1.5, 1.1}, reachM));
        QVERIFY2(picked.has_value(), picked ? "" : picked.error().message().c_str());
        const Chroma seen = chromaOf(picked->colour, frame.format), given = chromaOf(truth, frame.format);
        const double turn =
            std::abs(std::atan2(seen.x() * given.y() - seen.y() * given.x(), seen.dot(given)));
        qInfo("%s: %s, %.1f degrees, %.2f times as saturated, %.0f %% of the box", qPrintable(robot),
              picked->colour.toString().c_str(), turn * 180 / std::numbers::pi, seen.norm() / given.norm(),
              100 * picked->share);
        // The tracker allows 11° (1σ) and 0.6 to 1.5 times the saturation: well within, shaded sides and
        // edges included.
        QVERIFY(turn < 6 * std::numbers::pi / 180);
        QVERIFY(seen.norm() > 0.7 * given.norm() && seen.norm() < 1.2 * given.norm());

        auto tracker = ColourTracker::create({{"r", picked->colour}});
        QVERIFY(tracker.has_value());
        const Observation observation = (*tracker)->track(frame).front();
        const auto position = scene.cameras[0].view.pixelFromWorld({1.5, 1.1, 0.03});
        QVERIFY(observation.found && (observation.ellipse.centrePx - *position).norm() < 6);
    }

    void whatHoldsNoColourIsRefused_data()
    {
        QTest::addColumn<QString>("robot");
        QTest::addColumn<QString>("floor");
        QTest::addColumn<double>("x");
        QTest::addColumn<QString>("said");
        const QString nothing = QStringLiteral(
            "colour in the box: it contains no colour that differs from the floor around it; draw it "
            "closely round the robot, or put a plate of another colour on it");
        QTest::newRow("the floor alone") << "#d72328"
                                         << "#b6b1a6" << 0.6 << nothing;
        QTest::newRow("a wooden floor alone") << "#d72328"
                                              << "#b09470" << 0.6 << nothing;
        QTest::newRow("a robot of the floor's colour") << "#b09470"
                                                       << "#b09470" << 1.5 << nothing;
        QTest::newRow("a black robot on wood")
            << "#202020"
            << "#b09470" << 1.5
            << "colour in the box: the robot in it is grey, black or white; add the robot "
               "without a colour; background subtraction then finds it";
    }
    void whatHoldsNoColourIsRefused()
    {
        QFETCH(QString, robot);
        QFETCH(QString, floor);
        QFETCH(double, x);
        QFETCH(QString, said);
        const SimulatedScene scene =
            sceneWith(*parseColour(robot.toStdString()), *parseColour(floor.toStdString()));
        const auto picked = pickColour(SceneRenderer(scene, 0).render(0), boxAbout(scene, {x, 1.1}, 0.18));
        QVERIFY2(!picked, picked ? picked->colour.toString().c_str() : "");
        QCOMPARE(picked.error().code, ErrorCode::Undetermined);
        QCOMPARE(QString::fromStdString(picked.error().message()), said);
    }

    void aBoxThatCannotBeUsedIsRefused()
    {
        const Frame frame = SceneRenderer(sceneWith(red, wood), 0).render(0);
        for (const PixelRect box :
             {PixelRect{100, 100, 105, 140}, PixelRect{100, 100, 90, 90}, PixelRect{2000, 100, 2100, 200}})
            QCOMPARE(QString::fromStdString(pickColour(frame, box).error().message()),
                     QStringLiteral("colour in the box: the box is too small or outside the image; draw "
                                    "it round the robot, at "
                                    "least 8 pixels wide and high"));
        QCOMPARE(QString::fromStdString(pickColour(frame, {-10, -10, 5000, 5000}).error().message()),
                 QStringLiteral("colour in the box: the box leaves no floor around it to compare with; "
                                "draw it closely round the "
                                "robot"));
    }
};

ODOGRAPH_TEST(TestPickedColour, QCoreApplication)
#include "tst_picked_colour.moc"
