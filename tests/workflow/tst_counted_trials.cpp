// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/compare/trial_metrics.h"

#include "tests/support/registered_test.h"

#include <QTest>

using namespace odo;

namespace {

TrialRecord trialOf(RecordId id, const char *className, const char *task)
{
    TrialRecord trial;
    trial.id = id;
    trial.className = className;
    trial.task = task;
    return trial;
}

std::vector<RecordId> idsOf(const CountedTrials &counted)
{
    std::vector<RecordId> ids;
    for (const TrialRecord *trial : counted.trials)
        ids.push_back(trial->id);
    return ids;
}

using Ids = std::vector<RecordId>;

} // namespace

/// Which trials' figures can be compared.
class TestCountedTrials : public QObject
{
    Q_OBJECT

    std::vector<TrialRecord> m_trials;
    CountingGrounds m_grounds{
        {{2, "Trial 2", "Slalom", false}, {4, "Trial 4", "Slalom", true}, {5, "Trial 5", "Circle", false}},
        {}};

private Q_SLOTS:
    void initTestCase()
    {
        m_trials = {trialOf(1, "9B", "Slalom"), trialOf(2, "9B", "Slalom"), trialOf(3, "9C", "Slalom"),
                    trialOf(4, "9B", "Slalom"), trialOf(5, "9B", "Circle"), trialOf(6, "", "")};
        m_trials[3].binned = Instant();
    }
    void ofAClassInATask()
    {
        const CountedTrials counted = countedTrials(m_trials, "9B", "Slalom", m_grounds);
        QCOMPARE(idsOf(counted), Ids({1}));
        QCOMPARE(counted.leftOut, 1); // the one in the bin would not count anyhow
    }
    void ofAnyClassInATask()
    {
        const CountedTrials counted = countedTrials(m_trials, "", "Slalom", m_grounds);
        QCOMPARE(idsOf(counted), Ids({1, 3}));
        QCOMPARE(counted.leftOut, 1);
    }
    void anotherClasssTrialsAreNotLeftOut()
    {
        const CountedTrials counted = countedTrials(m_trials, "9C", "Slalom", m_grounds);
        QCOMPARE(idsOf(counted), Ids({3}));
        QCOMPARE(counted.leftOut, 0);
    }
    void ofAnyTaskAllButTheBinned()
    {
        const CountedTrials counted = countedTrials(m_trials, "", "", m_grounds);
        QCOMPARE(idsOf(counted), Ids({1, 2, 3, 5, 6}));
        QCOMPARE(counted.leftOut, 0);
    }
    void badResultsAreLeftOut()
    {
        CountingGrounds grounds = m_grounds;
        grounds.verdicts[1].checks = {{"views_agree", CheckLevel::Bad, foreignWords("apart")}};
        grounds.verdicts[3].checks = {{"few_spikes", CheckLevel::Doubtful, foreignWords("many")}};
        CountedTrials counted = countedTrials(m_trials, "", "Slalom", grounds);
        QCOMPARE(idsOf(counted), Ids({3}));
        QCOMPARE(counted.bad, 1);
        QCOMPARE(counted.leftOut, 1);
        QVERIFY(counted.doubtful == std::set<RecordId>{3});
        grounds.verdicts[3].acceptance = {"seen by me", {}, {"few_spikes"}};
        counted = countedTrials(m_trials, "", "Slalom", grounds);
        QCOMPARE(idsOf(counted), Ids({3}));
        QVERIFY(counted.doubtful.empty());
        QCOMPARE(countedTrials(m_trials, "", "", grounds).bad, 1); // of any task too
    }
    void ofNothing()
    {
        QVERIFY(countedTrials(std::vector<TrialRecord>(), "9B", "Slalom", m_grounds).trials.empty());
        QVERIFY(countedTrials(m_trials, "7A", "Slalom", m_grounds).trials.empty());
        QVERIFY(!countsIn(m_trials[3], "9B", "Slalom"));
    }
};

ODOGRAPH_TEST(TestCountedTrials, QCoreApplication)
#include "tst_counted_trials.moc"
