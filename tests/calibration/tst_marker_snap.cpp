// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/marker_detection.h"
#include "tests/calibration/floor_views.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

using Kind = SnappedMarker::Kind;
constexpr double tapeM = 0.05;

FloorPatch strip(const Vector2d &from, const Vector2d &to, RgbColour colour)
{
    const Vector2d along = (to - from).normalized(), across = 0.5 * tapeM * Vector2d(-along.y(), along.x());
    return {colour, {from - across, to - across, to + across, from + across}};
}

struct Tape
{
    Vector2d point; ///< what is meant
    std::vector<FloorPatch> patches;
};

Tape cross(const Vector2d &middle, double turnRad, RgbColour colour)
{
    const Vector2d a = 0.15 * Vector2d(std::cos(turnRad), std::sin(turnRad)), b(-a.y(), a.x());
    return {middle, {strip(middle - a, middle + a, colour), strip(middle - b, middle + b, colour)}};
}

/// Two strips that meet at a right angle; the outer corner is meant.
Tape angle(const Vector2d &corner, double turnRad, RgbColour colour)
{
    const Vector2d x(std::cos(turnRad), std::sin(turnRad)), y(-x.y(), x.x());
    const Vector2d middle = corner + 0.5 * tapeM * (x + y);
    return {corner,
            {strip(middle - 0.5 * tapeM * x, middle + 0.25 * x, colour),
             strip(middle - 0.5 * tapeM * y, middle + 0.25 * y, colour)}};
}

Frame drawn(const FloorView &view, const std::vector<FloorPatch> &patches, double noise, std::uint32_t seed)
{
    SimulatedScene scene;
    scene.seed = scene.floor.textureSeed = seed;
    scene.durationS = 0.1;
    scene.floor.patches = patches;
    scene.floor.tileM = 5; // no joints between tiles beside the tape
    scene.cameras = {{"A", view, 30, 0, 0, {}, 0}};
    scene.cameras[0].sensor.noiseSigma = noise;
    return SceneRenderer(scene, 0).render(0);
}

} // namespace

class TestMarkerSnap : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void findsWhatWasClicked_data()
    {
        QTest::addColumn<MarkerShape>("shape");
        QTest::addColumn<int>("kind");
        QTest::newRow("tags") << MarkerShape::Tag << int(Kind::Tag);
        QTest::newRow("rings") << MarkerShape::Ring << int(Kind::Ring);
        QTest::newRow("dots") << MarkerShape::Dot << int(Kind::Dot);
    }
    void findsWhatWasClicked()
    {
        QFETCH(MarkerShape, shape);
        QFETCH(int, kind);
        const MarkerLayout layout{"floor",
                                  {{"O", {0, 0}}, {"U", {2.4, 0}}, {"V", {0, 1.8}}, {"D", {2.7, 2.0}}}};
        const DrawnView view = drawFloorView(layout, shape, 0.16, 1002);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> off(-4, 4);
        for (const MarkerPixel &marker : view.truth) {
            const auto snapped = snapToMarker(view.frame, marker.pixel + Vector2d(off(random), off(random)));
            QCOMPARE(int(snapped.kind), kind);
            // A dot's ellipse is not corrected for perspective yet.
            QVERIFY2((snapped.pixel - marker.pixel).norm() < (shape == MarkerShape::Dot ? 0.6 : 0.2),
                     qPrintable(QString::number((snapped.pixel - marker.pixel).norm())));
            QVERIFY(snapped.sigmaPx > 0 && snapped.sigmaPx < 0.2);
        }
    }
    void findsTape_data()
    {
        QTest::addColumn<bool>("isCross");
        QTest::addColumn<bool>("isDark");
        QTest::newRow("white crosses") << true << false;
        QTest::newRow("black crosses") << true << true;
        QTest::newRow("white angles") << false << false;
        QTest::newRow("black angles") << false << true;
    }
    void findsTape()
    {
        QFETCH(bool, isCross);
        QFETCH(bool, isDark);
        const RgbColour colour = isDark ? RgbColour{40, 40, 44} : RgbColour{245, 245, 240};
        const FloorView view = simulatedView({-0.9, -1.55, 2.0}, {1.4, 0.9, 0.0}, 1280, 720, 960);
        std::mt19937 random(11);
        std::uniform_real_distribution<double> share(0, 1), off(-5, 5);
        int good = 0, tried = 0;
        double squares = 0;
        for (std::uint32_t image = 0; image < 4; ++image) {
            std::vector<Tape> tapes;
            std::vector<FloorPatch> patches;
            for (int i = 0; i < 6; ++i) {
                const Vector2d position(0.3 + 1.0 * (i % 3), 0.4 + 1.1 * (i / 3));
                const double turn = 2 * EIGEN_PI * share(random);
                tapes.push_back(isCross ? cross(position, turn, colour) : angle(position, turn, colour));
                patches.insert(patches.end(), tapes.back().patches.begin(), tapes.back().patches.end());
            }
            const Frame frame = drawn(view, patches, 1 + image, 40 + image);
            for (const Tape &tape : tapes) {
                const Vector2d truth = *view.pixelFromWorld({tape.point.x(), tape.point.y(), 0});
                if (truth.x() < 40 || truth.y() < 40 || truth.x() > 1240 || truth.y() > 680)
                    continue;
                // Beside the cross anywhere; from an angle's corner outwards, as one clicks who means it.
                const auto snapped =
                    snapToMarker(frame, truth + (isCross ? 1.0 : 0.5) * Vector2d(off(random), off(random)));
                const double error = (snapped.pixel - truth).norm();
                ++tried;
                const bool isGood =
                    snapped.kind == (isCross ? Kind::TapeCrossing : Kind::TapeCorner) && error < 0.5;
                good += isGood;
                if (isGood)
                    squares += error * error;
                else
                    qInfo("picture %u at %.0f, %.0f: kind %d, %.2f px off", image, truth.x(), truth.y(),
                          int(snapped.kind), error);
            }
        }
        qInfo("%d of %d, %.3f px RMS", good, tried, std::sqrt(squares / good));
        QVERIFY(good >= 0.9 * tried);
        // The floor's grain beside the tape tilts its edges by a tenth of a pixel or two.
        QVERIFY(std::sqrt(squares / good) < (isCross ? 0.1 : 0.25));
    }
    void findsASaddle()
    {
        const FloorView view = simulatedView({-0.9, -1.55, 2.0}, {1.4, 0.9, 0.0}, 1280, 720, 960);
        const Vector2d at(1.3, 0.8);
        const RgbColour black{30, 30, 30};
        const Frame frame =
            drawn(view,
                  {{RgbColour{235, 235, 235}, {{1.0, 0.5}, {1.6, 0.5}, {1.6, 1.1}, {1.0, 1.1}}},
                   {black, {{1.1, 0.6}, {1.3, 0.6}, {1.3, 0.8}, {1.1, 0.8}}},
                   {black, {{1.3, 0.8}, {1.5, 0.8}, {1.5, 1.0}, {1.3, 1.0}}}},
                  2, 5);
        const Vector2d truth = *view.pixelFromWorld({at.x(), at.y(), 0});
        const auto snapped = snapToMarker(frame, truth + Vector2d(3, -4));
        QCOMPARE(int(snapped.kind), int(Kind::Saddle));
        QVERIFY((snapped.pixel - truth).norm() < 0.2);
    }
    void onAnEmptyFloorTheClickStays()
    {
        const FloorView view = simulatedView({-0.9, -1.55, 2.0}, {1.4, 0.9, 0.0}, 1280, 720, 960);
        const Frame frame = drawn(view, {}, 2, 6);
        int moved = 0;
        for (const Vector2d &click :
             {Vector2d(500, 400), Vector2d(700, 300), Vector2d(640, 500), Vector2d(800, 450)}) {
            const auto snapped = snapToMarker(frame, click);
            moved += snapped.kind != Kind::None;
            if (snapped.kind == Kind::None)
                QCOMPARE(snapped.pixel, click);
            else
                qInfo("kind %d at %.1f, %.1f", int(snapped.kind), snapped.pixel.x(), snapped.pixel.y());
        }
        QCOMPARE(moved, 0);
        QCOMPARE(int(snapToMarker(frame, {-5, 3}).kind), int(Kind::None));
        QCOMPARE(int(snapToMarker(frame, {std::nan(""), 3}).kind), int(Kind::None));
    }
};

ODOGRAPH_TEST(TestMarkerSnap, QCoreApplication)
#include "tst_marker_snap.moc"
