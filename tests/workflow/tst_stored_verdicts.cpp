// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts that are stored with a project, and the doubtful ones that a person accepts. The stored example's
// Trial 1 is doubtful for its spikes.
#include "core/workflow/track/stored_verdicts.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/compare/trial_metrics.h"
#include "core/workflow/track/trial_verdict.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>

using namespace odo;

namespace {

struct Example
{
    QTemporaryDir folder;
    std::unique_ptr<Project> project = openStoredExample(folder.path().toStdString());
    RecordId trial = project->trials().find("Trial 1")->id;

    void compute() { QVERIFY(storeVerdicts(*project, computeVerdicts(*project, {trial}).value())); }
    bool isStored() const { return !std::ranges::count(missing(), trial); }
    std::vector<RecordId> missing() const
    {
        return project->verdicts().missing(Instant::min(), Instant::max()).value();
    }
    TrialVerdict stored() const
    {
        return project->verdicts().all(Instant::min(), Instant::max()).value()[trial];
    }
    /// Another analysis of Trial 1, altered.
    template <class Alter>
    void analyse(const Alter &alter)
    {
        auto analysis = project->analyses().current(trial)->front();
        alter(analysis.profile);
        std::vector<AnalysisRecord> made{project->analyses().add(std::move(analysis)).value()};
        QVERIFY(storeVerdict(*project, project->trials().get(trial).value(), made));
    }
    /// A view's synchronisation becomes worse, or unknown.
    void synchronise(const char *method, double sigmaS)
    {
        auto record = project->trials().get(trial).value();
        auto views = project->trials().recordings(trial).value();
        record.syncMethod = views[1].syncMethod = method;
        record.syncOffsetSigmaS = views[1].startOffsetSigmaS = sigmaS;
        QVERIFY(project->trials().setSync(record, views));
    }
};

void manySpikes(Profile &profile)
{
    const Spike one = profile.spikes.empty() ? Spike{0, profile.samples[0].time, 1, foreignWords("jump")}
                                             : profile.spikes.front();
    profile.spikes.assign(profile.samples.size() / 10 + 1, one);
}

void noSpikes(Profile &profile)
{
    profile.spikes.clear();
}

std::vector<std::string> codesOf(const TrialVerdict &verdict)
{
    std::vector<std::string> codes;
    for (const TrialCheck &check : verdict.checks)
        codes.push_back(check.code);
    return codes;
}

using Codes = std::vector<std::string>;

} // namespace

class TestStoredVerdicts : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    /// As of projects of older formats.
    void aMissingOneIsComputedAndStored()
    {
        Example example;
        QVERIFY(!example.isStored());
        QCOMPARE(example.missing().size(), std::size_t(2)); // Trial 3 is not analysed
        example.compute();
        QVERIFY(example.isStored());
        QCOMPARE(example.missing().size(), std::size_t(1));
        // the other one is computed where it is asked for
        const RecordId other = example.project->trials().find("Trial 2")->id;
        QCOMPARE(trialVerdicts(*example.project, {example.trial, other})->size(), std::size_t(2));
    }

    void itIsReadAsItWasComputed()
    {
        Example example;
        example.analyse(manySpikes);
        const auto recordings = example.project->trials().recordings(example.trial).value();
        const auto computed =
            verdictOn(*example.project, example.project->trials().get(example.trial).value(),
                      {&recordings[0], &recordings[1]},
                      example.project->analyses().current(example.trial).value())
                .value();
        const TrialVerdict stored = example.stored();
        QCOMPARE(codesOf(stored), Codes{"few_spikes"}); // passed ones are not read
        const auto same = std::ranges::find(computed.checks, "few_spikes", &TrialCheck::code);
        QVERIFY(same->level == stored.checks.front().level);
        QVERIFY(same->text == stored.checks.front().text);
    }

    void whatItFollowsFromChanges()
    {
        Example example;
        example.analyse(noSpikes);
        QVERIFY(example.isStored());
        QVERIFY(example.stored().level() == CheckLevel::Pass);
        example.synchronise("auto", 0.02);
        QVERIFY(!example.isStored());
        example.compute();
        QCOMPARE(codesOf(example.stored()), Codes{"synchronised"});
        const RecordId registration =
            example.project->analyses().current(example.trial)->front().registrations.front();
        QVERIFY(example.project->cameras().addCheck(
            registration, {instantNow(), RegistrationCheck::Outcome::Still, 0.1, 0, {}}));
        QVERIFY(example.isStored()); // nothing is to be said
        QVERIFY(example.project->cameras().addCheck(
            registration, {instantNow(), RegistrationCheck::Outcome::CameraMoved, 3, 0.01, {}}));
        QVERIFY(!example.isStored());
        example.compute();
        QCOMPARE(codesOf(example.stored()), (Codes{"camera_still", "synchronised"}));
    }

    void undoneAnalysesTakeTheirVerdictWithThem()
    {
        Example example;
        example.analyse(noSpikes);
        QVERIFY(example.project->change(foreignWords("spoil"), [&]() -> Result<void> {
            example.analyse(manySpikes);
            return {};
        }));
        QVERIFY(example.stored().level() == CheckLevel::Doubtful);
        QVERIFY(example.project->undo());
        QVERIFY(!example.isStored()); // what was stored is of another analysis
        example.compute();
        QVERIFY(example.stored().level() == CheckLevel::Pass);
    }

    void aDoubtfulOneIsAcceptedForAReason()
    {
        Example example;
        example.analyse(manySpikes);
        QVERIFY(!example.stored().isSound());
        QVERIFY(acceptVerdict(*example.project, "Trial 1", "  a cat ran past "));
        TrialVerdict verdict = example.stored();
        QVERIFY(verdict.isAccepted() && verdict.isSound());
        QVERIFY(verdict.level() == CheckLevel::Doubtful);
        QCOMPARE(verdict.acceptance->reason, std::string("a cat ran past"));
        QCOMPARE(example.project->changes()->front().words.english(),
                 std::string("accept the results of Trial 1"));
        QVERIFY(example.project->undo());
        QVERIFY(!example.stored().isAccepted());
        QVERIFY(example.project->redo());
        QVERIFY(example.stored().isAccepted());
        QVERIFY(withdrawAcceptance(*example.project, "Trial 1"));
        QVERIFY(!example.stored().isAccepted());
        QCOMPARE(withdrawAcceptance(*example.project, "Trial 1").error().code, ErrorCode::NotFound);
    }

    void itIsVoidWhereAnotherCheckFails()
    {
        Example example;
        example.analyse(manySpikes);
        QVERIFY(acceptVerdict(*example.project, "Trial 1", "a cat"));
        example.analyse(manySpikes);
        QVERIFY(example.stored().isAccepted()); // nothing new
        example.synchronise("auto", 0.02);
        example.compute();
        QVERIFY(!example.stored().isAccepted());
        QVERIFY(acceptVerdict(*example.project, "Trial 1", "a cat, and it drove slowly"));
        QVERIFY(example.stored().isAccepted());
        example.synchronise("none", 0);
        example.compute();
        QVERIFY(example.stored().level() == CheckLevel::Bad);
        QVERIFY(!example.stored().isAccepted());
    }

    void whatCannotBeAcceptedIsRefused()
    {
        Example example;
        example.analyse(noSpikes);
        QCOMPARE(
            acceptVerdict(*example.project, "Trial 1", "x").error().message(),
            std::string("verdict on trial 'Trial 1': all checks were passed; use the results as they are"));
        example.synchronise("none", 0);
        const auto refused = acceptVerdict(*example.project, "Trial 1", "x");
        QCOMPARE(refused.error().code, ErrorCode::InvalidInput);
        QVERIFY2(refused.error().message().starts_with(
                     "verdict on trial 'Trial 1': bad results cannot be accepted ("),
                 refused.error().message().c_str());
        example.synchronise("auto", 0.02);
        QCOMPARE(
            acceptVerdict(*example.project, "Trial 1", " ").error().message(),
            std::string("reason for accepting the results: it is blank; write why the results can be used"));
        QCOMPARE(acceptVerdict(*example.project, "Trial 3", "x").error().code, ErrorCode::NotFound);
    }

    void lowerBoundsAreKnownToLists()
    {
        Example example;
        example.analyse([](Profile &profile) {
            for (Metric &metric : profile.metrics)
                metric.isAtLeast = metric.name == "max_speed";
        });
        const auto isMarked = [&] {
            return example.project->analyses()
                .trialMetrics("max_speed", Instant::min(), Instant::max())
                ->back()
                .metric.isAtLeast;
        };
        QVERIFY(isMarked());
        const auto analyses = example.project->analyses().currentMetrics(example.trial).value();
        for (const Metric &metric : analyses.front().profile.metrics)
            QCOMPARE(metric.isAtLeast, metric.name == "max_speed");
    }

    void badOnesDoNotRank()
    {
        Example example;
        example.synchronise("none", 0);
        const TrialRecord trial = example.project->trials().get(example.trial).value();
        const auto grounds = countingGrounds(*example.project, trial.className, trial.task).value();
        const CountedTrials counted =
            countedTrials(example.project->trials().all().value(), trial.className, trial.task, grounds);
        QCOMPARE(counted.bad, 1);
        QVERIFY(std::ranges::none_of(counted.trials,
                                     [&](const TrialRecord *one) { return one->id == example.trial; }));
    }

    void aTrialThatIsRemovedTakesItsVerdictWithIt()
    {
        Example example;
        example.analyse(manySpikes);
        QVERIFY(acceptVerdict(*example.project, "Trial 1", "a cat"));
        QVERIFY(example.project->trials().setBinned(example.trial, true));
        const auto removed = example.project->trials().removeForGood(example.trial);
        QVERIFY2(removed, removed ? "" : removed.error().message().c_str());
    }
};

ODOGRAPH_TEST(TestStoredVerdicts, QCoreApplication)
#include "tst_stored_verdicts.moc"
