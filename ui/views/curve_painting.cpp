// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curve_painting.h"

#include "ui/views/decimation.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace odo {

namespace {

constexpr double lineWidth = 1.8, dotWidth = 2.6;
constexpr int hazeAlpha = 60;

/// The first point at or beyond x, and one before it where there is one.
qsizetype firstVisible(const QList<QPointF> &points, double x)
{
    const auto at = std::lower_bound(points.begin(), points.end(), x,
                                     [](const QPointF &point, double low) { return point.x() < low; });
    return std::max<qsizetype>(0, at - points.begin() - 1);
}

qsizetype endOfVisible(const QList<QPointF> &points, double x)
{
    const auto at = std::upper_bound(points.begin(), points.end(), x,
                                     [](double high, const QPointF &point) { return high < point.x(); });
    return std::min(points.size(), at - points.begin() + 1);
}

struct Column
{
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    double bandLow = low, bandHigh = high;
    bool isEmpty() const { return high < low; }
};

int columnCount(const ChartPlot &plot)
{
    return std::max(1, int(std::ceil(plot.rect.width() * plot.fineness)));
}

/// Of each pixel column the extremes of line and band; neighbours reach one another.
std::vector<Column> columnsOf(const ChartPlot &plot, const CurveRun &run, qsizetype from, qsizetype to)
{
    const int count = columnCount(plot);
    std::vector<Column> columns(static_cast<std::size_t>(count));
    const QPointF *line = run.line.constData(), *lower = run.lower.constData(),
                  *upper = run.upper.constData();
    const double step = (plot.high - plot.low) / (plot.rect.width() * plot.fineness);
    qsizetype i = from;
    while (i < to && line[i].x() < plot.low)
        ++i;
    for (int index = 0; index < count && i < to; ++index) {
        const double edge = plot.low + (index + 1) * step;
        if (line[i].x() >= edge)
            continue;
        Column column;
        const double before = line[i > from ? i - 1 : i].y();
        column.low = column.high = before;
        for (; i < to && line[i].x() < edge; ++i) {
            column.low = line[i].y() < column.low ? line[i].y() : column.low;
            column.high = line[i].y() > column.high ? line[i].y() : column.high;
            column.bandLow = lower[i].y() < column.bandLow ? lower[i].y() : column.bandLow;
            column.bandHigh = upper[i].y() > column.bandHigh ? upper[i].y() : column.bandHigh;
        }
        columns[static_cast<std::size_t>(index)] = column;
    }
    return columns;
}

void drawColumns(QPainter &painter, const ChartPlot &plot, const std::vector<Column> &columns,
                 const CurvePen &pen)
{
    constexpr std::size_t dashLength = 10, dashed = 6;
    const double width = 1 / plot.fineness;
    QList<QRectF> line, band;
    const auto between = [&](std::size_t i, double low, double high, double least) {
        const double top = plot.at(plot.low, high).y(), bottom = plot.at(plot.low, low).y();
        const double height = std::max(least, bottom - top);
        return QRectF(plot.rect.left() + double(i) * width, (top + bottom - height) / 2, width, height);
    };
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Column &column = columns[i];
        if (column.isEmpty())
            continue;
        band << between(i, column.bandLow, column.bandHigh, 1);
        if (pen.dash == Qt::SolidLine || std::size_t(double(i) * width) % dashLength < dashed)
            line << between(i, column.low, column.high, lineWidth);
    }
    QColor haze = pen.colour;
    haze.setAlpha(hazeAlpha);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(haze);
    painter.drawRects(band);
    painter.setBrush(pen.colour);
    painter.drawRects(line);
    painter.setRenderHint(QPainter::Antialiasing);
}

QPolygonF placed(const QList<QPointF> &points, const ChartPlot &plot, qsizetype from, qsizetype to)
{
    QPolygonF places;
    places.reserve(to - from);
    for (qsizetype i = from; i < to; ++i)
        places << plot.at(points[i].x(), points[i].y());
    return places;
}

void drawLine(QPainter &painter, const ChartPlot &plot, const CurveRun &run, qsizetype from, qsizetype to,
              const CurvePen &pen)
{
    QPolygonF band = placed(run.upper, plot, from, to);
    const QPolygonF lower = placed(run.lower, plot, from, to);
    std::copy(lower.crbegin(), lower.crend(), std::back_inserter(band));
    QColor haze = pen.colour;
    haze.setAlpha(hazeAlpha);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(haze);
    painter.drawPolygon(band);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(pen.colour, lineWidth, pen.dash, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(placed(run.line, plot, from, to));
}

} // namespace

void drawCurveRun(QPainter &painter, const ChartPlot &plot, const CurveRun &run, const CurvePen &pen)
{
    const qsizetype from = firstVisible(run.line, plot.low), to = endOfVisible(run.line, plot.high);
    if (from >= to || plot.rect.width() < 1)
        return;
    painter.save();
    painter.setClipRect(plot.rect);
    if (to - from > columnCount(plot))
        drawColumns(painter, plot, columnsOf(plot, run, from, to), pen);
    else
        drawLine(painter, plot, run, from, to, pen);
    painter.restore();
}

void drawCurvePoints(QPainter &painter, const ChartPlot &plot, const QList<QPointF> &points,
                     const QColor &colour)
{
    const int columns = columnCount(plot);
    const QList<QPointF> shown = decimated(points, plot.low, plot.high, columns);
    painter.save();
    painter.setClipRect(plot.rect);
    if (shown.size() > columns) { // round dots would run into one another, at many times the cost
        painter.setRenderHint(QPainter::Antialiasing, false);
        for (const QPointF &point : shown)
            painter.fillRect(QRectF(plot.at(point.x(), point.y()) - QPointF(1, 1), QSizeF(2, 2)), colour);
    } else {
        QList<QPointF> places;
        for (const QPointF &point : shown)
            places << plot.at(point.x(), point.y());
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(colour, dotWidth, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoints(places.constData(), int(places.size()));
    }
    painter.restore();
}

} // namespace odo
