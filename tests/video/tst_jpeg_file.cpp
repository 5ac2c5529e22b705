// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/jpeg.h"
#include "tests/support/registered_test.h"
#include "tests/video/jpeg_images.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

FrameFormat formatOf(int shiftX, int shiftY)
{
    FrameFormat format;
    format.width = 187;
    format.height = 93;
    format.chromaShiftX = shiftX;
    format.chromaShiftY = shiftY;
    return format;
}

} // namespace

class TestJpegFile : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theHeaderTellsTheFormat()
    {
        for (const auto &[x, y] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 0}, std::pair{0, 1}}) {
            const auto told = jpegFormat(jpegOf(formatOf(x, y), {}));
            QVERIFY(told);
            QCOMPARE(told->width, 187);
            QCOMPARE(told->height, 93);
            QCOMPARE(told->chromaShiftX, x);
            QCOMPARE(told->chromaShiftY, y);
            QCOMPARE(told->siting, ChromaSiting::Center);
            QVERIFY(told->fullRange);
        }
        QVERIFY(!jpegFormat(jpegOf(formatOf(1, 1), {.grey = true})));
    }

    /// libjpeg has coded with the standard tables, so that nothing else may come back.
    void missingTablesArePutIn()
    {
        const auto whole = jpegOf(formatOf(1, 0), {});
        const auto bare = withoutHuffmanTables(whole);
        QVERIFY(bare.size() < whole.size());
        const auto mended = withHuffmanTables(bare);
        QCOMPARE(mended.size(), whole.size() - 3 * 4); // one segment in place of four
        const Frame wanted = decodedByLibavcodec(whole, formatOf(1, 0)),
                    got = decodedByLibavcodec(mended, formatOf(1, 0));
        QVERIFY(got.owner);
        for (int y = 0; y < wanted.y.height; ++y)
            QVERIFY(std::equal(wanted.y.row(y), wanted.y.row(y) + wanted.y.width, got.y.row(y)));
    }

    void whatIsWholeOrDamagedStaysAsItIs()
    {
        const auto whole = jpegOf(formatOf(1, 1), {});
        QVERIFY(withHuffmanTables(whole) == whole);
        const auto bare = withoutHuffmanTables(whole);
        for (std::size_t length = 0; length < bare.size(); ++length) {
            const std::vector<std::uint8_t> cut(bare.begin(),
                                                bare.begin() + static_cast<std::ptrdiff_t>(length));
            const auto mended = withHuffmanTables(cut); // must not read beyond the end
            QVERIFY(mended.size() >= cut.size());
            if (length < 100) // within the quantisation tables
                QVERIFY(mended == cut && !jpegFormat(cut));
        }
    }

    void noByteOfTheHeaderIsTrusted()
    {
        const auto whole = withoutHuffmanTables(jpegOf(formatOf(1, 1), {}));
        for (std::size_t at = 0; at < std::min<std::size_t>(whole.size(), 400); ++at) {
            for (const int value : {0, 1, 0x7f, 0xff}) {
                auto broken = whole;
                broken[at] = static_cast<std::uint8_t>(value);
                QVERIFY(withHuffmanTables(broken).size() >= broken.size());
                jpegFormat(broken);
            }
        }
    }
};

ODOGRAPH_TEST(TestJpegFile, QCoreApplication)
#include "tst_jpeg_file.moc"
