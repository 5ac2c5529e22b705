// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/example_scene.h"
#include "ui/models/explanation.h"
#include "ui/models/number_text.h"
#include "ui/models/scene_uncertainty.h"

#include "core/analysis/gate_passages.h"
#include "core/analysis/metrics.h"
#include "core/analysis/task_metrics.h"
#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

class TestExplanation : public QObject
{
    Q_OBJECT
    TrialScenePtr m_scene = exampleScene({.frames = 300});

private Q_SLOTS:
    void everyFigureOfARunIsExplained()
    {
        const Profile &profile = m_scene->robots[0].analysis->profile;
        std::vector<Metric> metrics = measureRun(profile.samples, profile.points);
        QVERIFY(metrics.size() >= 14);
        // Those of a task, which are given only where a run has them.
        for (const char *name : {"circle_radius", "gate_time", "laps", "best_lap", "mean_lap",
                                 "cross_track_mean", "cross_track_rms", "cross_track_max", "cross_track_bias",
                                 "path_completed", "zone_breaches", "zone_time", "zone_depth"})
            metrics.push_back({name, "m", 1, 0.1});
        for (const Metric &metric : metrics) {
            const Explanation explanation = explainMetric(*m_scene, 0, metric);
            QVERIFY2(!explanation.formula.isEmpty(), metric.name.c_str());
            const bool isCount = metric.name == "stops" || metric.name == "laps" ||
                                 metric.name == "path_completed" || metric.name == "zone_breaches";
            QVERIFY2(!metric.sigma || isCount || !explanation.uncertainty.isEmpty(), metric.name.c_str());
            QVERIFY(explanation.text().startsWith(metricName(metric.name) + QStringLiteral(": ")));
        }
    }
    void breachesOfZonesAreNamed()
    {
        auto scene = std::make_shared<TrialScene>(*m_scene);
        scene->task = Task();
        scene->taskId = 7;
        scene->robots[0].analysis->task = 7;
        scene->task->zones = {rectangularZone("Nowhere", ZoneRule::StayInside, {90, 90}, {91, 91})};
        const Explanation explanation = explainMetric(*scene, 0, {"zone_time", "s", 1, 0.1});
        QVERIFY2(explanation.inputs.first().startsWith(QStringLiteral("Nowhere: from ")),
                 qPrintable(explanation.text()));
        scene->task->zones = {rectangularZone("All", ZoneRule::StayInside, {-90, -90}, {90, 90})};
        QVERIFY(zoneBreachLines(*scene, 0).isEmpty());
        scene->task->zones = {rectangularZone("Nowhere", ZoneRule::StayInside, {90, 90}, {91, 91})};
        scene->taskId = 8; // it was analysed with a different course
        QVERIFY(zoneBreachLines(*scene, 0).isEmpty());
    }
    void aCurveIsExplainedWhereTheCursorStands()
    {
        const Profile &profile = m_scene->robots[0].analysis->profile;
        for (const Quantity quantity : allQuantities()) {
            const Explanation told =
                explainCurve(*m_scene, 0, quantity, profile.samples[100].time, QStringLiteral("1 m/s"));
            QVERIFY(!told.formula.isEmpty() && !told.uncertainty.isEmpty());
            QCOMPARE(told.value, QStringLiteral("1 m/s"));
            QVERIFY2(
                told.inputs.first().startsWith(QStringLiteral("measured there: ")) ||
                    told.inputs.first().startsWith(QStringLiteral("no view found the robot in this frame")),
                qPrintable(told.text()));
        }
        auto scene = std::make_shared<TrialScene>(*m_scene);
        scene->robots[0].analysis->profile.samples[100].position.reset();
        QVERIFY(explainCurve(*scene, 0, Quantity::Speed, profile.samples[100].time, {})
                    .inputs.first()
                    .startsWith(QStringLiteral("no view found the robot in this frame")));
        // Before the first sample nothing was measured.
        QVERIFY(explainCurve(*m_scene, 0, Quantity::Speed, profile.samples.front().time - Nanoseconds(1), {})
                    .inputs.first()
                    .startsWith(QStringLiteral("trial ")));
        scene->robots[0].analysis.reset();
        QCOMPARE(explainCurve(*scene, 0, Quantity::Speed, Nanoseconds(0), {}).inputs.size(), 1);
    }
    void inputsAreTold()
    {
        const QString inputs = analysisInputs(*m_scene, 0).join(u'\n');
        QVERIFY2(inputs.contains(QStringLiteral("of 300 samples used")), qPrintable(inputs));
        QVERIFY(inputs.contains(QStringLiteral("Rauch, Tung, Striebel 1965")));
        auto untracked = std::make_shared<TrialScene>(*m_scene);
        untracked->robots[0].analysis.reset();
        QCOMPARE(analysisInputs(*untracked, 0).size(), 1); // its name
    }
    void aFigureThatIsNotKnownHasItsInputs()
    {
        const Explanation explanation = explainMetric(*m_scene, 0, {"wheel_wear", "1", 3, std::nullopt});
        QVERIFY(explanation.formula.isEmpty());
        QVERIFY(explanation.text().startsWith(QStringLiteral("Wheel wear: 3")));
        QVERIFY(!explanation.inputs.isEmpty());
    }
    void spikesSayWhatWasLookedAt()
    {
        for (const Spike &spike : m_scene->robots[0].analysis->profile.spikes) {
            const Explanation explanation = explainSpike(*m_scene, 0, spike);
            QVERIFY(explanation.formula.contains(isRejected(spike.flags)
                                                     ? QStringLiteral("not used for the curve")
                                                     : QStringLiteral("uses the sample nevertheless")));
            QCOMPARE(explanation.value, QString::fromStdString(spike.reason.english()));
        }
    }
    void disagreementIsCountedAndExplained()
    {
        const std::vector<ViewDisagreement> found = disagreementsOf(*m_scene);
        QCOMPARE(found.size(), m_scene->robots.size());
        const Explanation explanation = explainDisagreement(*m_scene, 0, found[0]);
        QVERIFY(explanation.formula.contains(QStringLiteral("tr A + tr B")));
        auto untracked = std::make_shared<TrialScene>(*m_scene);
        untracked->robots[0].analysis.reset();
        const auto none = disagreementsOf(*untracked);
        QVERIFY(none[0].positions.empty());
        QVERIFY(disagreementWords(none[0]).contains(QStringLiteral("nothing to compare")));
        QVERIFY(disagreementWords({{}, 0.003, 0.002, 0.01, 0.001})
                    .contains(QStringLiteral("nothing to compare")));
        const ViewDisagreement large{{Disagreement()}, 0.003, 0.002, 0.01, 0.001};
        QVERIFY(disagreementWords(large).contains(QStringLiteral("more than it explains")));
    }
};

ODOGRAPH_TEST(TestExplanation, QCoreApplication)
#include "tst_explanation.moc"
