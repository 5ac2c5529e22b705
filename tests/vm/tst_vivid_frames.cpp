// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in the emulated machine: what the kernel's emulated cameras offer, and whether their pictures are read
// rightly.
#include "core/capture/v4l2/v4l2_source.h"
#include "tests/support/offered_formats.h"
#include "tests/vm/vivid_cameras.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <thread>
#include <unistd.h>

using namespace odo;
using namespace odo::test;

namespace {

const std::string first = "/dev/video0", small = "?size=320x180&rate=25&format=";

struct Rgb
{
    double red = 0, green = 0, blue = 0;
};

/// By the frame's own matrix and range (H.273).
Rgb colourAt(const Frame &frame, int x, int y)
{
    const FrameFormat &format = frame.format;
    const auto sample = [&](const PlaneView &plane) {
        return plane.at(x >> format.chromaShiftX, y >> format.chromaShiftY);
    };
    const double luma = format.fullRange ? frame.y.at(x, y) : (frame.y.at(x, y) - 16) * 255.0 / 219;
    const double scale = format.fullRange ? 1 : 255.0 / 224;
    const double u = (sample(frame.u) - 128) * scale, v = (sample(frame.v) - 128) * scale;
    const double kr = format.matrix == YuvMatrix::Bt709 ? 0.2126 : 0.299,
                 kb = format.matrix == YuvMatrix::Bt709 ? 0.0722 : 0.114;
    const double red = luma + 2 * (1 - kr) * v, blue = luma + 2 * (1 - kb) * u;
    return {red, (luma - kr * red - kb * blue) / (1 - kr - kb), blue};
}

std::vector<CameraDescription> usbCameras()
{
    std::vector<CameraDescription> cameras = listCameras();
    std::erase_if(cameras, [](const CameraDescription &camera) { return camera.kind != "v4l2"; });
    return cameras;
}

} // namespace

class TestVividFrames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        for (const char *node : {"/dev/video0", "/dev/video1"}) {
            setVivid(node, "osd_text_mode", 2);    // no text in the picture
            setVivid(node, "timestamp_source", 1); // when a picture begins
        }
    }

    void bothAreListed()
    {
        const auto cameras = usbCameras();
        QCOMPARE(cameras.size(), std::size_t(2));
        QCOMPARE(cameras[0].uri, std::string("v4l2:/dev/video0"));
        QCOMPARE(cameras[0].name.english(), std::string("vivid"));
        QCOMPARE(cameras[0].widthPx, 640); // 30 frames/s or more, nearest to 1280×720
        QCOMPARE(cameras[0].heightPx, 360);
        // the best comes first
        QCOMPARE(test::offeredFormats(cameras[1]).front(), std::string("YUYV 640×360 at 40 frames/s"));
        const auto offered = test::offeredFormats(cameras[1]);
        QVERIFY(std::ranges::find(offered, "YUYV 640×480 at 25 frames/s") != offered.end());
    }

    void aCameraInUseIsListedAsBusyAndNotDisturbed()
    {
        const auto source = opened("v4l2:/dev/video1" + small + "YUYV");
        QVERIFY(source);
        const Taken before = take(*source, 5);
        const auto cameras = usbCameras();
        QVERIFY(!cameras.at(0).busy);
        QVERIFY(cameras.at(1).busy);
        QVERIFY(take(*source, 5).problems.empty());
        QCOMPARE(source->counts().reconnections, std::uint64_t(0));
    }

    void aPortIsAnAddressToo()
    {
        const auto source = opened("v4l2:platform:vivid-001");
        QVERIFY(source);
        const auto busy = usbCameras();
        QVERIFY(!busy.at(0).busy && busy.at(1).busy);
        QVERIFY(shell("mkdir -p /dev/v4l/by-id && ln -sf ../../video0 /dev/v4l/by-id/usb-vivid"));
        QVERIFY(opened("v4l2:/dev/v4l/by-id/usb-vivid"));
    }

    void twoAtOnceKeepAccount()
    {
        std::array<Taken, 2> taken;
        {
            std::vector<std::jthread> threads;
            for (std::size_t i = 0; i < 2; ++i)
                threads.emplace_back([&, i] {
                    taken[i] = take(*opened("v4l2:/dev/video" + std::to_string(i) + small + "YUYV"), 50);
                });
        }
        for (const Taken &one : taken) {
            QCOMPARE(one.frames.size(), std::size_t(50));
            QVERIFY(rises(one));
            QCOMPARE(one.frames.size() + one.lost, one.span());
            // By its own times the camera keeps its rate, whatever was lost on the way. A hundredth: vivid
            // counts in 4 ms.
            const double seconds = toSeconds(one.frames.back().frame.time - one.frames.front().frame.time);
            QVERIFY2(std::abs(seconds * 25 / double(one.span() - 1) - 1) < 0.05, QByteArray::number(seconds));
            QVERIFY(one.frames.back().clock);
        }
    }

    void coloursAreRight_data()
    {
        QTest::addColumn<QByteArray>("format");
        for (const char *format :
             {"YUYV", "UYVY", "NV12", "RGB3", "BGR3", "RGGB", "GRBG", "GBRG", "BA81", "GREY"})
            QTest::newRow(format) << QByteArray(format);
    }

    /// Eight bars, from white to black; a tolerance of four for the rounding to limited range and back,
    /// twice.
    void coloursAreRight()
    {
        QFETCH(QByteArray, format);
        setVivid(first, "test_pattern", 1);
        const auto source = opened("v4l2:" + first + small + format.toStdString());
        QVERIFY(source);
        const Taken taken = take(*source, 3);
        QVERIFY(!taken.frames.empty());
        const Frame &frame = taken.frames.back().frame;
        QCOMPARE(frame.format.width, 320);
        QCOMPARE(frame.format.height, 180);
        QVERIFY(!taken.frames.back().jpeg);
        const std::array<Rgb, 8> bars{
            {{1, 1, 1}, {1, 1, 0}, {0, 1, 1}, {0, 1, 0}, {1, 0, 1}, {1, 0, 0}, {0, 0, 1}, {0, 0, 0}}};
        double before = 300;
        for (std::size_t i = 0; i < bars.size(); ++i) {
            const Rgb seen = colourAt(frame, int(40 * i + 20), 90);
            const Rgb &bar = bars[i];
            const QByteArray words = "bar " + QByteArray::number(int(i)) + ": " +
                                     QByteArray::number(seen.red) + ' ' + QByteArray::number(seen.green) +
                                     ' ' + QByteArray::number(seen.blue);
            if (format == "GREY") { // how dark the colours between white and black are is vivid's own choice
                QVERIFY2(std::abs(seen.red - seen.green) < 1 && std::abs(seen.blue - seen.green) < 1 &&
                             seen.green < before,
                         words);
                QVERIFY2((i > 0 || std::abs(seen.green - 255) <= 4) && (i < 7 || std::abs(seen.green) <= 4),
                         words);
                before = seen.green;
            } else {
                QVERIFY2(std::abs(seen.red - 255 * bar.red) <= 4 &&
                             std::abs(seen.green - 255 * bar.green) <= 4 &&
                             std::abs(seen.blue - 255 * bar.blue) <= 4,
                         words);
            }
        }
    }

    void whatIsNotOfferedIsRefused()
    {
        const auto source = openCamera("v4l2:/dev/video0?format=MJPG");
        QVERIFY(!source);
        QVERIFY(source.error().message().find(
                    "it does not offer the requested mode; choose one that it offers: ") !=
                std::string::npos);
    }

    void whoMayNotIsToldWhatToDo()
    {
        QVERIFY(seteuid(65534) == 0);
        const auto source = openCamera("v4l2:/dev/video0");
        const auto cameras = usbCameras();
        QVERIFY(seteuid(0) == 0);
        QVERIFY(!source);
        QVERIFY(source.error().message().ends_with(
            "you may not use it; join the group video (sudo usermod -aG video YOUR-NAME) and log in again"));
        QCOMPARE(cameras.size(), std::size_t(2));
        QVERIFY(test::offeredFormats(cameras[0]).at(0).find("join the group video") != std::string::npos);
    }

    void withoutCamerasThereAreNone()
    {
        QVERIFY(shell("modprobe -r vivid"));
        QVERIFY(usbCameras().empty());
        QCOMPARE(openCamera("v4l2:/dev/video0").error().code, ErrorCode::NotFound);
        QVERIFY(shell("modprobe vivid n_devs=1 node_types=0x1 num_inputs=1 input_types=0"));
        QCOMPARE(usbCameras().size(), std::size_t(1));
    }
};

QTEST_GUILESS_MAIN(TestVividFrames)
#include "tst_vivid_frames.moc"
