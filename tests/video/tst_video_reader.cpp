// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QDir>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <fstream>
#include <random>
#include <sys/inotify.h>
#include <unistd.h>

using namespace odo;
using namespace odo::test;

class TestVideoReader : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void seekingEqualsReading_data();
    void seekingEqualsReading();
    void seekingOutside();
    void rateOfRoundedAndDroppedTimes();
    void framesOutliveTheirReader();
    void truncated_data();
    void truncated();
    void damagedInTheMiddle();
    void whatIsPredictedFromDamageIsDamaged();
    void damagedMotionJpeg();
    void partsOfMotionJpeg();
    void refusals_data();
    void refusals();
    void playlistsOpenNothing_data();
    void playlistsOpenNothing();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    void store(const std::string &name, const std::string &content) const
    {
        std::ofstream(path(name), std::ios::binary) << content;
    }
    std::string load(const std::string &name) const
    {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    QTemporaryDir m_folder;
};

void TestVideoReader::seekingEqualsReading_data()
{
    QTest::addColumn<int>("codec");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("bFrames");
    QTest::newRow("h264 B frames") << int(VideoCodec::H264) << QStringLiteral("seek.mp4") << 3;
    QTest::newRow("h264 mkv") << int(VideoCodec::H264) << QStringLiteral("seek.mkv") << 0;
    QTest::newRow("mjpeg") << int(VideoCodec::Mjpeg) << QStringLiteral("seekj.mkv") << 0;
    QTest::newRow("ffv1") << int(VideoCodec::Ffv1) << QStringLiteral("seekf.mkv") << 0;
}

void TestVideoReader::seekingEqualsReading()
{
    QFETCH(int, codec);
    QFETCH(QString, name);
    QFETCH(int, bFrames);
    constexpr int count = 600; // x264 puts a key frame every 250 frames: three groups of pictures
    VideoWriterOptions options;
    options.codec = static_cast<VideoCodec>(codec);
    options.maxBFrames = bFrames;
    options.bitRate = 500'000;
    const auto file = path(name.toStdString());
    QCOMPARE(writeCoded(file, unevenTimes(count), options), QString());
    const auto reader = VideoReader::open(file);
    QVERIFY(reader.has_value());
    std::vector<std::uint64_t> sequential;
    while (const auto frame = (*reader)->next().value())
        sequential.push_back(fingerprint(*frame));
    QCOMPARE(sequential.size(), std::size_t(count));

    std::mt19937 random(7);
    std::vector<std::int64_t> order = {0, 599, 0, 250, 249, 251, 500, 499, 501, 1, 2, 3, 2, 1, 598};
    for (int i = 0; i < 60; ++i)
        order.push_back(static_cast<std::int64_t>(random() % count));
    for (const std::int64_t index : order) {
        const auto frame = (*reader)->frameAt(index);
        QVERIFY2(frame.has_value(), frame ? "" : frame.error().message().c_str());
        QCOMPARE(frame->index, index);
        QCOMPARE(numberIn(*frame), int(index));
        QCOMPARE(fingerprint(*frame), sequential[static_cast<std::size_t>(index)]);
    }
    const bool allKeys = options.codec != VideoCodec::H264;
    QCOMPARE((*reader)->keyFrameBefore(0), 0);
    QCOMPARE((*reader)->keyFrameBefore(499), allKeys ? 499 : 250);
    QCOMPARE((*reader)->keyFrameBefore(count), 0); // there is no such frame
    QVERIFY((*reader)->seek(300).has_value());     // reading goes on after a seek
    for (int i = 300; i < 310; ++i)
        QCOMPARE(numberIn((*reader)->next().value().value()), i);
}

void TestVideoReader::seekingOutside()
{
    QCOMPARE(writeCoded(path("outside.mkv"), evenTimes(5, 30), {}), QString());
    const auto reader = VideoReader::open(path("outside.mkv"));
    QVERIFY(reader.has_value());
    for (const std::int64_t index : {-1, 5}) {
        const auto frame = (*reader)->frameAt(index);
        QVERIFY(!frame.has_value());
        QVERIFY(frame.error().message().find("frames 0 to 4") != std::string::npos);
    }
    QCOMPARE(numberIn((*reader)->frameAt(4).value()), 4);
}

void TestVideoReader::rateOfRoundedAndDroppedTimes()
{
    std::vector<Nanoseconds> times;
    for (int i = 0; i < 60; ++i) // 33, 34, 33 ms, ..., as most Matroska files have them
        times.push_back(std::chrono::milliseconds(std::lround(i * 1000.0 / 30.0)));
    QCOMPARE(writeCoded(path("rounded.mkv"), times, {}), QString());
    const auto rounded = VideoReader::open(path("rounded.mkv"));
    QVERIFY(std::abs((*rounded)->info().framesPerSecond - 30.0) < 0.02);
    QVERIFY(!(*rounded)->info().variableRate);
    times.erase(times.begin() + 20);
    QCOMPARE(writeCoded(path("dropped.mkv"), times, {}), QString());
    const auto dropped = VideoReader::open(path("dropped.mkv"));
    QVERIFY(std::abs((*dropped)->info().framesPerSecond - 30.0) < 0.02);
    QVERIFY((*dropped)->info().variableRate);
}

void TestVideoReader::framesOutliveTheirReader()
{
    QCOMPARE(writeCoded(path("outlive.mkv"), evenTimes(12, 30), {}), QString());
    std::vector<Frame> kept;
    {
        const auto reader = VideoReader::open(path("outlive.mkv"));
        while (auto frame = (*reader)->next().value())
            kept.push_back(*frame);
    }
    for (int i = 0; i < 12; ++i)
        QCOMPARE(numberIn(kept[static_cast<std::size_t>(i)]), i);
}

void TestVideoReader::truncated_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("codec");
    QTest::newRow("mkv h264") << QStringLiteral("whole.mkv") << int(VideoCodec::H264);
    QTest::newRow("mp4 h264") << QStringLiteral("whole.mp4") << int(VideoCodec::H264);
    QTest::newRow("mkv mjpeg") << QStringLiteral("wholej.mkv") << int(VideoCodec::Mjpeg);
    QTest::newRow("mkv ffv1") << QStringLiteral("wholef.mkv") << int(VideoCodec::Ffv1);
}

void TestVideoReader::truncated()
{
    QFETCH(QString, name);
    QFETCH(int, codec);
    VideoWriterOptions options;
    options.codec = static_cast<VideoCodec>(codec);
    options.bitRate = 1'000'000;
    constexpr int count = 150; // of fewer the first picture is too large a part
    QCOMPARE(writeCoded(path(name.toStdString()), evenTimes(count, 30), options), QString());
    const std::string whole = load(name.toStdString());
    const std::string cutName = "cut_" + name.toStdString();
    int readable = 0, framesBefore = 0;
    for (int part = 0; part < 100; ++part) {
        store(cutName, whole.substr(0, whole.size() * static_cast<std::size_t>(part) / 100));
        const auto reader = VideoReader::open(path(cutName));
        if (!reader) {
            QVERIFY(part < 15); // only where not even the header and one frame are there
            continue;
        }
        ++readable;
        const VideoInfo &info = (*reader)->info();
        const auto frames = static_cast<int>(info.frameTimes.size());
        QVERIFY(frames <= count);
        if (frames < count * 9 / 10)
            QVERIFY2(info.warning.english().find("ends early at ") != std::string::npos,
                     qPrintable(QString::number(part)));
        int good = 0;
        for (int i = 0; i < frames; ++i)
            if (const auto frame = (*reader)->next()) {
                QCOMPARE(numberIn(**frame), i);
                ++good;
            }
        QVERIFY(good >= frames - 1); // the packet that was cut may be lost, none else
        QVERIFY(frames >= framesBefore);
        framesBefore = frames;
    }
    QVERIFY(framesBefore >= count * 9 / 10);
    QVERIFY(readable >= 85);
}

void TestVideoReader::damagedInTheMiddle()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::Ffv1;
    QCOMPARE(writeCoded(path("damaged.mkv"), evenTimes(30, 30), options), QString());
    std::string bytes = load("damaged.mkv");
    for (std::size_t i = 0; i < 64; ++i)
        bytes[bytes.size() / 2 + i] ^= 0x5a;
    store("damaged.mkv", bytes);
    const auto reader = VideoReader::open(path("damaged.mkv"));
    QVERIFY(reader.has_value());
    int good = 0, damaged = 0;
    for (std::size_t i = 0; i < (*reader)->info().frameTimes.size(); ++i) {
        const auto frame = (*reader)->next();
        if (frame) {
            QCOMPARE(numberIn(**frame), int((*frame)->index));
            ++good;
        } else {
            QVERIFY(frame.error().message().find("its data are damaged") != std::string::npos);
            ++damaged;
        }
    }
    QVERIFY(good >= 27);
    QVERIFY(good + damaged >= 29);
    QVERIFY(good < 30);
}

/// The decoder conceals what it lacks, and says nothing of it in the frames that it predicts from there.
void TestVideoReader::whatIsPredictedFromDamageIsDamaged()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::H264;
    QCOMPARE(writeCoded(path("predicted.mkv"), evenTimes(60, 30), options), QString());
    std::string bytes = load("predicted.mkv");
    bytes.replace(bytes.size() / 2, 40, 40, '\x5a');
    store("predicted.mkv", bytes);
    const auto reader = VideoReader::open(path("predicted.mkv"));
    QVERIFY(reader.has_value());
    std::int64_t firstDamaged = -1, good = 0;
    for (std::int64_t i = 0; i < std::ssize((*reader)->info().frameTimes); ++i) {
        const auto frame = (*reader)->next();
        if (!frame && firstDamaged < 0)
            firstDamaged = i;
        if (frame && firstDamaged >= 0)
            QVERIFY2((*reader)->keyFrameBefore(i) > firstDamaged, qPrintable(QString::number(i)));
        good += frame.has_value();
    }
    QVERIFY(firstDamaged > 0);
    QVERIFY(good >= firstDamaged);
}

void TestVideoReader::damagedMotionJpeg()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::Mjpeg;
    QCOMPARE(writeCoded(path("damaged_jpeg.mkv"), evenTimes(30, 30), options), QString());
    std::string bytes = load("damaged_jpeg.mkv");
    for (std::size_t i = 0; i < 64; ++i)
        bytes[bytes.size() / 2 + i] ^= 0x5a;
    store("damaged_jpeg.mkv", bytes);
    const auto reader = VideoReader::open(path("damaged_jpeg.mkv"));
    QVERIFY(reader.has_value());
    int good = 0;
    for (int i = 0; i < 30; ++i) {
        const auto frame = (*reader)->next();
        if (frame) {
            QCOMPARE(numberIn(**frame), i);
            ++good;
        } else {
            QVERIFY(frame.error().message().find("its data are damaged") != std::string::npos);
        }
    }
    QCOMPARE(good, 29);
}

void TestVideoReader::partsOfMotionJpeg()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::Mjpeg;
    const auto times = unevenTimes(40);
    QCOMPARE(writeCoded(path("parts.mkv"), times, options), QString());
    auto reader = VideoReader::open(path("parts.mkv"));
    const auto other = VideoReader::open(path("parts.mkv"));
    QVERIFY(reader.has_value() && other.has_value());
    QVERIFY((*reader)->decodesRegions());
    Frame kept;
    for (int i = 0; i < 40; ++i) {
        const auto part = (*reader)->next(PixelRect{16, 20, 50, 40});
        const Frame whole = (*other)->next().value().value();
        QVERIFY(part.has_value() && part->has_value());
        QVERIFY(!whole.validRegion);
        QVERIFY((*part)->validRegion && (*part)->validRegion->contains({16, 20, 50, 40}));
        QCOMPARE((*part)->index, std::int64_t(i));
        QCOMPARE((*part)->time, times[static_cast<std::size_t>(i)]);
        for (int y = 20; y < 40; ++y)
            QVERIFY(std::equal((*part)->y.row(y) + 16, (*part)->y.row(y) + 50, whole.y.row(y) + 16));
        const auto completed = wholeFrame(**part);
        QVERIFY(completed.has_value() && !completed->validRegion);
        QCOMPARE(completed->index, std::int64_t(i));
        QCOMPARE(completed->time, times[static_cast<std::size_t>(i)]);
        QCOMPARE(fingerprint(*completed), fingerprint(whole));
        if (i == 7)
            kept = **part;
    }
    reader->reset(); // a frame needs its reader for nothing
    QCOMPARE(fingerprint(wholeFrame(kept).value()), fingerprint((*other)->frameAt(7).value()));
    QVERIFY(!wholeFrame(wholeFrame(kept).value()).value().validRegion);
}

void TestVideoReader::refusals_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("words");
    QTest::newRow("missing") << QStringLiteral("missing.mp4") << QStringLiteral("the file does not exist");
    QTest::newRow("folder") << QStringLiteral("folder") << QStringLiteral("it is a folder");
    QTest::newRow("empty") << QStringLiteral("empty.mp4") << QStringLiteral("the file is empty");
    QTest::newRow("text") << QStringLiteral("text.mp4")
                          << QStringLiteral("it is not a supported kind of video");
    QTest::newRow("noise") << QStringLiteral("noise.mkv") << QStringLiteral("");
    QTest::newRow("device") << QStringLiteral("/dev/null") << QStringLiteral("it is a device");
    QTest::newRow("address") << QStringLiteral("http://127.0.0.1/a.mkv")
                             << QStringLiteral("the file does not exist");
}

void TestVideoReader::refusals()
{
    QFETCH(QString, name);
    QFETCH(QString, words);
    std::filesystem::create_directory(path("folder"));
    store("empty.mp4", "");
    store("text.mp4", "This is a letter and no video at all.\n");
    std::string noise(100'000, '\0');
    std::mt19937 random(3);
    for (char &byte : noise)
        byte = static_cast<char>(random());
    store("noise.mkv", noise);
    const auto reader =
        VideoReader::open(name.startsWith(QLatin1String("/")) || name.contains(QLatin1String(":"))
                              ? std::filesystem::path(name.toStdString())
                              : path(name.toStdString()));
    QVERIFY(!reader.has_value());
    QVERIFY2(reader.error().message().find(words.toStdString()) != std::string::npos,
             reader.error().message().c_str());
    QVERIFY(!reader.error().advice.english().empty());
}

void TestVideoReader::playlistsOpenNothing_data()
{
    QTest::addColumn<QString>("content");
    QTest::newRow("HLS") << QStringLiteral("#EXTM3U\n#EXT-X-VERSION:3\n#EXT-X-TARGETDURATION:2\n"
                                           "#EXT-X-MEDIA-SEQUENCE:0\n#EXTINF:2.0,\n%1\n#EXT-X-ENDLIST\n");
    QTest::newRow("concat") << QStringLiteral("ffconcat version 1.0\nfile '%1'\n");
    QTest::newRow("SDP") << QStringLiteral(
        "v=0\r\no=- 0 0 IN IP4 127.0.0.1\r\ns=x\r\nc=IN IP4 127.0.0.1\r\nt=0 0\r\n"
        "m=video 5004 RTP/AVP 96\r\na=rtpmap:96 H264/90000\r\na=x:%1\r\n");
    QTest::newRow("DASH") << QStringLiteral(
        "<?xml version=\"1.0\"?>\n<MPD xmlns=\"urn:mpeg:dash:schema:mpd:2011\" "
        "type=\"static\"><Period><AdaptationSet><Representation id=\"1\">"
        "<BaseURL>%1</BaseURL></Representation></AdaptationSet></Period></MPD>\n");
}

namespace {

/// Counts how often a file is opened by anyone, as the kernel sees it.
class OpenCounter
{
public:
    explicit OpenCounter(const std::filesystem::path &file)
        : m_events(inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
    {
        inotify_add_watch(m_events, file.c_str(), IN_OPEN);
    }
    ~OpenCounter() { close(m_events); }
    bool wasOpened()
    {
        char event[4096];
        return read(m_events, event, sizeof event) > 0;
    }

private:
    int m_events;
};

} // namespace

void TestVideoReader::playlistsOpenNothing()
{
    QFETCH(QString, content);
    const auto other = path("other.mkv");
    QCOMPARE(writeCoded(other, evenTimes(5, 30), {}), QString());
    OpenCounter counter(other);
    const QString folderBefore = QDir::currentPath(); // relative names would lead to the other file from here
    QVERIFY(QDir::setCurrent(m_folder.path()));
    const auto back = qScopeGuard([&] { QDir::setCurrent(folderBefore); });
    QVERIFY(VideoReader::open(other).has_value());
    QVERIFY(counter.wasOpened());
    for (const char *ending : {".mkv", ".mp4", ".m3u8", ".txt", ".mpd"}) {
        const std::string name = std::string("playlist") + ending;
        for (const std::string &target : {other.string(), std::string("other.mkv")}) {
            store(name, content.arg(QString::fromStdString(target)).toStdString());
            const auto reader = VideoReader::open(path(name));
            QVERIFY(!reader.has_value());
            QCOMPARE(reader.error().code, ErrorCode::InvalidInput);
            QVERIFY(!counter.wasOpened());
        }
    }
}

ODOGRAPH_TEST(TestVideoReader, QCoreApplication)
#include "tst_video_reader.moc"
