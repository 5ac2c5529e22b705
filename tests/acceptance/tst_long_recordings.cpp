// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/calibration_file.h"
#include "core/exchange/labelled_points.h"
#include "core/exchange/text_file.h"
#include "core/files/output_file.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "tests/support/looped_video.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int loopS = 20, framesPerSecond = 30;
// Measured: 213 MB, 0.57 kB; a third is left for other machines and libraries.
constexpr double mostMegabytes = 280;
constexpr double mostPerFrameMegabytes = 0.75e-3; ///< and view

/// Two cameras of 320x180; a robot that drives round and comes to rest where it set out, so that the loop has
/// no seam.
SimulatedScene smallTestbed()
{
    SimulatedScene scene = demoTestbed(3);
    scene.cameras[0].view = simulatedView({-0.9, -1.55, 2.0}, {1.4, 0.75, 0.0}, 320, 180, 240);
    scene.cameras[1].view = simulatedView({3.9, -1.55, 2.0}, {1.6, 0.75, 0.0}, 320, 180, 235);
    scene.durationS = loopS;
    SimulatedRobot robot;
    robot.name = "Red";
    robot.colour = {215, 35, 40};
    robot.motion =
        makeSplineMotion({{0.5, 0.5}, {1.5, 0.4}, {2.5, 0.7}, {2.4, 1.6}, {1.4, 1.3}, {0.5, 1.7}, {0.5, 0.5}},
                         (loopS - 1.0) / 6);
    scene.robots.push_back(robot);
    return scene;
}

} // namespace

/// Memory does not grow with the length of a recording beyond what is kept of each frame.
class TestLongRecordings : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    const SimulatedScene m_scene = smallTestbed();
    QString m_project = path("long.odo");

    QString path(const QString &name) const { return m_folder.filePath(name); }
    QString path(const char *name) const { return path(QString::fromLatin1(name)); }
    std::filesystem::path file(const QString &name) const { return path(name).toStdString(); }
    void makeProject();
    double track(int minutes, VideoCodec codec);

private Q_SLOTS:
    void twoHourLongClips_data();
    void twoHourLongClips();
};

void TestLongRecordings::makeProject()
{
    const auto run = [](const QStringList &arguments) {
        const ProgramRun ran = runProgram(arguments);
        QVERIFY2(ran.exitStatus == 0, ran.err);
    };
    const auto s = [](const char *word) { return QString::fromLatin1(word); };
    m_project = path("long.odo");
    run({s("new"), m_project});
    QVERIFY(writeLayoutCsv(file(s("layout.csv")), m_scene.floor.markers));
    run({s("layout"), s("add"), m_project, s("floor"), path("layout.csv")});
    run({s("robot"), s("add"), m_project, s("Red"), s("--colour"), s("#d72328"), s("--height"), s("60mm")});
    for (const SimulatedCamera &camera : m_scene.cameras) {
        const QString name = QString::fromStdString(camera.name);
        std::string pixels = "label,u,v\n";
        for (const Marker &marker : m_scene.floor.markers.markers) {
            const auto pixel =
                camera.view.pixelFromWorld({marker.pointInWorld.x(), marker.pointInWorld.y(), 0});
            pixels += marker.label + "," + numberText(pixel->x()) + "," + numberText(pixel->y()) + "\n";
        }
        QVERIFY(writeOutput(file(name + s(".csv")), pixels));
        QVERIFY(writeIntrinsics(file(name + s(".yaml")), camera.name, camera.view.camera().intrinsics()));
        run({s("camera"), s("add"), m_project, name});
        run({s("intrinsics"), s("import"), m_project, name, path(name + s(".yaml"))});
        run({s("register"), m_project, s("--camera"), name, s("--layout"), s("floor"), s("--pixels"),
             path(name + s(".csv"))});
    }
}

/// Megabytes that tracking two clips of this length took.
double TestLongRecordings::track(int minutes, VideoCodec codec)
{
    const QString ending = codec == VideoCodec::Mjpeg ? QStringLiteral(".jpeg.mkv") : QStringLiteral(".mkv");
    const QString trial = QString::number(minutes) + ending;
    QStringList import{
        QStringLiteral("import"), m_project,           QStringLiteral("--trial"), trial,
        QStringLiteral("--sync"), QStringLiteral("0"), QStringLiteral("--robot"), QStringLiteral("Red")};
    for (int camera = 0; camera < 2; ++camera) {
        const QString name = QString::fromStdString(m_scene.cameras[std::size_t(camera)].name);
        const QString once = name + ending, looped = name + trial;
        VideoWriterOptions options;
        options.codec = codec;
        options.bitRate = 400'000;
        options.mjpegQuality = 10;
        if (!std::filesystem::exists(file(once)) && !renderVideo(m_scene, camera, file(once), options, {}))
            return -1;
        if (!loopVideo(file(once), file(looped), minutes * 60 / loopS))
            return -1;
        import << QStringLiteral("--video") << name + u'=' + path(looped);
    }
    const MeasuredRun imported = runMeasured(import);
    QElapsedTimer clock;
    clock.start();
    const MeasuredRun tracked = runMeasured({QStringLiteral("track"), m_project, trial});
    qInfo("%d min, %s: import %.0f MB, track %.0f MB in %.0f s, status %d and %d", minutes,
          qPrintable(ending), imported.megabytes, tracked.megabytes, double(clock.elapsed()) / 1000,
          imported.exitStatus, tracked.exitStatus);
    return imported.exitStatus == 0 && tracked.exitStatus == 0
               ? std::max(imported.megabytes, tracked.megabytes)
               : -1;
}

void TestLongRecordings::twoHourLongClips_data()
{
    QTest::addColumn<int>("codec");
    QTest::newRow("MJPEG") << int(VideoCodec::Mjpeg);
    QTest::newRow("H.264") << int(VideoCodec::H264);
}

void TestLongRecordings::twoHourLongClips()
{
    QFETCH(int, codec);
    if (!QFile::exists(m_project))
        makeProject();
    const double ofTenMinutes = track(10, VideoCodec(codec));
    const double ofAnHour = track(60, VideoCodec(codec));
    QVERIFY(ofTenMinutes > 0 && ofAnHour > 0);
    QVERIFY2(ofAnHour <= mostMegabytes, qPrintable(QString::number(ofAnHour)));
    // What is kept of a frame is what may grow: its observations (0.14 kB a view) to the end, beside them
    // while the views are laid on the floor twice a place (0.13 kB a view each), and the sample with its
    // profile (0.26 kB).
    const double frames = 2.0 * 50 * 60 * framesPerSecond;
    QVERIFY2(ofAnHour - ofTenMinutes < mostPerFrameMegabytes * frames,
             qPrintable(QString::number(ofAnHour - ofTenMinutes)));
}

ODOGRAPH_TEST(TestLongRecordings, QCoreApplication)
#include "tst_long_recordings.moc"
