// SPDX-License-Identifier: GPL-3.0-or-later
// The log that a killed program left, and which file it is applied to.
#include "core/files/output_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/project/write_ahead_log.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>
#include <csignal>
#include <functional>
#include <map>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace odo;
using Access = Project::Access;
namespace fs = std::filesystem;

namespace {

using Change = std::function<void(Project &)>;

QByteArray bytesOf(const fs::path &file)
{
    QFile input(QString::fromStdString(file.string()));
    return input.open(QIODevice::ReadOnly) ? input.readAll() : QByteArray();
}

void write(const fs::path &file, const QByteArray &bytes)
{
    QFile output(QString::fromStdString(file.string()));
    QVERIFY(output.open(QIODevice::WriteOnly) && output.write(bytes) == bytes.size());
}

fs::path logOf(const fs::path &file)
{
    return besideFile(file, logSuffix);
}

void add(Project &project, const std::string &camera)
{
    if (!project.cameras().add({0, camera, ""}))
        qFatal("camera not added");
}

/// The names of the cameras; of a project that cannot be opened, why.
std::string camerasOf(const fs::path &file, Access access = Access::ReadWrite)
{
    const auto project = Project::open(file, access);
    if (!project)
        return project.error().message();
    const auto cameras = (*project)->cameras().all();
    if (!cameras)
        return cameras.error().message();
    std::string names;
    for (const CameraRecord &camera : *cameras)
        names += camera.name;
    return names;
}

void edit(const fs::path &file, const Change &change)
{
    const auto project = Project::open(file, Access::ReadWrite);
    QVERIFY2(project, project ? "" : project.error().message().c_str());
    change(**project);
}

pid_t inChild(const std::function<void()> &work)
{
    const pid_t child = fork();
    if (child == 0) {
        work();
        _exit(0);
    }
    return child;
}

/// As edit(), by a program that is killed before it closes the file.
void editAndBeKilled(const fs::path &file, const Change &change)
{
    const pid_t child = inChild([&] {
        edit(file, [&](Project &project) {
            change(project);
            ::kill(getpid(), SIGKILL);
        });
    });
    int status = 0;
    QCOMPARE(waitpid(child, &status, 0), child);
    QVERIFY(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
}

const char *const foreign = "project 'lesson.odo': the log beside it ('lesson.odo-wal') belongs to another "
                            "file or to another state of this one; move the log to another folder to open "
                            "the file without it, or restore the file that the log belongs to";

} // namespace

class TestLogMark : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = folder() / "lesson.odo";
        QVERIFY(Project::create(m_file, "lesson"));
        edit(m_file, [](Project &project) { add(project, "A"); });
    }

    void itsOwnLogIsApplied_data()
    {
        QTest::addColumn<Access>("access");
        QTest::newRow("to write") << Access::ReadWrite;
        QTest::newRow("to read") << Access::ReadOnly;
    }
    void itsOwnLogIsApplied()
    {
        QFETCH(Access, access);
        editAndBeKilled(m_file, [](Project &project) { add(project, "B"), add(project, "C"); });
        QCOMPARE(camerasOf(m_file, access), std::string("ABC"));
    }

    void noneIsAppliedToAnOlderBackup()
    {
        fs::copy_file(m_file, folder() / "backup.odo");
        edit(m_file, [](Project &project) { add(project, "B"); });
        editAndBeKilled(m_file, [](Project &project) { add(project, "C"); });
        fs::rename(m_file, folder() / "kept.odo");
        fs::copy_file(folder() / "backup.odo", m_file);
        isRefusedUntilTheLogIsMoved("A");
        if (QTest::currentTestFailed())
            return;

        fs::rename(folder() / "kept.odo", m_file);
        fs::rename(folder() / "moved", logOf(m_file));
        QCOMPARE(camerasOf(m_file), std::string("ABC"));
    }

    void noneIsAppliedToAnotherProject()
    {
        QVERIFY(Project::create(folder() / "other.odo", "other"));
        edit(folder() / "other.odo", [](Project &project) { add(project, "X"); });
        editAndBeKilled(m_file, [](Project &project) { add(project, "B"); });
        fs::rename(folder() / "other.odo", m_file);
        isRefusedUntilTheLogIsMoved("X");
    }

    void noneOfASingleStatementIs()
    {
        fs::copy_file(m_file, folder() / "backup.odo");
        edit(m_file, [](Project &project) { add(project, "B"); });
        editAndBeKilled(m_file, [](Project &project) {
            if (!project.cameras().setDevice(1, "usb:1"))
                qFatal("no device set");
        });
        fs::rename(folder() / "backup.odo", m_file);
        isRefusedUntilTheLogIsMoved("A");
    }

    /// Both were changed equally often: only the marks tell them apart.
    void noneIsAppliedToACopyThatWentAnotherWay_data()
    {
        QTest::addColumn<int>("changes");
        for (const int changes : {0, 1, 2})
            QTest::addRow("%d changes after the copy", changes) << changes;
    }
    void noneIsAppliedToACopyThatWentAnotherWay()
    {
        QFETCH(int, changes);
        fs::copy_file(m_file, folder() / "copy.odo");
        const auto change = [changes](Project &project, char first) {
            for (int i = 0; i < changes; ++i)
                add(project, std::string(1, static_cast<char>(first + i)));
        };
        edit(m_file, [&](Project &project) { change(project, 'B'); });
        edit(folder() / "copy.odo", [&](Project &project) { change(project, 'K'); });
        const auto last = [](Project &project) { add(project, "P"), add(project, "Q"); };
        if (changes > 0)
            editAndBeKilled(m_file, last);
        else { // both begin with the same state
            editAndBeKilled(m_file, last);
            edit(folder() / "copy.odo", [](Project &project) { add(project, "S"); });
        }
        fs::rename(folder() / "copy.odo", m_file);
        isRefusedUntilTheLogIsMoved(changes == 0 ? "AS" : changes == 1 ? "AK" : "AKL");
    }

    void noneIsAppliedToACopyByTheProgram()
    {
        editAndBeKilled(m_file, [this](Project &project) {
            add(project, "B");
            if (!project.saveCopy(folder() / "copy.odo"))
                qFatal("no copy");
        });
        fs::rename(folder() / "copy.odo", m_file);
        isRefusedUntilTheLogIsMoved("AB");
    }

    /// A log that was moved away and comes back after the file went on without it.
    void noneIsAppliedToWhatTheFileBecameWithoutIt()
    {
        editAndBeKilled(m_file, [](Project &project) { add(project, "B"); });
        fs::rename(logOf(m_file), folder() / "moved");
        edit(m_file, [](Project &project) { add(project, "Y"); });
        fs::rename(folder() / "moved", logOf(m_file));
        isRefusedUntilTheLogIsMoved("AY");
    }

    void whatWasWrittenBackInPartIsCompleted()
    {
        editAndBeKilled(m_file, [this](Project &project) {
            add(project, "B");
            sqlite3 *reader = nullptr; // keeps what is added later from being written back
            if (sqlite3_open(m_file.c_str(), &reader) != SQLITE_OK ||
                sqlite3_exec(reader, "BEGIN; SELECT * FROM camera", nullptr, nullptr, nullptr) != SQLITE_OK)
                qFatal("not read");
            add(project, "C");
            if (project.writeBack())
                qFatal("all was written back");
        });
        QCOMPARE(camerasOf(m_file, Access::ReadOnly), std::string("ABC"));
        QCOMPARE(camerasOf(m_file), std::string("ABC"));
    }

    void afterWritingBackTheNextLogBelongsToo()
    {
        editAndBeKilled(m_file, [](Project &project) {
            for (const char *camera : {"B", "C", "D"}) {
                add(project, camera);
                if (!project.writeBack())
                    qFatal("not written back");
            }
            add(project, "E");
        });
        QCOMPARE(camerasOf(m_file), std::string("ABCDE"));
    }

    /// SQLite writes pages back in the order of their numbers.
    void killedAtAnyPageThatIsWrittenBack()
    {
        editAndBeKilled(m_file, [](Project &project) { add(project, "B"), add(project, "C"); });
        const QByteArray log = bytesOf(logOf(m_file));
        QByteArray file = bytesOf(m_file);
        constexpr qsizetype headerBytes = 32, pageBytes = 4096, frameBytes = 24 + pageBytes;
        std::map<quint32, QByteArray> pages;
        for (qsizetype at = headerBytes; at + frameBytes <= log.size(); at += frameBytes)
            pages[qFromBigEndian<quint32>(log.constData() + at)] = log.mid(at + 24, pageBytes);
        QVERIFY(pages.size() > 2 && pages.contains(1));
        for (const auto &[number, page] : pages) {
            const qsizetype at = qsizetype(number - 1) * pageBytes;
            file = file.leftJustified(std::max(file.size(), at + pageBytes), '\0');
            file.replace(at, pageBytes, page);
            const fs::path killed = folder() / "killed.odo";
            write(killed, file);
            write(logOf(killed), log);
            QCOMPARE(camerasOf(killed), std::string("ABC"));
        }
    }

    /// What SQLite would not apply does no harm to any file.
    void aLogWithoutACommitIsNoReason()
    {
        QVERIFY(Project::create(folder() / "other.odo", "other"));
        editAndBeKilled(m_file, [](Project &project) { add(project, "B"); });
        const QByteArray log = bytesOf(logOf(m_file));
        fs::rename(folder() / "other.odo", m_file);
        for (const qsizetype bytes : {qsizetype(0), qsizetype(31), qsizetype(32), qsizetype(32 + 24 + 100),
                                      qsizetype(32 + 24 + 4096)}) {
            write(logOf(m_file), log.first(bytes));
            QVERIFY(checkLog(m_file));
        }
        QByteArray damaged = log; // in its first page: all that follows counts for nothing
        damaged[32 + 24 + 60] = static_cast<char>(damaged[32 + 24 + 60] + 1);
        write(logOf(m_file), damaged);
        QVERIFY(checkLog(m_file));
        QCOMPARE(camerasOf(m_file), std::string());
    }

    /// As an older Odograph left them.
    void aLogWithoutMarksIsApplied()
    {
        const auto change = [this](const char *sql) {
            const pid_t child = inChild([&] {
                sqlite3 *database = nullptr;
                if (sqlite3_open(m_file.c_str(), &database) == SQLITE_OK &&
                    sqlite3_exec(database, sql, nullptr, nullptr, nullptr) == SQLITE_OK)
                    ::kill(getpid(), SIGKILL);
            });
            int status = 0;
            QCOMPARE(waitpid(child, &status, 0), child);
            QVERIFY(WIFSIGNALED(status));
        };
        change("UPDATE camera SET name='B'");
        QCOMPARE(camerasOf(m_file), std::string("B"));
        change("PRAGMA default_cache_size=0; PRAGMA wal_checkpoint; UPDATE camera SET name='C'; PRAGMA "
               "user_version=21");
        QCOMPARE(camerasOf(m_file), std::string("C"));
        change("UPDATE camera SET name='D'; PRAGMA user_version=21");
        QCOMPARE(camerasOf(m_file, Access::ReadOnly), std::string("D"));
        editAndBeKilled(m_file, [](Project &project) { add(project, "E"); });
        QCOMPARE(camerasOf(m_file), std::string("DE"));
    }

    /// Neither SQLite's writing nor its writing back makes a sound project look otherwise.
    void twoThatWriteAreNeverInTheWay()
    {
        constexpr int each = 60;
        std::vector<pid_t> writers;
        for (const char *name : {"B", "C"})
            writers.push_back(inChild([&] {
                for (int i = 0; i < each; ++i) {
                    const pid_t killed = inChild([&] {
                        static_cast<void>(Project::open(m_file, Access::ReadWrite).value()->writeBack());
                    });
                    usleep(static_cast<useconds_t>(200 * i)); // at any moment
                    ::kill(killed, SIGKILL);
                    waitpid(killed, nullptr, 0);
                    const auto project = Project::open(m_file, Access::ReadWrite);
                    if (!project)
                        _exit(1);
                    add(**project, name + std::to_string(i));
                    (*project)->writeBack();
                    add(**project, name + std::to_string(i) + "x");
                }
            }));
        int looks = 0;
        for (const pid_t writer : writers) {
            int status = 0;
            while (waitpid(writer, &status, WNOHANG) == 0) {
                const auto own = checkLog(m_file);
                QVERIFY2(own, own ? "" : own.error().message().c_str());
                if (++looks % 100 == 0)
                    QVERIFY(Project::open(m_file, looks % 200 == 0 ? Access::ReadOnly : Access::ReadWrite));
            }
            QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        }
        qInfo("%d looks", looks);
        const auto project = Project::open(m_file, Access::ReadOnly);
        QCOMPARE(project.value()->cameras().all().value().size(), std::size_t(1 + 2 * 2 * each));
    }

    void noProjectIsMadeBesideALogOrJournal_data()
    {
        QTest::addColumn<QString>("suffix");
        QTest::newRow("log") << QStringLiteral("-wal");
        QTest::newRow("journal") << QStringLiteral("-journal");
    }
    void noProjectIsMadeBesideALogOrJournal()
    {
        QFETCH(QString, suffix);
        const fs::path fresh = folder() / "new.odo", side = besideFile(fresh, suffix.toStdString());
        write(side, "left");
        const auto refused = Project::create(fresh, "new");
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::AlreadyExists);
        const std::string left = "new.odo" + suffix.toStdString();
        QCOMPARE(refused.error().message(),
                 "project '" + fresh.string() + "': its folder has '" + left +
                     "', the log or journal of another file of this name; choose another name, or move '" +
                     left + "' to another folder first");
        QVERIFY(!fs::exists(fresh));
        QCOMPARE(bytesOf(side), QByteArray("left"));

        fs::remove(side);
        fs::create_symlink(folder() / "elsewhere", side);
        QVERIFY(!Project::create(fresh, "new"));
        fs::remove(side);
        write(side, {}); // nothing is in it
        QVERIFY(Project::create(fresh, "new"));
    }

private:
    fs::path folder() const { return m_folder->path().toStdString(); }

    void isRefusedUntilTheLogIsMoved(const std::string &cameras)
    {
        const QByteArray file = bytesOf(m_file), log = bytesOf(logOf(m_file));
        for (const Access access : {Access::ReadOnly, Access::ReadWrite}) {
            QCOMPARE(camerasOf(m_file, access), std::string(foreign));
            QCOMPARE(bytesOf(m_file), file);
            QCOMPARE(bytesOf(logOf(m_file)), log);
        }
        fs::rename(logOf(m_file), folder() / "moved");
        fs::copy_file(m_file, folder() / "without.odo");
        QCOMPARE(camerasOf(folder() / "without.odo"), cameras);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    fs::path m_file;
};

ODOGRAPH_TEST(TestLogMark, QCoreApplication)
#include "tst_log_mark.moc"
