// SPDX-License-Identifier: GPL-3.0-or-later
// Backups of a project: when they are made and removed, what putting the project back would change, and that
// nothing is lost by it.
#include "core/workflow/backups.h"

#include "core/project/project.h"
#include "core/project/project_rescue.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"

#include <QDateTime>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>

using namespace odo;

namespace {

/// By the local clock, as the names of backups are.
Instant at(const QString &time)
{
    return Instant(std::chrono::milliseconds(QDateTime::fromString(time, Qt::ISODate).toMSecsSinceEpoch()));
}

/// By its path: any descriptor of an open project that is closed drops its locks.
void setLastWrite(const std::filesystem::path &file, Instant time)
{
    const auto ago = std::chrono::system_clock::now() - time;
    std::filesystem::last_write_time(
        file, std::filesystem::file_time_type::clock::now() -
                  std::chrono::duration_cast<std::filesystem::file_time_type::duration>(ago));
}

void addTrial(Project &project, const std::string &name)
{
    const auto camera = project.cameras().find("A");
    RecordingRecord recording;
    recording.camera = camera ? camera->id : project.cameras().add({0, "A", ""})->id;
    recording.path = "lesson.media/" + name + ".mkv";
    recording.bytes = 5;
    recording.frameTimes = {Nanoseconds{0}};
    TrialRecord trial;
    trial.name = name;
    trial.date = at(QStringLiteral("2026-11-20T10:00:00"));
    QVERIFY(project.change(foreignWords("import " + name), [&] {
        return project.trials().add(trial, {recording}).map([](const TrialRecord &) {});
    }));
}

} // namespace

class TestBackups : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = Project::create(file(), "Lesson").value();
        addTrial(*m_project, "one");
    }
    void cleanup() { m_project.reset(); }

    /// The first opening of a day makes one, the second none; nor does a day on which nothing was written.
    void oneIsMadeEachDayThatBringsChanges()
    {
        const BackupPlan plan;
        const auto first = backUpIfDue(*m_project, plan, at(QStringLiteral("2026-11-20T23:59:59")));
        QVERIFY(first && *first);
        QCOMPARE((*first)->file, folder() / "lesson.backups" / "lesson.odo.bak-20261120.235959");
        QVERIFY((*first)->isByDate);
        QVERIFY(m_project->emptyLog());
        setLastWrite(file(), at(QStringLiteral("2026-11-21T08:00:00")));
        hideLog();
        const auto same = backUpIfDue(*m_project, plan, at(QStringLiteral("2026-11-20T23:59:59")));
        QVERIFY(same && !*same);
        // a second later it is another day, and the file was written since
        const auto next = backUpIfDue(*m_project, plan, at(QStringLiteral("2026-11-21T00:00:00")));
        QVERIFY(next && *next);
        setLastWrite(file(), at(QStringLiteral("2026-11-20T12:00:00")));
        const auto unchanged = backUpIfDue(*m_project, plan, at(QStringLiteral("2026-11-22T00:00:00")));
        QVERIFY(unchanged && !*unchanged);
        QCOMPARE(backupsOf(file()).size(), std::size_t(2));
        QCOMPARE(backupsOf(file()).front().made, at(QStringLiteral("2026-11-21T00:00:00")));
        const auto off =
            backUpIfDue(*m_project, {.isDaily = false}, at(QStringLiteral("2026-12-22T00:00:00")));
        QVERIFY(off && !*off);
    }

    /// Those of thirty days ago stay, of thirty-one days ago go; the newest always stays, and one that was
    /// made before an update.
    void oldOnesAreRemoved()
    {
        for (const char *day : {"2026-10-01", "2026-10-02", "2026-10-03"})
            QVERIFY(backUp(*m_project, at(QString::fromUtf8(day) + QStringLiteral("T12:00:00"))));
        QVERIFY(m_project->saveCopy(folder() / "lesson.odo.bak-12"));
        QCOMPARE(removeOldBackups(file(), 30, at(QStringLiteral("2026-11-01T00:00:01"))), 1);
        QCOMPARE(names(), (std::vector<std::string>{"lesson.odo.bak-12", "lesson.odo.bak-20261003.120000",
                                                    "lesson.odo.bak-20261002.120000"}));
        QCOMPARE(removeOldBackups(file(), 30, at(QStringLiteral("2027-11-01T00:00:01"))), 1);
        QCOMPARE(names(), (std::vector<std::string>{"lesson.odo.bak-12", "lesson.odo.bak-20261003.120000"}));
    }

    void twoInOneSecondHaveTwoNames()
    {
        const Instant now = at(QStringLiteral("2026-11-20T10:00:00"));
        QVERIFY(backUp(*m_project, now));
        const auto second = backUp(*m_project, now);
        QCOMPARE(second->file.filename().string(), std::string("lesson.odo.bak-20261120.100000.2"));
        QCOMPARE(second->made, now);
    }

    void thePreviewSaysWhatWouldChange()
    {
        std::filesystem::create_directories(folder() / "lesson.media");
        std::ofstream(folder() / "lesson.media" / "one.mkv") << "video";
        addTrial(*m_project, "deleted");
        const auto backup = backUp(*m_project, at(QStringLiteral("2026-11-20T10:00:00"))).value();
        const RecordId gone = m_project->trials().find("deleted")->id;
        QVERIFY(m_project->note(foreignWords("delete deleted"), [&]() -> Result<void> {
            ODO_TRY(m_project->trials().setBinned(gone, true));
            return m_project->trials().removeForGood(gone).map([](const auto &) {});
        }));
        addTrial(*m_project, "new");
        const ProjectState before = m_project->state().value();
        const auto preview = previewBackup(backup.file, *m_project);
        QVERIFY(preview);
        QCOMPARE(preview->title, std::string("Lesson"));
        QCOMPARE(preview->trialCount, std::size_t(2));
        QCOMPARE(preview->trialsLost, std::vector<std::string>{"new"});
        QCOMPARE(preview->trialsBack, std::vector<std::string>{"deleted"});
        QCOMPARE(preview->changesLost.size(), std::size_t(2));
        QCOMPARE(preview->changesLost.front().words.english(), std::string("import new"));
        QVERIFY(preview->changesBack.empty());
        QCOMPARE(preview->videosMissing, std::size_t(1));
        QVERIFY(m_project->state().value() == before); // looking changes nothing
    }

    void goingBackKeepsWhatWasThere()
    {
        const auto backup = backUp(*m_project, at(QStringLiteral("2026-11-20T10:00:00"))).value();
        addTrial(*m_project, "new");
        m_project.reset();
        const auto kept = goBackTo(backup.file, file(), at(QStringLiteral("2026-11-21T10:00:00")));
        QVERIFY(kept);
        m_project = Project::open(file(), Project::Access::ReadWrite).value();
        QCOMPARE(trialNames(), std::vector<std::string>{"one"});
        QCOMPARE(names(), (std::vector<std::string>{"lesson.odo.bak-20261121.100000",
                                                    "lesson.odo.bak-20261120.100000"}));
        // and forth again: the preview says what would come back
        const auto preview = previewBackup(*kept, *m_project);
        QCOMPARE(preview->trialsBack, std::vector<std::string>{"new"});
        QCOMPARE(preview->changesBack.size(), std::size_t(1));
        QVERIFY(preview->changesLost.empty());
        m_project.reset();
        QVERIFY(goBackTo(*kept, file(), at(QStringLiteral("2026-11-22T10:00:00"))));
        m_project = Project::open(file(), Project::Access::ReadWrite).value();
        QCOMPARE(trialNames(), (std::vector<std::string>{"new", "one"}));
    }

    void aDamagedBackupLeavesTheProject()
    {
        const auto backup = backUp(*m_project, at(QStringLiteral("2026-11-20T10:00:00"))).value();
        std::ofstream(backup.file, std::ios::trunc) << "torn";
        QVERIFY(!previewBackup(backup.file, *m_project));
        m_project.reset();
        const auto done = goBackTo(backup.file, file(), at(QStringLiteral("2026-11-21T10:00:00")));
        QVERIFY(!done);
        m_project = Project::open(file(), Project::Access::ReadWrite).value();
        QCOMPARE(trialNames(), std::vector<std::string>{"one"});
        QCOMPARE(names(), std::vector<std::string>{"lesson.odo.bak-20261120.100000"});
    }

    /// As one from before an update is.
    void aDamagedProjectIsRestoredFromOne()
    {
        const auto backup = backUp(*m_project, at(QStringLiteral("2026-11-20T10:00:00"))).value();
        QCOMPARE(soundBackupOf(file()), std::optional(backup.file));
    }

private:
    std::filesystem::path folder() const { return m_folder->path().toStdString(); }
    std::filesystem::path file() const { return folder() / "lesson.odo"; }
    /// As if the log had been written before.
    void hideLog() const
    {
        const std::filesystem::path log = folder() / "lesson.odo-wal";
        if (std::filesystem::exists(log))
            setLastWrite(log, at(QStringLiteral("2026-11-20T12:00:00")));
    }
    std::vector<std::string> names() const
    {
        std::vector<std::string> all;
        for (const ProjectBackup &backup : backupsOf(file()))
            all.push_back(backup.file.filename().string());
        return all;
    }
    std::vector<std::string> trialNames() const
    {
        std::vector<std::string> all;
        const std::vector<TrialName> trials = m_project->trials().names().value();
        for (const TrialName &trial : trials)
            all.push_back(trial.name);
        std::ranges::sort(all);
        return all;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestBackups, QCoreApplication)
#include "tst_backups.moc"
