// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/picture.h"

#include "coded_frames.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

using namespace odo;
using namespace odo::test;

class TestPicture : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void screenColours_data();
    void screenColours();
    void screenSizes();
    void readsPictures_data();
    void readsPictures();
    void readAndShownAgain();
    void refusals_data();
    void refusals();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    QTemporaryDir m_folder;
};

namespace {

struct Rgb
{
    double red, green, blue;
};

/// ITU-R BT.601-7 and BT.709-6 in closed form, unrounded, clipped to 0..255.
Rgb closedForm(int y, int u, int v, YuvMatrix matrix, bool fullRange)
{
    const double kr = matrix == YuvMatrix::Bt709 ? 0.2126 : 0.299,
                 kb = matrix == YuvMatrix::Bt709 ? 0.0722 : 0.114;
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

void TestPicture::screenColours_data()
{
    QTest::addColumn<int>("matrix");
    QTest::addColumn<bool>("fullRange");
    QTest::addColumn<int>("shiftX");
    QTest::addColumn<int>("shiftY");
    for (const YuvMatrix matrix : {YuvMatrix::Bt601, YuvMatrix::Bt709})
        for (const bool full : {false, true})
            for (const auto &[x, y] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 1}, std::pair{0, 0}})
                QTest::addRow("BT.%d full %d shift %d,%d", matrix == YuvMatrix::Bt709 ? 709 : 601, int(full),
                              x, y)
                    << int(matrix) << full << x << y;
}

void TestPicture::screenColours()
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
                // BT.709's 2.112 for blue, a limit of its 8-bit factors that the eye does not see.
                const double blueLimit =
                    format.matrix == YuvMatrix::Bt709 && !fullRange ? 0.113 * std::abs(u - 128) : 0;
                const auto picture = toScreen(plainFrame(format, y, u, v), 20, 11);
                for (const std::uint32_t pixel : {picture.pixels[0], picture.pixels[20 * 11 - 1]}) {
                    QCOMPARE(pixel >> 24, 0xffU);
                    QVERIFY(std::abs((pixel >> 16 & 0xff) - expected.red) <= 2.5);
                    QVERIFY(std::abs((pixel >> 8 & 0xff) - expected.green) <= 2.5);
                    QVERIFY(std::abs((pixel & 0xff) - expected.blue) <= 2.5 + blueLimit);
                }
            }
}

/// A horizontal ramp stays a ramp, at its place, in every size.
void TestPicture::screenSizes()
{
    FrameFormat format;
    format.width = 256;
    format.height = 64;
    format.fullRange = true;
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int row = 0; row < format.height; ++row)
        for (int x = 0; x < format.width; ++x)
            buffer->yRow(row)[x] = static_cast<std::uint8_t>(x);
    for (int row = 0; row < buffer->chromaHeight(); ++row) {
        std::fill_n(buffer->uRow(row), buffer->chromaWidth(), std::uint8_t(128));
        std::fill_n(buffer->vRow(row), buffer->chromaWidth(), std::uint8_t(128));
    }
    const Frame frame = FrameBuffer::toFrame(std::move(buffer), 0, Nanoseconds(0));
    for (const int width : {64, 100, 128, 255, 256, 400, 512}) {
        const auto picture = toScreen(frame, width, width / 4);
        QCOMPARE(picture.width, width);
        QCOMPARE(picture.height, width / 4);
        for (int x = width / 8; x < width * 7 / 8; ++x) {
            const double expected = (x + 0.5) * 256.0 / width - 0.5;
            const double shown =
                picture.pixels[std::size_t(width / 8) * std::size_t(width) + std::size_t(x)] & 0xff;
            // One screen pixel, and two levels that the conversion may be off.
            QVERIFY2(
                std::abs(shown - expected) <= std::max(256.0 / width, 1.0) + 2.0,
                qPrintable(QStringLiteral("%1 %2: %3, not %4").arg(width).arg(x).arg(shown).arg(expected)));
        }
    }
    QVERIFY(!toScreen(frame, 0, 10).pixels);
    QVERIFY(!toScreen(Frame(), 10, 10).pixels);
}

void TestPicture::readsPictures_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<int>("tolerance");
    for (const char *ending : {".png", ".bmp", ".tiff", ".ppm"})
        QTest::newRow(ending) << QString::fromLatin1(ending) << 0;
    QTest::newRow(".jpg") << QStringLiteral(".jpg") << 4;
}

void TestPicture::readsPictures()
{
    QFETCH(QString, ending);
    QFETCH(int, tolerance);
    const auto file = path("colours" + ending.toStdString());
    for (const cv::Vec3b &bgr : {cv::Vec3b(0, 0, 255), cv::Vec3b(255, 0, 0), cv::Vec3b(0, 255, 0),
                                 cv::Vec3b(255, 255, 255), cv::Vec3b(0, 0, 0), cv::Vec3b(40, 35, 215)}) {
        QVERIFY(cv::imwrite(file.string(), cv::Mat(17, 33, CV_8UC3, cv::Scalar(bgr[0], bgr[1], bgr[2])),
                            {cv::IMWRITE_JPEG_QUALITY, 95}));
        const auto frame = readPicture(file);
        QVERIFY2(frame.has_value(), frame ? "" : frame.error().message().c_str());
        QCOMPARE(frame->format.width, 33);
        QCOMPARE(frame->format.height, 17);
        QCOMPARE(frame->format.chromaShiftX, 0);
        QVERIFY(frame->format.fullRange);
        const double y = 0.299 * bgr[2] + 0.587 * bgr[1] + 0.114 * bgr[0];
        QVERIFY(std::abs(frame->y.at(32, 16) - y) <= tolerance + 0.51);
        QVERIFY(std::abs(frame->u.at(32, 16) - std::min(128 + (bgr[0] - y) / 1.772, 255.0)) <=
                tolerance + 0.51);
        QVERIFY(std::abs(frame->v.at(32, 16) - std::min(128 + (bgr[2] - y) / 1.402, 255.0)) <=
                tolerance + 0.51);
    }
}

void TestPicture::readAndShownAgain()
{
    QVERIFY(cv::imwrite(path("again.png").string(), cv::Mat(20, 30, CV_8UC3, cv::Scalar(40, 35, 215))));
    const auto picture = toScreen(readPicture(path("again.png")).value(), 30, 20);
    const std::uint32_t pixel = picture.pixels[300];
    QVERIFY(std::abs(int(pixel >> 16 & 0xff) - 215) <= 2);
    QVERIFY(std::abs(int(pixel >> 8 & 0xff) - 35) <= 2);
    QVERIFY(std::abs(int(pixel & 0xff) - 40) <= 2);
}

void TestPicture::refusals_data()
{
    using namespace std::string_literals;
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("words");
    const auto row = [](const char *name, const std::string &content, const char *words) {
        QTest::newRow(name) << QByteArray::fromStdString(content) << QString::fromLatin1(words);
    };
    const std::string png = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s;
    const char *noPicture = "it is no PNG";
    const char *tooLarge = "more than 100 megapixels";
    row("empty", "", noPicture);
    row("text", "a letter", noPicture);
    row("png header alone", png, noPicture);
    row("png 60000x60000", png + "\0\0\xea\x60\0\0\xea\x60\x08\x02\0\0\0"s, tooLarge);
    row("png without content", png + "\0\0\0\x60\0\0\0\x60\x08\x02\0\0\0"s, "damaged or cut short");
    row("jpeg 65000x65000", "\xff\xd8\xff\xe0\0\x04\0\0\xff\xc0\0\x11\x08\xfd\xe8\xfd\xe8\x03\0\0\0\0"s,
        tooLarge);
    row("jpeg cut", "\xff\xd8\xff\xe0\0\x10JFIF"s, noPicture);
    row("bmp upside down", "BM"s + std::string(16, '\0') + "\xff\xff\xff\x7f\0\0\0\x80"s, tooLarge);
    row("tiff 65535x65535",
        "II*\0\x08\0\0\0\x02\0\0\x01\x03\0\x01\0\0\0\xff\xff\0\0\x01\x01\x03\0\x01\0\0\0\xff\xff\0\0"s,
        tooLarge);
    row("tiff pointing outside", "II*\0\xff\xff\xff\xff"s, noPicture);
    row("pnm", "P6 # much\n 99999 99999 255\n"s, tooLarge);
    row("a playlist", "#EXTM3U\n", noPicture);

    // What a decoder could read as another size, or as another format, than we do.
    row("pnm that can be taken for DICOM", "P6256#\n623" + std::string(118, '#') + "DICM", noPicture);
    row("pnm with a comment behind a number", "P6 30000#30000\n1 255\n", noPicture);
    row("pnm with a comment up to a carriage return", "P6 #\r30000 30000\n1 1 255\n", tooLarge);
    row("pnm of ten digits", "P6 1000000001 1 255\n", noPicture);
    const auto jpegFrame = [](char high, char low) {
        return "\xff\xc0\0\x11\x08"s + high + low + high + low + "\x03\x01\x22\0\x02\x11\x01\x03\x11\x01"s;
    };
    const std::string jpegScan = "\xff\xda\0\x0c\x03\x01\0\x02\x11\x03\x11\0\x3f\0"s;
    row("jpeg with a stuffed zero", "\xff\xd8\xff\0\0\x23"s + jpegFrame('\x75', '\x30') + jpegScan + jpegFrame(0, 8), noPicture);
    const auto tiffEntry = [](char tag, char type, char low, char high) {
        return std::string{tag, 1, type, 0, 1, 0, 0, 0, low, high, 0, 0};
    };
    const auto tiff = [&tiffEntry](const std::string &more, char count) {
        return "II*\0\x08\0\0\0"s + count + '\0' + tiffEntry(0, 4, 8, 0) + more + tiffEntry(1, 4, 8, 0);
    };
    row("tiff without pixels", tiff({}, 2), "damaged or cut short");
    row("tiff with two widths", tiff(tiffEntry(0, 4, 9, 0), 3), noPicture);
    row("tiff with a width of eight bytes", tiff(tiffEntry(0, 16, 9, 0), 3), noPicture);
    row("tiff with huge tiles", tiff(tiffEntry(0x42, 4, 0, 0x7d) + tiffEntry(0x43, 4, 0, 0x7d), 4), tooLarge);
}

void TestPicture::refusals()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, words);
    std::ofstream(path("bad.png"), std::ios::binary) << content.toStdString();
    const auto frame = readPicture(path("bad.png"));
    QVERIFY(!frame.has_value());
    QCOMPARE(frame.error().code, ErrorCode::InvalidInput);
    QVERIFY2(frame.error().message().find(words.toStdString()) != std::string::npos,
             frame.error().message().c_str());
    QCOMPARE(readPicture(path("missing.png")).error().code, ErrorCode::NotFound);
}

QTEST_GUILESS_MAIN(TestPicture)
#include "tst_picture.moc"
