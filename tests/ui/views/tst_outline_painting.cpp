// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/silhouette.h"
#include "tests/support/registered_test.h"
#include "tests/ui/support/example_scene.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/image/camera_view.h"
#include "ui/views/image/image_overlay.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QTest>
#include <array>
#include <cmath>

using namespace odo;

namespace {

const QColor colour(0x56, 0xb4, 0xe9);

/// A square of 60 pixels' half side about (100, 80), as its support tells it.
Observation squareSeen()
{
    Observation seen;
    seen.found = true;
    seen.ellipse = {{100, 80}, 40, 40, 0};
    seen.supportPx = supportOf({{40, 20}, {160, 20}, {160, 140}, {40, 140}}, seen.ellipse.centrePx);
    return seen;
}

QPointF asItIs(const QPointF &pixel)
{
    return pixel;
}

QImage painted(const Observation &seen, const QColor &ground, bool withLine = true)
{
    QImage image(320, 200, QImage::Format_RGB32);
    image.fill(ground);
    QPainter painter(&image);
    painter.setClipRect(image.rect());
    paintOutline(painter, seen, QStringLiteral("Red 2"), colour, asItIs, withLine);
    return image;
}

bool isColour(const QColor &got)
{
    return std::abs(got.red() - colour.red()) + std::abs(got.green() - colour.green()) +
               std::abs(got.blue() - colour.blue()) <
           40;
}

/// The part of the square's upper side along which the line's colour is.
double colouredPartOfTop(const QImage &image)
{
    int coloured = 0;
    for (int x = 50; x < 150; ++x)
        coloured += isColour(image.pixelColor(x, 18)) || isColour(image.pixelColor(x, 17));
    return coloured / 100.0;
}

} // namespace

class TestOutlinePainting : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void theSupportIsAPolygon()
    {
        const QRectF box = outlinePath(squareSeen(), [](const QPointF &pixel) {
                               return 2 * pixel + QPointF(5, 7);
                           }).boundingRect();
        QVERIFY(std::abs(box.left() - 85) < 0.1 && std::abs(box.top() - 47) < 0.1);
        QVERIFY(std::abs(box.right() - 325) < 0.1 && std::abs(box.bottom() - 287) < 0.1);
        // in the corner, where no ellipse reaches
        QVERIFY(outlinePath(squareSeen(), asItIs).contains(QPointF(158, 138)));
    }

    void aLineOutsideIsSoMuchWider()
    {
        const QRectF box = outlinePath(
                               squareSeen(), [](const QPointF &pixel) { return 2 * pixel; }, 3)
                               .boundingRect();
        QVERIFY(std::abs(box.left() - 77) < 0.1 && std::abs(box.top() - 37) < 0.1);
        QVERIFY(std::abs(box.right() - 323) < 0.1 && std::abs(box.bottom() - 283) < 0.1);
    }

    void withoutSupportItIsTheEllipse()
    {
        Observation seen = squareSeen();
        seen.ellipse = {{100, 80}, 50, 10, 0.5};
        for (const std::vector<float> &support :
             {std::vector<float>(), std::vector<float>(supportDirections, 0)}) {
            seen.supportPx = support;
            const QPainterPath path = outlinePath(seen, asItIs);
            const QPointF along(std::cos(0.5), std::sin(0.5)), across(-std::sin(0.5), std::cos(0.5)),
                centre(100, 80);
            QVERIFY(path.contains(centre + 48 * along) && !path.contains(centre + 52 * along));
            QVERIFY(path.contains(centre + 9 * across) && !path.contains(centre + 11 * across));
        }
    }

    void whatWasNotFoundIsNotDrawn()
    {
        Observation seen = squareSeen();
        seen.found = false;
        QVERIFY(outlinePath(seen, asItIs).isEmpty());
        QImage empty(320, 200, QImage::Format_RGB32);
        empty.fill(Qt::gray);
        QCOMPARE(painted(seen, Qt::gray), empty);
    }

    void theLineIsSeenOnAnyFloor()
    {
        for (const QColor &ground : {QColor(Qt::white), QColor(Qt::black), QColor(Qt::gray), colour}) {
            const QImage image = painted(squareSeen(), ground);
            QCOMPARE(colouredPartOfTop(image), 1.0);
            if (ground == QColor(Qt::black))
                continue;
            int dark = 0; // the casing on both sides of the line
            for (int y = 14; y < 20; ++y)
                dark += image.pixelColor(100, y).lightness() < ground.lightness() / 2 + 30;
            QVERIFY2(dark >= 2, qPrintable(QString::number(dark)));
            QCOMPARE(image.pixelColor(100, 21), ground); // the robot itself is left to be seen
        }
    }

    void whatTheBorderCutsIsDashed()
    {
        Observation seen = squareSeen();
        seen.touchesBorder = true;
        const double part = colouredPartOfTop(painted(seen, Qt::white));
        QVERIFY2(part > 0.35 && part < 0.75, qPrintable(QString::number(part)));
    }

    void withoutTheLineTheNameStays()
    {
        const QImage image = painted(squareSeen(), Qt::white, false);
        QCOMPARE(colouredPartOfTop(image), 0.0);
        const QImage besideIt = image.copy(167, 60, 60, 40);
        QImage blank(besideIt.size(), besideIt.format());
        blank.fill(Qt::white);
        QVERIFY(besideIt != blank);
    }

    void eachRobotHasItsColour()
    {
        TrialScene scene = *exampleScene({.frames = 5, .robots = 2});
        const auto views = [&](const std::optional<QColor> &all, bool outlines) {
            Timeline timeline;
            CameraView view(timeline);
            view.resize(640, 400);
            timeline.setFrameTimes(scene.frameTimes());
            scene.robots[1].observations[0][0].ellipse.centrePx = {200, 100};
            for (SceneRobot &robot : scene.robots)
                robot.analysis.reset(); // no trails
            view.setScene(std::make_shared<TrialScene>(scene), 0);
            view.setOutlinesShown(outlines);
            if (all)
                view.setRobotColour(*all);
            const QImage image = view.grab().toImage();
            std::array<int, 3> counts{};
            for (int position = 0; position < 3; ++position) {
                const QRgb wanted = colourOnImage(position).rgb();
                for (int y = 0; y < image.height(); ++y)
                    for (int x = 0; x < image.width(); ++x)
                        counts.at(std::size_t(position)) += image.pixel(x, y) == wanted;
            }
            return counts;
        };
        const auto own = views({}, true), all = views(colourOnImage(2), true), none = views({}, false);
        QVERIFY(own[0] > 20 && own[1] > 20 && own[2] == 0);
        QVERIFY(all[0] == 0 && all[1] == 0 && all[2] > 40);
        QVERIFY(none[0] < own[0] / 3 && none[1] < own[1] / 3); // the names
    }

    void eightOfThemCostNothingThatIsNoticed()
    {
        QImage image(960, 540, QImage::Format_RGB32);
        image.fill(Qt::gray);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setClipRect(image.rect());
        QElapsedTimer clock;
        clock.start();
        constexpr int times = 100;
        for (int i = 0; i < 8 * times; ++i)
            paintOutline(painter, squareSeen(), QStringLiteral("Red 2"), colour, asItIs);
        const double perFrameMs = double(clock.nsecsElapsed()) / 1e6 / times;
        qInfo("%.2f ms a frame", perFrameMs);
        QVERIFY2(perFrameMs < 8, qPrintable(QString::number(perFrameMs)));
    }
};

ODOGRAPH_TEST(TestOutlinePainting, QApplication)
#include "tst_outline_painting.moc"
