// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/tracking/colour_tracker.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QtTest>
#include <cstring>

using namespace odo;
using Eigen::Vector2d;

namespace {

/// Gives all of a picture, and counts how often it had to, or fails like one with damaged data.
class CountedFrame : public CodedImage
{
public:
    CountedFrame(Frame whole, int &count, bool damaged)
        : m_whole(std::move(whole)), m_count(count), m_damaged(damaged)
    {
    }
    Result<Frame> decodeWhole() const override
    {
        ++m_count;
        if (m_damaged)
            return test::saidFailure(ErrorCode::InvalidInput, "cannot decode", "damaged", "nothing");
        return m_whole;
    }

private:
    const Frame m_whole;
    int &m_count;
    const bool m_damaged;
};

void copyPart(const PlaneView &from, const PixelRect &part, int shiftX, int shiftY, std::uint8_t *to,
              int stride)
{
    for (int y = part.y0 >> shiftY; y < (part.y1 + (1 << shiftY) - 1) >> shiftY; ++y)
        for (int x = part.x0 >> shiftX; x < (part.x1 + (1 << shiftX) - 1) >> shiftX; ++x)
            to[y * stride + x] = from.at(x, y);
}

/// No more than the region, to the pixel; what lies outside is noise that differs from frame to frame.
Frame partOf(const Frame &whole, const PixelRect &region, int &completions, bool damaged = false)
{
    auto buffer = std::make_shared<FrameBuffer>(whole.format);
    auto state = static_cast<std::uint32_t>(whole.index + 1);
    const auto fill = [&state](std::uint8_t *row, int width) {
        for (int x = 0; x < width; ++x) {
            state = state * 1664525U + 1013904223U;
            row[x] = static_cast<std::uint8_t>(state >> 24);
        }
    };
    for (int y = 0; y < whole.format.height; ++y)
        fill(buffer->yRow(y), whole.format.width);
    for (int y = 0; y < buffer->chromaHeight(); ++y) {
        fill(buffer->uRow(y), buffer->chromaWidth());
        fill(buffer->vRow(y), buffer->chromaWidth());
    }
    const PixelRect part = region.clipped({0, 0, whole.format.width, whole.format.height});
    copyPart(whole.y, part, 0, 0, buffer->yRow(0), whole.format.width);
    copyPart(whole.u, part, 1, 1, buffer->uRow(0), buffer->chromaWidth());
    copyPart(whole.v, part, 1, 1, buffer->vRow(0), buffer->chromaWidth());
    Frame frame = FrameBuffer::toFrame(std::move(buffer), whole.index, whole.time);
    frame.validRegion = part;
    frame.coded = std::make_shared<CountedFrame>(whole, completions, damaged);
    return frame;
}

bool areEqual(const Observation &a, const Observation &b)
{
    return a.frame == b.frame && a.time == b.time && a.found == b.found &&
           a.duplicateFrame == b.duplicateFrame &&
           (!a.found ||
            (a.ellipse.centrePx == b.ellipse.centrePx && a.ellipse.semiMajorPx == b.ellipse.semiMajorPx &&
             a.ellipse.semiMinorPx == b.ellipse.semiMinorPx && a.ellipse.angleRad == b.ellipse.angleRad &&
             a.centreCovariancePx2 == b.centreCovariancePx2 && a.areaPx == b.areaPx && a.score == b.score &&
             a.touchesBorder == b.touchesBorder));
}

/// One to three robots that run, one of them behind a board for a while, with light that drifts, a camera
/// that shows a picture twice and leaves others out.
SimulatedScene eventfulScene(int robots)
{
    SimulatedScene scene = demoTestbed(5);
    scene.durationS = 7;
    const RgbColour colours[] = {{220, 40, 40}, {30, 140, 60}, {40, 80, 210}};
    for (int i = 0; i < robots; ++i) {
        SimulatedRobot robot;
        robot.name = std::to_string(i);
        robot.colour = colours[i];
        robot.motion = makeFigureEightMotion({1.4, 0.5 + 0.6 * i}, 0.8, 0.2, 5.0 + i, 0.5);
        scene.robots.push_back(robot);
    }
    Occluder board;
    board.colour = {120, 120, 120};
    board.from = {0.9, 0.2};
    board.to = {2.0, 0.2};
    board.startS = 2.0;
    board.durationS = 0.7;
    scene.occluders.push_back(board);
    SensorModel &sensor = scene.cameras[0].sensor;
    sensor.gainDriftPerS = 0.05;
    sensor.doubledFrames = {30, 31, 77};
    sensor.droppedFrames = {50, 51, 120};
    return scene;
}

} // namespace

/// Frames of which only the part that the tracker asked for was decoded give the observations of whole
/// frames.
class TestPartialFrames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void sameObservations_data();
    void sameObservations();
    void tooSmallAPartIsCompleted();
    void damagedRestIsNoRobot();
};

void TestPartialFrames::sameObservations_data()
{
    QTest::addColumn<int>("robots");
    QTest::newRow("one") << 1;
    QTest::newRow("three") << 3;
}

void TestPartialFrames::sameObservations()
{
    QFETCH(int, robots);
    const SimulatedScene scene = eventfulScene(robots);
    std::vector<TrackTarget> targets;
    for (const SimulatedRobot &robot : scene.robots)
        targets.push_back({robot.name, robot.colour});
    const auto onWhole = ColourTracker::create(targets), onParts = ColourTracker::create(targets);
    SceneRenderer renderer(scene, 0);
    int parts = 0, completions = 0, duplicates = 0, found = 0;
    double shares = 0;
    for (std::int64_t i = 0; i < renderer.frameCount(); ++i) {
        const Frame whole = renderer.render(i);
        const auto region = (*onParts)->neededRegion(whole.time);
        const auto expected = (*onWhole)->track(whole);
        const auto seen = (*onParts)->track(region ? partOf(whole, *region, completions) : whole);
        for (std::size_t r = 0; r < expected.size(); ++r) {
            QVERIFY2(areEqual(seen[r], expected[r]), qPrintable(QStringLiteral("frame %1").arg(i)));
            found += expected[r].found;
        }
        duplicates += expected.front().duplicateFrame;
        parts += region.has_value();
        if (region)
            shares += double(region->width()) * region->height() / (1280 * 720);
    }
    const auto frames = double(renderer.frameCount());
    QCOMPARE(duplicates, 3);
    QVERIFY(found > 0.8 * frames * robots);
    QVERIFY(parts > 0.75 * frames);
    QVERIFY2(completions < 0.1 * frames, qPrintable(QString::number(completions)));
    if (robots == 1)
        QVERIFY2(shares / parts < 0.06, qPrintable(QString::number(shares / parts)));
}

/// A caller who gives what he likes gets the right answer all the same, only later.
void TestPartialFrames::tooSmallAPartIsCompleted()
{
    const SimulatedScene scene = eventfulScene(1);
    const auto onWhole = ColourTracker::create({{"r", scene.robots[0].colour}}),
               onParts = ColourTracker::create({{"r", scene.robots[0].colour}});
    SceneRenderer renderer(scene, 0);
    int completions = 0;
    for (std::int64_t i = 0; i < 20; ++i) {
        const Frame whole = renderer.render(i);
        const auto expected = (*onWhole)->track(whole).front();
        QVERIFY(expected.found);
        QVERIFY(areEqual((*onParts)->track(partOf(whole, {0, 0, 64, 64}, completions)).front(), expected));
    }
    QCOMPARE(completions, 20);
}

void TestPartialFrames::damagedRestIsNoRobot()
{
    const SimulatedScene scene = eventfulScene(1);
    const auto tracker = ColourTracker::create({{"r", scene.robots[0].colour}});
    SceneRenderer renderer(scene, 0);
    int completions = 0;
    QVERIFY(!(*tracker)->track(partOf(renderer.render(0), {0, 0, 64, 64}, completions, true)).front().found);
    QVERIFY((*tracker)->track(renderer.render(1)).front().found);
    const Frame next = renderer.render(2);
    const auto region = (*tracker)->neededRegion(next.time);
    QVERIFY(region.has_value());
    QVERIFY((*tracker)->track(partOf(next, *region, completions, true)).front().found);
    QCOMPARE(completions, 1);
}

ODOGRAPH_TEST(TestPartialFrames, QCoreApplication)
#include "tst_partial_frames.moc"
