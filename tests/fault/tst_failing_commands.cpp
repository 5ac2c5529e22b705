// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own words and exit status where a call on the disk fails: never "done" with a file that is
// not whole, one line of error otherwise, and the project as it was or with the whole change.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/video/video_reader.h"
#include "tests/fault/folder_content.h"
#include "tests/fault/injected_fault.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cerrno>
#include <csignal>

using namespace odo;
using namespace odo::test;

namespace fs = std::filesystem;

class TestFailingCommands : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void sayWhatDidNotArrive_data();
    void sayWhatDidNotArrive();
    void anAnswerThatCannotBePrintedIsAnError();

private:
    QStringList problemsOf(const QString &line, const QString &output, const Fault &fault);
    QString problemOf(const Attempt &attempt, const ProgramRun &run, const QString &output) const;
    bool isWhole(const QString &output) const;
    QByteArray content(const QString &name) const
    {
        QFile file(QString::fromStdString((m_work / name.toStdString()).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QStringList argumentsOf(const QString &line) const;

    QTemporaryDir m_place{quickFolder()};
    const fs::path m_base = fs::path(m_place.path().toStdString()) / "base";
    const fs::path m_work = fs::path(m_place.path().toStdString()) / "work";
    QByteArray m_whole; ///< what the command writes where nothing fails
    QStringList m_rowsBefore, m_rowsAfter;
    int m_attempts = 0;
};

namespace {

const QString project = QStringLiteral("example.odo");

/// "odograph: WHAT: WHY; DO THIS", once.
bool isOneLine(const QByteArray &words)
{
    return words.startsWith("odograph: ") && words.count('\n') == 1 && words.count(": ") >= 2 &&
           words.contains("; ");
}

/// Of a PDF file.
QByteArray wordsOf(const fs::path &pages)
{
    QProcess reader;
    reader.start(QStringLiteral("pdftotext"), {QString::fromStdString(pages.string()), QStringLiteral("-")});
    return reader.waitForFinished() ? reader.readAllStandardOutput() : QByteArray();
}

std::size_t framesOf(const fs::path &video)
{
    const auto reader = VideoReader::open(video);
    return reader ? (*reader)->info().frameTimes.size() : 0;
}

} // namespace

void TestFailingCommands::initTestCase()
{
    fs::create_directories(m_base);
    const auto made = storeExample(m_base);
    QVERIFY2(made, made ? "" : made.error().message().c_str());
}

QStringList TestFailingCommands::argumentsOf(const QString &line) const
{
    QStringList arguments = line.split(u'|');
    for (QString &argument : arguments)
        argument.replace(QStringLiteral("%F"), QString::fromStdString(m_work.string()));
    return arguments;
}

void TestFailingCommands::sayWhatDidNotArrive_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("output");
    QTest::newRow("robot add") << QStringLiteral("robot|add|%F/example.odo|Green 3|--colour|#00ff00")
                               << QString();
    QTest::newRow("new") << QStringLiteral("new|%F/new.odo") << QStringLiteral("new.odo");
    QTest::newRow("csv") << QStringLiteral("export|%F/example.odo|Trial 1|-o|%F/out.csv")
                         << QStringLiteral("out.csv");
    QTest::newRow("json") << QStringLiteral("export|%F/example.odo|Trial 2|--format|json|-o|%F/out.json")
                          << QStringLiteral("out.json");
    QTest::newRow("report") << QStringLiteral("report|%F/example.odo|Trial 1|-o|%F/out.pdf")
                            << QStringLiteral("out.pdf");
    QTest::newRow("target") << QStringLiteral("target|tags|-o|%F/markers.pdf")
                            << QStringLiteral("markers.pdf");
    QTest::newRow("snapshot") << QStringLiteral("snapshot|%F/example.odo|Trial 1|-o|%F/out.png")
                              << QStringLiteral("out.png");
    QTest::newRow("video") << QStringLiteral(
                                  "export|%F/example.odo|Trial 1|--format|video|--size|320x180|-o|%F/out.mkv")
                           << QStringLiteral("out.mkv");
}

void TestFailingCommands::sayWhatDidNotArrive()
{
    QFETCH(QString, line);
    QFETCH(QString, output);
    copyFolder(m_base, m_work);
    m_rowsBefore = contentOf(m_work)[project];
    const ProgramRun done = runProgram(argumentsOf(line));
    QVERIFY2(done.exitStatus == 0, done.err.constData());
    m_rowsAfter = contentOf(m_work)[project];
    m_whole = content(output);
    QVERIFY(output.isEmpty() || isWhole(output));
    m_attempts = 0;
    QStringList problems;
    for (const Fault &fault : allFaults()) {
        const bool isSampled =
            fault.how == FailingCalls::How::FromThenOn ? fault.error == ENOSPC : fault.error == EIO;
        if (isWholeSweep() || isSampled)
            problems << problemsOf(line, output, fault);
    }
    qInfo("%d attempts", m_attempts);
    QVERIFY2(problems.isEmpty(), qPrintable(QStringLiteral("%1 problems:\n").arg(problems.size()) +
                                            problems.mid(0, 12).join(u'\n')));
}

QStringList TestFailingCommands::problemsOf(const QString &line, const QString &output, const Fault &fault)
{
    const int sampled = isWholeSweep() ? 60 : 3; // the program needs some time to start
    copyFolder(m_base, m_work);
    ProgramRun run;
    const Attempt counted = attemptProgram(m_work, fault, 0, argumentsOf(line), &run);
    if (counted.died() || run.exitStatus != 0 || counted.calls == 0)
        return {QStringLiteral("without a fault: ") + counted.words() + QString::fromUtf8(run.err)};
    QStringList problems;
    for (const int nth : spreadCalls(counted.calls, sampled)) {
        copyFolder(m_base, m_work);
        const Attempt tried = attemptProgram(m_work, fault, nth, argumentsOf(line), &run);
        ++m_attempts;
        if (const QString problem = problemOf(tried, run, output); !problem.isEmpty())
            problems << problem + QStringLiteral(" after ") + tried.words() + QStringLiteral(": ") +
                            QString::fromUtf8(run.err);
    }
    return problems;
}

QString TestFailingCommands::problemOf(const Attempt &attempt, const ProgramRun &run,
                                       const QString &output) const
{
    const bool wasKilled = attempt.fault.kills() && attempt.reached;
    if (attempt.signal != (wasKilled ? SIGKILL : 0))
        return QStringLiteral("ended by signal %1").arg(attempt.signal);
    if (run.exitStatus > 0 && !isOneLine(run.err))
        return QStringLiteral("it does not say so in one line");
    const bool isThere = fs::exists(m_work / output.toStdString()) && !output.isEmpty();
    if (isThere && !isWhole(output))
        return QStringLiteral("'%1' is not whole, exit status %2").arg(output).arg(run.exitStatus);
    if (!isThere && !output.isEmpty() && run.exitStatus == 0)
        return QStringLiteral("'%1' is not there").arg(output);
    {
        const auto opened = Project::open(m_work / project.toStdString(), Project::Access::ReadWrite);
        if (!opened)
            return QString::fromStdString(opened.error().message());
    }
    const QStringList rows = contentOf(m_work)[project];
    if (rows != m_rowsAfter && (run.exitStatus == 0 || rows != m_rowsBefore))
        return QStringLiteral("the project is neither as before nor as after");
    return {};
}

/// What a command writes is the same each time but for moments in it.
bool TestFailingCommands::isWhole(const QString &output) const
{
    const QByteArray found = content(output);
    if (output.endsWith(QStringLiteral(".odo")))
        return Project::open(m_work / output.toStdString(), Project::Access::ReadWrite).has_value();
    if (output.endsWith(QStringLiteral(".pdf"))) {
        if (!found.startsWith("%PDF") || !found.trimmed().endsWith("%%EOF"))
            return false;
        return std::abs(found.size() - m_whole.size()) < 200 ||
               wordsOf(m_work / output.toStdString()).contains("the video cannot be read");
    }
    if (output.endsWith(QStringLiteral(".png")))
        // what it shows may tell of the fault
        return found.startsWith("\x89PNG") && found.right(12).contains("IEND");
    if (output.endsWith(QStringLiteral(".mkv")))
        return framesOf(m_work / output.toStdString()) == 30;
    return found == m_whole;
}

void TestFailingCommands::anAnswerThatCannotBePrintedIsAnError()
{
    if (!QFile::exists(QStringLiteral("/dev/full")))
        QSKIP("there is no /dev/full here");
    copyFolder(m_base, m_work);
    const ProgramRun run =
        runCommand(QStringLiteral("sh"),
                   {QStringLiteral("-c"), QStringLiteral("exec \"$0\" list \"$1\" --json > /dev/full"),
                    qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                    QString::fromStdString((m_work / "example.odo").string())});
    QCOMPARE(run.exitStatus, 1);
    QCOMPARE(
        run.err,
        QByteArray("odograph: the output: it could not be written (No space left on device); the command "
                   "succeeded; free some disk space and repeat it\n"));
}

ODOGRAPH_TEST(TestFailingCommands, QCoreApplication)
#include "tst_failing_commands.moc"
