// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/libav.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/foreign_files.h"
#include "tests/video/raw_colours.h"

#include <QTemporaryDir>
#include <QTest>
#include <cstring>
extern "C" {
#include <libavutil/pixdesc.h>
}

using namespace odo;
using namespace odo::test;

namespace {

constexpr int width = 64, height = 48;

/// Of a component at a position, in 8 bits: another for each, rising to the right.
int levelAt(int component, int x)
{
    return 60 + 30 * component + x;
}

/// Each component of every pixel at its level, as libav keeps it; the lower bits of deeper ones are set.
void fillByComponent(AVFrame &image, int)
{
    const AVPixFmtDescriptor &pixels = *av_pix_fmt_desc_get(static_cast<AVPixelFormat>(image.format));
    for (const AVBufferRef *memory : image.buf) // to which the lines are added bit by bit
        if (memory)
            std::memset(memory->data, 0, memory->size);
    for (int component = 0; component < pixels.nb_components; ++component) {
        const bool isChroma = (component == 1 || component == 2) && (pixels.flags & AV_PIX_FMT_FLAG_RGB) == 0;
        const int shiftX = isChroma ? pixels.log2_chroma_w : 0, shiftY = isChroma ? pixels.log2_chroma_h : 0;
        const int deeper = pixels.comp[component].depth - 8;
        std::vector<std::uint16_t> row;
        for (int x = 0; x < AV_CEIL_RSHIFT(image.width, shiftX); ++x)
            row.push_back(std::uint16_t((levelAt(component, x << shiftX) << deeper) + (1 << deeper) - 1));
        for (int y = 0; y < AV_CEIL_RSHIFT(image.height, shiftY); ++y)
            av_write_image_line(row.data(), image.data, image.linesize, &pixels, 0, y, component,
                                int(row.size()));
    }
}

} // namespace

/// Frames of more than 8 bits, packed ones, and those of red, green and blue, as phones, editors and
/// industrial cameras write them.
class TestPixelFormats : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void yuv_data();
    void yuv();
    void redGreenBlue_data();
    void redGreenBlue();
    void whatPhonesCode_data();
    void whatPhonesCode();

private:
    std::filesystem::path written(const QString &name, const QString &encoder, const QString &pixels)
    {
        auto file = std::filesystem::path(m_folder.path().toStdString()) / name.toStdString();
        return writeRaw(file, {encoder.toStdString(), pixels.toStdString(), 3, width, height, 25, 1, false,
                               fillByComponent})
                   ? file
                   : std::filesystem::path();
    }
    QTemporaryDir m_folder;
};

void TestPixelFormats::yuv_data()
{
    QTest::addColumn<QString>("encoder");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::addColumn<int>("shiftX");
    QTest::addColumn<int>("shiftY");
    const auto row = [](const char *pixels, const char *encoder, const char *name, int depth, int shiftX,
                        int shiftY) {
        QTest::newRow(pixels) << QString::fromLatin1(encoder) << QString::fromLatin1(name) << depth << shiftX
                              << shiftY;
    };
    row("yuv420p10le", "ffv1", "a.mkv", 10, 1, 1);
    row("yuv422p10le", "ffv1", "a.mkv", 10, 1, 0);
    row("yuv440p10le", "ffv1", "a.mkv", 10, 0, 1);
    row("yuv444p12le", "ffv1", "a.mkv", 12, 0, 0);
    row("yuv420p9le", "ffv1", "a.mkv", 9, 1, 1);
    row("yuv422p16le", "ffv1", "a.mkv", 16, 1, 0);
    row("yuva444p10le", "ffv1", "a.mkv", 10, 0, 0);
    row("yuva420p", "ffv1", "a.mkv", 8, 1, 1);
    row("gray10le", "ffv1", "a.mkv", 10, 1, 1);
    row("gray16le", "ffv1", "a.mkv", 16, 1, 1);
    row("yuv420p10be", "rawvideo", "a.nut", 10, 1, 1);
    row("nv21", "rawvideo", "a.nut", 8, 1, 1);
    row("yuyv422", "rawvideo", "a.avi", 8, 1, 0);
    row("uyvy422", "rawvideo", "a.avi", 8, 1, 0);
    row("yuv411p", "ffv1", "a.mkv", 8, 1, 0);
}

void TestPixelFormats::yuv()
{
    QFETCH(QString, encoder);
    QFETCH(QString, name);
    QFETCH(int, depth);
    QFETCH(int, shiftX);
    QFETCH(int, shiftY);
    const QString pixels = QString::fromLatin1(QTest::currentDataTag());
    const auto file = written(name, encoder, pixels);
    QVERIFY(!file.empty());
    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    QCOMPARE((*reader)->info().bitDepth, depth);
    QCOMPARE((*reader)->info().format.chromaShiftX, shiftX);
    QCOMPARE((*reader)->info().format.chromaShiftY, shiftY);
    const bool isGrey = pixels.startsWith(QStringLiteral("gray"));
    const int dither = pixels.endsWith(QStringLiteral("be")) ? 1 : 0;        // of libswscale
    const int chromaStep = pixels == QStringLiteral("yuv411p") ? 2 : dither; // of the chroma in between
    for (const int number : {2, 0}) {
        const Frame frame = (*reader)->frameAt(number).value();
        for (int x = 0; x < width; ++x)
            QVERIFY(std::abs(frame.y.at(x, height - 1) - levelAt(0, x)) <= dither);
        for (int x = 2; x < frame.u.width - 2; ++x) {
            QVERIFY(std::abs(frame.u.at(x, frame.u.height - 1) - (isGrey ? 128 : levelAt(1, x << shiftX))) <=
                    chromaStep);
            QVERIFY(std::abs(frame.v.at(x, frame.u.height - 1) - (isGrey ? 128 : levelAt(2, x << shiftX))) <=
                    chromaStep);
        }
    }
}

void TestPixelFormats::redGreenBlue_data()
{
    QTest::addColumn<QString>("encoder");
    QTest::addColumn<QString>("name");
    for (const char *pixels : {"bgr24", "rgb24", "bgr0", "rgba", "gbrp"})
        QTest::newRow(pixels) << QStringLiteral("rawvideo") << QStringLiteral("a.nut");
    for (const char *pixels : {"gbrp10le", "rgb48le"})
        QTest::newRow(pixels) << QStringLiteral("ffv1") << QStringLiteral("a.mkv");
}

void TestPixelFormats::redGreenBlue()
{
    QFETCH(QString, encoder);
    QFETCH(QString, name);
    const auto file = written(name, encoder, QString::fromLatin1(QTest::currentDataTag()));
    QVERIFY(!file.empty());
    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    const FrameFormat &format = (*reader)->info().format;
    QVERIFY(format.fullRange && format.chromaShiftX == 0 && format.chromaShiftY == 0);
    const Frame frame = (*reader)->frameAt(1).value();
    for (int x = 0; x < width; ++x) {
        const Yuv expected =
            closedForm({double(levelAt(0, x)), double(levelAt(1, x)), double(levelAt(2, x))});
        QVERIFY(std::abs(frame.y.at(x, 5) - expected.y) <= 1);
        QVERIFY(std::abs(frame.u.at(x, 5) - expected.u) <= 1);
        QVERIFY(std::abs(frame.v.at(x, 5) - expected.v) <= 1);
    }
}

void TestPixelFormats::whatPhonesCode_data()
{
    QTest::addColumn<QString>("pixels");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("codec");
    const auto row = [](const char *encoder, const char *pixels, const char *name, const char *codec) {
        QTest::addRow("%s, %s", codec, pixels)
            << QString::fromLatin1(pixels) << QString::fromLatin1(name) << QString::fromLatin1(encoder);
    };
    row("libx265", "yuv420p10le", "a.mov", "hevc");
    row("libx264", "yuv422p10le", "a.mkv", "h264");
    row("prores_ks", "yuv422p10le", "a.mov", "prores");
}

/// Lossy codecs, whose decoders give deep frames: near the levels that went in.
void TestPixelFormats::whatPhonesCode()
{
    QFETCH(QString, pixels);
    QFETCH(QString, name);
    QFETCH(QString, codec);
    const auto file = written(name, codec, pixels);
    QVERIFY(!file.empty());
    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    QCOMPARE((*reader)->info().bitDepth, 10);
    const Frame frame = (*reader)->frameAt(1).value();
    for (int x = 4; x < width - 4; ++x)
        QVERIFY(std::abs(frame.y.at(x, 20) - levelAt(0, x)) <= 4);
}

ODOGRAPH_TEST(TestPixelFormats, QCoreApplication)
#include "tst_pixel_formats.moc"
