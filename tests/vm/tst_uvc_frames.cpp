// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in the emulated machine: the kernel's driver of USB webcams, fed by two played ones. What they are,
// MJPEG, damaged pictures, controls.
#include "core/video/jpeg.h"
#include "tests/support/offered_formats.h"
#include "tests/vm/played_cameras.h"

#include <QTest>
#include <algorithm>

using namespace odo;
using namespace odo::test;

class TestUvcFrames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        m_a = playedCamera(0, "Camera A", "A1");
        m_b = playedCamera(1, "Camera B", "B2");
        QVERIFY(m_a && m_b);
        QTRY_COMPARE(usbCameras().size(), std::size_t(2)); // each has a second node, for metadata
    }

    void webcamsAreListed()
    {
        const auto cameras = usbCameras();
        QVERIFY(cameras[0].name.english().find("Camera A") != std::string::npos);
        QCOMPARE(cameras[0].serial, std::string("A1"));
        QCOMPARE(cameras[1].serial, std::string("B2"));
        QCOMPARE(test::offeredFormats(cameras[0]),
                 (std::vector<std::string>{"MJPG 640×480 at 30 frames/s", "YUYV 640×480 at 30 frames/s",
                                           "MJPG 320×240 at 30 frames/s", "YUYV 320×240 at 30 frames/s"}));
        const auto source = opened(cameras[0].uri);
        QVERIFY(source);
        QCOMPARE(source->description().widthPx, 640);
        QVERIFY(std::abs(source->description().framesPerSecond - 30) <
                1e-3); // periods are whole numbers of 100 ns
    }

    void mjpegComesAsItIs()
    {
        const auto source = opened(playedUri("A1"));
        QVERIFY(source);
        const Taken taken = take(*source, 8);
        QCOMPARE(taken.frames.size(), std::size_t(8));
        QVERIFY(rises(taken));
        const CapturedFrame &captured = taken.frames.back();
        QVERIFY(captured.jpeg);
        QVERIFY(captured.clock);
        Frame wanted;
        QCOMPARE(JpegDecoder(*jpegFormat(playedFrame())).decode(playedFrame(), std::nullopt, wanted),
                 JpegDecoder::Outcome::Decoded);
        QCOMPARE(captured.frame.format.chromaShiftY, 0);
        for (int y = 0; y < 240; ++y)
            QVERIFY(std::equal(wanted.y.row(y), wanted.y.row(y) + 320, captured.frame.y.row(y)));
        // What is recorded is the same file, with its tables (in one segment instead of four).
        QCOMPARE(captured.jpeg->size(), playedFrame().size() - 3 * 4);
    }

    void yuyvComesInPlanes()
    {
        const auto source = opened(playedUri("B2", "YUYV"));
        QVERIFY(source);
        const Taken taken = take(*source, 3);
        QVERIFY(!taken.frames.empty());
        const Frame &frame = taken.frames.back().frame;
        QVERIFY(!taken.frames.back().jpeg);
        QCOMPARE(int(std::uint8_t(frame.y.at(101, 7) - frame.y.at(100, 200))), 1); // the gradient
        QCOMPARE(int(frame.u.at(50, 50)), 128);
    }

    void damagedPicturesAreCounted_data()
    {
        QTest::addColumn<bool>("kept");
        QTest::addColumn<QByteArray>("format");
        QTest::newRow("the driver drops them") << false << QByteArray("YUYV");
        QTest::newRow("the driver marks them") << true << QByteArray("YUYV");
        QTest::newRow("MJPEG that ends too early") << false << QByteArray("MJPG");
    }

    void damagedPicturesAreCounted()
    {
        QFETCH(bool, kept);
        QFETCH(QByteArray, format);
        m_a.reset(); // the driver heeds that when a camera is plugged in
        QVERIFY(shell(kept ? "echo 1 >/sys/module/uvcvideo/parameters/nodrop"
                           : "echo 0 >/sys/module/uvcvideo/parameters/nodrop"));
        m_a = playedCamera(0, "Camera A", "A1");
        QTRY_COMPARE(usbCameras().size(), std::size_t(2));
        const auto source = opened(playedUri("A1", format.toStdString()));
        QVERIFY(source);
        const Taken before = take(*source, 3);
        m_a->shortenOne();
        const Taken between = take(*source, 8);
        if (format == "YUYV")
            m_a->breakOne();
        const Taken after = take(*source, 8);
        QVERIFY(between.problems.empty() && after.problems.empty());
        QVERIFY(rises(after));
        const bool seenByUs = kept || format == "MJPG";
        QCOMPARE(source->counts().damaged, std::uint64_t(!seenByUs ? 0 : format == "MJPG" ? 1 : 2));
        // Whoever threw it away: it is missing in the count.
        QVERIFY(between.frames.back().sequence - before.frames.back().sequence >= 9);
    }

    void automaticsAreHeldWhereTheyAre()
    {
        const auto source = opened(playedUri("A1"));
        QVERIFY(source);
        QVERIFY(m_a->controls().isAnyAutomaticOn());
        const auto readOnly = [&](const std::string &id) {
            const auto controls = source->controls();
            const auto found = std::ranges::find(*controls, id, &CameraControl::id);
            return found == controls->end() || found->readOnly;
        };
        QVERIFY(readOnly("exposure_time_absolute")); // as long as its automatic moves it
        QVERIFY(!source->set("exposure_time_absolute", 300));
        const auto stillOn = source->holdAutomatics();
        QVERIFY2(stillOn.empty(), stillOn.empty() ? "" : stillOn.front().english().c_str());
        QVERIFY(!m_a->controls().isAnyAutomaticOn());
        QCOMPARE(m_a->controls().exposure(), 123); // where the automatic had it, not the 250 of before
        QCOMPARE(m_a->controls().whiteBalance(), 5200);
        QVERIFY(!readOnly("exposure_time_absolute"));
        QVERIFY(source->set("exposure_time_absolute", 300));
        QCOMPARE(m_a->controls().exposure(), 300);
    }

private:
    std::unique_ptr<UvcCamera> m_a, m_b;
};

QTEST_GUILESS_MAIN(TestUvcFrames)
#include "tst_uvc_frames.moc"
