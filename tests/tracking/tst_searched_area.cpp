// SPDX-License-Identifier: GPL-3.0-or-later
// What a person says that the tracker shall ignore is no evidence, for either kind of tracking; and a mark of
// the robot is worth more than what the tracker chose.
#include "core/tracking/internal/searched_mask.h"
#include "core/tracking/robot_tracker.h"
#include "tests/support/registered_test.h"
#include "tests/tracking/textured_floor.h"
#include "tests/tracking/tracked_robots.h"

#include <QTest>

using namespace odo;
using namespace odo::test;
using Eigen::Vector2d;

namespace {

const FrameFormat format = testFormat(480, 360);
constexpr RgbColour black{28, 28, 28};

PixelPolygon rectangle(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Background emptyFloor(const Painter &floor)
{
    std::mt19937 random(1);
    BackgroundLearner learner;
    for (int i = 0; i < 24; ++i) {
        Painter image = floor;
        image.rectangle({18.0 * i, 20}, {18.0 * i + 30, 50}, {30, 30, 30});
        learner.add(image.frame(i, i / 10.0, 2, random));
    }
    return *learner.learned();
}

/// The robot goes along the middle, and something larger of its look along the lower edge.
Vector2d robotAt(int frame)
{
    return {60 + 4.0 * frame, 120};
}
Vector2d strangerAt(int frame)
{
    return {420 - 4.0 * frame, 300};
}

Frame filmedBoth(const Painter &floor, int frame, RgbColour colour, std::mt19937 &random)
{
    Painter image = floor;
    const Vector2d half(20, 14), larger(32, 22), at = robotAt(frame), other = strangerAt(frame);
    image.rectangle(at - half, at + half, colour);
    image.rectangle(other - larger, other + larger, colour);
    return image.frame(frame, frame / 30.0, 2, random);
}

bool isAt(const Observation &seen, const Vector2d &position)
{
    return seen.found && (seen.ellipse.centrePx - position).norm() < 2;
}

} // namespace

class TestSearchedArea : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void insideIsByEvenOdd()
    {
        const PixelPolygon polygon{{0, 0}, {10, 0}, {10, 10}, {5, 4}, {0, 10}};
        QVERIFY(isWithin(polygon, {2, 2}));
        QVERIFY(isWithin(polygon, {9, 8}));
        QVERIFY(!isWithin(polygon, {5, 8})); // in the notch
        QVERIFY(!isWithin(polygon, {-1, 5}));
        QVERIFY(!isWithin({}, {0, 0}));
        QVERIFY(!isWithin({{0, 0}, {9, 9}}, {4, 4}));
    }

    void aNoteSaysTheAreas()
    {
        SearchedArea area;
        QCOMPARE(noteOf(area), std::string());
        area.ignored = {rectangle(1, 2, 30.25, 4)};
        area.search = {rectangle(0, 0, 100, 50)};
        const std::string note = noteOf(area);
        QCOMPARE(note, std::string("; searched in 0.0,0.0 100.0,0.0 100.0,50.0 0.0,50.0; ignoring 1.0,2.0 "
                                   "30.2,2.0 30.2,4.0 1.0,4.0"));
        QCOMPARE(areaNoteIn("silhouette 1" + note + "; camera moved 3.00 px after 5 ns"), note);
        QCOMPARE(areaNoteIn("silhouette 1; camera moved 3.00 px after 5 ns"), std::string());
    }

    void samplesAreSearchedByTheirPosition()
    {
        SearchedArea area;
        area.search = {rectangle(10, 10, 30, 20)};
        area.ignored = {rectangle(20, 0, 40, 40)};
        const BitMask pixels = searchedSamples(area, {40, 40});
        QCOMPARE(pixels.count(), 10 * 10);
        QVERIFY(pixels.at(10, 10) && pixels.at(19, 19) && !pixels.at(20, 15) && !pixels.at(9, 15));
        const BitMask chroma = searchedSamples(area, {20, 20, {0, 0.5}, {2, 2}});
        QCOMPARE(chroma.count(), 5 * 5);
        BitMask region(3, 3);
        region.set(1, 1);
        QVERIFY(isCutBy(pixels, region, 18, 14)); // beside what is ignored
        QVERIFY(!isCutBy(pixels, region, 13, 13));
        QVERIFY(!isCutBy(BitMask(40, 40).complement(), region, -1, -1)); // the frame's edge is no such
    }

    void whatIsIgnoredIsNotFollowed_data()
    {
        QTest::addColumn<bool>("isByColour");
        QTest::addColumn<bool>("isBySearch");
        QTest::newRow("silhouettes, ignored") << false << false;
        QTest::newRow("silhouettes, searched") << false << true;
        QTest::newRow("colour, ignored") << true << false;
        QTest::newRow("colour, searched") << true << true;
    }
    void whatIsIgnoredIsNotFollowed()
    {
        QFETCH(bool, isByColour);
        QFETCH(bool, isBySearch);
        const Painter floor = texturedFloor(format);
        const RgbColour colour = isByColour ? red : black;
        const TrackTarget target{"r", isByColour ? std::optional(red) : std::nullopt};
        SearchedArea area;
        if (isBySearch)
            area.search = {rectangle(0, 60, 480, 200)};
        else
            area.ignored = {rectangle(-10, 240, 490, 370)};
        const auto found = [&](const SearchedArea &searched) {
            const auto tracker = RobotTracker::create({target}, emptyFloor(floor), {}, 0, searched);
            std::mt19937 random(3);
            int right = 0;
            for (int i = 0; i < 40; ++i)
                right += isAt((*tracker)->track(filmedBoth(floor, i, colour, random)).front(), robotAt(i));
            return right;
        };
        QCOMPARE(found({}), 0); // the larger one
        QVERIFY2(found(area) >= 39, qPrintable(QString::number(found(area))));
    }

    void whatIsCutByAnAreaIsSaid_data()
    {
        QTest::addColumn<bool>("isByColour");
        QTest::newRow("silhouettes") << false;
        QTest::newRow("colour") << true;
    }
    void whatIsCutByAnAreaIsSaid()
    {
        QFETCH(bool, isByColour);
        const Painter floor = texturedFloor(format);
        const TrackTarget target{"r", isByColour ? std::optional(red) : std::nullopt};
        SearchedArea area;
        area.ignored = {rectangle(200, 0, 300, 200), rectangle(0, 240, 480, 360)};
        const auto tracker = RobotTracker::create({target}, emptyFloor(floor), {}, 0, area);
        std::mt19937 random(4);
        int cut = 0;
        for (int i = 0; i < 46; ++i) {
            const Observation seen =
                (*tracker)->track(filmedBoth(floor, i, isByColour ? red : black, random)).front();
            const double right = robotAt(i).x() + 20;
            if (right < 196)
                QVERIFY2(seen.found && !seen.touchesBorder, qPrintable(QString::number(i)));
            if (seen.found && right > 202 && robotAt(i).x() < 215) {
                QVERIFY2(seen.touchesBorder, qPrintable(QString::number(i)));
                ++cut;
            }
        }
        QVERIFY2(cut > 3, qPrintable(QString::number(cut)));
    }

    void aMarkWinsOverTheLarger_data() { whatIsCutByAnAreaIsSaid_data(); }
    void aMarkWinsOverTheLarger()
    {
        QFETCH(bool, isByColour);
        const Painter floor = texturedFloor(format);
        const TrackTarget target{"r", isByColour ? std::optional(red) : std::nullopt};
        const auto tracker = RobotTracker::create({target}, emptyFloor(floor));
        std::mt19937 random(5);
        constexpr int marked = 15;
        for (int i = 0; i < 40; ++i) {
            const Frame frame = filmedBoth(floor, i, isByColour ? red : black, random);
            std::vector<RobotSeed> seeds;
            if (i == marked)
                seeds.push_back({0, robotAt(i) + Vector2d(9, -5)});
            if (i == marked + 5) // where nothing is it has no effect
                seeds.push_back({0, Vector2d(5, 200)});
            const Observation seen = (*tracker)->track(frame, seeds).front();
            QVERIFY2(isAt(seen, i < marked ? strangerAt(i) : robotAt(i)), qPrintable(QString::number(i)));
        }
    }

    /// Two robots, and the mark is where the tracker follows the other: that one lets go.
    void aMarkTakesFromAnotherRobot()
    {
        const Painter floor = texturedFloor(format);
        const auto tracker = RobotTracker::create({{"a", {}}, {"b", {}}}, emptyFloor(floor));
        std::mt19937 random(6);
        for (int i = 0; i < 50; ++i) {
            const Frame frame = filmedBoth(floor, i, black, random);
            std::vector<RobotSeed> seeds;
            if (i == 10)
                seeds = {{0, robotAt(i)}, {1, strangerAt(i)}};
            const auto seen = (*tracker)->track(frame, seeds);
            QVERIFY2(isAt(seen[0], i < 10 ? strangerAt(i) : robotAt(i)), qPrintable(QString::number(i)));
            QVERIFY2(isAt(seen[1], i < 10 ? robotAt(i) : strangerAt(i)), qPrintable(QString::number(i)));
        }
    }
};

ODOGRAPH_TEST(TestSearchedArea, QCoreApplication)
#include "tst_searched_area.moc"
