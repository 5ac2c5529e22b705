// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in the emulated machine: drops, errors, clocks and counts that go wrong, and a camera that is taken
// away.
#include "core/base/steady_now.h"
#include "core/capture/capture_session.h"
#include "core/capture/v4l2/internal/v4l2_device.h"
#include "tests/vm/machine_stalls.h"
#include "tests/vm/vivid_cameras.h"

#include <QTest>
#include <algorithm>
#include <atomic>
#include <linux/videodev2.h>
#include <thread>

using namespace odo;
using namespace odo::test;

namespace {

const std::string node = "/dev/video0", other = "/dev/video1", mode = "?size=320x180&rate=50&format=YUYV";

std::unique_ptr<CameraSource> camera(const std::string &at = node)
{
    return opened("v4l2:" + at + mode);
}

/// As another program would.
void setRate(unsigned framesPerSecond)
{
    const auto device = V4l2Device::open(node, node);
    QVERIFY(device);
    v4l2_streamparm parameters{};
    parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    parameters.parm.capture.timeperframe = {1, framesPerSecond};
    QCOMPARE((*device)->call(VIDIOC_S_PARM, &parameters), 0);
}

} // namespace

class TestVividFaults : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        setVivid(node, "timestamp_source", 1);
        setVivid(node, "wrap_sequence_number", 0);
        setVivid(node, "wrap_timestamp", 0);
        setVivid(node, "percentage_of_dropped_buffers", 0);
    }

    void dropsAreCounted()
    {
        setVivid(node, "percentage_of_dropped_buffers", 30);
        const Taken taken = take(*camera(), 60);
        QCOMPARE(taken.frames.size(), std::size_t(60));
        QVERIFY(rises(taken));
        // Of 60/0.7 = 86 pictures 26 are lost, ±4 (binomial); on a busy host more.
        QVERIFY2(taken.lost >= 10, QByteArray::number(int(taken.lost)));
    }

    /// The count begins 128 before its end.
    void theCountWraps()
    {
        setVivid(node, "wrap_sequence_number", 1);
        const auto source = camera();
        const Taken taken = take(*source, 140);
        QCOMPARE(taken.frames.size(), std::size_t(140));
        QVERIFY(rises(taken));
        QVERIFY2(taken.lost < 70, QByteArray::number(int(taken.lost))); // not four billion
    }

    void clocksGoOn_data()
    {
        QTest::addColumn<int>("source");
        QTest::addColumn<int>("wrap");
        QTest::newRow("at the beginning of the exposure") << 1 << 0;
        QTest::newRow("at its end, which vivid puts into the future") << 0 << 0;
        QTest::newRow("64 bits of nanoseconds end") << 1 << 1;
        QTest::newRow("31 bits of seconds end") << 1 << 2;
    }

    void clocksGoOn()
    {
        QFETCH(int, source);
        QFETCH(int, wrap);
        setVivid(node, "timestamp_source", source);
        setVivid(node, "wrap_timestamp", wrap);
        const Taken taken = take(*camera(), 50);
        QCOMPARE(taken.frames.size(), std::size_t(50));
        QVERIFY(rises(taken));
        const double seconds = toSeconds(taken.frames.back().frame.time);
        QVERIFY2(std::abs(seconds * 50 / double(taken.span() - 1) - 1) < 0.05, QByteArray::number(seconds));
        QCOMPARE(taken.frames.back().clock.has_value(), source == 1 && wrap == 0);
        ClockMap clock;
        for (const CapturedFrame &captured : taken.frames) {
            clock.addArrival(captured.frame.time, captured.hostTime);
            if (captured.clock)
                clock.addLatch(captured.clock->device, captured.clock->before, captured.clock->after);
        }
        QCOMPARE(clock.epoch(), 0);
        // Nothing was taken after it arrived, nor half a second before.
        const Nanoseconds latency =
            taken.frames.back().hostTime - clock.fit()->hostTime(taken.frames.back().frame.time);
        QVERIFY2(latency >= Nanoseconds(-1000000) && latency < std::chrono::milliseconds(500),
                 QByteArray::number(qint64(latency.count())));
    }

    void aDamagedPictureIsThrownAwayAndCounted()
    {
        const auto source = camera();
        const Taken before = take(*source, 5);
        setVivid(node, "inject_v4l2_buf_flag_error", 1);
        const Taken after = take(*source, 15);
        QVERIFY(after.problems.empty());
        QCOMPARE(source->counts().damaged, std::uint64_t(1));
        QVERIFY(after.frames.back().sequence - before.frames.back().sequence >= 16); // it left a gap
    }

    void whatBreaksIsStartedAnew_data()
    {
        QTest::addColumn<QByteArray>("control");
        QTest::newRow("the stream") << QByteArray("inject_fatal_streaming_error");
        QTest::newRow("giving back a buffer") << QByteArray("inject_vidioc_qbuf_error");
        QTest::newRow("the device") << QByteArray("disconnect");
    }

    void whatBreaksIsStartedAnew()
    {
        QFETCH(QByteArray, control);
        const auto source = camera(), beside = camera(other);
        QVERIFY(source->set("brightness", 99));
        const Taken before = take(*source, 5), besideBefore = take(*beside, 5);
        setVivid(node, control.toStdString(), 1);
        const Taken after = take(*source, 15);
        QCOMPARE(after.frames.size(), std::size_t(15));
        QVERIFY(rises(after));
        QVERIFY(after.frames.front().sequence > before.frames.back().sequence);
        QVERIFY(after.frames.front().frame.time > before.frames.back().frame.time);
        QCOMPARE(source->counts().reconnections, std::uint64_t(1));
        const auto controls = source->controls();
        QCOMPARE(std::ranges::find(*controls, "brightness", &CameraControl::id)->value, 99.0);
        const Taken besideAfter = take(*beside, 15);
        QVERIFY(besideAfter.problems.empty());
        QCOMPARE(beside->counts().reconnections, std::uint64_t(0));
    }

    /// While one thread takes pictures and the camera breaks again and again.
    void theRestMayBeCalledFromAnyThread()
    {
        const auto source = camera();
        std::atomic<bool> goOn = true;
        std::size_t answers = 0;
        std::thread asking([&] {
            while (goOn) {
                answers += source->controls().has_value() ? 1 : 0;
                (void)source->set("brightness", double(answers % 200)); // fails while it is lost
                (void)source->holdAutomatics();
                (void)source->counts();
            }
        });
        for (int i = 0; i < 5; ++i) {
            setVivid(node, "disconnect", 1);
            (void)take(*source, 10);
        }
        goOn = false;
        asking.join();
        QVERIFY(answers > 0);
        QVERIFY(source->counts().reconnections >= 1);
        QCOMPARE(take(*source, 5).frames.size(), std::size_t(5));
    }

    void whatCannotBeStartedSaysSo_data()
    {
        QTest::addColumn<QByteArray>("control");
        QTest::newRow("buffers") << QByteArray("inject_vidioc_reqbufs_error");
        QTest::newRow("stream") << QByteArray("inject_vidioc_streamon_error");
    }

    void whatCannotBeStartedSaysSo()
    {
        QFETCH(QByteArray, control);
        setVivid(node, control.toStdString(), 1);
        const auto source = openCamera("v4l2:" + node + mode);
        QVERIFY(!source);
        QCOMPARE(source.error().code, ErrorCode::Unavailable);
        QVERIFY(source.error().message().find(
                    "it failed (Invalid argument); if this continues, unplug it and plug it in again") !=
                std::string::npos);
        QVERIFY(camera()); // the error is gone, and nothing was left open
    }

    void aSecondProgramIsTold()
    {
        const auto source = camera();
        const auto second = openCamera("v4l2:" + node + mode);
        QVERIFY(!second);
        QCOMPARE(second.error().code, ErrorCode::Unavailable);
        QVERIFY(second.error().message().ends_with("another program uses it; close that program"));
        QVERIFY(take(*source, 5).problems.empty());
    }

    /// The driver lets any program change the rate under us: what comes stays true, and nothing counts as
    /// lost for it.
    void anotherRateByAnotherProgram()
    {
        const auto source = camera();
        QVERIFY(!take(*source, 5).frames.empty());
        setRate(10);
        (void)take(*source, 10); // those that were under way
        const Taken slow = take(*source, 15);
        QVERIFY(slow.problems.empty());
        QVERIFY(rises(slow));
        const double perFrame = toSeconds(slow.frames.back().frame.time - slow.frames.front().frame.time) /
                                double(slow.span() - 1);
        QVERIFY2(std::abs(perFrame / 0.1 - 1) < 0.1, QByteArray::number(perFrame));
    }

    /// As when its automatic exposure needs more light; the other camera is told nothing of.
    void fewerPicturesAreTold()
    {
        std::vector<std::unique_ptr<CameraSource>> cameras;
        cameras.push_back(camera());
        cameras.push_back(camera(other));
        CaptureSession session(std::move(cameras));
        const auto views = [&] { return session.health().views; };
        QTRY_VERIFY(views()[0].delivered > 100 && views()[1].delivered > 100);
        setRate(10);
        const MachineStalls stalls;
        const Nanoseconds slowed = steadyNow();
        QTRY_VERIFY(views()[0].slow);
        const Nanoseconds after = steadyNow() - slowed, stalled = stalls.total();
        qInfo("told after %.2f s, of which the machine stood still for %.2f", toSeconds(after),
              toSeconds(stalled));
        QVERIFY2(after - stalled < std::chrono::seconds(2), QByteArray::number(toSeconds(after)));
        const auto words = [&] {
            const auto slow = views()[0].slow;
            return slow ? slow->error.message() : std::string();
        };
        QTRY_VERIFY2(words().ends_with("it delivers only 10 frames per second instead of the requested 50; "
                                       "give it more light or a shorter exposure, or ask for a lower rate"),
                     words().c_str());
        QTRY_COMPARE(views()[0].state, ViewHealth::State::Delivering);
        QVERIFY(!views()[1].slow);
        setRate(50);
        QTRY_VERIFY(!views()[0].slow);
    }

    /// Not even what is no camera ends it.
    void somethingElseInItsPlaceIsWaitedOut()
    {
        const auto source = camera();
        QVERIFY(!take(*source, 5).frames.empty());
        QVERIFY(shell("echo vivid.0 >/sys/bus/platform/drivers/vivid/unbind && touch /dev/video0"));
        (void)take(*source, 100, 1);               // those that were under way
        QVERIFY(source->holdAutomatics().empty()); // while it is not there
        const auto none = source->next();
        QVERIFY(!none);
        QCOMPARE(none.error().code, ErrorCode::Unavailable);
        QVERIFY2(none.error().message().find("/dev/video0 sends no frames") != std::string::npos,
                 none.error().message().c_str());
        QVERIFY(shell("rm /dev/video0 && echo vivid.0 >/sys/bus/platform/drivers/vivid/bind"));
        QCOMPARE(take(*source, 5).frames.size(), std::size_t(5));
        const auto controls = source->controls();
        QCOMPARE(std::ranges::find(*controls, "gain_automatic", &CameraControl::id)->value,
                 0.0); // held when it came back
    }

    /// As when a hub is unplugged: both nodes go. The session says so at once, and goes on when they are
    /// back.
    void removedAndBroughtBack()
    {
        std::vector<std::unique_ptr<CameraSource>> cameras;
        cameras.push_back(camera());
        CaptureSession session(std::move(cameras));
        const auto state = [&] { return session.health().views.at(0).state; };
        QTRY_COMPARE(state(), ViewHealth::State::Delivering);
        QVERIFY(shell("echo vivid.0 >/sys/bus/platform/drivers/vivid/unbind"));
        const MachineStalls stalls;
        const Nanoseconds gone = steadyNow();
        std::optional<RecordingWarning> warning;
        QTRY_VERIFY((warning = session.health().views[0].warning));
        QCOMPARE(state(), ViewHealth::State::Waiting);
        const Nanoseconds after = warning->since - gone, stalled = stalls.total();
        qInfo("told after %.2f s, of which the machine stood still for %.2f", toSeconds(after),
              toSeconds(stalled));
        QVERIFY2(after - stalled < std::chrono::seconds(1), QByteArray::number(toSeconds(after)));
        QVERIFY2(session.health().views[0].warning->error.message().ends_with(
                     "it was unplugged; plug it in again"),
                 session.health().views[0].warning->error.message().c_str());
        const std::uint64_t before = session.health().views[0].delivered;
        QVERIFY(shell("echo vivid.0 >/sys/bus/platform/drivers/vivid/bind"));
        QTRY_VERIFY(session.health().views[0].delivered > before + 5);
        QTRY_COMPARE(state(), ViewHealth::State::Delivering);
        QCOMPARE(session.health().views[0].source.reconnections, std::uint64_t(1));
    }
};

QTEST_GUILESS_MAIN(TestVividFaults)
#include "tst_vivid_faults.moc"
