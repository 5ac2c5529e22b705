// SPDX-License-Identifier: GPL-3.0-or-later
// A disk that becomes read-only, or is taken out of the file system, while a trial is recorded to it: a real
// file system, in a file, mounted where only this program and those it starts see it. Needs the right to
// mount.
#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/record/completed_recordings.h"
#include "tests/support/noise_clip.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <sched.h>
#include <sys/mount.h>

using namespace odo;
using namespace odo::test;
using namespace std::chrono_literals;

namespace {

constexpr double clipS = 30, mostMissingS = 1.0;
/// The program looks at the disk once a second, and then ends what it began; more on a busy machine. The
/// recording would go on for twenty.
constexpr Nanoseconds longestEnd = 10s;

bool works(const char *program, const QStringList &arguments)
{
    return runCommand(QString::fromLatin1(program), arguments).exitStatus == 0;
}

} // namespace

class TestDiskTakenAway : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void whatWasRecordedIsThere_data();
    void whatWasRecordedIsThere();
    void cleanup() { static_cast<void>(works("umount", {path("disk")})); }

private:
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    bool makeDisk() const;
    bool mountDisk() const
    {
        return works("mount", {QStringLiteral("-o"), QStringLiteral("loop"), path("disk.img"), path("disk")});
    }

    QTemporaryDir m_folder;
};

void TestDiskTakenAway::initTestCase()
{
    for (const char *name : {"a.mkv", "b.mkv"})
        QVERIFY(writeNoiseClip(path(name).toStdString(), clipS).has_value());
    // Of its own, so that nobody else sees what is mounted here, and nothing of it stays.
    if (::unshare(CLONE_NEWNS) != 0 || ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0)
        QSKIP("ODOGRAPH-SKIPPED: nothing may be mounted here; run it as the administrator");
    QVERIFY(QDir().mkdir(path("disk")));
    if (!makeDisk() || !mountDisk())
        QSKIP("ODOGRAPH-SKIPPED: no file can be mounted as a disk here (mkfs.ext4, loop devices)");
    cleanup();
}

/// Sparse, so that it takes no room.
bool TestDiskTakenAway::makeDisk() const
{
    QFile::remove(path("disk.img"));
    QFile image(path("disk.img"));
    return image.open(QIODevice::WriteOnly) && image.resize(400'000'000) &&
           works("mkfs.ext4", {QStringLiteral("-q"), QStringLiteral("-F"), path("disk.img")});
}

void TestDiskTakenAway::whatWasRecordedIsThere_data()
{
    QTest::addColumn<QStringList>("command");
    QTest::addColumn<QByteArray>("words");
    // As the kernel does by itself when the disk fails.
    QTest::newRow("it becomes read-only")
        << QStringList{QStringLiteral("mount"), QStringLiteral("-o"), QStringLiteral("remount,abort")}
        << QByteArray("the disk has become read-only");
    QTest::newRow("it is unmounted") << QStringList{QStringLiteral("umount"), QStringLiteral("-l")}
                                     << QByteArray("its file is no longer there");
}

void TestDiskTakenAway::whatWasRecordedIsThere()
{
    QFETCH(QStringList, command);
    QFETCH(QByteArray, words);
    QVERIFY(makeDisk() && mountDisk());
    const QString project = path("disk") + QStringLiteral("/p.odo");
    QVERIFY(Project::create(project.toStdString(), "Disk").has_value());
    QProcess program;
    program.start(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                  {QStringLiteral("record"), project, QStringLiteral("--trial"), QStringLiteral("run"),
                   QStringLiteral("--camera"), QStringLiteral("A=file:") + path("a.mkv"),
                   QStringLiteral("--camera"), QStringLiteral("B=file:") + path("b.mkv"),
                   QStringLiteral("--seconds"), QStringLiteral("25")});
    QVERIFY(program.waitForStarted());
    const auto recordedS = [&project] {
        const auto opened = Project::open(project.toStdString(), Project::Access::ReadOnly);
        const auto trial = opened ? (*opened)->trials().find("run") : tl::unexpected(Error());
        return trial ? trial->durationS : 0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(recordedS() > 1.5, 60000);
    const double acknowledgedS = recordedS();
    const Nanoseconds taken = steadyNow();
    const QByteArray tool = command.takeFirst().toUtf8();
    QVERIFY(works(tool, command << path("disk")));
    QVERIFY(program.waitForFinished(60000));
    const Nanoseconds after = steadyNow() - taken;
    const QByteArray told = program.readAllStandardError();
    qInfo("ended after %.2f s: %s", toSeconds(after), told.constData());
    QVERIFY2(after < longestEnd * slowness, qPrintable(QString::number(toSeconds(after))));
    QCOMPARE(program.exitStatus(), QProcess::NormalExit);
    QVERIFY(program.exitCode() != 0);
    QVERIFY2(told.startsWith("odograph: ") && told.contains(words) && told.contains("; "), told.constData());
    if (tool == "umount") { // nothing has landed on the disk in its place
        const QStringList landed =
            QDir(path("disk")).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
        QVERIFY2(landed.isEmpty(), qPrintable(landed.join(u' ')));
    }
    static_cast<void>(works("umount", {path("disk")}));
    QVERIFY(mountDisk());
    const auto opened = Project::open(project.toStdString(), Project::Access::ReadWrite);
    QVERIFY2(opened, opened ? "" : opened.error().message().c_str());
    const auto recovered = recoverTrials(**opened, {});
    QVERIFY2(recovered, recovered ? "" : recovered.error().message().c_str());
    const auto trial = (*opened)->trials().find("run");
    QVERIFY(trial && !trial->unfinished);
    QVERIFY((*opened)->check(true).value().empty());
    const auto recordings = (*opened)->trials().recordings(trial->id);
    QCOMPARE(recordings.value().size(), std::size_t(2));
    for (const RecordingRecord &recording : *recordings) {
        QVERIFY(playsWholly((*opened)->resolve(recording), recording.frameTimes.size()));
        const double keptS = toSeconds(recording.frameTimes.back());
        QVERIFY2(keptS > acknowledgedS - mostMissingS,
                 qPrintable(QStringLiteral("%1 of %2 s").arg(keptS).arg(acknowledgedS)));
    }
}

ODOGRAPH_TEST(TestDiskTakenAway, QCoreApplication)
#include "tst_disk_taken_away.moc"
