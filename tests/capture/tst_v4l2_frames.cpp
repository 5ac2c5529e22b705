// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/v4l2/internal/v4l2_mode.h"
#include "tests/support/registered_test.h"
#include "tests/video/jpeg_images.h"

#include <QTest>
#include <algorithm>
#include <linux/videodev2.h>

using namespace odo;
using namespace odo::test;

namespace {

v4l2_pix_format format(std::uint32_t fourcc, int bytesPerPixel, std::uint32_t size)
{
    v4l2_pix_format pixels{};
    pixels.width = 64;
    pixels.height = 48;
    pixels.pixelformat = fourcc;
    pixels.bytesperline = static_cast<std::uint32_t>(64 * bytesPerPixel);
    pixels.sizeimage = size;
    pixels.colorspace = V4L2_COLORSPACE_SRGB;
    return pixels;
}

FrameFormat planes()
{
    FrameFormat frame;
    frame.width = 64;
    frame.height = 48;
    frame.chromaShiftY = 0;
    return frame;
}

} // namespace

class TestV4l2Frames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void rangeAndMatrixFollowTheDriver()
    {
        const std::vector<std::uint8_t> buffer(64 * 48 * 2, 128);
        v4l2_pix_format pixels = format(V4L2_PIX_FMT_YUYV, 2, 64 * 48 * 2);
        QVERIFY(!V4l2Frames(pixels).read(buffer)->frame.format.fullRange);
        QCOMPARE(V4l2Frames(pixels).read(buffer)->frame.format.matrix, YuvMatrix::Bt601);
        pixels.quantization = V4L2_QUANTIZATION_FULL_RANGE;
        QVERIFY(V4l2Frames(pixels).read(buffer)->frame.format.fullRange);
        pixels.quantization = V4L2_QUANTIZATION_DEFAULT;
        pixels.colorspace = V4L2_COLORSPACE_JPEG; // full range by definition
        QVERIFY(V4l2Frames(pixels).read(buffer)->frame.format.fullRange);
        pixels.colorspace = V4L2_COLORSPACE_REC709;
        QCOMPARE(V4l2Frames(pixels).read(buffer)->frame.format.matrix, YuvMatrix::Bt709);
    }

    void everyRawFormatIsRead()
    {
        const std::vector<std::pair<std::uint32_t, int>> formats{
            {V4L2_PIX_FMT_YUYV, 2},   {V4L2_PIX_FMT_UYVY, 2},   {V4L2_PIX_FMT_NV12, 1},
            {V4L2_PIX_FMT_GREY, 1},   {V4L2_PIX_FMT_RGB24, 3},  {V4L2_PIX_FMT_BGR24, 3},
            {V4L2_PIX_FMT_SRGGB8, 1}, {V4L2_PIX_FMT_SGRBG8, 1}, {V4L2_PIX_FMT_SGBRG8, 1},
            {V4L2_PIX_FMT_SBGGR8, 1}};
        for (const auto &[fourcc, bytesPerPixel] : formats) {
            QVERIFY(v4l2FormatRank(fourcc) >= 0);
            const std::size_t bytes = fourcc == V4L2_PIX_FMT_NV12
                                          ? 64 * 48 * 3 / 2
                                          : 64 * 48 * static_cast<std::size_t>(bytesPerPixel);
            const std::vector<std::uint8_t> buffer(bytes, 128);
            V4l2Frames frames(format(fourcc, bytesPerPixel, static_cast<std::uint32_t>(bytes)));
            const auto image = frames.read(buffer);
            QVERIFY(image);
            QVERIFY(!image->jpeg);
            QCOMPARE(image->frame.y.width, 64);
            QVERIFY(std::abs(image->frame.y.at(30, 20) - 128) <= 1); // grey, whatever the layout
            QVERIFY(std::abs(image->frame.u.at(10, 10) - 128) <= 1);
            QVERIFY(!frames.read(std::span(buffer).first(bytes - 1)));
        }
        QCOMPARE(v4l2FormatRank(V4L2_PIX_FMT_H264), -1);
    }

    void jpegComesWithItsFile()
    {
        const auto whole = jpegOf(planes(), {}), bare = withoutHuffmanTables(whole);
        V4l2Frames frames(format(V4L2_PIX_FMT_MJPEG, 0, 64 * 48 * 2));
        const auto image = frames.read(bare);
        QVERIFY(image);
        QVERIFY(image->jpeg->size() > bare.size());
        QVERIFY(decodedByLibavcodec(*image->jpeg, planes()).owner);
        QCOMPARE(image->frame.format.chromaShiftY, 0);
        const Frame wanted = decodedByLibavcodec(whole, planes());
        for (int x = 0; x < 64; ++x) // another inverse cosine transform: one code value
            QVERIFY(std::abs(wanted.y.at(x, 17) - image->frame.y.at(x, 17)) <= 1);
        QVERIFY(*frames.read(whole)->jpeg == whole);
    }

    void damagedJpegIsNoPicture()
    {
        const auto whole = jpegOf(planes(), {});
        V4l2Frames frames(format(V4L2_PIX_FMT_MJPEG, 0, 64 * 48 * 2));
        const std::span<const std::uint8_t> bytes = whole;
        for (std::size_t length = 0; length < whole.size() - 40; length += 7)
            QVERIFY(!frames.read(bytes.first(length)));
        // A header that tells of another size must not make us fetch gigabytes.
        auto huge = jpegOf(planes(), {});
        const std::vector<std::uint8_t> size{0, 48, 0, 64};
        const auto found = std::search(huge.begin(), huge.end(), size.begin(), size.end());
        QVERIFY(found != huge.end());
        std::fill_n(found, size.size(), std::uint8_t(0xff));
        QVERIFY(!frames.read(huge));
        QVERIFY(frames.read(whole)); // and the next one is sound
    }
};

ODOGRAPH_TEST(TestV4l2Frames, QCoreApplication)
#include "tst_v4l2_frames.moc"
