// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_drawing.h"

#include "ui/views/charts/internal/chart.h"
#include "ui/views/charts/window_thread.h"

#include <QGraphicsScene>
#include <QPainter>
#include <QPicture>
#include <memory>
#include <optional>

namespace odo {

namespace {

/// A chart as drawing commands, which any painter plays.
struct Recorded
{
    ChartDrawing drawing;
    QSizeF size;
    QPalette palette;
    QFont font;
    double fineness = 1;
    QPicture picture; ///< once it was made
    ChartPlot plot;   ///< likewise
};

void record(Recorded &recorded)
{
    QGraphicsScene scene;
    auto *chart = new Chart(recorded.drawing.axes);
    scene.addItem(chart);
    chart->setFineness(recorded.fineness);
    chart->setLook(recorded.palette, recorded.font);
    chart->setContent(recorded.drawing.content, recorded.drawing.stretches);
    chart->setSize(recorded.size);
    std::optional<ValueRange> chosen;
    if (recorded.drawing.axes.style == ChartStyle::Strip && recorded.drawing.content)
        chosen = recorded.drawing.content->range; // its rows are where the page has them
    chart->show(recorded.drawing.low, recorded.drawing.high, chosen);
    chart->prepare();
    const QRectF room(QPointF(0, 0), recorded.size);
    QPainter painter(&recorded.picture);
    painter.setRenderHint(QPainter::Antialiasing);
    scene.render(&painter, room, room, Qt::IgnoreAspectRatio);
    recorded.plot = chart->chartPlot();
}

} // namespace

ChartPlot drawChart(QPainter &painter, const QRectF &rect, const ChartDrawing &drawing,
                    const QPalette &palette, const QFont &font, double fineness)
{
    // Shared with the window's thread, which may come to it when the caller has given up.
    const auto recorded = std::make_shared<Recorded>();
    recorded->drawing = drawing;
    recorded->size = rect.size();
    recorded->palette = palette;
    recorded->font = font;
    recorded->fineness = fineness;
    onWindowThread([recorded] { record(*recorded); });
    // Playing it would enlarge it by the dots to an inch, which whoever made the painter has done already.
    const QPaintDevice &paper = *painter.device();
    painter.save();
    painter.translate(rect.topLeft());
    painter.scale(double(recorded->picture.logicalDpiX()) / paper.logicalDpiX(),
                  double(recorded->picture.logicalDpiY()) / paper.logicalDpiY());
    painter.drawPicture(QPointF(), recorded->picture);
    painter.restore();
    ChartPlot plot = recorded->plot;
    plot.rect.translate(rect.topLeft());
    return plot;
}

} // namespace odo
