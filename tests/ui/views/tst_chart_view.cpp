// SPDX-License-Identifier: GPL-3.0-or-later
// Charts of Qt Charts under hand and eye: what is drawn where, zooming, the crosshair, the key.
#include "ui/views/charts/chart_view.h"

#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/theme.h"

#include <QAbstractButton>
#include <QApplication>
#include <QGraphicsScene>
#include <QNativeGestureEvent>
#include <QPainter>
#include <QPointingDevice>
#include <QTest>
#include <QWheelEvent>
#include <thread>

using namespace odo;

namespace {

struct Charts
{
    Timeline timeline;
    ChartSpan span{timeline};
    ProfileChart card{timeline, span, {Quantity::Speed}};

    explicit Charts(const TrialScenePtr &scene)
    {
        timeline.setFrameTimes(scene->frameTimes());
        card.setScene(scene);
        card.resize(700, 320);
        card.show();
        QCoreApplication::processEvents();
    }
    ChartArea &area() { return *card.chartArea(); }
    QImage picture() { return area().grab().toImage(); }
    void drag(const QPointF &from, const QPointF &to, Qt::KeyboardModifiers keys)
    {
        QWidget *plot = area().viewport();
        QTest::mousePress(plot, Qt::LeftButton, keys, from.toPoint());
        QTest::mouseMove(plot, ((from + to) / 2).toPoint());
        QTest::mouseMove(plot, to.toPoint());
        QTest::mouseRelease(plot, Qt::LeftButton, keys, to.toPoint());
    }
};

/// Pixels of about a colour within a rectangle.
int count(const QImage &image, const QRect &rect, const QColor &colour)
{
    int found = 0;
    for (int y = std::max(0, rect.top()); y <= std::min(rect.bottom(), image.height() - 1); ++y)
        for (int x = std::max(0, rect.left()); x <= std::min(rect.right(), image.width() - 1); ++x) {
            const QColor got = image.pixelColor(x, y);
            found += std::abs(got.red() - colour.red()) + std::abs(got.green() - colour.green()) +
                         std::abs(got.blue() - colour.blue()) <
                     40;
        }
    return found;
}

ChartContentPtr contentOf(std::vector<ChartCurve> curves, const ValueRange &range)
{
    auto content = std::make_shared<ChartContent>();
    content->curves = std::move(curves);
    content->range = range;
    return content;
}

CurveRun straight(double from, double to, int points, double value)
{
    CurveRun run;
    for (int i = 0; i < points; ++i)
        run.points.emplace_back(from + (to - from) * i / (points - 1), CurveValue{value, 0});
    return run;
}

QImage painted(const ChartDrawing &drawing, ChartPlot &plot)
{
    QImage image(600, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    plot = drawChart(painter, QRectF(0, 0, 600, 200), drawing, lightPalette(), QApplication::font(), 1);
    return image;
}

} // namespace

class TestChartView : public QObject
{
    Q_OBJECT
    TrialScenePtr m_scene, m_two;

private Q_SLOTS:
    void initTestCase()
    {
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setPalette(lightPalette());
        m_scene = exampleScene({.frames = 300}); // 10 s
        m_two = exampleScene({.frames = 300, .robots = 2});
    }
    void aCurveLiesWhereTheChartSays_data()
    {
        QTest::addColumn<int>("points");
        QTest::newRow("a line") << 40;
        QTest::newRow("columns") << 20'000;
    }
    void aCurveLiesWhereTheChartSays()
    {
        QFETCH(int, points);
        ChartCurve curve;
        curve.runs = {straight(0, 4, points, 3), straight(6, 10, points, 3)}; // a gap in the middle
        ChartPlot plot;
        const QImage image = painted({contentOf({curve}, {0, 4}), {}, 0, 10, {}}, plot);
        const QColor blue = seriesColour(0, lightPalette());
        const auto isDrawn = [&](double x) {
            return count(image, QRect(plot.at(x, 3).toPoint() - QPoint(2, 2), QSize(5, 5)), blue) > 0;
        };
        for (const double x : {0.1, 1.0, 3.9, 6.1, 9.9})
            QVERIFY2(isDrawn(x), qPrintable(QString::number(x)));
        for (const double x : {4.2, 5.0, 5.8})
            QVERIFY2(!isDrawn(x), qPrintable(QString::number(x)));
        // Nowhere else: a line is not thicker than four pixels.
        QVERIFY(count(image, plot.rect.toRect(), blue) < 4 * int(plot.rect.width()));
    }
    void aBandIsFilledAndASpikeBeyondTheAxisStandsAtItsEnd()
    {
        ChartCurve band, spikes;
        band.hasBand = true;
        band.runs = {CurveRun{0, {BandPoint(0, {5, 0.5}), BandPoint(10, {5, 0.5})}}};
        spikes.kind = ChartCurve::Kind::Spikes;
        spikes.ink = ChartInk::Spike;
        spikes.runs = {CurveRun{0, {BandPoint(5, {70, 0})}}};
        ChartPlot plot;
        const QImage image = painted({contentOf({band, spikes}, {0, 10}), {}, 0, 10, {}}, plot);
        QVERIFY(image.pixelColor(plot.at(3, 5.8).toPoint()) != QColor(Qt::white)); // within 1.96 · 0.5
        QCOMPARE(image.pixelColor(plot.at(3, 6.5).toPoint()), QColor(Qt::white));
        QVERIFY(count(image, QRect(plot.at(5, plot.values.high).toPoint() - QPoint(6, 6), QSize(12, 12)),
                      ThemeColours::of(lightPalette()).spike) > 10);
    }
    void stretchesAreShaded()
    {
        ChartPlot plot;
        const QImage image = painted({contentOf({}, {0, 1}), {}, 0, 10, {{2, 4, false}, {6, 8, true}}}, plot);
        QCOMPARE(image.pixelColor(plot.at(1, 0.63).toPoint()), QColor(Qt::white));
        QVERIFY(image.pixelColor(plot.at(3, 0.63).toPoint()) != QColor(Qt::white));
        QCOMPARE(image.pixelColor(plot.at(5, 0.63).toPoint()), QColor(Qt::white));
        const QRect hatched(plot.at(6.5, 0.7).toPoint(), plot.at(7.5, 0.6).toPoint());
        const int blank = count(image, hatched, Qt::white);
        QVERIFY(blank > 0 && blank < hatched.width() * hatched.height());
    }
    void aWorkerDrawsTheSame()
    {
        ChartCurve curve;
        curve.runs = {straight(0, 10, 50, 2)};
        const ChartDrawing drawing{contentOf({curve}, {0, 4}), {}, 0, 10, {}};
        ChartPlot here, there;
        const QImage expected = painted(drawing, here);
        QImage image;
        std::atomic<bool> isDone = false;
        std::thread worker([&] {
            image = painted(drawing, there);
            isDone = true;
        });
        QTRY_VERIFY(isDone);
        worker.join();
        QCOMPARE(image, expected);
        QCOMPARE(there.rect, here.rect);
    }
    void aBoxIsZoomedInto()
    {
        Charts charts(m_scene);
        const ChartPlot before = charts.area().plot();
        const auto time = charts.timeline.currentTime();
        charts.drag(before.at(2, 1.5), before.at(6, 0.5), Qt::ControlModifier);
        const ChartPlot after = charts.area().plot();
        const double pixelS = (before.high - before.low) / before.rect.width(),
                     pixelMps = (before.values.high - before.values.low) / before.rect.height();
        QVERIFY(std::abs(after.low - 2) <= pixelS && std::abs(after.high - 6) <= pixelS);
        QVERIFY(std::abs(after.values.low - 0.5) <= pixelMps &&
                std::abs(after.values.high - 1.5) <= pixelMps);
        QCOMPARE(charts.timeline.currentTime(), time); // it is no click
        QVERIFY(!charts.timeline.selection());
        QTest::mouseDClick(charts.area().viewport(), Qt::LeftButton, {}, after.rect.center().toPoint());
        QVERIFY(charts.span.showsAll());
        QCOMPARE(charts.area().plot().values.high, before.values.high);
    }
    void aSmallBoxIsNone()
    {
        Charts charts(m_scene);
        const QPointF at = charts.area().plot().rect.center();
        charts.drag(at, at + QPointF(2, 60), Qt::ControlModifier);
        QVERIFY(charts.span.showsAll());
    }
    void shiftAndADragPan()
    {
        Charts charts(m_scene);
        charts.span.show(4, 6);
        const ChartPlot plot = charts.area().plot();
        charts.drag(plot.at(5, 1), plot.at(4.5, 1), Qt::ShiftModifier);
        QVERIFY2(std::abs(charts.span.low() - 4.5) < 0.02, qPrintable(QString::number(charts.span.low())));
        QVERIFY(!charts.timeline.selection());
    }
    void theWheelOverTheAxisZoomsTheValues()
    {
        Charts charts(m_scene);
        const ChartPlot before = charts.area().plot();
        const QPointF position(before.rect.left() - 20, before.rect.center().y());
        QWheelEvent event(position, charts.area().viewport()->mapToGlobal(position), {}, QPoint(0, 120),
                          Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QApplication::sendEvent(charts.area().viewport(), &event);
        const ChartPlot after = charts.area().plot();
        QVERIFY(std::abs((after.values.high - after.values.low) * 1.25 -
                         (before.values.high - before.values.low)) < 1e-9);
        QVERIFY(charts.span.showsAll());
    }
    void aPinchZooms()
    {
        Charts charts(m_scene);
        const QPointF position = charts.area().plot().at(5, 1);
        QNativeGestureEvent event(Qt::ZoomNativeGesture, QPointingDevice::primaryPointingDevice(), 2,
                                  position, position, charts.area().viewport()->mapToGlobal(position), 0.5,
                                  {});
        QApplication::sendEvent(charts.area().viewport(), &event);
        QVERIFY(std::abs((charts.span.high() - charts.span.low()) * 1.5 - 299 / 30.0) < 1e-6);
    }
    void theCrosshairFollowsTheMouse()
    {
        Charts charts(m_scene);
        const ChartPlot plot = charts.area().plot();
        const QImage before = charts.picture();
        const QPoint at = plot.at(5, 1).toPoint();
        QTest::mouseMove(charts.area().viewport(), at);
        const QImage with = charts.picture();
        const QColor line = ThemeColours::of(lightPalette()).muted;
        const QRect column(at.x(), int(plot.rect.top()) + 2, 1, int(plot.rect.height()) - 4);
        QVERIFY(count(with, column, line) > count(before, column, line) + column.height() / 2);
        const QColor box = ThemeColours::of(lightPalette()).bubble;
        const QRect below(0, int(plot.rect.bottom()) + 1, with.width(), 20);
        QVERIFY(count(with, below, box) > 100); // what it stands for
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(charts.area().viewport(), &leave);
        QCOMPARE(charts.picture(), before);
    }
    void theKeyHidesARobot()
    {
        Charts charts(m_two);
        charts.card.setQuantity(Quantity::Acceleration); // spikes would be of the second robot's colour
        charts.timeline.setCurrentFrame(0);
        const ChartPlot plot = charts.area().plot();
        const QRect right(plot.rect.center().toPoint(), plot.rect.bottomRight().toPoint());
        const QColor second = seriesColour(1, lightPalette());
        QVERIFY(count(charts.picture(), right, second) > 50);
        auto *key = charts.card.findChild<SeriesKey *>();
        const QList<QAbstractButton *> entries = key->findChildren<QAbstractButton *>();
        QCOMPARE(entries.size(), 2);
        QTest::mouseClick(entries[1], Qt::LeftButton);
        QCOMPARE(count(charts.picture(), right, second), 0);
        QVERIFY(count(charts.picture(), right, seriesColour(0, lightPalette())) > 50);
        entries[1]->setFocus();
        QTest::keyClick(entries[1], Qt::Key_Space);
        QVERIFY(count(charts.picture(), right, second) > 50);
    }
    void whatTheKeyHidesStaysHiddenUntilTheNextScene()
    {
        Charts charts(m_two);
        charts.timeline.setCurrentFrame(0);
        auto *key = charts.card.findChild<SeriesKey *>();
        const auto second = [&] { return key->findChildren<QAbstractButton *>().at(1); };
        const auto drawn = [&] {
            const ChartPlot plot = charts.area().plot();
            const QRect right(plot.rect.center().toPoint(), plot.rect.bottomRight().toPoint());
            return count(charts.picture(), right, seriesColour(1, lightPalette()));
        };
        QTest::mouseClick(second(), Qt::LeftButton);
        charts.card.setQuantity(Quantity::Acceleration); // spikes would be of the second robot's colour
        QVERIFY(!second()->isChecked());
        QCOMPARE(drawn(), 0);
        charts.span.setAgainst(ChartSpan::Against::Distance);
        charts.span.setAgainst(ChartSpan::Against::Time);
        QVERIFY(!second()->isChecked());
        QCOMPARE(drawn(), 0);
        charts.card.setScene(m_two);
        QVERIFY(second()->isChecked());
        QVERIFY(drawn() > 50);
    }
    void itFollowsThePalette()
    {
        Charts charts(m_scene);
        charts.area().setPalette(darkPalette());
        const QImage image = charts.picture();
        QCOMPARE(image.pixelColor(2, 2), ThemeColours::of(darkPalette()).card);
        QVERIFY(count(image, charts.area().plot().rect.toRect(), seriesColour(0, darkPalette())) > 300);
    }
    void nothingIsShownOfNoScene()
    {
        Charts charts(m_scene);
        charts.card.setScene(nullptr);
        const QImage image = charts.picture();
        QCOMPARE(count(image, charts.area().plot().rect.toRect(), seriesColour(0, lightPalette())), 0);
    }
};

ODOGRAPH_TEST(TestChartView, QApplication)
#include "tst_chart_view.moc"
