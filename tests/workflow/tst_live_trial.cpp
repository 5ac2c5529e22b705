// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "core/workflow/record/completed_recordings.h"
#include "core/workflow/record/live_trial.h"
#include "tests/capture/played_camera.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

constexpr int lot = 30; ///< so many find room at once, however slow this machine is just now

/// A project, and two cameras; B takes its pictures 7 ms later by a clock that began an hour before A's.
struct Sitting
{
    explicit Sitting(CaptureSettings settings = {0s}, std::size_t jpegBytes = 0)
        : project(std::move(*Project::create(folder.filePath(QStringLiteral("p.odo")).toStdString(), "Live")))
    {
        std::vector<std::unique_ptr<CameraSource>> cameras;
        cameras.push_back(std::make_unique<PlayedCamera>(
            a, PlayedCamera::Kind{.beginning = beginning, .jpegBytes = jpegBytes}));
        cameras.push_back(std::make_unique<PlayedCamera>(
            b, PlayedCamera::Kind{.beginning = beginning, .clockStart = -3600s, .phase = 7ms}));
        session = std::make_unique<CaptureSession>(std::move(cameras), std::move(settings));
    }
    Result<std::shared_ptr<LiveTrial>> begin(const std::string &name = "run",
                                             const std::vector<std::string> &cameras = {"A", "B"},
                                             std::optional<RunStart> start = std::nullopt)
    {
        TrialRecord trial;
        trial.name = name;
        return LiveTrial::begin(*project, trial, cameras, *session, start);
    }
    /// Has both cameras take a lot more, and waits until it stands in the project.
    void record(LiveTrial &live, std::size_t lots)
    {
        a->frames(lot);
        b->frames(lot);
        for (const char *camera : {"A", "B"})
            QTRY_VERIFY(live.append(*project) && rawTimes(camera).frames.size() == lots * lot);
    }
    RecordedTimes rawTimes(const char *camera) const
    {
        const auto recordings = project->trials().recordings(trial().id);
        for (const RecordingRecord &record : *recordings) {
            if (record.cameraName == camera)
                return *project->trials().rawTimes(record.id);
        }
        return {};
    }
    TrialRecord trial() const { return project->trials().find("run").value_or(TrialRecord()); }
    QStringList media() const
    {
        return QDir(folder.filePath(QStringLiteral("p.media"))).entryList({QStringLiteral("*.mkv")});
    }

    QTemporaryDir folder;
    Nanoseconds beginning = steadyNow();
    std::unique_ptr<Project> project;
    std::shared_ptr<Script> a = std::make_shared<Script>(), b = std::make_shared<Script>();
    std::unique_ptr<CaptureSession> session;
};

} // namespace

class TestLiveTrial : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void standsInTheProjectFromItsBeginning();
    void itsStartIsMarkedWhereItBeganBefore();
    void whatTheMemoryCouldNotKeepIsTold();
    void aCameraThatTookTooFewPicturesIsTold();
    void oneThatIsGivenUpLeavesNothingBehind();
    void viewsNeverShareAFile_data();
    void viewsNeverShareAFile();
    void aViewWithoutPicturesIsLeftOut();
    void withoutAnyPictureItFails();
    void stoppedBeforeTheFirstFrameItSaysSo();
    void whatWasCutOffIsRecovered();
    void whatIsBeingRecordedIsLeftAlone();
    void aMissingFileIsWaitedFor();
    void picturesWithoutStoredTimesGetTheirsFromTheFile();
    void aFileWithoutAPictureIsRemoved();
    void aFileOfSomebodyElseStays();
    void aFileThatMayHoldAPictureStays();
    void hashesAreMadeAfterwards();
    void aProjectThatIsNoLongerThereIsNotRecordedInto();
    void aDiskThatIsTakenAwayKeepsTheTrial();
};

void TestLiveTrial::standsInTheProjectFromItsBeginning()
{
    Sitting sitting;
    const auto live = sitting.begin();
    QVERIFY(live);
    QVERIFY(sitting.trial().unfinished);
    QCOMPARE(sitting.trial().viewCount, 2);
    sitting.record(**live, 1);
    QVERIFY(std::abs(sitting.trial().durationS - 29 * 0.033) < 1e-6);
    QVERIFY(sitting.project->check(true)->empty()); // while it goes on, all is as it should be
    sitting.record(**live, 2);
    QVERIFY(runToEnd(**live, *sitting.project, {}));
    QVERIFY((*live)->warnings().empty());
    const TrialRecord trial = sitting.trial();
    QVERIFY(!trial.unfinished);
    QVERIFY(std::abs(trial.durationS - 59 * 0.033) < 1e-6);
    QCOMPARE(trial.syncMethod, std::string("clock"));
    QVERIFY(std::abs(trial.syncOffsetS - 0.007) < 1e-6);
    QCOMPARE(sitting.project->trials().recordings(trial.id)->back().frameTimes.size(), std::size_t(2 * lot));
    QCOMPARE(sitting.rawTimes("B").frames.front().device, Nanoseconds(3600s + 7ms));
    QVERIFY(sitting.project->check(true)->empty());
    QCOMPARE((*live)->commit(*sitting.project).error().why.english(),
             std::string("its recording has ended already"));
    QVERIFY(!sitting.project->trials().removeUnfinished(trial.id));
}

/// The button is pressed half way from the 28th to the 29th of 30 kept frames, and all are wanted.
void TestLiveTrial::itsStartIsMarkedWhereItBeganBefore()
{
    Sitting sitting({5s});
    sitting.a->frames(lot);
    sitting.b->frames(lot);
    QTRY_VERIFY(sitting.session->health().views[0].delivered == lot &&
                sitting.session->health().views[1].delivered == lot);
    const Nanoseconds pressed = sitting.beginning + 27 * 33ms + 16ms;
    const auto live = sitting.begin("run", {"A", "B"}, RunStart{pressed, pressed - 2s});
    QVERIFY(live);
    sitting.a->frames(lot);
    sitting.b->frames(lot);
    for (const char *camera : {"A", "B"})
        QTRY_VERIFY((*live)->append(*sitting.project) &&
                    sitting.rawTimes(camera).frames.size() == std::size_t(2 * lot));
    QVERIFY(runToEnd(**live, *sitting.project, {}));
    QVERIFY((*live)->warnings().empty());
    const TrialRecord trial = sitting.trial();
    QCOMPARE(trial.variables.size(), std::size_t(1));
    QCOMPARE(trial.variables.at(startVariable), std::string("0.907")); // 27 · 33 + 16 ms
    QVERIFY(sitting.project->check(true)->empty());
}

void TestLiveTrial::whatTheMemoryCouldNotKeepIsTold()
{
    Sitting sitting({.preRoll = 5s, .preRollBytes = 20'500'000}, 1'000'000); // 10 frames of A
    sitting.a->frames(lot);
    sitting.b->frames(lot);
    QTRY_VERIFY(sitting.session->health().views[0].delivered == lot &&
                sitting.session->health().views[1].delivered == lot);
    const Nanoseconds pressed = sitting.beginning + (lot - 1) * 33ms;
    const auto live = sitting.begin("run", {"A", "B"}, RunStart{pressed, pressed - 800ms});
    QVERIFY(live && runToEnd(**live, *sitting.project, {}));
    QCOMPARE((*live)->warnings().size(), std::size_t(1));
    QCOMPARE(
        (*live)->warnings().front().english(),
        std::string("view 'A': only the 0.3 s before the start were kept: 0.8 s of this camera need more "
                    "than 10 MB; record fewer seconds before the start, or smaller frames"));
}

void TestLiveTrial::aCameraThatTookTooFewPicturesIsTold()
{
    Sitting sitting;
    const auto live = sitting.begin();
    QVERIFY(live);
    sitting.b->pace(100ms);
    sitting.record(**live, 1);
    QVERIFY(runToEnd(**live, *sitting.project, {}));
    QCOMPARE(test::english((*live)->warnings()),
             std::vector<std::string>{
                 "view 'B': camera play:: it delivers only 10 frames per second instead of the requested 30; "
                 "give it more light or a shorter exposure, or ask for a lower rate"});
}

void TestLiveTrial::oneThatIsGivenUpLeavesNothingBehind()
{
    Sitting sitting;
    const auto live = sitting.begin();
    sitting.record(**live, 1);
    QVERIFY((*live)->discard(*sitting.project));
    QVERIFY(sitting.project->trials().all()->empty());
    QVERIFY(sitting.project->cameras().all()->empty());
    QVERIFY(sitting.media().empty());
    QVERIFY(sitting.begin()); // the next one may begin
}

void TestLiveTrial::viewsNeverShareAFile_data()
{
    QTest::addColumn<QString>("trial");
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::newRow("names that differ in what no file has")
        << QStringLiteral("run") << QStringLiteral("A?") << QStringLiteral("A*");
    QTest::newRow("longer than a file's name")
        << QString(100, u'x') << QStringLiteral("A") << QStringLiteral("B");
}

/// Their names become files' names, in which they may be the same.
void TestLiveTrial::viewsNeverShareAFile()
{
    QFETCH(QString, trial);
    QFETCH(QString, first);
    QFETCH(QString, second);
    Sitting sitting;
    const auto live = sitting.begin(trial.toStdString(), {first.toStdString(), second.toStdString()});
    QVERIFY2(live, live ? "" : live.error().message().c_str());
    sitting.a->frames(lot);
    sitting.b->frames(lot);
    const auto recordings =
        sitting.project->trials().recordings(sitting.project->trials().find(trial.toStdString())->id);
    for (const RecordingRecord &recording : *recordings)
        QTRY_VERIFY((*live)->append(*sitting.project) &&
                    sitting.project->trials().rawTimes(recording.id)->frames.size() == lot);
    QVERIFY(runToEnd(**live, *sitting.project, {}));
    QVERIFY2((*live)->warnings().empty(),
             (*live)->warnings().empty() ? "" : (*live)->warnings().front().english().c_str());
    QCOMPARE(sitting.media().size(), 2);
}

void TestLiveTrial::aViewWithoutPicturesIsLeftOut()
{
    Sitting sitting;
    const auto live = sitting.begin();
    sitting.b->frames(10);
    QTRY_COMPARE(sitting.session->health().views[1].delivered, 10u);
    QVERIFY(runToEnd(**live, *sitting.project, {}));
    QCOMPARE((*live)->warnings().size(), std::size_t(1));
    QVERIFY(
        (*live)->warnings().front().english().starts_with("view 'A': it recorded nothing and was left out"));
    const auto recordings = sitting.project->trials().recordings(sitting.trial().id);
    QCOMPARE(recordings->size(), std::size_t(1));
    QCOMPARE(recordings->front().cameraName, std::string("B"));
    QCOMPARE(recordings->front().position, 0);
    QCOMPARE(recordings->front().frameTimes.size(), std::size_t(10));
}

void TestLiveTrial::withoutAnyPictureItFails()
{
    Sitting sitting;
    const auto live = sitting.begin();
    const auto ended = runToEnd(**live, *sitting.project, {});
    QCOMPARE(ended.error().message(),
             std::string("recording of trial 'run': no camera delivered a frame; check that they are "
                         "connected and not used by another program"));
    QVERIFY(sitting.project->trials().all()->empty());
}

void TestLiveTrial::stoppedBeforeTheFirstFrameItSaysSo()
{
    Sitting sitting;
    sitting.a->frames(10);
    QTRY_COMPARE(sitting.session->health().views[0].delivered, 10u);
    const auto live = sitting.begin();
    const auto ended = runToEnd(**live, *sitting.project, {});
    QCOMPARE(
        ended.error().message(),
        std::string("recording of trial 'run': it was stopped before the first frame came; record again, "
                    "for longer"));
    QVERIFY(sitting.project->trials().all()->empty());
}

void TestLiveTrial::whatWasCutOffIsRecovered()
{
    Sitting sitting;
    {
        const auto live = sitting.begin();
        sitting.record(**live, 1);
    } // as a kill would leave it: never completed
    QVERIFY(sitting.trial().unfinished);
    QCOMPARE(sitting.project->check(false)->size(), std::size_t(1));
    const auto told = recoverTrials(*sitting.project, {});
    QVERIFY(told);
    QCOMPARE(test::english(*told),
             std::vector<std::string>{"trial 'run': its recording was cut off; 1.0 s of 2 views were saved, "
                                      "at most the last second is missing"});
    const TrialRecord trial = sitting.trial();
    QVERIFY(!trial.unfinished);
    QVERIFY(std::abs(trial.syncOffsetS - 0.007) < 1e-6);
    const auto recordings = sitting.project->trials().recordings(trial.id);
    for (const RecordingRecord &record : *recordings)
        QCOMPARE(record.frameTimes.size(), std::size_t(lot));
    QVERIFY(sitting.project->check(true)->empty());
    QVERIFY(recoverTrials(*sitting.project, {})->empty()); // once
}

void TestLiveTrial::whatIsBeingRecordedIsLeftAlone()
{
    Sitting sitting;
    const auto live = sitting.begin();
    sitting.record(**live, 1);
    QVERIFY(recoverTrials(*sitting.project, {})->empty());
    QVERIFY(sitting.trial().unfinished);
    TrialRecord second;
    second.name = "second";
    QCOMPARE(LiveTrial::begin(*sitting.project, second, {"A", "B"}, *sitting.session).error().why.english(),
             std::string("a trial is being recorded into it now"));
}

void TestLiveTrial::aMissingFileIsWaitedFor()
{
    Sitting sitting;
    {
        const auto live = sitting.begin();
        sitting.record(**live, 1);
    }
    const std::filesystem::path folder = sitting.project->mediaFolder();
    std::filesystem::rename(folder / "run_B.mkv", folder / "away");
    const auto told = recoverTrials(*sitting.project, {});
    QVERIFY(told && told->size() == 1 &&
            told->front().english().find("run_B.mkv is missing: move the file back") != std::string::npos);
    QVERIFY(sitting.trial().unfinished);
    std::filesystem::rename(folder / "away", folder / "run_B.mkv");
    QVERIFY(recoverTrials(*sitting.project, {}));
    QCOMPARE(sitting.trial().viewCount, 2);
    QVERIFY(!sitting.trial().unfinished);
}

void TestLiveTrial::picturesWithoutStoredTimesGetTheirsFromTheFile()
{
    Sitting sitting;
    {
        const auto live = sitting.begin();
        sitting.record(**live, 1);
        sitting.a->frames(lot); // on the disk, and not in the project
        QTRY_COMPARE(sitting.session->health().views[0].delivered, std::uint64_t(2 * lot));
    }
    QVERIFY(recoverTrials(*sitting.project, {}));
    const auto recordings = sitting.project->trials().recordings(sitting.trial().id);
    QCOMPARE(recordings->front().frameTimes.size(), std::size_t(2 * lot));
    QCOMPARE(recordings->back().frameTimes.size(), std::size_t(lot));
    for (std::size_t i = 0; i < 2 * lot;
         ++i) // the file knows them to half a millisecond, at each end of a difference
        QVERIFY(std::abs(toSeconds(recordings->front().frameTimes[i]) - 0.033 * double(i)) < 0.0011);
    QCOMPARE(sitting.rawTimes("A").frames.size(), std::size_t(lot)); // what is not known is not made up
}

void TestLiveTrial::aFileWithoutAPictureIsRemoved()
{
    Sitting sitting;
    {
        const auto live = sitting.begin();
        sitting.a->frames(lot);
        QTRY_VERIFY((*live)->append(*sitting.project) && sitting.rawTimes("A").frames.size() == lot);
    }
    // As far as a recording is written before its first picture.
    std::ofstream(sitting.project->mediaFolder() / "run_B.mkv") << "\x1a\x45\xdf\xa3 the beginning of a file";
    QVERIFY(recoverTrials(*sitting.project, {}));
    QCOMPARE(sitting.trial().viewCount, 1);
    QCOMPARE(sitting.media(), QStringList{QStringLiteral("run_A.mkv")});
}

/// A project may come from anyone, and say of any file that it was being recorded.
void TestLiveTrial::aFileOfSomebodyElseStays()
{
    Sitting sitting;
    const std::filesystem::path own = sitting.project->mediaFolder().parent_path() / "own.txt";
    std::ofstream(own) << "somebody's own";
    TrialRecord trial;
    trial.name = "hostile";
    RecordingRecord recording;
    recording.camera = sitting.project->cameras().add({0, "C", ""})->id;
    recording.path = own.string();
    QVERIFY(sitting.project->trials().begin(trial, {recording}));
    QVERIFY(recoverTrials(*sitting.project, {}));
    QVERIFY(!sitting.project->trials().find("hostile"));
    QVERIFY(std::filesystem::exists(own));
}

void TestLiveTrial::aFileThatMayHoldAPictureStays()
{
    Sitting sitting;
    {
        const auto live = sitting.begin();
    }
    std::ofstream(sitting.project->mediaFolder() / "run_B.mkv")
        << "damaged, but \xff\xd8\xff begins a picture";
    const auto told = recoverTrials(*sitting.project, {});
    QVERIFY(told && told->front().english().find("nothing of it had reached the disk") != std::string::npos);
    QVERIFY(sitting.project->trials().all()->empty());
    QCOMPARE(sitting.media(), QStringList{QStringLiteral("run_B.mkv")});
}

void TestLiveTrial::hashesAreMadeAfterwards()
{
    Sitting sitting;
    const auto live = sitting.begin();
    sitting.record(**live, 1);
    QVERIFY(runToEnd(**live, *sitting.project, {}));
    QCOMPARE(sitting.project->trials().unhashed()->size(), std::size_t(2));

    HashJob calledOff;
    QVERIFY(calledOff.prepare(*sitting.project));
    JobControl control;
    control.cancel.cancel();
    QCOMPARE(calledOff.run(control).error().code, ErrorCode::Cancelled);

    std::filesystem::resize_file(sitting.project->mediaFolder() / "run_B.mkv", 100); // not as it was
    HashJob job;
    QVERIFY(runToEnd(job, *sitting.project, {}));
    const auto recordings = sitting.project->trials().recordings(sitting.trial().id);
    QCOMPARE(recordings->front().sha256, *fileSha256(sitting.project->mediaFolder() / "run_A.mkv", {}));
    QVERIFY(recordings->back().sha256.empty());
    QCOMPARE(sitting.project->check(true)->size(), std::size_t(1));
}

/// Its disk was taken out of the file system: a media folder in the place where it was would be on another
/// one.
void TestLiveTrial::aProjectThatIsNoLongerThereIsNotRecordedInto()
{
    Sitting sitting;
    const QString file = sitting.folder.filePath(QStringLiteral("p.odo"));
    QVERIFY(QFile::rename(file, file + QStringLiteral(".away")));
    const auto live = sitting.begin();
    QVERIFY(!live);
    QCOMPARE(live.error().code, ErrorCode::NotFound);
    QCOMPARE(live.error().message(),
             std::string("recording of trial 'run': the project file no longer exists; reconnect its "
                         "disk, or move its folder back; nothing was recorded"));
    QVERIFY(!QFile::exists(sitting.folder.filePath(QStringLiteral("p.media"))));
    QVERIFY(QFile::rename(file + QStringLiteral(".away"), file));
    QVERIFY(sitting.begin());
}

/// The cause is told, and with the disk back the trial is as if the recording had been cut off.
void TestLiveTrial::aDiskThatIsTakenAwayKeepsTheTrial()
{
    Sitting sitting;
    {
        const auto live = sitting.begin();
        QVERIFY(live);
        sitting.record(**live, 1);
        const QString media = sitting.folder.filePath(QStringLiteral("p.media"));
        QVERIFY(QDir().rename(media, media + QStringLiteral(".away")));
        QTRY_VERIFY((sitting.a->frames(1), sitting.b->frames(1), sitting.session->health().disk.ended));
        const auto ended = runToEnd(**live, *sitting.project, {});
        QVERIFY(!ended);
        QVERIFY2(ended.error().message().ends_with("its file is no longer there; reconnect its disk, or move "
                                                   "its folder back; it holds what was recorded so far"),
                 ended.error().message().c_str());
        QVERIFY(sitting.trial().unfinished);
        QVERIFY(QDir().rename(media + QStringLiteral(".away"), media));
    }
    const auto told = recoverTrials(*sitting.project, {});
    QVERIFY2(told, told ? "" : told.error().message().c_str());
    QVERIFY(!sitting.trial().unfinished);
    QVERIFY(sitting.project->check(true)->empty());
    const auto recordings = sitting.project->trials().recordings(sitting.trial().id);
    QCOMPARE(recordings.value().size(), std::size_t(2));
    for (const RecordingRecord &recording : *recordings)
        QVERIFY(recording.frameTimes.size() >= std::size_t(lot));
}

ODOGRAPH_TEST(TestLiveTrial, QCoreApplication)
#include "tst_live_trial.moc"
