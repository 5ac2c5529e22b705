// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/floor_mat.h"

#include "core/calibration/floor_registration.h"
#include "core/calibration/marker_detection.h"
#include "tests/calibration/tagged_floors.h"
#include "tests/support/registered_test.h"

#include <QTest>
#include <set>

using namespace odo;

namespace {

/// What a mat that is printed at this scale looks like on the floor.
test::TaggedFloor floorWith(const FloorMat &mat)
{
    test::TaggedFloor floor;
    for (const Marker &marker : matLayout(mat).markers)
        floor.tags.push_back({{TagFamily::AprilTag36h11, std::stoi(marker.label)},
                              marker.pointInWorld,
                              mat.scale * matTagM,
                              0});
    return floor;
}

std::vector<Eigen::Vector2d> middles(const test::TaggedFloor &floor)
{
    std::vector<Eigen::Vector2d> all;
    for (const test::DrawnTag &tag : floor.tags)
        all.push_back(tag.middle);
    return all;
}

} // namespace

class TestFloorMat : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void noTwoTagsAreTheSame();
    void tagsKeepTheirWhiteRims_data() { addPapers(); }
    void tagsKeepTheirWhiteRims();
    void isRecognisedAndRegisteredBy_data();
    void isRecognisedAndRegisteredBy();
    void aPartOfItIsRecognised();
    void otherTagsAreNoMat();
    void aTagOfSomethingElseDoesNotCount();
    void matsAreJoined();
    void namesItsScale();

private:
    static void addPapers();
};

void TestFloorMat::addPapers()
{
    QTest::addColumn<FloorMat>("mat");
    QTest::newRow("A4") << FloorMat{FloorMat::Paper::A4, 4, 3};
    QTest::newRow("Letter") << FloorMat{FloorMat::Paper::Letter, 4, 3};
    QTest::newRow("A3") << FloorMat{FloorMat::Paper::A3, 3, 2};
}

void TestFloorMat::noTwoTagsAreTheSame()
{
    std::set<int> numbers;
    std::size_t count = 0;
    for (const auto paper : {FloorMat::Paper::A4, FloorMat::Paper::Letter, FloorMat::Paper::A3}) {
        for (const Marker &marker : matLayout({paper, FloorMat::mostColumns, FloorMat::mostRows}).markers) {
            numbers.insert(std::stoi(marker.label));
            ++count;
        }
    }
    QCOMPARE(numbers.size(), count);
    QVERIFY(*numbers.begin() >= 100); // below are those of a layout's markers by their place in it
    QVERIFY(*numbers.rbegin() < 587); // which the family ends at
}

/// A tag is read by its white rim, of one of its eight cells.
void TestFloorMat::tagsKeepTheirWhiteRims()
{
    QFETCH(const FloorMat, mat);
    const double reach = 0.5 * matTagM * 1.25;
    const Eigen::Vector2d sheet = matSheetM(mat.paper);
    const auto tags = matTags(mat.paper, 0, 0);
    for (std::size_t i = 0; i < tags.size(); ++i) {
        QVERIFY((tags[i].middle.array() >= reach).all());
        QVERIFY((tags[i].middle.array() <= sheet.array() - reach).all());
        QVERIFY(i == 0 || tags[i].middle.x() - tags[i - 1].middle.x() >= 2 * reach);
    }
    // The line by which the print is checked lies below the rims, and within the mat.
    QVERIFY(matLineStartM.y() < tags.front().middle.y() - reach - 0.003);
    QCOMPARE(matLineM(mat), 1.0);
    QVERIFY(matLineStartM.x() + matLineM(mat) < mat.columns * sheet.x());
    QCOMPARE(matLineM({mat.paper, 1, 1}), 0.2);
}

void TestFloorMat::isRecognisedAndRegisteredBy_data()
{
    QTest::addColumn<FloorMat>("mat");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 3; ++seed) {
        QTest::addRow("A4, view %d", seed) << FloorMat{FloorMat::Paper::A4, 4, 3} << seed;
        QTest::addRow("A3, view %d", seed) << FloorMat{FloorMat::Paper::A3, 3, 2} << seed;
    }
    QTest::newRow("Letter") << FloorMat{FloorMat::Paper::Letter, 4, 3} << 10;
    QTest::newRow("A4 at 97 %") << FloorMat{FloorMat::Paper::A4, 4, 3, 0.97} << 4;
}

void TestFloorMat::isRecognisedAndRegisteredBy()
{
    QFETCH(const FloorMat, mat);
    QFETCH(const int, seed);
    const test::TaggedFloor floor = floorWith(mat);
    const FloorView view = test::someView(middles(floor), std::uint32_t(seed));
    const Frame frame = test::drawTaggedFloor(view, floor);
    auto found = findMat(frame);
    QVERIFY(found);
    found->scale = mat.scale; // which only its owner can measure
    QCOMPARE(*found, mat);
    const MarkerLayout layout = matLayout(*found);
    const auto pixels = findMarkers(frame, layout, {view.camera(), true, {}});
    QVERIFY2(pixels, pixels ? "" : pixels.error().message().c_str());
    QVERIFY(pixels->size() + 1 >= layout.markers.size()); // one may be cut by the image's edge
    const auto registration = registerFloor(layout, *pixels, view.camera(), true);
    QVERIFY2(registration, registration ? "" : registration.error().message().c_str());
    // The camera is where it is to a few times what the pixels' noise of some 0.05 px leaves.
    const Eigen::Vector3d off = registration->worldFromCamera.translation - view.cameraInWorld();
    QVERIFY2(off.norm() < 0.005 * view.cameraInWorld().norm(), std::to_string(off.norm()).c_str());
}

void TestFloorMat::aPartOfItIsRecognised()
{
    test::TaggedFloor floor = floorWith({FloorMat::Paper::A4, 4, 3});
    const FloorView view = test::someView(middles(floor), 5);
    floor.tags.erase(floor.tags.begin(), floor.tags.begin() + 3); // the robots' box stands there
    floor.tags.pop_back();                                        // the last one of the upper row
    QCOMPARE(*findMat(test::drawTaggedFloor(view, floor)), (FloorMat{FloorMat::Paper::A4, 4, 3}));
    floor.tags.resize(3);
    QVERIFY(!findMat(test::drawTaggedFloor(view, floor)));
}

/// Markers of one's own with numbers that the mats use, at other positions or of another size.
void TestFloorMat::otherTagsAreNoMat()
{
    test::TaggedFloor floor;
    for (int i = 0; i < 6; ++i)
        floor.tags.push_back({{TagFamily::AprilTag36h11, 100 + i}, {0.4 * (i % 3), 0.5 * (i / 3)}, 0.14, 0});
    QVERIFY(!findMat(test::drawTaggedFloor(test::someView(middles(floor), 6), floor)));
    test::TaggedFloor smaller = floorWith({FloorMat::Paper::A4, 2, 2});
    for (test::DrawnTag &tag : smaller.tags)
        tag.sideM = 0.08;
    QVERIFY(!findMat(test::drawTaggedFloor(test::someView(middles(smaller), 7), smaller)));
    QVERIFY(!findMat(test::drawTaggedFloor(test::someView(middles(floor), 8), {})));
}

void TestFloorMat::aTagOfSomethingElseDoesNotCount()
{
    test::TaggedFloor floor = floorWith({FloorMat::Paper::A4, 3, 2});
    const FloorView view = test::someView(middles(floor), 9);
    floor.tags[5].name.number = 100 + 7 * FloorMat::mostColumns; // which would be far up the mat
    QCOMPARE(*findMat(test::drawTaggedFloor(view, floor)), (FloorMat{FloorMat::Paper::A4, 3, 2}));
}

void TestFloorMat::matsAreJoined()
{
    const FloorMat wide{FloorMat::Paper::A4, 5, 2}, high{FloorMat::Paper::A4, 2, 3};
    QCOMPARE(*joined(wide, high), (FloorMat{FloorMat::Paper::A4, 5, 3}));
    QVERIFY(!joined(wide, {FloorMat::Paper::A3, 3, 2}));
}

void TestFloorMat::namesItsScale()
{
    QCOMPARE(matName({}), std::string("Mat A4 4x3"));
    QCOMPARE(matName({FloorMat::Paper::A3, 3, 2, 0.985}), std::string("Mat A3 3x2, 98.50 %"));
}

ODOGRAPH_TEST(TestFloorMat, QCoreApplication)
#include "tst_floor_mat.moc"
