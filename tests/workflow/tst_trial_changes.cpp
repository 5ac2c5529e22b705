// SPDX-License-Identifier: GPL-3.0-or-later
// What people change about trials, and the bin. In the stored example Trial 1 is of team Falcon and Trial 2
// of Heron, both of class 9B; Trial 3 has no team.
#include "core/workflow/trials/trial_changes.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

const Instant longAgo{std::chrono::milliseconds(1'000'000'000'000)};

struct Example
{
    QTemporaryDir folder;
    std::unique_ptr<Project> project = openStoredExample(folder.path().toStdString());

    TrialRecord trial(const char *name = "Trial 1") const { return *project->trials().find(name); }
    Result<TrialRecord> edit(const TrialEdit &edit, const char *name = "Trial 1") const
    {
        return editTrial(*project, trial(name).id, edit);
    }
    std::string newestChange() const { return project->changes()->front().words.english(); }
};

std::string line(const Result<TrialRecord> &failed)
{
    return failed ? "nothing failed" : failed.error().message();
}

} // namespace

class TestTrialChanges : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void allOfItIsOneChangeAndUndone()
    {
        const Example example;
        const TrialRecord before = example.trial();
        QVERIFY(example.project->tasks().add({0, "Circle", {}}));
        const auto done = example.edit({.name = "Final",
                                        .team = "Heron",
                                        .className = "9B",
                                        .date = longAgo,
                                        .task = "Circle",
                                        .robots = {{"Blue 1", "Red 2", "Blue 1"}},
                                        .notes = "wet floor"});
        QVERIFY2(done, line(done).c_str());
        QCOMPARE(done->name, std::string("Final"));
        QCOMPARE(done->teamName, std::string("Heron"));
        QCOMPARE(done->className, std::string("9B"));
        QVERIFY(done->date == longAgo);
        QCOMPARE(done->task, std::string("Circle"));
        QCOMPARE(done->robotNames, (std::vector<std::string>{"Blue 1", "Red 2"}));
        QCOMPARE(done->notes, std::string("wet floor"));
        QCOMPARE(example.newestChange(), std::string("edit trial Trial 1"));

        QVERIFY(example.project->undo());
        const TrialRecord after = example.trial();
        QVERIFY(after.id == before.id && after.teamName == before.teamName && after.date == before.date);
        QVERIFY(after.task == before.task && after.robots == before.robots && after.notes == before.notes);
        QVERIFY(example.project->redo());
        QCOMPARE(example.trial("Final").id, before.id);
    }

    void whatIsNotGivenStays()
    {
        const Example example;
        const TrialRecord before = example.trial();
        const auto done = example.edit({.notes = ""});
        QVERIFY(done && done->name == before.name && done->team == before.team && done->date == before.date);
        QVERIFY(done->robots == before.robots);
    }

    void oneThingHasWordsOfItsOwn()
    {
        const Example example;
        QVERIFY(example.edit({.name = "Final"}));
        QCOMPARE(example.newestChange(), std::string("rename trial Trial 1 to Final"));
        QVERIFY(example.edit({.team = "Heron"}, "Final"));
        QCOMPARE(example.newestChange(), std::string("assign Final to team Heron"));
        QVERIFY(example.edit({.notes = "again"}, "Final"));
        QCOMPARE(example.newestChange(), std::string("write notes of Final"));
        QVERIFY(example.edit({.date = longAgo}, "Final"));
        QCOMPARE(example.newestChange(), std::string("edit trial Final"));
        const std::size_t count = example.project->changes()->size();
        QVERIFY(example.edit({.date = longAgo}, "Final")); // changes nothing, so leaves no trace
        QCOMPARE(example.project->changes()->size(), count);
    }

    void aNameMayChangeItsSpellingOnly()
    {
        const Example example;
        QCOMPARE(line(example.edit({.name = "Trial 2"})),
                 std::string("trial 'Trial 2': the project already has a trial of that name; choose another "
                             "name"));
        QVERIFY(example.edit({.name = " Trial 1 "})); // its own
        QCOMPARE(example.edit({.name = "two\nlines"}).error().code, ErrorCode::InvalidInput);
        QCOMPARE(example.edit({.name = ""}).error().code, ErrorCode::InvalidInput);
        QVERIFY(example.project->trials().find("Trial 1"));
    }

    void teamAndTaskAreRemovedByAnEmptyName()
    {
        const Example example;
        const auto done = example.edit({.team = "", .task = ""});
        QVERIFY(done && done->team == 0 && done->className.empty() && done->task.empty());
        QCOMPARE(line(example.edit({.className = "9B"})),
                 std::string("trial 'Trial 1': without a team it belongs to no class; give it a team too"));
        QVERIFY(example.edit({.team = "Falcon", .className = "9B"}));
    }

    void aNewTeamIsAdded()
    {
        const Example example;
        const auto done = example.edit({.team = "Owl", .className = "10A"}, "Trial 3");
        QVERIFY2(done, line(done).c_str());
        QCOMPARE(done->className, std::string("10A"));
        QVERIFY(example.project->undo()); // team and class with it
        QVERIFY(!example.project->teams().find("Owl"));
        QVERIFY(!example.project->classes().find("10A"));
    }

    void aNewTeamStaysInTheTrialsClass()
    {
        Example example;
        const auto done = example.edit({.team = "Owl"});
        QVERIFY(done && done->teamName == "Owl" && done->className == "9B");
    }

    void aTeamOfAnotherClassNeedsItsClass()
    {
        const Example example;
        QVERIFY(example.project->teams().add({0, "Owl", "10A"}));
        QCOMPARE(line(example.edit({.team = "Owl"})),
                 std::string("team 'Owl': it belongs to class 10A, not to class 9B; give its class too, or "
                             "another team"));
        QCOMPARE(example.trial().teamName, std::string("Falcon"));
        QCOMPARE(line(example.edit({.team = "Owl", .className = "9B"})),
                 std::string("team 'Owl': it belongs to class 10A, not to class 9B; give another team, or "
                             "change the class of this one"));
        QCOMPARE(line(example.edit({.className = "10A"})),
                 std::string("team 'Falcon': it belongs to class 9B, not to class 10A; give another team, or "
                             "change the class of this one"));
        const auto done = example.edit({.team = "Owl", .className = "10A"});
        QVERIFY(done && done->teamName == "Owl" && done->className == "10A");
    }

    void whatDoesNotExistIsNamed()
    {
        const Example example;
        const QByteArray before = state(example);
        QCOMPARE(example.edit({.task = "Slalom", .notes = "x"}).error().code, ErrorCode::NotFound);
        QCOMPARE(line(example.edit({.robots = std::vector<std::string>{"Red 2", "Green 3"}, .notes = "x"})),
                 std::string("robot 'Green 3': the project has no such robot; it has 'Red 2', 'Blue 1'"));
        QCOMPARE(editTrial(*example.project, 99, {.notes = "x"}).error().code, ErrorCode::NotFound);
        const auto future = example.edit({.date = instantNow() + std::chrono::hours(1), .notes = "x"});
        QCOMPARE(future.error().code, ErrorCode::WrongCall);
        QCOMPARE(line(future),
                 std::string("trial 'Trial 1': its new date is in the future; give the date of the run"));
        QCOMPARE(state(example), before);
    }

    void severalAreOneChange()
    {
        const Example example;
        const auto ids = [&] { return std::vector{example.trial().id, example.trial("Trial 3").id}; };
        const auto done = editTrials(*example.project, ids(),
                                     {.tags = {{"wet", "final"}}, .variables = {{"surface", "carpet"}}});
        QVERIFY(done && done->size() == 2 && done->at(1).name == "Trial 3");
        for (const TrialRecord &trial : *done) {
            QCOMPARE(trial.tags, (std::vector<std::string>{"final", "wet"}));
            QCOMPARE(trial.variables.at("surface"), std::string("carpet"));
        }
        QCOMPARE(example.newestChange(), std::string("edit 2 trials"));
        QVERIFY(example.project->undo());
        QVERIFY(example.trial().tags.empty() && example.trial("Trial 3").variables.empty());

        const QByteArray before = state(example);
        const auto refused = editTrials(*example.project, ids(), {.className = "9B", .notes = "x"});
        QCOMPARE(
            QString::fromStdString(refused.error().message()),
            QStringLiteral("trial 'Trial 3': without a team it belongs to no class; give it a team too"));
        QCOMPARE(state(example), before); // the first one neither
        QVERIFY(editTrials(*example.project, {example.trial().id}, {.tags = {{"wet"}}}));
        QCOMPARE(example.newestChange(), std::string("change the tags of Trial 1"));
        QCOMPARE(example.edit({.className = " "}).error().code, ErrorCode::InvalidInput);
    }

    void theBinIsOneChange()
    {
        const Example example;
        QVERIFY(setInBin(*example.project, {example.trial()}, true));
        QVERIFY(example.trial().binned);
        QCOMPARE(example.newestChange(), std::string("delete Trial 1"));
        QVERIFY(setInBin(*example.project, {example.trial()}, false));
        QVERIFY(!example.trial().binned);
        QCOMPARE(example.newestChange(), std::string("restore Trial 1 from the bin"));
        QVERIFY(setInBin(*example.project, {example.trial(), example.trial("Trial 2")}, true));
        QCOMPARE(example.newestChange(), std::string("delete 2 trials"));
        QVERIFY(example.project->undo());
        QVERIFY(!example.trial().binned && !example.trial("Trial 2").binned);
    }

    void whatIsBeingRecordedStays()
    {
        const Example example;
        TrialRecord begun;
        begun.name = "now";
        begun = *example.project->trials().begin(begun, {});
        const auto refused = setInBin(*example.project, {example.trial(), begun}, true);
        QCOMPARE(refused.error().message(),
                 std::string("trial 'now': it is being recorded; end its recording first"));
        QVERIFY(!example.trial().binned);
    }

private:
    static QByteArray state(const Example &example)
    {
        const TrialRecord trial = example.trial();
        return QByteArray::fromStdString(trial.notes + '|' + trial.task + '|' + trial.teamName) +
               QByteArray::number(qint64(trial.robots.size())) +
               QByteArray::number(qint64(example.project->changes()->size()));
    }
};

ODOGRAPH_TEST(TestTrialChanges, QCoreApplication)
#include "tst_trial_changes.moc"
