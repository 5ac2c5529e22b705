// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_turn.h"
#include "core/video/image_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/still_images.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <fstream>

using namespace odo;
using namespace odo::test;

class TestStillFormats : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void reads_data();
    void reads();
    void isShownAsItsOwnerSeesIt_data();
    void isShownAsItsOwnerSeesIt();
    void cutAnywhere_data();
    void cutAnywhere();
    void turnsBack_data();
    void turnsBack();
    void refusals_data();
    void refusals();

private:
    Result<Frame> readAs(const std::string &name, const Bytes &content) const
    {
        const auto file = std::filesystem::path(m_folder.path().toStdString()) / name;
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char *>(content.data()), std::streamsize(content.size()));
        return readImage(file);
    }
    QTemporaryDir m_folder;
};

namespace {

/// The largest difference of luma, away from the borders of the quarters, where a lossy format rings.
int largestError(const Frame &frame, const RgbImage &image)
{
    if (frame.format.width != image.width || frame.format.height != image.height)
        return 1000;
    int largest = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const bool isAtBorder = std::abs(2 * x - image.width) < 20 || std::abs(2 * y - image.height) < 20;
            if (!isAtBorder)
                largest = std::max(largest, std::abs(int(frame.y.at(x, y)) - image.grey(x, y)));
        }
    }
    return largest;
}

/// Of the chroma at a pixel in the middle of each quarter.
int largestChromaError(const Frame &frame, const RgbImage &image)
{
    int largest = 0;
    for (const int quarterX : {1, 3}) {
        for (const int quarterY : {1, 3}) {
            const int x = quarterX * image.width / 4, y = quarterY * image.height / 4;
            const std::uint8_t *pixel = image.at(x, y);
            const double luma = 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
            const double u = 128 + (pixel[2] - luma) / 1.772, v = 128 + (pixel[0] - luma) / 1.402;
            const int atX = x >> frame.format.chromaShiftX, atY = y >> frame.format.chromaShiftY;
            largest = std::max(
                {largest, int(std::abs(frame.u.at(atX, atY) - u)), int(std::abs(frame.v.at(atX, atY) - v))});
        }
    }
    return largest;
}

} // namespace

void TestStillFormats::reads_data()
{
    QTest::addColumn<Bytes>("content");
    QTest::addColumn<bool>("hasColour");
    QTest::addColumn<int>("tolerance");
    const RgbImage image = fourQuarters(132, 98);
    const auto libav = [&](const char *name, const char *encoder, const char *pixels, const char *options,
                           int tolerance, bool hasColour = true) {
        QTest::newRow(name) << codedByLibav(image, encoder, pixels, options) << hasColour << tolerance;
    };
    libav("png, 8 bits", "png", "rgb24", "", 0);
    libav("png, 16 bits", "png", "rgb48be", "", 1);
    libav("png, 16 bits with transparency", "png", "rgba64be", "", 1);
    libav("png, grey of 16 bits", "png", "gray16be", "", 1, false);
    libav("png, grey with transparency", "png", "ya8", "", 1, false);
    libav("png, grey of 16 bits with transparency", "png", "ya16be", "", 1, false);
    libav("png, interlaced", "png", "rgb24", "pred=mixed", 0);
    libav("tiff", "tiff", "rgb24", "compression_algo=raw", 0);
    libav("tiff, LZW", "tiff", "rgb24", "compression_algo=lzw", 0);
    libav("tiff, deflate", "tiff", "rgb24", "compression_algo=deflate", 0);
    libav("tiff, PackBits", "tiff", "rgb24", "compression_algo=packbits", 0);
    QTest::newRow("tiff, tiles") << tiledTiffOf(image) << true << 0;
    libav("tiff, 16 bits", "tiff", "rgb48le", "", 1);
    libav("tiff, 16 bits with transparency", "tiff", "rgba64le", "", 1);
    libav("tiff, grey of 16 bits", "tiff", "gray16le", "", 1, false);
    libav("tiff, grey with transparency", "tiff", "ya8", "", 1, false);
    libav("webp", "libwebp", "yuv420p", "quality=95", 6);
    libav("webp with transparency", "libwebp", "yuva420p", "quality=95", 6);
    libav("webp, lossless", "libwebp", "bgra", "lossless=1", 1);
    QTest::newRow("heic") << heicOf(image) << true << 6;
    QTest::newRow("heic of an odd size") << heicOf(fourQuarters(131, 97)) << true << 6;
    QTest::newRow("jpeg of four inks") << cmykJpegOf(image, false, false) << true << 6;
    QTest::newRow("jpeg of four inks, as Photoshop") << cmykJpegOf(image, true, false) << true << 6;
    QTest::newRow("jpeg of four inks, progressive") << cmykJpegOf(image, false, true) << true << 6;
}

void TestStillFormats::reads()
{
    QFETCH(Bytes, content);
    QFETCH(bool, hasColour);
    QFETCH(int, tolerance);
    QVERIFY(!content.empty());
    // the name is another's: the content decides
    const auto frame = readAs("image.jpg", content);
    QVERIFY2(frame.has_value(), frame ? "" : frame.error().message().c_str());
    const RgbImage image = fourQuarters(frame->format.width, frame->format.height);
    QVERIFY(frame->format.fullRange);
    const int error = largestError(*frame, image), chromaError = largestChromaError(*frame, image);
    QVERIFY2(error <= tolerance, qPrintable(QString::number(error)));
    if (hasColour)
        QVERIFY2(chromaError <= tolerance + 1, qPrintable(QString::number(chromaError)));
    QVERIFY(std::abs(frame->format.width - 132) <= 1);
    QCOMPARE(frame->orientation, 1);
}

void TestStillFormats::isShownAsItsOwnerSeesIt_data()
{
    QTest::addColumn<Bytes>("content");
    QTest::addColumn<int>("orientation");
    QTest::addColumn<int>("width");
    // 4:2:0 and 4:2:2 of even sides keep their chroma as it is, of odd sides not
    for (const auto &[width, height] : {std::pair(132, 98), std::pair(131, 97)}) {
        const RgbImage shown = fourQuarters(width, height);
        for (int orientation = 1; orientation <= 8; ++orientation) {
            const RgbImage stored = storedFor(shown, orientation);
            const auto row = [&](const char *name, const Bytes &content) {
                QTest::addRow("%s, %d, %d wide", name, orientation, width) << content << orientation << width;
            };
            const Bytes jpeg = codedByLibav(stored, "mjpeg", "yuvj420p");
            row("jpeg, EXIF of Intel", jpegWithOrientation(jpeg, orientation, false));
            row("jpeg, EXIF of Motorola", jpegWithOrientation(jpeg, orientation, true));
            row("jpeg, 4:2:2",
                jpegWithOrientation(codedByLibav(stored, "mjpeg", "yuvj422p"), orientation, true));
            row("png", pngWithOrientation(codedByLibav(stored, "png", "rgb24"), orientation));
            row("webp", webpWithOrientation(codedByLibav(stored, "libwebp", "yuv420p", "quality=95"), stored,
                                            orientation));
            Bytes tiff = codedByLibav(stored, "tiff", "rgb24");
            for (std::size_t i = 0; i + 12 < tiff.size(); ++i) // an entry of the directory becomes another
                if (tiff[i] == 0x31 && tiff[i + 1] == 0x01 && tiff[i + 2] == 2) {
                    const Bytes entry{0x12, 1, 3, 0, 1, 0, 0, 0, std::uint8_t(orientation), 0, 0, 0};
                    std::ranges::copy(entry, tiff.begin() + std::ptrdiff_t(i));
                    break;
                }
            row("tiff", tiff);
            row("heic", heicOf(stored, orientation));
        }
    }
}

void TestStillFormats::isShownAsItsOwnerSeesIt()
{
    QFETCH(Bytes, content);
    QFETCH(int, orientation);
    QFETCH(int, width);
    const auto frame = readAs("turned.png", content);
    QVERIFY2(frame.has_value(), frame ? "" : frame.error().message().c_str());
    const RgbImage shown = fourQuarters(width, width == 132 ? 98 : 97);
    const int error = largestError(*frame, shown), chromaError = largestChromaError(*frame, shown);
    QVERIFY2(error <= 8, qPrintable(QString::number(error))); // of the lossy ones
    QVERIFY2(chromaError <= 8, qPrintable(QString::number(chromaError)));
    const bool isHeic = QByteArray(QTest::currentDataTag()).startsWith("heic"); // turned by its library
    QCOMPARE(frame->orientation, isHeic ? 1 : orientation);
}

void TestStillFormats::turnsBack_data()
{
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    for (int from = 1; from <= 8; ++from)
        for (int to = 1; to <= 8; ++to)
            QTest::addRow("%d to %d", from, to) << from << to;
}

/// From any orientation to any other, as if the file had said that one.
void TestStillFormats::turnsBack()
{
    QFETCH(int, from);
    QFETCH(int, to);
    const RgbImage shown = fourQuarters(40, 24), stored = storedFor(shown, from);
    const Bytes png = codedByLibav(stored, "png", "rgb24");
    const auto frame = readAs("from.png", pngWithOrientation(png, from)),
               expected = readAs("to.png", pngWithOrientation(png, to));
    QVERIFY(frame && expected);
    const Frame other = inOrientation(*frame, to);
    QCOMPARE(other.orientation, to);
    QCOMPARE(other.format.width, expected->format.width);
    QCOMPARE(other.format.height, expected->format.height);
    for (int y = 0; y < other.format.height; ++y) {
        QVERIFY(std::equal(other.y.row(y), other.y.row(y) + other.format.width, expected->y.row(y)));
        QVERIFY(std::equal(other.v.row(y), other.v.row(y) + other.format.width, expected->v.row(y)));
    }
}

void TestStillFormats::cutAnywhere_data()
{
    QTest::addColumn<Bytes>("whole");
    const RgbImage image = fourQuarters(64, 48);
    QTest::newRow("heic") << heicOf(image);
    QTest::newRow("webp") << codedByLibav(image, "libwebp", "yuv420p");
    QTest::newRow("webp, lossless") << codedByLibav(image, "libwebp", "bgra", "lossless=1");
    QTest::newRow("png, 16 bits") << codedByLibav(image, "png", "rgb48be");
    QTest::newRow("tiff, LZW") << codedByLibav(image, "tiff", "rgb24", "compression_algo=lzw");
}

/// Refused in a sentence, or nothing that is seen is missing.
void TestStillFormats::cutAnywhere()
{
    QFETCH(Bytes, whole);
    const auto read = readAs("whole", whole);
    QVERIFY(read.has_value());
    int accepted = 0;
    for (std::size_t bytes = 0; bytes < whole.size(); bytes += 7) {
        const auto cut = readAs("cut", {whole.begin(), whole.begin() + std::ptrdiff_t(bytes)});
        if (!cut) {
            QCOMPARE(cut.error().code, ErrorCode::InvalidInput);
            continue;
        }
        ++accepted;
        for (int y = 0; y < read->format.height; ++y)
            QVERIFY2(std::equal(cut->y.row(y), cut->y.row(y) + cut->format.width, read->y.row(y)),
                     qPrintable(QString::number(bytes)));
    }
    QVERIFY2(accepted <= 30, qPrintable(QString::number(accepted))); // the end of a PNG, the tags of a TIFF
}

void TestStillFormats::refusals_data()
{
    QTest::addColumn<Bytes>("content");
    QTest::addColumn<QString>("words");
    const RgbImage image = fourQuarters(64, 48);
    const auto noImage = QStringLiteral("it is not a PNG, JPEG, TIFF, HEIC, WebP, BMP or PNM image");
    const auto damaged = QStringLiteral("its content is damaged or cut short; copy it again");
    Bytes webp = codedByLibav(image, "libwebp", "yuv420p");
    Bytes stretched = webpWithOrientation(webp, fourQuarters(65, 48), 1);
    QTest::newRow("webp with two sizes") << stretched << noImage;
    webp[8 + 4 + 8 + 3] = 0;
    QTest::newRow("webp without its mark") << webp << noImage;
    Bytes heic = heicOf(image);
    const std::string content(heic.begin(), heic.end());
    const auto data = std::ptrdiff_t(content.find("mdat"));
    std::fill(heic.begin() + data + 4, heic.end(), std::uint8_t(0));
    QTest::newRow("heic without data") << heic << damaged;
    Bytes brand = heicOf(image);
    std::fill_n(brand.begin() + 8, 8, std::uint8_t('x'));
    std::fill_n(brand.begin() + 16, 12, std::uint8_t('x'));
    QTest::newRow("container of something else") << brand << noImage;
    Bytes large = heicOf(image);
    const std::string boxes(large.begin(), large.end());
    for (std::size_t at = boxes.find("ispe"); at != std::string::npos; at = boxes.find("ispe", at + 4))
        large[at + 10] = large[at + 14] = 0x4e; // some 20,000 x 20,000
    QTest::newRow("heic that claims much") << large << QStringLiteral("50 megapixels");
    const auto tiffWith = [&](std::uint8_t tag, std::uint8_t value) { // SampleFormat, or what is in its place
        Bytes tiff = codedByLibav(image, "tiff", "gray16le");
        for (std::size_t i = 0; i + 12 < tiff.size(); ++i)
            if (tiff[i] == 0x31 && tiff[i + 1] == 0x01 && tiff[i + 2] == 2) {
                const Bytes entry{tag, std::uint8_t(tag == 0xfe ? 0 : 1), 3, 0, 1, 0, 0, 0, value, 0, 0, 0};
                std::ranges::copy(entry, tiff.begin() + std::ptrdiff_t(i));
                break;
            }
        return tiff;
    };
    QTest::newRow("tiff of signed numbers") << tiffWith(0x53, 2) << noImage;
    QTest::newRow("a raw image's preview") << tiffWith(0xfe, 1) << noImage;
}

void TestStillFormats::refusals()
{
    QFETCH(Bytes, content);
    QFETCH(QString, words);
    const auto frame = readAs("bad.heic", content);
    QVERIFY(!frame.has_value());
    QCOMPARE(frame.error().code, ErrorCode::InvalidInput);
    QVERIFY2(QString::fromStdString(frame.error().message()).contains(words),
             frame.error().message().c_str());
}

ODOGRAPH_TEST(TestStillFormats, QCoreApplication)
#include "tst_still_formats.moc"
