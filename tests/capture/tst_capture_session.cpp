// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "core/video/video_reader.h"
#include "tests/capture/played_camera.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <csignal>
#include <future>
#include <sys/resource.h>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

using State = ViewHealth::State;

const Error gone{ErrorCode::Unavailable, "camera play:", "it was unplugged", "plug it in"};
const Error over{ErrorCode::Io, "camera play:", "the video has ended", "nothing is to be done"};

/// Two played cameras, of which B takes its pictures 7 ms later by a clock that began an hour before A's.
struct TwoCameras
{
    /// Pictures of the past are given up at once where they find no partner; those of the future never are.
    explicit TwoCameras(Nanoseconds preRoll = 0s, Nanoseconds ago = 20s, PlayedCamera::Kind first = {},
                        DiskWatch disk = {})
    {
        first.beginning = steadyNow() - ago;
        std::vector<std::unique_ptr<CameraSource>> cameras;
        cameras.push_back(std::make_unique<PlayedCamera>(a, first));
        cameras.push_back(std::make_unique<PlayedCamera>(
            b, PlayedCamera::Kind{.beginning = first.beginning, .clockStart = -3600s, .phase = 7ms}));
        session =
            std::make_unique<CaptureSession>(std::move(cameras), CaptureSettings{preRoll, std::move(disk)});
    }
    void pictures(int count) const
    {
        a->pictures(count);
        b->pictures(count);
    }
    ViewHealth health(std::size_t view) const { return session->health().views[view]; }
    std::uint64_t delivered() const { return std::min(health(0).delivered, health(1).delivered); }

    std::shared_ptr<Script> a = std::make_shared<Script>(), b = std::make_shared<Script>();
    std::unique_ptr<CaptureSession> session;
};

} // namespace

class TestCaptureSession : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void recordsAllAndPairsThem();
    void recordsAgainAndAgain();
    void beginsBeforeItWasAskedTo();
    void lostPicturesAreCounted();
    void whatASourceThrowsAwayIsLostByUs();
    void aCameraThatIsGoneIsWaitedFor();
    void aCameraThatEndsKeepsWhatThereIs();
    void aDiskThatFailsIsTold();
    void itEndsBeforeTheDiskIsFull();
    void littleIsReservedOnASmallDisk();
    void aFileThatMayNotGrowKeepsWhatThereIs();
    void aSlowDiskIsToldBeforeAnythingIsLost();
    void picturesThatTheCameraCodedAreKeptAsTheyCame();
    void subscribersGetPicturesAndSetsAndLoseTheOldest();
    void healthKnowsTheClockAndHowWellTheyAreInStep();
    void whatChangesByItselfIsHeldWhileRecording();
    void theRoomIsKnownBeforeAnythingIsRecorded();
    void lossesOfWhatIsMadeHereAreNotTheWires();
    void aCameraThatHangsHoldsNothingUp();
    void aCameraThatTakesFewerPicturesIsTold();

private:
    std::vector<std::filesystem::path> files(const char *a = "a.mkv", const char *b = "b.mkv") const
    {
        const std::filesystem::path folder = m_folder->path().toStdString();
        return {folder / a, folder / b};
    }
    /// So many at a time find room on the way to the coder, however slow this machine is just now.
    static constexpr int lot = 30;
    /// Has both cameras take some lots of pictures, each lot recorded before the next one is taken.
    static void record(TwoCameras &cameras, int lots)
    {
        std::size_t written[2] = {0, 0};
        for (int i = 1; i <= lots; ++i) {
            cameras.pictures(lot);
            for (std::size_t view = 0; view < 2; ++view)
                QTRY_COMPARE(written[view] += cameras.session->takeWritten(view).pictures.size(),
                             std::size_t(i * lot));
        }
    }
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCaptureSession::recordsAllAndPairsThem()
{
    TwoCameras cameras;
    cameras.session->startRecording(files());
    record(cameras, 2);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QVERIFY(!cameras.session->isRecording());
    QCOMPARE(outcome.views.size(), std::size_t(2));
    for (const ViewRecording &view : outcome.views) {
        QVERIFY(!view.problem);
        QCOMPARE(view.frames, 60u);
        QCOMPARE(view.lostOnWire + view.lostByUs, 0u);
        QCOMPARE(view.taken.size(), std::size_t(60));
        QCOMPARE(view.times.pictures.size(), std::size_t(60));
        QCOMPARE(view.latenciesS.size(), std::size_t(60));
        const auto reader = VideoReader::open(view.file);
        QVERIFY(reader);
        QCOMPARE((*reader)->info().frameTimes.size(), std::size_t(60));
    }
    QCOMPARE(outcome.views[1].taken.front() - outcome.views[0].taken.front(), Nanoseconds(7ms));
    QCOMPARE(outcome.views[1].times.pictures.front().device, Nanoseconds(3600s + 7ms));
    QCOMPARE(outcome.pairs.pairs, 60u);
    QCOMPARE(outcome.pairs.unpaired, 0u);
    for (const double errorS : outcome.pairs.errorsS)
        QVERIFY(std::abs(errorS - 0.007) < 1e-6);
}

void TestCaptureSession::recordsAgainAndAgain()
{
    TwoCameras cameras;
    cameras.pictures(lot); // shown, and not recorded
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    for (const char *name : {"1.mkv", "2.mkv"}) {
        cameras.session->startRecording(files(name, (std::string("b") + name).c_str()));
        record(cameras, 1);
        QCOMPARE(cameras.session->stopRecording().views[1].taken.size(), std::size_t(lot));
    }
    QCOMPARE(cameras.health(0).delivered, std::uint64_t(3 * lot));
}

void TestCaptureSession::beginsBeforeItWasAskedTo()
{
    // The last 300 ms are kept: ten pictures, each 33 ms after the other.
    TwoCameras cameras(300ms);
    cameras.pictures(lot);
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    cameras.session->startRecording(files(), 1h);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    for (const ViewRecording &view : outcome.views) {
        QCOMPARE(view.times.pictures.size(), std::size_t(10));
        QCOMPARE(view.times.pictures.back().sequence, std::uint64_t(lot - 1));
    }
}

void TestCaptureSession::lostPicturesAreCounted()
{
    TwoCameras cameras;
    cameras.session->startRecording(files());
    cameras.a->pictures(10);
    cameras.a->lose(2);
    cameras.a->pictures(18);
    cameras.b->pictures(lot);
    QTRY_VERIFY(cameras.health(0).delivered == 28 && cameras.health(1).delivered == lot);
    QCOMPARE(cameras.health(0).lostOnWire, 2u);
    QVERIFY(cameras.health(0).latencyS > 19); // they claim to have been taken 20 s ago, and a second apart
    QCOMPARE(healthWords(cameras.health(1)).substr(healthWords(cameras.health(1)).find(',')),
             std::string(", none lost"));
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].lostOnWire, 2u);
    QCOMPARE(outcome.views[1].lostOnWire, 0u);
    QCOMPARE(outcome.pairs.pairs, 28u);
    QCOMPARE(outcome.pairs.unpaired, 2u);
}

void TestCaptureSession::whatASourceThrowsAwayIsLostByUs()
{
    TwoCameras cameras;
    cameras.session->startRecording(files());
    cameras.a->pictures(10);
    cameras.a->loseHere(3);
    cameras.a->lose(2);
    cameras.a->pictures(15);
    QTRY_COMPARE(cameras.health(0).delivered, 25u);
    QCOMPARE(cameras.health(0).lostOnWire, 2u);
    QCOMPARE(cameras.health(0).lostByUs, 3u);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].lostOnWire, 2u);
    QCOMPARE(outcome.views[0].lostByUs, 3u);
    QCOMPARE(outcome.views[0].frames, 28u); // came, whatever became of them
}

void TestCaptureSession::aCameraThatIsGoneIsWaitedFor()
{
    TwoCameras cameras;
    cameras.session->startRecording(files());
    cameras.b->pictures(10);
    cameras.b->error(gone);
    cameras.a->pictures(lot);
    QTRY_COMPARE(cameras.health(1).state, State::Waiting);
    QVERIFY(cameras.health(1).trouble);
    QCOMPARE(healthWords(cameras.health(1)), gone.message());
    QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(lot)); // the other one loses nothing
    QVERIFY(!cameras.health(0).trouble);
    cameras.b->lose(5);
    cameras.b->pictures(10);
    QTRY_COMPARE(cameras.health(1).delivered, 20u);
    QCOMPARE(cameras.health(1).state, State::Delivering);
    QVERIFY(!cameras.health(1).trouble);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QVERIFY(outcome.views[0].gaps.empty());
    const ViewRecording &view = outcome.views[1];
    QVERIFY(!view.problem);
    QCOMPARE(view.taken.size(), std::size_t(20));
    QCOMPARE(view.gaps.size(), std::size_t(1));
    QCOMPARE(view.gaps.front().before, std::size_t(10));
    QCOMPARE(view.gaps.front().length, 6 * PlayedCamera::interval);
    QCOMPARE(view.gaps.front().why.why, gone.why);
    QCOMPARE(view.taken[10] - view.taken[9], 6 * PlayedCamera::interval); // the time goes on
}

void TestCaptureSession::aCameraThatEndsKeepsWhatThereIs()
{
    TwoCameras cameras;
    cameras.session->startRecording(files());
    cameras.b->pictures(20);
    cameras.b->error(over);
    QTRY_COMPARE(cameras.health(1).state, State::Ended);
    cameras.a->pictures(lot);
    QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(lot));
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QVERIFY(!outcome.views[0].problem);
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QVERIFY(outcome.views[1].problem);
    QCOMPARE(outcome.views[1].problem->why, over.why);
    QCOMPARE(outcome.views[1].taken.size(), std::size_t(20));
    QVERIFY(VideoReader::open(outcome.views[1].file));
}

void TestCaptureSession::aDiskThatFailsIsTold()
{
    TwoCameras cameras;
    cameras.session->startRecording(files("a.mkv", "no/folder/b.mkv"));
    cameras.pictures(lot);
    QTRY_VERIFY(cameras.session->health().disk.trouble);
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    QVERIFY(cameras.session->health().disk.recording);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QVERIFY(outcome.views[1].problem);
    QCOMPARE(outcome.views[1].problem->code, ErrorCode::Io);
    QVERIFY(outcome.views[1].taken.empty());
    QVERIFY(!outcome.views[0].problem);
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QVERIFY(!cameras.session->health().disk.trouble);
}

void TestCaptureSession::itEndsBeforeTheDiskIsFull()
{
    std::atomic<std::uint64_t> left = 1'000'000'000;
    TwoCameras cameras(0s, 20s, {}, {.mostReserved = 100'000'000, .room = [&left](const auto &) {
                                         return DiskRoom{left, 4'000'000'000};
                                     }});
    cameras.session->startRecording(files());
    record(cameras, 2);
    const DiskHealth disk = cameras.session->health().disk;
    QVERIFY(!disk.trouble && !disk.ended);
    // What may still be written at the rate so far, of both views together.
    QVERIFY(disk.secondsLeft);
    const double expectedS = 900e6 / (double(disk.bytes) / (59 * 0.033));
    QVERIFY2(std::abs(*disk.secondsLeft - expectedS) < 0.01 * expectedS,
             qPrintable(QString::number(*disk.secondsLeft)));
    left = 99'000'000;
    QTRY_VERIFY((cameras.pictures(1), cameras.session->health().disk.ended)); // it looks once a second
    QCOMPARE(cameras.session->health().disk.trouble->error.why,
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

void TestCaptureSession::littleIsReservedOnASmallDisk()
{
    const DiskWatch watch;
    QCOMPARE(watch.left({1'000'000'000, 1'000'000'000'000}), std::uint64_t(800'000'000));
    QCOMPARE(watch.left({50'000'000, 60'000'000}), std::uint64_t(47'000'000));
    QCOMPARE(watch.left({2'000'000, 60'000'000}), std::uint64_t(0));
    QVERIFY(!diskRoomOf("/no/such/folder"));
    QVERIFY(diskRoomOf(m_folder->path().toStdString())->size > 0);
}

void TestCaptureSession::aFileThatMayNotGrowKeepsWhatThereIs()
{
    // As a full disk: what the system refuses to write.
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 30'000;
    TwoCameras cameras;
    cameras.session->startRecording(files());
    setrlimit(RLIMIT_FSIZE, &small);
    QTRY_VERIFY((cameras.pictures(1), cameras.session->health().disk.ended));
    setrlimit(RLIMIT_FSIZE, &before);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    const auto cut = std::ranges::find_if(outcome.views,
                                          [](const ViewRecording &view) { return view.problem.has_value(); });
    QVERIFY(cut != outcome.views.end());
    QVERIFY2(cut->problem->message().find("File too large") != std::string::npos,
             cut->problem->message().c_str());
    QVERIFY(cut->taken.size() > 5);
    const auto reader = VideoReader::open(cut->file);
    QVERIFY(reader);
    QCOMPARE((*reader)->info().frameTimes.size(), cut->taken.size());
    for (std::size_t i = 0; i < cut->taken.size(); ++i)
        QVERIFY((*reader)->next().value().has_value());
}

void TestCaptureSession::aSlowDiskIsToldBeforeAnythingIsLost()
{
    std::promise<void> goesOn;
    const auto disk = [went = goesOn.get_future().share()](const auto &) {
        went.wait(); // as a disk that does not answer
        return std::optional<DiskRoom>();
    };
    TwoCameras cameras(0s, 20s, {}, {.room = disk});
    cameras.session->startRecording(files());
    cameras.pictures(lot);
    QTRY_VERIFY(cameras.session->health().disk.trouble);
    const DiskHealth slow = cameras.session->health().disk;
    QVERIFY(!slow.ended);
    QVERIFY2(slow.trouble->error.why.starts_with("it is too slow: a picture has waited 1."),
             slow.trouble->error.why.c_str());
    QCOMPARE(slow.trouble->error.advice, std::string("nothing is lost yet; end what else writes to it"));
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    goesOn.set_value();
    const RecordingOutcome outcome = cameras.session->stopRecording();
    for (const ViewRecording &view : outcome.views) {
        QCOMPARE(view.taken.size(), std::size_t(lot));
        QCOMPARE(view.lostByUs, 0u);
        QVERIFY(view.longestWaitS > 1);
    }
}

void TestCaptureSession::picturesThatTheCameraCodedAreKeptAsTheyCame()
{
    TwoCameras cameras(0s, 20s, {.codes = true});
    cameras.session->startRecording(files());
    cameras.a->pictures(2);
    QTRY_COMPARE(cameras.health(0).delivered, 2u);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(2));
    QFile file(QString::fromStdString(outcome.views[0].file.string()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    for (const char *picture : {"picture 0 as it came", "picture 1 as it came"})
        QVERIFY(bytes.contains(picture));
}

void TestCaptureSession::subscribersGetPicturesAndSetsAndLoseTheOldest()
{
    TwoCameras cameras(0s, -1h);
    const auto quick = cameras.session->subscribeFrames(0, lot), slow = cameras.session->subscribeFrames(0),
               bored = cameras.session->subscribeFrames(0);
    const auto sets = cameras.session->subscribeSets(lot);
    bored->close();
    cameras.pictures(lot);
    for (std::uint64_t i = 0; i < lot; ++i)
        QCOMPARE(quick->pop()->captured.sequence, i);
    QCOMPARE(quick->dropped(), 0u);
    QTRY_COMPARE(slow->dropped(), std::uint64_t(lot - 1));
    QCOMPARE(slow->pop()->captured.sequence, std::uint64_t(lot - 1));
    const auto set = sets->pop();
    QVERIFY(set && set->views[0] && set->views[1]);
    QCOMPARE(set->views[1]->taken - set->views[0]->taken, Nanoseconds(7ms));
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    cameras.session.reset();
    QVERIFY(!quick->pop());
    while (sets->pop()) { // what was there can still be taken; then it ends
    }
}

void TestCaptureSession::healthKnowsTheClockAndHowWellTheyAreInStep()
{
    TwoCameras cameras(0s, -1h);
    QCOMPARE(cameras.health(0).state, State::Starting);
    QVERIFY(!cameras.health(0).clock);
    cameras.pictures(lot);
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    const ViewHealth view = cameras.health(0);
    QCOMPARE(view.clock->source, ClockFit::Source::Arrival);
    QVERIFY(view.framesPerSecond > 0);
    const PairHealth pairs = cameras.session->health().pairs;
    QVERIFY(pairs.pairs > 0);
    QVERIFY(std::abs(pairs.medianS - 0.007) < 1e-6);
    QVERIFY(std::abs(pairs.p95S - 0.007) < 1e-6);
    const std::size_t middle = pairs.histogram.size() / 2;
    QCOMPARE(std::uint64_t(pairs.histogram[middle + 7]), pairs.pairs); // bins of 1 ms
    QCOMPARE(inStepWords(0.0012), std::string("in step to 1.2 ms; at 2 m/s that is 2.4 mm"));
}

void TestCaptureSession::whatChangesByItselfIsHeldWhileRecording()
{
    TwoCameras cameras(0s, 20s, {.notHeld = {"White balance"}});
    cameras.pictures(1);
    QTRY_COMPARE(cameras.delivered(), 1u);
    QVERIFY(!cameras.health(0).automaticsHeld);
    cameras.session->startRecording(files());
    cameras.pictures(2);
    QTRY_VERIFY(cameras.health(0).automaticsHeld && cameras.health(1).automaticsHeld);
    QVERIFY(!*cameras.health(0).automaticsHeld);
    QCOMPARE(cameras.health(0).notHeld, std::vector<std::string>{"White balance"});
    QVERIFY(*cameras.health(1).automaticsHeld);
    QVERIFY(cameras.a->held && cameras.b->held);

    cameras.session->stopRecording();
    cameras.pictures(1); // with the next picture they are given back
    QTRY_VERIFY(!cameras.a->held && !cameras.b->held);
    QVERIFY(!cameras.health(0).automaticsHeld);

    cameras.session->startRecording(files("a2.mkv", "b2.mkv"));
    cameras.pictures(2);
    QTRY_VERIFY(cameras.a->held && cameras.b->held);
    cameras.session.reset(); // in the midst of it
    QVERIFY(!cameras.a->held && !cameras.b->held);
}

void TestCaptureSession::theRoomIsKnownBeforeAnythingIsRecorded()
{
    TwoCameras cameras(2s);
    QVERIFY(!cameras.session->secondsOfRoom(m_folder->path().toStdString()));
    cameras.pictures(lot); // almost a second
    const auto room = [&] { return cameras.session->secondsOfRoom(m_folder->path().toStdString()); };
    QTRY_VERIFY(room() && *room() > 0);
    QVERIFY(!cameras.session->secondsOfRoom("/no/such/folder"));
}

void TestCaptureSession::lossesOfWhatIsMadeHereAreNotTheWires()
{
    ViewHealth view;
    view.state = ViewHealth::State::Delivering;
    view.framesPerSecond = 30;
    view.lostOnWire = 3;
    QCOMPARE(healthWords(view), std::string("30.0 frames/s, 3 lost on the wire"));
    view.hasWire = comesByWire("simulated");
    QCOMPARE(healthWords(view), std::string("30.0 frames/s, 3 lost because this machine is too slow"));
    QVERIFY(!comesByWire("file") && comesByWire("v4l2") && comesByWire("aravis"));
}

void TestCaptureSession::aCameraThatHangsHoldsNothingUp()
{
    TwoCameras cameras;
    cameras.session->startRecording(files());
    cameras.a->pictures(lot);
    cameras.b->pictures(5);
    cameras.b->hang();
    QTRY_COMPARE(cameras.health(1).delivered, 5u);
    QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(lot));
    QTRY_VERIFY(cameras.health(1).trouble); // nobody says why: it is silent for a second
    QCOMPARE(cameras.health(1).state, State::Waiting);
    QVERIFY(cameras.health(1).trouble->error.why.starts_with("no picture has come for "));
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(lot));
    QCOMPARE(outcome.views[1].taken.size(), std::size_t(5));
    cameras.session.reset(); // returns
    cameras.b->giveUp();
}

/// As webcams do in dim light. What is lost on its way has another cause, and another word.
void TestCaptureSession::aCameraThatTakesFewerPicturesIsTold()
{
    TwoCameras cameras;
    for (int i = 1; i <= 2; ++i) {
        cameras.a->pictures(lot);
        for (int j = 0; j < lot / 2; ++j) {
            cameras.b->lose(1);
            cameras.b->pictures(1);
        }
        QTRY_COMPARE(cameras.health(0).delivered, std::uint64_t(i * lot));
    }
    QVERIFY(!cameras.health(0).slow && !cameras.health(1).slow);
    cameras.a->pace(83ms);
    cameras.a->pictures(12); // in a second
    QTRY_COMPARE(cameras.health(0).delivered, 72u);
    QVERIFY(cameras.health(0).slow);
    cameras.a->pictures(20);
    QTRY_COMPARE(cameras.health(0).delivered, 92u);
    QCOMPARE(cameras.health(0).slow->error.message(),
             std::string(
                 "camera play:: it takes only 12 pictures a second of the 30 it was asked for; give it more "
                 "light or a shorter exposure, or ask for a lower rate"));
    QCOMPARE(cameras.health(0).state, State::Delivering);
    QVERIFY2(healthWords(cameras.health(0)).ends_with(" frames/s (too slow), none lost"),
             healthWords(cameras.health(0)).c_str());
    cameras.a->error(gone); // whatever is worse is told instead
    QTRY_VERIFY(cameras.health(0).trouble);
    QVERIFY(!cameras.health(0).slow);
    cameras.a->pictures(24); // two seconds
    QTRY_VERIFY(cameras.health(0).slow);
    cameras.a->pace(PlayedCamera::interval);
    cameras.a->pictures(lot);
    QTRY_COMPARE(cameras.health(0).delivered, 146u);
    cameras.a->pictures(lot);
    QTRY_COMPARE(cameras.health(0).delivered, 176u);
    QVERIFY(!cameras.health(0).slow);
}

QTEST_GUILESS_MAIN(TestCaptureSession)
#include "tst_capture_session.moc"
