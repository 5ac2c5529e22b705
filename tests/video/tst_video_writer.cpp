// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestVideoWriter : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void roundTrip_data();
    void roundTrip();
    void losslessIsLossless();
    void keepsTheColourDescription_data();
    void keepsTheColourDescription();
    void sameBytesTwice();
    void appearsOnlyWhenFinished();
    void timesBeginAtTheFirstFrame();
    void refusals();

private:
    std::filesystem::path path(const char *name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    /// How many files are being written, or were left.
    int temporaries() const
    {
        return int(QDir(m_folder.path())
                       .entryList({QStringLiteral(".odograph-*")}, QDir::Dirs | QDir::Hidden)
                       .size());
    }
    QTemporaryDir m_folder;
};

void TestVideoWriter::roundTrip_data()
{
    QTest::addColumn<int>("codec");
    QTest::addColumn<QString>("ending");
    QTest::addColumn<bool>("even");
    QTest::addColumn<int>("bFrames");
    QTest::newRow("h264 mkv") << int(VideoCodec::H264) << QStringLiteral(".mkv") << true << 0;
    QTest::newRow("h264 mkv uneven") << int(VideoCodec::H264) << QStringLiteral(".mkv") << false << 0;
    QTest::newRow("h264 mp4") << int(VideoCodec::H264) << QStringLiteral(".mp4") << true << 0;
    QTest::newRow("h264 mp4 uneven") << int(VideoCodec::H264) << QStringLiteral(".mp4") << false << 0;
    QTest::newRow("h264 mp4 B frames") << int(VideoCodec::H264) << QStringLiteral(".mp4") << true << 3;
    QTest::newRow("h264 mp4 B frames uneven")
        << int(VideoCodec::H264) << QStringLiteral(".mp4") << false << 3;
    QTest::newRow("h264 mkv B frames left out")
        << int(VideoCodec::H264) << QStringLiteral(".mkv") << false << 3;
    QTest::newRow("mjpeg mkv uneven") << int(VideoCodec::Mjpeg) << QStringLiteral(".mkv") << false << 0;
    QTest::newRow("mjpeg mp4 uneven") << int(VideoCodec::Mjpeg) << QStringLiteral(".mp4") << false << 0;
    QTest::newRow("ffv1 mkv uneven") << int(VideoCodec::Ffv1) << QStringLiteral(".mkv") << false << 0;
}

void TestVideoWriter::roundTrip()
{
    QFETCH(int, codec);
    QFETCH(QString, ending);
    QFETCH(bool, even);
    QFETCH(int, bFrames);
    constexpr int count = 120;
    const auto times = even ? evenTimes(count, 30) : unevenTimes(count);
    VideoWriterOptions options;
    options.codec = static_cast<VideoCodec>(codec);
    options.bitRate = 1'000'000;
    options.maxBFrames = bFrames;
    const auto file = path(("round" + ending.toStdString()).c_str());
    QCOMPARE(writeCoded(file, times, options), QString());

    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    const VideoInfo &info = (*reader)->info();
    QCOMPARE(info.warning.english(), std::string());
    QCOMPARE(info.frameTimes.size(), times.size());
    QCOMPARE(info.variableRate, !even);
    if (even)
        QVERIFY(std::abs(info.framesPerSecond - 30.0) < 0.001);
    for (int i = 0; i < count; ++i) {
        // Both containers count in microseconds: half of one is lost at most.
        QVERIFY(std::abs((info.frameTimes[i] - times[i]).count()) <= 500);
        const auto frame = (*reader)->next();
        QVERIFY(frame.has_value() && frame->has_value());
        QCOMPARE((*frame)->index, std::int64_t(i));
        QCOMPARE((*frame)->time, info.frameTimes[i]);
        QCOMPARE(numberIn(**frame), i);
    }
    QVERIFY(!(*reader)->next().value().has_value());
}

void TestVideoWriter::losslessIsLossless()
{
    for (const auto &[shiftX, shiftY] : {std::pair{1, 1}, std::pair{1, 0}, std::pair{0, 0}}) {
        FrameFormat format = smallFormat();
        format.width = 191; // odd, so that chroma is rounded up
        format.height = 95;
        format.chromaShiftX = shiftX;
        format.chromaShiftY = shiftY;
        VideoWriterOptions options;
        options.codec = VideoCodec::Ffv1;
        QCOMPARE(writeCoded(path("lossless.mkv"), evenTimes(3, 30), options, format), QString());
        const auto reader = VideoReader::open(path("lossless.mkv"));
        QVERIFY(reader.has_value());
        const Frame written = codedFrame(format, 2, Nanoseconds(0));
        const auto read = (*reader)->frameAt(2);
        QVERIFY(read.has_value());
        const auto same = [](const PlaneView &a, const PlaneView &b) {
            bool equal = a.width == b.width && a.height == b.height;
            for (int y = 0; equal && y < a.height; ++y)
                equal = std::equal(a.row(y), a.row(y) + a.width, b.row(y));
            return equal;
        };
        QVERIFY(same(read->y, written.y));
        QVERIFY(same(read->u, written.u));
        QVERIFY(same(read->v, written.v));
    }
}

void TestVideoWriter::keepsTheColourDescription_data()
{
    QTest::addColumn<int>("codec");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("siting");
    QTest::addColumn<int>("matrix");
    QTest::addColumn<bool>("fullRange");
    for (const ChromaSiting siting :
         {ChromaSiting::Left, ChromaSiting::Center, ChromaSiting::TopLeft, ChromaSiting::Unknown})
        for (const YuvMatrix matrix : {YuvMatrix::Bt601, YuvMatrix::Bt709})
            for (const bool full : {false, true})
                for (const char *name : {"h264.mp4", "h264.mkv", "ffv1.mkv"})
                    QTest::addRow("%s siting %d matrix %d full %d", name, int(siting), int(matrix), int(full))
                        << int(name[0] == 'h' ? VideoCodec::H264 : VideoCodec::Ffv1)
                        << QString::fromLatin1(name) << int(siting) << int(matrix) << full;
    for (const bool full : {false, true})
        QTest::addRow("mjpeg full %d", int(full))
            << int(VideoCodec::Mjpeg) << QStringLiteral("mjpeg.mkv") << int(ChromaSiting::Center)
            << int(YuvMatrix::Bt601) << full;
}

void TestVideoWriter::keepsTheColourDescription()
{
    QFETCH(int, codec);
    QFETCH(QString, name);
    QFETCH(int, siting);
    QFETCH(int, matrix);
    QFETCH(bool, fullRange);
    FrameFormat format = smallFormat();
    format.siting = static_cast<ChromaSiting>(siting);
    format.matrix = static_cast<YuvMatrix>(matrix);
    format.fullRange = fullRange;
    VideoWriterOptions options;
    options.codec = static_cast<VideoCodec>(codec);
    const auto file = path(name.toLatin1().constData());
    QCOMPARE(writeCoded(file, evenTimes(2, 30), options, format), QString());
    const auto reader = VideoReader::open(file);
    QVERIFY(reader.has_value());
    QCOMPARE(int((*reader)->info().format.siting), siting);
    QCOMPARE(int((*reader)->info().format.matrix), matrix);
    QCOMPARE((*reader)->info().format.fullRange, fullRange);
}

void TestVideoWriter::sameBytesTwice()
{
    QByteArray bytes[2];
    for (QByteArray &written : bytes) {
        QCOMPARE(writeCoded(path("same.mkv"), evenTimes(20, 30), {}), QString());
        QFile file(QString::fromStdString(path("same.mkv").string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        written = file.readAll();
    }
    QVERIFY(bytes[0] == bytes[1]);
}

void TestVideoWriter::appearsOnlyWhenFinished()
{
    const auto file = path("late.mkv");
    {
        const auto writer = VideoWriter::create(file, smallFormat(), {});
        QVERIFY(writer.has_value());
        QVERIFY((*writer)->write(codedFrame(smallFormat(), 0, Nanoseconds(0))).has_value());
        QVERIFY(!std::filesystem::exists(file));
    }
    QVERIFY(!std::filesystem::exists(file));
    QCOMPARE(temporaries(), 0);
    QCOMPARE(writeCoded(file, evenTimes(2, 30), {}), QString());
    QVERIFY(std::filesystem::exists(file));
    QCOMPARE(temporaries(), 0);
}

void TestVideoWriter::timesBeginAtTheFirstFrame()
{
    for (const char *name : {"offset.mkv", "offset.mp4"}) {
        auto times = evenTimes(5, 50);
        for (Nanoseconds &time : times)
            time += std::chrono::hours(3);
        QCOMPARE(writeCoded(path(name), times, {}), QString());
        const auto reader = VideoReader::open(path(name));
        QVERIFY(reader.has_value());
        QCOMPARE((*reader)->info().frameTimes.size(), std::size_t(5));
        QCOMPARE((*reader)->info().frameTimes[4], Nanoseconds(80'000'000));
        QCOMPARE((*reader)->info().duration, Nanoseconds(100'000'000));
    }
}

void TestVideoWriter::refusals()
{
    VideoWriterOptions options;
    const auto refusal = [&](const char *name, const FrameFormat &format) {
        const auto writer = VideoWriter::create(path(name), format, options);
        return writer ? std::string() : writer.error().message();
    };
    QVERIFY(refusal("a.avi", smallFormat()).find("neither .mkv nor .mp4") != std::string::npos);
    QVERIFY(refusal("no-such-folder/a.mkv", smallFormat()).find("does not exist") != std::string::npos);
    FrameFormat odd = smallFormat();
    odd.width = 191;
    QVERIFY(refusal("a.mkv", odd).find("even width and height, not 191x96") != std::string::npos);
    options.codec = VideoCodec::Ffv1;
    QVERIFY(refusal("a.mp4", smallFormat()).find("use the ending .mkv") != std::string::npos);

    const auto writer = VideoWriter::create(path("order.mkv"), smallFormat(), {});
    QVERIFY(writer.has_value());
    QVERIFY((*writer)->write(codedFrame(smallFormat(), 0, Nanoseconds(5000))).has_value());
    const auto again = (*writer)->write(codedFrame(smallFormat(), 1, Nanoseconds(5000)));
    QVERIFY(!again.has_value());
    QCOMPARE(again.error().code, ErrorCode::InvalidInput);
    QVERIFY(!(*writer)->write(codedFrame(odd, 1, Nanoseconds(9000))).has_value());
    QVERIFY((*writer)->finish().has_value()); // a refused frame spoils nothing
    QVERIFY(!(*writer)->finish().has_value());
    QVERIFY(!VideoWriter::create(path("empty.mkv"), smallFormat(), {}).value()->finish().has_value());
}

ODOGRAPH_TEST(TestVideoWriter, QCoreApplication)
#include "tst_video_writer.moc"
