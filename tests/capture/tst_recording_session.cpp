// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/recording_session.h"
#include "core/video/video_reader.h"

#include <QTemporaryDir>
#include <QTest>
#include <atomic>

using namespace odo;
using namespace std::chrono_literals;

namespace {

const FrameFormat format{160, 96};

/// A camera without a pace, whose clock began at another time than ours; it loses some pictures, and may fail after the last.
class PlayedCamera : public CameraSource
{
public:
    struct Play
    {
        int pictures = 60;
        Nanoseconds clockStart{0}, phase{0};
        std::vector<int> lost;
        std::optional<Error> end; ///< none: it waits to be stopped
    };
    explicit PlayedCamera(Play play) : m_play(std::move(play)) {}

    const CameraDescription &description() const override { return m_description; }
    void stop() override { m_stopped = true; m_stopped.notify_all(); }
    Result<CapturedFrame> next() override
    {
        while (std::ranges::find(m_play.lost, m_sequence) != m_play.lost.end())
            ++m_sequence;
        if (m_sequence >= m_play.pictures) {
            if (m_play.end)
                return tl::unexpected(*m_play.end);
            m_stopped.wait(false);
        }
        if (m_stopped)
            return cancelled("played camera");
        const Nanoseconds time = m_sequence * interval + m_play.phase;
        CapturedFrame captured;
        captured.frame = FrameBuffer::toFrame(std::make_shared<FrameBuffer>(format), m_sequence, time - m_play.clockStart);
        captured.sequence = std::uint64_t(m_sequence++);
        captured.hostTime = beginning + time;
        return captured;
    }

    static constexpr Nanoseconds interval = 33ms;
    static inline const Nanoseconds beginning = std::chrono::steady_clock::now().time_since_epoch();

private:
    const Play m_play;
    const CameraDescription m_description{"play:", "played", "Played", format.width, format.height, 30, {}};
    int m_sequence = 0;
    std::atomic<bool> m_stopped = false;
};

} // namespace

class TestRecordingSession : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void recordsAllAndPairsThem();
    void lostPicturesAreCounted();
    void aCameraThatIsLostEndsItAndKeepsWhatThereIs();
    void aDiskThatFailsEndsIt();

private:
    RecordedCamera camera(const char *name, PlayedCamera::Play play)
    {
        return {std::make_unique<PlayedCamera>(std::move(play)), m_folder.filePath(QString::fromLatin1(name)).toStdString()};
    }
    static std::vector<RecordedCamera> both(RecordedCamera a, RecordedCamera b)
    {
        std::vector<RecordedCamera> cameras;
        cameras.push_back(std::move(a));
        cameras.push_back(std::move(b));
        return cameras;
    }
    QTemporaryDir m_folder;
};

void TestRecordingSession::recordsAllAndPairsThem()
{
    // B's clock began an hour before A's, and B takes its pictures 7 ms later.
    RecordingSession session(both(camera("a.mkv", {}), camera("b.mkv", {.clockStart = -3600s, .phase = 7ms})));
    QTRY_COMPARE(session.frames(), 60u);
    QVERIFY(!session.hasEnded());
    const RecordingOutcome outcome = session.finish();
    QCOMPARE(outcome.views.size(), std::size_t(2));
    for (const ViewRecording &view : outcome.views) {
        QVERIFY(!view.problem);
        QCOMPARE(view.lostOnWire, 0u);
        QCOMPARE(view.taken.size() + view.lostByUs, std::size_t(60)); // cameras without a pace may be too fast for the disk
        QCOMPARE(view.latenciesS.size(), view.taken.size());
        const auto reader = VideoReader::open(view.file);
        QVERIFY(reader);
        QCOMPARE((*reader)->info().frameTimes.size(), view.taken.size());
    }
    QCOMPARE(outcome.views[1].taken.front() - outcome.views[0].taken.front(), Nanoseconds(7ms));
    QCOMPARE(outcome.pairs.pairs, 60u);
    QCOMPARE(outcome.pairs.unpaired, 0u);
    for (const double errorS : outcome.pairs.errorsS)
        QVERIFY(std::abs(errorS - 0.007) < 1e-6);
}

void TestRecordingSession::lostPicturesAreCounted()
{
    RecordingSession session(both(camera("c.mkv", {.lost = {10, 11, 40}}), camera("d.mkv", {})));
    QTRY_COMPARE(session.frames(), 57u);
    const RecordingOutcome outcome = session.finish();
    QCOMPARE(outcome.views[0].lostOnWire, 3u);
    QCOMPARE(outcome.views[1].lostOnWire, 0u);
    QCOMPARE(outcome.pairs.pairs, 57u);
    QCOMPARE(outcome.pairs.unpaired, 3u);
}

void TestRecordingSession::aCameraThatIsLostEndsItAndKeepsWhatThereIs()
{
    const Error gone{ErrorCode::Io, "camera B", "it was unplugged", "plug it in"};
    RecordingSession session(both(camera("e.mkv", {}), camera("f.mkv", {.pictures = 20, .end = gone})));
    QTRY_VERIFY(session.hasEnded());
    const RecordingOutcome outcome = session.finish();
    QVERIFY(!outcome.views[0].problem);
    QVERIFY(outcome.views[1].problem);
    QCOMPARE(outcome.views[1].problem->why, gone.why);
    QCOMPARE(outcome.views[1].taken.size(), std::size_t(20));
    QVERIFY(VideoReader::open(outcome.views[1].file));
}

void TestRecordingSession::aDiskThatFailsEndsIt()
{
    RecordingSession session(both(camera("g.mkv", {}), camera("no/folder/h.mkv", {})));
    QTRY_VERIFY(session.hasEnded());
    const RecordingOutcome outcome = session.finish();
    QVERIFY(outcome.views[1].problem);
    QCOMPARE(outcome.views[1].problem->code, ErrorCode::Io);
    QVERIFY(outcome.views[1].taken.empty());
    QVERIFY(!outcome.views[0].problem);
}

QTEST_GUILESS_MAIN(TestRecordingSession)
#include "tst_recording_session.moc"
