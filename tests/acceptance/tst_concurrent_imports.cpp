// SPDX-License-Identifier: GPL-3.0-or-later
// Imports by two processes at once, of one trial's name and of two names that give one file name: each trial
// that was acknowledged has its own video, and a refused import leaves nothing. ODOGRAPH_IMPORTS says how
// many pairs of each; 3 without it.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"
#include "tests/video/coded_frames.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

struct Ended
{
    int status = -1;
    QByteArray error;
};

std::unique_ptr<QProcess> begin(const QStringList &arguments)
{
    auto process = std::make_unique<QProcess>();
    process->start(qEnvironmentVariable("ODOGRAPH_PROGRAM"), arguments);
    return process;
}

Ended end(QProcess &process)
{
    process.waitForFinished(60'000);
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardError()};
}

} // namespace

class TestConcurrentImports : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(writeCoded(file("one.mkv").toStdString(), evenTimes(40, 30), {}), QString());
        QCOMPARE(writeCoded(file("two.mkv").toStdString(), evenTimes(60, 30), {}), QString());
        m_hashes = {fileHash(file("one.mkv")), fileHash(file("two.mkv"))};
        QVERIFY(m_hashes[0] != m_hashes[1]);
    }
    void eachTrialHasItsOwnVideo_data()
    {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::newRow("one name") << QStringLiteral("Run 1") << QStringLiteral("Run 1");
        QTest::newRow("one file name") << QStringLiteral("Run 1") << QStringLiteral("Run_1");
    }
    void eachTrialHasItsOwnVideo()
    {
        QFETCH(QString, first);
        QFETCH(QString, second);
        const int asked = qEnvironmentVariableIntValue("ODOGRAPH_IMPORTS");
        for (int i = 0; i < (asked > 0 ? asked : 3) && !QTest::currentTestFailed(); ++i)
            importAtOnce(first, second);
    }

private:
    QString file(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
    void importAtOnce(const QString &first, const QString &second) const;

    QTemporaryDir m_folder;
    std::array<QByteArray, 2> m_hashes;
};

void TestConcurrentImports::importAtOnce(const QString &first, const QString &second) const
{
    const QTemporaryDir place;
    const QString project = place.filePath(QStringLiteral("p.odo"));
    QCOMPARE(runProgram({QStringLiteral("new"), project}).exitStatus, 0);
    const auto import = [&](const QString &trial, const char *video) {
        return begin({QStringLiteral("import"), project, QStringLiteral("--trial"), trial,
                      QStringLiteral("--video"), QStringLiteral("A=") + file(video)});
    };
    const auto one = import(first, "one.mkv"), two = import(second, "two.mkv");
    const std::array ended{end(*one), end(*two)};
    const bool sameName = first == second;
    const int done = int(ended[0].status == 0) + int(ended[1].status == 0);
    QVERIFY2(done == (sameName ? 1 : 2), (ended[0].error + ended[1].error).constData());
    const auto opened = Project::open(project.toStdString(), Project::Access::ReadOnly);
    QVERIFY(opened);
    const std::array names{first, second};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (ended[i].status != 0) {
            QCOMPARE(ended[i].status, 1);
            QVERIFY2(ended[i].error.contains("the project already has a trial of that name") ||
                         ended[i].error.contains("already"),
                     ended[i].error);
            continue;
        }
        const auto recording =
            (*opened)->trials().recordings((*opened)->trials().find(names[i].toStdString())->id)->front();
        QCOMPARE(QByteArray::fromStdString(recording.sha256), m_hashes[i].toHex());
        QCOMPARE(fileHash(QString::fromStdString((*opened)->resolve(recording).string())), m_hashes[i]);
    }
    QCOMPARE(QDir(place.filePath(QStringLiteral("p.media"))).entryList(QDir::Files | QDir::Hidden).size(),
             done);
    QVERIFY((*opened)->check(true)->empty());
}

ODOGRAPH_TEST(TestConcurrentImports, QCoreApplication)
#include "tst_concurrent_imports.moc"
