// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/marker_assignment.h"
#include "core/calibration/internal/round_markers.h"
#include "core/calibration/marker_detection.h"
#include "tests/calibration/tagged_floors.h"
#include "tests/support/contains.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <algorithm>
#include <ctime>
#include <random>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

/// What kind of field: how its dots lie.
enum class Field { Grid, Triangles, Measured };

int dotScenes()
{
    const int asked = qEnvironmentVariableIntValue("ODOGRAPH_DOT_FIELDS");
    return asked > 0 ? asked : 3;
}

/// 69 dots 300 mm apart: in rows with one corner left open, in rows that are shifted, or anywhere.
std::vector<Vector2d> fieldOf(Field field, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<Vector2d> places;
    if (field == Field::Measured) {
        while (places.size() < 69) {
            const Vector2d place(3.0 * share(random), 2.2 * share(random));
            if (std::ranges::all_of(places, [&](const Vector2d &p) { return (p - place).norm() > 0.2; }))
                places.push_back(place);
        }
        return places;
    }
    for (int row = 0; row < 7; ++row) {
        for (int column = 0; column < 10; ++column) {
            const double shift = field == Field::Triangles && row % 2 == 1 ? 0.15 : 0;
            places.emplace_back(0.3 * column + shift, 0.3 * row);
        }
    }
    places.pop_back();
    return places;
}

MarkerLayout labelled(const std::vector<Vector2d> &places)
{
    MarkerLayout layout{"dots", {}};
    for (const Vector2d &place : places)
        layout.markers.push_back({"P" + std::to_string(layout.markers.size() + 1), place});
    return layout;
}

/// A camera of that lens above the field, from some side; its lens bends the image's corners by some 30 px.
FloorView viewOf(const std::vector<Vector2d> &places, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    Vector2d middle = Vector2d::Zero();
    for (const Vector2d &place : places)
        middle += place / double(places.size());
    const MarkerLayout layout = labelled(places);
    static constexpr int sizes[][2] = {{1280, 720}, {1920, 1080}, {1024, 768}};
    for (;;) {
        const auto &size = sizes[random() % 3];
        const double direction = 2 * std::acos(-1.0) * share(random), away = 0.4 + 2.2 * share(random);
        const Eigen::Vector3d position(middle.x() + away * std::cos(direction),
                                       middle.y() + away * std::sin(direction), 1.8 + 1.8 * share(random));
        const FloorView view = simulatedView(position, {middle.x(), middle.y(), 0}, size[0], size[1],
                                             size[0] * (0.45 + 0.3 * share(random)));
        if (!markersIn(view, layout, 25).empty())
            return view;
    }
}

/// The field with some dots hidden and some others that are in no layout.
TaggedFloor floorOf(const std::vector<Vector2d> &places, std::size_t hidden, std::size_t others,
                    std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    TaggedFloor floor;
    floor.seed = seed;
    floor.blurPx = 0.3 + 0.5 * share(random);
    floor.darkest = 0.4 + 0.6 * share(random);
    const double radiusM = 0.035 + 0.015 * share(random);
    std::vector<Vector2d> shown = places;
    std::ranges::shuffle(shown, random);
    shown.resize(shown.size() - hidden);
    for (const Vector2d &place : shown)
        floor.dots.push_back({place, radiusM});
    while (floor.dots.size() < shown.size() + others) {
        const Vector2d place(-0.2 + 3.2 * share(random), -0.2 + 2.4 * share(random));
        if (std::ranges::all_of(floor.dots,
                                [&](const DrawnDot &dot) { return (dot.middle - place).norm() > 0.11; }))
            floor.dots.push_back({place, radiusM * (0.7 + 0.6 * share(random))});
    }
    return floor;
}

/// How many have another's pixel.
int wrongOf(const std::vector<MarkerPixel> &found, const FloorView &view, const MarkerLayout &layout)
{
    return int(std::ranges::count_if(found, [&](const MarkerPixel &marker) {
        const Vector2d point = std::ranges::find(layout.markers, marker.label, &Marker::label)->pointInWorld;
        return (marker.pixel - *view.pixelFromWorld({point.x(), point.y(), 0})).norm() > 2;
    }));
}

QByteArray saidOf(const Result<std::vector<MarkerPixel>> &found)
{
    return found ? QByteArray::number(qsizetype(found->size())) + " found"
                 : QByteArray::fromStdString(found.error().message());
}

/// Shapes of no size at exact pixels, in another order.
std::vector<RoundMarker> dotsAt(const FloorView &view, const std::vector<Vector2d> &places)
{
    std::vector<RoundMarker> shapes;
    for (const Vector2d &place : places) {
        const Vector2d pixel = *view.pixelFromWorld({place.x(), place.y(), 0});
        shapes.push_back({RoundMarker::Kind::Dot, pixel, 0.05, {pixel, {0, 0}, 0}});
    }
    std::ranges::reverse(shapes);
    return shapes;
}

} // namespace

class TestDotFields : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void dotsAreNamedByTheirNeighbours_data()
    {
        QTest::addColumn<int>("field");
        QTest::addColumn<int>("hidden");
        QTest::addColumn<int>("others");
        QTest::newRow("a grid with an open corner, all there") << int(Field::Grid) << 0 << 0;
        QTest::newRow("shifted rows, some hidden") << int(Field::Triangles) << 8 << 4;
        QTest::newRow("measured, all there") << int(Field::Measured) << 0 << 0;
        QTest::newRow("measured, some hidden, some others") << int(Field::Measured) << 9 << 12;
        QTest::newRow("measured, a third hidden") << int(Field::Measured) << 23 << 5;
    }
    void dotsAreNamedByTheirNeighbours()
    {
        QFETCH(int, field);
        QFETCH(int, hidden);
        QFETCH(int, others);
        int good = 0, wrong = 0, asked = 0;
        double slowest = 0; // seconds of the processor
        for (int scene = 0; scene < dotScenes(); ++scene) {
            const auto seed = std::uint32_t(1000 * field + 100 * hidden + scene);
            const auto places = fieldOf(Field(field), seed);
            const MarkerLayout layout = labelled(places);
            const FloorView view = viewOf(places, seed);
            const Frame frame =
                drawTaggedFloor(view, floorOf(places, std::size_t(hidden), std::size_t(others), seed));
            const bool known = scene % 2 == 1;
            const CameraModel assumed =
                CameraModel::assumed(view.camera().intrinsics().widthPx, view.camera().intrinsics().heightPx);
            const auto shapes = findRoundMarkers(frame);
            const std::clock_t before = std::clock();
            const auto found = assignMarkers(shapes, layout, known ? view.camera() : assumed, known);
            slowest = std::max(slowest, double(std::clock() - before) / CLOCKS_PER_SEC);
            const int bad = found ? wrongOf(*found, view, layout) : 0;
            wrong += bad > 0;
            asked += !found && contains(found.error().message(), "mark by hand");
            if (found && bad == 0 && int(found->size()) >= 0.8 * std::min(69 - hidden, int(shapes.size())))
                ++good;
            else
                qInfo("scene %d (%s): %d shapes, %s, %d wrong", scene, known ? "lens" : "no lens",
                      int(shapes.size()), saidOf(found).constData(), bad);
        }
        qInfo("%d of %d good, %d asked, %d wrong, slowest %.2f s", good, dotScenes(), asked, wrong, slowest);
        QCOMPARE(wrong, 0);
        QVERIFY(good + asked >= 0.9 * dotScenes() - 1); // a third hidden: one in fourteen is refused
        QVERIFY(slowest < 2.0 * slowness);
    }
    void aSymmetricGridAsksForOneDot()
    {
        auto places = fieldOf(Field::Grid, 1);
        places.emplace_back(2.7, 1.8);
        const MarkerLayout layout = labelled(places);
        const FloorView view = viewOf(places, 7);
        const auto shapes = dotsAt(view, places);
        const auto unsure = assignMarkers(shapes, layout, view.camera(), true);
        QVERIFY2(!unsure && contains(unsure.error().message(), "in 2 ways"), saidOf(unsure).constData());
        QVERIFY(contains(unsure.error().message(), "mark by hand which of them is"));
        const MarkerPixel told{"P1", *view.pixelFromWorld({0, 0, 0}) + Vector2d(4, -3)};
        const auto sure = assignMarkers(shapes, layout, view.camera(), true, {told});
        QVERIFY2(sure && sure->size() == 70, saidOf(sure).constData());
        QCOMPARE(wrongOf(*sure, view, layout), 0);
    }
    void aGridOfWhichARowIsHiddenAsksForOneDot()
    {
        const auto places = fieldOf(Field::Grid, 1);
        const MarkerLayout layout = labelled(places);
        const FloorView view = viewOf(places, 8);
        const std::vector<Vector2d> seen(places.begin() + 10, places.end());
        const auto unsure = assignMarkers(dotsAt(view, seen), layout, view.camera(), true);
        QVERIFY2(!unsure || wrongOf(*unsure, view, layout) == 0, saidOf(unsure).constData());
    }
    void aGridThatGoesOnAsksForOneDot()
    {
        // The floor has more rows than the layout.
        const auto places = fieldOf(Field::Grid, 1);
        std::vector<Vector2d> part;
        for (const Vector2d &place : places) {
            if (place.x() < 2.0 && place.y() < 1.4)
                part.push_back(place);
        }
        const MarkerLayout layout = labelled(part);
        const FloorView view = viewOf(places, 9);
        const auto unsure = assignMarkers(dotsAt(view, places), layout, view.camera(), true);
        QVERIFY2(!unsure && contains(unsure.error().message(), "mark by hand"), saidOf(unsure).constData());
    }
    void otherDotsFitNowhere()
    {
        const auto layout = labelled(fieldOf(Field::Measured, 3));
        int wrong = 0;
        for (int scene = 0; scene < 4 * dotScenes(); ++scene) {
            const auto others = fieldOf(Field::Measured, std::uint32_t(100 + scene));
            const FloorView view = viewOf(others, std::uint32_t(200 + scene));
            const auto found = assignMarkers(
                dotsAt(view, others), layout,
                CameraModel::assumed(view.camera().intrinsics().widthPx, view.camera().intrinsics().heightPx),
                false);
            if (found || !contains(found.error().message(), "fits the layout"))
                ++wrong, qInfo("scene %d: %s", scene, saidOf(found).constData());
        }
        QCOMPARE(wrong, 0);
    }
    void seenInAMirrorTheyFitNowhere()
    {
        const auto places = fieldOf(Field::Measured, 5);
        const FloorView view = viewOf(places, 11);
        auto shapes = dotsAt(view, places);
        for (RoundMarker &shape : shapes)
            shape.centrePx.x() = view.camera().intrinsics().widthPx - shape.centrePx.x();
        const auto found = assignMarkers(shapes, labelled(places), view.camera(), true);
        QVERIFY2(!found && contains(found.error().message(), "fits the layout"), saidOf(found).constData());
    }
    void foundInAnImage()
    {
        const auto places = fieldOf(Field::Measured, 6);
        const MarkerLayout layout = labelled(places);
        const FloorView view = viewOf(places, 12);
        const auto found = findMarkers(drawTaggedFloor(view, floorOf(places, 5, 5, 6)), layout);
        QVERIFY2(found && found->size() >= 60, saidOf(found).constData());
        QCOMPARE(wrongOf(*found, view, layout), 0);
    }
};

ODOGRAPH_TEST(TestDotFields, QCoreApplication)
#include "tst_dot_fields.moc"
