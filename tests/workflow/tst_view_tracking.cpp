// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/tracking/colour_tracker.h"
#include "core/video/video_reader.h"
#include "core/workflow/view_tracking.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

/// Decoding MJPEG only where the tracker looks gives, from the file to the stored observation, what decoding
/// all gives.
class TestViewTracking : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void partsGiveWhatTheWholeGives();
};

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
    QCOMPARE(tracked->front().damagedFrames, std::int64_t(0));

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

QTEST_GUILESS_MAIN(TestViewTracking)
#include "tst_view_tracking.moc"
