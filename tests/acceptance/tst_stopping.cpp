// SPDX-License-Identifier: GPL-3.0-or-later
// What SIGTERM, Ctrl-C and SIGHUP do to a subcommand: a recording ends and is kept, everything else stops and
// leaves the project as it was.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/noise_clip.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

using namespace odo;
using namespace odo::test;

class TestStopping : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void aRecordingIsKept_data();
    void aRecordingIsKept();
    void beforeAPictureNothingIsLeft();
    void asJsonToo();
    void anImportLeavesNothing_data();
    void anImportLeavesNothing();
    void theCommandIsNamed();
    void theSecondInterruptEndsAtOnce();
    void aWindowEndsAsIfClosed_data();
    void aWindowEndsAsIfClosed();

private:
    QString path(const char *name) const { return m_folder->filePath(QString::fromLatin1(name)); }
    void begin(const QStringList &arguments);
    void beginRecording(const QStringList &more = {});
    void signal(int number) const { ::kill(static_cast<pid_t>(m_program->processId()), number); }
    /// Its exit status.
    int end(int withinMs = 20'000);

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<QProcess> m_program;
};

void TestStopping::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QCOMPARE(runProgram({QStringLiteral("new"), path("p.odo")}).exitStatus, 0);
}

void TestStopping::begin(const QStringList &arguments)
{
    m_program = std::make_unique<QProcess>();
    m_program->start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), arguments);
    QVERIFY(m_program->waitForStarted());
}

/// Returns when pictures are on the disk.
void TestStopping::beginRecording(const QStringList &more)
{
    begin(QStringList{QStringLiteral("record"), path("p.odo"), QStringLiteral("--trial"),
                      QStringLiteral("run"), QStringLiteral("--camera"), QStringLiteral("A=sim:A"),
                      QStringLiteral("--seconds"), QStringLiteral("60")} +
          more);
    const QString video = path("p.media/run_A.mkv");
    QVERIFY(QTest::qWaitFor([&] { return QFileInfo(video).size() > 50'000; }, 30'000));
}

int TestStopping::end(int withinMs)
{
    if (!m_program->waitForFinished(withinMs)) {
        m_program->kill();
        m_program->waitForFinished();
        return -1;
    }
    return m_program->exitStatus() == QProcess::NormalExit ? m_program->exitCode() : -2;
}

void TestStopping::aRecordingIsKept_data()
{
    QTest::addColumn<int>("number");
    QTest::addColumn<int>("status");
    QTest::newRow("SIGINT") << SIGINT << 130;
    QTest::newRow("SIGTERM") << SIGTERM << 143;
    QTest::newRow("SIGHUP") << SIGHUP << 129;
}

void TestStopping::aRecordingIsKept()
{
    QFETCH(int, number);
    QFETCH(int, status);
    beginRecording();
    signal(number);
    QCOMPARE(end(), status);
    const QByteArray words = m_program->readAllStandardOutput(), error = m_program->readAllStandardError();
    QVERIFY2(words.startsWith("Trial run recorded: "), words);
    QCOMPARE(error, QByteArray("odograph: recording of trial 'run': it was stopped early; "
                               "what was recorded until then is kept\n"));
    const auto project = Project::open(path("p.odo").toStdString(), Project::Access::ReadOnly);
    const auto trial = (*project)->trials().find("run");
    QVERIFY(trial && !trial->unfinished);
    const auto recordings = (*project)->trials().recordings(trial->id);
    QCOMPARE(recordings->size(), std::size_t(1));
    QVERIFY(playsWholly((*project)->resolve(recordings->front()), recordings->front().frameTimes.size()));
    QVERIFY((*project)->check(true)->empty());
}

void TestStopping::beforeAPictureNothingIsLeft()
{
    begin({QStringLiteral("record"), path("p.odo"), QStringLiteral("--trial"), QStringLiteral("run"),
           QStringLiteral("--camera"), QStringLiteral("A=sim:A"), QStringLiteral("--pre-roll"),
           QStringLiteral("10")});
    QVERIFY(QTest::qWaitFor([&] { return QFileInfo::exists(path("p.odo-wal")); }, 30'000));
    signal(SIGTERM);
    QCOMPARE(end(), 143);
    QVERIFY(!QFileInfo::exists(path("p.media/run_A.mkv")));
    const auto project = Project::open(path("p.odo").toStdString(), Project::Access::ReadOnly);
    QVERIFY((*project)->trials().all()->empty());
}

void TestStopping::asJsonToo()
{
    beginRecording({QStringLiteral("--json")});
    signal(SIGTERM);
    QCOMPARE(end(), 143);
    const QJsonObject answer = QJsonDocument::fromJson(m_program->readAllStandardOutput()).object();
    QCOMPARE(answer.value(QStringLiteral("trial")).toString(), QStringLiteral("run"));
    QVERIFY(answer.value(QStringLiteral("duration_s")).toDouble() > 0);
}

void TestStopping::anImportLeavesNothing_data()
{
    aRecordingIsKept_data();
}

/// While it copies: a file in the media folder says so.
void TestStopping::anImportLeavesNothing()
{
    QFETCH(int, number);
    QFETCH(int, status);
    QVERIFY(writeNoiseClip(path("long.mkv").toStdString(), 4).has_value());
    begin({QStringLiteral("import"), path("p.odo"), QStringLiteral("--trial"), QStringLiteral("run"),
           QStringLiteral("--video"), QStringLiteral("A=") + path("long.mkv")});
    signal(number); // before it is ready for it, it is ended by it, which leaves nothing either
    const int ended = end(5000);
    QVERIFY2(ended == status || ended == -2 || ended == 0, m_program->readAllStandardError());
    const auto project = Project::open(path("p.odo").toStdString(), Project::Access::ReadOnly);
    QCOMPARE((*project)->trials().all()->size(), std::size_t(ended == 0 ? 1 : 0));
    QVERIFY((*project)->check(true)->empty());
    QCOMPARE(QDir(path("p.media")).entryList(QDir::Files | QDir::Hidden).size(), ended == 0 ? 1 : 0);
}

/// Not the video that it was rendering just then.
void TestStopping::theCommandIsNamed()
{
    const QString folder = path("lesson");
    begin({QStringLiteral("demo"), folder});
    const auto isRendering = [&] {
        return QDirIterator(folder, {QStringLiteral("*.mkv")}, QDir::Files | QDir::Hidden,
                            QDirIterator::Subdirectories)
            .hasNext();
    };
    QVERIFY(QTest::qWaitFor(isRendering, 60'000));
    signal(SIGINT);
    QCOMPARE(end(), 130);
    QCOMPARE(m_program->readAllStandardError(),
             QByteArray("odograph: demo: cancelled; nothing was changed\n"));
    QVERIFY(!QFileInfo::exists(folder));
}

/// Whatever the first one waits for; what was recorded is found at the next opening.
void TestStopping::theSecondInterruptEndsAtOnce()
{
    beginRecording();
    QElapsedTimer since;
    since.start();
    signal(SIGINT);
    signal(SIGINT);
    QCOMPARE(end(), 130);
    QVERIFY2(since.elapsed() < 1000, qPrintable(QString::number(since.elapsed())));
    const ProgramRun recovered =
        runProgram({QStringLiteral("record"), path("p.odo"), QStringLiteral("--recover")});
    QCOMPARE(recovered.exitStatus, 0);
    QCOMPARE(runProgram({QStringLiteral("check"), path("p.odo")}).exitStatus, 0);
}

void TestStopping::aWindowEndsAsIfClosed_data()
{
    aRecordingIsKept_data();
}

void TestStopping::aWindowEndsAsIfClosed()
{
    QFETCH(int, number);
    qputenv("QT_QPA_PLATFORM", "offscreen");
    begin({path("p.odo")});
    QVERIFY(QTest::qWaitFor([&] { return QFileInfo::exists(path("p.odo-wal")); }, 30'000));
    signal(number);
    QCOMPARE(end(), 0);
    // it was closed in good order
    QCOMPARE(QDir(m_folder->path()).entryList({QStringLiteral("p.odo-*")}).size(), 0);
}

ODOGRAPH_TEST(TestStopping, QCoreApplication)
#include "tst_stopping.moc"
