// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/video/jpeg.h"
#include "core/video/video_reader.h"
#include "core/workflow/import/import_trial_job.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/video/coded_frames.h"
#include "tests/video/foreign_files.h"

#include <QGuiApplication>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;
using namespace odo::test;

/// Recordings that are more than one file: chapters, numbered images, a table of times beside a video.
class TestImportManyFiles : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void chaptersAreOneView();
    void whatFailsLeavesNothing();
    void aCancelledJoinLeavesNothing();
    void imagesKeepTheirGaps();
    void jpegsAreKeptBitForBit();
    void sixteenBitsAndGrey();
    void imagesNeedTimes();
    void imagesOfOtherSizesAreRefused();
    void tablesGiveTheTimes();
    void aRowIsOfBothFields();
    void tablesThatDoNotFitAreRefused();
    void oneCameraHasOneVideo();

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder->path().toStdString()) / name;
    }
    std::string write(const std::string &name, int first, int frames, int bFrames = 0)
    {
        VideoWriterOptions options;
        options.maxBFrames = bFrames;
        options.nominalFramesPerSecond = 25;
        const auto writer = VideoWriter::create(OutputTarget(path(name)), smallFormat(), options).value();
        for (int i = 0; i < frames; ++i)
            if (!writer->write(codedFrame(smallFormat(), first + i, std::chrono::milliseconds(40 * i))))
                qWarning("not written");
        return writer->finish() ? path(name).string() : std::string();
    }
    void image(const std::string &name, int number, const FrameFormat &format = smallFormat()) const
    {
        std::filesystem::create_directories(path(name).parent_path());
        QVERIFY(writeImage(codedFrame(format, number, {}), OutputTarget(path(name))));
    }
    std::string table(const std::string &name, int rows, double intervalS) const
    {
        std::ofstream file(path(name));
        file << "frame,t_s\n";
        for (int i = 0; i < rows; ++i)
            file << i << "," << 3 + i * intervalS << "\n";
        return path(name).string();
    }
    /// The warnings, or the error.
    std::vector<std::string> imported(ImportSettings settings, const JobControl &control = {})
    {
        settings.trial = m_imported == 0 ? "run" : "run " + std::to_string(m_imported);
        ImportTrialJob job(std::move(settings));
        const auto done = runToEnd(job, *m_project, control);
        m_imported += done ? 1 : 0;
        std::vector<std::string> told =
            done ? english(job.warnings()) : std::vector<std::string>{done.error().message()};
        for (std::string &one : told)
            one = QString::fromStdString(one).remove(m_folder->path() + u'/').toStdString();
        return told;
    }
    std::vector<std::string> importedFrom(const std::string &video, std::optional<double> rate = {})
    {
        ImportSettings settings;
        settings.videos = {{"A", video}};
        settings.rate = rate;
        return imported(std::move(settings));
    }
    RecordingRecord stored() const
    {
        const std::string last = m_imported == 1 ? "run" : "run " + std::to_string(m_imported - 1);
        return m_project->trials().recordings(m_project->trials().find(last)->id)->front();
    }
    std::vector<int> numbersStored() const
    {
        const auto reader = VideoReader::open(m_project->resolve(stored()));
        std::vector<int> numbers;
        for (auto frame = (*reader)->next(); frame && *frame; frame = (*reader)->next())
            numbers.push_back(numberIn(**frame));
        return numbers;
    }
    bool isMediaEmpty() const { return !std::filesystem::exists(m_project->mediaFolder()); }
    using Told = std::vector<std::string>;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    int m_imported = 0;
};

void TestImportManyFiles::init()
{
    m_project.reset();
    m_imported = 0;
    m_folder = std::make_unique<QTemporaryDir>();
    m_project = std::move(*Project::create(path("class.odo"), "Class"));
}

void TestImportManyFiles::chaptersAreOneView()
{
    write("GX010001.MP4.mp4", 0, 30, 2);
    write("GX020001.MP4.mp4", 30, 20, 2);
    std::filesystem::rename(path("GX010001.MP4.mp4"), path("GX010001.MP4"));
    std::filesystem::rename(path("GX020001.MP4.mp4"), path("GX020001.MP4"));
    QCOMPARE(importedFrom(path("GX010001.MP4+GX020001.MP4").string()), Told());
    const RecordingRecord recording = stored();
    QCOMPARE(recording.frameTimes, evenTimes(50, 25));
    QCOMPARE(recording.framesPerSecond, 25.0);
    std::vector<int> expected;
    for (int i = 0; i < 50; ++i)
        expected.push_back(i);
    QCOMPARE(numbersStored(), expected);
    const auto file = m_project->resolve(recording);
    QCOMPARE(file.filename().string(), std::string("run_A.mov"));
    QCOMPARE(recording.sha256, fileSha256(file, {}).value());
    QCOMPARE(recording.bytes, std::int64_t(std::filesystem::file_size(file)));
    QCOMPARE(m_project->changes()->front().words.english(),
             std::string("import trial run from GX010001.MP4+GX020001.MP4"));
    QCOMPARE(importedFrom(path("GX020001.MP4+GX010001.MP4").string()),
             Told{"videos 'GX020001.MP4+GX010001.MP4': by their names 'GX010001.MP4' comes before "
                  "'GX020001.MP4', and was joined behind it; check the order of the files"});
}

void TestImportManyFiles::whatFailsLeavesNothing()
{
    write("1.mp4", 0, 30);
    FrameFormat wide = smallFormat();
    wide.width *= 2;
    QVERIFY(writeCoded(path("2.mp4"), evenTimes(9, 25), {}, wide).isEmpty());
    QVERIFY(importedFrom(path("1.mp4+2.mp4").string()).front().starts_with("cannot join '2.mp4'"));
    QVERIFY(isMediaEmpty());
    QVERIFY(
        importedFrom(path("1.mp4+3.mp4").string()).front().starts_with("'3.mp4': the file does not exist"));
    QVERIFY(importedFrom(path("1.mp4+1.mp4").string()).front().find("'1.mp4' is given twice") !=
            std::string::npos);
    // a later view fails when the first one is made
    write("3.mp4", 30, 30);
    ImportSettings settings;
    settings.videos = {{"A", path("1.mp4+3.mp4")}, {"B", path("class.odo")}};
    QVERIFY(!imported(settings).empty());
    QVERIFY(isMediaEmpty());
    QVERIFY(!m_project->trials().find("run"));
}

void TestImportManyFiles::aCancelledJoinLeavesNothing()
{
    write("1.mp4", 0, 30);
    write("2.mp4", 30, 30);
    JobControl control;
    bool wasThere = false;
    control.progress = [&](double, const Message &text) {
        if (text.english() != "joining '2.mp4'")
            return;
        wasThere = !isMediaEmpty();
        control.cancel.cancel();
    };
    ImportSettings settings;
    settings.videos = {{"A", path("1.mp4+2.mp4")}};
    settings.trial = "run";
    {
        ImportTrialJob job(settings);
        const auto done = runToEnd(job, *m_project, control);
        QVERIFY(!done && done.error().code == ErrorCode::Cancelled);
    }
    QVERIFY(wasThere && isMediaEmpty());
}

void TestImportManyFiles::imagesKeepTheirGaps()
{
    for (const int number : {1, 2, 3, 6, 7, 10})
        image("p/" + std::to_string(number) + ".png", number);
    QCOMPARE(importedFrom(path("p").string(), 20),
             Told{"images 'p': missing numbers: 4, the first behind 3; their frames count as lost, and the "
                  "others keep their times"});
    const RecordingRecord recording = stored();
    std::vector<std::int64_t> ms;
    for (const Nanoseconds time : recording.frameTimes)
        ms.push_back(time.count() / 1'000'000);
    QCOMPARE(ms, (std::vector<std::int64_t>{0, 50, 100, 250, 300, 450}));
    QCOMPARE(recording.framesPerSecond, 20.0);
    QCOMPARE(numbersStored(), (std::vector<int>{1, 2, 3, 6, 7, 10}));
    // without loss: as the reader of images gives it
    const auto reader = VideoReader::open(m_project->resolve(recording));
    QCOMPARE(fingerprint((*reader)->frameAt(3).value()), fingerprint(readImage(path("p/6.png")).value()));
    QCOMPARE(m_project->changes()->front().words.english(), "import trial run from " + path("p").string());
}

void TestImportManyFiles::jpegsAreKeptBitForBit()
{
    std::string bytes;
    for (int number = 8; number < 12; ++number) {
        image("p/" + std::to_string(number) + ".jpg", number);
        std::ifstream file(path("p/" + std::to_string(number) + ".jpg"), std::ios::binary);
        bytes.assign(std::istreambuf_iterator<char>(file), {});
    }
    QCOMPARE(importedFrom(path("p/%d.jpg").string(), 1500), Told()); // faster than Matroska's milliseconds
    QCOMPARE(numbersStored(), (std::vector<int>{8, 9, 10, 11}));
    QCOMPARE(stored().frameTimes.back(), Nanoseconds(2'000'000));
    std::ifstream file(m_project->resolve(stored()), std::ios::binary);
    const std::string whole(std::istreambuf_iterator<char>(file), {});
    QVERIFY(bytes.size() > 500 && whole.find(bytes) != std::string::npos);
}

void TestImportManyFiles::sixteenBitsAndGrey()
{
    std::filesystem::create_directories(path("p"));
    std::filesystem::create_directories(path("g"));
    for (int i = 1; i < 4; ++i) {
        QImage deep(65, 33, QImage::Format_RGBX64), grey(65, 33, QImage::Format_Grayscale16);
        for (int y = 0; y < 33; ++y)
            for (int x = 0; x < 65; ++x) {
                deep.setPixelColor(x, y, QColor::fromRgba64(quint16(x * 1000), quint16(y * 1900), 257 * 50));
                reinterpret_cast<quint16 *>(grey.scanLine(y))[x] = quint16(257 * (x + i));
            }
        QVERIFY(deep.save(QString::fromStdString(path("p/" + std::to_string(i) + ".png").string())));
        QVERIFY(grey.save(QString::fromStdString(path("g/" + std::to_string(i) + ".png").string())));
    }
    QCOMPARE(importedFrom(path("p").string(), 30), Told());
    auto reader = VideoReader::open(m_project->resolve(stored()));
    QCOMPARE(fingerprint((*reader)->frameAt(1).value()), fingerprint(readImage(path("p/2.png")).value()));
    QCOMPARE(importedFrom(path("g").string(), 30), Told());
    reader = VideoReader::open(m_project->resolve(stored()));
    const Frame second = (*reader)->frameAt(1).value();
    QCOMPARE(int(second.y.at(10, 3)), 12);
    QCOMPARE(int(second.y.at(64, 32)), 66);
}

void TestImportManyFiles::imagesNeedTimes()
{
    image("p/1.png", 1);
    image("p/2.png", 2);
    QCOMPARE(importedFrom(path("p").string()),
             Told{"'p': images have no times; give their rate or a table of their times, like --rate 30 or "
                  "--times A=stamps.csv"});
    ImportSettings settings;
    settings.videos = {{"A", path("p")}};
    settings.times = {{"A", table("t.csv", 3, 0.1)}};
    QCOMPARE(imported(settings), Told{"file 't.csv': it has 3 times, but the video of view 'A' has 2 frames; "
                                      "give one time for each frame"});
    QVERIFY(isMediaEmpty());
    settings.times = {{"A", table("t2.csv", 2, 0.1)}};
    QCOMPARE(imported(settings), Told());
    QCOMPARE(stored().frameTimes, (std::vector<Nanoseconds>{Nanoseconds(0), Nanoseconds(100'000'000)}));
    // numbers that count no frames are no matter where there is a table
    std::filesystem::rename(path("p/2.png"), path("p/2000000.png"));
    QCOMPARE(imported(settings), Told());
}

void TestImportManyFiles::imagesOfOtherSizesAreRefused()
{
    FrameFormat wide = smallFormat();
    wide.width *= 2;
    for (const char *ending : {".png", ".jpg"}) {
        const std::string folder = ending + 1;
        image(folder + "/1" + ending, 1);
        image(folder + "/2" + ending, 2);
        image(folder + "/3" + ending, 3, wide);
        QCOMPARE(importedFrom(path(folder).string(), 30),
                 Told{"cannot take '3" + std::string(ending) +
                      "' as a frame of a video: its size is 384×96, "
                      "that of the first, '1" +
                      ending + "', is 192×96; leave it out, or convert all of them in the same way"});
        QVERIFY(isMediaEmpty());
    }
}

void TestImportManyFiles::tablesGiveTheTimes()
{
    ImportSettings settings;
    settings.videos = {{"A", write("a.mp4", 0, 30)}};
    settings.times = {{"A", table("t.csv", 30, 0.01)}}; // four times as fast as the file says
    QCOMPARE(imported(settings), Told());
    const RecordingRecord recording = stored();
    QCOMPARE(recording.frameTimes.size(), std::size_t(30));
    QCOMPARE(recording.frameTimes.front(), Nanoseconds(0));
    for (std::size_t i = 0; i < 30; ++i)
        QVERIFY(std::abs(recording.frameTimes[i].count() - std::int64_t(i) * 10'000'000) <= 1);
    QVERIFY(std::abs(recording.framesPerSecond - 100) < 1e-5);
    std::ofstream(path("us.csv")) << [] {
        std::string text;
        for (int i = 0; i < 30; ++i)
            text += std::to_string(20'000 * i) + "\n";
        return text;
    }();
    settings.times = {{"A", path("us.csv")}};
    settings.timeUnit = TimeUnit::Microsecond;
    QCOMPARE(imported(settings), Told());
    QCOMPARE(stored().frameTimes.back(), Nanoseconds(29 * 20'000'000LL));
}

void TestImportManyFiles::aRowIsOfBothFields()
{
    QVERIFY(writeRaw(path("fields.mkv"), "ffv1", "yuv420p", 30, 1, 320, 25, true));
    ImportSettings settings;
    settings.videos = {{"A", path("fields.mkv")}};
    settings.times = {{"A", table("t.csv", 30, 0.02)}};
    QVERIFY(imported(settings).front().find("it is interlaced") != std::string::npos);
    const std::vector<Nanoseconds> times = stored().frameTimes;
    QCOMPARE(times.size(), std::size_t(60));
    for (std::size_t i = 0; i < times.size(); ++i)
        QVERIFY(std::abs(times[i].count() - 10'000'000LL * std::int64_t(i)) <= 2);
}

void TestImportManyFiles::tablesThatDoNotFitAreRefused()
{
    ImportSettings settings;
    settings.videos = {{"A", write("a.mp4", 0, 30)}};
    settings.times = {{"A", table("t.csv", 29, 0.04)}};
    QCOMPARE(imported(settings), Told{"file 't.csv': it has 29 times, but the video of view 'A' has 30 "
                                      "frames; give one time for each frame"});
    settings.times = {{"B", path("t.csv")}};
    QCOMPARE(imported(settings), Told{"import of trial 'run': there are frame times for camera 'B', but no "
                                      "video of it; name the camera of one of the videos"});
    settings.times = {{"A", path("t.csv")}, {"A", path("t.csv")}};
    QCOMPARE(imported(settings), Told{"import of trial 'run': camera 'A' was given two tables of frame "
                                      "times; give one table for each view"});
    settings.times = {{"A", path("t.csv")}};
    settings.rate = 30;
    QCOMPARE(imported(settings), Told{"import of trial 'run': camera 'A' was given both a frame rate and "
                                      "frame times; give one of them"});
    settings.rate = {};
    settings.times = {{"A", path("none.csv")}};
    QCOMPARE(imported(settings).front(),
             std::string("file 'none.csv': the file does not exist; check the name and the folder"));
}

void TestImportManyFiles::oneCameraHasOneVideo()
{
    ImportSettings settings;
    settings.videos = {{"A", write("1.mp4", 0, 9)}, {"A", write("2.mp4", 9, 9)}};
    QCOMPARE(imported(settings),
             Told{"import of trial 'run': camera 'A' was given two videos; give each view a camera of its "
                  "own, or join the files of one recording with +, like --video A=1.mp4+2.mp4"});
}

ODOGRAPH_TEST(TestImportManyFiles, QGuiApplication)
#include "tst_import_many_files.moc"
