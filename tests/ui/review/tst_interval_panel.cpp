// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of frame intervals: what it says of each view, its bars, and that the keyboard brings it.
#include "core/project/project.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "tests/ui/support/found_widgets.h"
#include "ui/models/timeline.h"
#include "ui/review/internal/interval_panel.h"
#include "ui/review/review_desk.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QHelpEvent>
#include <QImage>
#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>
#include <QToolTip>

using namespace odo;
using namespace std::chrono_literals;

namespace {

TrialScenePtr withLosses()
{
    auto scene = std::make_shared<TrialScene>(*exampleScene({.frames = 240}));
    std::vector<Nanoseconds> &times = scene->views[1].recording.frameTimes;
    times.erase(times.begin() + 100, times.begin() + 103);
    times.erase(times.begin() + 50);
    // every second frame of the first view repeats the one before
    std::vector<Sample> &samples = scene->robots[0].analysis->profile.samples;
    for (std::size_t i = 1; i < samples.size(); i += 2)
        samples[i].flags |= flagBit(SampleFlag::DuplicateFrame);
    return scene;
}

} // namespace

class TestIntervalPanel : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        QLocale::setDefault(QLocale::c());
    }

    void eachViewHasItsWords()
    {
        IntervalPanel panel;
        QSignalSpy settled(&panel, &IntervalPanel::settled);
        panel.resize(700, 300);
        panel.show();
        panel.setScene(withLosses());
        QVERIFY(!panel.isSettled());
        QTRY_COMPARE(settled.count(), 1);
        QStringList words;
        for (const QLabel *label : panel.content()->findChildren<QLabel *>())
            words << label->text();
        const QString all = words.join(u'\n');
        QVERIFY2(all.contains(QStringLiteral("frames are 33.3")), qPrintable(all));
        QVERIFY2(all.contains(QStringLiteral("120 of 240 frames repeat the one before")), qPrintable(all));
        QVERIFY2(all.contains(QStringLiteral("4 missing in 2 gap(s)")), qPrintable(all));
        QCOMPARE(all.count(QStringLiteral("no frame missing")), 1);
        QCOMPARE(panel.findChildren<IntervalHistogram *>().size(), 2);
        QCOMPARE(panel.accessibleDescription(), all);
        // another trial comes while one is being computed
        panel.setScene(withLosses());
        panel.setScene(nullptr);
        QTRY_VERIFY(panel.isSettled());
        QTRY_VERIFY(test::says(panel, "This trial has no videos."));
        QVERIFY(panel.findChildren<IntervalHistogram *>().isEmpty());
    }

    void barsShowEvenASingleInterval()
    {
        std::vector<Nanoseconds> times;
        for (int i = 0; i < 1000; ++i)
            times.push_back(20ms * i + (i >= 500 ? 20ms : 0ms)); // one is 40 ms
        IntervalHistogram histogram(frameIntervals(times));
        histogram.setPalette(lightPalette());
        histogram.resize(600, 90);
        const QImage image = histogram.grab().toImage();
        const QColor blue = seriesColour(0, lightPalette());
        const auto heightAt = [&](int from, int to) {
            int most = 0;
            for (int x = from; x < to; ++x) {
                int height = 0;
                for (int y = 0; y < image.height(); ++y)
                    height += image.pixelColor(x, y) == blue;
                most = std::max(most, height);
            }
            return most;
        };
        // 600 px: from 18 to 40.5 ms within 580, 0.5 ms a bar; 20 ms at 62, 40 ms at 577
        QVERIFY2(heightAt(50, 80) > 55, qPrintable(QString::number(heightAt(50, 80))));
        QVERIFY2(heightAt(540, 600) >= 2, qPrintable(QString::number(heightAt(540, 600))));
        QVERIFY(heightAt(540, 600) < heightAt(50, 80) / 2);
        QCOMPARE(heightAt(200, 400), 0);
        QHelpEvent help(QEvent::ToolTip, {66, 40}, histogram.mapToGlobal(QPoint(66, 40)));
        QApplication::sendEvent(&histogram, &help);
        QVERIFY2(QToolTip::text().contains(QStringLiteral("998 interval(s)")), qPrintable(QToolTip::text()));
        times.push_back(times.back() + 3s); // longer than the axis: a bar behind it
        IntervalHistogram paused(frameIntervals(times));
        paused.resize(600, 90);
        QHelpEvent behind(QEvent::ToolTip, {584, 40}, paused.mapToGlobal(QPoint(584, 40)));
        QApplication::sendEvent(&paused, &behind);
        QVERIFY2(QToolTip::text().startsWith(QStringLiteral("longer than")), qPrintable(QToolTip::text()));
        paused.grab();
        IntervalHistogram none(frameIntervals({}));
        none.resize(100, 60);
        none.grab(); // nothing to paint, and nothing happens
    }

    void itIsADockThatIsHiddenAtFirst()
    {
        Timeline timeline;
        ReviewDesk desk(timeline);
        desk.resize(1200, 800);
        desk.show();
        desk.setScene(withLosses());
        auto *dock = desk.findChild<QDockWidget *>(QStringLiteral("intervalDock"));
        QVERIFY(dock && !dock->isVisible());
        QCOMPARE(dock->toggleViewAction()->text(), QStringLiteral("Frame intervals"));
        QVERIFY(desk.dockActions().contains(dock->toggleViewAction()));
        dock->toggleViewAction()->trigger();
        QVERIFY(dock->isVisible());
        QTRY_VERIFY(desk.isSettled());
        desk.saveLayout();
        ReviewDesk next(timeline); // it comes again as it was
        next.resize(1200, 800);
        next.show();
        QTRY_VERIFY(next.findChild<QDockWidget *>(QStringLiteral("intervalDock"))->isVisible());
        next.resetLayout();
        QVERIFY(!next.findChild<QDockWidget *>(QStringLiteral("intervalDock"))->isVisible());
    }
};

ODOGRAPH_TEST(TestIntervalPanel, QApplication)
#include "tst_interval_panel.moc"
