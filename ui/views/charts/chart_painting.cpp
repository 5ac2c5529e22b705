// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_painting.h"

#include "ui/views/charts/chart_picture.h"
#include "ui/views/widgets/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

double niceStep(double range, int most)
{
    const double rough = range / std::max(1, most);
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (rough <= factor * power * (1 + 1e-9))
            return factor * power;
    }
    return 10 * power;
}

AxisTicks ticksBetween(double firstIndex, double lastIndex, double step)
{
    AxisTicks ticks;
    ticks.step = step;
    ticks.first = firstIndex * step;
    ticks.count = std::max(0, static_cast<int>(lastIndex - firstIndex) + 1);
    ticks.decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    return ticks;
}

/// A range that a step can be computed of.
bool isUsable(double low, double high)
{
    return std::isfinite(low) && std::isfinite(high) && high > low;
}

} // namespace

std::vector<double> AxisTicks::values() const
{
    std::vector<double> all;
    for (int i = 0; i < count; ++i)
        all.push_back(first + i * step);
    return all;
}

QString AxisTicks::label(double value, const QLocale &locale) const
{
    QLocale plain = locale;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(std::abs(value) < step * 1e-6 ? 0.0 : value, 'f', decimals);
}

AxisTicks niceTicks(double low, double high, int most)
{
    if (!isUsable(low, high))
        return {};
    const double step = niceStep(high - low, most), slack = 1e-9;
    return ticksBetween(std::ceil(low / step - slack), std::floor(high / step + slack), step);
}

AxisTicks coveringTicks(double low, double high, int most)
{
    if (!isUsable(low, high)) {
        const double centre = std::isfinite(low) ? low : 0;
        low = centre - 0.5;
        high = centre + 0.5;
    }
    const double step = niceStep(high - low, most), slack = 1e-9;
    return ticksBetween(std::floor(low / step + slack), std::ceil(high / step - slack), step);
}

QPointF ChartPlot::at(double x, double value) const
{
    return {rect.left() + (x - low) / (high - low) * rect.width(),
            rect.bottom() - (value - values.first) / (values.last() - values.first) * rect.height()};
}

double ChartPlot::xAt(double screenX) const
{
    const double part = std::clamp((screenX - rect.left()) / std::max(1.0, rect.width()), 0.0, 1.0);
    return low + part * (high - low);
}

void drawChartAxes(QPainter &painter, const ChartPlot &plot, const ShownUnit &below, const QFont &font,
                   const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const QFontMetricsF metrics(font);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const double value : plot.values.values()) {
        const double y = plot.at(plot.low, value).y();
        painter.setPen(QPen(colours.grid, 1));
        painter.drawLine(QPointF(plot.rect.left(), y), QPointF(plot.rect.right(), y));
        painter.setPen(colours.muted);
        painter.drawText(QRectF(0, y - metrics.height() / 2, ChartPlot::leftMargin - 8, metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter, plot.values.label(value));
    }
    const double labelWidth = metrics.horizontalAdvance(QStringLiteral("0000 ") + below.name);
    const AxisTicks ticks = niceTicks(below.perSi * plot.low, below.perSi * plot.high,
                                      std::max(2, int(plot.rect.width() / (1.6 * labelWidth))));
    for (const double value : ticks.values()) {
        const QString label = ticks.label(value) + u' ' + below.name;
        const double last = plot.rect.right() + ChartPlot::rightMargin - metrics.horizontalAdvance(label) / 2;
        const double x = std::min(plot.at(value / below.perSi, 0).x(), last); // at the end it is not cut
        painter.drawText(QRectF(x - labelWidth, plot.rect.bottom() + 5, 2 * labelWidth, metrics.height()),
                         Qt::AlignHCenter, label);
    }
}

void drawChartCursor(QPainter &painter, const ChartPlot &plot, double x, const QPalette &palette)
{
    const double screenX = plot.at(x, 0).x();
    painter.setPen(QPen(ThemeColours::of(palette).text, 1.4, Qt::DotLine));
    painter.drawLine(QPointF(screenX, plot.rect.top()), QPointF(screenX, plot.rect.bottom()));
}

void drawChartRange(QPainter &painter, const ChartPlot &plot, double from, double to, const QPalette &palette)
{
    const double left = plot.at(from, 0).x(), right = plot.at(to, 0).x();
    const QColor accent = ThemeColours::of(palette).accent;
    QColor haze = accent;
    haze.setAlpha(34);
    painter.fillRect(
        QRectF(QPointF(left, plot.rect.top()), QPointF(right, plot.rect.bottom())).intersected(plot.rect),
        haze);
    painter.setPen(QPen(accent, 1));
    for (const double x : {left, right})
        if (x >= plot.rect.left() && x <= plot.rect.right())
            painter.drawLine(QPointF(x, plot.rect.top()), QPointF(x, plot.rect.bottom()));
}

void drawChartDoubt(QPainter &painter, const ChartPlot &plot, double from, double to, bool isHatched,
                    const QPalette &palette)
{
    constexpr double leastWidth = 2;
    const double left = plot.at(from, 0).x(), right = std::max(plot.at(to, 0).x(), left + leastWidth);
    QColor shade = isHatched ? ThemeColours::of(palette).spike : ThemeColours::of(palette).muted;
    shade.setAlpha(isHatched ? 90 : 48);
    painter.fillRect(
        QRectF(QPointF(left, plot.rect.top()), QPointF(right, plot.rect.bottom())).intersected(plot.rect),
        QBrush(shade, isHatched ? Qt::BDiagPattern : Qt::SolidPattern));
}

void drawChartSpikes(QPainter &painter, const ChartPlot &plot, const QList<QPointF> &spikes,
                     const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    painter.setPen(QPen(colours.card, 1));
    painter.setBrush(colours.spike);
    for (const QPointF &spike : spikes) {
        if (spike.x() < plot.low || spike.x() > plot.high)
            continue;
        const QPointF at = plot.at(spike.x(), std::clamp(spike.y(), plot.values.first, plot.values.last()));
        const QPointF triangle[] = {at + QPointF(-5.5, 5), at + QPointF(5.5, 5), at + QPointF(0, -6)};
        painter.drawConvexPolygon(triangle, 3);
    }
}

void drawChartFit(QPainter &painter, const ChartPlot &plot, const QList<QPointF> &values,
                  const QPalette &palette)
{
    QPolygonF line;
    for (const QPointF &value : values)
        line << plot.at(value.x(), value.y());
    painter.save();
    painter.setClipRect(plot.rect);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ThemeColours::of(palette).card, 5)); // a rim, so that it stands out from the curve
    painter.drawPolyline(line);
    painter.setPen(QPen(ThemeColours::of(palette).text, 2, Qt::DashLine));
    painter.drawPolyline(line);
    painter.restore();
}

void drawChartFocus(QPainter &painter, const QWidget &plot)
{
    if (!plot.hasFocus() || ChartPicture::isPaintedBy(painter, plot))
        return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(ThemeColours::of(plot.palette()).accent, 1));
    painter.drawRect(plot.rect().adjusted(0, 0, -1, -1));
}

QRectF drawChartBubble(QPainter &painter, const ChartPlot &plot, const QPointF &value, double top,
                       const QString &fullText, const QColor &colour, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const QFontMetricsF metrics(painter.font());
    // The value stands at its end; a long name before it gives way.
    const QString text = metrics.elidedText(fullText, Qt::ElideLeft, plot.rect.width() / 2);
    const QPointF at = plot.at(value.x(), value.y());
    const double height = metrics.height() + 6, width = metrics.horizontalAdvance(text) + 14;
    const bool fits = at.x() + 6 + width <= plot.rect.right();
    const QRectF bubble(fits ? at.x() + 6 : at.x() - 6 - width, top, width, height);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.bubble);
    painter.drawRoundedRect(bubble, 3, 3);
    painter.setPen(colours.bubbleText);
    painter.drawText(bubble, Qt::AlignCenter, text);
    painter.setPen(QPen(colours.card, 1.5));
    painter.setBrush(colour);
    painter.drawEllipse(at, 4, 4);
    return bubble;
}

} // namespace odo
