// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/steady_now.h"
#include "core/video/video_reader.h"
#include "tests/capture/two_cameras.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <atomic>
#include <csignal>
#include <future>
#include <sys/resource.h>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

using State = ViewHealth::State;

const Error gone = test::saidError(ErrorCode::Unavailable, "camera play:", "it was unplugged", "plug it in");
const Error over =
    test::saidError(ErrorCode::Io, "camera play:", "the video has ended", "nothing is to be done");

} // namespace

/// Cameras that go, end, hang or slow down, and disks that fail, fill up or are too slow.
class TestCaptureFaults : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void aCameraThatIsGoneIsWaitedFor();
    void aCameraThatEndsKeepsWhatThereIs();
    void aDiskThatFailsIsTold();
    void itEndsBeforeTheDiskIsFull();
    void littleIsReservedOnASmallDisk();
    void aFileThatMayNotGrowKeepsWhatThereIs();
    void aFileThatIsNoLongerThereIsTold();
    void aSlowDiskIsToldBeforeAnythingIsLost();
    void aCameraThatHangsHoldsNothingUp();
    void aCameraThatTakesFewerPicturesIsTold();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCaptureFaults::aCameraThatIsGoneIsWaitedFor()
{
    TwoCameras cameras;
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.b->frames(10);
    cameras.b->error(gone);
    cameras.a->frames(lot);
    QTRY_COMPARE(cameras.health(1).state, State::Waiting);
    QVERIFY(cameras.health(1).warning);
    QCOMPARE(healthWords(cameras.health(1)).english(), gone.message());
    QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(lot)); // the other one loses nothing
    QVERIFY(!cameras.health(0).warning);
    cameras.b->lose(5);
    cameras.b->frames(10);
    QTRY_COMPARE(cameras.health(1).delivered, 20u);
    QCOMPARE(cameras.health(1).state, State::Delivering);
    QVERIFY(!cameras.health(1).warning);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QVERIFY(outcome.views[0].gaps.empty());
    const ViewRecording &view = outcome.views[1];
    QVERIFY(!view.problem);
    QCOMPARE(view.taken.size(), std::size_t(20));
    QCOMPARE(view.gaps.size(), std::size_t(1));
    QCOMPARE(view.gaps.front().before, std::size_t(10));
    QCOMPARE(view.gaps.front().length, 6 * PlayedCamera::interval);
    QCOMPARE(view.gaps.front().why.why.english(), gone.why.english());
    QCOMPARE(view.taken[10] - view.taken[9], 6 * PlayedCamera::interval); // the time goes on
}

void TestCaptureFaults::aCameraThatEndsKeepsWhatThereIs()
{
    TwoCameras cameras;
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.b->frames(20);
    cameras.b->error(over);
    QTRY_COMPARE(cameras.health(1).state, State::Ended);
    cameras.a->frames(lot);
    QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(lot));
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QVERIFY(!outcome.views[0].problem);
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QVERIFY(outcome.views[1].problem);
    QCOMPARE(outcome.views[1].problem->why.english(), over.why.english());
    QCOMPARE(outcome.views[1].taken.size(), std::size_t(20));
    QVERIFY(VideoReader::open(outcome.views[1].file));
}

void TestCaptureFaults::aDiskThatFailsIsTold()
{
    TwoCameras cameras;
    cameras.session->startRecording(filesIn(*m_folder, "a.mkv", "no/folder/b.mkv"));
    cameras.frames(lot);
    QTRY_VERIFY(cameras.session->health().disk.warning);
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    QVERIFY(cameras.session->health().disk.recording);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QVERIFY(outcome.views[1].problem);
    QCOMPARE(outcome.views[1].problem->code, ErrorCode::Io);
    QVERIFY(outcome.views[1].taken.empty());
    QVERIFY(!outcome.views[0].problem);
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QVERIFY(!cameras.session->health().disk.warning);
}

void TestCaptureFaults::itEndsBeforeTheDiskIsFull()
{
    std::atomic<std::uint64_t> left = 1'000'000'000;
    TwoCameras cameras(0s, 20s, {}, {.mostReserved = 100'000'000, .space = [&left](const auto &) {
                                         return DiskCapacity{left, 4'000'000'000};
                                     }});
    cameras.session->startRecording(filesIn(*m_folder));
    record(cameras, 2);
    const DiskHealth disk = cameras.session->health().disk;
    QVERIFY(!disk.warning && !disk.ended);
    // What may still be written at the rate so far, of both views together.
    QVERIFY(disk.secondsLeft);
    const double expectedS = 900e6 / (double(disk.bytes) / (59 * 0.033));
    QVERIFY2(std::abs(*disk.secondsLeft - expectedS) < 0.01 * expectedS,
             qPrintable(QString::number(*disk.secondsLeft)));
    left = 99'000'000;
    QTRY_VERIFY((cameras.frames(1), cameras.session->health().disk.ended)); // it looks once a second
    QCOMPARE(cameras.session->health().disk.warning->error.why.english(),
             std::string("its disk has only 99 MB left, of which 100 are kept free"));
    const RecordingOutcome outcome = cameras.session->stopRecording();
    for (const ViewRecording &view : outcome.views) {
        if (!view.problem)
            continue;
        const auto reader = VideoReader::open(view.file);
        QVERIFY(reader && view.taken.size() >= 60);
        QCOMPARE((*reader)->info().frameTimes.size(), view.taken.size());
    }
}

void TestCaptureFaults::littleIsReservedOnASmallDisk()
{
    const DiskWatch watch;
    QCOMPARE(watch.left({1'000'000'000, 1'000'000'000'000}), std::uint64_t(800'000'000));
    QCOMPARE(watch.left({50'000'000, 60'000'000}), std::uint64_t(47'000'000));
    QCOMPARE(watch.left({2'000'000, 60'000'000}), std::uint64_t(0));
    QVERIFY(!diskCapacityOf("/no/such/folder"));
    QVERIFY(diskCapacityOf(m_folder->path().toStdString())->size > 0);
}

void TestCaptureFaults::aFileThatMayNotGrowKeepsWhatThereIs()
{
    // As a full disk: what the system refuses to write.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 30'000;
    TwoCameras cameras;
    cameras.session->startRecording(filesIn(*m_folder));
    setrlimit(RLIMIT_FSIZE, &small);
    QTRY_VERIFY((cameras.frames(1), cameras.session->health().disk.ended));
    setrlimit(RLIMIT_FSIZE, &before);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    const auto cut = std::ranges::find_if(outcome.views,
                                          [](const ViewRecording &view) { return view.problem.has_value(); });
    QVERIFY(cut != outcome.views.end());
    QVERIFY2(cut->problem->message().find("File too large") != std::string::npos,
             cut->problem->message().c_str());
    QVERIFY(cut->taken.size() > 5);
    QCOMPARE(cut->lostByUs, 0u); // nothing was too slow
    const auto reader = VideoReader::open(cut->file);
    QVERIFY(reader);
    QCOMPARE((*reader)->info().frameTimes.size(), cut->taken.size());
    for (std::size_t i = 0; i < cut->taken.size(); ++i)
        QVERIFY((*reader)->next().value().has_value());
}

/// Its folder was moved, or its disk was taken out of the file system: it could be written to on and on.
void TestCaptureFaults::aFileThatIsNoLongerThereIsTold()
{
    const auto folder = std::filesystem::path(m_folder->path().toStdString());
    std::filesystem::create_directory(folder / "here");
    TwoCameras cameras;
    cameras.session->startRecording({folder / "here" / "a.mkv", folder / "here" / "b.mkv"});
    cameras.frames(lot);
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    QTRY_VERIFY(std::filesystem::exists(folder / "here" / "a.mkv") &&
                std::filesystem::exists(folder / "here" / "b.mkv"));
    std::filesystem::rename(folder / "here", folder / "elsewhere");
    const Nanoseconds moved = steadyNow();
    QTRY_VERIFY((cameras.frames(1), cameras.session->health().disk.ended));
    QVERIFY2(steadyNow() - moved < 1500ms * slowness,
             qPrintable(QString::number(toSeconds(steadyNow() - moved))));
    const RecordingOutcome outcome = cameras.session->stopRecording();
    const auto cut = std::ranges::find_if(outcome.views,
                                          [](const ViewRecording &view) { return view.problem.has_value(); });
    QVERIFY(cut != outcome.views.end());
    QVERIFY2(cut->problem->message().ends_with(".mkv: its file is no longer there; reconnect its disk, or "
                                               "move its folder back; it holds what was recorded so far"),
             cut->problem->message().c_str());
    for (const ViewRecording &view : outcome.views) { // nothing of it is given up
        const auto reader = VideoReader::open(folder / "elsewhere" / view.file.filename());
        QVERIFY(reader);
        QCOMPARE((*reader)->info().frameTimes.size(), view.taken.size());
        QVERIFY(view.taken.size() >= std::size_t(lot));
    }
}

void TestCaptureFaults::aSlowDiskIsToldBeforeAnythingIsLost()
{
    std::promise<void> goesOn;
    const auto disk = [went = goesOn.get_future().share()](const auto &) {
        went.wait(); // as a disk that does not answer
        return std::optional<DiskCapacity>();
    };
    TwoCameras cameras(0s, 20s, {}, {.space = disk});
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.frames(lot);
    QTRY_VERIFY(cameras.session->health().disk.warning);
    const DiskHealth slow = cameras.session->health().disk;
    QVERIFY(!slow.ended);
    QVERIFY2(slow.warning->error.why.english().starts_with("it is too slow: a frame has waited 1."),
             slow.warning->error.why.english().c_str());
    QCOMPARE(slow.warning->error.advice.english(),
             std::string("nothing is lost yet; stop other programs that write to it"));
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    goesOn.set_value();
    const RecordingOutcome outcome = cameras.session->stopRecording();
    for (const ViewRecording &view : outcome.views) {
        QCOMPARE(view.taken.size(), std::size_t(lot));
        QCOMPARE(view.lostByUs, 0u);
        QVERIFY(view.longestWaitS > 1);
    }
}

void TestCaptureFaults::aCameraThatHangsHoldsNothingUp()
{
    TwoCameras cameras;
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.a->frames(lot);
    cameras.b->frames(5);
    cameras.b->hang();
    QTRY_COMPARE(cameras.health(1).delivered, 5u);
    QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(lot));
    QTRY_VERIFY(cameras.health(1).warning); // nobody says why: it is silent for a second
    QCOMPARE(cameras.health(1).state, State::Waiting);
    QVERIFY(cameras.health(1).warning->error.why.english().starts_with("no frame has arrived for "));
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QCOMPARE(outcome.views[1].taken.size(), std::size_t(5));
    cameras.session.reset(); // returns
    cameras.b->giveUp();
}

/// As webcams do in dim light. What is lost on its way has another cause, and another word.
void TestCaptureFaults::aCameraThatTakesFewerPicturesIsTold()
{
    TwoCameras cameras;
    for (int i = 1; i <= 2; ++i) {
        cameras.a->frames(lot);
        for (int j = 0; j < lot / 2; ++j) {
            cameras.b->lose(1);
            cameras.b->frames(1);
        }
        QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(i * lot));
    }
    QVERIFY(!cameras.health(0).slow && !cameras.health(1).slow);
    cameras.a->pace(83ms);
    cameras.a->frames(12); // in a second
    QTRY_COMPARE(cameras.health(0).delivered, 72u);
    QVERIFY(cameras.health(0).slow);
    cameras.a->frames(20);
    QTRY_COMPARE(cameras.health(0).delivered, 92u);
    QCOMPARE(cameras.health(0).slow->error.message(),
             std::string("camera play:: it delivers only 12 frames per second instead of the requested 30; "
                         "give it more light or a shorter exposure, or ask for a lower rate"));
    QCOMPARE(cameras.health(0).state, State::Delivering);
    QVERIFY2(healthWords(cameras.health(0)).english().ends_with(" frames/s (too slow), none lost"),
             healthWords(cameras.health(0)).english().c_str());
    cameras.a->error(gone); // whatever is worse is told instead
    QTRY_VERIFY(cameras.health(0).warning);
    QVERIFY(!cameras.health(0).slow);
    cameras.a->frames(24); // two seconds
    QTRY_VERIFY(cameras.health(0).slow);
    cameras.a->pace(PlayedCamera::interval);
    cameras.a->frames(lot);
    QTRY_COMPARE(cameras.health(0).delivered, 146u);
    cameras.a->frames(lot);
    QTRY_COMPARE(cameras.health(0).delivered, 176u);
    QVERIFY(!cameras.health(0).slow);
}

ODOGRAPH_TEST(TestCaptureFaults, QCoreApplication)
#include "tst_capture_faults.moc"
