// SPDX-License-Identifier: GPL-3.0-or-later
// Projects that were cut off, changed bit by bit, or robbed of their log: the file at fault is named and left
// as it is, nothing crashes or takes long, and a sound backup beside it is named, and takes its place when
// that is asked for.
#include "core/project/project.h"
#include "core/project/project_rescue.h"
#include "core/project/repositories.h"
#include "tests/fault/folder_content.h"
#include "tests/fault/injected_fault.h"
#include "tests/fault/stored_rows.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
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
    void aBackupIsRestored();
    void nothingIsLostByRestoring();
    void withoutABackupThereIsNothingToRestore();
    void aWindowOpensWhereThereIsABackup();

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
    QByteArray damagedContent() const
    {
        QByteArray bytes = m_whole;
        return bytes.replace(8 * 4096, 4096, QByteArray(4096, '\x55'));
    }
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
            if (project.error().advice.english().empty() || project.error().code == ErrorCode::Internal)
                return QStringLiteral("it does not say what to do: ") + QString::fromStdString(words);
            if (content(bad) != bytes)
                return QStringLiteral("it was changed although it was refused: ") +
                       QString::fromStdString(words);
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
            const QString problem = problemOf(
                m_whole.left(length), page % 2 == 0 ? Project::Access::ReadWrite : Project::Access::ReadOnly);
            QVERIFY2(problem.isEmpty(), qPrintable(QStringLiteral("%1 bytes: ").arg(length) + problem));
            QVERIFY2(m_refused == before + 1,
                     qPrintable(QStringLiteral("%1 bytes were taken for a project").arg(length)));
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
        const QString problem =
            problemOf(bytes, i % 2 == 0 ? Project::Access::ReadWrite : Project::Access::ReadOnly);
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
        const bool isSet = project && (*project)->setTitle("First").has_value() &&
                           (*project)->setTitle("Second").has_value();
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
    const QByteArray bytes = damagedContent();
    store(file("class.odo"), bytes);
    const auto project = Project::open(file("class.odo"), Project::Access::ReadWrite);
    QVERIFY(!project);
    QCOMPARE(project.error().message(),
             std::string("project 'class.odo': the file is damaged; copy 'class.odo.bak-9', which is intact, "
                         "to a new name, open that copy and keep the damaged file"));
    QVERIFY(content(file("class.odo")) == bytes);
    // What it says can be done.
    fs::copy_file(file("class.odo.bak-9"), file("restored.odo"));
    const auto restored = Project::open(file("restored.odo"), Project::Access::ReadWrite);
    QVERIFY2(restored, restored ? "" : restored.error().message().c_str());
    QCOMPARE(firstDifference(storedRows(file("example.odo")), storedRows(file("restored.odo"))), QString());
}

void TestDamagedProjects::aDamagedBackupIsNot()
{
    const QByteArray bytes = damagedContent();
    store(file("lesson.odo"), bytes);
    store(file("lesson.odo.bak-9"), bytes);
    const auto project = Project::open(file("lesson.odo"), Project::Access::ReadWrite);
    QVERIFY(!project);
    QCOMPARE(project.error().advice.english(), std::string("restore it from a backup copy"));
}

/// The newest that is sound, under the name that people know; the damaged file with its log is kept, and a
/// second one beside it.
void TestDamagedProjects::aBackupIsRestored()
{
    const QByteArray bytes = damagedContent();
    for (const char *kept : {"year.odo.damaged", "year.odo.damaged.2"}) {
        store(file("year.odo"), bytes);
        store(file("year.odo-wal"), "the log of the damaged one");
        store(file("year.odo.bak-9"), m_whole);
        store(file("year.odo.bak-10"), bytes);
        const auto restored = restoreBackup(file("year.odo"));
        QVERIFY2(restored, restored ? "" : restored.error().message().c_str());
        QCOMPARE(restored->backup.filename().string(), std::string("year.odo.bak-9"));
        QCOMPARE(restored->damaged.filename().string(), std::string(kept));
        QVERIFY(content(restored->damaged) == bytes);
        QCOMPARE(content(restored->damaged.string() + "-wal"), QByteArray("the log of the damaged one"));
        QVERIFY(!fs::exists(file("year.odo-wal")));
        QVERIFY(content(file("year.odo.bak-9")) == m_whole);
        QVERIFY(Project::open(file("year.odo"), Project::Access::ReadWrite));
        QCOMPARE(firstDifference(storedRows(file("example.odo")), storedRows(file("year.odo"))), QString());
    }
}

/// Whatever call fails, or wherever it is killed: both files are there, whole, and one of them has the
/// project's name.
void TestDamagedProjects::nothingIsLostByRestoring()
{
    const fs::path place = m_folder / "place";
    const QByteArray bytes = damagedContent(), log("the log");
    const Work work = [](const fs::path &folder, const Acknowledge &acknowledge) -> Result<void> {
        const auto restored = restoreBackup(folder / "p.odo");
        if (!restored)
            return tl::unexpected(restored.error());
        acknowledge();
        return {};
    };
    const auto begin = [&] {
        fs::remove_all(place);
        fs::create_directory(place);
        store(place / "p.odo", bytes);
        store(place / "p.odo-wal", log);
        store(place / "p.odo.bak-9", m_whole);
    };
    const QStringList wanted = storedRows(file("example.odo"));
    int attempts = 0;
    for (const Fault &fault : allFaults()) {
        begin();
        const int calls = attempt(place, fault, 0, work).calls;
        QVERIFY(calls > 0);
        for (const int nth : spreadCalls(calls, isWholeSweep() ? calls : 12)) {
            begin();
            const Attempt tried = attempt(place, fault, nth, work);
            const QByteArray words = tried.words().toUtf8();
            ++attempts;
            QVERIFY2(content(place / "p.odo.bak-9") == m_whole, words);
            const bool isStill = content(place / "p.odo") == bytes,
                       isKept = content(place / "p.odo.damaged") == bytes;
            QVERIFY2(isStill || isKept, words);
            QVERIFY2(content(place / "p.odo-wal") == log || content(place / "p.odo.damaged-wal") == log,
                     words);
            if (!isStill)
                QVERIFY2(firstDifference(wanted, storedRows(place / "p.odo")).isEmpty(), words);
            QVERIFY2(isStill != (tried.acknowledged == 1) || tried.died(), words);
            if (tried.error) {
                QVERIFY2(!tried.error->why.english().empty() && !tried.error->advice.english().empty() &&
                             tried.error->code != ErrorCode::Internal,
                         words);
                const bool mayStay = fault.how == FailingCalls::How::FromThenOn ||
                                     tried.failedCall.startsWith(QStringLiteral("rename")) ||
                                     tried.failedCall.startsWith(QStringLiteral("unlink"));
                QVERIFY2(mayStay || content(place / "p.odo-wal") == log, words);
            }
        }
    }
    qInfo("%d attempts", attempts);
}

void TestDamagedProjects::withoutABackupThereIsNothingToRestore()
{
    store(file("alone.odo"), damagedContent());
    const auto restored = restoreBackup(file("alone.odo"));
    QVERIFY(!restored);
    QCOMPARE(restored.error().message(),
             std::string(
                 "project 'alone.odo': no intact backup was found beside it; restore it from a backup copy"));
    QVERIFY(content(file("alone.odo")) == damagedContent());
}

/// Double-clicked, of a file that was cut off nothing but a window could be seen.
void TestDamagedProjects::aWindowOpensWhereThereIsABackup()
{
    store(file("cut.odo"), m_whole.left(5000));
    const auto alone = worthOpening(file("cut.odo"));
    QVERIFY(!alone);
    QVERIFY2(alone.error().why.english().starts_with("the file is incomplete"),
             alone.error().why.english().c_str());
    store(file("cut.odo.bak-9"), damagedContent());
    QVERIFY(!worthOpening(file("cut.odo")));
    store(file("cut.odo.bak-10"), m_whole);
    QVERIFY(worthOpening(file("cut.odo")));
    QVERIFY(worthOpening(file("example.odo")));
    fs::remove(file("cut.odo"));
    QCOMPARE(worthOpening(file("cut.odo")).error().code, ErrorCode::NotFound);
}

ODOGRAPH_TEST(TestDamagedProjects, QCoreApplication)
#include "tst_damaged_projects.moc"
