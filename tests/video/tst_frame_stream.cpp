// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/frame_stream.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;
using namespace odo::test;

class TestFrameStream : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void givesEveryFrameAndThenTheEnd();
    void decodesPartsOnDemand();
    void canBeDroppedAtAnyTime();
    void skipsDamagedFrames();
    void refusesWhatTheReaderRefuses();

private:
    std::filesystem::path path(const char *name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    QTemporaryDir m_folder;
};

void TestFrameStream::givesEveryFrameAndThenTheEnd()
{
    constexpr int count = 100;
    const auto times = unevenTimes(count);
    QCOMPARE(writeCoded(path("a.mkv"), times, {}), QString());
    const auto stream = FrameStream::open(path("a.mkv"), 3);
    QVERIFY(stream.has_value());
    QCOMPARE((*stream)->info().frameTimes.size(), std::size_t(count));
    for (int i = 0; i < count; ++i) {
        const auto frame = (*stream)->pop();
        QVERIFY(frame.has_value() && frame->has_value());
        QCOMPARE(numberIn(**frame), i);
        QCOMPARE((*frame)->time, times[static_cast<std::size_t>(i)]);
    }
    QVERIFY(!(*stream)->pop().value().has_value());
    QVERIFY(!(*stream)->pop().value().has_value()); // the end stays the end
    QVERIFY((*stream)->decodeCpuTime() > Nanoseconds(0));
    QVERIFY((*stream)->decodeCpuTime() < std::chrono::seconds(60));
}

void TestFrameStream::decodesPartsOnDemand()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::Mjpeg;
    QCOMPARE(writeCoded(path("parts.mkv"), evenTimes(20, 30), options), QString());
    auto reader = VideoReader::open(path("parts.mkv"));
    QVERIFY(reader.has_value());
    FrameStream stream(std::move(*reader), 0);
    for (int i = 0; i < 20; ++i) {
        // A different part of every second frame; the numbers are in the other.
        const bool part = i % 2 == 0;
        const auto frame =
            stream.pop(part ? std::optional(PixelRect{32, 4 * i, 64, 4 * i + 5}) : std::nullopt).value();
        QVERIFY(frame.has_value());
        QCOMPARE(frame->index, std::int64_t(i));
        QCOMPARE(frame->validRegion.has_value(), part);
        QCOMPARE(numberIn(wholeFrame(*frame).value()), i);
    }
    QVERIFY(!stream.pop().value().has_value());
    QVERIFY(stream.decodeCpuTime() > Nanoseconds(0));
}

void TestFrameStream::canBeDroppedAtAnyTime()
{
    QCOMPARE(writeCoded(path("b.mkv"), evenTimes(60, 30), {}), QString());
    for (int taken = 0; taken < 5; ++taken) {
        auto stream = FrameStream::open(path("b.mkv"), 2);
        QVERIFY(stream.has_value());
        for (int i = 0; i < taken; ++i)
            QVERIFY((*stream)->pop().value().has_value());
        stream->reset(); // its thread waits for room in the queue
    }
}

void TestFrameStream::skipsDamagedFrames()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::Ffv1;
    QCOMPARE(writeCoded(path("c.mkv"), evenTimes(30, 30), options), QString());
    {
        std::fstream file(path("c.mkv"), std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(path("c.mkv")) / 2));
        file.write("damage damage damage", 20);
    }
    const auto stream = FrameStream::open(path("c.mkv"));
    QVERIFY(stream.has_value());
    int good = 0;
    while (const auto frame = (*stream)->pop().value()) {
        QCOMPARE(numberIn(*frame), int(frame->index));
        ++good;
    }
    QCOMPARE(good, 29);
}

void TestFrameStream::refusesWhatTheReaderRefuses()
{
    const auto stream = FrameStream::open(path("missing.mkv"));
    QVERIFY(!stream.has_value());
    QCOMPARE(stream.error().code, ErrorCode::NotFound);
}

ODOGRAPH_TEST(TestFrameStream, QCoreApplication)
#include "tst_frame_stream.moc"
