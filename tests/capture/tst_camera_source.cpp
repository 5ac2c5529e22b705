// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_detection.h"
#include "core/capture/internal/stand_in_source.h"
#include "core/simulation/demo_testbed.h"
#include "core/simulation/renderer.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <thread>

using namespace odo;

namespace {

const CameraModel lens = CameraModel::assumed(320, 180);

struct Shown
{
    int y = 0, cb = 0, cr = 0;
};

/// What the next frame shows where a robot's side or top must be seen: a little above the middle of its
/// footprint.
Shown shownAt(CameraSource &source, const SimulatedScene &scene, const std::vector<SimulatedRobot> &robots)
{
    const Frame frame = source.next()->frame;
    const Eigen::Vector2d at = robots.front().motion->at(frameSceneTime(scene, 0, frame.index)).position;
    const Eigen::Vector2d pixel = *scene.cameras[0].view.pixelFromWorld({at.x(), at.y(), 0.05});
    const int x = int(pixel.x()), y = int(pixel.y());
    return {frame.y.at(x, y), frame.u.at(x / 2, y / 2), frame.v.at(x / 2, y / 2)};
}

std::unique_ptr<CameraSource> board(Pace::Kind pace)
{
    return simulatedBoardSource({"sim:T", "simulated", foreignWords("T"), 320, 180, 10}, lens, {},
                                heldBoardPoses(lens, {}, 3, 1), pace);
}

} // namespace

class TestCameraSource : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void countsAndStampsItsPictures()
    {
        const auto source = board(Pace::Kind::None);
        for (std::uint64_t i = 0; i < 5; ++i) {
            const auto captured = source->next();
            QVERIFY(captured);
            QCOMPARE(captured->sequence, i);
            QCOMPARE(captured->frame.time, fromSeconds(0.1 * double(i)));
        }
    }

    void theBoardIsHeldAndThenMoved()
    {
        const auto source = board(Pace::Kind::None);
        std::vector<Eigen::Vector2d> corners;
        BoardSpec spec;
        spec.pattern = BoardPattern::Checkerboard;
        for (int i = 0; i < 20; ++i) {
            const auto captured = source->next();
            QVERIFY(captured);
            const auto view = findBoard(captured->frame, spec, "p");
            // held for a second, then half a second on its way, then held again
            if (i == 0 || i == 9 || i == 16) {
                QVERIFY2(view, view ? "" : view.error().message().c_str());
                corners.push_back(view->pixels.front());
            }
        }
        QVERIFY((corners[0] - corners[1]).norm() < 0.5);
        QVERIFY((corners[0] - corners[2]).norm() > 5);
    }

    void aSceneBeginsAnewWhenItIsOver()
    {
        SimulatedScene scene = demoTestbed(1);
        scene.durationS = 0.2;
        const auto source = simulatedSceneSource({"sim:A", "simulated", foreignWords("A"), 1280, 720, 30},
                                                 scene, 0, Pace::Kind::None);
        for (std::uint64_t i = 0; i < 8; ++i)
            QCOMPARE(source->next()->sequence, i);
    }

    void aSceneShowsTheRobotsThatAreChosen()
    {
        const SimulatedScene scene = demoTestbed(1); // in which there is none
        const auto source = simulatedSceneSource({"sim:A", "simulated", foreignWords("A"), 1280, 720, 30},
                                                 scene, 0, Pace::Kind::None);
        const Shown floor = shownAt(*source, scene, circlingRobots({}));
        // By BT.601 a red has much of Cr, a blue of Cb; the rover is dark and grey.
        for (const std::vector<RobotAppearance> &chosen : {std::vector<RobotAppearance>{{.colour = demoRed}},
                                                           {{.colour = demoBlue}, {}},
                                                           {{}},
                                                           {{.colour = demoRed, .heightM = 0.2}},
                                                           {}}) {
            source->showRobots(chosen);
            const std::vector<SimulatedRobot> robots = circlingRobots(chosen);
            for (std::size_t i = 0; i < robots.size(); ++i) {
                const Shown shown = shownAt(*source, scene, {robots[i]});
                const bool isRed = !chosen.empty() && chosen[i].colour == demoRed,
                           isBlue = chosen.empty() || chosen[i].colour == demoBlue;
                QVERIFY2((shown.cr > 160) == isRed && (shown.cb > 150) == isBlue,
                         qPrintable(QStringLiteral("%1 %2 %3").arg(shown.y).arg(shown.cb).arg(shown.cr)));
                if (!isRed && !isBlue)
                    QVERIFY(shown.y < floor.y - 20 && std::abs(shown.cb - 128) < 30 &&
                            std::abs(shown.cr - 128) < 30);
            }
        }
    }

    void aBoardIsHeldWhateverRobotIsChosen()
    {
        const auto source = board(Pace::Kind::None), other = board(Pace::Kind::None);
        source->showRobots({{.colour = demoRed}});
        const auto a = source->next(), b = other->next();
        QVERIFY(a && b);
        for (int y = 0; y < a->frame.y.height; ++y)
            QVERIFY(std::equal(a->frame.y.row(y), a->frame.y.row(y) + a->frame.y.width, b->frame.y.row(y)));
    }

    void stopWakesWhoWaits()
    {
        const auto source = board(Pace::Kind::RealTime);
        QVERIFY(source->next());
        std::thread other([&] { source->stop(); });
        const auto after = source->next();
        other.join();
        // Either it was waiting for its time, or was stopped before; it never gives pictures for ever.
        QVERIFY(!source->next());
        if (!after)
            QCOMPARE(after.error().code, ErrorCode::Cancelled);
    }

    void aFilePlaysToItsEnd()
    {
        QTemporaryDir folder;
        SimulatedScene scene = demoTestbed(1);
        scene.durationS = 0.2;
        const auto file = std::filesystem::path(folder.path().toStdString()) / "a.mkv";
        QVERIFY(renderVideo(scene, 0, file, {}, {}));
        const auto source = openFileSource(file, Pace::Kind::None);
        QVERIFY(source);
        QCOMPARE((*source)->description().widthPx, 1280);
        int frames = 0;
        auto captured = (*source)->next();
        for (; captured; captured = (*source)->next())
            QCOMPARE(captured->sequence, std::uint64_t(frames++));
        QCOMPARE(frames, 6);
        QCOMPARE(captured.error().code, ErrorCode::Io);
        QVERIFY(captured.error().message().find("the video has ended; ") != std::string::npos);
    }

    void addressesThatAreNoneAreRefused()
    {
        QVERIFY(openCamera("sim:A"));
        QVERIFY(openCamera("sim:B?board"));
        QVERIFY(openCamera("sim:Z").error().message().find("use sim:A or sim:B") != std::string::npos);
        QCOMPARE(openCamera("usb:0").error().code, ErrorCode::NotFound);
        QVERIFY(!openCamera("file:/nowhere/x.mkv"));
        QCOMPARE(std::ranges::count(listCameras(), "simulated", &CameraDescription::kind), 2);
    }
};

ODOGRAPH_TEST(TestCameraSource, QCoreApplication)
#include "tst_camera_source.moc"
