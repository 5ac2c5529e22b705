// SPDX-License-Identifier: GPL-3.0-or-later
// In the stored example Trial 1 is of team Falcon and Trial 2 of Heron, both of class 9B; Trial 3 has no
// team.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/mnemonics.h"
#include "tests/ui/support/stored_example.h"
#include "ui/main_window/internal/edit_trial_dialog.h"
#include "ui/main_window/internal/variable_table.h"
#include "ui/views/widgets/form_fields.h"

#include <QApplication>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

/// The button in place of a field in which the trials differ; null: they do not.
QPushButton *several(const QDialog &dialog, const char *field)
{
    const QString name = QString::fromUtf8(field) + QStringLiteral(": several");
    for (auto *each : dialog.findChildren<QPushButton *>())
        if (each->accessibleName() == name && each->isVisibleTo(&dialog))
            return each;
    return nullptr;
}

void setVariable(VariableTable &table, int row, const char *name, const char *value)
{
    table.item(row, VariableTable::NameColumn)->setText(QString::fromUtf8(name));
    table.item(row, VariableTable::ValueColumn)->setText(QString::fromUtf8(value));
}

} // namespace

class TestEditTrialDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = openStoredExample(m_folder->path().toStdString());
    }

    void whatIsNotTouchedStays()
    {
        EditTrialDialog dialog(*m_project, trials({"Trial 1"}));
        QVERIFY(isEmpty(dialog.edit()));
        EditTrialDialog both(*m_project, trials({"Trial 1", "Trial 2"}));
        QVERIFY(isEmpty(both.edit()));
        const std::size_t before = m_project->changes()->size();
        both.accept();
        QCOMPARE(both.result(), int(QDialog::Accepted));
        QCOMPARE(m_project->changes()->size(), before);
        QCOMPARE(sharedMnemonics(dialog), QStringList());
    }

    void aTrialIsEditedAndUndone()
    {
        QVERIFY(m_project->tasks().add({0, "Circle", {}}));
        EditTrialDialog dialog(*m_project, trials({"Trial 1"}));
        named<QLineEdit>(dialog, "Name")->setText(QStringLiteral("Final"));
        auto *team = named<QComboBox>(dialog, "Team"), *ofClass = named<QComboBox>(dialog, "Class");
        team->setCurrentText(QString());
        QCOMPARE(ofClass->currentText(), QString()); // without a team it has none
        team->setCurrentText(QStringLiteral("Heron"));
        QCOMPARE(ofClass->currentText(), QStringLiteral("9B"));
        const QDateTime moment(QDate(2026, 3, 4), QTime(10, 30));
        named<QDateTimeEdit>(dialog, "Date and time")->setDateTime(moment);
        named<QComboBox>(dialog, "Task")->setCurrentText(QStringLiteral("Circle"));
        named<CheckList>(dialog, "Robots")->setChecked({QStringLiteral("Blue 1")});
        named<QLineEdit>(dialog, "Tags")->setText(QStringLiteral("wet, final,"));
        named<QPlainTextEdit>(dialog, "Notes")->setPlainText(QStringLiteral("two\nlines"));
        auto *variables = dialog.findChild<VariableTable *>();
        QCOMPARE(variables->rowCount(), 1);
        setVariable(*variables, 0, "surface", "carpet");
        setVariable(*variables, 1, "battery", "7,4"); // a row more has come
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const TrialRecord trial = *m_project->trials().find("Final");
        QCOMPARE(trial.teamName, std::string("Heron"));
        QCOMPARE(qint64(trial.date.time_since_epoch().count()), moment.toMSecsSinceEpoch());
        QCOMPARE(trial.task, std::string("Circle"));
        QCOMPARE(trial.robotNames, std::vector<std::string>{"Blue 1"});
        QCOMPARE(trial.tags, (std::vector<std::string>{"final", "wet"}));
        QCOMPARE(trial.notes, std::string("two\nlines"));
        QCOMPARE(trial.variables,
                 (std::map<std::string, std::string>{{"battery", "7.4"}, {"surface", "carpet"}}));
        QVERIFY(m_project->undo());
        const TrialRecord before = *m_project->trials().find("Trial 1");
        QVERIFY(before.id == trial.id && before.teamName == "Falcon" && before.variables.empty());
    }

    void severalAreEditedAtOnce()
    {
        const auto set = [&](const char *name, const std::map<std::string, std::string> &variables) {
            QVERIFY(m_project->trials().setVariables(m_project->trials().find(name)->id, variables));
        };
        set("Trial 1", {{"surface", "carpet"}, {"attempt", "1"}, {"battery", "7.4"}});
        set("Trial 2", {{"surface", "carpet"}, {"attempt", "2"}});
        EditTrialDialog dialog(*m_project, trials({"Trial 1", "Trial 2"}));
        for (const QLineEdit *line : dialog.findChildren<QLineEdit *>()) // a name is one trial's
            QVERIFY(line->accessibleName() != QLatin1String("Name"));
        QVERIFY(several(dialog, "Team") && several(dialog, "Date and time") && !several(dialog, "Class"));
        named<QLineEdit>(dialog, "Tags")->setText(QStringLiteral("league"));
        several(dialog, "Notes")->click();
        named<QPlainTextEdit>(dialog, "Notes")->setPlainText(QString());
        QVERIFY(!several(dialog, "Notes"));
        auto *variables = dialog.findChild<VariableTable *>();
        QCOMPARE(variables->rowCount(), 4); // attempt, battery, surface and an empty one
        QCOMPARE(variables->item(0, 0)->text(), QStringLiteral("attempt"));
        variables->setCurrentCell(2, 0);
        variables->removeCurrent(); // the surface
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const TrialRecord first = *m_project->trials().find("Trial 1"),
                          second = *m_project->trials().find("Trial 2");
        QVERIFY(first.teamName == "Falcon" && second.teamName == "Heron"); // several stay several
        QVERIFY(first.tags == second.tags && first.tags == std::vector<std::string>{"league"});
        QVERIFY(first.notes.empty() && second.notes.empty());
        QCOMPARE(first.variables, (std::map<std::string, std::string>{{"attempt", "1"}, {"battery", "7.4"}}));
        QCOMPARE(second.variables, (std::map<std::string, std::string>{{"attempt", "2"}}));
        QCOMPARE(m_project->changes()->front().words.english(), std::string("edit 2 trials"));
    }

    void severalIsWrittenOver()
    {
        QVERIFY(m_project->trials().setVariables(m_project->trials().find("Trial 1")->id, {{"v", "1"}}));
        EditTrialDialog dialog(*m_project, trials({"Trial 1", "Trial 2"}));
        dialog.show();
        auto *variables = dialog.findChild<VariableTable *>();
        variables->setFocus();
        variables->setCurrentCell(0, VariableTable::ValueColumn);
        const auto writeByF2 = [variables](const QString &text) {
            QTest::keyClick(variables, Qt::Key_F2);
            auto *line = variables->viewport()->findChild<QLineEdit *>();
            QVERIFY(line && line->text().isEmpty());
            QTest::keyClicks(line, text);
            QTest::keyClick(line, Qt::Key_Return);
            QTRY_VERIFY(!variables->viewport()->findChild<QLineEdit *>());
        };
        writeByF2({}); // only looked at
        QVERIFY(dialog.edit().variables.empty());
        writeByF2(QStringLiteral("2"));
        QCOMPARE(dialog.edit().variables, (std::map<std::string, std::string>{{"v", "2"}}));
    }

    void aRefusalKeepsTheDialog()
    {
        EditTrialDialog dialog(*m_project, trials({"Trial 1"}));
        auto *name = named<QLineEdit>(dialog, "Name");
        name->setText(QStringLiteral("Trial 2"));
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Rejected)); // still open
        QVERIFY(says(dialog, "the project already has a trial of that name"));
        QCOMPARE(name->text(), QStringLiteral("Trial 2"));
        name->setText(QStringLiteral("Final"));
        auto *variables = dialog.findChild<VariableTable *>();
        setVariable(*variables, 0, "surface", "wood");
        setVariable(*variables, 1, "surface", "carpet");
        dialog.accept();
        QVERIFY(says(dialog, "The variable surface is in the table twice."));
        QVERIFY(m_project->trials().find("Trial 1"));
        setVariable(*variables, 1, "", "carpet"); // a value of nothing
        dialog.accept();
        QCOMPARE(dialog.result(), int(QDialog::Rejected));
        QVERIFY(m_project->trials().find("Trial 1"));
    }

    void aNewTeamIsOfTheClass()
    {
        EditTrialDialog dialog(*m_project, trials({"Trial 1"}));
        named<QComboBox>(dialog, "Team")->setCurrentText(QStringLiteral("Owl"));
        dialog.accept();
        QCOMPARE(m_project->teams().find("Owl")->className, std::string("9B"));
        QCOMPARE(dialog.trials().front().teamName, std::string("Owl"));
    }

private:
    std::vector<TrialRecord> trials(std::initializer_list<const char *> names) const
    {
        std::vector<TrialRecord> trials;
        for (const char *name : names)
            trials.push_back(*m_project->trials().find(name));
        return trials;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

ODOGRAPH_TEST(TestEditTrialDialog, QApplication)
#include "tst_edit_trial_dialog.moc"
