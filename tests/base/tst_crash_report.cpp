// SPDX-License-Identifier: GPL-3.0-or-later
// What a crash leaves: child processes crash in several ways, and their reports are read.
#include "core/base/crash_report.h"

#include "core/base/platform/crash_handler.h"
#include "core/base/platform/user_folders.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <cstdlib>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace odo;

namespace {

/// Runs in a child process with the watch on; gives how that ended.
template <class Crash>
int inChild(const std::filesystem::path &folder, const Crash &crash)
{
    const pid_t child = fork();
    if (child == 0) {
        const rlimit none{0, 0};
        setrlimit(RLIMIT_CORE, &none);
        std::signal(SIGTERM, SIG_DFL); // not what QtTest makes of it
        if (!watchForCrashes(folder, "7.8.9"))
            _exit(99);
        crash();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

int endlessly(int depth);
int (*volatile again)(int) = endlessly; // the compiler must not see that this never ends

int endlessly(int depth)
{
    volatile char room[4096] = {};
    room[depth % 4096] = 1;
    return again(depth + 1) + room[0];
}

void readNothing()
{
    volatile int *volatile nothing = nullptr; // the compiler must not see that it is
    *nothing = 1;
}

QByteArray contentOf(const std::filesystem::path &file)
{
    QFile opened(QString::fromStdString(file.string()));
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

bool isSanitized()
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return true;
#else
    return false;
#endif
}

} // namespace

class TestCrashReport : public QObject
{
    Q_OBJECT
    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path folder() const
    {
        return m_folder->filePath(QStringLiteral("state/odograph")).toStdString();
    }
    QStringList left() const
    {
        return QDir(m_folder->filePath(QStringLiteral("state/odograph"))).entryList(QDir::Files);
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        if (isSanitized() && QByteArray(QTest::currentTestFunction()).startsWith("aCrash"))
            QSKIP("sanitizers report crashes themselves");
    }

    void aCrashLeavesAReport_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGSEGV") << SIGSEGV;
        QTest::newRow("SIGABRT") << SIGABRT;
        QTest::newRow("SIGFPE") << SIGFPE;
        QTest::newRow("SIGBUS") << SIGBUS;
        QTest::newRow("SIGILL") << SIGILL;
    }
    void aCrashLeavesAReport()
    {
        QFETCH(int, signal);
        const int status = inChild(folder(), [signal] {
            noteOpenProject("/home/somebody/first.odo");
            noteOpenProject("/home/somebody/lesson 9B.odo");
            raise(signal);
        });
        QVERIFY(WIFSIGNALED(status)); // the program ends as it would have without the watch
        QCOMPARE(WTERMSIG(status), signal);
        const std::vector<CrashReport> reports = newCrashReports(folder());
        QCOMPARE(reports.size(), std::size_t(1));
        QCOMPARE(reports[0].signal, std::string(QTest::currentDataTag()));
        QCOMPARE(reports[0].project, std::filesystem::path("/home/somebody/lesson 9B.odo"));
        const QByteArray text = contentOf(reports[0].file);
        QVERIFY2(text.startsWith("odograph 7.8.9 ended unexpectedly\nbegun: 20"), text.constData());
        QVERIFY2(text.contains("tests_base("), text.constData()); // frames of the backtrace, by their file
        QVERIFY(text.count('\n') > 8);
        QCOMPARE(std::filesystem::status(reports[0].file).permissions(),
                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    }
    void aCrashByMemoryIsReported()
    {
        QCOMPARE(WTERMSIG(inChild(folder(), readNothing)), SIGSEGV);
        const QByteArray text = contentOf(newCrashReports(folder()).at(0).file);
        QVERIFY2(text.contains("\nsignal: SIGSEGV\naddress: 0x0000000000000000\n"), text.constData());
        QVERIFY(!newCrashReports(folder()).at(0).project);
    }
    void aCrashOfAThreadIsReported()
    {
        QCOMPARE(WTERMSIG(inChild(folder(), [] { std::thread(readNothing).join(); })), SIGSEGV);
        QCOMPARE(newCrashReports(folder()).size(), std::size_t(1));
    }
    void aCrashByAFullStackIsReported()
    {
        QCOMPARE(WTERMSIG(inChild(folder(), [] { endlessly(0); })), SIGSEGV);
        QCOMPARE(newCrashReports(folder()).size(), std::size_t(1));
    }
    void aCrashOfSeveralThreadsGivesOneReport()
    {
        const int status = inChild(folder(), [] {
            std::vector<std::thread> threads;
            for (int i = 0; i < 8; ++i)
                threads.emplace_back(readNothing);
            for (std::thread &thread : threads)
                thread.join();
        });
        QCOMPARE(WTERMSIG(status), SIGSEGV);
        QCOMPARE(newCrashReports(folder()).size(), std::size_t(1));
    }
    void aGoodEndLeavesNothing()
    {
        if (isSanitized())
            QSKIP("nothing is watched");
        QCOMPARE(inChild(folder(), [] {}), 0);
        QCOMPARE(inChild(folder(), [] { std::exit(0); }), 0);
        QCOMPARE(WTERMSIG(inChild(folder(), [] { raise(SIGKILL); })), SIGKILL);
        QCOMPARE(WTERMSIG(inChild(folder(), [] { raise(SIGTERM); })), SIGTERM);
        QCOMPARE(left(), QStringList());
        QVERIFY(newCrashReports(folder() / "no such folder").empty());
    }
    void aFolderThatCannotBeWrittenToIsNoHindrance()
    {
        QFile file(m_folder->filePath(QStringLiteral("state")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(WEXITSTATUS(inChild(folder(), [] {})), 99);
        QVERIFY(!watchForCrashes({}, "7.8.9"));
    }
    void whatIsToldIsNotNewAndIsKeptForAWhile()
    {
        std::filesystem::create_directories(folder());
        const auto write = [this](const QString &name, const QByteArray &text) {
            QFile file(QString::fromStdString(folder().string()) + u'/' + name);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(text);
        };
        for (int day = 10; day < 25; ++day)
            write(QStringLiteral("crash-202611%1T120000Z-1.txt").arg(day), "odograph\nsignal: SIGSEGV\n");
        write(QStringLiteral("crash-20261201T120000Z-1.txt"), ""); // a crash while the disk was full
        write(QStringLiteral("crash-20261202T120000Z-1.txt"), QByteArray(2'000'000, 'x'));
        write(QStringLiteral("notes.txt"), "signal: SIGSEGV\n");
        const std::vector<CrashReport> reports = newCrashReports(folder());
        QCOMPARE(reports.size(), std::size_t(16));
        QVERIFY(reports[0].file.filename() == "crash-20261110T120000Z-1.txt" &&
                reports[0].signal == "SIGSEGV");
        QVERIFY(reports[15].signal.empty());
        for (const CrashReport &report : reports)
            QCOMPARE(keepShownReport(report).filename().string(), "told-" + report.file.filename().string());
        QVERIFY(newCrashReports(folder()).empty());
        QCOMPARE(left().filter(QStringLiteral("told-")).size(), 10);
        QVERIFY(left().contains(QStringLiteral("notes.txt")));
    }
    void theStateFolderFollowsTheDesktop()
    {
        const QByteArray state = qgetenv("XDG_STATE_HOME"), home = qgetenv("HOME");
        qputenv("XDG_STATE_HOME", "/somewhere/state");
        QCOMPARE(stateFolder(), std::filesystem::path("/somewhere/state/odograph"));
        qputenv("XDG_STATE_HOME", "relative"); // the specification: to be ignored
        qputenv("HOME", "/home/somebody");
        QCOMPARE(stateFolder(), std::filesystem::path("/home/somebody/.local/state/odograph"));
        qunsetenv("HOME");
        QCOMPARE(stateFolder(), std::filesystem::path());
        qputenv("XDG_STATE_HOME", state);
        qputenv("HOME", home);
    }
};

ODOGRAPH_TEST(TestCrashReport, QCoreApplication)
#include "tst_crash_report.moc"
