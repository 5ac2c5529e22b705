// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/mnemonics.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/classes_dialog.h"
#include "ui/history/history_page.h"
#include "ui/history/internal/trial_list.h"
#include "ui/models/project_changes.h"
#include "ui/models/shown_names.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

namespace {

const QKeySequence undoKeys(Qt::CTRL | Qt::Key_Z), redoKeys(Qt::CTRL | Qt::SHIFT | Qt::Key_Z);

} // namespace

class TestClassesDialog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_project = openStoredExample(m_folder->path().toStdString());
    }
    void classesAreMadeRenamedAndDeleted();
    void teamsAreMadeRenamedAndMoved();
    void membersAndRobotsAreWritten();
    void anArchivedClassIsOutOfTheWay();
    void onlyWhatWasDoneHereIsTakenBack();
    void whatIsReadOnlyIsNotChanged();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<Project> m_project;
};

void TestClassesDialog::membersAndRobotsAreWritten()
{
    ClassesDialog dialog(*m_project);
    auto *table = dialog.findChild<QTableWidget *>();
    dialog.findChild<QListWidget *>()->setCurrentRow(0);
    table->setCurrentCell(0, 0);
    const auto team = [&] { return *m_project->teams().find("Falcon"); };
    QVERIFY(team().members.empty());
    const auto write = [](const QString &members, bool withRobot) {
        return Answer([=](QDialog &asked) {
            asked.findChild<QPlainTextEdit *>()->setPlainText(members);
            asked.findChild<QListWidget *>()->item(0)->setCheckState(withRobot ? Qt::Checked : Qt::Unchecked);
            asked.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok)->click();
        });
    };
    {
        Person person({write(QStringLiteral("Anna\n\n  Ben \n"), true)});
        button(dialog, "Members and r&obots…")->click();
        QVERIFY(person.isDone());
    }
    QCOMPARE(team().members, (std::vector<std::string>{"Anna", "Ben"}));
    QCOMPARE(team().robots, std::vector<RecordId>{m_project->robots().all()->front().id});
    QCOMPARE(table->item(0, 2)->text(), QStringLiteral("Anna, Ben"));
    QVERIFY(!table->item(0, 3)->text().isEmpty());
    QVERIFY(!(table->item(0, 2)->flags() & Qt::ItemIsEditable));
    {
        Person person({write(QStringLiteral("Anna\nBen"), true)}); // the same again is no change
        button(dialog, "Members and r&obots…")->click();
        QVERIFY(person.isDone());
    }
    QCOMPARE(m_project->changes()->size(), std::size_t(1));
    {
        Person person({write(QString(201, u'x'), true)});
        button(dialog, "Members and r&obots…")->click();
        QVERIFY(person.isDone());
    }
    const QString told = named<QLabel>(dialog, "What was done")->text();
    QVERIFY2(told.startsWith(QLatin1String("name of a member: it has 201 characters")), qPrintable(told));
    pressKeys(dialog, undoKeys);
    QVERIFY(team().members.empty() && team().robots.empty());
    pressKeys(dialog, redoKeys);
    QCOMPARE(team().members.size(), std::size_t(2));
    showPseudonyms(true);
    QCOMPARE(shownMembers(team()), QStringLiteral("2 member(s)")); // tests have no translation
    QVERIFY(shownMembers({}).isEmpty());
    showPseudonyms(false);
}

void TestClassesDialog::classesAreMadeRenamedAndDeleted()
{
    ClassesDialog dialog(*m_project);
    QSignalSpy changed(&dialog, &ClassesDialog::changed);
    auto *list = dialog.findChild<QListWidget *>();
    QVERIFY2(sharedMnemonics(dialog).isEmpty(), qPrintable(sharedMnemonics(dialog).join(u'\n')));
    {
        Person person({enterText(QStringLiteral("9C & co"))});
        button(dialog, "&New class…")->click();
        QVERIFY(person.isDone());
    }
    QCOMPARE(changed.count(), 1);
    QVERIFY(list->currentItem()->text().startsWith(QLatin1String("9C & co"))); // it is chosen at once
    {
        Person person({enterText(QStringLiteral("9B"))});
        button(dialog, "&Rename…")->click();
        QVERIFY(person.isDone());
    }
    QVERIFY(named<QLabel>(dialog, "What was done")->text().startsWith(QLatin1String("class '9B': ")));
    QVERIFY(m_project->classes().all()->size() == 2);
    button(dialog, "Dele&te")->click();
    QCOMPARE(m_project->classes().all()->size(), std::size_t(1));
    pressKeys(dialog, undoKeys);
    QCOMPARE(m_project->classes().all()->size(), std::size_t(2));
    list->setCurrentRow(0);
    QVERIFY(!button(dialog, "Dele&te")->isEnabled()); // it has teams
}

void TestClassesDialog::teamsAreMadeRenamedAndMoved()
{
    QVERIFY(m_project->classes().add("9C"));
    ClassesDialog dialog(*m_project);
    auto *table = dialog.findChild<QTableWidget *>();
    dialog.findChild<QListWidget *>()->setCurrentRow(0);
    QCOMPARE(table->rowCount(), 2);
    const auto find = [&](const char *name) { return m_project->teams().find(name); };
    table->item(0, 1)->setText(QStringLiteral("Team 4"));
    QCOMPARE(find("Falcon")->pseudonym, std::string("Team 4"));
    table->item(0, 0)->setText(QStringLiteral("Heron")); // taken
    QVERIFY(named<QLabel>(dialog, "What was done")->text().startsWith(QLatin1String("team 'Heron': ")));
    QCOMPARE(table->item(0, 0)->text(), QStringLiteral("Falcon")); // what is stored stands there again
    table->item(0, 0)->setText(QStringLiteral("Merlin"));
    QCOMPARE(table->item(table->currentRow(), 0)->text(),
             QStringLiteral("Merlin")); // chosen still, though it stands elsewhere now
    QVERIFY(find("Merlin") && !find("Falcon"));
    button(dialog, "&Move to")->menu()->actions().front()->trigger();
    QCOMPARE(find("Merlin")->className, std::string("9C"));
    {
        Person person({enterText(QStringLiteral("Otter"))});
        button(dialog, "New t&eam…")->click();
        QVERIFY(person.isDone());
    }
    QCOMPARE(find("Otter")->className, std::string("9B"));
    dialog.findChild<QListWidget *>()->setCurrentRow(0);
    for (int row = 0; row < table->rowCount(); ++row)
        if (table->item(row, 0)->text() == QLatin1String("Otter"))
            table->setCurrentCell(row, 0);
    button(dialog, "&Delete")->click();
    QVERIFY(!find("Otter"));
    button(dialog, "&Delete")->click(); // Heron has trials
    QVERIFY(find("Heron").has_value());
    QVERIFY(named<QLabel>(dialog, "What was done")->text().contains(QLatin1String("it has a trial")));
    QSignalSpy roster(&dialog, &ClassesDialog::rosterRequested);
    button(dialog, "&Import roster…")->click();
    QCOMPARE(roster.count(), 1);
}

void TestClassesDialog::anArchivedClassIsOutOfTheWay()
{
    HistoryPage page(*m_project);
    page.refresh();
    auto *model = page.findChild<QTableView *>(QStringLiteral("trials"))->model();
    QCOMPARE(model->rowCount(), 3);
    {
        ClassesDialog dialog(*m_project);
        dialog.findChild<QListWidget *>()->setCurrentRow(0);
        button(dialog, "&Archive")->click();
        QVERIFY(dialog.findChild<QListWidget *>()->item(0)->text().contains(QLatin1String("archived")));
    }
    page.refresh();
    QCOMPARE(model->rowCount(), 1); // that without a team
    QComboBox *classes = nullptr, *where = nullptr;
    for (QComboBox *box : page.findChild<TrialFilterBar *>()->findChildren<QComboBox *>()) {
        if (box->accessibleName() == QLatin1String("Class"))
            classes = box;
        if (box->accessibleName() == QLatin1String("Where"))
            where = box;
    }
    where->setCurrentIndex(1);
    QCOMPARE(model->rowCount(), 2);
    where->setCurrentIndex(0);
    classes->setCurrentIndex(classes->findText(QStringLiteral("9B (archived)")));
    QCOMPARE(model->rowCount(), 2); // asked for by name
}

void TestClassesDialog::onlyWhatWasDoneHereIsTakenBack()
{
    QVERIFY(m_project->change(foreignWords("star"), [&] {
        return m_project->trials().setStarred(m_project->trials().find("Trial 1")->id, true);
    }));
    OwnChanges own(*m_project);
    QCOMPARE(own.undo().error().code, ErrorCode::NotFound);
    const auto rename = [&](const char *name) {
        return [this, name] {
            return m_project->classes().rename(m_project->classes().all()->front().id, name);
        };
    };
    QVERIFY(own.make(foreignWords("nothing"), rename("9B"))->isEmpty()); // it has that name
    QCOMPARE(own.undo().error().code, ErrorCode::NotFound);
    QCOMPARE(*own.make(foreignWords("rename"), rename("9X")),
             QStringLiteral("Done: rename. Press Ctrl+Z to undo it."));
    QCOMPARE(*own.undo(), QStringLiteral("Undone: rename."));
    QCOMPARE(m_project->classes().all()->front().name, std::string("9B"));
    QCOMPARE(*own.redo(), QStringLiteral("Redone: rename."));
    QCOMPARE(own.redo().error().code, ErrorCode::NotFound);
    QVERIFY(own.undo() && !own.undo());
    QVERIFY(m_project->trials().find("Trial 1")->starred);
}

void TestClassesDialog::whatIsReadOnlyIsNotChanged()
{
    ClassesDialog dialog(*m_project, true);
    for (const char *text : {"&New class…", "&Rename…", "&Archive", "Dele&te", "New t&eam…", "&Move to",
                             "&Delete", "&Import roster…"})
        QVERIFY(!button(dialog, text)->isEnabled());
    QVERIFY(dialog.findChild<QTableWidget *>()->editTriggers() == QAbstractItemView::NoEditTriggers);
}

ODOGRAPH_TEST(TestClassesDialog, QApplication)
#include "tst_classes_dialog.moc"
