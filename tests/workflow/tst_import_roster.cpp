// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/import/teams.h"
#include "tests/support/registered_test.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestImportRoster : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project =
            std::move(*Project::create(m_folder->filePath(QStringLiteral("year.odo")).toStdString(), "Year"));
    }

    void teamsAreTakenOver()
    {
        QVERIFY(m_project->teams().add({0, "Heron", "9A", "Team 1"}));
        QVERIFY(m_project->teams().add({0, "Owl", "9B", ""}));
        const auto outcome = import("\xef\xbb\xbfTeam,Members,class,Pseudonym\r\nFalcon,\"Ann, Ben\",9B,Team "
                                    "4\r\n\r\nHeron,Cy,9B,\r\nOwl,,9B,\r\n");
        QVERIFY2(outcome, outcome ? "" : outcome.error().message().c_str());
        QVERIFY(outcome->added == 1 && outcome->changed == 1 && outcome->unchanged == 1);
        QVERIFY(team("Falcon").className == "9B" && team("Falcon").pseudonym == "Team 4");
        QVERIFY(team("Heron").className == "9B" && team("Heron").pseudonym == "Team 1"); // nothing told: kept
        QCOMPARE(m_project->undo().value().english(), std::string("import the roster roster.csv"));
        QCOMPARE(m_project->teams().all()->size(), std::size_t(2));
        QCOMPARE(team("Heron").className, std::string("9A"));
    }

    void membersAreTaken()
    {
        QVERIFY(import("class,members,team\n9B,\" Anna ;;Zoë;\",Falcon\n9B,,Heron\n"));
        QCOMPARE(team("Falcon").members, (std::vector<std::string>{"Anna", "Zoë"}));
        QVERIFY(team("Heron").members.empty());
        const auto again = import("class,members,team\n9B,,Falcon\n9B,Ben,Heron\n");
        QVERIFY(again && again->unchanged == 1 && again->changed == 1); // nothing told: kept
        QCOMPARE(team("Falcon").members.size(), std::size_t(2));
        QCOMPARE(team("Heron").members, std::vector<std::string>{"Ben"});
    }

    void aSecondTimeNothingChanges()
    {
        QVERIFY(import("class,team\n9B,Falcon\n"));
        const auto again = import("class,team\n9B,Falcon\n");
        QVERIFY(again && again->unchanged == 1 && again->added == 0 && again->changed == 0);
        QCOMPARE(m_project->changes()->size(), std::size_t(1));
    }

    void badLinesAreTold_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("why");
        QTest::addRow("empty") << QByteArray() << "the file is empty";
        QTest::addRow("no team column")
            << QByteArray("class,name\n9B,Falcon\n") << "it lacks the column team";
        QTest::addRow("no class column") << QByteArray("team\nFalcon\n") << "it lacks the column class";
        QTest::addRow("semicolons") << QByteArray("class;team\n9B;Falcon\n")
                                    << "its columns are separated by semicolons";
        QTest::addRow("header alone") << QByteArray("class,team\n") << "it has no team";
        QTest::addRow("each bad line")
            << QByteArray("class,team\n9B,Falcon\n9B,\n,Owl\n9C,Falcon\n9B,Heron\n")
            << "line 3 has no team; line 4 has no class for team 'Owl'; line 5 names team 'Falcon' again, as "
               "line 2";
        QTest::addRow("a short line") << QByteArray("class,team\n9B\n") << "line 2 has no team";
        QTest::addRow("no quotes at the end")
            << QByteArray("class,team\n9B,\"Fal\n") << "a quoted cell does not end";
        QTest::addRow("names that cannot be")
            << QByteArray("class,team\n9B,Falcon\n9B," + QByteArray(201, 'x') + "\n9B,two\x01words\n")
            << "line 3: ";
        QTest::addRow("very many") << "class,team\n" + QByteArray("9B,\n").repeated(12)
                                   << "; line 11 has no team; and 2 more lines";
    }
    void badLinesAreTold()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QString, why);
        const auto outcome = import(text);
        QVERIFY(!outcome);
        QCOMPARE(outcome.error().code, ErrorCode::InvalidInput);
        QVERIFY2(QString::fromStdString(outcome.error().why.english()).contains(why),
                 outcome.error().why.english().c_str());
        QVERIFY(m_project->teams().all()->empty());
        QVERIFY(m_project->changes()->empty());
    }

    void aFileThatIsNotThere()
    {
        QCOMPARE(importRoster(*m_project, m_folder->filePath(QStringLiteral("none.csv")).toStdString())
                     .error()
                     .code,
                 ErrorCode::NotFound);
    }

private:
    Result<RosterOutcome> import(const QByteArray &text)
    {
        QFile file(m_folder->filePath(QStringLiteral("roster.csv")));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("no roster");
        file.close();
        return importRoster(*m_project, file.fileName().toStdString());
    }
    TeamRecord team(const std::string &name) const { return m_project->teams().find(name).value(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestImportRoster, QCoreApplication)
#include "tst_import_roster.moc"
