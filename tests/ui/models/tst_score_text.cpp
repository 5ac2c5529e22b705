// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/results.h"
#include "ui/models/trial_scene.h"

#include <QTest>

using namespace odo;

class TestScoreText : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void aScoreIsTold()
    {
        const std::vector<Criterion> rubric{{"gate_time", 4, 10, 30},
                                            {"path_completed", 1, 0.5, 10},
                                            {"spikes", 10, 0, -10},
                                            {"best_lap", 4, 10, 5}};
        const Score score = scoreOf(
            rubric, {{"gate_time", "s", 7, 0.2}, {"path_completed", "1", 0.75, {}}, {"spikes", "1", 3, {}}});
        QCOMPARE(scoreText(score), QString::fromUtf8("17.0 ±1.0 of 45"));
        QCOMPARE(scoreNumber(score).smallPrint(), QString::fromUtf8("of 45 ±1.0"));
        const QStringList lines = scoreLines(score);
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines[0],
                 QString::fromUtf8("Start to finish 7.0 ±0.2\u00a0s: 15.0 ±1.0 of 30 points (30 points "
                                   "at 4\u00a0s or less, none at 10\u00a0s or more)"));
        QVERIFY2(lines[1].endsWith(QString::fromUtf8(
                     "5 of 10 points (10 points at 100\u00a0% or more, none at 50\u00a0% or less)")),
                 qPrintable(lines[1]));
        QCOMPARE(lines[2], QString::fromUtf8(
                               "Spikes 3: -3 points (10 points off at 10 or more, none off at 0 or less)"));
        QVERIFY(lines[3].startsWith(QLatin1String("Best lap: not measured, no points")));
        const QString how = explainScore(score, {QStringLiteral("Smoother: RTS")}).text();
        for (const QString &part :
             lines + QStringList{QStringLiteral("Smoother: RTS"), QStringLiteral("none at")})
            QVERIFY2(how.contains(part), qPrintable(how));
    }
    void boundsHaveTheUnitsOfPeople()
    {
        QCOMPARE(boundUnit("max_turn_rate").unit, QString::fromUtf8("°/s"));
        QVERIFY(std::abs(boundUnit("max_turn_rate").factor - 57.29578) < 1e-4);
        QCOMPARE(boundUnit("cross_track_rms").unit, QStringLiteral("mm"));
        QVERIFY(boundUnit("spikes").unit.isEmpty() && boundUnit("laps").unit.isEmpty());
    }
    /// What was analysed with a different course has no score in this one.
    void aSceneIsScoredByItsOwnTask()
    {
        TrialScene scene = *exampleScene({.frames = 30});
        QVERIFY(!scoreOf(scene, 0)); // it is not scored
        scene.task = Task();
        scene.task->path.points = {{0, 0}, {1, 0}};
        scene.taskId = 7;
        scene.scoring = {{"path_length", 1, 0, 10}};
        scene.robots[0].analysis->task = 7;
        QVERIFY(scoreOf(scene, 0) && !isMeasuredOtherwise(scene, 0));
        scene.robots[0].analysis->task = 6;
        QVERIFY(!scoreOf(scene, 0) && isMeasuredOtherwise(scene, 0));
        scene.task->path.points.clear(); // without a course nothing depends on it
        QVERIFY(scoreOf(scene, 0) && !isMeasuredOtherwise(scene, 0));
        scene.robots[0].analysis.reset();
        QVERIFY(!scoreOf(scene, 0) && !isMeasuredOtherwise(scene, 0));
    }
};

ODOGRAPH_TEST(TestScoreText, QCoreApplication)
#include "tst_score_text.moc"
