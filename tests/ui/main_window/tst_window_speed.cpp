// SPDX-License-Identifier: GPL-3.0-or-later
// A year of trials in the window: whatever a person does, the event loop gets its turn.
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/patience.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/driven_window.h"
#include "tests/ui/support/year_project.h"
#include "ui/history/history_page.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/workspace.h"
#include "ui/review/review_page.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QStackedWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace odo;

namespace {

constexpr int trialCount = 2000, waitMs = 60'000;
/// The bar is 50 ms on an ordinary machine; one was seen that took 1.7 times as long for the same program.
constexpr double slowMachine = 2;
constexpr double mostBusyMs = 50 * slowMachine;
/// Widgets can only be made on this thread, and the first page comes whole: 55 ms beside ten other programs.
constexpr double mostOpeningMs = 90 * slowMachine;
/// CPU time grows when other programs take the caches, and what Qt loads once is loaded in the first attempt.
/// Work that is too long is too long in each.
constexpr int attempts = 6;

/// What kept the event loop longest, of each thing that a person does.
class Phases
{
public:
    void end(const QString &name, double mostMs = mostBusyMs)
    {
        QCoreApplication::processEvents(); // so that the watch sees the last turn
        const double busy = m_watch.takeLongestMs();
        m_words << QStringLiteral("%1 %2").arg(name).arg(busy, 0, 'f', 1);
        m_worst = std::max(m_worst, busy / mostMs);
    }
    /// The longest as a part of what is allowed.
    double worst() const { return m_worst; }
    QString words() const { return m_words.join(QStringLiteral(", ")); }

private:
    BusyWatch m_watch;
    QStringList m_words;
    double m_worst = 0;
};

} // namespace

class TestWindowSpeed : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        test::beginWithoutSettings();
        applyAppearance(*qApp, Theme::Light);
        const auto made = test::makeYearProject(m_folder.path().toStdString(), trialCount);
        QVERIFY2(made, made ? "" : made.error().message().c_str());
        m_project = *made;
    }

    void nothingKeepsTheWindowWaiting()
    {
        double best = std::numeric_limits<double>::max();
        for (int attempt = 0; attempt < attempts && best >= test::slowness; ++attempt) {
            MainWindow window;
            window.resize(1440, 900);
            window.show();
            QVERIFY(QTest::qWaitForWindowExposed(&window));
            Phases phases;
            spendADay(window, phases);
            if (QTest::currentTestFailed())
                return;
            qInfo("%s", qPrintable(phases.words()));
            best = std::min(best, phases.worst());
        }
        QVERIFY2(best < test::slowness, qPrintable(QString::number(best)));
    }

private:
    void spendADay(MainWindow &window, Phases &phases) const
    {
        window.beginOpening(m_project);
        QVERIFY(
            QTest::qWaitFor([&] { return window.findChild<HistoryPage *>() && isSettled(window); }, waitMs));
        phases.end(QStringLiteral("opening"), mostOpeningMs);
        lookAtTrials(window, phases);
        search(window, phases);
        changeAndUndo(window, phases);
        for (const auto &[mode, name] : {std::pair(MainWindow::Mode::Testbed, QStringLiteral("Testbed")),
                                         std::pair(MainWindow::Mode::Compare, QStringLiteral("Compare")),
                                         std::pair(MainWindow::Mode::Record, QStringLiteral("Record")),
                                         std::pair(MainWindow::Mode::Review, QStringLiteral("Review"))}) {
            window.showMode(mode);
            QVERIFY(QTest::qWaitFor([&] { return isSettled(window); }, waitMs));
            phases.end(name);
        }
    }

    static bool isSettled(const MainWindow &window)
    {
        return !window.workspace().isBusy() && window.isSettled();
    }

    static void lookAtTrials(MainWindow &window, Phases &phases)
    {
        auto *review = window.findChild<ReviewPage *>();
        for (const char *name : {"Run 7", "Run 1900", "Run 800"}) {
            QVERIFY(window.showTrial(name));
            QVERIFY(QTest::qWaitFor([&] { return isSettled(window); }, waitMs));
            QCOMPARE(review->scene()->trial.name, std::string(name));
        }
        phases.end(QStringLiteral("trials"));
    }

    static void search(MainWindow &window, Phases &phases)
    {
        window.showMode(MainWindow::Mode::History);
        QVERIFY(QTest::qWaitFor([&] { return isSettled(window); }, waitMs));
        phases.end(QStringLiteral("History"));
        auto *line = window.findChild<QLineEdit *>(QStringLiteral("search"));
        auto *table = window.findChild<QTableView *>(QStringLiteral("trials"));
        QCOMPARE(table->model()->rowCount(), trialCount);
        for (const char letter : QByteArrayLiteral("team 7 wet")) {
            line->insert(QString(QLatin1Char(letter)));
            QCoreApplication::processEvents();
        }
        QVERIFY(table->model()->rowCount() > 0 && table->model()->rowCount() < trialCount);
        line->clear();
        phases.end(QStringLiteral("search"));
        for (int column = 0; column < table->model()->columnCount(); ++column) {
            table->sortByColumn(column, Qt::AscendingOrder);
            QCoreApplication::processEvents();
        }
        phases.end(QStringLiteral("sorting"));
    }

    static void changeAndUndo(MainWindow &window, Phases &phases)
    {
        Project &project = *window.workspace().project();
        const auto trial = project.trials().find("Run 800");
        QVERIFY(trial);
        QVERIFY(project.change(foreignWords("star Run 800"),
                               [&] { return project.trials().setStarred(trial->id, true); }));
        for (const QMenu *menu : window.menuBar()->findChildren<QMenu *>())
            if (menu->title() == QLatin1String("&Edit"))
                menu->actions().front()->trigger();
        QVERIFY(QTest::qWaitFor([&] { return isSettled(window); }, waitMs));
        QVERIFY(!project.trials().find("Run 800")->starred);
        phases.end(QStringLiteral("undo"));
    }

    QTemporaryDir m_folder;
    std::filesystem::path m_project;
};

ODOGRAPH_TEST(TestWindowSpeed, QApplication)
#include "tst_window_speed.moc"
