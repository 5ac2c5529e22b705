// SPDX-License-Identifier: GPL-3.0-or-later
// Classes, and changing teams and robots.
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/project/sample_records.h"
#include "tests/support/registered_test.h"

#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestClasses : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project =
            std::move(*Project::create(m_folder->filePath(QStringLiteral("year.odo")).toStdString(), "Year"));
    }

    void classesAreKept()
    {
        const auto b = m_project->classes().add("9B"), a = m_project->classes().add("9A");
        QVERIFY(a && b);
        QCOMPARE(m_project->classes().add("9A").error().code, ErrorCode::AlreadyExists);
        QCOMPARE(m_project->classes().add("").error().code, ErrorCode::InvalidInput);
        QVERIFY(m_project->teams().add({0, "Falcon", "9B"}));
        QVERIFY(m_project->classes().rename(b->id, "10B"));
        QCOMPARE(m_project->classes().rename(b->id, "9A").error().code, ErrorCode::AlreadyExists);
        QCOMPARE(m_project->classes().rename(99, "9C").error().code, ErrorCode::NotFound);
        QCOMPARE(m_project->teams().find("Falcon")->className, std::string("10B"));
        const auto all = m_project->classes().all().value();
        QCOMPARE(all.size(), std::size_t(2));
        QVERIFY(all[0].name == "10B" && all[0].teams == 1 && all[1].name == "9A" && all[1].teams == 0);
    }

    void aClassIsArchivedAndComesBack()
    {
        const RecordId id = m_project->classes().add("9B")->id;
        QVERIFY(m_project->change(foreignWords("archive class 9B"),
                                  [&] { return m_project->classes().setArchived(id, true); }));
        const auto since = m_project->classes().get(id)->archived;
        QVERIFY(since.has_value());
        QVERIFY(m_project->classes().setArchived(id, true)); // again changes nothing
        QVERIFY(m_project->classes().get(id)->archived == since);
        QVERIFY(m_project->undo());
        QVERIFY(!m_project->classes().get(id)->archived);
        QVERIFY(m_project->classes().setArchived(id, true));
        QVERIFY(m_project->classes().setArchived(id, false));
        QVERIFY(!m_project->classes().get(id)->archived);
    }

    void whatIsUsedIsNotRemoved()
    {
        const RecordId id = m_project->classes().add("9B")->id;
        const auto team = m_project->teams().add({0, "Falcon", "9B"});
        QCOMPARE(
            QString::fromStdString(m_project->classes().remove(id).error().message()),
            QStringLiteral(
                "class '9B': a team belongs to it; move its teams to another class first, or archive it"));
        TrialRecord trial;
        trial.name = "Falcon 1";
        trial.team = team->id;
        QVERIFY(m_project->trials().add(trial, {}));
        QCOMPARE(
            QString::fromStdString(m_project->teams().remove(team->id).error().message()),
            QStringLiteral(
                "team 'Falcon': it has a trial; delete its trials permanently first, or archive its class"));
        const auto spare = m_project->teams().add({0, "Heron", "9B"});
        QVERIFY(m_project->teams().remove(spare->id));
        QCOMPARE(m_project->teams().remove(spare->id).error().code, ErrorCode::NotFound);
        const RecordId empty = m_project->classes().add("9C")->id;
        QVERIFY(m_project->classes().remove(empty));
        QCOMPARE(m_project->classes().all()->size(), std::size_t(1));
    }

    void aRobotIsChangedAndRemoved()
    {
        RecordSource source(4);
        const FilledProject filled = *fill(*m_project, source);
        RobotRecord robot = *m_project->robots().get(filled.robot);
        robot.name = "Red";
        robot.colour = {1, 2, 3};
        robot.heightMode = RobotRecord::Height::Given;
        robot.heightM = 0.08;
        QVERIFY(m_project->robots().set(robot));
        QCOMPARE(m_project->robots().find("Red")->heightM, std::optional(0.08));
        QCOMPARE(m_project->robots().find("Red")->colour->toString(), std::string("#010203"));
        robot.heightM.reset();
        QCOMPARE(m_project->robots().set(robot).error().code, ErrorCode::InvalidInput);
        RobotRecord spare;
        spare.name = "Blue";
        const auto added = m_project->robots().add(spare);
        robot.heightM = 0.08;
        robot.name = "Blue";
        QCOMPARE(m_project->robots().set(robot).error().code, ErrorCode::AlreadyExists);
        QCOMPARE(m_project->robots().remove(filled.robot).error().why.english(),
                 std::string("a trial uses it"));
        QVERIFY(m_project->robots().remove(added->id));
        QCOMPARE(m_project->robots().remove(added->id).error().code, ErrorCode::NotFound);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestClasses, QCoreApplication)
#include "tst_classes.moc"
