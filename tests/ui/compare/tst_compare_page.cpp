// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/stored_example.h"
#include "ui/compare/compare_desk.h"
#include "ui/compare/compare_page.h"
#include "ui/compare/internal/compare_column.h"
#include "ui/compare/internal/compare_map.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/timeline.h"
#include "ui/views/map/trial_map.h"
#include "ui/views/widgets/empty_state.h"
#include "ui/views/widgets/fact_list.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

using namespace odo;

namespace {

constexpr int longestMs = 20000; // on a busy machine

/// The words of the empty state, if one is shown.
QString emptyWords(const ComparePage &page)
{
    const auto *none = page.findChild<EmptyState *>();
    if (!none || !none->isVisibleTo(&page))
        return {};
    QStringList words;
    for (const QLabel *label : none->findChildren<QLabel *>())
        words << label->text();
    return words.join(u' ');
}

} // namespace

/// The page of Compare with stored trials whose robots drive the same course.
class TestComparePage : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    std::unique_ptr<Project> m_project;

    struct Shown
    {
        std::unique_ptr<ComparePage> page;
        CompareMap &map() const { return page->desk().map(); }
    };
    Shown shown(const QStringList &trials, QSize size = {1366, 768})
    {
        Shown result{std::make_unique<ComparePage>(*m_project)};
        result.page->resize(size);
        result.page->refresh();
        result.page->showTrials(trials);
        result.page->show();
        if (!QTest::qWaitFor([&] { return result.page->isSettled(); }, longestMs))
            qWarning("the page does not settle");
        if (!result.page->scene())
            qInfo("%s", qPrintable(emptyWords(*result.page)));
        return result;
    }
    static QTableView *table(const ComparePage &page, const char *name)
    {
        for (QTableView *each : page.findChildren<QTableView *>())
            if (each->accessibleName() == QLatin1String(name))
                return each;
        return nullptr;
    }

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        m_project = openStoredExample(m_folder.path().toStdString(), {90, 320, 180});
    }

    void showsTwoRunsInStep()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        const ComparisonScenePtr scene = shown.page->scene();
        QVERIFY(scene);
        QCOMPARE(scene->runCount(), std::size_t(2));
        for (const QWidget *window : QApplication::topLevelWidgets())
            QVERIFY2(window == shown.page.get() || !window->isVisible(), window->metaObject()->className());
        QVERIFY(!scene->compared.comparison.isTasksPath);
        // The same robot on the same course: nothing differs, and nothing is called a difference.
        const QTableView *figures = table(*shown.page, "Metrics of both runs");
        QVERIFY(figures && figures->model()->rowCount() >= 1);
        for (int row = 0; row < figures->model()->rowCount(); ++row) {
            const QModelIndex difference = figures->model()->index(row, DifferenceModel::DifferenceColumn);
            QVERIFY(!difference.data(DifferenceModel::SignificantRole).toBool());
            QCOMPARE(difference.data(Qt::AccessibleDescriptionRole).toString(),
                     QStringLiteral("not significant"));
        }
        const ChartContentPtr differences = comparedContent(*scene, Compared::TimeDifference);
        QCOMPARE(differences->curves.size(), std::size_t(3)); // faint, sure, and where neither is ahead
        for (const ChartCurve &curve : differences->curves)
            QVERIFY(curve.ink == ChartInk::Muted ? !curve.runs.empty() : curve.runs.empty());
        // Each picture follows the shared time by its own clock.
        Timeline &shared = shown.page->timeline();
        QVERIFY(shared.frameCount() >= 89); // laid from the aligned moment, so that one may lie beyond an end
        shared.setCurrentTime(std::chrono::milliseconds(700));
        const QList<Timeline *> clocks =
            shown.page->desk().findChildren<Timeline *>(QString(), Qt::FindDirectChildrenOnly);
        QCOMPARE(clocks.size(), 2);
        for (std::size_t run = 0; run < 2; ++run) {
            const double apartS =
                toSeconds(clocks[qsizetype(run)]->currentTime() - scene->ownTime(run, shared.currentTime()));
            QVERIFY(std::abs(apartS) < 0.017); // half a frame
            QVERIFY(scene->pointAt(run, shared.currentTime()));
        }
        QVERIFY(QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs));
    }

    void theTimeLineHoldsTheAlignedMoment()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 2"), QStringLiteral("Trial 1")});
        const auto times = shown.page->scene()->frameTimes();
        QVERIFY(std::ranges::find(times, Nanoseconds(0)) != times.end());
        QVERIFY(std::ranges::is_sorted(times));
        QCOMPARE(shown.page->timeline().currentTime(), Nanoseconds(0));
        const Nanoseconds some(123456789);
        QCOMPARE(shown.page->scene()->commonTime(1, shown.page->scene()->ownTime(1, some)), some);
    }

    void aSingleTrialFindsAPartner()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1")});
        QVERIFY(shown.page->scene());
        QCOMPARE(shown.page->scene()->trials.runs[1].trial.name,
                 std::string("Trial 2")); // Trial 3 was not tracked
    }

    void swapsTheRuns()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        for (QToolButton *button : shown.page->findChildren<QToolButton *>())
            if (button->accessibleName() == QLatin1String("Swap the two runs"))
                button->click();
        QVERIFY(QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs));
        QCOMPARE(shown.page->scene()->trials.runs[0].trial.name, std::string("Trial 2"));
        QCOMPARE(shown.page->scene()->trials.runs[1].trial.name, std::string("Trial 1"));
    }

    void aShiftByHandIsATimeDifference()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        QComboBox *align = nullptr;
        for (QComboBox *list : shown.page->findChildren<QComboBox *>())
            if (list->accessibleName() == QLatin1String("How to align the runs"))
                align = list;
        auto *shift = shown.page->findChild<QDoubleSpinBox *>();
        QVERIFY(align && shift && !shift->isVisible());
        align->setCurrentIndex(align->count() - 1);
        Q_EMIT align->activated(align->currentIndex());
        QVERIFY(shift->isVisible());
        shift->setValue(0.1);
        QVERIFY(QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs));
        const RunComparison &comparison = shown.page->scene()->compared.comparison;
        QVERIFY(comparison.alignedBy == AlignBy::ByHand);
        const auto difference = comparison.timeDifferenceAt(1, comparison.originM + 0.2);
        QVERIFY(difference &&
                std::abs(difference->value + 0.1) < 1e-6); // its clock begins later: it is earlier by it
    }

    void aPlaceIsWhereBothAreAtTheSameTime()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        QVERIFY(shown.page->scene());
        const auto field = [&](auto *kind, const QString &name) {
            for (auto *each : shown.page->findChildren<std::remove_pointer_t<decltype(kind)> *>())
                if (each->accessibleName() == name)
                    return each;
            return decltype(kind)(nullptr);
        };
        auto *align = field(static_cast<QComboBox *>(nullptr), QStringLiteral("How to align the runs"));
        auto *place = field(static_cast<QDoubleSpinBox *>(nullptr),
                            QStringLiteral("Distance along the path at which the runs are aligned"));
        QVERIFY(align && place && !place->isVisible());
        const auto wait = [&] { return QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs); };
        align->setCurrentIndex(align->findData(int(AlignBy::Distance)));
        Q_EMIT align->activated(align->currentIndex());
        QVERIFY(wait());
        QVERIFY(place->isVisible());
        const double originM = shown.page->scene()->compared.comparison.originM;
        place->setValue(0.5);
        QVERIFY(wait());
        const RunComparison &comparison = shown.page->scene()->compared.comparison;
        QCOMPARE(comparison.alignedBy, AlignBy::Distance);
        QVERIFY(std::abs(comparison.originM - originM) < 1e-9);
        const auto there = comparison.timeDifferenceAt(1, originM + 0.5);
        QVERIFY(there && std::abs(there->value) < 1e-9);
        place->setValue(500); // nobody gets there
        QVERIFY(wait());
        QVERIFY(!shown.page->scene());
        QVERIFY(emptyWords(*shown.page).contains(QStringLiteral("choose a position that both runs pass")));
        place->setValue(0);
        QVERIFY(wait());
        QVERIFY(shown.page->scene());
    }
    void ofThreeRunsOneIsChosenAgainstTheFirst()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        shown.page->chooser().setRuns({{"Trial 1", "Red 2"}, {"Trial 2", "Red 2"}, {"Trial 2", "Blue 1"}});
        Q_EMIT shown.page->chooser().runsChanged();
        QVERIFY(QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs));
        QVERIFY(shown.page->scene());
        QCOMPARE(shown.page->scene()->runCount(), std::size_t(3));
        QComboBox *others = nullptr;
        for (QComboBox *each : shown.page->findChildren<QComboBox *>())
            if (each->accessibleName() == QStringLiteral("Run compared with the first one"))
                others = each;
        QVERIFY(others && others->isVisible());
        QCOMPARE(others->count(), 2);
        const QAbstractItemModel *figures = table(*shown.page, "Metrics of both runs")->model();
        const auto headline = [&] {
            return figures->headerData(DifferenceModel::SecondColumn, Qt::Horizontal).toString();
        };
        const QString before = headline();
        others->setCurrentIndex(1);
        QVERIFY(headline() != before);
        shown.page->showTrials({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        QVERIFY(QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs));
        QVERIFY(!others->isVisible());
    }
    void gatesAreDraggedAndMovedByKeys()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        CompareMap &map = shown.map();
        QCOMPARE(map.gates().size(), std::size_t(2)); // without a task the way is parted into three
        const QAbstractItemModel *sectors = table(*shown.page, "Times from gate to gate")->model();
        QCOMPARE(sectors->rowCount(), 3);
        const QString before = sectors->index(0, DifferenceModel::FirstColumn).data().toString();
        const double stationM = map.gates()[0].stationM;
        QSignalSpy moved(&map, &CompareMap::gatesMoved);

        const ReferencePath &path = shown.page->scene()->compared.comparison.path;
        const QPoint to = map.fromWorld(pointAt(path, stationM + 0.15).position).toPoint();
        QTest::mousePress(&map, Qt::LeftButton, {}, map.gatePosition(0).toPoint());
        QTest::mouseMove(&map, to);
        QMouseEvent drag(QEvent::MouseMove, to, map.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&map, &drag);
        QTest::mouseRelease(&map, Qt::LeftButton, {}, to);
        QVERIFY(moved.count() >= 1);
        // A pixel is some 10 mm here, and the gate stays a little behind the pointer.
        QVERIFY2(std::abs(map.gates()[0].stationM - stationM - 0.15) < 0.04,
                 qPrintable(QString::number(map.gates()[0].stationM - stationM)));
        QVERIFY(sectors->index(0, DifferenceModel::FirstColumn).data().toString() != before);

        const double draggedM = map.gates()[1].stationM;
        map.setFocus();
        const Nanoseconds time = shown.page->timeline().currentTime();
        QTest::keyClick(&map, Qt::Key_Escape);
        QTest::keyClick(&map, Qt::Key_Down);
        QTest::keyClick(&map, Qt::Key_Down);
        QTest::keyClick(&map, Qt::Key_Right, Qt::ShiftModifier);
        QTest::keyClick(&map, Qt::Key_Left);
        QVERIFY(std::abs(map.gates()[1].stationM - draggedM - 0.09) < 1e-9);
        QCOMPARE(shown.page->timeline().currentTime(), time);
    }

    void aClickIntoAChartGoesThere()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        DistanceArea &area = shown.page->desk().difference().area();
        constexpr double wantedM = 0.5;
        QTest::mouseClick(area.viewport(), Qt::LeftButton, {}, area.plot().at(wantedM, 0).toPoint());
        const double reachedM = shown.page->scene()->distanceAt(0, shown.page->timeline().currentTime());
        // Half a frame and half a pixel.
        QVERIFY2(std::abs(reachedM - wantedM) < 0.04, qPrintable(QString::number(reachedM)));
    }

    void everyDifferenceTellsHowItWasComputed()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        const auto explanation = [&shown] {
            auto *dialog = shown.page->findChild<QDialog *>(QStringLiteral("explanation"));
            const QString text = dialog ? dialog->findChild<QPlainTextEdit *>()->toPlainText() : QString();
            delete dialog;
            return text;
        };
        const auto explained = [&](const char *name, int row) {
            QTableView *table = TestComparePage::table(*shown.page, name);
            table->setCurrentIndex(table->model()->index(row, 0));
            table->findChild<QAction *>(QStringLiteral("howComputed"))->trigger();
            return explanation();
        };
        const QString figure = explained("Metrics of both runs", 0);
        QVERIFY2(figure.contains(QStringLiteral("Trial 2 minus Trial 1")) &&
                     figure.contains(QStringLiteral("not above 1.96")) &&
                     figure.contains(QStringLiteral("√(σ₁² + σ₂²)")) &&
                     figure.contains(QStringLiteral("time 0: ")),
                 qPrintable(figure));
        const QString sector = explained("Times from gate to gate", 0);
        QVERIFY2(sector.startsWith(QStringLiteral("Sector begin to ")) &&
                     sector.contains(QStringLiteral("first arrival")),
                 qPrintable(sector));
        auto *end = shown.page->findChild<MetricGrid *>();
        QTest::keyClick(end, Qt::Key_Return);
        const QString atEnd = explanation();
        QVERIFY2(atEnd.startsWith(QStringLiteral("Δt of ")) &&
                     atEnd.contains(QStringLiteral("Trial 2 against Trial 1 at ")),
                 qPrintable(atEnd));
        shown.page->timeline().setCurrentTime(std::chrono::milliseconds(700));
        for (const auto &[chart, words] :
             {std::pair(&shown.page->desk().speed(), QStringLiteral("Speed of Trial 1 at ")),
              std::pair(&shown.page->desk().difference(), QStringLiteral("Trial 2 against Trial 1 at "))}) {
            chart->area().grab();
            QTest::keyClick(&chart->area(), Qt::Key_F1, Qt::ShiftModifier);
            const QString told = explanation();
            QVERIFY2(told.contains(words), qPrintable(told));
        }
        // What only one of them has, and what is exact, is told without a claim.
        const auto &scene = *shown.page->scene();
        QCOMPARE(explainDifference(scene, 1, {"circle_radius", "m", 0.5, {}, 0.01, {}, {}}).value,
                 QStringLiteral("only one of the two runs has it"));
        QVERIFY(explainDifference(scene, 1, {"laps", "1", 2, 3, {}, {}, Difference{1, 0}})
                    .formula.contains(QStringLiteral("Both values are exact")));
        QVERIFY(explainDifference(scene, 1, {"duration", "s", 2, 3, 0.1, 0.1, Difference{1, 0.14}})
                    .formula.contains(QStringLiteral("fewer than 5 of 100")));
    }

    void remembersAndResetsItsDocks()
    {
        {
            const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
            auto *dock = shown.page->findChild<QDockWidget *>(QStringLiteral("compareSpeedDock"));
            QCOMPARE(shown.page->desk().dockActions().size(), 2);
            shown.page->desk().dockActions().first()->trigger();
            QVERIFY(dock->isHidden());
            shown.page->desk().saveLayout();
        }
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        auto *dock = shown.page->findChild<QDockWidget *>(QStringLiteral("compareSpeedDock"));
        QVERIFY(dock->isHidden());
        shown.page->desk().resetLayout();
        QVERIFY(!dock->isHidden());
        QSettings().remove(QStringLiteral("compare"));
    }

    void saysWhyRunsCannotBeCompared()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 3")});
        QVERIFY(!shown.page->scene());
        QVERIFY2(emptyWords(*shown.page)
                     .contains(QLatin1String("it has not been tracked yet. What to do: track it first.")),
                 qPrintable(emptyWords(*shown.page)));
        shown.page->showTrials({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        QVERIFY(QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs));
        QVERIFY(shown.page->scene());
        QCOMPARE(emptyWords(*shown.page), QString());
    }

    void asksForTwoRunsWhereThereAreNone()
    {
        const auto empty =
            Project::create(m_folder.filePath(QStringLiteral("empty.odo")).toStdString(), "Empty");
        QVERIFY(empty);
        ComparePage page(**empty);
        page.refresh();
        page.show();
        QTRY_VERIFY(emptyWords(page).startsWith(QLatin1String("Select two runs")));
        QSignalSpy wanted(&page, &ComparePage::importRequested);
        page.findChild<EmptyState *>()->findChild<QPushButton *>()->click();
        QCOMPARE(wanted.count(), 1);
    }

    void neverKeepsTheWindowWaiting()
    {
        const Shown shown = this->shown({QStringLiteral("Trial 1"), QStringLiteral("Trial 2")});
        BusyWatch watch;
        shown.page->showTrials({QStringLiteral("Trial 2"), QStringLiteral("Trial 1")});
        QVERIFY(QTest::qWaitFor([&] { return shown.page->isSettled(); }, longestMs));
        shown.page->timeline().play();
        QVERIFY(QTest::qWaitFor([&] { return !shown.page->timeline().isPlaying(); }, longestMs));
        qInfo("longest: %.1f ms", watch.longestMs());
        QVERIFY2(watch.longestMs() < longestAllowedMs(), qPrintable(QString::number(watch.longestMs())));
    }

    void theTableKeepsTheRulesOfModels()
    {
        DifferenceModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.setRunNames(QStringLiteral("One"), QStringLiteral("Two"));
        model.setMetrics({{"max_speed", "m/s", 1.5, 1.75, 0.02, 0.02, Difference{0.25, 0.03}},
                          {"duration", "s", 5.0, 5.01, 0.02, 0.02, Difference{0.01, 0.03}},
                          {"circle_radius", "m", 0.5, std::nullopt, 0.01, std::nullopt, std::nullopt}});
        const auto text = [&](int row, int column) { return model.index(row, column).data().toString(); };
        QCOMPARE(text(0, DifferenceModel::NameColumn), QStringLiteral("Top speed, m/s"));
        QCOMPARE(text(0, DifferenceModel::DifferenceColumn), QStringLiteral("+0.25 ±0.03"));
        QVERIFY(model.index(0, 3).data(DifferenceModel::SignificantRole).toBool());
        QVERIFY(!model.index(1, 3).data(DifferenceModel::SignificantRole).toBool());
        QVERIFY(
            model.index(1, 3).data(Qt::ToolTipRole).toString().contains(QLatin1String("not significant")));
        QCOMPARE(text(2, DifferenceModel::SecondColumn), QStringLiteral("–"));
        QCOMPARE(model.index(2, 3).data(Qt::ToolTipRole).toString(),
                 QStringLiteral("Only one of the two runs has it"));
        QCOMPARE(model.headerData(DifferenceModel::SecondColumn, Qt::Horizontal).toString(),
                 QStringLiteral("Two"));
        model.setSectors(
            {{"", "Left", 0, 1, {Difference{2.5, 0.01}, std::nullopt}, {std::nullopt, std::nullopt}}}, 1);
        QCOMPARE(text(0, DifferenceModel::NameColumn), QStringLiteral("begin to Left"));
        QCOMPARE(text(0, DifferenceModel::DifferenceColumn), QStringLiteral("–"));
    }

    /// A menu that is open while the list of runs gets shorter offers none that is gone.
    void fewerChoicesEmptyTheOpenMenu()
    {
        RunChooser chooser;
        const auto named = [](const char *trial) {
            return RunChoice{{trial, {}}, QString::fromLatin1(trial)};
        };
        chooser.setChoices({named("a"), named("b"), named("c"), named("d")});
        auto *menu = chooser.findChild<QMenu *>();
        QVERIFY(menu);
        Q_EMIT menu->aboutToShow();
        QVERIFY(menu->actions().size() >= 2);
        chooser.setChoices({named("a")});
        QVERIFY(menu->isEmpty());
    }
};

ODOGRAPH_TEST(TestComparePage, QApplication)
#include "tst_compare_page.moc"
