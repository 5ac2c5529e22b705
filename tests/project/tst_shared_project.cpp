// SPDX-License-Identifier: GPL-3.0-or-later
// One project file and several that use it: threads of this process, other processes, and whoever moves the
// file.
#include "core/project/project.h"
#include "core/project/project_locks.h"
#include "core/project/project_rescue.h"
#include "core/project/repositories.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace odo;
using namespace odo::test;
using Access = Project::Access;
using std::chrono::milliseconds;
namespace fs = std::filesystem;

class TestSharedProject : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = folder() / "lesson.odo";
        m_project = std::move(*Project::create(m_file, "lesson"));
        QVERIFY(m_project->cameras().add({0, "A", ""}));
    }
    void cleanup() { m_project.reset(); }

    /// A descriptor of the file that anybody of this process closes, but for SQLite, takes all locks of the
    /// process with it.
    void whateverIsLookedAtTheLocksStay_data()
    {
        QTest::addColumn<std::function<void()>>("look");
        const auto row = [](const char *name, const std::function<void()> &look) {
            QTest::newRow(name) << look;
        };
        row("opened to read", [this] { QVERIFY(Project::open(m_file, Access::ReadOnly)); });
        row("opened to write", [this] { QVERIFY(Project::open(m_file, Access::ReadWrite)); });
        row("opened again", [this] { QVERIFY(Project::openAgain(m_file, Access::ReadOnly)); });
        row("opened again to write", [this] { QVERIFY(Project::openAgain(m_file, Access::ReadWrite)); });
        row("by another path", [this] {
            fs::create_symlink(m_file, folder() / "link.odo");
            QVERIFY(Project::open(folder() / "link.odo", Access::ReadOnly));
        });
        row("header", [this] { QVERIFY(Project::checkHeader(m_file)); });
        row("worth opening", [this] { QVERIFY(worthOpening(m_file)); });
        row("checked", [this] { QVERIFY(m_project->check(true)); });
        row("copied", [this] { QVERIFY(m_project->saveCopy(folder() / "copy.odo")); });
        row("written back", [this] { QVERIFY(m_project->writeBack()); });
    }
    void whateverIsLookedAtTheLocksStay()
    {
        QFETCH(std::function<void()>, look);
        QVERIFY(isLockedByThisProcess());
        look();
        QVERIFY(isLockedByThisProcess());
    }

    void whoeverOpensAFileOfItsOwnLosesThem() // what the test above would see
    {
        QFile file(QString::fromStdString(m_file.string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        file.close();
        QVERIFY(!isLockedByThisProcess());
    }

    void whatOthersChangeIsTold()
    {
        const ProjectState before = m_project->state().value();
        QCOMPARE(m_project->state().value(), before);
        QVERIFY(m_project->cameras().add({0, "B", ""}));
        const ProjectState own = m_project->state().value();
        QCOMPARE(own.byOthers, before.byOthers);
        QVERIFY(own.here != before.here);
        QCOMPARE(runProgram({QStringLiteral("camera"), QStringLiteral("add"), name(), QStringLiteral("C")})
                     .exitStatus,
                 0);
        const ProjectState after = m_project->state().value();
        QVERIFY(after.byOthers != own.byOthers);
        QCOMPARE(after.here, own.here);
        QVERIFY(m_project->cameras().find("C"));
    }

    void lookingChangesNothing()
    {
        const ProjectState before = m_project->state().value();
        QCOMPARE(runProgram({QStringLiteral("list"), name()}).exitStatus, 0);
        QCOMPARE(m_project->state().value(), before);
    }

    void whatIsWrittenBackIsInACopyOfTheFileAlone()
    {
        QVERIFY(m_project->setTitle("before"));
        QVERIFY(m_project->writeBack());
        fs::copy_file(m_file, folder() / "copy.odo");
        const auto copy = Project::open(folder() / "copy.odo", Access::ReadOnly);
        QVERIFY2(copy, copy ? "" : copy.error().message().c_str());
        QCOMPARE((*copy)->title().value(), std::string("before"));
    }

    void oneProcessWritesAtATime()
    {
        const auto turn = WriteTurn::of(m_file);
        int begun[2], end[2];
        QVERIFY(pipe(begun) == 0 && pipe(end) == 0);
        const pid_t child = fork();
        if (child == 0) {
            WriteTurn own(fs::canonical(m_file));
            const HeldTurn held(own);
            char byte = held.isHeld() ? 'y' : 'n';
            _exit(write(begun[1], &byte, 1) == 1 && read(end[0], &byte, 1) == 1 ? 0 : 1);
        }
        char byte = 0;
        QCOMPARE(read(begun[0], &byte, 1), ssize_t(1));
        QCOMPARE(byte, 'y');
        QVERIFY(!HeldTurn(*turn, milliseconds(30)).isHeld());
        QCOMPARE(kill(child, SIGKILL), 0); // however it ends
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        QVERIFY(HeldTurn(*turn, milliseconds(0)).isHeld());
        for (const int descriptor : {begun[0], begun[1], end[0], end[1]})
            close(descriptor);
    }

    void aWriterThatGoesOnTooLongIsSaid()
    {
        WriteTurn other(fs::canonical(m_file)); // as another process has it
        const HeldTurn held(other);
        const auto refused = m_project->setTitle("late");
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(), std::string("project 'lesson.odo': another program is writing to "
                                                        "it; close the other program and try again"));
        QCOMPARE(m_project->title().value(), std::string("lesson")); // reading goes on
    }

    void afterItsFileWasTakenAwayItIsRescued_data()
    {
        QTest::addColumn<std::function<void()>>("take");
        QTest::newRow("deleted") << std::function<void()>([this] { fs::remove(m_file); });
        QTest::newRow("renamed") << std::function<void()>(
            [this] { fs::rename(m_file, folder() / "other.odo"); });
        QTest::newRow("replaced") << std::function<void()>([this] {
            QVERIFY(Project::create(folder() / "new.odo", "another"));
            fs::rename(folder() / "new.odo", m_file);
        });
    }
    void afterItsFileWasTakenAwayItIsRescued()
    {
        QFETCH(std::function<void()>, take);
        QVERIFY(m_project->isInPlace());
        take();
        QVERIFY(!m_project->isInPlace());
        const auto refused = m_project->setTitle("nowhere");
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(),
                 std::string("project 'lesson.odo': its file was deleted, renamed or replaced while it was "
                             "open; nothing was stored; move it back to its folder and try again"));
        m_project->keepWritingWhenLost();
        QVERIFY(m_project->setTitle("afterwards"));
        const auto rescued = rescueProject(*m_project);
        QVERIFY2(rescued, rescued ? "" : rescued.error().message().c_str());
        QCOMPARE(*rescued, folder() / "lesson (rescued).odo");
        QCOMPARE(*rescueProject(*m_project), folder() / "lesson (rescued 2).odo");
        m_project.reset();
        const auto opened = Project::open(*rescued, Access::ReadOnly);
        QCOMPARE((*opened)->title().value(), std::string("afterwards"));
        QVERIFY((*opened)->cameras().find("A"));
        if (fs::exists(m_file)) { // is what took its place as it was?
            const auto another = Project::open(m_file, Access::ReadWrite);
            QVERIFY2(another, another ? "" : another.error().message().c_str());
            QCOMPARE((*another)->title().value(), std::string("another"));
            QVERIFY(!(*another)->cameras().find("A"));
        }
    }

    void whatIsCopiedOverItIsNeitherMixedNorChanged_data()
    {
        QTest::addColumn<bool>("hasLog");
        QTest::newRow("all of it in the file") << false;
        QTest::newRow("changes in the log") << true;
    }
    void whatIsCopiedOverItIsNeitherMixedNorChanged()
    {
        QFETCH(bool, hasLog);
        QVERIFY(m_project->setTitle("before"));
        if (!hasLog)
            QVERIFY(m_project->emptyLog());
        QVERIFY(!m_project->isOverwritten());
        QVERIFY(Project::create(folder() / "new.odo", "another"));
        fs::copy_file(folder() / "new.odo", m_file, fs::copy_options::overwrite_existing);
        QVERIFY(m_project->isInPlace()); // it is the same file for the system
        const auto refused = m_project->setTitle("afterwards");
        QVERIFY(!refused);
        QCOMPARE(refused.error().message(),
                 std::string("project 'lesson.odo': another program wrote over its file while it was open; "
                             "nothing more was stored; open it again; if you were recording, find stray "
                             "files (odograph check --adopt)"));
        QVERIFY(m_project->isOverwritten());
        QVERIFY(!m_project->writeBack());
        m_project.reset();
        const auto another = Project::open(m_file, Access::ReadWrite);
        QVERIFY2(another, another ? "" : another.error().message().c_str());
        QCOMPARE((*another)->title().value(), std::string("another"));
        QVERIFY(!(*another)->cameras().find("A"));
        QVERIFY((*another)->check(false)->empty());
        QVERIFY((*another)->setTitle("goes on"));
    }

    void whatSqliteWritesIsNotTakenForOverwriting()
    {
        const auto other = Project::open(m_file, Access::ReadWrite);
        for (int i = 0; i < 3; ++i) {
            QVERIFY(m_project->setTitle("one" + std::to_string(i)));
            QVERIFY(!(*other)->isOverwritten());
            QVERIFY((*other)->emptyLog());
            QVERIFY(!m_project->isOverwritten());
            QVERIFY((*other)->setTitle("two" + std::to_string(i)));
            QVERIFY(m_project->writeBack());
            QVERIFY(!(*other)->isOverwritten());
            fs::copy_file(m_file, folder() / "copy.odo", fs::copy_options::overwrite_existing);
            QVERIFY(!m_project->isOverwritten());
        }
    }

    void withItsFolderItIsRescuedWhereThatIsNow()
    {
        fs::create_directory(folder() / "first");
        m_file = folder() / "first" / "lesson.odo";
        m_project = std::move(*Project::create(m_file, "lesson"));
        QCOMPARE(m_project->currentLocation().value(), fs::canonical(m_file));
        fs::rename(folder() / "first", folder() / "second");
        QVERIFY(!m_project->isInPlace());
        QCOMPARE(*rescueProject(*m_project), fs::canonical(folder() / "second") / "lesson (rescued).odo");
    }

    /// As a teacher's folder is to a class.
    void aLogIsReadWhereNothingCanBeWritten()
    {
        if (geteuid() != 0)
            QSKIP("only root can become somebody who may not write here");
        QVERIFY(m_project->setTitle("in the log"));
        const fs::path shared = folder() / "shared";
        fs::create_directory(shared);
        for (const char *part : {"lesson.odo", "lesson.odo-wal"})
            fs::copy_file(folder() / part, shared / part);
        QCOMPARE(chmod(folder().c_str(), 0755), 0);
        const pid_t child = fork(); // which may, for this process has not opened that file
        if (child == 0) {
            const bool isNobody = setgid(65534) == 0 && setuid(65534) == 0;
            const auto other = Project::open(shared / "lesson.odo", Access::ReadOnly);
            _exit(isNobody && other && (*other)->title().value_or("") == "in the log" &&
                          (*other)->file() == shared / "lesson.odo"
                      ? 0
                      : 1);
        }
        int status = 1;
        QCOMPARE(waitpid(child, &status, 0), child);
        QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        QVERIFY(!fs::exists(shared / "lesson.odo-shm"));
    }

    void aBackupInTheMakingIsNotOffered()
    {
        QVERIFY(m_project->saveCopy(folder() / "lesson.odo.bak-3.new-77"));
        QVERIFY(!soundBackupOf(m_file));
        QVERIFY(m_project->saveCopy(folder() / "lesson.odo.bak-3.2"));
        QCOMPARE(soundBackupOf(m_file).value(), folder() / "lesson.odo.bak-3.2");
    }

private:
    fs::path folder() const { return m_folder->path().toStdString(); }
    QString name() const { return QString::fromStdString(m_file.string()); }

    /// Whether /proc/locks has a lock of this process on the file.
    bool isLockedByThisProcess() const
    {
        struct stat file
        {
        };
        if (stat(m_file.c_str(), &file) != 0)
            return false;
        QFile locks(QStringLiteral("/proc/locks"));
        if (!locks.open(QIODevice::ReadOnly))
            return false;
        const QByteArray inode = ':' + QByteArray::number(qulonglong(file.st_ino)),
                         process = QByteArray::number(getpid());
        for (const QByteArray &line : locks.readAll().split('\n')) {
            const QByteArrayList words = line.simplified().split(' ');
            if (words.size() > 5 && words[1] == "POSIX" && words[4] == process && words[5].endsWith(inode))
                return true;
        }
        return false;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    fs::path m_file;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestSharedProject, QCoreApplication)
#include "tst_shared_project.moc"
