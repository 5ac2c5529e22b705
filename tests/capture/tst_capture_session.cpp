// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_reader.h"
#include "tests/capture/two_cameras.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QFile>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

using State = ViewHealth::State;

/// So many pictures of each camera, each lot taken before the next one.
void play(const TwoCameras &cameras, int lots)
{
    const std::uint64_t before = cameras.delivered();
    for (int i = 1; i <= lots; ++i) {
        cameras.frames(lot);
        QTRY_COMPARE(cameras.delivered(), before + std::uint64_t(i * lot));
    }
}

/// The numbers of the frames in a file, as the camera counted them: first, first + 1, and so on.
bool countUp(const std::vector<RawTime> &frames, std::uint64_t first)
{
    for (const RawTime &frame : frames) {
        if (frame.sequence != first++)
            return false;
    }
    return true;
}

} // namespace

class TestCaptureSession : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void recordsAllAndPairsThem();
    void recordsAgainAndAgain();
    void beginsBeforeItWasAskedTo();
    void whatWasKeptComesFirstWithoutAGap();
    void howLongFramesAreKeptCanBeChanged();
    void theMemoryOfWhatIsKeptIsBounded();
    void whatIsKeptDoesNotFillTheQueueToTheDisk();
    void whatIsLostWhileKeptIsLostByUs();
    void lostPicturesAreCounted();
    void whatASourceThrowsAwayIsLostByUs();
    void picturesThatTheCameraCodedAreKeptAsTheyCame();
    void subscribersGetPicturesAndLoseTheOldest();
    void healthKnowsTheClockAndHowWellTheyAreInStep();
    void whatChangesByItselfIsHeldWhileRecording();
    void theRoomIsKnownBeforeAnythingIsRecorded();
    void lossesOfWhatIsMadeHereAreNotTheWires();
    void allCamerasAreGivenTheRobotsToShow();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCaptureSession::recordsAllAndPairsThem()
{
    TwoCameras cameras;
    cameras.session->startRecording(filesIn(*m_folder));
    record(cameras, 2);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QVERIFY(!cameras.session->isRecording());
    QCOMPARE(outcome.views.size(), std::size_t(2));
    for (const ViewRecording &view : outcome.views) {
        QVERIFY(!view.problem);
        QCOMPARE(view.frames, 60u);
        QCOMPARE(view.lostOnWire + view.lostByUs, 0u);
        QCOMPARE(view.taken.size(), std::size_t(60));
        QCOMPARE(view.times.frames.size(), std::size_t(60));
        QCOMPARE(view.latenciesS.size(), std::size_t(60));
        const auto reader = VideoReader::open(view.file);
        QVERIFY(reader);
        QCOMPARE((*reader)->info().frameTimes.size(), std::size_t(60));
    }
    QCOMPARE(outcome.views[1].taken.front() - outcome.views[0].taken.front(), Nanoseconds(7ms));
    QCOMPARE(outcome.views[1].times.frames.front().device, Nanoseconds(3600s + 7ms));
    QCOMPARE(outcome.pairs.pairs, 60u);
    QCOMPARE(outcome.pairs.unpaired, 0u);
    for (const double errorS : outcome.pairs.errorsS)
        QVERIFY(std::abs(errorS - 0.007) < 1e-6);
}

void TestCaptureSession::recordsAgainAndAgain()
{
    TwoCameras cameras;
    cameras.frames(lot); // shown, and not recorded
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    for (const char *name : {"1.mkv", "2.mkv"}) {
        cameras.session->startRecording(filesIn(*m_folder, name, (std::string("b") + name).c_str()));
        record(cameras, 1);
        QCOMPARE(cameras.session->stopRecording().views[1].taken.size(), std::size_t(lot));
    }
    QCOMPARE(cameras.health(0).delivered, std::uint64_t(3 * lot));
}

void TestCaptureSession::beginsBeforeItWasAskedTo()
{
    // The last 300 ms are kept: ten pictures, each 33 ms after the other.
    TwoCameras cameras(300ms);
    cameras.frames(lot);
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    cameras.session->startRecording(filesIn(*m_folder), 1h);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    for (const ViewRecording &view : outcome.views) {
        QCOMPARE(view.times.frames.size(), std::size_t(10));
        QCOMPARE(view.times.frames.back().sequence, std::uint64_t(lot - 1));
    }
}

/// Five seconds of frames 33 ms apart are 152 of them; the others come while it records.
void TestCaptureSession::whatWasKeptComesFirstWithoutAGap()
{
    TwoCameras cameras(5s);
    play(cameras, 10);
    cameras.session->startRecording(filesIn(*m_folder), 1h);
    play(cameras, 2);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    for (const ViewRecording &view : outcome.views) {
        QCOMPARE(view.times.frames.size(), std::size_t(152 + 2 * lot));
        QVERIFY(countUp(view.times.frames, 300 - 152));
        for (std::size_t i = 1; i < view.times.frames.size(); ++i)
            QCOMPARE(view.times.frames[i].device - view.times.frames[i - 1].device, Nanoseconds(33ms));
        QCOMPARE(view.frames, 152u + 2 * lot);
        QCOMPARE(view.lostByUs + view.lostOnWire, 0u);
        QVERIFY(!view.keptOnlyFrom);
        // A frame of before has no latency from before: they claim to have been taken 20 s ago.
        QVERIFY(*std::ranges::max_element(view.latenciesS) < 19);
        const auto reader = VideoReader::open(view.file);
        QVERIFY(reader);
        QCOMPARE((*reader)->info().frameTimes.size(), view.times.frames.size());
        QCOMPARE((*reader)->info().frameTimes.back(), Nanoseconds((152 + 2 * lot - 1) * 33ms));
    }
}

void TestCaptureSession::howLongFramesAreKeptCanBeChanged()
{
    TwoCameras cameras(300ms);
    play(cameras, 1);
    cameras.session->setPreRoll(600ms); // none come back that were dropped
    play(cameras, 2);
    cameras.session->startRecording(filesIn(*m_folder), 1h);
    RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].times.frames.size(), std::size_t(19)); // 18 steps of 33 ms
    cameras.session->setPreRoll(0s);
    play(cameras, 1);
    cameras.session->startRecording(filesIn(*m_folder, "c.mkv", "d.mkv"), 1h);
    outcome = cameras.session->stopRecording();
    QVERIFY(outcome.views[0].times.frames.empty());
}

/// Frames of a megabyte, as of a large format: ten of them fit, of the 91 that are wanted.
void TestCaptureSession::theMemoryOfWhatIsKeptIsBounded()
{
    const auto script = std::make_shared<Script>();
    std::vector<std::unique_ptr<CameraSource>> cameras;
    cameras.push_back(std::make_unique<PlayedCamera>(
        script, PlayedCamera::Kind{.beginning = steadyNow() - 20s, .jpegBytes = 1'000'000}));
    CaptureSession session(std::move(cameras), {.preRoll = 3s, .preRollBytes = 10'500'000});
    QCOMPARE(session.preRollBytesOfView(), std::size_t(10'500'000));
    for (std::uint64_t lots = 1; lots <= 4; ++lots) {
        script->frames(lot);
        QTRY_COMPARE(session.health().views[0].delivered, lots * lot);
    }
    session.startRecording({filesIn(*m_folder).front()}, 1h);
    const RecordingOutcome outcome = session.stopRecording();
    const ViewRecording &view = outcome.views.front();
    QCOMPARE(view.times.frames.size(), std::size_t(10));
    QVERIFY(countUp(view.times.frames, 4 * lot - 10));
    QCOMPARE(view.keptOnlyFrom, std::optional(view.times.frames.front().arrival));
    QCOMPARE(view.lostByUs, 0u); // they belong to no recording
}

/// 80 MB are handed over at once, more than the 64 MB that may wait for a slow disk.
void TestCaptureSession::whatIsKeptDoesNotFillTheQueueToTheDisk()
{
    const auto script = std::make_shared<Script>();
    std::vector<std::unique_ptr<CameraSource>> cameras;
    cameras.push_back(std::make_unique<PlayedCamera>(
        script, PlayedCamera::Kind{.beginning = steadyNow() - 20s, .jpegBytes = 1'000'000}));
    CaptureSession session(std::move(cameras), {.preRoll = 10s});
    for (std::uint64_t lots = 1; lots <= 3; ++lots) {
        script->frames(lot);
        QTRY_COMPARE(session.health().views[0].delivered, lots * lot);
    }
    session.startRecording({filesIn(*m_folder).front()}, 1h);
    script->frames(lot);
    QTRY_COMPARE(session.health().views[0].delivered, 4u * lot);
    QVERIFY(session.health().disk.waiting < 0.6); // of which those of before are no part
    const RecordingOutcome outcome = session.stopRecording();
    const ViewRecording &view = outcome.views.front();
    QCOMPARE(view.lostByUs, 0u);
    QCOMPARE(view.times.frames.size(), std::size_t(4 * lot));
    QVERIFY(countUp(view.times.frames, 0));
}

void TestCaptureSession::whatIsLostWhileKeptIsLostByUs()
{
    TwoCameras cameras(5s);
    cameras.a->frames(10);
    cameras.a->loseHere(3);
    cameras.a->frames(10);
    cameras.b->frames(20);
    QTRY_COMPARE(cameras.delivered(), 20u);
    cameras.session->startRecording(filesIn(*m_folder), 1h);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].times.frames.size(), std::size_t(20));
    QCOMPARE(outcome.views[0].lostByUs, 3u);
    QCOMPARE(outcome.views[0].lostOnWire, 0u);
    QCOMPARE(outcome.views[1].lostByUs, 0u);
}

void TestCaptureSession::lostPicturesAreCounted()
{
    TwoCameras cameras;
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.a->frames(10);
    cameras.a->lose(2);
    cameras.a->frames(18);
    cameras.b->frames(lot);
    QTRY_VERIFY(cameras.health(0).delivered == 28 && cameras.health(1).delivered == lot);
    QCOMPARE(cameras.health(0).lostOnWire, 2u);
    QVERIFY(cameras.health(0).latencyS > 19); // they claim to have been taken 20 s ago, and a second apart
    QCOMPARE(
        healthWords(cameras.health(1)).english().substr(healthWords(cameras.health(1)).english().find(',')),
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
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.a->frames(10);
    cameras.a->loseHere(3);
    cameras.a->lose(2);
    cameras.a->frames(15);
    QTRY_COMPARE(cameras.health(0).delivered, 25u);
    QCOMPARE(cameras.health(0).lostOnWire, 2u);
    QCOMPARE(cameras.health(0).lostByUs, 3u);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].lostOnWire, 2u);
    QCOMPARE(outcome.views[0].lostByUs, 3u);
    QCOMPARE(outcome.views[0].frames, 28u); // came, whatever became of them
}

void TestCaptureSession::picturesThatTheCameraCodedAreKeptAsTheyCame()
{
    TwoCameras cameras(0s, 20s, {.codes = true});
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.a->frames(2);
    QTRY_COMPARE(cameras.health(0).delivered, 2u);
    const RecordingOutcome outcome = cameras.session->stopRecording();
    QCOMPARE(outcome.views[0].taken.size(), std::size_t(2));
    QFile file(QString::fromStdString(outcome.views[0].file.string()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    for (const char *image : {"picture 0 as it came", "picture 1 as it came"})
        QVERIFY(bytes.contains(image));
}

void TestCaptureSession::subscribersGetPicturesAndLoseTheOldest()
{
    TwoCameras cameras(0s, -1h);
    const auto quick = cameras.session->subscribeFrames(0, lot), slow = cameras.session->subscribeFrames(0),
               bored = cameras.session->subscribeFrames(0);
    bored->close();
    cameras.frames(lot);
    for (std::uint64_t i = 0; i < lot; ++i)
        QCOMPARE(quick->pop()->captured.sequence, i);
    QCOMPARE(quick->dropped(), 0u);
    QTRY_COMPARE(slow->dropped(), std::uint64_t(lot - 1));
    QCOMPARE(slow->pop()->captured.sequence, std::uint64_t(lot - 1));
    QTRY_COMPARE(cameras.delivered(), std::uint64_t(lot));
    cameras.session.reset();
    QVERIFY(!quick->pop());
}

void TestCaptureSession::healthKnowsTheClockAndHowWellTheyAreInStep()
{
    TwoCameras cameras(0s, -1h);
    QCOMPARE(cameras.health(0).state, State::Starting);
    QVERIFY(!cameras.health(0).clock);
    cameras.frames(lot);
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
    QCOMPARE(synchronisationWords(0.0012).english(),
             std::string("synchronised to 1.2 ms; at 2 m/s that is 2.4 mm"));
}

void TestCaptureSession::whatChangesByItselfIsHeldWhileRecording()
{
    TwoCameras cameras(0s, 20s, {.notHeld = {foreignWords("White balance")}});
    cameras.frames(1);
    QTRY_COMPARE(cameras.delivered(), 1u);
    QVERIFY(!cameras.health(0).automaticsHeld);
    cameras.session->startRecording(filesIn(*m_folder));
    cameras.frames(2);
    QTRY_VERIFY(cameras.health(0).automaticsHeld && cameras.health(1).automaticsHeld);
    QVERIFY(!*cameras.health(0).automaticsHeld);
    QCOMPARE(test::english(cameras.health(0).notHeld), std::vector<std::string>{"White balance"});
    QVERIFY(*cameras.health(1).automaticsHeld);
    QVERIFY(cameras.a->held && cameras.b->held);

    cameras.session->stopRecording();
    cameras.frames(1); // with the next picture they are given back
    QTRY_VERIFY(!cameras.a->held && !cameras.b->held);
    QVERIFY(!cameras.health(0).automaticsHeld);

    cameras.session->startRecording(filesIn(*m_folder, "a2.mkv", "b2.mkv"));
    cameras.frames(2);
    QTRY_VERIFY(cameras.a->held && cameras.b->held);
    cameras.session.reset(); // in the midst of it
    QVERIFY(!cameras.a->held && !cameras.b->held);
}

void TestCaptureSession::theRoomIsKnownBeforeAnythingIsRecorded()
{
    TwoCameras cameras(2s);
    QVERIFY(!cameras.session->remainingSeconds(m_folder->path().toStdString()));
    cameras.frames(lot); // almost a second
    const auto space = [&] { return cameras.session->remainingSeconds(m_folder->path().toStdString()); };
    QTRY_VERIFY(space() && *space() > 0);
    QVERIFY(!cameras.session->remainingSeconds("/no/such/folder"));
}

void TestCaptureSession::lossesOfWhatIsMadeHereAreNotTheWires()
{
    ViewHealth view;
    view.state = ViewHealth::State::Delivering;
    view.framesPerSecond = 30;
    view.lostOnWire = 3;
    QCOMPARE(healthWords(view).english(), std::string("30.0 frames/s, 3 lost on the wire"));
    view.hasWire = comesByWire("simulated");
    QCOMPARE(healthWords(view).english(),
             std::string("30.0 frames/s, 3 lost because this machine is too slow"));
    QVERIFY(!comesByWire("file") && comesByWire("v4l2") && comesByWire("aravis"));
}

void TestCaptureSession::allCamerasAreGivenTheRobotsToShow()
{
    TwoCameras cameras;
    QVERIFY(cameras.a->robotsToShow == -1 && cameras.b->robotsToShow == -1);
    cameras.session->showRobots(std::vector<RobotAppearance>(2));
    QVERIFY(cameras.a->robotsToShow == 2 && cameras.b->robotsToShow == 2);
}

ODOGRAPH_TEST(TestCaptureSession, QCoreApplication)
#include "tst_capture_session.moc"
