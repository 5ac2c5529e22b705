// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/video/chapter_join.h"
#include "core/video/video_input.h"
#include "core/video/video_reader.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/video/coded_frames.h"
#include "tests/video/foreign_files.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int framesEach = 30;
constexpr double chapterRate = 25;

struct ReadVideo
{
    std::vector<std::uint64_t> frames;
    std::vector<Nanoseconds> times;
    VideoInfo info;
};

ReadVideo readWhole(const std::filesystem::path &file)
{
    ReadVideo video;
    const auto reader = VideoReader::open(file);
    if (!reader) {
        qWarning("%s", reader.error().message().c_str());
        return video;
    }
    video.info = (*reader)->info();
    video.times = video.info.frameTimes;
    for (auto frame = (*reader)->next(); frame && *frame; frame = (*reader)->next())
        video.frames.push_back(fingerprint(**frame));
    return video;
}

} // namespace

/// Files into which a camera has split one recording, as one.
class TestChapterJoin : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void joinsBitForBit_data();
    void joinsBitForBit();
    void keepsTurnAndSound();
    void refusesOtherFormats();
    void refusesACutChapterButTheLast();
    void tellsOfRecordingTimes();
    void endsWhenCancelled();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    /// Two chapters of what `options` code, remuxed to files of this ending.
    std::vector<std::filesystem::path> chapters(const std::string &name, const std::string &ending,
                                                const VideoWriterOptions &options, bool withSound = false)
    {
        std::vector<std::filesystem::path> files;
        for (int part = 0; part < 2; ++part) {
            const std::string stem = name + std::to_string(part);
            VideoWriterOptions own = options;
            if (part == 1)
                own.maxBFrames = 0; // another set-up of the same coder
            const std::string coded = stem + (own.codec == VideoCodec::H264 ? "_coded.mp4" : "_coded.mkv");
            if (const QString problem =
                    writeCoded(path(coded), evenTimes(framesEach + part, chapterRate), own);
                !problem.isEmpty())
                qWarning("%s", qPrintable(problem));
            files.push_back(path(stem + ending));
            if (!remux(path(coded), files.back(), {}, {}, withSound))
                qWarning("no %s", files.back().c_str());
        }
        return files;
    }
    Result<std::vector<Message>> join(const std::vector<std::filesystem::path> &files, const std::string &to,
                                      const JobControl &control = {})
    {
        return joinChapters(files, path(to), control);
    }

    QTemporaryDir m_folder;
};

void TestChapterJoin::joinsBitForBit_data()
{
    QTest::addColumn<int>("codec");
    QTest::addColumn<int>("bFrames");
    QTest::addColumn<QString>("ending");
    QTest::addColumn<QString>("joinedEnding");
    QTest::newRow("MP4") << int(VideoCodec::H264) << 0 << ".mp4"
                         << ".mov";
    QTest::newRow("MP4, B frames first") << int(VideoCodec::H264) << 3 << ".mp4"
                                         << ".mov";
    QTest::newRow("transport stream") << int(VideoCodec::H264) << 3 << ".ts"
                                      << ".mov";
    QTest::newRow("AVI of JPEG") << int(VideoCodec::Mjpeg) << 0 << ".avi"
                                 << ".mov";
    QTest::newRow("Matroska") << int(VideoCodec::Ffv1) << 0 << ".mkv"
                              << ".mkv";
}

/// All frames of both, each at its own time, and the joint as long as the usual interval.
void TestChapterJoin::joinsBitForBit()
{
    QFETCH(int, codec);
    QFETCH(int, bFrames);
    QFETCH(QString, ending);
    QFETCH(QString, joinedEnding);
    VideoWriterOptions options;
    options.codec = VideoCodec(codec);
    options.maxBFrames = bFrames;
    options.nominalFramesPerSecond = chapterRate;
    const std::string tag = QTest::currentDataTag();
    const auto files = chapters(tag, ending.toStdString(), options);
    QCOMPARE(endingOfJoined(files.front()).value_or(""), joinedEnding.toStdString());
    const auto joined = join(files, tag + "_joined");
    QVERIFY2(joined, joined ? "" : joined.error().message().c_str());
    QVERIFY(joined->empty());

    ReadVideo expected = readWhole(files[0]);
    const ReadVideo second = readWhole(files[1]);
    QCOMPARE(expected.frames.size(), std::size_t(framesEach));
    QCOMPARE(second.frames.size(), std::size_t(framesEach + 1));
    expected.frames.insert(expected.frames.end(), second.frames.begin(), second.frames.end());
    const ReadVideo whole = readWhole(path(tag + "_joined"));
    QCOMPARE(whole.frames, expected.frames);
    QVERIFY(whole.info.warning.isEmpty());
    const std::vector<Nanoseconds> even = evenTimes(2 * framesEach + 1, chapterRate);
    QCOMPARE(whole.times.size(), even.size());
    for (std::size_t i = 0; i < even.size(); ++i) // 40 ms are whole ticks of all these containers
        QVERIFY2(std::abs((whole.times[i] - even[i]).count()) <= 1, std::to_string(i).c_str());

    // any frame can be reached, also back over the joint
    const auto reader = VideoReader::open(path(tag + "_joined"));
    for (const int index : {framesEach + 5, framesEach - 5, framesEach, framesEach - 1}) {
        const auto frame = (*reader)->frameAt(index);
        QVERIFY(frame && fingerprint(*frame) == expected.frames[std::size_t(index)]);
    }
}

void TestChapterJoin::keepsTurnAndSound()
{
    const auto files = chapters("loud", ".mov", {}, true);
    const auto joined = join(files, "loud");
    QVERIFY2(joined, joined ? "" : joined.error().message().c_str());
    QVERIFY(joined->empty());
    const auto input = VideoInput::open(path("loud"));
    QCOMPARE(int((*input)->container().nb_streams), 2);
    const AVStream &sound = *(*input)->container().streams[1];
    // the sound of each chapter at its own time, however long that of the one before is
    const auto lastSound = VideoInput::open(files[1]);
    const AVStream &second = *(*lastSound)->container().streams[1];
    const double expectedS = framesEach / chapterRate + double(second.duration) * av_q2d(second.time_base),
                 soundS = double(sound.duration) * av_q2d(sound.time_base);
    QVERIFY2(std::abs(soundS - expectedS) < 0.001, std::to_string(soundS - expectedS).c_str());
    const auto twice = join({path("loud"), files[0]}, "loud3"); // whose sound goes on
    QVERIFY(twice && twice->empty());
    QCOMPARE(readWhole(path("loud3")).times.size(), std::size_t(3 * framesEach + 1));

    const auto silent = chapters("silent", ".mov", {});
    const auto half = join({files[0], silent[1]}, "half");
    QVERIFY(half);
    QCOMPARE(english(*half), std::vector<std::string>{
                                 "video 'loud0.mov': the sound was left out, because the files it is joined "
                                 "with have none or another kind of it"});

    for (const auto &file : silent)
        QVERIFY(remux(file, path("turned_" + file.filename().string()), {0, 1, -1, 0}));
    QVERIFY(join({path("turned_silent0.mov"), path("turned_silent1.mov")}, "turned"));
    const auto orientationOf = [&](const char *name) {
        const auto reader = VideoReader::open(path(name));
        return reader ? (*reader)->info().orientation : 0;
    };
    QCOMPARE(orientationOf("turned"), orientationOf("turned_silent0.mov"));
    QVERIFY(orientationOf("turned") > 1);
    const auto mixed = join({silent[0], path("turned_silent1.mov")}, "mixed");
    QVERIFY(!mixed);
    QCOMPARE(mixed.error().message(),
             std::string("cannot join 'turned_silent1.mov' to a recording: its frames are to be turned by "
                         "90°, those of 'silent0.mov' by 0°; join only the files into which a camera has "
                         "split one recording"));
}

void TestChapterJoin::refusesOtherFormats()
{
    const auto first = chapters("first", ".mp4", {}).front();
    FrameFormat wide = smallFormat();
    wide.width *= 2;
    QVERIFY(writeCoded(path("wide.mp4"), evenTimes(9, chapterRate), {}, wide).isEmpty());
    QCOMPARE(join({first, path("wide.mp4")}, "x1").error().message(),
             std::string("cannot join 'wide.mp4' to a recording: its frames are 384×96, those of "
                         "'first0.mp4' are 192×96; join only the files into which a camera has split one "
                         "recording"));
    VideoWriterOptions jpeg;
    jpeg.codec = VideoCodec::Mjpeg;
    QVERIFY(writeCoded(path("jpeg.mp4"), evenTimes(9, chapterRate), jpeg).isEmpty());
    QVERIFY(join({first, path("jpeg.mp4")}, "x2")
                .error()
                .message()
                .starts_with("cannot join 'jpeg.mp4' to a recording: its codec is mjpeg, that of "
                             "'first0.mp4' is h264; "));
    FrameFormat full = smallFormat();
    full.chromaShiftY = 0;
    QVERIFY(writeCoded(path("chroma.mp4"), evenTimes(9, chapterRate), {}, full).isEmpty());
    QVERIFY(join({first, path("chroma.mp4")}, "x3").error().message().find("its pixel format is yuv") !=
            std::string::npos);
    QVERIFY(writeRaw(path("bare.mjpeg"), "mjpeg", "yuvj420p", 30, 1, 320));
    QVERIFY(join({path("bare.mjpeg"), path("bare.mjpeg")}, "x4")
                .error()
                .message()
                .starts_with("cannot join 'bare.mjpeg' to a recording: its frames have no time stamps of "
                             "their own; put each file into MP4 first"));
    QVERIFY(!join({first, path("not there.mp4")}, "x5"));
    QVERIFY(join({first, first}, "taken"));
    QVERIFY(!join({first, first}, "taken")); // over what is there
}

/// What follows a chapter that lost its end would get wrong times.
void TestChapterJoin::refusesACutChapterButTheLast()
{
    VideoWriterOptions options;
    options.codec = VideoCodec::Ffv1;
    const auto files = chapters("cut", ".mkv", options);
    std::filesystem::resize_file(files[1], std::filesystem::file_size(files[1]) / 2);
    const auto last = join(files, "cut_last");
    QVERIFY(last && last->size() == 1);
    QVERIFY(last->front().english().starts_with("video 'cut1.mkv': ends early at "));
    const auto first = join({files[1], files[0]}, "cut_first");
    QVERIFY(!first);
    QVERIFY(first.error().message().starts_with("cannot join 'cut1.mkv' to a recording: ends early at "));
    QVERIFY(first.error().message().ends_with(
        "copy it from the camera again: what follows it would get wrong times"));
}

void TestChapterJoin::tellsOfRecordingTimes()
{
    const auto files = chapters("timed", ".mp4", {});
    const auto at = [&](int part, const char *time) {
        const auto file = path("at" + std::string(time).substr(17, 2) + std::to_string(part) + ".mp4");
        return remux(files[std::size_t(part)], file, {}, time) ? file : std::filesystem::path();
    };
    const auto ten = at(0, "2024-05-06T10:11:10Z"), eleven = at(1, "2024-05-06T10:11:11Z"),
               one = at(1, "2024-05-06T10:11:01Z"), forty = at(1, "2024-05-06T10:11:40Z");
    const auto span = recordedSpan(ten);
    QVERIFY(span && std::abs(toSeconds(span->duration) - framesEach / chapterRate) < 0.05);
    QCOMPARE(span->at, Nanoseconds(1714990270LL * 1'000'000'000));
    QVERIFY(!recordedSpan(files[0]));
    QVERIFY(join({ten, eleven}, "in order").value().empty());
    QCOMPARE(
        english(join({ten, one}, "out of order").value()),
        std::vector<std::string>{
            "video 'at011.mp4': by its recording time it was started before 'at100.mp4', behind which it "
            "was joined; check the order of the files"});
    QCOMPARE(english(join({ten, forty}, "gap").value()),
             std::vector<std::string>{"video 'at401.mp4': by its recording time 29 s are missing between "
                                      "'at100.mp4' and it; if so, all times behind that are wrong"});
}

void TestChapterJoin::endsWhenCancelled()
{
    const auto files = chapters("long", ".mp4", {});
    JobControl control;
    int reports = 0;
    double last = 0;
    control.progress = [&](double fraction, const Message &) {
        last = fraction;
        if (++reports == 5)
            control.cancel.cancel();
    };
    const auto ended = join(files, "cancelled", control);
    QVERIFY(!ended && ended.error().code == ErrorCode::Cancelled);
    QVERIFY(last > 0 && last < 1);
}

ODOGRAPH_TEST(TestChapterJoin, QCoreApplication)
#include "tst_chapter_join.moc"
