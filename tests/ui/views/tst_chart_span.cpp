// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/motion_stretches.h"
#include "core/analysis/range_statistics.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

using namespace odo;

namespace {

/// Two charts over one span, as in Review.
struct Charts
{
    Timeline timeline;
    ChartSpan span{timeline};
    ProfileChart speed{timeline, span, {Quantity::Speed, Quantity::PositionX}},
        acceleration{timeline, span, {Quantity::Acceleration}};

    explicit Charts(const TrialScenePtr &scene)
    {
        show(scene);
        for (ProfileChart *chart : {&speed, &acceleration}) {
            chart->resize(700, 260);
            chart->show();
        }
    }
    void show(const TrialScenePtr &scene)
    {
        timeline.setFrameTimes(scene ? scene->frameTimes() : std::vector<Nanoseconds>());
        speed.setScene(scene);
        acceleration.setScene(scene);
    }
    ChartArea &area() { return *speed.chartArea(); }
    QPoint at(double second, double value = 0.5)
    {
        return area().plot().at(span.cursorPosition(fromSeconds(second)), value).toPoint();
    }
    void drag(double from, double to)
    {
        QWidget *plot = area().viewport();
        QTest::mousePress(plot, Qt::LeftButton, {}, at(from));
        QTest::mouseMove(plot, at((from + to) / 2));
        QTest::mouseMove(plot, at(to));
        QTest::mouseRelease(plot, Qt::LeftButton, {}, at(to));
    }
    void turnWheel(int notches, Qt::KeyboardModifiers modifiers, double about)
    {
        const QPointF position = at(about);
        QWheelEvent event(position, area().mapToGlobal(position), {}, QPoint(0, 120 * notches), Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QApplication::sendEvent(area().viewport(), &event);
    }
};

} // namespace

class TestChartSpan : public QObject
{
    Q_OBJECT
    TrialScenePtr m_scene;

private Q_SLOTS:
    void initTestCase()
    {
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setPalette(lightPalette());
        m_scene = exampleScene({.frames = 300}); // 10 s
    }
    void showsAllAtFirst()
    {
        Charts charts(m_scene);
        QVERIFY(charts.span.showsAll());
        QCOMPARE(charts.span.low(), 0.0);
        QVERIFY(std::abs(charts.span.high() - 299 / 30.0) < 1e-6);
        QCOMPARE(charts.span.positionOf(0, fromSeconds(4)), 4.0);
        QCOMPARE(charts.span.timeAt(4), fromSeconds(4));
    }
    void zoomsAndPansWithinTheWhole()
    {
        Charts charts(m_scene);
        charts.span.zoom(4, 5);
        QVERIFY(std::abs(charts.span.high() - charts.span.low() - 299 / 120.0) < 1e-6);
        QVERIFY(std::abs((5 - charts.span.low()) / (charts.span.high() - charts.span.low()) -
                         5 / (299 / 30.0)) < 1e-6);
        const double low = charts.span.low(), width = charts.span.high() - low;
        charts.span.pan(0.5);
        QVERIFY(std::abs(charts.span.low() - low - width / 2) < 1e-9);
        charts.span.pan(100);
        QVERIFY(std::abs(charts.span.high() - charts.span.wholeHigh()) < 1e-9);
        QVERIFY(std::abs(charts.span.high() - charts.span.low() - width) < 1e-9); // as wide as before
        charts.span.zoom(1e9, 3);
        QVERIFY(charts.span.high() - charts.span.low() > 1e-4);
        charts.span.zoom(1e-9, 3);
        QVERIFY(charts.span.showsAll());
        charts.span.show(std::nan(""), 3);
        charts.span.show(7, 3);
        QVERIFY(charts.span.showsAll());
    }
    void followsTheTimeThatLeaves()
    {
        Charts charts(m_scene);
        charts.span.show(2, 4);
        charts.timeline.setCurrentTime(fromSeconds(3));
        QCOMPARE(charts.span.low(), 2.0);
        charts.timeline.setCurrentTime(fromSeconds(6));
        QVERIFY(charts.span.low() < 6 && charts.span.high() > 6);
        QVERIFY(std::abs(charts.span.high() - charts.span.low() - 2) < 1e-9);
        charts.timeline.setCurrentTime(fromSeconds(1));
        QVERIFY(charts.span.low() < 1 && charts.span.high() > 1);
    }
    void distanceIsTheWayDriven()
    {
        Charts charts(m_scene);
        charts.span.setAgainst(ChartSpan::Against::Distance);
        const Profile &profile = m_scene->robots[0].analysis->profile;
        const std::vector<double> distances = distanceTravelled(profile.samples, profile.points);
        QCOMPARE(charts.span.positions()->at(0), distances);
        QCOMPARE(charts.span.wholeHigh(), distances.back());
        QCOMPARE(charts.span.positionOf(0, profile.samples[100].time), distances[100]);
        const Nanoseconds between = (profile.samples[100].time + profile.samples[101].time) / 2;
        QVERIFY(std::abs(charts.span.positionOf(0, between) - (distances[100] + distances[101]) / 2) < 1e-9);
        QCOMPARE(charts.span.timeAt(distances[100]), profile.samples[100].time);
        QVERIFY(charts.area().accessibleName().contains(QStringLiteral("over distance")));
        for (QAction *action : charts.span.actions()) // by its key
            if (action->objectName() == QStringLiteral("againstDistance"))
                action->trigger();
        QCOMPARE(charts.span.against(), ChartSpan::Against::Time);
        QVERIFY(std::abs(charts.span.wholeHigh() - 299 / 30.0) < 1e-6);
    }
    void withoutARobotThereIsOnlyTime()
    {
        Charts charts(nullptr);
        charts.span.setAgainst(ChartSpan::Against::Distance);
        QCOMPARE(charts.span.cursorPosition(fromSeconds(3)), 0.0);
        charts.show(m_scene);
        charts.show(nullptr);
        auto untracked = std::make_shared<TrialScene>(*m_scene);
        untracked->robots[0].analysis.reset();
        charts.show(untracked);
        QVERIFY(!charts.speed.grab().isNull());
        QCOMPARE(charts.span.timeAt(1), fromSeconds(1));
    }
    void draggingSelectsARange()
    {
        Charts charts(m_scene);
        charts.drag(2, 6);
        QVERIFY(charts.timeline.selection());
        const double pixel = 10.0 / 600; // of time, and a frame of 33 ms
        QVERIFY(std::abs(toSeconds(charts.timeline.selection()->begin) - 2) < pixel + 0.02);
        QVERIFY(std::abs(toSeconds(charts.timeline.selection()->end) - 6) < pixel + 0.02);
        charts.drag(9, 7); // backwards
        QVERIFY(std::abs(toSeconds(charts.timeline.selection()->begin) - 7) < pixel + 0.02);
        const auto before = charts.timeline.selection();
        QTest::mouseClick(charts.area().viewport(), Qt::LeftButton, {},
                          charts.at(4)); // goes there, and no more
        QCOMPARE(charts.timeline.selection(), before);
        QVERIFY(std::abs(toSeconds(charts.timeline.currentTime()) - 4) < pixel + 0.02);
    }
    void wheelAndDoubleClickChangeTheSpan()
    {
        Charts charts(m_scene);
        charts.turnWheel(3, {}, 5);
        const double width = charts.span.high() - charts.span.low();
        QVERIFY(std::abs(width - 299 / 30.0 / std::pow(1.25, 3)) < 1e-6);
        const double low = charts.span.low();
        charts.turnWheel(-1, Qt::ShiftModifier, 5);
        QVERIFY(std::abs(charts.span.low() - low - 0.1 * width) < 1e-6);
        QTest::mouseDClick(charts.area().viewport(), Qt::LeftButton, {}, charts.at(5));
        QVERIFY(charts.span.showsAll());
    }
    void rangeAndFitArePainted()
    {
        Charts charts(m_scene);
        const TimeSpan span{fromSeconds(3), fromSeconds(7)};
        const auto fit =
            fitQuantity(m_scene->robots[0].analysis->profile, Quantity::Speed, span, FitShape::Constant);
        QVERIFY(fit);
        const QImage before = charts.area().grab().toImage();
        charts.timeline.setSelection(span);
        charts.speed.setFit(FitOverlay{0, Quantity::Speed, span, *fit});
        const QImage after = charts.area().grab().toImage();
        int dark = 0; // dashes of the fit
        for (double second = 3.2; second < 6.8; second += 0.02) {
            const QPoint at = charts.at(second, fit->coefficients[0]);
            dark += after.pixelColor(at).lightness() < 90;
        }
        QVERIFY2(dark > 40, qPrintable(QString::number(dark)));
        const QPoint inside = charts.at(5) + QPoint(3, 0), outside = charts.at(8) + QPoint(3, 0);
        QVERIFY(after.pixelColor(inside.x(), 14) != before.pixelColor(inside.x(), 14)); // shaded
        QCOMPARE(after.pixelColor(outside.x(), 14), before.pixelColor(outside.x(), 14));
        charts.speed.setQuantity(Quantity::PositionX); // the fit is not of this one
        const QImage other = charts.area().grab().toImage();
        charts.speed.setFit(std::nullopt);
        QCOMPARE(charts.area().grab().toImage(), other);
    }
    void everyQuantityHasACurve()
    {
        Timeline timeline;
        ChartSpan span(timeline);
        timeline.setFrameTimes(m_scene->frameTimes());
        ProfileChart chart(timeline, span, {allQuantities().begin(), allQuantities().end()});
        chart.resize(700, 260);
        chart.setScene(m_scene);
        auto *choice = chart.findChild<QComboBox *>();
        QSignalSpy changed(&chart, &ProfileChart::quantityChanged);
        for (const auto against : {ChartSpan::Against::Time, ChartSpan::Against::Distance}) {
            span.setAgainst(against);
            for (int i = 0; i < choice->count(); ++i) {
                if (!(choice->model()->index(i, 0).flags() & Qt::ItemIsEnabled))
                    continue; // there is no other robot
                choice->setCurrentIndex(i);
                const QImage image = chart.chartArea()->grab().toImage();
                const QColor blue = seriesColour(0, lightPalette());
                int pixels = 0;
                for (int x = 60; x < image.width() - 20; ++x)
                    for (int y = 10; y < image.height() - 30; ++y) {
                        const QColor got = image.pixelColor(x, y);
                        pixels += std::abs(got.red() - blue.red()) + std::abs(got.green() - blue.green()) +
                                      std::abs(got.blue() - blue.blue()) <
                                  40;
                    }
                QVERIFY2(pixels > 300, qPrintable(choice->currentText()));
            }
        }
        QVERIFY(changed.count() >= 10);
    }
};

ODOGRAPH_TEST(TestChartSpan, QApplication)
#include "tst_chart_span.moc"
