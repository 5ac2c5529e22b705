// SPDX-License-Identifier: GPL-3.0-or-later
// The calendar clock jumps to and fro while a trial is recorded: its times do not.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/program.h"
#include "tests/support/registered_test.h"

#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestClockJumps : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theClockReallyJumps();
    void durationsStayTrue();

private:
    static ProgramRun runWithJumps(const QString &program, const QStringList &arguments)
    {
        return runCommand(QStringLiteral("env"),
                          QStringList{QStringLiteral("LD_PRELOAD=") +
                                          qEnvironmentVariable("ODOGRAPH_JUMPING_CLOCK_LIBRARY"),
                                      QStringLiteral("ASAN_OPTIONS=verify_asan_link_order=0"), program} +
                              arguments);
    }
};

/// So that the other test does not pass because nothing jumped.
void TestClockJumps::theClockReallyJumps()
{
    const ProgramRun run = runWithJumps(
        QStringLiteral("sh"),
        {QStringLiteral("-c"), QStringLiteral("for i in 1 2 3 4 5 6 7 8; do date +%s; sleep 0.25; done")});
    std::vector<qint64> moments;
    for (const QByteArray &line : run.out.trimmed().split('\n'))
        moments.push_back(line.toLongLong());
    QCOMPARE(moments.size(), std::size_t(8));
    QVERIFY(!std::ranges::is_sorted(moments));
}

void TestClockJumps::durationsStayTrue()
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("p.odo"));
    QVERIFY(Project::create(file.toStdString(), "p").has_value());
    constexpr double wantedS = 3;
    const ProgramRun run =
        runWithJumps(qEnvironmentVariable("ODOGRAPH_PROGRAM"),
                     {QStringLiteral("record"), file, QStringLiteral("--trial"), QStringLiteral("run"),
                      QStringLiteral("--camera"), QStringLiteral("A=sim:A"), QStringLiteral("--camera"),
                      QStringLiteral("B=sim:B"), QStringLiteral("--seconds"), QString::number(wantedS),
                      QStringLiteral("--json")});
    QVERIFY2(run.exitStatus == 0, run.err.constData());
    // The rest of a second to begin and end in, on a busy machine; the least jump is a second.
    const double durationS = run.json()[QStringLiteral("duration_s")].toDouble();
    QVERIFY2(std::abs(durationS - wantedS) < 0.9, qPrintable(QString::number(durationS)));
    const auto project = Project::open(file.toStdString(), Project::Access::ReadWrite);
    const auto trial = (*project)->trials().find("run");
    QVERIFY(trial.has_value());
    const auto recordings = (*project)->trials().recordings(trial->id);
    QCOMPARE(recordings->size(), std::size_t(2));
    for (const RecordingRecord &recording : *recordings) {
        QVERIFY(recording.frameTimes.size() > 10);
        QVERIFY(std::ranges::is_sorted(recording.frameTimes, std::less_equal())); // each after the one before
        const double lengthS = toSeconds(recording.frameTimes.back() - recording.frameTimes.front());
        QVERIFY2(std::abs(lengthS - wantedS) < 0.9, qPrintable(QString::number(lengthS)));
        const auto raw = (*project)->trials().rawTimes(recording.id);
        QVERIFY(raw && std::ranges::is_sorted(raw->frames, {}, &RawTime::arrival));
    }
    QVERIFY(std::abs(trial->syncOffsetS) < 0.9);
    const auto problems = (*project)->check(true);
    QVERIFY(problems && problems->empty());
}

ODOGRAPH_TEST(TestClockJumps, QCoreApplication)
#include "tst_clock_jumps.moc"
