// SPDX-License-Identifier: GPL-3.0-or-later
// What the Trial card says of a view.
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/review/internal/trial_facts.h"

#include <QTemporaryFile>
#include <QTest>

using namespace odo;
using namespace std::chrono_literals;

class TestViewFacts : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QVERIFY(m_video.open()); }

    void aVaryingRateIsShown_data()
    {
        QTest::addColumn<bool>("isUneven");
        QTest::addColumn<bool>("isThere");
        QTest::addColumn<QString>("badge");
        QTest::newRow("even") << false << true << "";
        QTest::newRow("uneven") << true << true << "rate varies";
        QTest::newRow("lost") << true << false << "video missing"; // worse, and what is known of it stays
    }
    void aVaryingRateIsShown()
    {
        QFETCH(bool, isUneven);
        QFETCH(bool, isThere);
        auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 60}));
        SceneView &view = scene->views.front();
        view.file = isThere ? m_video.fileName().toStdString() : std::string("/nowhere/a.mkv");
        for (std::size_t i = 0; i < view.recording.frameTimes.size(); ++i)
            view.recording.frameTimes[i] = 40ms * static_cast<int>(i) + (isUneven && i % 5 == 4 ? 25ms : 0ms);
        const QList<Fact> facts = trialFacts(*scene);
        const auto fact = std::ranges::find(facts, QStringLiteral("View"), &Fact::name);
        QVERIFY(fact != facts.end());
        QTEST(fact->badge.text, "badge");
        QCOMPARE(fact->value.contains(QStringLiteral("\n15 to 65 ms apart")), isUneven);
    }

    void theVerdictIsShownWithItsReasons()
    {
        TrialScene scene = *exampleScene({.frames = 60});
        const auto verdictFact = [&scene] {
            const QList<Fact> facts = trialFacts(scene);
            const auto fact = std::ranges::find(facts, QStringLiteral("Verdict"), &Fact::name);
            return fact == facts.end() ? Fact() : *fact;
        };
        QVERIFY(verdictFact().value.isEmpty()); // not tracked
        scene.verdict.checks = {{"views_agree", CheckLevel::Pass, foreignWords("the views agree")},
                                {"few_spikes", CheckLevel::Pass, foreignWords("few spikes")}};
        QCOMPARE(verdictFact().value, QStringLiteral("all checks passed"));
        QVERIFY(verdictFact().action.isEmpty());
        QVERIFY(verdictFact().badge.state == BadgeState::Good);
        scene.verdict.checks[1] = {"few_spikes", CheckLevel::Doubtful, foreignWords("30 spikes")};
        QCOMPARE(verdictFact().value, QStringLiteral("30 spikes."));
        QVERIFY(verdictFact().badge.state == BadgeState::Warning);
        QCOMPARE(verdictFact().action, QStringLiteral("Accept…"));
        scene.verdict.acceptance = {"a cat ran past", {}, {"few_spikes"}};
        QCOMPARE(verdictFact().value, QStringLiteral("30 spikes.\nAccepted: a cat ran past"));
        QCOMPARE(verdictFact().badge.text, QStringLiteral("✓ accepted"));
        QCOMPARE(verdictFact().action, QStringLiteral("Withdraw"));
        scene.verdict.checks[0] = {"views_agree", CheckLevel::Bad, foreignWords("the views are apart")};
        QCOMPARE(verdictFact().value, QStringLiteral("the views are apart.\n30 spikes."));
        QVERIFY(verdictFact().badge.state == BadgeState::Bad);
        QVERIFY(verdictFact().action.isEmpty()); // whatever was accepted before
    }

private:
    QTemporaryFile m_video;
};

ODOGRAPH_TEST(TestViewFacts, QCoreApplication)
#include "tst_view_facts.moc"
