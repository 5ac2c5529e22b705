// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing a figure or a spike, and the map of how far the views disagree.
#include "core/trajectory/analyser.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/scene_uncertainty.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/map/floor_map.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/spike_list.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>

using namespace odo;

namespace {

/// What the explanation says that a widget's window shows; it is closed then.
QString explanationOf(QWidget &window)
{
    auto *dialog = window.findChild<QDialog *>(QStringLiteral("explanation"));
    if (!dialog)
        return {};
    const QString text = dialog->findChild<QPlainTextEdit *>()->toPlainText();
    delete dialog;
    return text;
}

/// The example analysed from its observations, so that the views' disagreement is that of its cameras.
TrialScenePtr analysedScene()
{
    auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 120}));
    std::vector<ViewTrack> tracks;
    for (std::size_t view = 0; view < scene->views.size(); ++view)
        tracks.push_back({scene->views[view].camera, scene->views[view].floorView,
                          scene->views[view].startOffset, scene->robots[0].observations[view], 0});
    const auto profile = analyse(tracks, {0.06, std::nullopt, std::nullopt}, {});
    if (profile)
        scene->robots[0].analysis->profile = *profile;
    return scene;
}

} // namespace

class TestChosenMetrics : public QObject
{
    Q_OBJECT
    TrialScenePtr m_scene = exampleScene({.frames = 120});

private Q_SLOTS:
    void initTestCase()
    {
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setPalette(lightPalette());
    }
    void figuresAreChosenByKeys()
    {
        MetricGrid grid;
        grid.setMetrics({{QStringLiteral("a"), {}}, {QStringLiteral("b"), {}}, {QStringLiteral("c"), {}}});
        QSignalSpy chosen(&grid, &MetricGrid::chosen);
        QTest::keyClick(&grid, Qt::Key_Return); // it cannot be chosen from yet
        QCOMPARE(chosen.count(), 0);
        grid.setChoosable(QStringLiteral("why"));
        QTest::keyClick(&grid, Qt::Key_Return);
        QCOMPARE(chosen.takeLast().at(0).value<std::size_t>(), std::size_t(0));
        QTest::keyClick(&grid, Qt::Key_Down);
        QTest::keyClick(&grid, Qt::Key_Right); // there is no fourth
        QTest::keyClick(&grid, Qt::Key_Space);
        QCOMPARE(chosen.takeLast().at(0).value<std::size_t>(), std::size_t(2));
        QTest::keyClick(&grid, Qt::Key_Up);
        QTest::keyClick(&grid, Qt::Key_Right);
        QTest::keyClick(&grid, Qt::Key_Enter);
        QCOMPARE(chosen.takeLast().at(0).value<std::size_t>(), std::size_t(1));
        grid.setMetrics({});
        QTest::keyClick(&grid, Qt::Key_Return);
        QCOMPARE(chosen.count(), 0);
    }
    void aFigureTellsHowItWasComputed()
    {
        ResultPanel panel;
        panel.setScene(m_scene);
        panel.resize(308, 300);
        panel.show();
        auto *grid = panel.findChild<MetricGrid *>();
        QTest::mouseClick(grid, Qt::LeftButton, {}, {20, 20});
        QVERIFY(explanationOf(panel).contains(QStringLiteral("What went into it")));
    }
    void aSpikeTellsHowItWasFound()
    {
        Timeline timeline;
        timeline.setFrameTimes(m_scene->frameTimes());
        SpikeList list(timeline);
        list.setScene(m_scene);
        list.show();
        QTest::keyClick(list.table(), Qt::Key_F1, Qt::ShiftModifier); // none is chosen
        QVERIFY(explanationOf(list).isEmpty());
        list.table()->setCurrentIndex(list.table()->model()->index(0, 0));
        for (QAction *action : list.table()->actions())
            action->trigger();
        QVERIFY(explanationOf(list).startsWith(QStringLiteral("Spike at")));
    }
    void aBubbleTellsHowItsValueWasComputed()
    {
        Timeline timeline;
        timeline.setFrameTimes(m_scene->frameTimes());
        ProfileChart chart(timeline, Quantity::Speed);
        chart.setScene(m_scene);
        chart.resize(600, 240);
        chart.show();
        timeline.setCurrentFrame(60);
        ChartArea *area = chart.chartArea();
        area->grab(); // painted, so that the bubble stands somewhere
        const auto *bubbles = area->findChild<ChartBubbles *>();
        QCOMPARE(bubbles->positions().size(), qsizetype(m_scene->robots.size()));
        const Nanoseconds before = timeline.currentTime();
        QTest::mouseClick(area->viewport(), Qt::LeftButton, {},
                          bubbles->positions().first().center().toPoint());
        QCOMPARE(timeline.currentTime(), before); // it is not a click on the chart
        QVERIFY(explanationOf(chart).startsWith(QStringLiteral("Speed at ")));
        QTest::keyClick(area, Qt::Key_F1, Qt::ShiftModifier);
        QVERIFY(explanationOf(chart).contains(QStringLiteral("measured there: ")));
        QTest::keyClick(area, Qt::Key_Return);
        QVERIFY(!explanationOf(chart).isEmpty());
        QTest::mouseClick(area->viewport(), Qt::LeftButton, {},
                          QPoint(area->width() / 3, area->height() / 2));
        QVERIFY(explanationOf(chart).isEmpty());
        QVERIFY(timeline.currentTime() != before);
        chart.setScene(nullptr);
        area->grab();
        QTest::keyClick(area, Qt::Key_Return); // there is nothing to tell
        QVERIFY(explanationOf(chart).isEmpty());
    }
    void mapShowsHowFarTheViewsDisagree()
    {
        const TrialScenePtr scene = analysedScene();
        const std::vector<ViewDisagreement> truth = disagreementsOf(*scene);
        QVERIFY(truth[0].positions.size() > 60);
        Timeline timeline;
        timeline.setFrameTimes(scene->frameTimes());
        FloorMap map(timeline);
        map.resize(500, 420);
        map.setScene(scene);
        map.show();
        QTRY_VERIFY(map.isSettled());
        const QImage before = map.mapArea()->grab().toImage();
        map.disagreementAction()->trigger();
        QCOMPARE(map.findChild<QComboBox *>()->currentIndex(), 1);
        QTRY_VERIFY(map.isSettled());
        QTRY_VERIFY(map.mapArea()->accessibleDescription().contains(QStringLiteral("RMS")));
        QVERIFY(map.mapArea()->grab().toImage() != before);
        auto *how = map.findChild<QToolButton *>();
        QVERIFY(how->isVisible());
        how->click();
        QVERIFY(explanationOf(map).contains(QStringLiteral("tr A + tr B")));
        map.findChild<QComboBox *>()->setCurrentIndex(0);
        QVERIFY(!map.disagreementAction()->isChecked() && !how->isVisible());
        map.setScene(nullptr);
        map.disagreementAction()->trigger();
        how->click(); // there is nothing to tell
        QVERIFY(explanationOf(map).isEmpty());
    }
    void longNamesAreCut()
    {
        SeriesKey key;
        const QString endless(10000, u'x');
        key.setNames({endless, QStringLiteral("<b>short</b>")});
        QVERIFY(key.sizeHint().width() < 500);
        const QList<QAbstractButton *> entries = key.findChildren<QAbstractButton *>();
        QCOMPARE(entries.size(), 2);
        QVERIFY(entries[0]->toolTip().size() < 1000);
        QVERIFY(entries[1]->toolTip().contains(QStringLiteral("&lt;b&gt;short")));
    }
};

ODOGRAPH_TEST(TestChosenMetrics, QApplication)
#include "tst_chosen_metrics.moc"
