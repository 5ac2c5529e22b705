// SPDX-License-Identifier: GPL-3.0-or-later
// Looking closely in Review: by the wheel, by keys and by a double click.
#include "tests/support/registered_test.h"
#include "tests/ui/support/busy_watch.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/number_text.h"
#include "ui/models/timeline.h"
#include "ui/review/review_desk.h"
#include "ui/views/image/camera_view.h"
#include "ui/views/image/floor_read_out.h"
#include "ui/views/map/floor_map.h"
#include "ui/views/widgets/theme.h"
#include "ui/views/widgets/zoom_pan.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <ctime>

using namespace odo;

namespace {

struct ShownDesk
{
    Timeline timeline;
    ReviewDesk desk{timeline};
    FloorMap *map = desk.findChild<FloorMap *>();

    explicit ShownDesk(const TrialScenePtr &scene, int frame = 40)
    {
        for (QAction *action : desk.viewActions())
            desk.addAction(action);
        desk.resize(1400, 900);
        timeline.setFrameTimes(scene->frameTimes());
        desk.setScene(scene);
        timeline.setCurrentFrame(frame);
        desk.show();
    }
    CameraView &view(int index = 0) const
    {
        const QString title = index == 0 ? QStringLiteral("Camera A") : QStringLiteral("Camera B");
        for (CameraView *each : desk.findChildren<CameraView *>())
            if (each->title() == title)
                return *each;
        qFatal("there is no such view");
    }
    void press(Qt::Key key)
    {
        for (QAction *action : desk.viewActions())
            if (action->shortcut() == QKeySequence(key))
                return action->trigger();
        QFAIL("no such key");
    }
};

void roll(QWidget &widget, const QPointF &at, int eighths)
{
    QWheelEvent wheel(at, widget.mapToGlobal(at), {}, QPoint(0, eighths), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &wheel);
}

QImage shot(QWidget *widget)
{
    return widget->grab().toImage().convertToFormat(QImage::Format_RGB32);
}

/// Of this thread alone: other programs cannot prolong it.
double threadCpuMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

int apart(const QColor &a, const QColor &b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue());
}

bool hasColourNear(const QImage &image, const QPointF &position, const QColor &colour, int reach,
                   int tolerance)
{
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx)
            if (const QPoint at = position.toPoint() + QPoint(dx, dy);
                image.rect().contains(at) && apart(image.pixelColor(at), colour) < tolerance)
                return true;
    return false;
}

} // namespace

class TestZoomedViews : public QObject
{
    Q_OBJECT
    QTemporaryDir m_folder;
    TrialScenePtr m_scene;

private Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        QApplication::setStyle(QStringLiteral("Fusion"));
        m_scene = exampleScene({.frames = 60, .videoFolder = m_folder.path().toStdString()});
    }
    void cleanupTestCase() { QSettings().clear(); }

    /// Each pixel of the recording is a square of one colour, with a line around it when that is large.
    void singlePixelsAreSeen()
    {
        auto bare = std::make_shared<TrialScene>(*m_scene); // with nothing painted over it
        bare->layout.reset();
        bare->robots.clear();
        ShownDesk shown(bare);
        CameraView &view = shown.view();
        QTRY_VERIFY(view.isSettled());
        const Observation &seen = *m_scene->observationAt(0, 0, 40);
        const QPointF edge(std::round(seen.ellipse.centrePx.x()) - 10, std::round(seen.ellipse.centrePx.y()));
        roll(*view.imageArea(), view.fromImagePixels(edge), 12'000);
        QVERIFY(view.zoom().state().isClosest());
        QTRY_VERIFY(view.isSettled());
        QCOMPARE(view.fromImagePixels(edge + QPointF(1, 0)).x() - view.fromImagePixels(edge).x(), 48.0);
        const QImage image = shot(view.imageArea());
        int reds = 0, squares = 0;
        for (int across = -4; across <= 4; ++across) { // over the left edge of the red box
            const QPointF middle = view.fromImagePixels(edge + QPointF(across, 0));
            if (!QRectF(image.rect()).adjusted(24, 24, -24, -24).contains(middle))
                continue;
            ++squares;
            const QColor inside = image.pixelColor((middle + QPointF(-12, 12)).toPoint());
            reds += apart(inside, QColor(0xd7, 0x23, 0x28)) < 90 ? 1 : 0;
            for (const QPointF &corner :
                 {QPointF(-20, -20), QPointF(20, -20), QPointF(20, 20), QPointF(-20, 20)})
                QCOMPARE(image.pixelColor((middle + corner).toPoint()), inside);
            const QColor line = image.pixelColor((middle + QPointF(24, 12)).toPoint());
            QVERIFY(line != inside || image.pixelColor((middle + QPointF(23, 12)).toPoint()) != inside);
        }
        QVERIFY(reds > 0 && reds < squares);
    }

    /// What is painted over the image is where the image is, however closely it is looked at.
    void overlaysFollow()
    {
        ShownDesk shown(m_scene);
        CameraView &view = shown.view(1);
        QTRY_VERIFY(view.isSettled());
        const Eigen::Vector2d late = m_scene->robots[0].analysis->profile.points[45].position;
        const Eigen::Vector2d pixel =
            *m_scene->views[1].floorView->pixelFromWorld({late.x(), late.y(), 0.06});
        const QPointF before = view.fromImagePixels({pixel.x(), pixel.y()});
        roll(*view.imageArea(), before, 960);
        QTRY_VERIFY(view.isSettled());
        const QPointF after = view.fromImagePixels({pixel.x(), pixel.y()});
        QVERIFY(QLineF(before, after).length() < 1e-9);
        QVERIFY(hasColourNear(shot(view.imageArea()), after, QColor(0x56, 0xb4, 0xe9), 2, 60));
        const QPointF elsewhere = view.fromImagePixels({pixel.x() + 10, pixel.y()});
        QVERIFY(elsewhere.x() - after.x() > 60); // 16 times as large as it fits
    }

    void theLoupeShowsTheRobot()
    {
        ShownDesk shown(m_scene);
        CameraView &view = shown.view();
        QTRY_VERIFY(view.isSettled());
        QAction *loupe = shown.desk.findChild<QAction *>(QStringLiteral("loupe"));
        const double side = 0.45 * std::min(view.imageArea()->width(), view.imageArea()->height());
        const QPointF middle(view.imageArea()->width() - 8 - side / 2, 8 + side / 2);
        view.setOutlinesShown(false);
        const QColor red(0xd7, 0x23, 0x28);
        const auto redPixels = [&] {
            const QImage image = shot(view.imageArea());
            int count = 0;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x)
                    count += apart(image.pixelColor(QPointF(middle.x() - side / 2 + x, 8 + y).toPoint()),
                                   red) < 90;
            return count;
        };
        QVERIFY(redPixels() < 100);
        loupe->trigger();
        QTRY_VERIFY(view.isSettled());
        QVERIFY(redPixels() > side * side / 8); // the robot is some twenty pixels long
        shown.timeline.setCurrentFrame(10);     // it follows
        QTRY_VERIFY(view.isSettled());
        QVERIFY(redPixels() > side * side / 8);
        loupe->trigger();
        QVERIFY(redPixels() < 2000);
    }

    void theReadOutNamesPixelAndFloor()
    {
        ShownDesk shown(m_scene);
        CameraView &view = shown.view();
        QTRY_VERIFY(view.isSettled());
        const auto *readOut = view.findChild<FloorReadOut *>();
        roll(*view.imageArea(), {200, 150}, 480);
        const QPointF pixel(300, 200);
        Q_EMIT view.hovered(pixel);
        const Eigen::Vector2d floor = *m_scene->views[0].floorView->floorFromPixel({300, 200}, 0);
        const QString text = readOut->floorText(); // rounded to what its σ leaves
        QVERIFY2(std::abs(text.section(u' ', 1, 1).toDouble() - 1e3 * floor.x()) <= 1 &&
                     text.contains(QStringLiteral(" · y ")) && text.contains(u'±'),
                 qPrintable(text));
        Q_EMIT view.hovered(QPointF(300, -1e4)); // above the horizon
        QCOMPARE(readOut->floorText(), QString());
    }

    void keysZoomWhatTheMouseWasOver()
    {
        ShownDesk shown(m_scene);
        Q_EMIT shown.view(1).zoom().used();
        shown.press(Qt::Key_Plus);
        QCOMPARE(shown.view(1).zoom().state().scale(), 1.5);
        QVERIFY(shown.view(0).zoom().state().isFitted());
        shown.press(Qt::Key_Plus);
        shown.press(Qt::Key_Minus);
        QCOMPARE(shown.view(1).zoom().state().scale(), 1.5);
        shown.press(Qt::Key_0);
        QVERIFY(shown.view(1).zoom().state().isFitted());
        Q_EMIT shown.map->zoom().used();
        shown.press(Qt::Key_Plus);
        QCOMPARE(shown.map->zoom().state().scale(), 1.5);
        shown.desk.setScene(exampleScene({.frames = 5})); // another trial, of which the videos are missing
        QCOMPARE(shown.map->zoom().state().scale(), 1.5);
    }

    void aDoubleClickEnlargesAndBack()
    {
        ShownDesk shown(m_scene);
        CameraView &view = shown.view();
        const int width = view.width();
        QList<QDockWidget *> docks; // that are on show: that of the samples is not
        for (QDockWidget *dock : shown.desk.findChildren<QDockWidget *>())
            if (dock->isVisible())
                docks << dock;
        QCOMPARE(docks.size(), qsizetype(2));
        QTest::mouseDClick(view.imageArea(), Qt::LeftButton);
        QVERIFY(view.isVisible() && !shown.view(1).isVisible() && !shown.map->isVisible());
        for (const QDockWidget *dock : shown.desk.findChildren<QDockWidget *>())
            QVERIFY(!dock->isVisible());
        QTRY_VERIFY(view.width() > shown.desk.width() - 20);
        shown.desk.saveLayout(); // of before
        QTest::mouseDClick(view.imageArea(), Qt::LeftButton);
        QVERIFY(shown.view(1).isVisible() && shown.map->isVisible());
        for (const QDockWidget *dock : shown.desk.findChildren<QDockWidget *>())
            QCOMPARE(dock->isVisible(), docks.contains(dock));
        QTRY_COMPARE(view.width(), width);
        {
            ShownDesk again(m_scene);
            QVERIFY(again.view(1).isVisible() && again.map->isVisible());
        }
        Q_EMIT shown.map->zoom().used();
        shown.press(Qt::Key_E);
        QVERIFY(shown.map->isVisible() && !view.isVisible());
        shown.desk.setScene(nullptr); // its views go
        QVERIFY(shown.map->isVisible());
        shown.desk.setScene(m_scene);
        QVERIFY(shown.view().isVisible());
    }

    void aClickOnTheEnlargedTrailGoesThere()
    {
        ShownDesk shown(m_scene);
        const Eigen::Vector2d point = m_scene->robots[0].analysis->profile.points[20].position;
        roll(*shown.map->mapArea(), shown.map->fromWorld(point), 720);
        const QPointF at = shown.map->fromWorld(point);
        QTest::mouseClick(shown.map->mapArea(), Qt::LeftButton, {}, at.toPoint());
        QCOMPARE(shown.timeline.currentFrame(), 20);
        const QPointF shift = shown.map->zoom().state().shift();
        QTest::mousePress(shown.map->mapArea(), Qt::LeftButton, {}, at.toPoint()); // on it nothing is dragged
        QTest::mouseMove(shown.map->mapArea(), at.toPoint() + QPoint(60, 60));
        QTest::mouseRelease(shown.map->mapArea(), Qt::LeftButton, {}, at.toPoint() + QPoint(60, 60));
        QCOMPARE(shown.map->zoom().state().shift(), shift);
    }

    /// A view of 4K, and the map, of a run of five minutes.
    void itStaysFluid()
    {
        QTemporaryDir folder;
        const TrialScenePtr scene = exampleScene(
            {.frames = 4, .widthPx = 3840, .heightPx = 2160, .videoFolder = folder.path().toStdString()});
        const TrialScenePtr longRun = exampleScene({.frames = 9000});
        auto both = std::make_shared<TrialScene>(*scene);
        both->robots.front().analysis = longRun->robots.front().analysis;
        ShownDesk shown(both, 0);
        CameraView &view = shown.view();
        QTRY_VERIFY_WITH_TIMEOUT(view.isSettled(), 20'000);
        shown.desk.toggleEnlarged(&view);
        measure("4K view", *view.imageArea(), view.zoom());
        followsAtLast(*view.imageArea(), [&] { return view.isSettled(); });
        view.zoom().fit();
        shown.desk.toggleEnlarged(&view);
        shown.desk.toggleEnlarged(shown.map);
        measure("map of 9000 points", *shown.map->mapArea(), shown.map->zoom());
        followsAtLast(*shown.map->mapArea(), [&] { return shown.map->isSettled(); });
    }

private:
    /// What was painted on another thread is what is painted at once.
    static void followsAtLast(QWidget &area, const std::function<bool()> &isSettled)
    {
        roll(area, QRectF(area.rect()).center(), 360);
        area.repaint();
        QTRY_VERIFY(isSettled());
        const QImage patient = shot(&area);
        QEvent event(QEvent::FontChange); // all of it is painted anew
        QCoreApplication::sendEvent(&area, &event);
        const QImage anew = shot(&area);
        QCOMPARE(patient, anew);
    }

    static void measure(const char *what, QWidget &area, ZoomPan &zoom)
    {
        std::vector<double> tookMs;
        const auto paint = [&] {
            const double before = threadCpuMs();
            area.repaint();
            tookMs.push_back(threadCpuMs() - before);
        };
        const QPointF middle = QRectF(area.rect()).center();
        for (int notch = 0; notch < 14; ++notch) {
            roll(area, middle, 120);
            paint();
            QTest::qWait(0);
        }
        for (int step = 0; step < 30; ++step) {
            QTest::mousePress(&area, Qt::MiddleButton, {}, middle.toPoint());
            QTest::mouseMove(&area, middle.toPoint() + QPoint(step % 2 ? 40 : -40, step % 3 ? 15 : -30));
            paint();
            QTest::mouseRelease(&area, Qt::MiddleButton, {}, middle.toPoint());
        }
        zoom.fit();
        std::ranges::sort(tookMs);
        qInfo("%s, %d x %d: median %.1f ms, longest %.1f ms", what, area.width(), area.height(),
              tookMs[tookMs.size() / 2], tookMs.back());
        QVERIFY(tookMs.back() < longestAllowedMs());
    }
};

ODOGRAPH_TEST(TestZoomedViews, QApplication)
#include "tst_zoomed_views.moc"
