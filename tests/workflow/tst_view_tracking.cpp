// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/synchronisation/internal/flash_synchronisation.h"
#include "core/tracking/colour_tracker.h"
#include "core/video/video_reader.h"
#include "core/workflow/track/frame_damage.h"
#include "core/workflow/track/view_tracking.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;

/// Decoding MJPEG only where the tracker looks gives, from the file to the stored observation, what decoding
/// all gives.
class TestViewTracking : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void partsGiveWhatTheWholeGives();
    void measuresTheLight_data();
    void measuresTheLight();
    void framesOfTwoMomentsAreTakenByFields();
};

namespace {

/// Even lines of one frame and odd lines of the next.
Frame woven(const Frame &even, const Frame &odd, std::int64_t index)
{
    const auto buffer = std::make_shared<FrameBuffer>(even.format);
    const auto weave = [&](PlaneView Frame::*plane, const auto &row) {
        for (int y = 0; y < (even.*plane).height; ++y)
            std::copy_n(((y % 2 == 0 ? even : odd).*plane).row(y), (even.*plane).width, row(y));
    };
    weave(&Frame::y, [&](int y) { return buffer->yRow(y); });
    weave(&Frame::u, [&](int y) { return buffer->uRow(y); });
    weave(&Frame::v, [&](int y) { return buffer->vRow(y); });
    return FrameBuffer::toFrame(buffer, index, even.time);
}

/// As a program writes an interlaced recording that says nothing of fields, the even lines later if asked.
Result<void> writeWoven(const SimulatedScene &scene, const std::filesystem::path &file, bool isEvenLater)
{
    SceneRenderer renderer(scene, 0);
    std::unique_ptr<VideoWriter> writer;
    for (std::int64_t i = 0; i + 1 < renderer.frameCount(); i += 2) {
        const Frame first = renderer.render(i), second = renderer.render(i + 1);
        Frame both = isEvenLater ? woven(second, first, i / 2) : woven(first, second, i / 2);
        both.time = first.time;
        if (!writer)
            writer = ODO_TRY(VideoWriter::create(file, both.format, {}));
        ODO_TRY(writer->write(both));
    }
    return writer->finish();
}

} // namespace

void TestViewTracking::partsGiveWhatTheWholeGives()
{
    SimulatedScene scene = demoTestbed(8);
    scene.durationS = 5;
    scene.cameras[0].sensor.doubledFrames = {40};
    std::vector<RobotRecord> robots(2);
    std::vector<TrackTarget> targets;
    const RgbColour colours[] = {{215, 35, 40}, {31, 157, 77}};
    for (int i = 0; i < 2; ++i) {
        SimulatedRobot robot;
        robot.name = std::to_string(i);
        robot.colour = colours[i];
        robot.motion = makeFigureEightMotion({1.4, 0.7 + 0.8 * i}, 0.8, 0.2, 4.0 + i, 0.5);
        scene.robots.push_back(robot);
        robots[std::size_t(i)].name = robot.name;
        robots[std::size_t(i)].colour = robot.colour;
        targets.push_back({robot.name, robot.colour});
    }
    const QTemporaryDir folder;
    RegisteredView view;
    view.file = folder.filePath(QStringLiteral("a.mkv")).toStdString();
    VideoWriterOptions options;
    options.codec = VideoCodec::Mjpeg;
    QVERIFY(renderVideo(scene, 0, view.file, options, {}));

    const auto reader = VideoReader::open(view.file);
    QVERIFY(reader.has_value());
    view.recording.frameTimes = (*reader)->info().frameTimes;
    const auto tracked = trackViews({view}, robots, {});
    QVERIFY(tracked.has_value());
    QCOMPARE(damageOf(tracked->front().series[0].observations, view.recording.frameTimes).frames,
             std::int64_t(0));

    const auto tracker = ColourTracker::create(targets);
    int found = 0;
    for (std::size_t i = 0; i < view.recording.frameTimes.size(); ++i) {
        const auto frame = (*reader)->next();
        QVERIFY(frame.has_value() && frame->has_value() && !(*frame)->validRegion);
        const auto expected = (*tracker)->track(**frame);
        for (std::size_t r = 0; r < robots.size(); ++r) {
            const Observation &seen = tracked->front().series[r].observations.at(i);
            QCOMPARE(seen.frame, expected[r].frame);
            QCOMPARE(seen.found, expected[r].found);
            QCOMPARE(seen.duplicateFrame, expected[r].duplicateFrame);
            QCOMPARE(seen.duplicateFrame, i == 40);
            found += seen.found;
            // To the last bit: the samples are the same ones.
            QVERIFY(seen.ellipse.centrePx == expected[r].ellipse.centrePx);
            QVERIFY(seen.centreCovariancePx2 == expected[r].centreCovariancePx2);
            QVERIFY(seen.score == expected[r].score);
        }
    }
    QVERIFY(found > 290);
}

void TestViewTracking::measuresTheLight_data()
{
    // decoded where the robot is, so that there is no whole picture to measure
    QTest::addColumn<bool>("mjpeg");
    QTest::addColumn<bool>("robot");
    QTest::newRow("whole pictures") << false << true;
    QTest::newRow("parts of pictures") << true << true;
    QTest::newRow("no robot") << true << false;
}

void TestViewTracking::measuresTheLight()
{
    QFETCH(bool, mjpeg);
    QFETCH(bool, robot);
    SimulatedScene scene = demoTestbed(8);
    scene.durationS = 3.5;
    scene.cameras[0].sensor.exposureS = 0.02;
    // A lamp for 0.4 s; and the sun comes out, and in the end a dark board is put up in a corner.
    scene.lights = {{1.3, 1.511, 0.4}};
    scene.cameras[0].sensor.gainDriftPerS = 0.1;
    scene.occluders = {{{40, 40, 40}, {-0.3, 0.0}, {0.5, 0.0}, 0.7, 2.5, 1e9}};
    SimulatedRobot red;
    red.name = "red";
    red.colour = {215, 35, 40};
    red.motion = makeFigureEightMotion({1.7, 1.4}, 0.8, 0.3, 4.0, 0.5);
    scene.robots.push_back(red);
    const QTemporaryDir folder;
    RegisteredView view;
    view.file = folder.filePath(QStringLiteral("a.mkv")).toStdString();
    VideoWriterOptions options;
    if (mjpeg)
        options.codec = VideoCodec::Mjpeg;
    QVERIFY(renderVideo(scene, 0, view.file, options, {}));
    const auto reader = VideoReader::open(view.file);
    QVERIFY(reader.has_value());
    view.recording.frameTimes = (*reader)->info().frameTimes;
    std::vector<RobotRecord> robots(1);
    robots[0].name = red.name;
    robots[0].colour = red.colour;
    if (!robot)
        robots.clear();

    QVERIFY(trackViews({view}, robots, {})->front().light.empty()); // only where it is asked for
    const auto tracked = trackViews({view}, robots, {}, WithLight::Measured);
    QVERIFY2(tracked, tracked ? "" : tracked.error().message().c_str());
    QCOMPARE(tracked->front().series.size(), robots.size());
    QCOMPARE(tracked->front().frames, std::int64_t(105));
    QCOMPARE(tracked->front().light.size(), std::size_t(105));
    const auto edges = findLightEdges(tracked->front().light);
    QCOMPARE(edges.size(), std::size_t(2));
    QVERIFY(edges[0].brighter && !edges[1].brighter);
    QVERIFY2(std::abs(edges[0].timeS - 1.511) < 3 * edges[0].sigmaS && edges[0].sigmaS < 0.012,
             qPrintable(QStringLiteral("%1 +- %2").arg(edges[0].timeS).arg(edges[0].sigmaS)));
    QVERIFY2(std::abs(edges[1].timeS - 1.911) < 3 * edges[1].sigmaS && edges[1].sigmaS < 0.012,
             qPrintable(QStringLiteral("%1 +- %2").arg(edges[1].timeS).arg(edges[1].sigmaS)));
    QVERIFY(std::abs(edges[0].change - std::log(1.3)) < 0.05); // eight code values stand for black
}

void TestViewTracking::framesOfTwoMomentsAreTakenByFields()
{
    SimulatedScene scene = demoTestbed(8);
    scene.durationS = 3;
    SimulatedRobot robot;
    robot.name = "red";
    robot.colour = {215, 35, 40};
    robot.motion = makeFigureEightMotion({1.7, 1.4}, 0.8, 0.3, 4.0, 1.2);
    scene.robots.push_back(robot);
    std::vector<RobotRecord> robots(1);
    robots[0].name = robot.name;
    robots[0].colour = robot.colour;
    const QTemporaryDir folder;
    std::vector<RegisteredView> views(1);
    const auto track = [&](const QString &name) {
        views[0].file = folder.filePath(name).toStdString();
        if (views[0].recording.frameTimes.empty())
            views[0].recording.frameTimes = (*VideoReader::open(views[0].file))->info().frameTimes;
        return trackViews(views, robots, {}).value();
    };
    QVERIFY(renderVideo(scene, 0, folder.filePath(QStringLiteral("sound.mkv")).toStdString(), {}, {}));
    const auto sound = track(QStringLiteral("sound.mkv"));
    QVERIFY(sound[0].interlace == Interlace::None);
    QVERIFY(takeFields(views, sound, {}).empty());
    for (const bool isEvenLater : {false, true}) {
        views[0].recording.frameTimes.clear();
        QVERIFY(writeWoven(scene, folder.filePath(QStringLiteral("woven.mkv")).toStdString(), isEvenLater));
        const auto whole = track(QStringLiteral("woven.mkv"));
        QVERIFY(whole[0].interlace == Interlace::Whole);
        QCOMPARE(whole[0].frames, std::int64_t(45));
        QCOMPARE(takeFields(views, whole, {}), std::vector<std::size_t>{0});
        const auto fields = track(QStringLiteral("woven.mkv"));
        QVERIFY(fields[0].interlace == Interlace::Fields);
        QCOMPARE(fields[0].frames, std::int64_t(90));
        const std::vector<Observation> &seen = fields[0].series[0].observations,
                                       &expected = sound[0].series[0].observations;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            QVERIFY(std::abs(toSeconds(seen[i].time - expected[i].time)) < 1e-4);
            QCOMPARE(seen[i].found, expected[i].found);
            QVERIFY((seen[i].ellipse.centrePx - expected[i].ellipse.centrePx).norm() <
                    1.5); // of some 10 a field
        }
    }
}

ODOGRAPH_TEST(TestViewTracking, QCoreApplication)
#include "tst_view_tracking.moc"
