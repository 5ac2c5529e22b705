// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/stream_format.h"
#include "core/video/jpeg.h"
#include "tests/support/registered_test.h"
#include "tests/video/jpeg_images.h"

#include <QTest>

using namespace odo;
using namespace odo::test;
using Outcome = JpegDecoder::Outcome;

class TestJpegDecoder : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void formats_data();
    void equalsLibavcodec_data() { formats_data(); }
    void equalsLibavcodec();
    void partsEqualTheWhole_data() { formats_data(); }
    void partsEqualTheWhole();
    void takesMostOfThePictureAsAWhole();
    void standardTablesWhereThereAreNone();
    void damaged();
    void paddedIsSound();
    void leavesTheUnusual();
    void twoFieldsAreOneFrame();
    void memoryOutlivesTheDecoder();
};

void TestJpegDecoder::formats_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("shiftX");
    QTest::addColumn<int>("shiftY");
    for (const auto &[w, h] : {std::pair{320, 240}, std::pair{187, 93}, std::pair{8, 8}, std::pair{1, 1}})
        for (const auto &[x, y] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 0}, std::pair{0, 1}})
            QTest::addRow("%dx%d, shifts %d %d", w, h, x, y) << w << h << x << y;
}

namespace {

FrameFormat fetchedFormat()
{
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, shiftX);
    QFETCH(int, shiftY);
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.chromaShiftX = shiftX;
    format.chromaShiftY = shiftY;
    return format;
}

/// The largest difference inside a rectangle, in code values.
int largestDifference(const Frame &a, const Frame &b, const PixelRect &rect)
{
    int largest = 0;
    const auto compare = [&](const PlaneView &p, const PlaneView &q, int shiftX, int shiftY) {
        for (int y = rect.y0 >> shiftY; y < (rect.y1 + (1 << shiftY) - 1) >> shiftY; ++y)
            for (int x = rect.x0 >> shiftX; x < (rect.x1 + (1 << shiftX) - 1) >> shiftX; ++x)
                largest = std::max(largest, std::abs(p.at(x, y) - q.at(x, y)));
    };
    compare(a.y, b.y, 0, 0);
    compare(a.u, b.u, a.format.chromaShiftX, a.format.chromaShiftY);
    compare(a.v, b.v, a.format.chromaShiftX, a.format.chromaShiftY);
    return largest;
}

} // namespace

void TestJpegDecoder::equalsLibavcodec()
{
    const FrameFormat format = fetchedFormat();
    const std::vector<std::uint8_t> coded = jpegOf(format, {});
    JpegDecoder decoder(format);
    Frame frame;
    QCOMPARE(decoder.decode(coded, std::nullopt, frame), Outcome::Decoded);
    QVERIFY(!frame.validRegion);
    QCOMPARE(frame.y.width, format.width);
    QCOMPARE(frame.u.width, (format.width + (1 << format.chromaShiftX) - 1) >> format.chromaShiftX);
    QCOMPARE(frame.v.height, (format.height + (1 << format.chromaShiftY) - 1) >> format.chromaShiftY);
    const Frame other = decodedByLibavcodec(coded, format);
    QVERIFY(other.y.data);
    // Both transforms keep the standard's bound of one code value to the exact one; they round differently.
    QVERIFY(largestDifference(frame, other, {0, 0, format.width, format.height}) <= 1);
}

void TestJpegDecoder::partsEqualTheWhole()
{
    const FrameFormat format = fetchedFormat();
    const std::vector<std::uint8_t> coded = jpegOf(format, {});
    JpegDecoder decoder(format);
    Frame whole;
    QCOMPARE(decoder.decode(coded, std::nullopt, whole), Outcome::Decoded);
    const int w = format.width, h = format.height;
    const PixelRect image{0, 0, w, h};
    for (const PixelRect &wanted : {PixelRect{0, 0, 1, 1}, PixelRect{w - 1, h - 1, w, h},
                                    PixelRect{w - 20, -30, w + 99, 17}, PixelRect{-7, h - 20, 40, h + 7},
                                    PixelRect{w / 3, h / 3, w / 2, h / 2}, PixelRect{40, 16, 41, 32}}) {
        const PixelRect inside = wanted.clipped(image);
        if (inside.isEmpty())
            continue;
        Frame part;
        QCOMPARE(decoder.decode(coded, wanted, part), Outcome::Decoded);
        const PixelRect valid = part.validRegion.value_or(image);
        QVERIFY(valid.contains(inside) && image.contains(valid));
        if (w > 100)
            QVERIFY(valid.width() <= inside.width() + 30 && valid.height() <= inside.height() + 30);
        QCOMPARE(largestDifference(part, whole, valid), 0);
    }
}

void TestJpegDecoder::takesMostOfThePictureAsAWhole()
{
    FrameFormat format;
    format.width = 320;
    format.height = 240;
    JpegDecoder decoder(format);
    Frame frame;
    QCOMPARE(decoder.decode(jpegOf(format, {}), PixelRect{0, 0, 320, 200}, frame), Outcome::Decoded);
    QVERIFY(!frame.validRegion);
    QCOMPARE(decoder.decode(jpegOf(format, {}), PixelRect{5, 5, 5, 9}, frame),
             Outcome::Decoded); // wants nothing
    QVERIFY(!frame.validRegion);
}

/// USB cameras leave the tables out (USB Video Class, MJPEG payload 1.5, §3.4).
void TestJpegDecoder::standardTablesWhereThereAreNone()
{
    FrameFormat format;
    format.width = 320;
    format.height = 240;
    format.chromaShiftY = 0;
    const std::vector<std::uint8_t> coded = jpegOf(format, {});
    const std::vector<std::uint8_t> bare = withoutHuffmanTables(coded);
    QVERIFY(bare.size() + 400 < coded.size());
    JpegDecoder decoder(format);
    Frame whole, without, part;
    QCOMPARE(decoder.decode(bare, std::nullopt, without),
             Outcome::Decoded); // first, so that none are left over
    QCOMPARE(decoder.decode(coded, std::nullopt, whole), Outcome::Decoded);
    QCOMPARE(largestDifference(whole, without, {0, 0, 320, 240}), 0);
    JpegDecoder fresh(format);
    QCOMPARE(fresh.decode(bare, PixelRect{100, 100, 150, 150}, part), Outcome::Decoded);
    QCOMPARE(largestDifference(whole, part, *part.validRegion), 0);
}

void TestJpegDecoder::damaged()
{
    FrameFormat format;
    format.width = 320;
    format.height = 240;
    const std::vector<std::uint8_t> coded = jpegOf(format, {});
    JpegDecoder decoder(format);
    Frame frame;
    for (const std::size_t left : {std::size_t(0), std::size_t(1), std::size_t(100), coded.size() / 2})
        QCOMPARE(decoder.decode(std::span(coded).first(left), std::nullopt, frame), Outcome::Damaged);
    int noticed = 0;
    constexpr int runs = 200;
    for (int run = 0; run < runs; ++run) {
        std::vector<std::uint8_t> broken = coded;
        for (std::size_t i = 0; i < 40; ++i)
            broken[coded.size() / 3 + static_cast<std::size_t>(run) * 7 + i] ^=
                static_cast<std::uint8_t>(0x5a + run);
        noticed += decoder.decode(broken, std::nullopt, frame) == Outcome::Damaged;
    }
    // Any bits are some codes: what still ends in the right place cannot be told from a sound picture.
    QVERIFY2(noticed > runs * 3 / 4, qPrintable(QString::number(noticed)));
    // Above the damage all is well.
    QCOMPARE(decoder.decode(std::span(coded).first(coded.size() / 2), PixelRect{0, 0, 64, 64}, frame),
             Outcome::Decoded);
    QCOMPARE(decoder.decode(coded, std::nullopt, frame), Outcome::Decoded); // none of it left a mark
}

void TestJpegDecoder::paddedIsSound()
{
    FrameFormat format;
    format.width = 320;
    format.height = 240;
    std::vector<std::uint8_t> coded = jpegOf(format, {});
    JpegDecoder decoder(format);
    Frame frame;
    coded.insert(coded.end(), 5000, 0); // cameras that send buffers of fixed size
    QCOMPARE(decoder.decode(coded, std::nullopt, frame), Outcome::Decoded);
    coded = jpegOf(format, {});
    coded.resize(coded.size() - 2); // the end-of-image marker forgotten
    QCOMPARE(decoder.decode(coded, std::nullopt, frame), Outcome::Decoded);
}

void TestJpegDecoder::leavesTheUnusual()
{
    FrameFormat format;
    format.width = 320;
    format.height = 240;
    JpegDecoder decoder(format);
    Frame frame;
    QCOMPARE(decoder.decode(jpegOf(format, {.progressive = true}), std::nullopt, frame),
             Outcome::NotSuitable);
    QCOMPARE(decoder.decode(jpegOf(format, {.grey = true}), std::nullopt, frame), Outcome::NotSuitable);
    FrameFormat other = format;
    other.height = 120; // one of two fields
    QCOMPARE(decoder.decode(jpegOf(other, {}), std::nullopt, frame), Outcome::NotSuitable);
    other = format;
    other.chromaShiftY = 0;
    QCOMPARE(decoder.decode(jpegOf(other, {}), std::nullopt, frame), Outcome::NotSuitable);
    QCOMPARE(decoder.decode(jpegOf(format, {.restartRows = 1}), std::nullopt, frame), Outcome::Decoded);
}

/// As AVI has them, each coded as an image of half the height.
void TestJpegDecoder::twoFieldsAreOneFrame()
{
    FrameFormat field, stated;
    field.width = stated.width = 320;
    field.height = 120;
    stated.height = 240;
    AVPixelFormat pixels = AV_PIX_FMT_YUVJ420P;
    std::vector<std::uint8_t> one = jpegOf(field, {}), two = one;
    two.insert(two.end(), one.begin(), one.end());
    FrameFormat format = stated;
    judgeByMost({two, two, two}, format, pixels);
    QCOMPARE(format.height, 240);
    judgeByMost({one, one, one}, format, pixels); // a container that is wrong
    QCOMPARE(format.height, 120);
}

void TestJpegDecoder::memoryOutlivesTheDecoder()
{
    FrameFormat format;
    format.width = 320;
    format.height = 240;
    const std::vector<std::uint8_t> coded = jpegOf(format, {});
    Frame kept, again;
    {
        JpegDecoder decoder(format);
        QCOMPARE(decoder.decode(coded, std::nullopt, kept), Outcome::Decoded);
        const std::uint8_t *first = kept.y.data;
        {
            Frame second;
            QCOMPARE(decoder.decode(coded, std::nullopt, second), Outcome::Decoded);
            QVERIFY(second.y.data != first); // the first is still in use
            again = second;
        }
        const std::uint8_t *given = again.y.data;
        again = Frame();
        QCOMPARE(decoder.decode(coded, std::nullopt, again), Outcome::Decoded);
        QCOMPARE(again.y.data, given); // used again
    }
    QCOMPARE(largestDifference(kept, again, {0, 0, 320, 240}), 0);
}

ODOGRAPH_TEST(TestJpegDecoder, QCoreApplication)
#include "tst_jpeg_decoder.moc"
