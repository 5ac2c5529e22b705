// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/internal/chart_series.h"

#include "ui/views/widgets/theme.h"

#include <QAreaSeries>
#include <QChart>
#include <QLineSeries>
#include <QScatterSeries>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int bandAlpha = 60;
constexpr double spikePx = 12; // of a triangle

/// Dots are not cut off at the edge of the plot, as lines are: those beyond it must be left out.
bool holds(const ValueRange &values, double value)
{
    return value >= values.low && value <= values.high;
}

QColor inkColour(ChartInk ink, int position, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    switch (ink) {
    case ChartInk::Muted:
        return colours.muted;
    case ChartInk::Point:
        return colours.point;
    case ChartInk::Text:
        return colours.text;
    case ChartInk::Accent:
        return colours.accent;
    case ChartInk::Spike:
        return colours.spike;
    case ChartInk::Ground:
        return colours.card;
    case ChartInk::Series:
        break;
    }
    return seriesColour(position, palette);
}

} // namespace

int ChartColumns::count() const
{
    return std::max(1, int(std::ceil(plot.rect.width() * fineness)));
}

double ChartColumns::middleOf(int column) const
{
    return perSi * (plot.low + (column + 0.5) * (plot.high - plot.low) / count());
}

bool ChartColumns::areAlike(double low, double high) const
{
    constexpr double alikePx = 0.7;
    return (high - low) * plot.rect.height() < alikePx * (plot.values.high - plot.values.low);
}

ChartSeries::ChartSeries(QChart &chart, const ChartCurve &curve) : m_chart(chart), m_curve(&curve)
{
    if (curve.kind == ChartCurve::Kind::Spikes) {
        m_spikes = new QScatterSeries;
        m_spikes->setMarkerShape(QScatterSeries::MarkerShapeTriangle);
        m_spikes->setMarkerSize(spikePx);
        m_chart.addSeries(m_spikes);
        return;
    }
    if (curve.hasBand || curve.kind == ChartCurve::Kind::Bars)
        m_band = newArea(chart);
    line(0);
}

ChartSeries::~ChartSeries()
{
    for (QAbstractSeries *series : all()) {
        m_chart.removeSeries(series);
        delete series;
    }
}

QList<QAbstractSeries *> ChartSeries::all() const
{
    QList<QAbstractSeries *> series;
    for (QAbstractSeries *one : std::initializer_list<QAbstractSeries *>{m_band, m_spikes})
        if (one)
            series << one;
    for (QLineSeries *one : m_lines)
        series << one;
    return series;
}

QLineSeries *ChartSeries::line(qsizetype index)
{
    while (m_lines.size() <= index) {
        auto *added = new QLineSeries;
        m_chart.addSeries(added);
        if (m_below) {
            added->attachAxis(m_below);
            added->attachAxis(m_left);
        }
        added->setVisible(m_isShown);
        m_lines << added;
        setPen(*added);
    }
    return m_lines[index];
}

void ChartSeries::attach(QAbstractAxis *below, QAbstractAxis *left)
{
    m_below = below;
    m_left = left;
    for (QAbstractSeries *series : all()) {
        series->attachAxis(below);
        series->attachAxis(left);
    }
}

void ChartSeries::clear()
{
    if (m_band)
        setEdges(*m_band, {}, {});
    for (QLineSeries *series : m_lines)
        series->replace(QList<QPointF>());
    if (m_spikes)
        m_spikes->replace(QList<QPointF>());
}

qsizetype ChartSeries::show(const ChartColumns &columns)
{
    if (!m_isShown)
        return 0;
    if (m_spikes)
        return showSpikes(columns);
    if (m_curve->kind == ChartCurve::Kind::Bars)
        return showBars(columns);
    const std::size_t count = visibleCount(m_curve->runs, columns.plot.low, columns.plot.high);
    const bool isDense = count > static_cast<std::size_t>(columns.count());
    if (m_curve->kind == ChartCurve::Kind::Points)
        return isDense ? showDensePoints(columns) : showPoints(columns);
    return isDense ? showDenseLine(columns) : showLine(columns);
}

void ChartSeries::setCoarse(bool isCoarse)
{
    if (isCoarse == m_isCoarse)
        return;
    m_isCoarse = isCoarse;
    setPens();
}

/// From the lowest to the highest value of each column and on to the next: what the eye would see of a line
/// through all points, at two points a column, or one where they are within a pixel.
qsizetype ChartSeries::showDenseLine(const ChartColumns &columns)
{
    QList<QPointF> points;
    qsizetype used = 0, strokes = 0;
    const auto finish = [&] {
        strokes += points.size();
        if (!points.isEmpty())
            line(used++)->replace(std::exchange(points, {}));
    };
    const ChartPlot &plot = columns.plot;
    for (const CurveColumn &column : curveColumns(m_curve->runs, plot.low, plot.high, columns.count())) {
        if (!column.isJoined)
            finish();
        const double middle = (column.low + column.high) / 2;
        const bool isRising = points.isEmpty() || points.last().y() <= middle;
        if (columns.areAlike(column.low, column.high)) {
            points.append({columns.middleOf(column.index), middle});
        } else {
            points.append({columns.middleOf(column.index), isRising ? column.low : column.high});
            points.append({columns.middleOf(column.index), isRising ? column.high : column.low});
        }
    }
    finish();
    if (m_band)
        showDenseBand(columns);
    return strokes;
}

/// Both extremes of each column, which is half as wide as a dot.
qsizetype ChartSeries::showDensePoints(const ChartColumns &columns)
{
    constexpr int widthPx = 2;
    ChartColumns wide = columns;
    wide.fineness = columns.fineness / widthPx;
    const ChartPlot &plot = columns.plot;
    QList<QPointF> points;
    for (const CurveColumn &column :
         curveColumns(m_curve->runs, plot.low, plot.high, wide.count(), ColumnReach::Points)) {
        if (holds(plot.values, column.low))
            points.append({wide.middleOf(column.index), column.low});
        if (!columns.areAlike(column.low, column.high) && holds(plot.values, column.high))
            points.append({wide.middleOf(column.index), column.high});
    }
    m_lines.first()->replace(points);
    return points.size();
}

void ChartSeries::showDenseBand(const ChartColumns &columns)
{
    // Wider columns: an area with thousands of corners takes long to fill, and a haze hides its corners.
    constexpr int widthPx = 4;
    ChartColumns wide = columns;
    wide.fineness = columns.fineness / widthPx;
    ColumnOutline band(wide);
    for (const CurveColumn &column : curveColumns(m_curve->runs, wide.plot.low, wide.plot.high, wide.count()))
        band.add(column.index, column.isJoined, column.bandLow, column.bandHigh);
    band.setTo(*m_band);
}

qsizetype ChartSeries::showLine(const ChartColumns &columns)
{
    AreaOutline band(columns.plot.values);
    qsizetype used = 0, strokes = 0;
    for (const CurveRun &run : m_curve->runs) {
        const auto visible = visiblePoints(run.points, columns.plot.low, columns.plot.high);
        if (visible.size() < 2)
            continue;
        QList<QPointF> points;
        points.reserve(static_cast<qsizetype>(visible.size()));
        for (const BandPoint &point : visible) {
            const double x = point.x * columns.perSi;
            if (m_band && points.isEmpty())
                band.leap(x, point.low(), point.high());
            else if (m_band)
                band.add(x, point.low(), point.high());
            points.append({x, double(point.value)});
        }
        strokes += points.size();
        line(used++)->replace(points);
    }
    if (m_band)
        band.setTo(*m_band);
    return strokes;
}

qsizetype ChartSeries::showPoints(const ChartColumns &columns)
{
    QList<QPointF> points;
    for (const CurveRun &run : m_curve->runs)
        for (const BandPoint &point : visiblePoints(run.points, columns.plot.low, columns.plot.high))
            if (point.x >= columns.plot.low && point.x <= columns.plot.high &&
                holds(columns.plot.values, point.value))
                points.append({point.x * columns.perSi, double(point.value)});
    m_lines.first()->replace(points);
    return points.size();
}

qsizetype ChartSeries::showBars(const ChartColumns &columns)
{
    constexpr double halfWidth = 0.4;
    AreaOutline bars;
    qsizetype strokes = 0;
    for (const CurveRun &run : m_curve->runs)
        for (const BandPoint &point : run.points) {
            ++strokes;
            const double left = (point.x - halfWidth) * columns.perSi,
                         right = (point.x + halfWidth) * columns.perSi;
            bars.add(left, 0, 0);
            bars.add(left, 0, double(point.value));
            bars.add(right, 0, double(point.value));
            bars.add(right, 0, 0);
        }
    bars.setTo(*m_band);
    return strokes;
}

qsizetype ChartSeries::showSpikes(const ChartColumns &columns)
{
    const ChartPlot &plot = columns.plot;
    QList<QPointF> points;
    double last = 0; // of several in one column the first stands for all
    for (const CurveRun &run : m_curve->runs)
        for (const BandPoint &point : run.points) {
            const double screenX = plot.at(point.x, 0).x();
            if (point.x < plot.low || point.x > plot.high || (!points.isEmpty() && screenX - last < 1))
                continue;
            last = screenX;
            points.append({point.x * columns.perSi,
                           std::clamp(double(point.value), plot.values.low, plot.values.high)});
        }
    m_spikes->replace(points);
    return points.size();
}

void ChartSeries::setPalette(const QPalette &palette)
{
    m_colour = inkColour(m_curve->ink, m_curve->position, palette);
    m_rim = ThemeColours::of(palette).card;
    setPens();
}

void ChartSeries::setPens()
{
    QColor haze = m_colour;
    haze.setAlpha(bandAlpha);
    if (m_curve->kind == ChartCurve::Kind::Bars) {
        const bool isOutline = m_curve->fill == Qt::NoBrush;
        m_band->setBrush(isOutline ? QBrush(Qt::NoBrush) : QBrush(m_colour, m_curve->fill));
        m_band->setPen(m_curve->fill == Qt::SolidPattern
                           ? QPen(Qt::NoPen)
                           : QPen(m_colour, isOutline ? 2 : 1, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    } else if (m_band) {
        m_band->setBrush(haze);
    }
    for (QLineSeries *series : m_lines)
        setPen(*series);
    if (m_spikes) {
        m_spikes->setBrush(m_colour);
        m_spikes->setPen(QPen(m_rim, 1));
    }
}

void ChartSeries::setPen(QLineSeries &series) const
{
    const bool arePoints = m_curve->kind == ChartCurve::Kind::Points;
    series.setPen(arePoints ? QPen(m_colour, m_curve->widthPx, Qt::NoPen)
                            : QPen(m_colour, m_isCoarse ? 1 : m_curve->widthPx,
                                   m_isCoarse ? Qt::SolidLine : m_curve->dash, Qt::SquareCap, Qt::BevelJoin));
    series.setPointsVisible(arePoints);
}

void ChartSeries::setShown(bool isShown)
{
    m_isShown = isShown;
    for (QAbstractSeries *series : all())
        series->setVisible(isShown);
}

QAreaSeries *newArea(QChart &chart)
{
    auto *area = new QAreaSeries;
    area->setUpperSeries(new QLineSeries(area));
    area->setLowerSeries(new QLineSeries(area));
    chart.addSeries(area);
    area->setPen(Qt::NoPen);
    return area;
}

void setEdges(QAreaSeries &area, const QList<QPointF> &upper, const QList<QPointF> &lower)
{
    area.upperSeries()->replace(upper);
    area.lowerSeries()->replace(lower);
}

void AreaOutline::add(double x, double low, double high)
{
    m_upper.append({x, high});
    m_lower.append({x, low});
}

void AreaOutline::leap(double x, double low, double high)
{
    if (!m_upper.isEmpty()) {
        add(m_upper.last().x(), m_belowPlot, m_belowPlot);
        add(x, m_belowPlot, m_belowPlot);
    }
    add(x, low, high);
}

ColumnOutline::ColumnOutline(const ChartColumns &columns)
    : m_outline(columns.plot.values), m_low(columns.plot.low * columns.perSi),
      m_step((columns.plot.high - columns.plot.low) * columns.perSi / columns.count()),
      m_least((columns.plot.values.high - columns.plot.values.low) /
              std::max(1.0, columns.plot.rect.height()))
{
}

void ColumnOutline::add(int index, bool isJoined, double low, double high)
{
    if (high - low < m_least) {
        const double middle = (low + high) / 2;
        low = middle - m_least / 2;
        high = middle + m_least / 2;
    }
    const double left = m_low + index * m_step;
    if (!isJoined || m_isFirst) {
        close();
        m_outline.leap(left, low, high);
    }
    m_outline.add(left + m_step / 2, low, high);
    m_isFirst = false;
    m_right = left + m_step;
    m_lastLow = low;
    m_lastHigh = high;
}

void ColumnOutline::setTo(QAreaSeries &area)
{
    close();
    m_outline.setTo(area);
}

void ColumnOutline::close()
{
    if (!m_isFirst)
        m_outline.add(m_right, m_lastLow, m_lastHigh);
}

} // namespace odo
