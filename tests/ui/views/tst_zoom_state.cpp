// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/zoom_state.h"

#include "tests/support/registered_test.h"
#include "ui/views/widgets/zoom_pan.h"

#include <QApplication>
#include <QLineF>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <QWidget>
#include <random>

using namespace odo;

namespace {

constexpr double exact = 1e-9;

const QRectF view(0, 0, 640, 480);
const QRectF fitted(0, 60, 640, 360); // letter-boxed

ZoomState framed(double mostScale = 100)
{
    ZoomState state;
    state.setFrame(fitted, view, mostScale);
    return state;
}

double apart(const QPointF &a, const QPointF &b)
{
    return QLineF(a, b).length();
}

bool roll(QWidget &widget, const QPointF &at, int eighths)
{
    QWheelEvent wheel(at, widget.mapToGlobal(at), {}, QPoint(0, eighths), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &wheel);
    return wheel.isAccepted();
}

} // namespace

class TestZoomState : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void fittedIsAsItIs()
    {
        const ZoomState state = framed();
        QVERIFY(state.isFitted() && !state.isClosest());
        QCOMPARE(state.toShown(QPointF(12.5, 77)), QPointF(12.5, 77));
        QCOMPARE(state.toShown(fitted), fitted);
        ZoomState none; // before anything is known
        QVERIFY(!none.zoomBy(2, {}) && !none.panBy({3, 3}) && !none.fit());
        none.setFrame({}, {}, 0);
        QCOMPARE(none.toShown(QPointF(1, 2)), QPointF(1, 2));
    }

    /// Rounding alone may move it: 1e-9 of a pixel is a million times what it does.
    void thePointUnderTheMouseStays()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> x(0, 640), y(0, 480), factor(0.7, 1.6);
        for (int round = 0; round < 200; ++round) {
            ZoomState state = framed(500);
            state.zoomBy(40, {x(random), y(random)});
            for (int step = 0; step < 50; ++step) {
                const QPointF mouse(x(random), y(random)), under = state.toFitted(mouse);
                const ZoomState before = state;
                state.zoomBy(factor(random), mouse);
                const QRectF shown = state.toShown(fitted);
                const bool isAtEdge =
                    shown.left() > -1 || shown.top() > -1 || shown.right() < 641 || shown.bottom() < 481;
                if (!isAtEdge)
                    QVERIFY(apart(state.toShown(under), mouse) < exact);
                QVERIFY(apart(state.toFitted(state.toShown(under)), under) < exact);
            }
        }
    }

    void theViewIsNeverLeftEmpty()
    {
        ZoomState state = framed();
        QVERIFY(!state.panBy({50, 50})); // all of it is seen
        QVERIFY(state.zoomBy(1.2, {0, 0}));
        QRectF shown = state.toShown(fitted);
        QCOMPARE(shown.left(), 0.0);
        QCOMPARE(shown.center().y(), view.center().y()); // 432 of 480 pixels: in the middle
        QVERIFY(state.zoomBy(10, {320, 240}));
        QVERIFY(state.panBy({1e6, -1e6}));
        shown = state.toShown(fitted);
        QVERIFY(std::abs(shown.left()) < exact && std::abs(shown.bottom() - 480) < exact);
        QVERIFY(!state.panBy({1, 0}));
        QVERIFY(state.panBy({-1, 0}));
        QVERIFY(state.zoomBy(1e-6, {320, 240})); // not smaller than where it fits
        QVERIFY(state.isFitted() && state.toShown(fitted) == fitted);
        QVERIFY(!state.zoomBy(0.5, {320, 240}));
        QVERIFY(state.zoomBy(1e6, {320, 240}));
        QVERIFY(state.isClosest() && state.scale() == 100);
        QVERIFY(!state.zoomBy(2, {320, 240}));
        QVERIFY(state.fit() && !state.fit());
        QCOMPARE(state.shift(), QPointF());
    }

    void anotherSizeKeepsTheMiddle()
    {
        ZoomState state = framed();
        const QRectF larger(0, 0, 1280, 720), largerView(0, 0, 1280, 720);
        state.setFrame(larger, largerView, 100);
        QCOMPARE(state.toShown(larger), larger); // fitted stays fitted
        state = framed();
        state.zoomBy(8, {400, 200});
        const QPointF middle = state.toFitted(view.center());
        const QPointF part((middle.x() - fitted.left()) / fitted.width(),
                           (middle.y() - fitted.top()) / fitted.height());
        state.setFrame(larger, largerView, 100);
        QCOMPARE(state.scale(), 8.0);
        const QPointF now = state.toFitted(largerView.center());
        QVERIFY(apart({now.x() / 1280, now.y() / 720}, part) < exact);
        state.setFrame(larger, largerView, 4); // no closer than that any more
        QCOMPARE(state.scale(), 4.0);
        state.fit();
        QCOMPARE(state.toShown(larger), larger);
    }

    void wheelAndDragReachIt()
    {
        QWidget widget;
        widget.resize(640, 480);
        widget.show();
        ZoomPan zoom(widget);
        zoom.setFrame(fitted, 100);
        QSignalSpy changed(&zoom, &ZoomPan::changed), doubled(&zoom, &ZoomPan::doubleClicked);
        const QPointF mouse(200, 250);
        QVERIFY(roll(widget, mouse, 480)); // four notches
        QCOMPARE(zoom.state().scale(), 4.0);
        QVERIFY(apart(zoom.state().toShown(mouse), mouse) < exact);
        QCOMPARE(changed.count(), 1);
        const QPointF under = zoom.state().toFitted({300, 300});
        QTest::mousePress(&widget, Qt::MiddleButton, {}, {300, 300});
        QTest::mouseMove(&widget, {340, 320});
        QTest::mouseRelease(&widget, Qt::MiddleButton, {}, {340, 320});
        QVERIFY(apart(zoom.state().toShown(under), {340, 320}) < exact);
        bool mayDrag = false;
        zoom.setDragFilter([&mayDrag](const QPointF &) { return mayDrag; });
        for (const bool may : {false, true}) {
            mayDrag = may;
            const QPointF before = zoom.state().shift();
            QTest::mousePress(&widget, Qt::LeftButton, {}, {300, 300});
            QTest::mouseMove(&widget, {280, 290});
            QTest::mouseRelease(&widget, Qt::LeftButton, {}, {280, 290});
            QCOMPARE(zoom.state().shift() != before, may);
        }
        QTest::mouseDClick(&widget, Qt::LeftButton, {}, {300, 300});
        QCOMPARE(doubled.count(), 1);
        zoom.fit();
        QVERIFY(zoom.state().isFitted());
        zoom.zoomIn();
        QCOMPARE(zoom.state().scale(), 1.5);
        zoom.zoomOut();
        QVERIFY(zoom.state().isFitted());
    }
};

ODOGRAPH_TEST(TestZoomState, QApplication)
#include "tst_zoom_state.moc"
