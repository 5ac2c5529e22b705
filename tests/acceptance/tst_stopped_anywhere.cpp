// SPDX-License-Identifier: GPL-3.0-or-later
// Import, track, export, reprocess, pack and record, ended by SIGKILL or SIGTERM at random moments: the
// project stays whole, what was acknowledged is there, and check names every file that was left in the media
// folder. ODOGRAPH_STOPS says how many must hit a call before it has ended; 19 without it, three of thirteen
// by SIGTERM.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/media_upkeep.h"
#include "core/workflow/project_copy.h"
#include "core/workflow/record/completed_recordings.h"
#include "tests/support/demo_lesson.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <random>
#include <set>

using namespace odo;

namespace {

constexpr int stopsALesson = 26, longestStopMs = 3000 * test::slowness,
              longestRunMs = 120'000 * test::slowness;
constexpr const char *packArgument = "--pack";

/// A call that is ended: of the program, or, of packing, which is a window's, of this one.
struct Call
{
    QString name;
    QStringList arguments;
    int mostMs; ///< of the random time until it is ended
};

int pack(const char *project, const char *archive)
{
    const auto opened = Project::open(project, Project::Access::ReadOnly);
    PackJob job(archive);
    return opened && runToEnd(job, **opened, {}) ? 0 : 1;
}

} // namespace

class TestStoppedAnywhere : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void nothingAcknowledgedIsLost();

private:
    QString path(const QString &name) const { return m_lesson->filePath(name); }
    Call callOf(int number) const;
    void stop(const Call &call, int signal, int afterMs);
    void lookAtProject(bool withHashes);
    void lookAtStrays(Project &project, bool withHashes);

    std::unique_ptr<QTemporaryDir> m_lesson;
    std::set<std::string> m_acknowledged; ///< trials
    int m_recordingsKept = 0, m_strays = 0, m_killed = 0, m_terminated = 0;
    qint64 m_longestStopMs = 0;
};

Call TestStoppedAnywhere::callOf(int number) const
{
    const QString project = path(QStringLiteral("demo.odo")), trial = QStringLiteral("trial%1").arg(number);
    switch (number % 6) {
    case 0: // as from another disk
        return {QStringLiteral("import"),
                {QStringLiteral("import"), project, QStringLiteral("--trial"), trial,
                 QStringLiteral("--sync"), QStringLiteral("none"), QStringLiteral("--video"),
                 QStringLiteral("A=") + path(QStringLiteral("elsewhere/circle_A.mkv")),
                 QStringLiteral("--video"),
                 QStringLiteral("B=") + path(QStringLiteral("elsewhere/circle_B.mkv"))},
                500};
    case 1:
        return {
            QStringLiteral("track"), {QStringLiteral("track"), project, QStringLiteral("straight")}, 2000};
    case 2:
        return {QStringLiteral("export"),
                {QStringLiteral("export"), project, QStringLiteral("straight"), QStringLiteral("-o"),
                 path(QStringLiteral("out.csv"))},
                250};
    case 3:
        return {QStringLiteral("reprocess"),
                {QStringLiteral("reprocess"), project, QStringLiteral("straight"), QStringLiteral("--keep")},
                600};
    case 4:
        return {QStringLiteral("pack"),
                {QString::fromLatin1(packArgument), project, path(QStringLiteral("out.zip"))},
                600};
    default:
        return {QStringLiteral("record"),
                {QStringLiteral("record"), project, QStringLiteral("--trial"), trial,
                 QStringLiteral("--camera"), QStringLiteral("A=sim:A"), QStringLiteral("--seconds"),
                 QStringLiteral("5")},
                3000};
    }
}

void TestStoppedAnywhere::stop(const Call &call, int signal, int afterMs)
{
    QProcess program;
    const bool packs = call.name == QStringLiteral("pack");
    program.start(packs ? QCoreApplication::applicationFilePath() : qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                  call.arguments);
    QVERIFY(program.waitForStarted());
    if (!program.waitForFinished(afterMs)) { // the moment is what is tested
        QElapsedTimer since;
        since.start();
        ::kill(static_cast<pid_t>(program.processId()), signal);
        QVERIFY2(program.waitForFinished(longestRunMs), qPrintable(call.name));
        m_longestStopMs = std::max(m_longestStopMs, since.elapsed());
        QVERIFY2(since.elapsed() < longestStopMs, qPrintable(call.name + QString::number(since.elapsed())));
        ++(signal == SIGKILL ? m_killed : m_terminated);
    }
    const QByteArray answer = program.readAllStandardOutput(), error = program.readAllStandardError();
    const int status = program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1;
    QVERIFY2(status == -1 || status == 0 || status == 128 + SIGTERM,
             (call.name.toUtf8() + ": " + error).constData());
    const bool isKept = call.name == QStringLiteral("record") && answer.contains(" recorded: ");
    if (isKept || (call.name == QStringLiteral("import") && status == 0))
        m_acknowledged.insert(call.arguments[3].toStdString());
    m_recordingsKept += isKept && status == 128 + SIGTERM;
}

/// The project is whole and holds all that was acknowledged, once what was cut off is completed.
void TestStoppedAnywhere::lookAtProject(bool withHashes)
{
    const auto project =
        Project::open(path(QStringLiteral("demo.odo")).toStdString(), Project::Access::ReadWrite);
    QVERIFY2(project, project ? "" : project.error().message().c_str());
    const auto recovered = recoverTrials(**project, {});
    QVERIFY2(recovered, recovered ? "" : recovered.error().message().c_str());
    for (const std::string &name : m_acknowledged) {
        const auto trial = (*project)->trials().find(name);
        QVERIFY2(trial && !trial->unfinished, name.c_str());
        const auto recordings = (*project)->trials().recordings(trial->id).value();
        QVERIFY2(!recordings.empty(), name.c_str());
        for (const RecordingRecord &recording : recordings)
            QVERIFY2(std::filesystem::exists((*project)->resolve(recording)), recording.path.c_str());
    }
    QVERIFY((*project)->analyses().currentMetrics((*project)->trials().find("straight")->id).value().size() ==
            1);
    lookAtStrays(**project, withHashes);
}

/// Every file that nothing refers to is named, and nothing else is wrong.
void TestStoppedAnywhere::lookAtStrays(Project &project, bool withHashes)
{
    std::set<QString> left;
    QDirIterator files(path(QStringLiteral("demo.media")), QDir::Files | QDir::Hidden | QDir::System);
    while (files.hasNext())
        left.insert(files.next());
    left.erase(path(QStringLiteral("demo.media/recording.lock")));
    const auto recordings = project.trials().allRecordings().value();
    for (const RecordingRecord &recording : recordings)
        left.erase(QString::fromStdString(project.resolve(recording).string()));
    const auto problems = project.check(withHashes).value();
    for (const ProjectProblem &problem : problems)
        QVERIFY2(left.erase(QString::fromStdString(problem.where.english())) == 1,
                 joined({problem.where, problem.what}, Join::Colon).english().c_str());
    QVERIFY2(left.empty(), left.empty() ? "" : qPrintable(*left.begin()));
    m_strays += static_cast<int>(problems.size());
    FindStraysJob found;
    QVERIFY(runToEnd(found, project, {}));
    RemoveStraysJob removed(found.strays());
    QVERIFY(runToEnd(removed, project, {}));
    QVERIFY(project.check(false)->empty());
}

void TestStoppedAnywhere::nothingAcknowledgedIsLost()
{
    constexpr int sample = 19;
    const int asked = qEnvironmentVariableIntValue("ODOGRAPH_STOPS"), stops = asked > 0 ? asked : sample;
    std::mt19937 random(32);
    int i = 0;
    for (; m_killed + m_terminated < stops && i < 3 * stops; ++i) {
        if (i % stopsALesson == 0) {
            m_acknowledged.clear();
            m_lesson = std::make_unique<QTemporaryDir>();
            QCOMPARE(test::provideDemoLesson(m_lesson->path()), QString());
            QVERIFY(QDir().mkpath(path(QStringLiteral("elsewhere"))));
            for (const QString &name : {QStringLiteral("/circle_A.mkv"), QStringLiteral("/circle_B.mkv")})
                std::filesystem::create_hard_link(path(QStringLiteral("demo.media") + name).toStdString(),
                                                  path(QStringLiteral("elsewhere") + name).toStdString());
        }
        const Call call = callOf(i);
        const int signal = i % 13 % 4 == 1 ? SIGTERM : SIGKILL; // three of thirteen, of each call some
        stop(call, signal, std::uniform_int_distribution(0, call.mostMs)(random));
        if (!QTest::currentTestFailed())
            lookAtProject((i + 1) % stopsALesson == 0);
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QStringLiteral("stop %1: %2, signal %3").arg(i).arg(call.name).arg(signal)));
    }
    qInfo("of %d calls %d killed and %d terminated, %d strays named, %d recordings kept, %lld ms at most", i,
          m_killed, m_terminated, m_strays, m_recordingsKept, m_longestStopMs);
    QVERIFY(m_killed + m_terminated >= stops);
}

int main(int argc, char **argv)
{
    if (argc == 4 && std::string_view(argv[1]) == packArgument)
        return pack(argv[2], argv[3]);
    QCoreApplication application(argc, argv);
    TestStoppedAnywhere test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_stopped_anywhere.moc"
