// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image.h"

#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QTest>

using namespace odo;
using namespace odo::test;

class TestImage : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void screenColours_data();
    void screenColours();
    void screenSizes();
    void highDynamicRangeIsMappedToTheScreen();
    void sidesBeyondFixedPoint_data();
    void sidesBeyondFixedPoint();
};

namespace {

struct Rgb
{
    double red, green, blue;
};

std::pair<double, double> lumaShares(YuvMatrix matrix)
{
    return matrix == YuvMatrix::Bt2020  ? std::pair{0.2627, 0.0593}
           : matrix == YuvMatrix::Bt709 ? std::pair{0.2126, 0.0722}
                                        : std::pair{0.299, 0.114};
}

/// ITU-R BT.601-7, BT.709-6 and BT.2020-2 in closed form, unrounded, clipped to 0..255.
Rgb closedForm(int y, int u, int v, YuvMatrix matrix, bool fullRange)
{
    const auto [kr, kb] = lumaShares(matrix);
    const double luma = fullRange ? y : (y - 16) * 255.0 / 219.0;
    const double scale = fullRange ? 1.0 : 255.0 / 224.0;
    const double cb = (u - 128) * scale, cr = (v - 128) * scale;
    const double red = luma + 2 * (1 - kr) * cr, blue = luma + 2 * (1 - kb) * cb;
    const double green = (luma - kr * red - kb * blue) / (1 - kr - kb);
    return {std::clamp(red, 0.0, 255.0), std::clamp(green, 0.0, 255.0), std::clamp(blue, 0.0, 255.0)};
}

Frame plainFrame(const FrameFormat &format, int y, int u, int v)
{
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int row = 0; row < format.height; ++row)
        std::fill_n(buffer->yRow(row), format.width, static_cast<std::uint8_t>(y));
    for (int row = 0; row < buffer->chromaHeight(); ++row) {
        std::fill_n(buffer->uRow(row), buffer->chromaWidth(), static_cast<std::uint8_t>(u));
        std::fill_n(buffer->vRow(row), buffer->chromaWidth(), static_cast<std::uint8_t>(v));
    }
    return FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
}

} // namespace

void TestImage::screenColours_data()
{
    QTest::addColumn<int>("matrix");
    QTest::addColumn<bool>("fullRange");
    QTest::addColumn<int>("shiftX");
    QTest::addColumn<int>("shiftY");
    for (const YuvMatrix matrix : {YuvMatrix::Bt601, YuvMatrix::Bt709, YuvMatrix::Bt2020})
        for (const bool full : {false, true})
            for (const auto &[x, y] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 1}, std::pair{0, 0}})
                QTest::addRow("matrix %d full %d shift %d,%d", int(matrix), int(full), x, y)
                    << int(matrix) << full << x << y;
}

void TestImage::screenColours()
{
    QFETCH(int, matrix);
    QFETCH(bool, fullRange);
    QFETCH(int, shiftX);
    QFETCH(int, shiftY);
    FrameFormat format;
    format.width = 37;
    format.height = 21;
    format.chromaShiftX = shiftX;
    format.chromaShiftY = shiftY;
    format.matrix = static_cast<YuvMatrix>(matrix);
    format.fullRange = fullRange;
    for (const int y : {16, 70, 128, 190, 235})
        for (const int u : {60, 110, 128, 150, 200})
            for (const int v : {60, 110, 128, 150, 200}) {
                const Rgb expected = closedForm(y, u, v, format.matrix, fullRange);
                // libyuv works with 6 bits after the point, up to 2 levels off; and it has 2 in place of
                // BT.709's 2.112 and BT.2020's 2.142 for blue, a limit of its 8-bit factors that the eye does
                // not see.
                const double kb = lumaShares(format.matrix).second;
                const double blueLimit =
                    fullRange ? 0 : std::max((2 * (1 - kb) * 255 / 224 - 2) * std::abs(u - 128), 0.0);
                const auto image = toScreen(plainFrame(format, y, u, v), 20, 11);
                for (const std::uint32_t pixel : {image.pixels[0], image.pixels[20 * 11 - 1]}) {
                    QCOMPARE(pixel >> 24, 0xffU);
                    QVERIFY(std::abs((pixel >> 16 & 0xff) - expected.red) <= 2.5);
                    QVERIFY(std::abs((pixel >> 8 & 0xff) - expected.green) <= 2.5);
                    QVERIFY(std::abs((pixel & 0xff) - expected.blue) <= 2.5 + blueLimit);
                }
            }
}

/// Grey of known light by BT.2100: white of a graphic (203 cd/m²) is the code 0.58 of PQ and 0.75 of HLG
/// (BT.2408 table 1), which the curve maps to (1 + 0.041) / 2 of the screen's light: sRGB code 191.
void TestImage::highDynamicRangeIsMappedToTheScreen()
{
    const auto shown = [](Transfer transfer, double code) {
        FrameFormat format;
        format.width = format.height = 8;
        format.matrix = YuvMatrix::Bt2020;
        format.transfer = transfer;
        return toScreen(plainFrame(format, int(std::lround(16 + 219 * code)), 128, 128), 8, 8).pixels[0];
    };
    for (const auto &[transfer, white] :
         {std::pair{Transfer::PerceptualQuantizer, 0.58}, std::pair{Transfer::HybridLogGamma, 0.75}}) {
        const std::uint32_t pixel = shown(transfer, white);
        for (const int shift : {0, 8, 16})
            QVERIFY2(std::abs(int(pixel >> shift & 0xff) - 191) <= 3, qPrintable(QString::number(pixel, 16)));
        QCOMPARE(shown(transfer, 0), 0xff000000U);
        std::uint32_t before = 0;
        for (int step = 0; step <= 20; ++step) {
            const std::uint32_t grey = shown(transfer, step / 20.0) & 0xff;
            QVERIFY(grey >= before);
            before = grey;
        }
        QVERIFY(before >= 250);
    }
    QCOMPARE(shown(Transfer::Standard, 0.75) & 0xff, 191U); // as it is
}

/// A horizontal ramp stays a ramp, at its place, in every size.
void TestImage::screenSizes()
{
    const Frame frame = rampFrame();
    for (const int width : {64, 100, 128, 255, 256, 400, 512}) {
        const auto image = toScreen(frame, width, width / 4);
        QCOMPARE(image.width, width);
        QCOMPARE(image.height, width / 4);
        for (int x = width / 8; x < width * 7 / 8; ++x) {
            const double expected = (x + 0.5) * 256.0 / width - 0.5;
            const double shown =
                image.pixels[std::size_t(width / 8) * std::size_t(width) + std::size_t(x)] & 0xff;
            // One screen pixel, and two levels that the conversion may be off.
            QVERIFY2(
                std::abs(shown - expected) <= std::max(256.0 / width, 1.0) + 2.0,
                qPrintable(QStringLiteral("%1 %2: %3, not %4").arg(width).arg(x).arg(shown).arg(expected)));
        }
    }
    QVERIFY(!toScreen(frame, 0, 10).pixels);
    QVERIFY(!toScreen(Frame(), 10, 10).pixels);
}

void TestImage::sidesBeyondFixedPoint_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::newRow("tall") << 8 << 64259;
    QTest::newRow("wide") << 100'000 << 8;
    QTest::newRow("just too wide") << 32768 << 8;
}

/// A ramp along a side that has more than the 32,767 pixels that libyuv's scaling can count.
void TestImage::sidesBeyondFixedPoint()
{
    QFETCH(int, width);
    QFETCH(int, height);
    FrameFormat format;
    format.width = width;
    format.height = height;
    format.fullRange = true;
    const int longest = std::max(width, height);
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            buffer->yRow(y)[x] = static_cast<std::uint8_t>(256LL * std::max(x, y) / longest);
    for (int y = 0; y < buffer->chromaHeight(); ++y) {
        std::fill_n(buffer->uRow(y), buffer->chromaWidth(), std::uint8_t(128));
        std::fill_n(buffer->vRow(y), buffer->chromaWidth(), std::uint8_t(128));
    }
    const Frame frame = FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
    const bool isTall = height > width;
    constexpr int shown = 500;
    const auto image = isTall ? toScreen(frame, 4, shown) : toScreen(frame, shown, 4);
    for (int i = 0; i < shown; ++i) {
        const std::size_t place = isTall ? 4 * std::size_t(i) : std::size_t(i);
        const int grey = int(image.pixels[place] & 0xff);
        // Half a level for the mean within a pixel, one for the samples left out, two of the conversion.
        QVERIFY2(std::abs(grey - 256.0 * (i + 0.5) / shown) <= 3.5,
                 qPrintable(QStringLiteral("%1: %2").arg(i).arg(grey)));
    }
}

ODOGRAPH_TEST(TestImage, QCoreApplication)
#include "tst_image.moc"
