// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo in the window: what a person changed is taken back, and what is shown follows.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "tests/ui/support/person.h"
#include "tests/ui/support/project_content.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/history_page.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/review/review_page.h"

#include <QApplication>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;
using namespace odo::test;

class TestUndo : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_window = std::make_unique<MainWindow>();
        QVERIFY(m_window->openProject(*made));
        QTRY_VERIFY(!m_window->workspace().isBusy()); // with what is made up for on opening
        m_window->showMode(MainWindow::Mode::History);
        for (QMenu *menu : m_window->menuBar()->findChildren<QMenu *>())
            if (menu->title() == QLatin1String("&Edit"))
                m_edit = menu;
        QVERIFY(m_edit);
    }
    void cleanupTestCase() { m_window.reset(); }

    void saysWhenThereIsNothing()
    {
        openMenu();
        QVERIFY(!undo()->isEnabled() && !redo()->isEnabled());
        closeMenu();
        undo()->trigger();
        QVERIFY(message().contains(QLatin1String("nothing has been changed since the project was opened")));
    }

    void takesNotesBackThatAreStillBeingWritten()
    {
        auto *page = m_window->findChild<HistoryPage *>();
        page->selectTrial(QStringLiteral("Trial 2"));
        auto *notes = page->findChild<QPlainTextEdit *>();
        const QStringList before = contentOf(project());
        notes->setPlainText(QStringLiteral("slipped & slid"));
        openMenu(); // stores them, so that the menu speaks of them
        QCOMPARE(undo()->text(), QStringLiteral("&Undo: write notes of Trial 2"));
        closeMenu();
        const QStringList written = contentOf(project());
        QVERIFY(written != before);
        undo()->trigger();
        QCOMPARE(notes->toPlainText(), QString());
        QCOMPARE(contentOf(project()), before);
        QCOMPARE(message(), QStringLiteral("Undone: write notes of Trial 2."));
        redo()->trigger();
        QCOMPARE(notes->toPlainText(), QStringLiteral("slipped & slid"));
        QCOMPARE(contentOf(project()), written);
        const auto changes = project().changes().value();
        QCOMPARE(changes.size(), std::size_t(3));
        QVERIFY(changes.front().kind == ChangeEntry::Kind::Redone);
    }

    /// Edited in the window, Review shows the trial under its new name, and again under the old one.
    void aTrialIsRenamedAndBackAgain()
    {
        QVERIFY(m_window->showTrial("Trial 2"));
        QTRY_VERIFY(m_window->windowTitle().contains(QLatin1String("Trial 2")));
        const auto rename = [](QDialog &dialog) {
            named<QLineEdit>(dialog, "Name")->setText(QStringLiteral("Final"));
            press(dialog);
        };
        Person person({rename});
        actionOf(*m_window, "Edit…")->trigger();
        QVERIFY(person.isDone());
        QCOMPARE(message(), QStringLiteral("1 trial(s) changed. Choose Undo to reverse this."));
        QTRY_COMPARE(m_window->findChild<ReviewPage *>()->trial(), QStringLiteral("Final"));
        QTRY_VERIFY(m_window->windowTitle().contains(QLatin1String("Final")));
        undo()->trigger();
        QTRY_COMPARE(m_window->findChild<ReviewPage *>()->trial(), QStringLiteral("Trial 2"));
        QTRY_VERIFY(m_window->windowTitle().contains(QLatin1String("Trial 2")));
    }

    /// In History it edits what is selected there.
    void selectedTrialsAreEdited()
    {
        m_window->showMode(MainWindow::Mode::History);
        auto *page = m_window->findChild<HistoryPage *>();
        auto *table = page->findChild<QTableView *>(QStringLiteral("trials"));
        table->selectAll();
        const auto tag = [](QDialog &dialog) {
            named<QLineEdit>(dialog, "Tags")->setText(QStringLiteral("league"));
            press(dialog);
        };
        Person person({tag});
        actionOf(*m_window, "Edit…")->trigger();
        QVERIFY(person.isDone());
        for (const char *trial : {"Trial 1", "Trial 2", "Trial 3"})
            QCOMPARE(project().trials().find(trial)->tags, std::vector<std::string>{"league"});
        QCOMPARE(page->selectedTrials().size(), qsizetype(3));
        undo()->trigger();
        QVERIFY(project().trials().find("Trial 3")->tags.empty());
    }

private:
    Project &project() const { return *m_window->workspace().project(); }
    QAction *undo() const { return m_edit->actions().at(0); }
    QAction *redo() const { return m_edit->actions().at(1); }
    void openMenu() const { Q_EMIT m_edit->aboutToShow(); }
    void closeMenu() const { Q_EMIT m_edit->aboutToHide(); }
    QString message() const { return m_window->findChild<MessageBar *>()->text(); }

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;
    QMenu *m_edit = nullptr;
};

ODOGRAPH_TEST(TestUndo, QApplication)
#include "tst_undo.moc"
