// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/import/import_trial_job.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"
#include "tests/video/coded_frames.h"
#include "tests/video/foreign_files.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <fstream>

using namespace odo;
using namespace odo::test;

/// What the user is told of a video that is imported. (How views get in step: tst_import_in_step.)
class TestImportTrial : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_project = std::move(*Project::create(path("class.odo"), "Class")); }

    /// As telephones record, where each picture has a time of its own.
    void anUnevenRateIsTold()
    {
        std::vector<Nanoseconds> times;
        for (int i = 0; i < 60; ++i)
            times.push_back(std::chrono::milliseconds(40 * i + (i % 5 == 4 ? 25 : 0)));
        const auto warnings = imported("uneven", times);
        QCOMPARE(warnings, std::vector<std::string>{"video 'uneven.mkv': its frame rate varies: frames are "
                                                    "15 to 65 ms apart; each frame keeps its own time"});
        const auto stored =
            m_project->trials().recordings(m_project->trials().find("uneven")->id)->front().frameTimes;
        QCOMPARE(stored, times);
    }

    void evenAndMissingPicturesAreNoUnevenRate()
    {
        QVERIFY(imported("even", evenTimes(60, 30)).empty());
        std::vector<Nanoseconds> rounded; // as most files have them
        for (int i = 0; i < 60; ++i)
            rounded.push_back(std::chrono::milliseconds(std::lround(i * 1000 / 30.0)));
        QVERIFY(imported("rounded", rounded).empty());
        rounded.erase(rounded.begin() + 20, rounded.begin() + 23);
        rounded.erase(rounded.begin() + 30);
        QVERIFY(imported("missing", rounded).empty());
        QVERIFY(imported("one picture", {Nanoseconds(0)}).empty());
    }

    /// As Android's recorder writes it: played at 30 frames a second, filmed at another rate.
    void slowMotionIsMeasuredAsItWasFilmed()
    {
        const auto importedAs = [this](const char *trial, const char *filmed,
                                       std::optional<double> rate = {}) {
            RawVideo video{"libx264", "yuv420p", 31, 64, 48, 30};
            video.fill = [](AVFrame &, int) {};
            video.muxing = {{"movflags", "use_metadata_tags"}};
            video.metadata = {{"com.android.capture.fps", filmed}};
            return writeRaw(path(std::string(trial) + ".mp4"), video)
                       ? importFile(trial, ".mp4", rate)
                       : std::vector<std::string>{"not written"};
        };
        const auto lastTime = [this](const char *trial) {
            const auto stored = m_project->trials().recordings(m_project->trials().find(trial)->id);
            return std::lround(toSeconds(stored->front().frameTimes.back()) * 1e6);
        };
        QCOMPARE(importedAs("slow", "240.000000"),
                 std::vector<std::string>{"video 'slow.mp4': it was filmed at 240.0, as its file says, and "
                                          "plays at 30.0 frames/s; its times are those of filming"});
        QCOMPARE(lastTime("slow"), 125'000);
        QCOMPARE(importedAs("lapse", "1").size(), std::size_t(1));
        QCOMPARE(lastTime("lapse"), 30'000'000);
        QVERIFY(importedAs("usual", "29.4").empty());
        QCOMPARE(lastTime("usual"), 1'000'000);
        QVERIFY(importedAs("told", "240", 30.0).empty());
        QCOMPARE(lastTime("told"), 1'000'000);
        QCOMPARE(
            importedAs("doubtful", "40"),
            std::vector<std::string>{"video 'doubtful.mp4': its file says that it was filmed at 40.0, but "
                                     "its time stamps mean 30.0 frames/s; give the rate at which the "
                                     "camera took the frames"});
    }

    void aVideoThatEndsEarlyIsTold()
    {
        QVERIFY(imported("whole", evenTimes(60, 30)).empty());
        std::filesystem::copy_file(path("whole.mkv"), path("cut.mkv"));
        std::filesystem::resize_file(path("cut.mkv"), std::filesystem::file_size(path("cut.mkv")) / 2);
        const auto warnings = importFile("cut");
        QCOMPARE(warnings.size(), std::size_t(1));
        QVERIFY2(warnings.front().starts_with("video 'cut.mkv': ends early at "), warnings.front().c_str());
    }

    /// A codec's bare stream has no time stamps: nobody's rate is invented.
    void aVideoWithoutTimesNeedsItsRate()
    {
        QVERIFY(imported("timed", evenTimes(30, 30)).empty());
        // JPEG images one after another, as some cameras write them
        QVERIFY(writeRaw(path("bare.mjpeg"), "mjpeg", "yuvj420p", 30, 1, 320));
        QCOMPARE(
            importFile("bare", ".mjpeg").front(),
            std::string("video 'bare.mjpeg': it has no time stamps and states no frame rate; give the rate "
                        "at which the camera took the frames"));
        QVERIFY(!m_project->trials().find("bare"));
        QVERIFY(importFile("bare", ".mjpeg", 50).empty());
        const auto stored = m_project->trials().recordings(m_project->trials().find("bare")->id)->front();
        QCOMPARE(stored.framesPerSecond, 50.0);
        QCOMPARE(stored.frameTimes.size(), std::size_t(30));
        QCOMPARE(stored.frameTimes.back(), Nanoseconds(29 * 20'000'000LL));
    }

    /// Two recordings in one file, as from a camera that was switched off meanwhile.
    void aClockThatBeginsAgainIsRefused()
    {
        QVERIFY(imported("part", evenTimes(60, 30)).empty());
        QVERIFY(remux(path("part.mkv"), path("single.ts")));
        std::ofstream joined(path("joined.ts"), std::ios::binary);
        for (int part = 0; part < 2; ++part)
            joined << std::ifstream(path("single.ts"), std::ios::binary).rdbuf();
        joined.close();
        QVERIFY(importFile("single", ".ts").empty());
        const auto error = importFile("joined", ".ts").front();
        QVERIFY2(
            error.starts_with("video 'joined.ts': its time stamps begin again or stand still after 1.97 s: "
                              "two files were joined, or the camera's clock was reset; cut it there, and "
                              "import each part as its own trial"),
            error.c_str());
        QVERIFY(!m_project->trials().find("joined"));
    }

    /// The time between them is in no file: of AVI the second would follow at once, of MP4 it would be
    /// ignored.
    void filesThatWereJoinedByteByByteAreRefused()
    {
        QVERIFY(imported("one", evenTimes(60, 30)).empty());
        for (const std::string kind : {"avi", "mp4", "mov"}) {
            const std::string ending = '.' + kind, twice = kind + "-twice";
            QVERIFY(remux(path("one.mkv"), path(kind + ending)));
            std::ofstream joined(path(twice + ending), std::ios::binary);
            for (int part = 0; part < 2; ++part)
                joined << std::ifstream(path(kind + ending), std::ios::binary).rdbuf();
            joined.close();
            QVERIFY(importFile(kind.c_str(), ending.c_str()).empty());
            const auto words = importFile(twice.c_str(), ending.c_str());
            QVERIFY(!words.empty());
            QVERIFY2(
                words.front().starts_with("video '" + twice + ending +
                                          "': it consists of several video files joined byte by byte, so "
                                          "the time between them is unknown; import each of these files "
                                          "as its own trial"),
                words.front().c_str());
        }
    }

    /// What editors make of such a file: its clock waits until it would go on.
    void aClockThatStandsStillIsRefused()
    {
        std::vector<Nanoseconds> times = evenTimes(60, 30);
        for (std::size_t i = 40; i < times.size(); ++i)
            times[i] = times[39] + std::chrono::milliseconds(i - 39);
        const std::string error = imported("waiting", times).front();
        QVERIFY2(
            error.starts_with("video 'waiting.mkv': its time stamps begin again or stand still after 1.30 s"),
            error.c_str());
        for (std::size_t i = 43; i < times.size(); ++i) // a few may be damaged
            times[i] = times[42] + std::chrono::milliseconds(33 * (i - 42));
        QVERIFY(imported("damaged", times).size() < 2);
        QVERIFY(m_project->trials().find("damaged"));
    }

    void interlacedFramesAreTold()
    {
        QVERIFY(writeRaw(path("fields.mkv"), "ffv1", "yuv420p", 30, 1, 320, 25, true));
        const auto warnings = importFile("fields");
        QCOMPARE(warnings, std::vector<std::string>{
                               "video 'fields.mkv': it is interlaced: each frame holds two fields taken one "
                               "after the other, and each is measured at its own time, with half the lines; "
                               "choose a progressive mode of the camera (p, "
                               "not i)"});
    }

    void aRateThatNoCameraHasIsRefused()
    {
        std::vector<Nanoseconds> times;
        for (int i = 0; i < 30; ++i)
            times.push_back(std::chrono::microseconds(i));
        const std::string refused = imported("dense", times).front();
        QVERIFY2(refused.find("frames/s, which no camera takes; give the rate at which") != std::string::npos,
                 refused.c_str());
        QVERIFY(importFile("dense", ".mkv", 30).empty());
        for (const double nonsense : {1e9, 0.0, -30.0, std::nan("")})
            QVERIFY(importFile("timed", ".mkv", nonsense).front().find("not between 0.1 and 100,000") !=
                    std::string::npos);
    }

    /// By the camera's clock, or else by when the file was written; neither where it was never set.
    void aTrialIsDatedByItsClips()
    {
        const auto made = [this](const char *trial, const char *created) {
            RawVideo video{"libx264", "yuv420p", 31, 64, 48, 30};
            video.fill = [](AVFrame &, int) {};
            if (created)
                video.metadata = {{"creation_time", created}};
            return writeRaw(path(std::string(trial) + ".mp4"), video) && importFile(trial, ".mp4").empty();
        };
        const auto date = [this](const char *trial) { return m_project->trials().find(trial)->date; };
        const Instant lesson(std::chrono::sys_days(std::chrono::year(2026) / 3 / 9) + std::chrono::hours(10) +
                             std::chrono::minutes(15));
        QVERIFY(made("filmed", "2026-03-09T10:15:00.000000Z"));
        QVERIFY(date("filmed") == lesson);
        const Instant before = instantNow() - std::chrono::seconds(2);
        QVERIFY(made("undated", nullptr));
        QVERIFY(date("undated") >= before && date("undated") <= instantNow());
        QVERIFY(made("unset clock", "1970-01-01T00:00:05.000000Z"));
        QVERIFY(date("unset clock") >= before);
        QVERIFY(made("future", "2150-01-01T00:00:00.000000Z"));
        QVERIFY(date("future") <= instantNow());
        std::filesystem::copy_file(path("undated.mp4"), path("old.mp4"));
        std::filesystem::last_write_time(path("old.mp4"), std::chrono::file_clock::from_sys(lesson));
        QVERIFY(importFile("old", ".mp4").empty());
        QVERIFY(date("old") == lesson);
    }

    /// It would agree with itself in everything.
    void aFileGivenToTwoCamerasIsRefused()
    {
        QVERIFY(imported("once", evenTimes(30, 30)).empty());
        std::filesystem::create_symlink(path("once.mkv"), path("again.mkv"));
        for (const char *other : {"once.mkv", "again.mkv"}) {
            ImportSettings settings;
            settings.trial = "twice";
            settings.videos = {{"A", path("once.mkv")}, {"B", path(other)}};
            ImportTrialJob job(std::move(settings));
            const auto done = runToEnd(job, *m_project, {});
            QVERIFY(!done);
            QCOMPARE(done.error().message(),
                     std::string("import of trial 'twice': cameras 'A' and 'B' were given the same file, '") +
                         other + "'; give each camera its own video");
        }
    }

private:
    std::filesystem::path path(const std::string &name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    std::vector<std::string> imported(const std::string &trial, const std::vector<Nanoseconds> &times)
    {
        if (const QString problem = writeCoded(path(trial + ".mkv"), times, {}); !problem.isEmpty())
            return {problem.toStdString()};
        return importFile(trial);
    }
    std::vector<std::string> importFile(const std::string &trial, const std::string &ending = ".mkv",
                                        std::optional<double> rate = {})
    {
        ImportSettings settings;
        settings.trial = trial;
        settings.videos = {{"A", path(trial + ending)}};
        settings.rate = rate;
        ImportTrialJob job(std::move(settings));
        const auto done = runToEnd(job, *m_project, {});
        return done ? test::english(job.warnings()) : std::vector<std::string>{done.error().message()};
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestImportTrial, QCoreApplication)
#include "tst_import_trial.moc"
