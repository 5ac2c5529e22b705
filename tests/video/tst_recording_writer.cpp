// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/jpeg.h"
#include "core/video/recording_writer.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstdlib>

using namespace odo;

namespace {

/// A smooth picture that differs from frame to frame.
Frame painted(const FrameFormat &format, int number)
{
    auto buffer = std::make_shared<FrameBuffer>(format);
    for (int y = 0; y < format.height; ++y)
        for (int x = 0; x < format.width; ++x)
            buffer->yRow(y)[x] = static_cast<std::uint8_t>(60 + (x + y + 5 * number) % 128);
    for (int y = 0; y < buffer->chromaHeight(); ++y)
        for (int x = 0; x < buffer->chromaWidth(); ++x) {
            buffer->uRow(y)[x] = static_cast<std::uint8_t>(100 + x % 40);
            buffer->vRow(y)[x] = static_cast<std::uint8_t>(150 - y % 40);
        }
    return FrameBuffer::toFrame(std::move(buffer), number, fromSeconds(number / 30.0));
}

double meanDifference(const PlaneView &a, const PlaneView &b, double scale, double zero, double zeroAfter)
{
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            sum += std::abs((a.at(x, y) - zero) * scale + zeroAfter - b.at(x, y));
    return sum / (a.width * a.height);
}

} // namespace

class TestRecordingWriter : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void picturesComeBack_data();
    void picturesComeBack();
    void whatWasWrittenCanBeReadWithoutAnEnd();
    void timesNeverStandStill();
    void neverOverwrites();
    void tellsWhatStandsInItsWay();

private:
    std::filesystem::path file(const char *name) const
    {
        return m_folder.filePath(QString::fromLatin1(name)).toStdString();
    }
    /// Writes so many pictures; finished or not.
    void write(const std::filesystem::path &path, const FrameFormat &format, int count, bool finish)
    {
        JpegEncoder encoder;
        auto writer = RecordingWriter::create(path, format, 30);
        QVERIFY2(writer, writer ? "" : writer.error().message().c_str());
        for (int i = 0; i < count; ++i) {
            const Frame frame = painted(format, i);
            const auto jpeg = encoder.encode(frame);
            QVERIFY(jpeg);
            QVERIFY((*writer)->write(*jpeg, frame.time));
        }
        if (finish)
            QVERIFY((*writer)->finish());
    }

    QTemporaryDir m_folder;
};

void TestRecordingWriter::picturesComeBack_data()
{
    QTest::addColumn<int>("shiftX");
    QTest::addColumn<int>("shiftY");
    QTest::addColumn<int>("siting");
    QTest::addColumn<bool>("fullRange");
    const auto left = int(ChromaSiting::Left), centre = int(ChromaSiting::Center);
    QTest::newRow("4:2:0") << 1 << 1 << centre << true;
    QTest::newRow("4:2:0, left, limited range") << 1 << 1 << left << false;
    QTest::newRow("4:2:2, left") << 1 << 0 << left << true;
    QTest::newRow("4:4:4") << 0 << 0 << centre << false;
}

void TestRecordingWriter::picturesComeBack()
{
    QFETCH(int, shiftX);
    QFETCH(int, shiftY);
    QFETCH(int, siting);
    QFETCH(bool, fullRange);
    const FrameFormat format{320, 176, shiftX, shiftY, ChromaSiting(siting), YuvMatrix::Bt601, fullRange};
    const auto path = file(QTest::currentDataTag()).replace_extension(".mkv");
    write(path, format, 10, true);
    const auto reader = VideoReader::open(path);
    QVERIFY2(reader, reader ? "" : reader.error().message().c_str());
    const VideoInfo &info = (*reader)->info();
    QCOMPARE(info.frameTimes.size(), std::size_t(10));
    QVERIFY(std::abs(toSeconds(info.frameTimes[9]) - 0.3) < 0.001);
    QVERIFY(info.format.fullRange);
    QCOMPARE(info.format.chromaShiftX, shiftX);
    QCOMPARE(info.format.chromaShiftY, shiftY);
    if (shiftX == 1) // otherwise it means nothing
        QCOMPARE(int(info.format.siting), siting);
    for (int i = 0; i < 10; ++i) {
        const auto frame = (*reader)->next();
        QVERIFY(frame && *frame);
        const Frame truth = painted(format, i);
        // What coding at this quality leaves of a smooth picture: less than one code value.
        QVERIFY(meanDifference(truth.y, (*frame)->y, fullRange ? 1 : 255 / 219.0, fullRange ? 0 : 16, 0) <
                1.5);
        QVERIFY(meanDifference(truth.u, (*frame)->u, fullRange ? 1 : 255 / 224.0, fullRange ? 0 : 128,
                               fullRange ? 0 : 128) < 1.5);
        QVERIFY(meanDifference(truth.v, (*frame)->v, fullRange ? 1 : 255 / 224.0, fullRange ? 0 : 128,
                               fullRange ? 0 : 128) < 1.5);
    }
}

void TestRecordingWriter::whatWasWrittenCanBeReadWithoutAnEnd()
{
    const FrameFormat format{320, 176};
    const auto path = file("killed.mkv");
    // As a kill leaves it: a copy of the file while it is still being written.
    JpegEncoder encoder;
    auto writer = RecordingWriter::create(path, format, 30);
    QVERIFY(writer);
    for (int i = 0; i < 90; ++i) {
        const Frame frame = painted(format, i);
        QVERIFY((*writer)->write(*encoder.encode(frame), frame.time));
    }
    const auto copy = file("copy.mkv");
    std::filesystem::copy_file(path, copy);
    const auto reader = VideoReader::open(copy);
    QVERIFY2(reader, reader ? "" : reader.error().message().c_str());
    // A cluster is half a second: of three seconds no more than that is missing.
    QVERIFY2((*reader)->info().frameTimes.size() >= 74,
             qPrintable(QString::number((*reader)->info().frameTimes.size())));
}

void TestRecordingWriter::timesNeverStandStill()
{
    const FrameFormat format{320, 176};
    const auto path = file("fast.mkv");
    JpegEncoder encoder;
    auto writer = RecordingWriter::create(path, format, 2000);
    QVERIFY(writer);
    const auto jpeg = encoder.encode(painted(format, 0));
    for (int i = 0; i < 20; ++i)
        QVERIFY((*writer)->write(*jpeg, fromSeconds(i * 0.0004))); // finer than Matroska's milliseconds
    QVERIFY((*writer)->finish());
    const auto reader = VideoReader::open(path);
    QVERIFY(reader);
    QCOMPARE((*reader)->info().frameTimes.size(), std::size_t(20));
}

void TestRecordingWriter::neverOverwrites()
{
    const auto path = file("twice.mkv");
    write(path, {320, 176}, 3, true);
    const auto again = RecordingWriter::create(path, {320, 176}, 30);
    QVERIFY(!again);
    QVERIFY(again.error().message().find("File exists") != std::string::npos);
    QVERIFY(VideoReader::open(path));
}

void TestRecordingWriter::tellsWhatStandsInItsWay()
{
    const auto nowhere = RecordingWriter::create(file("no/such/folder.mkv"), {320, 176}, 30);
    QVERIFY(!nowhere);
    QCOMPARE(nowhere.error().code, ErrorCode::Io);
    QVERIFY(nowhere.error().message().find("check that its folder may be written to") != std::string::npos);
}

ODOGRAPH_TEST(TestRecordingWriter, QCoreApplication)
#include "tst_recording_writer.moc"
