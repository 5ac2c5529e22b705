// SPDX-License-Identifier: GPL-3.0-or-later
// Pages read the project when they are seen, and only then.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/stored_example.h"
#include "ui/history/history_page.h"
#include "ui/main_window/project_pages.h"
#include "ui/main_window/workspace.h"
#include "ui/review/review_page.h"
#include "ui/testbed/testbed_page.h"

#include <QApplication>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

class TestProjectPages : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        const auto made = storeExample(m_folder.path().toStdString());
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        QVERIFY(m_workspace.open(*made));
        QTRY_VERIFY(!m_workspace.isBusy());
    }
    void init()
    {
        m_stack = std::make_unique<QStackedWidget>();
        m_stack->addWidget(new QWidget); // as the page of welcome
        m_pages = std::make_unique<ProjectPages>(m_workspace, *m_stack);
    }
    void cleanup()
    {
        m_pages.reset();
        QCOMPARE(m_stack->count(), 1); // the pages went with it
    }

    void areMadeOneAfterTheOther()
    {
        QSignalSpy made(m_pages.get(), &ProjectPages::made);
        m_pages->makeSoon();
        QCOMPARE(made.count(), 0);
        QVERIFY(!m_pages->isSettled());
        QTRY_COMPARE(made.count(), int(allModes.size()));
        QCOMPARE(made.front().front().value<ProjectPages::Mode>(), ProjectPages::Mode::Review);
        QVERIFY(qobject_cast<ReviewPage *>(m_stack->currentWidget()));
        QTRY_VERIFY(m_pages->scene());
    }

    void aPageThatIsAskedForComesAtOnceAndStays()
    {
        QSignalSpy made(m_pages.get(), &ProjectPages::made);
        m_pages->makeSoon();
        m_pages->show(ProjectPages::Mode::History);
        QCOMPARE(made.count(), 1);
        QTRY_COMPARE(made.count(), int(allModes.size()));
        QVERIFY(qobject_cast<HistoryPage *>(m_stack->currentWidget()));
    }

    void nothingIsReadBeforeItIsShown()
    {
        QCOMPARE(rowsIn("Trials", m_pages->history()), 0);
        QCOMPARE(rowsIn("Cameras", m_pages->testbed()), 0);
        m_pages->show(ProjectPages::Mode::History);
        QCOMPARE(rowsIn("Trials", m_pages->history()), 3);
        QCOMPARE(rowsIn("Cameras", m_pages->testbed()), 0);
        m_pages->show(ProjectPages::Mode::Testbed);
        QCOMPARE(rowsIn("Cameras", m_pages->testbed()), 2);
    }

    void aHiddenPageReadsWhatChangedWhenItIsShown()
    {
        QSignalSpy changed(m_pages.get(), &ProjectPages::changed);
        m_pages->show(ProjectPages::Mode::History);
        m_pages->show(ProjectPages::Mode::Testbed);
        setBinned(true);
        m_pages->refresh();
        QCOMPARE(changed.count(), 1);
        QCOMPARE(rowsIn("Trials", m_pages->history()), 3);
        m_pages->show(ProjectPages::Mode::History);
        QCOMPARE(rowsIn("Trials", m_pages->history()), 2);
        setBinned(false);
        m_pages->refresh(); // it is on screen
        QCOMPARE(rowsIn("Trials", m_pages->history()), 3);
    }

    void thePageThatChangedSomethingKeepsWhatItShows()
    {
        m_pages->show(ProjectPages::Mode::History);
        setBinned(true);
        QSignalSpy messageReady(m_pages.get(), &ProjectPages::messageReady);
        Q_EMIT m_pages->history().trialsChanged(QStringLiteral("One trial is gone."));
        QCOMPARE(messageReady.count(), 1);
        QCOMPARE(rowsIn("Trials", m_pages->history()), 3);
        setBinned(false);
    }

    void refusesTrialsThatAreNotThere()
    {
        const auto shown = m_pages->showTrial("Trial 9");
        QVERIFY(!shown);
        QCOMPARE(shown.error().code, ErrorCode::NotFound);
        const auto compared = m_pages->compareTrials({QStringLiteral("Trial 1"), QStringLiteral("Trial 9")});
        QVERIFY(!compared);
        QVERIFY2(compared.error().message().find("Trial 9") != std::string::npos,
                 compared.error().message().c_str());
        QCOMPARE(m_stack->currentIndex(), 0);
    }

private:
    static int rowsIn(const char *name, const QWidget &page)
    {
        for (const QTableView *table : page.findChildren<QTableView *>())
            if (table->accessibleName() == QLatin1String(name))
                return table->model()->rowCount();
        return -1;
    }
    void setBinned(bool binned)
    {
        TrialRepository &trials = m_workspace.project()->trials();
        QVERIFY(trials.setBinned(trials.find("Trial 3")->id, binned));
    }

    QTemporaryDir m_folder;
    Workspace m_workspace;
    std::unique_ptr<QStackedWidget> m_stack;
    std::unique_ptr<ProjectPages> m_pages;
};

ODOGRAPH_TEST(TestProjectPages, QApplication)
#include "tst_project_pages.moc"
