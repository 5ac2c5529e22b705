// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/record/line_up.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using Names = std::vector<std::string>;

class TestLineUp : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void teamsComeUpOneAfterTheOther();
    void aTeamDrivesWhatItDroveLast();
    void aTeamDrivesItsOwnRobots();
    void archivedTasksAreNotOffered();
    void withoutTeamsTrialsAreNumbered();
    void pseudonymsNameTrialsWhereTheyAreShown();
    void archivedClassesAreNotUp();

private:
    void addTrial(const std::string &name, const std::string &team, const std::string &task,
                  const Names &robots, int minute);
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

void TestLineUp::init()
{
    m_project.reset();
    m_folder = std::make_unique<QTemporaryDir>();
    m_project = std::move(*Project::create(m_folder->filePath(QStringLiteral("p.odo")).toStdString(), "P"));
    for (const char *name : {"Red 2", "Blue 1"}) {
        RobotRecord robot;
        robot.name = name;
        robot.colour = {200, 30, 30};
        QVERIFY(m_project->robots().add(robot));
    }
}

void TestLineUp::addTrial(const std::string &name, const std::string &team, const std::string &task,
                          const Names &robots, int minute)
{
    TrialRecord trial;
    trial.name = name;
    trial.task = task;
    trial.date = Instant(std::chrono::minutes(minute));
    if (!team.empty())
        trial.team = m_project->teams().find(team)->id;
    for (const std::string &robot : robots)
        trial.robots.push_back(m_project->robots().find(robot)->id);
    QVERIFY(m_project->trials().add(trial, {}));
}

void TestLineUp::teamsComeUpOneAfterTheOther()
{
    for (const auto &[team, className] :
         {std::pair("Otter", "9A"), std::pair("Falcon", "9A"), std::pair("Lynx", "9B")})
        QVERIFY(m_project->teams().add({0, team, className}));
    addTrial("x", "Falcon", "Circle", {"Blue 1"}, 1);
    const LineUp up = *LineUp::read(*m_project);
    QCOMPARE(up.classes(), (Names{"9A", "9B"}));
    QCOMPARE(up.teams("9A"), (Names{"Falcon", "Otter"}));
    QCOMPARE(up.teams("10"), Names());
    NextRun run = up.first(); // Falcon drove last
    QCOMPARE(run.team, std::string("Otter"));
    QCOMPARE(run.task, std::string("Circle"));
    QCOMPARE(run.trial, std::string("Otter 1"));
    run = up.next(run);
    QCOMPARE(run.team, std::string("Falcon")); // from the first again, the other class is not theirs
    QCOMPARE(run.className, std::string("9A"));
    QCOMPARE(run.trial, std::string("Falcon 2"));
    QCOMPARE(up.next(up.run("9B", "Lynx")).team, std::string("Lynx"));
}

void TestLineUp::aTeamDrivesWhatItDroveLast()
{
    QVERIFY(m_project->teams().add({0, "Falcon", "9A"}));
    QVERIFY(m_project->teams().add({0, "Otter", "9A"}));
    addTrial("Falcon 2", "", "Line", {"Red 2"}, 1); // somebody took the name
    addTrial("a", "Falcon", "Circle", {"Blue 1"}, 2);
    addTrial("b", "Falcon", "Eight", {"Red 2"}, 3);
    addTrial("c", "", "Line", {}, 4);
    const LineUp up = *LineUp::read(*m_project);
    const NextRun falcon = up.run("9A", "Falcon");
    QCOMPARE(falcon.robots, Names{"Red 2"});
    QCOMPARE(falcon.task, std::string("Eight"));
    QCOMPARE(falcon.trial, std::string("Falcon 3"));
    const NextRun otter = up.run("9A", "Otter"); // has not driven yet
    QCOMPARE(otter.robots.size(), std::size_t(2));
    QCOMPARE(otter.task, std::string("Line"));
    QVERIFY(up.task("Eight") && !up.task("Nine"));
}

void TestLineUp::aTeamDrivesItsOwnRobots()
{
    const RecordId blue = m_project->robots().find("Blue 1")->id;
    QVERIFY(m_project->teams().add({0, "Falcon", "9A", "", {}, {blue}}));
    QVERIFY(m_project->teams().add({0, "Otter", "9A"}));
    addTrial("a", "Falcon", "Circle", {"Red 2"}, 1); // lent once
    const LineUp up = *LineUp::read(*m_project);
    QCOMPARE(up.run("9A", "Falcon").robots, Names{"Blue 1"});
    QCOMPARE(up.run("9A", "Otter").robots.size(), std::size_t(2));
    QVERIFY(up.robotsOf("Otter").empty() && up.robotsOf("nobody").empty());
}

void TestLineUp::archivedTasksAreNotOffered()
{
    QVERIFY(m_project->teams().add({0, "Falcon", "9A"}));
    addTrial("a", "Falcon", "Circle", {"Red 2"}, 1);
    QVERIFY(m_project->tasks().setArchived(m_project->tasks().find("Circle")->id, true));
    const LineUp up = *LineUp::read(*m_project);
    QVERIFY(up.tasks().empty() && !up.task("Circle"));
    QVERIFY(up.run("9A", "Falcon").task.empty());
}

void TestLineUp::withoutTeamsTrialsAreNumbered()
{
    const LineUp empty = *LineUp::read(*m_project);
    NextRun run = empty.first();
    QCOMPARE(run.team, std::string());
    QCOMPARE(run.trial, std::string("Trial 1"));
    QCOMPARE(run.robots.size(), std::size_t(2));
    addTrial("Trial 1", "", "", {}, 1);
    addTrial("Trial 3", "", "", {}, 2);
    const LineUp up = *LineUp::read(*m_project);
    run = up.next(run);
    QCOMPARE(run.trial, std::string("Trial 4"));
    QVERIFY(up.classes().empty());
}

void TestLineUp::pseudonymsNameTrialsWhereTheyAreShown()
{
    QVERIFY(m_project->teams().add({0, "Falcon", "9A", "Team 4"}));
    QVERIFY(m_project->teams().add({0, "Otter", "9A"}));
    QCOMPARE(LineUp::read(*m_project)->freeTrialName("Falcon"), std::string("Falcon 1"));
    const LineUp up = *LineUp::read(*m_project, true);
    QCOMPARE(up.freeTrialName("Falcon"), std::string("Team 4 1"));
    QCOMPARE(up.freeTrialName("Otter"), std::string("Otter 1")); // it has none
    QCOMPARE(up.pseudonymOf("Falcon"), std::string("Team 4"));
    QVERIFY(up.pseudonymOf("Otter").empty() && up.pseudonymOf("nobody").empty());
}

void TestLineUp::archivedClassesAreNotUp()
{
    QVERIFY(m_project->teams().add({0, "Falcon", "9A"}));
    QVERIFY(m_project->teams().add({0, "Lynx", "9B"}));
    addTrial("Lynx 1", "Lynx", "", {}, 1);
    const auto classes = m_project->classes().all().value();
    for (const ClassRecord &each : classes)
        if (each.name == "9B")
            QVERIFY(m_project->classes().setArchived(each.id, true));
    const LineUp up = *LineUp::read(*m_project);
    QCOMPARE(up.classes(), Names{"9A"});
    QCOMPARE(up.first().team, std::string("Falcon")); // not who comes after a team that is not up
}

ODOGRAPH_TEST(TestLineUp, QCoreApplication)
#include "tst_line_up.moc"
