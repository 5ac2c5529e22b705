// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/image_reader.h"

#include "core/video/image.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"
#include "tests/video/jpeg_images.h"

#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <fstream>
#include <iterator>

using namespace odo;
using namespace odo::test;

class TestImageReader : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void readsPictures_data();
    void readsPictures();
    void readsOtherPixels_data();
    void readsOtherPixels();
    void readAndShownAgain();
    void isReadAsItWasWritten();
    void writesOnlyWhatItKnows();
    void cutAnywhere_data();
    void cutAnywhere();
    void aChangedByteOfAPng();
    void aTiffThatDoesNotUnpack();
    void aTiffSaysWhoMadeIt_data();
    void aTiffSaysWhoMadeIt();
    void refusals_data();
    void refusals();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    void store(const std::string &name, const std::vector<unsigned char> &content) const
    {
        std::ofstream(path(name), std::ios::binary)
            .write(reinterpret_cast<const char *>(content.data()), std::streamsize(content.size()));
    }
    QTemporaryDir m_folder;
};

namespace {

bool hasSameLuma(const Frame &a, const Frame &b)
{
    if (a.y.width != b.y.width || a.y.height != b.y.height)
        return false;
    for (int y = 0; y < a.y.height; ++y)
        if (!std::equal(a.y.row(y), a.y.row(y) + a.y.width, b.y.row(y)))
            return false;
    return true;
}

QImage plainImage(QImage::Format pixels, const QColor &colour)
{
    QImage image(33, 17, pixels);
    image.fill(colour);
    return image;
}

using TiffEntry = std::array<int, 4>; ///< tag, type, count, value

/// As TIFF 6.0 §6 has it: three bytes a pixel, in one strip, not compressed.
void writeTiff(const std::filesystem::path &file, int width, int height, const QColor &colour,
               const std::vector<TiffEntry> &others = {}, bool bigEndian = false)
{
    QByteArray bytes = bigEndian ? QByteArray("MM\0*\0\0\0\x08", 8) : QByteArray("II*\0\x08\0\0\0", 8);
    const auto number = [&](int value, int count) {
        for (int i = 0; i < count; ++i)
            bytes.append(char(value >> 8 * (bigEndian ? count - 1 - i : i)));
    };
    const int count = 9 + int(others.size());
    constexpr int shortNumber = 3, longNumber = 4;
    const int bitsAt = 10 + 12 * count + 4, pixelsAt = bitsAt + 6;
    const int pixelBytes = 3 * width * height;
    std::vector<TiffEntry> entries{
        {256, longNumber, 1, width}, {257, longNumber, 1, height}, {258, shortNumber, 3, bitsAt},
        {259, shortNumber, 1, 1},    {262, shortNumber, 1, 2},     {273, longNumber, 1, pixelsAt},
        {277, shortNumber, 1, 3},    {278, longNumber, 1, height}, {279, longNumber, 1, pixelBytes}};
    entries.insert(entries.end(), others.begin(), others.end());
    std::ranges::sort(entries);
    number(count, 2);
    for (const auto &[tag, type, values, value] : entries) {
        number(tag, 2);
        number(type, 2);
        number(values, 4);
        if (type == shortNumber && values == 1) {
            number(value, 2);
            number(0, 2);
        } else {
            number(value, 4);
        }
    }
    number(0, 4); // no further picture
    for (int colours = 0; colours < 3; ++colours)
        number(8, 2);
    for (int i = 0; i < width * height; ++i)
        bytes.append(char(colour.red())).append(char(colour.green())).append(char(colour.blue()));
    std::ofstream(file, std::ios::binary) << bytes.toStdString();
}

std::vector<unsigned char> contentOf(const std::filesystem::path &file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

void TestImageReader::aTiffSaysWhoMadeIt_data()
{
    QTest::addColumn<std::vector<std::array<int, 4>>>("others");
    QTest::addColumn<bool>("bigEndian");
    constexpr int text = 2, shortNumber = 3, longNumber = 4, fraction = 5;
    const TiffEntry orientation{274, shortNumber, 1, 1}, inches{296, shortNumber, 1, 2},
        maker{305, text, 4, 0x4d4d}, page{297, shortNumber, 2, 1}, across{282, fraction, 1, 8},
        down{283, fraction, 1, 8};
    QTest::newRow("ImageMagick") << std::vector{orientation, page} << false;
    QTest::newRow("MATLAB") << std::vector{TiffEntry{254, longNumber, 1, 0}, across, down, inches, maker}
                            << false;
    QTest::newRow("OpenCV") << std::vector{orientation, TiffEntry{339, shortNumber, 1, 1}} << false;
    QTest::newRow("camera") << std::vector{orientation,
                                           across,
                                           down,
                                           inches,
                                           maker,
                                           TiffEntry{306, text, 20, 8},
                                           TiffEntry{34665, longNumber, 1, 8}}
                            << true;
    QTest::newRow("GIMP") << std::vector{TiffEntry{270, text, 4, 0x41}, TiffEntry{700, 1, 4, 8}} << true;
}

/// libavcodec takes tags that it does not know for damage when it is to report some.
void TestImageReader::aTiffSaysWhoMadeIt()
{
    QFETCH(std::vector<TiffEntry>, others);
    QFETCH(bool, bigEndian);
    const auto plain = path("plain.tiff"), described = path("described.tiff");
    writeTiff(plain, 33, 17, QColor(215, 35, 40));
    writeTiff(described, 33, 17, QColor(215, 35, 40), others, bigEndian);
    const auto expected = readImage(plain), frame = readImage(described);
    QVERIFY2(expected && frame, frame ? "" : frame.error().message().c_str());
    QVERIFY(hasSameLuma(*frame, *expected));
    // damage is still told
    std::vector<unsigned char> cut = contentOf(described);
    cut.resize(cut.size() - 100);
    std::ofstream(described, std::ios::binary)
        .write(reinterpret_cast<const char *>(cut.data()), std::streamsize(cut.size()));
    QVERIFY(!readImage(described));
}

void TestImageReader::readsPictures_data()
{
    QTest::addColumn<QString>("ending");
    QTest::addColumn<int>("tolerance");
    for (const char *ending : {".png", ".bmp", ".tiff", ".ppm"})
        QTest::newRow(ending) << QString::fromLatin1(ending) << 0;
    QTest::newRow(".jpg") << QStringLiteral(".jpg") << 4;
}

void TestImageReader::readsPictures()
{
    QFETCH(QString, ending);
    QFETCH(int, tolerance);
    const auto file = path("colours" + ending.toStdString());
    for (const QColor &colour : {QColor(255, 0, 0), QColor(0, 0, 255), QColor(0, 255, 0),
                                 QColor(255, 255, 255), QColor(0, 0, 0), QColor(215, 35, 40)}) {
        if (ending == QStringLiteral(".tiff"))
            writeTiff(file, 33, 17, colour);
        else
            QVERIFY(plainImage(QImage::Format_RGB888, colour)
                        .save(QString::fromStdString(file.string()), nullptr, 95));
        const auto frame = readImage(file);
        QVERIFY2(frame.has_value(), frame ? "" : frame.error().message().c_str());
        QCOMPARE(frame->format.width, 33);
        QCOMPARE(frame->format.height, 17);
        QVERIFY(frame->format.fullRange);
        const int x = 32 >> frame->format.chromaShiftX, y = 16 >> frame->format.chromaShiftY;
        QCOMPARE(x, ending == QStringLiteral(".jpg") ? 16 : 32); // the chroma of a JPEG is as it is
        const double luma = 0.299 * colour.red() + 0.587 * colour.green() + 0.114 * colour.blue();
        QVERIFY(std::abs(frame->y.at(32, 16) - luma) <= tolerance + 0.51);
        QVERIFY(std::abs(frame->u.at(x, y) - std::min(128 + (colour.blue() - luma) / 1.772, 255.0)) <=
                tolerance + 0.51);
        QVERIFY(std::abs(frame->v.at(x, y) - std::min(128 + (colour.red() - luma) / 1.402, 255.0)) <=
                tolerance + 0.51);
    }
}

void TestImageReader::readsOtherPixels_data()
{
    QTest::addColumn<int>("pixels");
    QTest::addColumn<QString>("ending");
    const auto row = [](QImage::Format pixels, const char *ending) {
        QTest::addRow("%d%s", int(pixels), ending) << int(pixels) << QString::fromLatin1(ending);
    };
    for (const auto pixels : {QImage::Format_ARGB32, QImage::Format_RGBX64, QImage::Format_Grayscale8,
                              QImage::Format_Grayscale16, QImage::Format_Indexed8, QImage::Format_Mono})
        row(pixels, ".png");
    row(QImage::Format_Grayscale8, ".pgm");
    row(QImage::Format_Mono, ".pbm");
    row(QImage::Format_Indexed8, ".bmp");
    row(QImage::Format_Grayscale8, ".jpg");
}

/// Grey of 8 and 16 bits, colours of 16 bits, with a transparency that is ignored, of a palette, black and
/// white.
void TestImageReader::readsOtherPixels()
{
    QFETCH(int, pixels);
    QFETCH(QString, ending);
    const auto file = path("other" + ending.toStdString());
    for (const int grey : {0, 255, 90}) {
        if (grey == 90 && pixels == QImage::Format_Mono)
            continue;
        const QImage image = plainImage(QImage::Format_RGB888, QColor(grey, grey, grey))
                                 .convertToFormat(QImage::Format(pixels));
        QVERIFY(image.save(QString::fromStdString(file.string()), nullptr, 95));
        const auto frame = readImage(file);
        QVERIFY2(frame.has_value(), frame ? "" : frame.error().message().c_str());
        QCOMPARE(frame->format.width, 33);
        QCOMPARE(int(frame->y.at(32, 16)), grey);
        QCOMPARE(int(frame->u.at(0, 0)), 128);
        QCOMPARE(int(frame->v.at(0, 0)), 128);
    }
}

void TestImageReader::readAndShownAgain()
{
    QVERIFY(plainImage(QImage::Format_RGB888, QColor(215, 35, 40))
                .save(QString::fromStdString(path("again.png").string())));
    const auto picture = toScreen(readImage(path("again.png")).value(), 30, 20);
    const std::uint32_t pixel = picture.pixels[300];
    QVERIFY(std::abs(int(pixel >> 16 & 0xff) - 215) <= 2);
    QVERIFY(std::abs(int(pixel >> 8 & 0xff) - 35) <= 2);
    QVERIFY(std::abs(int(pixel & 0xff) - 40) <= 2);
}

/// Luma of a grey PNG is the frame's own; colours go to the screen's and back, a JPEG's by its encoder.
void TestImageReader::isReadAsItWasWritten()
{
    const Frame frame = rampFrame();
    const auto grey = greyPng(frame), colours = colourPng(frame);
    QVERIFY(grey && colours);
    store("grey.png", *grey);
    store("colours.png", *colours);
    QVERIFY(writeImage(frame, path("file.png")));
    QVERIFY(writeImage(frame, path("file.jpg")));
    for (const auto &[name, tolerance] :
         {std::pair{"grey.png", 0}, {"colours.png", 2}, {"file.png", 2}, {"file.jpg", 4}}) {
        const auto read = readImage(path(name));
        QVERIFY2(read.has_value(), name);
        QCOMPARE(read->format.width, frame.format.width);
        QCOMPARE(read->format.height, frame.format.height);
        for (int x = 0; x < frame.format.width; ++x)
            QVERIFY2(std::abs(read->y.at(x, 20) - frame.y.at(x, 20)) <= tolerance, name);
    }
}

void TestImageReader::writesOnlyWhatItKnows()
{
    const auto written = writeImage(rampFrame(), path("file.gif"));
    QVERIFY(!written);
    QVERIFY2(written.error().message().find("its format is unknown; check the folder, the free space, and "
                                            "that the name ends in .png or .jpg") != std::string::npos,
             written.error().message().c_str());
    QVERIFY(!std::filesystem::exists(path("file.gif")));
    QVERIFY(!greyPng(Frame()) && !colourPng(Frame()));
    QVERIFY(!writeImage(rampFrame(), path("no folder/file.png")));
}

void TestImageReader::cutAnywhere_data()
{
    QTest::addColumn<QByteArray>("whole");
    const auto row = [](const char *name, const std::vector<unsigned char> &bytes) {
        QTest::newRow(name) << QByteArray(reinterpret_cast<const char *>(bytes.data()),
                                          qsizetype(bytes.size()));
    };
    const Frame frame = rampFrame();
    row("png", colourPng(frame).value());
    const FrameFormat format = frame.format;
    row("jpeg", jpegOf(format, {}));
    row("jpeg, grey", jpegOf(format, {.grey = true}));
    row("jpeg, progressive", jpegOf(format, {.progressive = true}));
    writeTiff(path("whole.tiff"), 33, 17, QColor(215, 35, 40));
    row("tiff", contentOf(path("whole.tiff")));
    for (const char *name : {"whole.bmp", "whole.ppm"}) {
        QVERIFY(plainImage(QImage::Format_RGB888, QColor(215, 35, 40))
                    .save(QString::fromStdString(path(name).string())));
        row(name, contentOf(path(name)));
    }
}

/// Either it is refused, or nothing that is seen is missing.
void TestImageReader::cutAnywhere()
{
    QFETCH(QByteArray, whole);
    store("cut.png", {whole.begin(), whole.end()});
    const Frame read = readImage(path("cut.png")).value();
    int accepted = 0;
    for (qsizetype bytes = 0; bytes < whole.size(); bytes += bytes + 100 < whole.size() ? 13 : 1) {
        store("cut.png", {whole.begin(), whole.begin() + bytes});
        const auto cut = readImage(path("cut.png"));
        accepted += cut ? 1 : 0;
        if (cut)
            QVERIFY2(hasSameLuma(*cut, read),
                     qPrintable(QStringLiteral("%1 of %2 bytes").arg(bytes).arg(whole.size())));
    }
    QVERIFY2(accepted <= 16, qPrintable(QString::number(accepted))); // a checksum and the sign of the end
}

/// A PNG has a checksum for each of its parts.
void TestImageReader::aChangedByteOfAPng()
{
    QVERIFY(writeImage(rampFrame(), path("whole.png")));
    const std::vector<unsigned char> whole = contentOf(path("whole.png"));
    const Frame read = readImage(path("whole.png")).value();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        auto changed = whole;
        changed[i] ^= 0x10;
        store("changed.png", changed);
        const auto frame = readImage(path("changed.png"));
        QVERIFY2(!frame || hasSameLuma(*frame, read), qPrintable(QStringLiteral("byte %1").arg(i)));
    }
}

/// Plain pixels that are said to be packed (TIFF 6.0 §9, PackBits).
void TestImageReader::aTiffThatDoesNotUnpack()
{
    writeTiff(path("packed.tiff"), 33, 17, QColor(215, 35, 40));
    auto packed = contentOf(path("packed.tiff"));
    constexpr std::size_t compressionAt = 10 + 3 * 12 + 8;
    QCOMPARE(int(packed[compressionAt]), 1);
    packed[compressionAt] = 0x05;
    packed[compressionAt + 1] = 0x80;
    store("packed.tiff", packed);
    const auto frame = readImage(path("packed.tiff"));
    QVERIFY(!frame);
    QVERIFY2(frame.error().message().find("damaged or cut short") != std::string::npos,
             frame.error().message().c_str());
}

void TestImageReader::refusals_data()
{
    using namespace std::string_literals;
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("words");
    const auto row = [](const char *name, const std::string &content, const char *words) {
        QTest::newRow(name) << QByteArray::fromStdString(content) << QString::fromLatin1(words);
    };
    const std::string png = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR"s;
    const char *noImage = "it is not a PNG";
    const char *tooLarge = "50 megapixels";
    row("empty", "", noImage);
    row("text", "a letter", noImage);
    row("png header alone", png, noImage);
    row("png 60000x60000", png + "\0\0\xea\x60\0\0\xea\x60\x08\x02\0\0\0"s, tooLarge);
    row("png without content", png + "\0\0\0\x60\0\0\0\x60\x08\x02\0\0\0"s, "damaged or cut short");
    row("jpeg 65000x65000", "\xff\xd8\xff\xe0\0\x04\0\0\xff\xc0\0\x11\x08\xfd\xe8\xfd\xe8\x03\0\0\0\0"s,
        tooLarge);
    row("jpeg cut", "\xff\xd8\xff\xe0\0\x10JFIF"s, noImage);
    row("bmp upside down", "BM"s + std::string(16, '\0') + "\xff\xff\xff\x7f\0\0\0\x80"s, tooLarge);
    row("tiff 65535x65535",
        "II*\0\x08\0\0\0\x02\0\0\x01\x03\0\x01\0\0\0\xff\xff\0\0\x01\x01\x03\0\x01\0\0\0\xff\xff\0\0"s,
        tooLarge);
    row("tiff pointing outside", "II*\0\xff\xff\xff\xff"s, noImage);
    row("pnm", "P6 # much\n 99999 99999 255\n"s, tooLarge);
    row("a playlist", "#EXTM3U\n", noImage);

    // What a decoder could read as another size, or as another format, than we do.
    row("pnm that can be taken for DICOM", "P6256#\n623" + std::string(118, '#') + "DICM", noImage);
    row("pnm with a comment behind a number", "P6 30000#30000\n1 255\n", noImage);
    row("pnm with a comment up to a carriage return", "P6 #\r30000 30000\n1 1 255\n", tooLarge);
    row("pnm of ten digits", "P6 1000000001 1 255\n", noImage);
    const auto jpegFrame = [](char high, char low) {
        return "\xff\xc0\0\x11\x08"s + high + low + high + low + "\x03\x01\x22\0\x02\x11\x01\x03\x11\x01"s;
    };
    const std::string jpegScan = "\xff\xda\0\x0c\x03\x01\0\x02\x11\x03\x11\0\x3f\0"s;
    row("jpeg with a stuffed zero",
        "\xff\xd8\xff\0\0\x23"s + jpegFrame('\x75', '\x30') + jpegScan + jpegFrame(0, 8), noImage);
    const auto tiffEntry = [](char tag, char type, char low, char high) {
        return std::string{tag, 1, type, 0, 1, 0, 0, 0, low, high, 0, 0};
    };
    const auto tiff = [&tiffEntry](const std::string &more, char count) {
        return "II*\0\x08\0\0\0"s + count + '\0' + tiffEntry(0, 4, 8, 0) + more + tiffEntry(1, 4, 8, 0);
    };
    row("tiff without pixels", tiff({}, 2), "damaged or cut short");
    row("tiff with two widths", tiff(tiffEntry(0, 4, 9, 0), 3), noImage);
    row("tiff with a width of eight bytes", tiff(tiffEntry(0, 16, 9, 0), 3), noImage);
    row("tiff with huge tiles", tiff(tiffEntry(0x42, 4, 0, 0x7d) + tiffEntry(0x43, 4, 0, 0x7d), 4), tooLarge);
}

void TestImageReader::refusals()
{
    QFETCH(QByteArray, content);
    QFETCH(QString, words);
    std::ofstream(path("bad.png"), std::ios::binary) << content.toStdString();
    const auto frame = readImage(path("bad.png"));
    QVERIFY(!frame.has_value());
    QCOMPARE(frame.error().code, ErrorCode::InvalidInput);
    QVERIFY2(frame.error().message().find(words.toStdString()) != std::string::npos,
             frame.error().message().c_str());
    QCOMPARE(readImage(path("missing.png")).error().code, ErrorCode::NotFound);
}

ODOGRAPH_TEST(TestImageReader, QCoreApplication)
#include "tst_image_reader.moc"
