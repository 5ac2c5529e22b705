// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_mode.h"

#include "tests/support/registered_test.h"

#include <QTest>
#include <linux/videodev2.h>

using namespace odo;

namespace {

constexpr std::uint32_t mjpeg = V4L2_PIX_FMT_MJPEG, yuyv = V4L2_PIX_FMT_YUYV;

/// A usual webcam.
const std::vector<V4l2Mode> webcam{{yuyv, 640, 480, 1, 30},   {yuyv, 1280, 720, 1, 10},
                                   {yuyv, 1920, 1080, 1, 5},  {mjpeg, 640, 480, 1, 30},
                                   {mjpeg, 1280, 720, 1, 60}, {mjpeg, 1280, 720, 333333, 10000000},
                                   {mjpeg, 1920, 1080, 1, 30}};

std::string chosen(const std::vector<V4l2Mode> &modes, const V4l2Request &request)
{
    const auto mode = chooseMode(modes, request, "v4l2:/dev/video0");
    return mode ? modeWords(*mode).english() : mode.error().message();
}

} // namespace

class TestV4l2Mode : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void withoutAWishItIsSensible()
    {
        QCOMPARE(chosen(webcam, {}), std::string("MJPG 1280×720 at 60 frames/s"));
        // A fast small picture serves better than a slow large one; MJPEG leaves room for the second camera.
        QCOMPARE(chosen({webcam.begin(), webcam.begin() + 3}, {}),
                 std::string("YUYV 640×480 at 30 frames/s"));
        QCOMPARE(chosen({webcam.begin(), webcam.begin() + 4}, {}),
                 std::string("MJPG 640×480 at 30 frames/s"));
        QCOMPARE(chosen({{yuyv, 1280, 720, 1, 10}, {yuyv, 320, 240, 1, 15}}, {}),
                 std::string("YUYV 1280×720 at 10 frames/s"));
    }

    void aWishIsMet()
    {
        QCOMPARE(chosen(webcam, {.format = yuyv}), std::string("YUYV 640×480 at 30 frames/s"));
        QCOMPARE(chosen(webcam, {.widthPx = 1920, .heightPx = 1080}),
                 std::string("MJPG 1920×1080 at 30 frames/s"));
        QCOMPARE(chosen(webcam, {.widthPx = 1280, .heightPx = 720, .framesPerSecond = 29.97}),
                 std::string("MJPG 1280×720 at 30 frames/s"));
        QCOMPARE(chosen(webcam, {.framesPerSecond = 5}), std::string("YUYV 1920×1080 at 5 frames/s"));
    }

    void whatCannotBeMetIsAnsweredWithTheOffer()
    {
        const std::string answer = chosen(webcam, {.framesPerSecond = 200});
        QVERIFY(answer.starts_with("camera v4l2:/dev/video0: it does not offer the requested mode; choose "
                                   "one that it offers: YUYV 640×480 at 30 frames/s, "));
        QVERIFY(chosen({}, {}).find("it offers no supported format") != std::string::npos);
    }
};

ODOGRAPH_TEST(TestV4l2Mode, QCoreApplication)
#include "tst_v4l2_mode.moc"
