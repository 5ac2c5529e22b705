// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in the emulated machine: webcams that are unplugged, frozen, swapped, taken by another program, and
// that return, while a session records two of them.
#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "core/capture/v4l2/internal/v4l2_stream.h"
#include "core/video/video_reader.h"
#include "tests/vm/machine_stalls.h"
#include "tests/vm/played_cameras.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <linux/videodev2.h>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

constexpr Nanoseconds told = 1s;

bool isWaiting(const CaptureSession &session, std::size_t view)
{
    return session.health().views.at(view).state == ViewHealth::State::Waiting;
}

QByteArray warningOf(const CaptureSession &session, std::size_t view)
{
    const auto health = session.health();
    return health.views.at(view).warning
               ? QByteArray::fromStdString(health.views[view].warning->error.message())
               : QByteArray();
}

} // namespace

class TestUvcFaults : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_a = playedCamera(0, "Camera A", "A1");
        m_b = playedCamera(1, "Camera B", "B2");
        QVERIFY(m_a && m_b);
        QTRY_COMPARE(usbCameras().size(), std::size_t(2));
        m_place = playedUri("A1");
        std::vector<std::unique_ptr<CameraSource>> sources;
        sources.push_back(opened(m_place));
        sources.push_back(opened(playedUri("B2")));
        m_session = std::make_unique<CaptureSession>(std::move(sources));
        QTRY_VERIFY(delivered(0) > 3 && delivered(1) > 3);
    }

    void cleanup()
    {
        m_session.reset();
        m_a.reset();
        m_b.reset();
        QTRY_VERIFY(usbCameras().empty());
    }

    void unpluggedAndPluggedInAgain()
    {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        m_session->startRecording({path / "a.mkv", path / "b.mkv"});
        waitForFrames(1, 5);
        m_a->unplug();
        isToldSoon(0, "it was unplugged; plug it in again");
        theOtherGoesOn();
        m_a = playedCamera(0, "Camera A", "A1"); // fresh from the shop: with its automatics on
        QVERIFY(m_a);
        returns(0);
        QVERIFY(!m_a->controls().isAnyAutomaticOn()); // recording holds them
        QCOMPARE(m_a->controls().whiteBalance(), 5200);
        const RecordingOutcome outcome = m_session->stopRecording();
        QCOMPARE(outcome.views[0].gaps.size(), std::size_t(1));
        QVERIFY(outcome.views[1].gaps.empty());
        QVERIFY(outcome.views[0].lostOnWire > 0); // what it missed is counted
        QVERIFY(!outcome.views[0].problem && !outcome.views[1].problem);
        for (const ViewRecording &view : outcome.views) {
            auto reader = VideoReader::open(view.file);
            QVERIFY(reader);
            std::size_t frames = 0;
            for (auto frame = (*reader)->next(); frame && *frame; frame = (*reader)->next())
                ++frames;
            QCOMPARE(frames, view.taken.size());
        }
    }

    void frozen()
    {
        m_a->setStalled(true);
        isToldSoon(
            0, "it is connected but sends no frames; check its cable; if this continues, plug it in again");
        theOtherGoesOn();
        m_a->setStalled(false);
        returns(0);
    }

    void swappedForAnother()
    {
        m_a->unplug();
        isToldSoon(0, "plug it in again");
        auto stranger = playedCamera(0, "Camera C", "C3");
        QTRY_VERIFY2(warningOf(*m_session, 0).contains("has replaced it; plug Camera A"),
                     warningOf(*m_session, 0));
        theOtherGoesOn();
        stranger.reset();
        m_a = playedCamera(0, "Camera A", "A1");
        returns(0);
    }

    void returnsAtAnotherPort()
    {
        m_a->unplug();
        isToldSoon(0, "it was unplugged");
        m_a = playedCamera(3, "Camera A", "A1");
        returns(0);
        theOtherGoesOn();
    }

    /// The other program was faster when the camera came back.
    void takenByAnotherProgram()
    {
        m_session.reset();
        auto source = opened(m_place);
        QVERIFY(source && !take(*source, 3).frames.empty());
        m_a.reset();
        m_a = playedCamera(0, "Camera A", "A1");
        QVERIFY(m_a);
        QTRY_VERIFY(!playedUri("A1").empty()); // at another node, because the source still holds the former
        {
            const std::string place = playedUri("A1"), node = place.substr(5, place.find('?') - 5);
            const auto other =
                V4l2Stream::start(*V4l2Device::open(node, node), {V4L2_PIX_FMT_YUYV, 320, 240, 1, 5}, node);
            QVERIFY2(other, other ? "" : other.error().message().c_str());
            const Taken none = take(*source, 1, 2);
            QVERIFY(none.frames.empty());
            QVERIFY2(none.problems.back().message().ends_with("another program uses it; close that program"),
                     none.problems.back().message().c_str());
            QVERIFY(usbCameras().at(0).busy || usbCameras().at(1).busy);
        }
        QCOMPARE(take(*source, 3).frames.size(), std::size_t(3));
    }

    void stoppingWakesWhoWaits()
    {
        m_session.reset();
        auto source = opened(m_place);
        m_a->setStalled(true);
        std::jthread stopper([&] { source->stop(); });
        auto captured = source->next();
        while (captured)
            captured = source->next();
        QCOMPARE(captured.error().code, ErrorCode::Cancelled);
    }

private:
    std::uint64_t delivered(std::size_t view) const { return m_session->health().views.at(view).delivered; }
    void waitForFrames(std::size_t view, std::uint64_t more)
    {
        const std::uint64_t before = delivered(view);
        QTRY_VERIFY(delivered(view) >= before + more);
    }
    void isToldSoon(std::size_t view, const char *words)
    {
        const MachineStalls stalls;
        const Nanoseconds from = steadyNow();
        std::optional<RecordingWarning> warning;
        QTRY_VERIFY((warning = m_session->health().views.at(view).warning));
        const Nanoseconds after = warning->since - from, stalled = stalls.total();
        qInfo("told after %.2f s, of which the machine stood still for %.2f", toSeconds(after),
              toSeconds(stalled));
        QVERIFY2(after - stalled < told, QByteArray::number(toSeconds(after)));
        QTRY_VERIFY(isWaiting(*m_session, view));
        QTRY_VERIFY2(warningOf(*m_session, view).contains(words), warningOf(*m_session, view));
    }
    /// It delivers, and was not touched.
    void theOtherGoesOn()
    {
        waitForFrames(1, 5);
        const ViewHealth other = m_session->health().views[1];
        QCOMPARE(other.state, ViewHealth::State::Delivering);
        QVERIFY(!other.warning);
        QCOMPARE(other.source.reconnections, std::uint64_t(0));
    }
    void returns(std::size_t view)
    {
        waitForFrames(view, 5);
        QTRY_COMPARE(m_session->health().views[view].state, ViewHealth::State::Delivering);
        QVERIFY(!m_session->health().views[view].warning);
    }

    std::unique_ptr<UvcCamera> m_a, m_b;
    std::string m_place;
    std::unique_ptr<CaptureSession> m_session;
};

QTEST_GUILESS_MAIN(TestUvcFaults)
#include "tst_uvc_faults.moc"
