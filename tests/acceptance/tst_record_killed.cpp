// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that are killed at random moments: the project opens, what was recorded plays, and no more than
// the last second is missing. ODOGRAPH_KILLS says how many; 20 without it.
#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/record/completed_recordings.h"
#include "tests/support/noise_clip.h"
#include "tests/support/registered_test.h"

#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>
#include <chrono>
#include <random>

using namespace odo;
using namespace std::chrono_literals;

namespace {

/// When to kill: so long after the program began, or after the first file of the recording was there.
struct Moment
{
    bool recording;
    int milliseconds;
};

/// When it was killed, by the clock of the trial's date and by that of the pictures' arrival.
struct Kill
{
    Instant date;
    Nanoseconds steady{0};
};

constexpr int killsAProject = 20;
constexpr double clipS = 30;
constexpr double mostMissingS = 1.0;
/// From when a trial stands in the project to its first picture, on a busy machine.
constexpr double longestBeginS = 0.5;

} // namespace

class TestRecordKilled : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        for (const char *name : {"a.mkv", "b.mkv"})
            QVERIFY(test::writeNoiseClip(file(QString::fromLatin1(name)), clipS).has_value());
    }
    void nothingIsLostButTheLastSecond();

private:
    std::filesystem::path file(const QString &name) const { return m_folder.filePath(name).toStdString(); }
    Kill recordAndKill(const QString &project, const QString &trial, Moment moment) const;
    void lookAt(const std::filesystem::path &project, const QString &trial, const Kill &killed);

    QTemporaryDir m_folder;
    int m_recovered = 0, m_timesStored = 0;
    double m_mostMissingS = 0;
};

/// When it was killed.
Kill TestRecordKilled::recordAndKill(const QString &project, const QString &trial, Moment moment) const
{
    QProcess program;
    program.start(
        qEnvironmentVariable("ODOGRAPH_PROGRAM"),
        {QStringLiteral("record"), project, QStringLiteral("--trial"), trial, QStringLiteral("--camera"),
         QStringLiteral("A=file:") + m_folder.filePath(QStringLiteral("a.mkv")), QStringLiteral("--camera"),
         QStringLiteral("B=file:") + m_folder.filePath(QStringLiteral("b.mkv")), QStringLiteral("--seconds"),
         QStringLiteral("25")});
    program.waitForStarted();
    const QString first =
        QString(project).replace(QStringLiteral(".odo"), QStringLiteral(".media/%1_A.mkv").arg(trial));
    if (moment.recording &&
        !QTest::qWaitFor(
            [&] { return QFileInfo(first).size() > 0 || program.state() == QProcess::NotRunning; }, 60000))
        qWarning("no recording began within a minute");
    QThread::msleep(
        static_cast<unsigned long>(moment.milliseconds)); // the moment of the kill is what is tested
    const Kill now{std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now()),
                   steadyNow()};
    program.kill();
    program.waitForFinished();
    if (program.exitStatus() != QProcess::CrashExit)
        qWarning("it had ended by itself: %s", program.readAllStandardError().constData());
    return now;
}

void TestRecordKilled::lookAt(const std::filesystem::path &projectFile, const QString &trial,
                              const Kill &killed)
{
    const auto project = Project::open(projectFile, Project::Access::ReadWrite);
    QVERIFY2(project, project ? "" : project.error().message().c_str());
    const auto cut = (*project)->trials().find(trial.toStdString());
    if (!cut)
        return; // it was killed before it began
    const double recordedS = std::chrono::duration<double>(killed.date - cut->date).count();
    const auto told = recoverTrials(**project, {});
    QVERIFY2(told, told ? "" : told.error().message().c_str());
    QCOMPARE(told->size(), std::size_t(1));
    auto problems = (*project)->check(true);
    QVERIFY(problems.has_value());
    // One killed between making its file and storing its trial left that file, which the check names ever
    // after.
    std::erase_if(*problems, [&trial](const ProjectProblem &problem) {
        return problem.what.english().starts_with("no trial,") &&
               problem.where.english().find('/' + trial.toStdString() + '_') == std::string::npos;
    });
    QVERIFY2(problems->empty(), problems->empty() ? "" : problems->front().what.english().c_str());
    const auto kept = (*project)->trials().find(trial.toStdString());
    if (!kept) {
        QVERIFY2(recordedS < mostMissingS + longestBeginS, qPrintable(QString::number(recordedS)));
        return;
    }
    ++m_recovered;
    const auto recordings = (*project)->trials().recordings(kept->id);
    QVERIFY(recordings && !recordings->empty());
    for (const RecordingRecord &recording : *recordings) {
        QVERIFY2(test::playsWholly((*project)->resolve(recording), recording.frameTimes.size()),
                 recording.path.c_str());
        QVERIFY(std::ranges::is_sorted(recording.frameTimes));
        const auto raw = (*project)->trials().rawTimes(recording.id);
        QVERIFY(raw.has_value());
        const double lengthS = toSeconds(recording.frameTimes.back());
        // Where it was cut off before times were stored, nobody knows when its first picture came.
        const double missingS = raw->frames.empty()
                                    ? recordedS - longestBeginS - lengthS
                                    : toSeconds(killed.steady - raw->frames.front().arrival) - lengthS;
        m_timesStored += !raw->frames.empty();
        m_mostMissingS = std::max(m_mostMissingS, missingS);
        QVERIFY2(missingS <= mostMissingS, qPrintable(QString::number(missingS)));
    }
}

void TestRecordKilled::nothingIsLostButTheLastSecond()
{
    const int kills = qEnvironmentVariableIntValue("ODOGRAPH_KILLS") > 0
                          ? qEnvironmentVariableIntValue("ODOGRAPH_KILLS")
                          : 20;
    std::mt19937 random(20);
    QString project;
    for (int i = 0; i < kills; ++i) {
        if (i % killsAProject == 0) {
            project = m_folder.filePath(QStringLiteral("p%1.odo").arg(i / killsAProject));
            QVERIFY(Project::create(project.toStdString(), "Killed").has_value());
        }
        const QString trial = QStringLiteral("run%1").arg(i);
        const bool recording = i % 5 != 0; // every fifth is killed while it begins
        const Moment moment{recording, std::uniform_int_distribution(0, recording ? 1600 : 500)(random)};
        const Kill killed = recordAndKill(project, trial, moment);
        lookAt(project.toStdString(), trial, killed);
        if (QTest::currentTestFailed()) {
            QFAIL(qPrintable(QStringLiteral("kill %1").arg(i)));
        }
        if ((i + 1) % 100 == 0)
            qInfo("%d kills, %d recordings recovered, at most %.2f s missing", i + 1, m_recovered,
                  m_mostMissingS);
    }
    qInfo("%d kills, %d recordings recovered, at most %.2f s missing", kills, m_recovered, m_mostMissingS);
    QVERIFY(m_recovered > kills / 2);
    QVERIFY(m_timesStored > kills / 4); // those of more than a second, of two views each
}

ODOGRAPH_TEST(TestRecordKilled, QCoreApplication)
#include "tst_record_killed.moc"
