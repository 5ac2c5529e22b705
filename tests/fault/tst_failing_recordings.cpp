// SPDX-License-Identifier: GPL-3.0-or-later
// A recording during which a call on the disk fails, or the program is killed at it: what is kept plays and
// fits its times, what is missing is told, and the project opens.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/record/completed_recordings.h"
#include "tests/fault/injected_fault.h"
#include "tests/support/noise_clip.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

using namespace odo;
using namespace odo::test;

namespace fs = std::filesystem;

namespace {

constexpr double clipS = 5;

} // namespace

class TestFailingRecordings : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void whatIsKeptPlaysAndTheRestIsTold_data();
    void whatIsKeptPlaysAndTheRestIsTold();

private:
    QStringList record(const Fault &fault, const std::vector<int> &nths);
    QStringList arguments(const fs::path &folder) const;
    static QString problemOf(const fs::path &folder, const Attempt &attempt, const ProgramRun &run);
    static QString problemOfTrial(const fs::path &folder, bool isSaidDone);

    QTemporaryDir m_place{quickFolder()};
    const fs::path m_folder = m_place.path().toStdString();
    int m_attempts = 0, m_kept = 0;
};

void TestFailingRecordings::initTestCase()
{
    for (const char *name : {"a.mkv", "b.mkv"}) {
        const auto written = writeNoiseClip(m_folder / name, clipS);
        QVERIFY2(written, written ? "" : written.error().message().c_str());
    }
}

QStringList TestFailingRecordings::arguments(const fs::path &folder) const
{
    const QString clips = QString::fromStdString(m_folder.string());
    return {QStringLiteral("record"),    QString::fromStdString((folder / "p.odo").string()),
            QStringLiteral("--trial"),   QStringLiteral("run"),
            QStringLiteral("--camera"),  QStringLiteral("A=file:") + clips + QStringLiteral("/a.mkv"),
            QStringLiteral("--camera"),  QStringLiteral("B=file:") + clips + QStringLiteral("/b.mkv"),
            QStringLiteral("--seconds"), QStringLiteral("1.5")};
}

void TestFailingRecordings::whatIsKeptPlaysAndTheRestIsTold_data()
{
    QTest::addColumn<int>("number");
    for (int i = 0; i < static_cast<int>(allFaults().size()); ++i) {
        const Fault &fault = allFaults()[static_cast<std::size_t>(i)];
        if (isWholeSweep() || (!fault.reads && fault.how != FailingCalls::How::Once && fault.error != EROFS))
            QTest::addRow("%s", qPrintable(fault.words())) << i;
    }
}

void TestFailingRecordings::whatIsKeptPlaysAndTheRestIsTold()
{
    QFETCH(int, number);
    Fault fault = allFaults()[static_cast<std::size_t>(number)];
    fault.reads = false; // how often a thread reads depends on the moment
    constexpr std::size_t atOnce = 8;
    ProgramRun run;
    fs::create_directories(m_folder / "counted");
    QVERIFY(Project::create(m_folder / "counted" / "p.odo", "p").has_value());
    const Attempt counted =
        attemptProgram(m_folder / "counted", fault, 0, arguments(m_folder / "counted"), &run);
    QVERIFY2(run.exitStatus == 0, run.err.constData());
    fs::remove_all(m_folder / "counted");
    QVERIFY(counted.calls > 50);
    m_attempts = m_kept = 0;
    QStringList problems;
    const std::vector<int> all = spreadCalls(counted.calls, isWholeSweep() ? counted.calls : 6);
    for (std::size_t from = 0; from < all.size(); from += atOnce)
        problems << record(fault,
                           {all.begin() + static_cast<std::ptrdiff_t>(from),
                            all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), from + atOnce))});
    qInfo("%d of %d calls, %d recordings kept", m_attempts, counted.calls, m_kept);
    QVERIFY2(problems.isEmpty(), qPrintable(QStringLiteral("%1 problems:\n").arg(problems.size()) +
                                            problems.mid(0, 12).join(u'\n')));
}

/// Some at once: a recording mostly waits.
QStringList TestFailingRecordings::record(const Fault &fault, const std::vector<int> &nths)
{
    QStringList problems;
    std::vector<std::unique_ptr<AttemptedProgram>> running;
    std::vector<fs::path> folders;
    for (const int nth : nths) {
        folders.push_back(m_folder / ("at " + std::to_string(nth)));
        fs::create_directories(folders.back());
        if (!Project::create(folders.back() / "p.odo", "p"))
            return {QStringLiteral("no project")};
        running.push_back(
            std::make_unique<AttemptedProgram>(folders.back(), fault, nth, arguments(folders.back())));
    }
    for (std::size_t i = 0; i < running.size(); ++i) {
        ProgramRun run;
        const Attempt attempt = running[i]->finish(&run);
        ++m_attempts;
        const QString problem = problemOf(folders[i], attempt, run);
        if (!problem.isEmpty())
            problems << problem + QStringLiteral(" after ") + attempt.words() + QStringLiteral(": ") +
                            QString::fromUtf8(run.out + run.err);
        m_kept += fs::exists(folders[i] / "p.media" / "run_A.mkv");
        fs::remove_all(folders[i]);
    }
    return problems;
}

QString TestFailingRecordings::problemOf(const fs::path &folder, const Attempt &attempt,
                                         const ProgramRun &run)
{
    const bool wasKilled = attempt.fault.kills() && attempt.reached;
    if (attempt.signal != (wasKilled ? SIGKILL : 0))
        return QStringLiteral("ended by signal %1").arg(attempt.signal);
    if (run.exitStatus > 0 && !run.err.contains("odograph: "))
        return QStringLiteral("it does not say why");
    for (const QByteArray &line : run.err.trimmed().split('\n')) {
        if (!line.isEmpty() && (!line.startsWith("odograph: ") || line.count(": ") < 2))
            return QStringLiteral("it says other things than what went wrong");
    }
    if (run.exitStatus == 0 && attempt.failedCall.endsWith(QStringLiteral(".mkv")) && run.err.isEmpty())
        return QStringLiteral("it does not say that a video was cut short");
    return problemOfTrial(folder, run.exitStatus == 0);
}

QString TestFailingRecordings::problemOfTrial(const fs::path &folder, bool isSaidDone)
{
    const auto project = Project::open(folder / "p.odo", Project::Access::ReadWrite);
    if (!project)
        return QStringLiteral("does not open: ") + QString::fromStdString(project.error().message());
    const auto trialBefore = (*project)->trials().find("run");
    if (isSaidDone && (!trialBefore || trialBefore->unfinished))
        return QStringLiteral("it said that it is done, but the trial is not complete");
    if (const auto told = recoverTrials(**project, {}); !told)
        return QStringLiteral("is not recovered: ") + QString::fromStdString(told.error().message());
    auto problems = (*project)->check(true);
    if (problems) // a name that was claimed for a trial that did not begin, with nothing in the file
        std::erase_if(*problems, [](const ProjectProblem &problem) {
            return problem.what.english().ends_with("uses this file") &&
                   fs::file_size(problem.where.english()) == 0;
        });
    if (!problems || !problems->empty())
        return QStringLiteral("the check says: ") +
               QString::fromStdString(problems ? problems->front().what.english()
                                               : problems.error().message());
    const auto trial = (*project)->trials().find("run");
    if (!trial)
        return {};
    const auto recordings = (*project)->trials().recordings(trial->id);
    if (!recordings || recordings->empty())
        return QStringLiteral("a trial without recordings is left");
    for (const RecordingRecord &recording : *recordings) {
        if (!playsWholly((*project)->resolve(recording), recording.frameTimes.size()))
            return QStringLiteral("%1 does not play its %2 frames")
                .arg(QString::fromStdString(recording.path))
                .arg(recording.frameTimes.size());
    }
    return {};
}

ODOGRAPH_TEST(TestFailingRecordings, QCoreApplication)
#include "tst_failing_recordings.moc"
