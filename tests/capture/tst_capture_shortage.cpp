// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/camera_source.h"
#include "core/video/video_reader.h"
#include "tests/capture/two_cameras.h"
#include "tests/fault/scarce.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

constexpr const char *noThreadWords = "this computer cannot start another thread";

} // namespace

/// A session that gets no thread for one of its views: the other one is shown and recorded all the same.
class TestCaptureShortage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aViewWithoutAThreadHasEnded_data()
    {
        QTest::addColumn<int>("thread");
        QTest::addColumn<int>("view");
        QTest::newRow("the first one's coder") << 1 << 0;
        QTest::newRow("the first one's taker") << 2 << 0;
        QTest::newRow("the second one's coder") << 3 << 1;
        QTest::newRow("the second one's taker") << 4 << 1;
    }
    void aViewWithoutAThreadHasEnded()
    {
        QFETCH(int, thread);
        QFETCH(int, view);
        std::optional<FailingRequest> failing(std::in_place, Scarce::Threads, std::uint64_t(thread));
        TwoCameras cameras;
        QVERIFY(failing->hasFailed());
        failing.reset();
        const auto lame = std::size_t(view), sound = 1 - lame;
        QCOMPARE(cameras.health(lame).state, ViewHealth::State::Ended);
        QCOMPARE(cameras.health(lame).warning->error.why.english(), std::string(noThreadWords));
        cameras.session->startRecording(filesIn(*m_folder));
        cameras.frames(lot);
        QTRY_COMPARE(cameras.health(sound).delivered, std::uint64_t(lot));
        const RecordingOutcome outcome = cameras.session->stopRecording();
        QVERIFY(!outcome.views[sound].problem);
        QCOMPARE(outcome.views[sound].taken.size(), std::size_t(lot));
        QVERIFY(VideoReader::open(outcome.views[sound].file));
        QVERIFY(outcome.views[lame].problem);
        QCOMPARE(outcome.views[lame].problem->why.english(), std::string(noThreadWords));
        QVERIFY(outcome.views[lame].taken.empty());
    }

    void aRecordingWithoutAThreadIsTold_data()
    {
        QTest::addColumn<int>("thread");
        QTest::newRow("of the first view") << 1;
        QTest::newRow("of the second view") << 2;
    }
    void aRecordingWithoutAThreadIsTold()
    {
        QFETCH(int, thread);
        TwoCameras cameras;
        {
            const FailingRequest failing(Scarce::Threads, std::uint64_t(thread));
            cameras.session->startRecording(filesIn(*m_folder));
            QVERIFY(failing.hasFailed());
        }
        QVERIFY(cameras.session->health().disk.ended);
        QCOMPARE(cameras.session->health().disk.warning->error.why.english(), std::string(noThreadWords));
        cameras.frames(lot);
        QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot)); // both are shown
        const RecordingOutcome outcome = cameras.session->stopRecording();
        const auto lame = std::size_t(thread - 1);
        QVERIFY(outcome.views[lame].problem && outcome.views[lame].taken.empty());
        QVERIFY(!outcome.views[1 - lame].problem);
        QCOMPARE(outcome.views[1 - lame].taken.size(), std::size_t(lot));
        cameras.session->startRecording(filesIn(*m_folder, "c.mkv", "d.mkv")); // and now there are enough
        cameras.frames(lot);
        QTRY_COMPARE(cameras.delivered(), std::uint64_t(2 * lot));
        for (const ViewRecording &view : cameras.session->stopRecording().views)
            QVERIFY(!view.problem && view.taken.size() == std::size_t(lot));
    }

    void aCameraThatNobodyCanWaitForIsSaid()
    {
        const FailingRequest failing(Scarce::Threads, 1);
        const auto source = awaitCamera(
            "play:", test::saidError(ErrorCode::Unavailable, "camera play:", "it is away", "wait"),
            []() -> Result<std::unique_ptr<CameraSource>> {
                return test::saidFailure(ErrorCode::Unavailable, "camera", "it is away", "wait");
            },
            1ms);
        const auto captured = source->next();
        QVERIFY(!captured);
        QCOMPARE(captured.error().why.english(), std::string(noThreadWords));
        source->stop();
        QCOMPARE(source->next().error().code, ErrorCode::Cancelled);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

ODOGRAPH_TEST(TestCaptureShortage, QCoreApplication)
#include "tst_capture_shortage.moc"
