// SPDX-License-Identifier: GPL-3.0-or-later
// A machine that sleeps while it records: the clock that pictures are told by goes on, as the cameras' own
// do, and what waits and what drivers stamp by stands still. The machine sleeps by word of this test, which
// gives machineSlept() itself.
#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "core/video/video_reader.h"
#include "tests/capture/aravis/frame_taker.h"
#include "tests/capture/played_camera.h"
#include "tests/capture/played_driver.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

std::atomic<Nanoseconds::rep> slept = 0;
constexpr Nanoseconds told = 1s * slowness;

void sleepFor(Nanoseconds howLong)
{
    slept += howLong.count();
}

} // namespace

Nanoseconds odo::machineSlept()
{
    return Nanoseconds(slept.load());
}

class TestMachineSleep : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void cleanup()
    {
        m_session.reset();
        m_driver.reset();
    }

    void aRecordingGoesOnWithAGap()
    {
        const Nanoseconds beginning = steadyNow() - 20s;
        auto a = std::make_shared<Script>(), b = std::make_shared<Script>();
        begin(std::make_unique<PlayedCamera>(a, PlayedCamera::Kind{.beginning = beginning}),
              std::make_unique<PlayedCamera>(
                  b, PlayedCamera::Kind{.beginning = beginning, .clockStart = -3600s, .phase = 7ms}));
        for (const auto &script : {a, b})
            script->frames(20);
        QTRY_VERIFY(delivered(0) == 20 && delivered(1) == 20);
        QVERIFY(!m_session->health().sleep);
        for (const auto &script : {a, b})
            script->pass(300s);
        sleepFor(300s);
        isTold("it slept for 5 min and recorded nothing meanwhile; the recording up to then is kept; keep it "
               "awake while it records");
        QVERIFY(!view(0).warning); // it has not had the time to deliver since
        for (const auto &script : {a, b})
            script->frames(10);
        QTRY_VERIFY(delivered(0) == 30 && delivered(1) == 30);
        QVERIFY(!view(0).slow && !view(0).warning);
        QVERIFY(m_session->health().sleep); // as long as it records
        const RecordingOutcome outcome = m_session->stopRecording();
        for (const ViewRecording &recording : outcome.views)
            hasOneGap(recording, 300s, 2ms); // a file counts milliseconds
        QCOMPARE(outcome.pairs.pairs, 30u);
        m_session->startRecording(files()); // of another run
        QVERIFY(!m_session->health().sleep);
    }

    /// Its clock goes on, and so does its stream, because it was asked again before it gave its connection
    /// up.
    void aGigeCameraGoesOnAfterAShortSleep()
    {
        SimulatedGigeCamera a({.address = "127.31.6.2", .serial = "A", .clockPpm = 50}, codedPainter()),
            b({.address = "127.31.6.3", .serial = "B", .clockPpm = -50}, codedPainter());
        begin(opened("aravis:127.31.6.2"), opened("aravis:127.31.6.3"));
        QTRY_VERIFY(delivered(0) > 30 && delivered(1) > 30);
        sleepFor(1500ms);
        isTold("it slept for 2 s");
        goesOn(0);
        goesOn(1);
        const RecordingOutcome outcome = m_session->stopRecording();
        // By how long a busy machine may hold up the pictures beside the sleep.
        for (const ViewRecording &recording : outcome.views)
            hasOneGap(recording, 1500ms, 500ms * slowness);
        QCOMPARE(view(0).source.reconnections + view(1).source.reconnections, 0u);
    }

    /// It has heard nothing for longer than it keeps a connection, and is taken up anew.
    void aGigeCameraIsTakenUpAfterALongSleep()
    {
        SimulatedGigeCamera camera({.address = "127.31.6.4", .clockPpm = 50}, codedPainter());
        const auto source = opened("aravis:127.31.6.4");
        QVERIFY(source);
        FrameTaker taker(*source);
        QTRY_VERIFY(taker.count() > 30);
        sleepFor(1h);
        const Nanoseconds woken = steadyNow();
        QTRY_VERIFY_WITH_TIMEOUT(taker.countSince(woken) > 30, 15000 * slowness);
        QVERIFY(source->counts().reconnections == 1);
        const auto frames = taker.frames();
        const auto &first = frames.front(), &last = frames.back();
        QVERIFY(last.time - first.time > 1h);
        const double errorMs =
            1e3 * toSeconds((last.time - first.time) - (last.code.begin - first.code.begin));
        // 50 ppm of an hour: the camera's clock is right by its own measure.
        QVERIFY2(std::abs(errorMs) < 200 * slowness, qPrintable(QString::number(errorMs)));
        for (std::size_t i = 1; i < frames.size(); ++i)
            QVERIFY(frames[i].time > frames[i - 1].time && frames[i].sequence > frames[i - 1].sequence);
    }

    /// Its driver's stamps stand still meanwhile.
    void aUsbCameraGoesOn()
    {
        m_driver = std::make_unique<PlayedDriver>();
        begin(opened(m_driver->uri()));
        QTRY_VERIFY(delivered(0) > 30);
        sleepFor(90s);
        isTold("it slept for 90 s");
        goesOn(0);
        const RecordingOutcome outcome = m_session->stopRecording();
        hasOneGap(outcome.views[0], 90s, 500ms * slowness);
        QVERIFY(outcome.views[0].clockSigmaS < 0.001); // its stamps are still believed
        QCOMPARE(view(0).source.reconnections, 0u);
    }

private:
    template <class... Sources>
    void begin(Sources... sources)
    {
        std::vector<std::unique_ptr<CameraSource>> cameras;
        (cameras.push_back(std::move(sources)), ...);
        QVERIFY(std::ranges::all_of(cameras, [](const auto &camera) { return camera != nullptr; }));
        m_session = std::make_unique<CaptureSession>(std::move(cameras), CaptureSettings{.preRoll = 0s});
        m_session->startRecording(files());
    }
    std::vector<std::filesystem::path> files()
    {
        const std::filesystem::path folder = m_folder->path().toStdString();
        ++m_recordings;
        return {folder / (std::to_string(m_recordings) + "a.mkv"),
                folder / (std::to_string(m_recordings) + "b.mkv")};
    }
    ViewHealth view(std::size_t number) const { return m_session->health().views[number]; }
    std::uint64_t delivered(std::size_t number) const { return view(number).delivered; }
    void isTold(const std::string &words) const
    {
        const Nanoseconds woken = steadyNow();
        std::optional<RecordingWarning> sleep;
        QTRY_VERIFY((sleep = m_session->health().sleep));
        QVERIFY(sleep->since - woken < told);
        QVERIFY2(sleep->error.message().find(words) != std::string::npos, sleep->error.message().c_str());
    }
    void goesOn(std::size_t number) const
    {
        const std::uint64_t before = delivered(number);
        QTRY_VERIFY(delivered(number) > before + 30);
        QTRY_VERIFY(view(number).state == ViewHealth::State::Delivering && !view(number).warning);
    }
    /// That is as long as the sleep, by when the pictures are said to have been taken, and in the file. One
    /// may have been under way when the machine fell asleep, and come thereafter.
    static void hasOneGap(const ViewRecording &recording, Nanoseconds length, Nanoseconds tolerance)
    {
        QVERIFY(!recording.problem);
        const auto isOfTheSleep = [](const RecordingGap &gap) {
            return gap.why.what.english() == "this computer";
        };
        // A machine that stalls may make others.
        QCOMPARE(std::ranges::count_if(recording.gaps, isOfTheSleep), 1);
        const RecordingGap &gap = *std::ranges::find_if(recording.gaps, isOfTheSleep);
        const auto reader = VideoReader::open(recording.file);
        QVERIFY(reader);
        const std::vector<Nanoseconds> &inFile = (*reader)->info().frameTimes;
        QCOMPARE(inFile.size(), recording.taken.size());
        QVERIFY(gap.before + 1 < inFile.size());
        const auto around = [&gap](const std::vector<Nanoseconds> &times) {
            return times[gap.before + 1] - times[gap.before - 1];
        };
        for (const Nanoseconds passed :
             {around(recording.taken), around(inFile), gap.length + PlayedCamera::interval})
            QVERIFY2(std::chrono::abs(passed - length - 2 * PlayedCamera::interval) <= tolerance,
                     qPrintable(QString::number(toSeconds(passed))));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<PlayedDriver> m_driver;
    std::unique_ptr<CaptureSession> m_session;
    int m_recordings = 0;
};

ODOGRAPH_TEST(TestMachineSleep, QCoreApplication)
#include "tst_machine_sleep.moc"
