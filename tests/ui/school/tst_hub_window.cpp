// SPDX-License-Identifier: GPL-3.0-or-later
// The hub in the main window: the menu, the foot, and what a conflict says.
#include "core/project/repositories.h"
#include "core/project/school_repository.h"
#include "tests/support/registered_test.h"
#include "tests/ui/school/hub_bench.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/history/history_page.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/school/hub_dialog.h"
#include "ui/school/hub_runs_panel.h"

#include <QApplication>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

using namespace odo;
using namespace odo::test;

namespace {

constexpr int longMs = 60'000;

QString footOf(const MainWindow &window)
{
    for (const QToolButton *each : window.findChild<StatusLine *>()->findChildren<QToolButton *>())
        if (each->isVisibleTo(each->window()))
            return each->text();
    return {};
}

} // namespace

class TestHubWindow : public QObject
{
    Q_OBJECT
    HubBench m_bench;
    std::filesystem::path m_file;

private Q_SLOTS:
    void initTestCase()
    {
        beginWithoutSettings();
        const QString problem = m_bench.start();
        if (!problem.isEmpty())
            QSKIP(qPrintable(QStringLiteral("ODOGRAPH-SKIPPED: ") + problem));
    }
    void init()
    {
        m_bench.clear();
        m_file = m_bench.project("bench.odo", 2)->file();
    }

    void theFootSaysHowTheHubIs()
    {
        MainWindow window;
        window.show();
        QVERIFY(!actionOf(window, "School hub…")->isEnabled());
        QVERIFY(window.openProject(m_file));
        QCOMPARE(footOf(window), QString());
        QVERIFY(connectToSchool(*window.workspace().project(), m_bench.address("bench1"), {}));
        QTRY_VERIFY_WITH_TIMEOUT(footOf(window).endsWith(QStringLiteral("pending")), longMs);
        QTRY_COMPARE_WITH_TIMEOUT(footOf(window), QStringLiteral("Hub: all sent"), longMs); // by itself
        QVERIFY(m_bench.number("SELECT count(*) FROM odograph.document WHERE kind='trial'") == 2);
        actionOf(window, "School hub…")->trigger();
        const auto *dialog = window.findChild<HubDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        QVERIFY(says(*dialog, "Nothing: all is sent"));
    }

    void historyHasTheRunsOfAllBenches()
    {
        MainWindow window;
        window.show();
        QVERIFY(window.openProject(m_file));
        window.showMode(WindowMode::History);
        waitFor(window);
        auto *panel = window.findChild<HubRunsPanel *>();
        auto *tabs = window.findChild<HistoryPage *>()->findChild<QTabWidget *>();
        QVERIFY(!tabs->isTabVisible(tabs->indexOf(panel)));
        QVERIFY(connectToSchool(*window.workspace().project(), m_bench.address("bench1"), {}));
        QTRY_COMPARE_WITH_TIMEOUT(footOf(window), QStringLiteral("Hub: all sent"), longMs);
        QVERIFY(tabs->isTabVisible(tabs->indexOf(panel)));
        tabs->setCurrentWidget(panel);
        QTRY_COMPARE_WITH_TIMEOUT(panel->findChild<QTableView *>()->model()->rowCount(), 2, longMs);
    }

    void aConflictIsSaidAndShown()
    {
        MainWindow window;
        window.show();
        QVERIFY(window.openProject(m_file));
        QVERIFY(connectToSchool(*window.workspace().project(), m_bench.address("bench1"), {}));
        QTRY_COMPARE_WITH_TIMEOUT(footOf(window), QStringLiteral("Hub: all sent"), longMs);
        const auto other = m_bench.project("other.odo", 0);
        QVERIFY(connectToSchool(*other, m_bench.address("anna"), {}));
        QVERIFY(pullFromSchool(*other, WithRecordings::No, {}));
        QVERIFY(other->trials().setNotes(other->trials().find("run 2")->id, "the teacher's"));
        QVERIFY(publishToSchool(*other, WithRecordings::No, {}));
        Project &project = *window.workspace().project();
        QVERIFY(project.trials().setNotes(project.trials().find("run 2")->id, "the bench's"));
        auto *messages = window.findChild<MessageBar *>();
        QTRY_VERIFY_WITH_TIMEOUT(messages->text().contains(QLatin1String("changed the same things")), longMs);
        QStringList values;
        Person person({[&](QDialog &dialog) {
            const auto *table = dialog.findChild<QTableWidget *>();
            for (int row = 0; row < table->rowCount(); ++row)
                for (int column = 0; column < table->columnCount(); ++column)
                    values << table->item(row, column)->text();
            dialog.accept();
        }});
        button(*messages, "Show both")->click();
        QVERIFY(person.isDone());
        QVERIFY2(values.contains(QLatin1String("the teacher's")) &&
                     values.contains(QLatin1String("the bench's")),
                 qPrintable(values.join(u'|')));
    }

    /// While it is asking a server that is away.
    void theWindowClosesAtOnce()
    {
        auto window = std::make_unique<MainWindow>();
        window->show();
        QVERIFY(window->openProject(m_file));
        QVERIFY(connectToSchool(*window->workspace().project(), m_bench.address("bench1"), {}));
        QTRY_VERIFY_WITH_TIMEOUT(footOf(*window).startsWith(QLatin1String("Hub: publishing")) ||
                                     footOf(*window) == QLatin1String("Hub: all sent"),
                                 longMs);
        window.reset();
        const auto project = Project::open(m_file, Project::Access::ReadOnly);
        QVERIFY(project);
        QVERIFY((*project)->school().link()->has_value());
    }
};

ODOGRAPH_TEST(TestHubWindow, QApplication)
#include "tst_hub_window.moc"
