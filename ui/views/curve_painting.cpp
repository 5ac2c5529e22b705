// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/curve_painting.h"

#include "ui/views/decimation.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace odo {

namespace {

constexpr double lineWidth = 1.8, dotWidth = 2.6;
constexpr int hazeAlpha = 60;

using BandPoints = std::span<const BandPoint>;

/// Those between low and high, and the next one on either side.
BandPoints visibleOf(const std::vector<BandPoint> &points, double low, double high)
{
    const auto inside = std::lower_bound(points.begin(), points.end(), low, [](const BandPoint &point, double x) { return point.x < x; });
    const auto beyond = std::upper_bound(points.begin(), points.end(), high, [](double x, const BandPoint &point) { return x < point.x; });
    return {inside == points.begin() ? inside : inside - 1, beyond == points.end() ? beyond : beyond + 1};
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
std::vector<Column> columnsOf(const ChartPlot &plot, BandPoints points)
{
    const int count = columnCount(plot);
    std::vector<Column> columns(static_cast<std::size_t>(count));
    const double step = (plot.high - plot.low) / (plot.rect.width() * plot.fineness);
    auto point = points.begin();
    while (point != points.end() && point->x < plot.low)
        ++point;
    for (int index = 0; index < count && point != points.end(); ++index) {
        const double edge = plot.low + (index + 1) * step;
        if (point->x >= edge)
            continue;
        Column column;
        column.low = column.high = double((point == points.begin() ? point : point - 1)->value);
        for (; point != points.end() && point->x < edge; ++point) {
            const double value = double(point->value), low = point->low(), high = point->high();
            column.low = value < column.low ? value : column.low;
            column.high = value > column.high ? value : column.high;
            column.bandLow = low < column.bandLow ? low : column.bandLow;
            column.bandHigh = high > column.bandHigh ? high : column.bandHigh;
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

template <class Value>
QPolygonF placed(BandPoints points, const ChartPlot &plot, const Value &value)
{
    QPolygonF places;
    places.reserve(static_cast<qsizetype>(points.size()));
    for (const BandPoint &point : points)
        places << plot.at(point.x, std::invoke(value, point));
    return places;
}

void drawLine(QPainter &painter, const ChartPlot &plot, BandPoints points, const CurvePen &pen)
{
    QPolygonF band = placed(points, plot, &BandPoint::high);
    const QPolygonF lower = placed(points, plot, &BandPoint::low);
    std::copy(lower.crbegin(), lower.crend(), std::back_inserter(band));
    QColor haze = pen.colour;
    haze.setAlpha(hazeAlpha);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(haze);
    painter.drawPolygon(band);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(pen.colour, lineWidth, pen.dash, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(placed(points, plot, &BandPoint::value));
}

} // namespace

void drawCurveRun(QPainter &painter, const ChartPlot &plot, const CurveRun &run, const CurvePen &pen)
{
    const BandPoints points = visibleOf(run.points, plot.low, plot.high);
    if (points.empty() || plot.rect.width() < 1)
        return;
    painter.save();
    painter.setClipRect(plot.rect);
    if (points.size() > static_cast<std::size_t>(columnCount(plot)))
        drawColumns(painter, plot, columnsOf(plot, points), pen);
    else
        drawLine(painter, plot, points, pen);
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
