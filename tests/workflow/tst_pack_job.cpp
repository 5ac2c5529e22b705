// SPDX-License-Identifier: GPL-3.0-or-later
// A project packed with all that belongs to it and opened elsewhere; lost videos found again by their
// content.
#include "core/project/project.h"
#include "core/project/recording_rows.h"
#include "core/project/repositories.h"
#include "core/workflow/media_upkeep.h"
#include "core/workflow/project_copy.h"
#include "tests/support/registered_test.h"
#include "tests/support/said_error.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace odo;

namespace {

/// Of the files that the project needs. What it needs not lies in its media folder here too.
int damagedFiles(Project &project)
{
    const auto problems = project.check(true).value();
    return static_cast<int>(std::ranges::count_if(problems, [](const ProjectProblem &problem) {
        return !problem.what.english().ends_with("uses this file");
    }));
}

} // namespace

class TestPackJob : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void isOpenedElsewhere();
    void renamedAndThroughALink();
    void theProjectStaysAsItWas();
    void whatIsLostIsNamed();
    void aPathThatNoFileCanHaveIsLost();
    void aVideoElsewhereThatIsAnotherFileIsLeftOut_data();
    void aVideoElsewhereThatIsAnotherFileIsLeftOut();
    void aLinkOutOfTheMediaFolderIsLeftOut();
    void notWhileATrialIsRecorded();
    void cancellingLeavesNothing();
    void lostVideosAreFoundByTheirContent();
    void sayingWhatIsMissing();

private:
    QString path(const char *name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    std::filesystem::path file(const char *name) const { return path(name).toStdString(); }
    void write(const char *name, const QByteArray &content) const
    {
        QVERIFY(QDir().mkpath(QFileInfo(path(name)).path()));
        QFile out(path(name));
        QVERIFY(out.open(QIODevice::WriteOnly) && out.write(content) == content.size());
    }
    RecordingRecord recording(const char *name) const;
    QStringList everything() const;

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
    RecordId m_camera = 0;
};

RecordingRecord TestPackJob::recording(const char *name) const
{
    RecordingRecord recording;
    recording.camera = m_camera;
    recording.path = file(name).string();
    recording.sha256 = *fileSha256(recording.path, {});
    recording.bytes = QFileInfo(path(name)).size();
    recording.widthPx = 640;
    recording.heightPx = 480;
    recording.framesPerSecond = 30;
    recording.frameTimes = {Nanoseconds(0), Nanoseconds(33'000'000)};
    return recording;
}

/// One video beside the project, one elsewhere, of the same name.
void TestPackJob::init()
{
    m_project.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir().mkpath(path("school/lesson.media/calibration")));
    QVERIFY(QDir().mkpath(path("elsewhere")));
    write("school/lesson.media/run.mkv", QByteArray(70'000, 'a'));
    write("school/lesson.media/calibration/board.png", "picture");
    write("school/lesson.media/recording.lock", "");
    write("elsewhere/run.mkv", QByteArray(70'000, 'b'));
    m_project = std::move(*Project::create(file("school/lesson.odo"), "Lesson"));
    m_camera = m_project->cameras().add({0, "A", ""})->id;
    TrialRecord trial;
    trial.name = "run";
    trial.durationS = 0.033;
    const auto added = m_project->trials().add(
        trial, {recording("school/lesson.media/run.mkv"), recording("elsewhere/run.mkv")});
    QVERIFY2(added, added ? "" : added.error().message().c_str());
}

QStringList TestPackJob::everything() const
{
    QStringList files;
    for (const auto &each : std::filesystem::recursive_directory_iterator(m_folder->path().toStdString()))
        files << QString::fromStdString(each.path().string());
    files.sort();
    return files;
}

void TestPackJob::isOpenedElsewhere()
{
    PackJob job(file("lesson.zip"));
    const auto packed = runToEnd(job, *m_project, {});
    QVERIFY2(packed, packed ? "" : packed.error().message().c_str());
    QVERIFY(job.warnings().empty());
    m_project.reset();
    std::filesystem::remove_all(file("school"));
    std::filesystem::remove_all(file("elsewhere"));

    const auto unpacked = unpackArchive(file("lesson.zip"), file("home"), {});
    QVERIFY2(unpacked, unpacked ? "" : unpacked.error().message().c_str());
    const auto project = Project::open(*unpacked, Project::Access::ReadWrite);
    QVERIFY2(project, project ? "" : project.error().message().c_str());
    QCOMPARE(damagedFiles(**project), 0); // every video is there, of its hash
    const auto recordings = (*project)->trials().recordings((*project)->trials().find("run")->id).value();
    QCOMPARE(recordings[0].path, std::string("lesson.media/run.mkv"));
    QCOMPARE(recordings[1].path, std::string("lesson.media/run_2.mkv"));
    QVERIFY(QFile::exists(path("home/lesson.media/calibration/board.png")));
    QVERIFY(!QFile::exists(path("home/lesson.media/recording.lock")));
}

void TestPackJob::renamedAndThroughALink()
{
    m_project.reset();
    std::filesystem::rename(file("school/lesson.odo"), file("school/year.odo"));
    std::filesystem::rename(file("school/lesson.media"), file("school/year.media"));
    std::filesystem::create_symlink(file("school/year.odo"), file("desk.odo"));
    m_project = std::move(*Project::open(file("desk.odo"), Project::Access::ReadWrite));
    PackJob job(file("lesson.zip"));
    const auto packed = runToEnd(job, *m_project, {});
    QVERIFY2(packed, packed ? "" : packed.error().message().c_str());
    QVERIFY(job.warnings().empty());
    const auto unpacked = unpackArchive(file("lesson.zip"), file("home"), {});
    QVERIFY2(unpacked, unpacked ? "" : unpacked.error().message().c_str());
    QCOMPARE(*unpacked, file("home/year.odo"));
    QCOMPARE(damagedFiles(**Project::open(*unpacked, Project::Access::ReadOnly)), 0);
}

void TestPackJob::theProjectStaysAsItWas()
{
    const QStringList before = everything();
    PackJob job(file("lesson.zip"));
    QVERIFY(runToEnd(job, *m_project, {}));
    QCOMPARE(everything(), [&] {
        QStringList after = before;
        after << path("lesson.zip");
        after.sort();
        return after;
    }());
    const auto recordings = m_project->trials().recordings(m_project->trials().find("run")->id).value();
    QCOMPARE(recordings[1].path, file("elsewhere/run.mkv").string());
}

void TestPackJob::whatIsLostIsNamed()
{
    QVERIFY(QFile::remove(path("elsewhere/run.mkv")));
    PackJob job(file("lesson.zip"));
    QVERIFY(runToEnd(job, *m_project, {}));
    QCOMPARE(test::english(job.warnings()),
             std::vector<std::string>{
                 "the video of camera A in trial 'run' is lost and is not in the packed project"});
}

/// The system refuses to look at it, which is no reason to end the program.
void TestPackJob::aPathThatNoFileCanHaveIsLost()
{
    const auto recordings = m_project->trials().recordings(m_project->trials().find("run")->id).value();
    QVERIFY(m_project->trials().setFile(recordings[1].id, "/" + std::string(6000, 'A')));
    PackJob job(file("lesson.zip"));
    QVERIFY(runToEnd(job, *m_project, {}));
    QCOMPARE(job.warnings().size(), std::size_t(1));
    RelinkJob relink(file("elsewhere"));
    QVERIFY(runToEnd(relink, *m_project, {}));
    QCOMPARE(relink.lostCount(), std::size_t(1));
    RelinkJob nowhere("/" + std::string(6000, 'A'));
    QCOMPARE(runToEnd(nowhere, *m_project, {}).error().code, ErrorCode::NotFound); // nothing is lost any more
    QVERIFY(m_project->trials().setFile(recordings[1].id, "/nowhere"));
    QCOMPARE(runToEnd(nowhere, *m_project, {}).error().why.english(), std::string("File name too long"));
}

void TestPackJob::aVideoElsewhereThatIsAnotherFileIsLeftOut_data()
{
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<bool>("isHashed");
    QTest::newRow("of the same size") << QByteArray(70'000, 'x') << true;
    QTest::newRow("longer") << QByteArray(70'001, 'b') << true;
    QTest::newRow("never hashed, and no video") << QByteArray(70'000, 'b') << false;
}

/// Otherwise a project from elsewhere could have any file of its reader packed.
void TestPackJob::aVideoElsewhereThatIsAnotherFileIsLeftOut()
{
    QFETCH(QByteArray, content);
    QFETCH(bool, isHashed);
    if (!isHashed) {
        const auto recordings = m_project->trials().recordings(m_project->trials().find("run")->id).value();
        QVERIFY(m_project->trials().setHash(recordings[1].id, {}));
    }
    write("elsewhere/run.mkv", content);
    PackJob job(file("lesson.zip"));
    QVERIFY(runToEnd(job, *m_project, {}));
    QCOMPARE(test::english(job.warnings()),
             std::vector<std::string>{"the video of camera A in trial 'run' is outside the media folder and "
                                      "has changed since; it is not in the packed project"});
    QVERIFY(unpackArchive(file("lesson.zip"), file("home"), {}));
    QVERIFY(QFile::exists(path("home/lesson.media/run.mkv")));
    QVERIFY(!QFile::exists(path("home/lesson.media/run_2.mkv")));
}

void TestPackJob::aLinkOutOfTheMediaFolderIsLeftOut()
{
    write("elsewhere/diary.txt", "private");
    QVERIFY(QFile::link(path("elsewhere/diary.txt"), path("school/lesson.media/diary.txt")));
    QVERIFY(QFile::link(path("elsewhere"), path("school/lesson.media/elsewhere")));
    QVERIFY(QFile::link(path("nowhere"), path("school/lesson.media/nowhere")));
    QVERIFY(QDir(path("school/lesson.media")).mkpath(QStringLiteral("below")));
    write("school/lesson.media/below/a.txt", "a");
    QStringList many; // in whatever order they are found, some come after the link
    for (int i = 0; i < 20; ++i)
        many += QStringLiteral("lesson.media/%1.txt").arg(i);
    for (const QString &name : many)
        write(qPrintable(QStringLiteral("school/") + name), "z");
    PackJob job(file("lesson.zip"));
    QVERIFY(runToEnd(job, *m_project, {}));
    QVERIFY(unpackArchive(file("lesson.zip"), file("home"), {}));
    QVERIFY(QFile::exists(path("home/lesson.media/run_2.mkv"))); // its video, and of the same content
    QVERIFY(QFile::exists(path("home/lesson.media/below/a.txt")));
    for (const QString &name : many)
        QVERIFY2(QFile::exists(path("home/") + name), qPrintable(name));
    for (const char *left : {"diary.txt", "elsewhere", "nowhere"})
        QVERIFY2(!QFile::exists(path("home/lesson.media/") + QString::fromLatin1(left)), left);
}

void TestPackJob::notWhileATrialIsRecorded()
{
    TrialRecord trial;
    trial.name = "now";
    QVERIFY(m_project->trials().begin(trial, {}));
    PackJob job(file("lesson.zip"));
    QCOMPARE(runToEnd(job, *m_project, {}).error().message(),
             std::string("pack 'lesson.odo': trial 'now' is being recorded; end its recording first"));
    QVERIFY(!QFile::exists(path("lesson.zip")));
}

void TestPackJob::cancellingLeavesNothing()
{
    const QStringList before = everything();
    JobControl control;
    control.cancel.cancel();
    PackJob job(file("lesson.zip"));
    QCOMPARE(runToEnd(job, *m_project, control).error().code, ErrorCode::Cancelled);
    QCOMPARE(everything(), before);
}

void TestPackJob::lostVideosAreFoundByTheirContent()
{
    QVERIFY(QDir().mkpath(path("stick/deep/er")));
    QVERIFY(QFile::rename(path("elsewhere/run.mkv"), path("stick/deep/er/renamed.bin")));
    write("stick/run.mkv", QByteArray(70'000, 'c')); // of its name and size, and another
    RelinkJob job(file("stick"));
    const auto linked = runToEnd(job, *m_project, {});
    QVERIFY2(linked, linked ? "" : linked.error().message().c_str());
    QCOMPARE(job.lostCount(), std::size_t(1));
    QCOMPARE(job.foundCount(), std::size_t(1));
    QCOMPARE(damagedFiles(*m_project), 0);
    QCOMPARE(m_project->undo().value().english(), std::string("link a lost video"));
    QCOMPARE(damagedFiles(*m_project), 1);
}

void TestPackJob::sayingWhatIsMissing()
{
    RelinkJob none(file("elsewhere"));
    QCOMPARE(runToEnd(none, *m_project, {}).error().message(),
             std::string("lost videos: no video of this project is lost; no action is needed"));
    QVERIFY(QFile::remove(path("elsewhere/run.mkv")));
    RelinkJob empty(file("elsewhere"));
    QCOMPARE(runToEnd(empty, *m_project, {}).error().message(),
             "search '" + file("elsewhere").string() +
                 "': the lost video is not in this folder; choose the folder where they were copied to");
    RelinkJob nowhere("/no/such/folder");
    QCOMPARE(runToEnd(nowhere, *m_project, {}).error().code, ErrorCode::Io);
    JobControl control;
    control.cancel.cancel();
    RelinkJob stopped(file("school"));
    QCOMPARE(runToEnd(stopped, *m_project, control).error().code, ErrorCode::Cancelled);
}

ODOGRAPH_TEST(TestPackJob, QCoreApplication)
#include "tst_pack_job.moc"
