// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/profile_curve.h"

#include "ui/models/figure_text.h"
#include "ui/views/charts/simplified_line.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

namespace odo {

namespace {

constexpr double band95 = 1.959964; // of the normal distribution

ShownUnit unitOf(Quantity quantity)
{
    constexpr double degrees = 180 / std::numbers::pi;
    switch (quantity) {
    case Quantity::Speed:
        return shownUnits().speed;
    case Quantity::Acceleration:
        return shownUnits().acceleration;
    case Quantity::Heading:
        return {QStringLiteral("°"), degrees};
    case Quantity::TurnRate:
        return {QStringLiteral("°/s"), degrees};
    case Quantity::PositionX:
    case Quantity::PositionY:
        break;
    }
    return shownUnits().length;
}

} // namespace

std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity)
{
    auto values = quantityValues(profile, quantity);
    const double factor = curveFactor(quantity);
    for (auto &value : values)
        if (value)
            value = CurveValue{factor * value->value, factor * value->sigma};
    return values;
}

QString curveUnit(Quantity quantity)
{
    return unitOf(quantity).name;
}

double curveFactor(Quantity quantity)
{
    return unitOf(quantity).perSi;
}

std::vector<double> sampleTimes(const Profile &profile)
{
    std::vector<double> times;
    times.reserve(profile.samples.size());
    for (const Sample &sample : profile.samples)
        times.push_back(toSeconds(sample.time));
    return times;
}

BandPoint::BandPoint(double place, const CurveValue &curveValue)
    : x(place), value(float(curveValue.value)), reach(float(band95 * curveValue.sigma))
{
}

CurveValue BandPoint::curveValue() const
{
    return {double(value), double(reach) / band95};
}

std::vector<CurveRun> curveRuns(const std::vector<std::optional<CurveValue>> &values,
                                const std::vector<double> &places)
{
    std::vector<CurveRun> runs;
    const auto exists = [](const std::optional<CurveValue> &value) { return value.has_value(); };
    for (auto begin = std::find_if(values.begin(), values.end(), exists); begin != values.end();) {
        const auto end = std::find_if_not(begin, values.end(), exists);
        CurveRun &run = runs.emplace_back(CurveRun{static_cast<std::size_t>(begin - values.begin()), {}});
        run.points.reserve(static_cast<std::size_t>(end - begin));
        for (auto value = begin; value != end; ++value)
            run.points.emplace_back(places[static_cast<std::size_t>(value - values.begin())], **value);
        begin = std::find_if(end, values.end(), exists);
    }
    return runs;
}

ValueRange valueRange(const std::vector<const CurveRun *> &runs, Quantity quantity)
{
    const bool isPlace = quantity == Quantity::PositionX || quantity == Quantity::PositionY;
    double low = isPlace && !runs.empty() ? runs.front()->points.front().value : 0, high = low;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, double(point.value));
            high = std::max(high, double(point.value));
        }
    const double room = 0.25 * std::max(1e-3, high - low);
    // A speed is not negative, whatever its σ.
    const double least = quantity == Quantity::Speed ? std::max(0.0, low - room) : low - room,
                 most = high + room;
    for (const CurveRun *run : runs)
        for (const BandPoint &point : run->points) {
            low = std::min(low, std::max(point.low(), least));
            high = std::max(high, std::min(point.high(), most));
        }
    return {low, high - low < 1e-6 ? low + 1 : high};
}

QList<QPointF> measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &places)
{
    QList<QPointF> points;
    const auto values = measuredValues(profile, quantity);
    points.reserve(std::count_if(values.begin(), values.end(),
                                 [](const std::optional<CurveValue> &value) { return value.has_value(); }));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i])
            points.append({places[i], curveFactor(quantity) * values[i]->value});
    return points;
}

QList<QPointF> spikePoints(const Profile &profile, Quantity quantity, const std::vector<double> &places)
{
    QList<QPointF> spikes;
    for (const Spike &spike : profile.spikes) {
        const auto index = static_cast<std::size_t>(spike.sampleIndex);
        if (quantity != Quantity::Speed || index >= profile.points.size())
            continue;
        const auto measured = measuredSpeed(profile, index);
        if (measured || profile.points[index].valid)
            spikes.append({places[index], curveFactor(Quantity::Speed) *
                                              (measured ? *measured : profile.points[index].speedMps)});
    }
    return spikes;
}

namespace {

constexpr double lineWidth = 1.8, dotWidth = 2.6;
constexpr int hazeAlpha = 60;

using BandPoints = std::span<const BandPoint>;

/// Those between low and high, and the next one on either side.
BandPoints visibleOf(const std::vector<BandPoint> &points, double low, double high)
{
    const auto inside = std::lower_bound(points.begin(), points.end(), low,
                                         [](const BandPoint &point, double x) { return point.x < x; });
    const auto beyond = std::upper_bound(points.begin(), points.end(), high,
                                         [](double x, const BandPoint &point) { return x < point.x; });
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
