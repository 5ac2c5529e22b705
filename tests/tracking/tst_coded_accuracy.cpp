// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/tracking/colour_tracker.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/tracking/silhouette.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <numeric>

using namespace odo;
using Eigen::Vector2d;

namespace {

/// Three robots at once; blue tape and a brown patch lie about, as they do on floors. The chroma is sited as
/// the codec's standard has it.
SimulatedScene sceneOf(SimulatedShape shape, VideoCodec codec)
{
    SimulatedScene scene = demoTestbed(21);
    scene.durationS = 3;
    scene.cameras[0].sensor.siting = codec == VideoCodec::Mjpeg ? ChromaSiting::Center : ChromaSiting::Left;
    constexpr RgbColour colours[] = {{215, 35, 40}, {31, 157, 77}, {140, 50, 180}};
    for (int i = 0; i < 3; ++i) {
        SimulatedRobot robot;
        robot.name = std::to_string(i);
        robot.colour = colours[i];
        robot.shape = shape;
        if (shape == SimulatedShape::Cylinder) { // a flat disc: no shaded side
            robot.lengthM = robot.widthM = 0.2;
            robot.heightM = 0.0001;
        }
        robot.motion = makeFigureEightMotion({1.5, 0.45 + 0.65 * i}, 0.9, 0.12, 4.0 + 0.7 * i, 0.8);
        scene.robots.push_back(std::move(robot));
    }
    scene.floor.patches.push_back({{45, 95, 190}, {{0.2, 0.75}, {2.8, 0.78}, {2.8, 0.82}, {0.2, 0.79}}});
    scene.floor.patches.push_back({{120, 85, 60}, {{2.6, 1.2}, {2.85, 1.2}, {2.85, 1.5}, {2.6, 1.5}}});
    return scene;
}

/// Of a disc with the lens's bend along its outline; of a box as the analysis reckons it.
Vector2d trueCentre(const SimulatedScene &scene, std::size_t robot, std::int64_t frame)
{
    const SimulatedRobot &body = scene.robots[robot];
    if (body.shape == SimulatedShape::Cylinder)
        return exactMoments(silhouette(scene, robot, 0, frame)).centre;
    const MotionState state = body.motion->at(frameSceneTime(scene, 0, frame));
    const SolidShape box{SolidShape::Form::Box, body.lengthM, body.widthM, 0, body.heightM};
    return silhouetteMoments(scene.cameras[0].view, box, state.position, state.headingRad)->centrePx;
}

} // namespace

/// From the simulated scene through a video file, 1280×720, 30 frames/s, to the centre of the outline: what
/// coding and decoding cost is in these figures.
class TestCodedAccuracy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void centresAreRight_data();
    void centresAreRight();
};

void TestCodedAccuracy::centresAreRight_data()
{
    QTest::addColumn<bool>("boxes");
    QTest::addColumn<bool>("mjpeg");
    QTest::addColumn<double>("mostMeanPx");
    QTest::addColumn<double>("most95Px");
    QTest::newRow("discs, H.264 of 8 Mbit/s") << false << false << 0.10 << 0.25;
    QTest::newRow("discs, MJPEG of quality 3") << false << true << 0.10 << 0.25;
    QTest::newRow("boxes, H.264 of 8 Mbit/s") << true << false << 0.15 << 0.30;
    QTest::newRow("boxes, MJPEG of quality 3") << true << true << 0.15 << 0.30;
}

void TestCodedAccuracy::centresAreRight()
{
    QFETCH(bool, boxes);
    QFETCH(bool, mjpeg);
    QFETCH(double, mostMeanPx);
    QFETCH(double, most95Px);
    VideoWriterOptions options;
    options.codec = mjpeg ? VideoCodec::Mjpeg : VideoCodec::H264;
    options.bitRate = 8'000'000;
    options.mjpegQuality = 3;
    const SimulatedScene scene =
        sceneOf(boxes ? SimulatedShape::Box : SimulatedShape::Cylinder, options.codec);
    const QTemporaryDir folder;
    const std::string file = folder.filePath(QStringLiteral("clip.mkv")).toStdString();
    QVERIFY(renderVideo(scene, 0, file, options, {}));

    std::vector<TrackTarget> targets;
    for (const SimulatedRobot &robot : scene.robots)
        targets.push_back({robot.name, robot.colour});
    const auto tracker = ColourTracker::create(targets);
    const auto reader = VideoReader::open(file);
    QVERIFY(tracker && reader);
    QCOMPARE((*reader)->info().frameTimes.size(), std::size_t(90));
    std::vector<double> errors;
    for (const Nanoseconds time : (*reader)->info().frameTimes) {
        const auto frame = (*reader)->next((*tracker)->neededRegion(time));
        QVERIFY(frame && *frame);
        const auto seen = (*tracker)->track(**frame);
        for (std::size_t robot = 0; robot < seen.size(); ++robot) {
            QVERIFY2(seen[robot].found, qPrintable(QStringLiteral("frame %1").arg((*frame)->index)));
            const Vector2d truth = trueCentre(scene, robot, (*frame)->index);
            errors.push_back((seen[robot].ellipse.centrePx - truth).norm());
        }
    }
    std::sort(errors.begin(), errors.end());
    const double mean = std::reduce(errors.begin(), errors.end()) / double(errors.size());
    const double most95 = errors[errors.size() * 95 / 100];
    qInfo("%zu centres: mean %.3f px, 95 %% within %.3f px, worst %.3f px", errors.size(), mean, most95,
          errors.back());
    QVERIFY(mean <= mostMeanPx);
    QVERIFY(most95 <= most95Px);
}

ODOGRAPH_TEST(TestCodedAccuracy, QCoreApplication)
#include "tst_coded_accuracy.moc"
