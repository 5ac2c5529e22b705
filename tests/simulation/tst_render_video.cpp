// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

/// Half a second of a small view, lossless, with a frame lost on the way.
SimulatedScene smallScene()
{
    SimulatedScene scene = demoTrials().front().scene;
    scene.durationS = 0.5;
    scene.cameras.pop_back();
    scene.cameras[0].view = simulatedView({-0.9, -1.5, 2.0}, {1.4, 0.75, 0}, 320, 180, 240);
    scene.cameras[0].sensor.droppedFrames = {5};
    return scene;
}

VideoWriterOptions lossless()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::Ffv1;
    return options;
}

} // namespace

class TestRenderVideo : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theFileHoldsTheFramesAndTheirTimes()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("a.mkv")).toStdString();
        const SimulatedScene scene = smallScene();
        double fraction = 0;
        const JobControl control{{}, [&](double done, const Message &) { fraction = done; }};
        const auto rendered = renderVideo(scene, 0, file, lossless(), control);
        QVERIFY2(rendered.has_value(), rendered ? "" : rendered.error().message().c_str());
        QCOMPARE(fraction, 1.0);

        const auto reader = VideoReader::open(file);
        QVERIFY(reader.has_value());
        const VideoInfo &info = (*reader)->info();
        QCOMPARE(info.frameTimes.size(), 14u);
        QCOMPARE(info.format.siting, ChromaSiting::Left);
        for (std::int64_t i = 0; i < 14; ++i)
            // The file counts in microseconds.
            QVERIFY(
                std::abs((info.frameTimes[static_cast<std::size_t>(i)] - frameStamp(scene, 0, i)).count()) <=
                1000);
        SceneRenderer renderer(scene, 0);
        const auto frame = (*reader)->frameAt(7);
        QVERIFY(frame.has_value());
        const Frame truth = renderer.render(7);
        for (int y = 0; y < 180; ++y)
            QVERIFY(std::equal(truth.y.row(y), truth.y.row(y) + 320, frame->y.row(y)));
    }

    void stopsWhenAsked()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("a.mkv")).toStdString();
        JobControl control;
        control.progress = [cancel = control.cancel](double done, const Message &) {
            if (done > 0.3)
                cancel.cancel();
        };
        const auto rendered = renderVideo(smallScene(), 0, file, lossless(), control);
        QVERIFY(!rendered.has_value());
        QCOMPARE(rendered.error().code, ErrorCode::Cancelled);
        QVERIFY(std::filesystem::is_empty(folder.path().toStdString()));
    }

    void saysWhatIsWrong()
    {
        SimulatedScene scene = smallScene();
        const auto nowhere = renderVideo(scene, 0, "/nonexistent/a.mkv", lossless(), {});
        QVERIFY(!nowhere.has_value());
        scene.cameras[0].startOffsetS = 9;
        const auto empty = renderVideo(scene, 0, "a.mkv", lossless(), {});
        QVERIFY(!empty.has_value());
        QCOMPARE(empty.error().message(),
                 std::string("cannot render a.mkv: camera A takes no frame during the scene; give the scene "
                             "a longer duration or start the camera earlier"));
    }
};

ODOGRAPH_TEST(TestRenderVideo, QCoreApplication)
#include "tst_render_video.moc"
