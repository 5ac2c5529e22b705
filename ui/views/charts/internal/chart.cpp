// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/internal/chart.h"

#include "ui/views/charts/internal/chart_series.h"
#include "ui/views/widgets/theme.h"

#include <QAreaSeries>
#include <QDateTime>
#include <QDateTimeAxis>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QGraphicsSimpleTextItem>
#include <QLegend>
#include <QLineSeries>
#include <QLocale>
#include <QValueAxis>
#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

constexpr double leftMargin = 48, titleWidth = 16, rightMargin = 22, dateMargin = 44, topMargin = 10,
                 bottomMargin = 28, stripScale = 16;
constexpr double tickApartPx = 23, stripTickApartPx = 30, leastStretchPx = 2;
constexpr double dayMs = 86'400e3;
constexpr qsizetype mostSmooth = 4500; // points: two charts of them take less than a frame

void setTicks(QValueAxis &axis, double low, double high, const AxisTicks &ticks, const QString &unit)
{
    // The axis remakes its marks at each step: never the marks of one range in another.
    constexpr double noMarks = 1e30;
    axis.setTickType(QValueAxis::TicksDynamic);
    axis.setTickAnchor(0);
    axis.setTickInterval(noMarks);
    axis.setLabelFormat(QStringLiteral("%.%1f").arg(ticks.decimals) +
                        (unit.isEmpty() ? QString() : u' ' + unit));
    axis.setRange(low, high);
    axis.setTickInterval(ticks.step);
}

/// How many marks divide so many days: whole days apart where that leaves enough of them.
int dateTicks(double days, int most)
{
    const int whole = std::max(1, int(std::lround(days)));
    most = std::clamp(most, 2, whole + 1);
    for (int count = most; 2 * count > most; --count)
        if (count >= 2 && whole % (count - 1) == 0)
            return count;
    return most;
}

} // namespace

Chart::Chart(const ChartAxes &axes) : m_axes(axes), m_words(new QGraphicsSimpleTextItem(this))
{
    setMinimumSize(1, 1);
    legend()->hide();
    setBackgroundVisible(false);
    setBackgroundRoundness(0);
    setDropShadowEnabled(false);
    setMargins(QMargins(0, 0, 0, 0));
    layout()->setContentsMargins(0, 0, 0, 0);
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    setLocale(locale);
    setLocalizeNumbers(true);
    m_words->setZValue(100);
    makeAxes();
    remake();
}

Chart::~Chart() = default;

void Chart::makeAxes()
{
    for (QAbstractAxis *axis : std::initializer_list<QAbstractAxis *>{m_below, m_left})
        if (axis) {
            removeAxis(axis);
            delete axis;
        }
    const bool isStrip = m_axes.style == ChartStyle::Strip;
    if (m_axes.style == ChartStyle::Dates) {
        auto *date = new QDateTimeAxis;
        date->setFormat(QLocale().dateFormat(QLocale::ShortFormat));
        m_below = date;
    } else {
        m_below = new QValueAxis;
    }
    m_left = new QValueAxis;
    addAxis(m_below, isStrip ? Qt::AlignTop : Qt::AlignBottom);
    addAxis(m_left, Qt::AlignLeft);
    m_below->setGridLineVisible(isStrip);
    m_below->setLabelsVisible(m_axes.style != ChartStyle::Bars);
    m_left->setVisible(!isStrip);
    m_below->setLineVisible(false);
    m_left->setLineVisible(false);
    m_below->setTruncateLabels(false);
    m_left->setTruncateLabels(false);
    m_left->setTitleText(m_axes.left);
}

void Chart::setAxes(const ChartAxes &axes)
{
    if (axes.style == m_axes.style && axes.left == m_axes.left && axes.below.name == m_axes.below.name &&
        axes.below.perSi == m_axes.below.perSi)
        return;
    m_axes = axes;
    makeAxes();
    remake();
    setSize(size());
}

void Chart::setContent(ChartContentPtr content, std::vector<ChartStretch> stretches)
{
    m_content = std::move(content);
    m_stretches = std::move(stretches);
    remake();
}

bool Chart::setOverlay(std::vector<ChartCurve> curves)
{
    if (curves.empty() && m_overlay.empty())
        return false;
    m_series.resize(m_series.size() - m_overlay.size());
    m_overlay = std::move(curves);
    add(m_overlay);
    searchAgain();
    invalidate();
    return true;
}

/// Rebuilds all series, in the order in which they overlap.
void Chart::remake()
{
    m_series.clear();
    removeAllSeries();
    m_shade = newArea(*this);
    m_hatch = newArea(*this);
    for (QAreaSeries *area : {m_shade, m_hatch}) {
        area->attachAxis(m_below);
        area->attachAxis(m_left);
    }
    if (m_content)
        add(m_content->curves);
    add(m_overlay);
    searchAgain();
    invalidate();
}

/// They have no look yet.
void Chart::add(const std::vector<ChartCurve> &curves)
{
    for (const ChartCurve &curve : curves) {
        m_series.push_back(std::make_unique<ChartSeries>(*this, curve));
        m_series.back()->attach(m_below, m_left);
        m_series.back()->setShown(isGroupShown(curve.group));
    }
}

void Chart::setStyle(const QPalette &palette, const QFont &font)
{
    m_palette = palette;
    m_font = font;
    searchAgain();
    invalidate();
}

void Chart::searchAgain()
{
    const ThemeColours colours = ThemeColours::of(m_palette);
    for (QAbstractAxis *axis : std::initializer_list<QAbstractAxis *>{m_below, m_left}) {
        axis->setLabelsFont(m_font);
        axis->setLabelsBrush(colours.muted);
        axis->setTitleFont(m_font);
        axis->setTitleBrush(colours.muted);
        axis->setGridLinePen(QPen(colours.grid, 1));
        axis->setLinePen(QPen(colours.grid, 1));
    }
    QColor shade = colours.muted, hatch = colours.spike;
    shade.setAlpha(48);
    hatch.setAlpha(90);
    m_shade->setBrush(shade);
    m_hatch->setBrush(QBrush(hatch, Qt::BDiagPattern));
    for (const auto &series : m_series)
        series->setPalette(m_palette);
    m_words->setFont(m_font);
    m_words->setBrush(colours.muted);
}

void Chart::setGroupShown(int group, bool isShown)
{
    if (isShown)
        m_hidden.remove(group);
    else
        m_hidden.insert(group);
    showGroups();
}

void Chart::showAllGroups()
{
    m_hidden.clear();
    showGroups();
}

void Chart::showGroups()
{
    for (const auto &series : m_series)
        series->setShown(isGroupShown(series->curve().group));
    invalidate();
}

void Chart::setFineness(double fineness)
{
    m_fineness = fineness;
}

void Chart::setSize(const QSizeF &size)
{
    resize(size);
    const bool isStrip = m_axes.style == ChartStyle::Strip;
    const double left = isStrip ? 0 : leftMargin + (m_axes.left.isEmpty() ? 0 : titleWidth),
                 right = isStrip                             ? 0
                         : m_axes.style == ChartStyle::Dates ? dateMargin
                                                             : rightMargin,
                 top = isStrip ? stripScale : topMargin, bottom = isStrip ? 0 : bottomMargin;
    setPlotArea(QRectF(left, top, std::max(1.0, size.width() - left - right),
                       std::max(1.0, size.height() - top - bottom)));
    invalidate();
}

void Chart::show(double low, double high, std::optional<ValueRange> chosen)
{
    m_low = low;
    m_high = high;
    m_chosen = chosen;
    invalidate();
}

ChartPlot Chart::chartPlot() const
{
    return {plotArea(), m_low, m_high, m_values};
}

bool Chart::hasCurves() const
{
    return m_content && std::ranges::any_of(m_content->curves, [](const ChartCurve &curve) {
               return curve.kind == ChartCurve::Kind::Line;
           });
}

void Chart::setAxisRanges()
{
    setTicks(*m_left, m_values.low, m_values.high, m_ticks, {});
    const QFontMetricsF metrics(m_font);
    const double perSi = m_axes.below.perSi;
    if (auto *date = qobject_cast<QDateTimeAxis *>(m_below)) {
        date->setRange(QDateTime::fromMSecsSinceEpoch(qint64(m_low)),
                       QDateTime::fromMSecsSinceEpoch(qint64(m_high)));
        const double width =
            1.6 * metrics.horizontalAdvance(QLocale().toString(QDate(2000, 12, 28), QLocale::ShortFormat));
        date->setTickCount(dateTicks((m_high - m_low) / dayMs, int(plotArea().width() / width)));
        return;
    }
    auto *axis = static_cast<QValueAxis *>(m_below);
    const bool isStrip = m_axes.style == ChartStyle::Strip;
    const double apart = isStrip
                             ? stripTickApartPx
                             : 1.6 * metrics.horizontalAdvance(QStringLiteral("0000 ") + m_axes.below.name);
    const AxisTicks below =
        niceTicks(perSi * m_low, perSi * m_high, std::max(2, int(plotArea().width() / apart)));
    setTicks(*axis, perSi * m_low, perSi * m_high, below, m_axes.below.name);
}

void Chart::showStretches()
{
    const ChartPlot plot = chartPlot();
    for (QAreaSeries *area : {m_shade, m_hatch}) {
        QList<QPointF> upper, lower;
        for (const ChartStretch &stretch : m_stretches) {
            if (stretch.isHatched != (area == m_hatch) || stretch.from > m_high || stretch.to < m_low)
                continue;
            const double least = leastStretchPx * (m_high - m_low) / std::max(1.0, plot.rect.width());
            const double from = m_axes.below.perSi * stretch.from,
                         to = m_axes.below.perSi * std::max(stretch.to, stretch.from + least);
            for (const double x : {from, from, to, to})
                lower.append({x, m_values.low});
            upper << QPointF(from, m_values.low) << QPointF(from, m_values.high) << QPointF(to, m_values.high)
                  << QPointF(to, m_values.low);
        }
        setEdges(*area, upper, lower);
    }
}

void Chart::invalidate()
{
    const int most = std::max(2, int(plotArea().height() / tickApartPx));
    const ValueRange all = m_content ? m_content->range : ValueRange();
    m_ticks =
        m_chosen ? niceTicks(m_chosen->low, m_chosen->high, most) : coveringTicks(all.low, all.high, most);
    m_values = m_chosen.value_or(ValueRange{m_ticks.first, m_ticks.last()});
    m_isStale = true;
}

void Chart::prepare()
{
    if (!std::exchange(m_isStale, false))
        return;
    // Emptied first: full series would be arranged again for each axis that changes.
    for (const auto &series : m_series)
        series->clear();
    for (QAreaSeries *area : {m_shade, m_hatch})
        setEdges(*area, {}, {});
    setAxisRanges();
    showStretches();
    const ChartColumns columns{chartPlot(), m_axes.below.perSi, m_fineness};
    qsizetype strokes = 0;
    for (const auto &series : m_series)
        strokes += series->show(columns);
    m_isCoarse = m_fineness <= 1 && strokes > mostSmooth;
    for (const auto &series : m_series)
        series->setCoarse(m_isCoarse);
    m_words->setText(m_content && !hasCurves() ? m_content->emptyWords : QString());
    m_words->setPos(plotArea().center() - m_words->boundingRect().center());
    layout()->activate();
}

} // namespace odo
