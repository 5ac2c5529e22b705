// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/internal/libav.h"
#include "core/video/internal/stream_format.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"
#include "tests/video/foreign_files.h"
#include "tests/video/moving_square.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstring>

using namespace odo;
using namespace odo::test;

/// Files as other programs write them: containers without presentation times, semi-planar and grey pictures,
/// interlaced ones.
class TestForeignFiles : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void containers_data();
    void containers();
    void ratesOfBareStreams_data();
    void ratesOfBareStreams();
    void containersThatAreNotTrusted();
    void timesBeyondAnyVideoAreRefused();
    void pixelFormats_data();
    void pixelFormats();
    void eachFieldIsAFrame();
    void whatMovesSaysWhetherThereAreFields();
    void theCamerasRateIsToldApart();
    void coloursWithoutANameCountAsNotStated();
    void refusedPixelFormats_data();
    void refusedPixelFormats();
    void sitingOfArbitraryBytes();
    void sitingBehindAnOddListOfScales();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    QTemporaryDir m_folder;
};

void TestForeignFiles::containers_data()
{
    QTest::addColumn<int>("bFrames");
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isBare");
    for (const int bFrames : {0, 3})
        for (const char *ending : {"mov", "avi", "ts", "flv", "mkv", "nut", "h264"})
            QTest::addRow("%s, %d B frames", ending, bFrames)
                << bFrames << QStringLiteral("copy.") + QString::fromLatin1(ending)
                << (QByteArray(ending) == "h264");
}

void TestForeignFiles::containers()
{
    QFETCH(int, bFrames);
    QFETCH(QString, name);
    QFETCH(bool, isBare);
    constexpr int count = 300;
    VideoWriterOptions options;
    options.maxBFrames = bFrames;
    options.bitRate = 500'000;
    options.nominalFramesPerSecond = 25;
    QCOMPARE(writeCoded(path("original.mp4"), evenTimes(count, 25), options), QString());
    const auto file = path(name.toStdString());
    QVERIFY(remux(path("original.mp4"), file));
    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    const VideoInfo &info = (*reader)->info();
    QVERIFY2(info.warning.isEmpty(), info.warning.english().c_str());
    QCOMPARE(info.timeSource == TimeSource::Stamps, !isBare);
    QCOMPARE(info.frameTimes.size(), std::size_t(count));
    for (int i = 0; i < count; ++i) {
        if (!isBare)
            QCOMPARE(info.frameTimes[static_cast<std::size_t>(i)], Nanoseconds(i * 40'000'000LL));
        const auto frame = (*reader)->next();
        QVERIFY(frame.has_value());
        QCOMPARE(numberIn(**frame), i);
    }
    for (const int i : {299, 0, 251, 249, 250, 100, 7, 8, 290})
        QCOMPARE(numberIn((*reader)->frameAt(i).value()), i);
}

/// Stamps may be any number; what lies between these does not fit into 64 bits of nanoseconds.
void TestForeignFiles::timesBeyondAnyVideoAreRefused()
{
    constexpr std::int64_t interval = 50'000'000'000'000'000;
    QVERIFY(writeRaw(path("far.mkv"), "mjpeg", "yuvj420p", 3, interval));
    const auto reader = VideoReader::open(path("far.mkv"));
    QVERIFY(!reader);
    QCOMPARE(reader.error().why.english(), std::string("its time stamps span 8640000.00 s"));
}

void TestForeignFiles::ratesOfBareStreams_data()
{
    QTest::addColumn<QString>("encoder");
    QTest::addColumn<QString>("pixelFormat");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("rate");
    QTest::addColumn<int>("tick");
    QTest::addColumn<int>("stated"); // 0: none
    const QString mjpeg = QStringLiteral("mjpeg"), h264 = QStringLiteral("libx264"),
                  jpegFormat = QStringLiteral("yuvj420p"), yuv = QStringLiteral("yuv420p");
    for (const char *name : {"a.mjpeg", "a.mjpg"})
        QTest::newRow(name) << mjpeg << jpegFormat << QString::fromLatin1(name) << 30 << 30 << 0;
    QTest::newRow("H.264 at 30") << h264 << yuv << QStringLiteral("a.h264") << 30 << 30 << 30;
    QTest::newRow("H.264 at 50") << h264 << yuv << QStringLiteral("b.h264") << 50 << 50 << 50;
    // the clock of the container that it came from, as of Matroska files
    QTest::newRow("H.264 in ms") << h264 << yuv << QStringLiteral("c.h264") << 30 << 1000 << 0;
    QTest::newRow("H.264 in µs") << h264 << yuv << QStringLiteral("d.h264") << 30 << 1'000'000 << 0;
    QTest::newRow("MPEG-2") << QStringLiteral("mpeg2video") << yuv << QStringLiteral("a.m2v") << 50 << 50
                            << 50;
}

/// libav's 25 frames/s for a stream that states none, and the tick of a clock, are no frame rate.
void TestForeignFiles::ratesOfBareStreams()
{
    QFETCH(QString, encoder);
    QFETCH(QString, pixelFormat);
    QFETCH(QString, name);
    QFETCH(int, rate);
    QFETCH(int, tick);
    QFETCH(int, stated);
    const auto file = path(name.toStdString());
    if (!writeRaw(file, encoder.toStdString(), pixelFormat.toStdString(), 12, tick / rate, 320, tick))
        QSKIP("this libav has no such encoder");
    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    const VideoInfo &info = (*reader)->info();
    QVERIFY2(info.warning.isEmpty(), info.warning.english().c_str());
    QCOMPARE(info.timeSource, stated > 0 ? TimeSource::Rate : TimeSource::Nowhere);
    QCOMPARE(VideoReader::lacksTimes(file), stated == 0);
    QCOMPARE(info.frameTimes.size(), std::size_t(12));
    if (stated > 0)
        QVERIFY(std::abs(info.framesPerSecond - stated) < 1e-3);
    // Which frame is which does not depend on its time.
    for (const int i : {0, 11, 5})
        QCOMPARE((*reader)->frameAt(i).value().index, std::int64_t(i));
    QVERIFY(!VideoReader::lacksTimes(path("missing.mjpeg")));
}

void TestForeignFiles::containersThatAreNotTrusted()
{
    QVERIFY(writeRaw(path("r.mxf"), "mpeg2video", "yuv420p", 3));
    const auto reader = VideoReader::open(path("r.mxf"));
    QVERIFY(!reader.has_value());
    QCOMPARE(reader.error().code, ErrorCode::InvalidInput);
    QVERIFY2(QString::fromStdString(reader.error().message())
                 .endsWith(QStringLiteral(
                     "give an MP4, MOV, MKV or AVI file; copy it from the camera again if it was cut short")),
             reader.error().message().c_str());
}

void TestForeignFiles::pixelFormats_data()
{
    QTest::addColumn<QString>("encoder");
    QTest::addColumn<QString>("pixelFormat");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("shiftX");
    QTest::addColumn<int>("shiftY");
    QTest::addColumn<QList<int>>("values"); // of Y, U, V in frame 0
    const QString ffv1 = QStringLiteral("ffv1"), raw = QStringLiteral("rawvideo"),
                  mkv = QStringLiteral("p.mkv");
    QTest::newRow("4:2:0") << ffv1 << QStringLiteral("yuv420p") << mkv << 1 << 1 << QList<int>{40, 60, 80};
    QTest::newRow("grey") << ffv1 << QStringLiteral("gray") << mkv << 1 << 1 << QList<int>{40, 128, 128};
    QTest::newRow("NV12") << raw << QStringLiteral("nv12") << QStringLiteral("p.nut") << 1 << 1
                          << QList<int>{40, 60, 160};
}

void TestForeignFiles::pixelFormats()
{
    QFETCH(QString, encoder);
    QFETCH(QString, pixelFormat);
    QFETCH(QString, name);
    QFETCH(int, shiftX);
    QFETCH(int, shiftY);
    QFETCH(QList<int>, values);
    const auto file = path(name.toStdString());
    QVERIFY(writeRaw(file, encoder.toStdString(), pixelFormat.toStdString(), 3));
    const auto reader = VideoReader::open(file);
    QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
    QCOMPARE((*reader)->info().frameTimes.size(), std::size_t(3));
    QCOMPARE((*reader)->info().format.chromaShiftX, shiftX);
    QCOMPARE((*reader)->info().format.chromaShiftY, shiftY);
    const Frame frame = (*reader)->frameAt(0).value();
    for (const auto &[x, y] : {std::pair{0, 0}, std::pair{31, 23}}) {
        QCOMPARE(int(frame.y.at(x, y)), values[0]);
        QCOMPARE(int(frame.u.at(x, y)), values[1]);
        QCOMPARE(int(frame.v.at(x, y)), values[2]);
    }
    QCOMPARE(int((*reader)->frameAt(2).value().y.at(63, 47)), 42);
}

void TestForeignFiles::eachFieldIsAFrame()
{
    for (const char *format : {"yuv420p", "gray"}) {
        QVERIFY(writeRaw(path("fields.mkv"), "ffv1", format, 3, 1, 64, 25, true));
        const auto reader = VideoReader::open(path("fields.mkv"));
        QVERIFY2(reader.has_value(), reader ? "" : reader.error().message().c_str());
        const VideoInfo &info = (*reader)->info();
        QVERIFY(info.areFields);
        QCOMPARE(info.framesPerSecond, 25.0);
        QCOMPARE(info.frameTimes.size(), std::size_t(6));
        for (const std::int64_t number : {3, 2, 5, 0, 1}) {
            const Frame frame = (*reader)->frameAt(number).value();
            QCOMPARE(frame.index, number);
            QCOMPARE(frame.time, std::chrono::milliseconds(20 * number));
            const int luma = 40 + int(number / 2) + (number % 2 != 0 ? 50 : 0);
            for (int y = 0; y < 48; ++y) // without a trace of the other
                QCOMPARE(int(frame.y.at(5, y)), luma);
            for (int y = 0; y < 24; ++y)
                QCOMPARE(int(frame.u.at(5, y)), format[0] == 'y' ? luma + 20 : 128);
        }
        QVERIFY(!(*reader)->seek(6));
        // a project that counts them whole
        const auto whole = VideoReader::open(path("fields.mkv"), {}, {3, {}});
        QVERIFY(!(*whole)->info().areFields);
        const Frame frame = (*whole)->frameAt(2).value();
        QCOMPARE(int(frame.y.at(5, 6)), 42);
        QCOMPARE(int(frame.y.at(5, 7)), 92);
    }
    QVERIFY(writeRaw(path("whole.mkv"), "ffv1", "yuv420p", 3));
    QVERIFY(!(*VideoReader::open(path("whole.mkv")))->info().areFields);
    QVERIFY(!(*VideoReader::open(path("whole.mkv"), {}, {6, {}}))->info().areFields);
}

void TestForeignFiles::whatMovesSaysWhetherThereAreFields()
{
    const auto fieldsIn = [&](FieldOrder order, bool isStated, std::size_t known) {
        writeLuma(path("moving.mkv"), movingSquare(order, 20), isStated);
        auto reader = VideoReader::open(path("moving.mkv"), {}, {known, {}});
        return reader && (*reader)->info().areFields ? std::move(*reader) : nullptr;
    };
    QVERIFY(writeLuma(path("moving.mkv"), movingSquare(FieldOrder::TopFirst, 2), true));
    using enum FieldOrder;
    QVERIFY(!fieldsIn(OneMoment, true, 0)); // only called interlaced
    QVERIFY(!fieldsIn(OneMoment, false, 40));
    QVERIFY(!fieldsIn(BottomFirst, false, 0)); // nobody asked
    for (const auto &[order, isStated, known] : {std::tuple{TopFirst, true, 0},
                                                 {BottomFirst, true, 0},
                                                 {TopFirst, false, 40},
                                                 {BottomFirst, false, 40}}) {
        const auto reader = fieldsIn(order, isStated, std::size_t(known));
        QVERIFY(reader);
        QCOMPARE(reader->info().frameTimes.size(), std::size_t(40));
        for (std::int64_t number = 0; number < 40; ++number) // in the order in which they were taken
            QCOMPARE(leftEdge(reader->frameAt(number).value()), edgeAt(double(number) / 2));
    }
}

void TestForeignFiles::theCamerasRateIsToldApart()
{
    const auto rateOf = [&](const char *stated) {
        RawVideo video{"libx264", "yuv420p", 4, 64, 48, 30};
        video.fill = [](AVFrame &image, int) {
            std::memset(image.data[0], 90, std::size_t(image.linesize[0]));
        };
        video.muxing = {{"movflags", "use_metadata_tags"}};
        if (stated)
            video.metadata = {{"com.android.capture.fps", stated}};
        const bool isWritten = writeRaw(path("captured.mp4"), video);
        const auto reader = VideoReader::open(path("captured.mp4"));
        return isWritten && reader ? (*reader)->info().capturedPerSecond : -1;
    };
    QCOMPARE(rateOf("240.000000"), std::optional(240.0));
    for (const char *none : {"", "fast", "-30", "0", "inf", "nan"})
        QCOMPARE(rateOf(none), std::optional<double>());
    QCOMPARE(rateOf(nullptr), std::optional<double>());
}

void TestForeignFiles::coloursWithoutANameCountAsNotStated()
{
    const libav::ParametersPtr parameters(avcodec_parameters_alloc());
    const auto state = [](auto &what, int number) { std::memcpy(&what, &number, sizeof what); };
    state(parameters->color_space, 67); // in unknown_colours.m2v of the fuzzing seeds
    state(parameters->color_range, 3);
    state(parameters->color_trc, 67);
    state(parameters->chroma_location, -1);
    libav::forgetUnknownColours(*parameters);
    QCOMPARE(parameters->color_space, AVCOL_SPC_UNSPECIFIED);
    QCOMPARE(parameters->color_range, AVCOL_RANGE_UNSPECIFIED);
    QCOMPARE(parameters->color_trc, AVCOL_TRC_UNSPECIFIED);
    QCOMPARE(parameters->chroma_location, AVCHROMA_LOC_UNSPECIFIED);
    parameters->color_space = AVCOL_SPC_BT709;
    parameters->color_range = AVCOL_RANGE_JPEG;
    parameters->chroma_location = AVCHROMA_LOC_TOPLEFT;
    libav::forgetUnknownColours(*parameters);
    QCOMPARE(parameters->color_space, AVCOL_SPC_BT709);
    QCOMPARE(parameters->color_range, AVCOL_RANGE_JPEG);
    QCOMPARE(parameters->chroma_location, AVCHROMA_LOC_TOPLEFT);
}

void TestForeignFiles::refusedPixelFormats_data()
{
    QTest::addColumn<QString>("encoder");
    QTest::addColumn<QString>("pixelFormat");
    QTest::newRow("a sensor's mosaic") << QStringLiteral("rawvideo") << QStringLiteral("bayer_rggb8");
}

void TestForeignFiles::refusedPixelFormats()
{
    QFETCH(QString, encoder);
    QFETCH(QString, pixelFormat);
    QVERIFY(writeRaw(path("r.nut"), encoder.toStdString(), pixelFormat.toStdString(), 2));
    const auto reader = VideoReader::open(path("r.nut"));
    QVERIFY(!reader.has_value());
    QCOMPARE(reader.error().code, ErrorCode::InvalidInput);
    QVERIFY2(reader.error().message().find(pixelFormat.toStdString() +
                                           " is not supported; convert it to 8-bit YUV") != std::string::npos,
             reader.error().message().c_str());
}

/// A damaged parameter set gives an answer or none, but never a read outside (seen by the address sanitizer).
void TestForeignFiles::sitingOfArbitraryBytes()
{
    unsigned state = 1;
    for (int run = 0; run < 2000; ++run) {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(run % 80));
        for (std::uint8_t &byte : bytes) {
            state = state * 1664525U + 1013904223U;
            byte = static_cast<std::uint8_t>(state >> 24);
        }
        const std::uint8_t annexB[] = {0, 0, 1, 0x67}, avcC[] = {1, 100, 0, 30, 0xff, 0xe1, 0, 20};
        if (run % 2 == 0 && bytes.size() > 4)
            std::copy(std::begin(annexB), std::end(annexB), bytes.begin());
        else if (bytes.size() > 8)
            std::copy(std::begin(avcC), std::end(avcC), bytes.begin());
        const auto location = h264ChromaLocation(bytes);
        QVERIFY(!location || *location <= 5);
    }
}

/// The difference in a list of scales may be any number in a damaged one (an overflow, seen by the
/// undefined-behaviour sanitizer). What follows is read as ever: the location that is told here is 3.
void TestForeignFiles::sitingBehindAnOddListOfScales()
{
    std::vector<std::uint8_t> bytes{0, 0, 1, 0x67, 100, 0, 30};
    const QByteArray zeros(31, '0'), ones(30, '1');
    QByteArray bits = "1"
                      "010"
                      "1"
                      "1"
                      "0"
                      "1";                  // id, 4:2:0, depths, not bypassed, there are lists of scales
    bits += "1" + zeros + "1" + ones + "0"; // the first one: 8 + 2147483647 modulo 256 is 7
    bits += QByteArray(15, '1');            // and no more differences
    bits += QByteArray(7, '0');             // the other lists are not there
    // numbers of frames, order, its bits, references, no gaps, size, whole frames, no cropping
    bits += "1"
            "1"
            "1"
            "1"
            "0"
            "1"
            "1"
            "1"
            "1"
            "0";
    // the VUI: nothing of aspect, overscan and signal, but where chroma lies
    bits += "1"
            "0"
            "0"
            "0"
            "1"
            "00100"
            "00100";
    bits += QByteArray((8 - bits.size() % 8) % 8 + 8, '1');
    for (qsizetype at = 0; at < bits.size(); at += 8)
        bytes.push_back(static_cast<std::uint8_t>(bits.mid(at, 8).toUInt(nullptr, 2)));
    const auto location = h264ChromaLocation(bytes);
    QVERIFY(location);
    QCOMPARE(*location, 3U);
}

ODOGRAPH_TEST(TestForeignFiles, QCoreApplication)
#include "tst_foreign_files.moc"
