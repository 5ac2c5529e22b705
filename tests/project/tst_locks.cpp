// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_locks.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace odo;
using Afterwards = HeldFile::Afterwards;

class TestLocks : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void oneHoldsIt()
    {
        const auto first = HeldFile::take(file(), Afterwards::Goes, "anna on pc7");
        QVERIFY(first && *first);
        QVERIFY(HeldFile::isHeld(file()));
        QCOMPARE(HeldFile::wordsOf(file()), std::string("anna on pc7"));
        const auto second = HeldFile::take(file(), Afterwards::Goes, "ben");
        QVERIFY(second && !*second);
        QCOMPARE(HeldFile::wordsOf(file()), std::string("anna on pc7"));
    }

    void givenUpItIsFree()
    {
        for (const Afterwards afterwards : {Afterwards::Stays, Afterwards::Goes}) {
            QVERIFY(HeldFile::take(file(), afterwards, "a long story").value() != nullptr);
            QVERIFY(!HeldFile::isHeld(file()));
            QCOMPARE(std::filesystem::exists(file()), afterwards == Afterwards::Stays);
            const auto again = HeldFile::take(file(), Afterwards::Goes, "b");
            QVERIFY(again && *again);
            QCOMPARE(HeldFile::wordsOf(file()), std::string("b"));
        }
    }

    /// Its file is left behind, and means nothing.
    void aProgramThatIsKilledHoldsNothing()
    {
        const pid_t child = fork();
        if (child == 0) {
            const auto held = HeldFile::take(file(), Afterwards::Goes, "dead");
            _exit(held && *held ? 0 : 1);
        }
        int status = 1;
        QCOMPARE(waitpid(child, &status, 0), child);
        QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        QVERIFY(std::filesystem::exists(file()));
        QVERIFY(!HeldFile::isHeld(file()));
        QVERIFY(HeldFile::take(file(), Afterwards::Goes).value() != nullptr);
    }

    /// What lies in a project's folder may come from anyone.
    void itIsNeverHeldThroughALink()
    {
        const std::filesystem::path own = file().string() + ".own";
        QFile other(QString::fromStdString(own.string()));
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("somebody's own") > 0);
        other.close();
        std::filesystem::create_symlink(own, file());
        const auto refused = HeldFile::take(file(), Afterwards::Goes, "anna");
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::Io);
        QVERIFY(other.open(QIODevice::ReadOnly));
        QCOMPARE(other.readAll(), QByteArray("somebody's own"));
    }

    /// It is held all the same, without a word.
    void whatIsNotItsOwnIsNotWrittenTo_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<bool>("hasMoreNames");
        QTest::newRow("somebody's notes") << QByteArray("Dear Anna,\nthis is no lock\n") << false;
        QTest::newRow("a hard link to notes") << QByteArray("Dear Anna,\nthis is no lock\n") << true;
        QTest::newRow("a hard link to an empty file") << QByteArray() << true;
        QTest::newRow("a hard link to another lock") << QByteArray("ben on pc8\nlock of Odograph\n") << true;
        QTest::newRow("much") << QByteArray(1'000'000, 'x') << false;
    }
    void whatIsNotItsOwnIsNotWrittenTo()
    {
        QFETCH(QByteArray, content);
        QFETCH(bool, hasMoreNames);
        QFile::remove(QString::fromStdString(file().string()));
        const std::filesystem::path own = file().string() + ".own";
        std::filesystem::remove(own);
        QFile lock(QString::fromStdString(file().string()));
        QVERIFY(lock.open(QIODevice::WriteOnly) && lock.write(content) == content.size());
        lock.close();
        if (hasMoreNames)
            std::filesystem::create_hard_link(file(), own);
        for (const Afterwards afterwards : {Afterwards::Stays, Afterwards::Goes}) {
            const auto held = HeldFile::take(file(), afterwards, "anna");
            QVERIFY(held && *held);
            QVERIFY(HeldFile::isHeld(file()));
            QVERIFY(HeldFile::take(file(), afterwards, "ben").value() == nullptr);
        }
        QVERIFY(lock.open(QIODevice::ReadOnly));
        QCOMPARE(lock.readAll(), content);
        lock.close();
        std::filesystem::remove(file());
        std::filesystem::remove(own);
    }

    void whatItSaysIsOneShortLine()
    {
        QFile lock(QString::fromStdString(file().string()));
        QVERIFY(lock.open(QIODevice::WriteOnly) && lock.write(QByteArray(1'000'000, 'x')) > 0);
        lock.close();
        QCOMPARE(HeldFile::wordsOf(file()), std::string());
        QVERIFY(lock.open(QIODevice::WriteOnly) && lock.write("anna\nand more") > 0);
        lock.close();
        QCOMPARE(HeldFile::wordsOf(file()), std::string());
        std::filesystem::remove(file());
        QCOMPARE(mkfifo(file().c_str(), 0600), 0); // reading it would wait for ever
        QCOMPARE(HeldFile::wordsOf(file()), std::string());
        QVERIFY(!HeldFile::isHeld(file()));
    }

    void aFolderThatIsNotThereIsSaid()
    {
        const auto refused = HeldFile::take("/no/such/folder/file", Afterwards::Goes);
        QCOMPARE(refused.error().code, ErrorCode::Io);
        QCOMPARE(refused.error().message(),
                 std::string("cannot hold /no/such/folder/file: No such file or directory; check the free "
                             "space and the permissions of its folder"));
    }

    void oneTrialIsRecordedAtATime()
    {
        const std::filesystem::path media = m_folder.filePath(QStringLiteral("p.media")).toStdString();
        QVERIFY(!RecordingLock::isHeld(media));
        const auto lock = RecordingLock::take(media);
        QVERIFY(lock && RecordingLock::isHeld(media));
        QVERIFY(RecordingLock::take(media).error().message().find(
                    "a trial is being recorded into it now; wait until that has ended") != std::string::npos);
    }

    void oneWindowChangesAProject()
    {
        const QString project = m_folder.filePath(QStringLiteral("lesson.odo"));
        QVERIFY(QFile(project).open(QIODevice::WriteOnly));
        const QString other = m_folder.filePath(QStringLiteral("other.odo")); // another way to the same file
        QVERIFY(QFile::link(project, other));
        auto lock = WindowLock::take(project.toStdString());
        QVERIFY(lock.has_value());
        const auto refused = WindowLock::take(other.toStdString());
        QCOMPARE(refused.error().code, ErrorCode::AlreadyExists);
        QCOMPARE(refused.error().why.code(), std::string_view("project.open_elsewhere_by"));
        lock->reset();
        QVERIFY(WindowLock::take(other.toStdString()).has_value());
        QVERIFY(!QFile::exists(project + QStringLiteral(".lock")));
    }

private:
    std::filesystem::path file() const { return m_folder.filePath(QStringLiteral("held")).toStdString(); }
    QTemporaryDir m_folder;
};

ODOGRAPH_TEST(TestLocks, QCoreApplication)
#include "tst_locks.moc"
