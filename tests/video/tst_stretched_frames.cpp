// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_turn.h"
#include "core/video/internal/libav.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/foreign_files.h"
#include "tests/video/raw_colours.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int width = 120, height = 64;
constexpr double edgeAt = 51.3; // of the stored luma

/// A soft upright edge in luma; in chroma, whose samples lie at every second one of luma, the same.
void fillEdge(AVFrame &image, int)
{
    for (int plane = 0; plane < 3; ++plane) {
        const int step = plane > 0 ? 2 : 1;
        for (int y = 0; y < height / step; ++y)
            for (int x = 0; x < width / step; ++x)
                image.data[plane][std::ptrdiff_t(y) * image.linesize[plane] + x] =
                    std::uint8_t(std::lround(60 + 140 * softStep((x * step - edgeAt) / 2)));
    }
}

RawVideo anamorphic(const std::string &encoder, int aspectWidth, int aspectHeight)
{
    const std::string pixels = encoder == "mjpeg" ? "yuvj420p" : "yuv420p";
    return {encoder, pixels, 4, width, height, 25, 1, false, fillEdge, aspectWidth, aspectHeight};
}

double mean(const std::vector<double> &values)
{
    double sum = 0;
    for (const double value : values)
        sum += value;
    return sum / double(values.size());
}

} // namespace

/// Clips whose pixels are not square, as television, HDV and some phones store them.
class TestStretchedFrames : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void aFrameIsAsWideAsItIsSeen_data();
    void aFrameIsAsWideAsItIsSeen();
    void whatWasMeasuredAsStoredStaysSo();
    void aTurnedOneIsStretchedBefore();
    void ratiosThatNoCameraWrites_data();
    void ratiosThatNoCameraWrites();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    QTemporaryDir m_folder;
};

void TestStretchedFrames::aFrameIsAsWideAsItIsSeen_data()
{
    QTest::addColumn<QString>("encoder");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("aspectWidth");
    QTest::addColumn<int>("aspectHeight");
    QTest::addColumn<int>("seenWidth");
    const auto row = [](const char *encoder, const char *name, int aspectWidth, int aspectHeight,
                        int seenWidth) {
        QTest::addRow("%s in %s, %d:%d", encoder, name, aspectWidth, aspectHeight)
            << QString::fromLatin1(encoder) << QString::fromLatin1(name) << aspectWidth << aspectHeight
            << seenWidth;
    };
    row("libx264", "a.mp4", 4, 3, 160);
    row("libx264", "a.mkv", 16, 15, 128);
    row("libx264", "a.mkv", 10, 11, 110);
    row("libx264", "a.ts", 64, 45, 170);
    row("mjpeg", "a.mov", 4, 3, 160);
    row("ffv1", "a.mkv", 1, 1, 120);
}

void TestStretchedFrames::aFrameIsAsWideAsItIsSeen()
{
    QFETCH(QString, encoder);
    QFETCH(QString, name);
    QFETCH(int, aspectWidth);
    QFETCH(int, aspectHeight);
    QFETCH(int, seenWidth);
    const auto file = path(name.toStdString());
    QVERIFY(writeRaw(file, anamorphic(encoder.toStdString(), aspectWidth, aspectHeight)));
    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    const FrameFormat &format = (*reader)->info().format;
    QCOMPARE(format.width, seenWidth);
    QCOMPARE(format.height, height);
    const double scale = double(seenWidth) / width, seenEdge = scale * (edgeAt + 0.5) - 0.5;
    const auto stored = VideoReader::open(file, {}, {4, 1, width, height});
    QCOMPARE((*stored)->info().format.width, width);
    for (const int number : {2, 0, 3}) {
        const Frame frame = (*reader)->frameAt(number).value(), as = (*stored)->frameAt(number).value();
        QCOMPARE(frame.index, number);
        QCOMPARE(frame.time, std::chrono::milliseconds(40 * number));
        QCOMPARE(frame.y.width, seenWidth);
        QVERIFY(sameLayout(frame.format, format));
        // Where the edge is stored, with what the codec did to it: the same is seen, in luma and in chroma.
        const auto seenFrom = [&](double storedLuma) { return scale * (storedLuma + 0.5) - 0.5; };
        const double luma = mean(edgePositions(frame.y, true));
        QVERIFY(std::abs(luma - seenEdge) < 0.4);
        QVERIFY2(std::abs(luma - seenFrom(mean(edgePositions(as.y, true)))) < 0.02,
                 qPrintable(QString::number(luma)));
        const double chroma = 2 * mean(edgePositions(frame.u, true)) + format.chromaOffsetX(),
                     storedChroma = 2 * mean(edgePositions(as.u, true)) + as.format.chromaOffsetX();
        QVERIFY2(std::abs(chroma - seenFrom(storedChroma)) < 0.08, qPrintable(QString::number(chroma)));
    }
}

void TestStretchedFrames::whatWasMeasuredAsStoredStaysSo()
{
    QVERIFY(writeRaw(path("a.mp4"), anamorphic("libx264", 4, 3)));
    QVERIFY(VideoReader::isShownOtherwise(path("a.mp4"), {4, 1, width, height}));
    QVERIFY(!VideoReader::isShownOtherwise(path("a.mp4"), {4, 1, 160, height}));
    QVERIFY(!VideoReader::isShownOtherwise(path("a.mp4"), {}));
    const Frame now = (*VideoReader::open(path("a.mp4"), {}, {4, 1, 160, height}))->frameAt(1).value();
    QCOMPARE(now.format.width, 160);
}

void TestStretchedFrames::aTurnedOneIsStretchedBefore()
{
    RawVideo video = anamorphic("libx264", 4, 3);
    video.turn = {0, 1, -1, 0};
    QVERIFY(writeRaw(path("turned.mov"), video));
    QVERIFY(writeRaw(path("a.mov"), anamorphic("libx264", 4, 3)));
    const auto reader = VideoReader::open(path("turned.mov"));
    QCOMPARE((*reader)->info().orientation, 6);
    QCOMPARE((*reader)->info().format.width, height);
    QCOMPARE((*reader)->info().format.height, 160);
    const Frame frame = (*reader)->frameAt(2).value();
    const Frame expected = turned((*VideoReader::open(path("a.mov")))->frameAt(2).value(), 6);
    for (int y = 0; y < 160; ++y)
        for (int x = 0; x < height; ++x)
            QCOMPARE(frame.y.at(x, y), expected.y.at(x, y));
    QCOMPARE((*VideoReader::open(path("turned.mov"), {}, {4, 6, height, width}))->info().format.height,
             width);
}

void TestStretchedFrames::ratiosThatNoCameraWrites_data()
{
    QTest::addColumn<int>("aspectWidth");
    QTest::addColumn<int>("aspectHeight");
    QTest::newRow("not stated") << 0 << 1;
    QTest::newRow("a line") << 255 << 1;
    QTest::newRow("a column") << 1 << 200;
}

void TestStretchedFrames::ratiosThatNoCameraWrites()
{
    QFETCH(int, aspectWidth);
    QFETCH(int, aspectHeight);
    QVERIFY(writeRaw(path("odd.mkv"), anamorphic("ffv1", aspectWidth, aspectHeight)));
    const auto reader = VideoReader::open(path("odd.mkv"));
    QVERIFY(reader.has_value());
    QCOMPARE((*reader)->info().format.width, width);
}

ODOGRAPH_TEST(TestStretchedFrames, QCoreApplication)
#include "tst_stretched_frames.moc"
