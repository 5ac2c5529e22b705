// SPDX-License-Identifier: GPL-3.0-or-later
// Projects that were cut off, changed bit by bit, or robbed of their log: the file at fault is named and left as it is, nothing
// crashes or takes long, and a sound backup beside it is named.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/fault/folder_content.h"
#include "tests/fault/injected_fault.h"
#include "tests/fault/stored_rows.h"
#include "tests/support/patience.h"
#include "tests/ui/support/stored_example.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <ctime>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

using namespace odo;
using namespace odo::test;

namespace fs = std::filesystem;

class TestDamagedProjects : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cutOffAtEveryPage();
    void flippedBits();
    void withoutTheirLog();
    void withADamagedLog();
    void aSoundBackupIsNamed();
    void aDamagedBackupIsNot();

private:
    fs::path file(const char *name) const { return m_folder / name; }
    static QByteArray content(const fs::path &of)
    {
        QFile in(QString::fromStdString(of.string()));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray();
    }
    static void store(const fs::path &in, const QByteArray &bytes)
    {
        QFile out(QString::fromStdString(in.string()));
        if (!out.open(QIODevice::WriteOnly) || out.write(bytes) != bytes.size())
            qFatal("cannot write the test's file");
    }
    QString problemOf(const QByteArray &bytes, Project::Access access);
    /// A project with a log of changes that no process closed.
    void leaveALog() const;

    QTemporaryDir m_place{quickFolder()};
    const fs::path m_folder = m_place.path().toStdString();
    QByteArray m_whole;
    int m_refused = 0, m_opened = 0;
};

namespace {

/// All that people look at.
void readEverything(Project &project)
{
    static_cast<void>(project.check(false));
    static_cast<void>(project.layouts().all());
    static_cast<void>(project.teams().all());
    static_cast<void>(project.tasks().all());
    static_cast<void>(project.changes());
    const auto cameras = project.cameras().all();
    for (const CameraRecord &camera : cameras.value_or(std::vector<CameraRecord>())) {
        static_cast<void>(project.cameras().allIntrinsics(camera.id));
        static_cast<void>(project.cameras().allRegistrations(camera.id));
    }
    const auto trials = project.trials().all();
    for (const TrialRecord &trial : trials.value_or(std::vector<TrialRecord>())) {
        static_cast<void>(project.analyses().current(trial.id));
        const auto recordings = project.trials().recordings(trial.id);
        for (const RecordingRecord &recording : recordings.value_or(std::vector<RecordingRecord>()))
            for (const RecordId robot : trial.robots)
                static_cast<void>(project.trials().currentObservations(recording.id, robot));
    }
}

} // namespace

void TestDamagedProjects::initTestCase()
{
    const auto made = storeExample(m_folder);
    QVERIFY2(made, made ? "" : made.error().message().c_str());
    m_whole = content(*made);
    QVERIFY(m_whole.size() > 100'000);
}

/// Opened, and all of it read; what is wrong with how the program took it.
QString TestDamagedProjects::problemOf(const QByteArray &bytes, Project::Access access)
{
    const fs::path bad = file("bad.odo");
    store(bad, bytes);
    const std::clock_t begun = std::clock(); // of this process alone: other programs may take their time
    {
        const auto project = Project::open(bad, access);
        if (project) {
            ++m_opened;
            readEverything(**project);
        } else {
            ++m_refused;
            const std::string words = project.error().message();
            if (words.find("bad.odo") == std::string::npos)
                return QStringLiteral("the file is not named: ") + QString::fromStdString(words);
            if (project.error().advice.empty() || project.error().code == ErrorCode::Internal)
                return QStringLiteral("it does not say what to do: ") + QString::fromStdString(words);
            if (content(bad) != bytes)
                return QStringLiteral("it was changed although it was refused: ") + QString::fromStdString(words);
        }
    }
    const double tookS = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
    if (tookS > slowness)
        return QStringLiteral("it took %1 s").arg(tookS);
    return {};
}

void TestDamagedProjects::cutOffAtEveryPage()
{
    const int pageBytes = 4096, step = isWholeSweep() ? 1 : 4;
    for (qsizetype page = 0; page * pageBytes < m_whole.size(); page += step) {
        for (const qsizetype more : {0, 1, 2000}) {
            const qsizetype length = page * pageBytes + more;
            if (length >= m_whole.size())
                continue;
            const int before = m_refused;
            const QString problem =
                problemOf(m_whole.left(length), page % 2 == 0 ? Project::Access::ReadWrite : Project::Access::ReadOnly);
            QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("%1 bytes: ").arg(length) + problem));
            QVERIFY2(m_refused == before + 1, qPrintable(QStringLiteral("%1 bytes were taken for a project").arg(length)));
        }
    }
}

void TestDamagedProjects::flippedBits()
{
    const int flips = isWholeSweep() ? 10'000 : 300;
    std::mt19937 random(8);
    m_refused = m_opened = 0;
    for (int i = 0; i < flips; ++i) {
        QByteArray bytes = m_whole;
        // A quarter of the flips go to the header; some come in threes.
        const auto range = static_cast<std::size_t>(i % 4 == 0 ? 100 : bytes.size());
        for (int each = 0; each < (i % 5 == 0 ? 3 : 1); ++each) {
            const auto at = static_cast<qsizetype>(random() % range);
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        }
        const QString problem = problemOf(bytes, i % 2 == 0 ? Project::Access::ReadWrite : Project::Access::ReadOnly);
        QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("flip %1: ").arg(i) + problem));
    }
    qInfo("%d flips: %d refused, %d opened and read", flips, m_refused, m_opened);
    QVERIFY(m_refused > flips / 10);
}

void TestDamagedProjects::leaveALog() const
{
    store(file("logged.odo"), m_whole);
    const pid_t child = ::fork();
    if (child == 0) {
        const auto project = Project::open(file("logged.odo"), Project::Access::ReadWrite);
        const bool isSet = project && (*project)->setTitle("First").has_value() && (*project)->setTitle("Second").has_value();
        ::_exit(isSet ? 0 : 1); // as killed: nothing is closed
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    QVERIFY(fs::exists(file("logged.odo-wal")));
}

/// A log that somebody has deleted, as "temporary" beside the project: what was before it is there, whole.
void TestDamagedProjects::withoutTheirLog()
{
    leaveALog();
    for (const char *side : {"logged.odo-wal", "logged.odo-shm"})
        fs::remove(file(side));
    const auto project = Project::open(file("logged.odo"), Project::Access::ReadWrite);
    QVERIFY2(project, project ? "" : project.error().message().c_str());
    QCOMPARE((*project)->title().value(), std::string("Year 9 robotics"));
    QVERIFY((*project)->check(false).has_value());
}

/// Frames of a log have checksums: it counts up to the first that is damaged.
void TestDamagedProjects::withADamagedLog()
{
    std::mt19937 random(9);
    int kept = 0;
    for (int i = 0; i < (isWholeSweep() ? 500 : 40); ++i) {
        leaveALog();
        QByteArray log = content(file("logged.odo-wal"));
        if (i % 2 == 0) {
            const auto at = static_cast<qsizetype>(random() % static_cast<std::size_t>(log.size()));
            log[at] = static_cast<char>(log[at] ^ (1 << random() % 8));
        } else {
            log.truncate(static_cast<qsizetype>(random() % static_cast<std::size_t>(log.size())));
        }
        store(file("logged.odo-wal"), log);
        fs::remove(file("logged.odo-shm"));
        const auto project = Project::open(file("logged.odo"), Project::Access::ReadWrite);
        QVERIFY2(project, project ? "" : project.error().message().c_str());
        const std::string title = (*project)->title().value();
        QVERIFY(title == "Second" || title == "First" || title == "Year 9 robotics");
        kept += title == "First";
        readEverything(**project);
    }
    QVERIFY(kept > 0); // the damage was in the second change alone
}

void TestDamagedProjects::aSoundBackupIsNamed()
{
    store(file("class.odo.bak-9"), m_whole);
    QByteArray bytes = m_whole;
    bytes.replace(8 * 4096, 4096, QByteArray(4096, '\x55'));
    store(file("class.odo"), bytes);
    const auto project = Project::open(file("class.odo"), Project::Access::ReadWrite);
    QVERIFY(!project);
    QCOMPARE(project.error().message(),
             std::string("project 'class.odo': the file is damaged; copy 'class.odo.bak-9', which is sound, to a new name and "
                         "open that, and keep the damaged file"));
    QVERIFY(content(file("class.odo")) == bytes);
    // What it says can be done.
    fs::copy_file(file("class.odo.bak-9"), file("restored.odo"));
    const auto restored = Project::open(file("restored.odo"), Project::Access::ReadWrite);
    QVERIFY2(restored, restored ? "" : restored.error().message().c_str());
    QCOMPARE(firstDifference(storedRows(file("example.odo")), storedRows(file("restored.odo"))), QString());
}

void TestDamagedProjects::aDamagedBackupIsNot()
{
    QByteArray bytes = m_whole;
    bytes.replace(8 * 4096, 4096, QByteArray(4096, '\x55'));
    store(file("lesson.odo"), bytes);
    store(file("lesson.odo.bak-9"), bytes);
    const auto project = Project::open(file("lesson.odo"), Project::Access::ReadWrite);
    QVERIFY(!project);
    QCOMPARE(project.error().advice, std::string("restore it from a backup copy"));
}

QTEST_GUILESS_MAIN(TestDamagedProjects)
#include "tst_damaged_projects.moc"
