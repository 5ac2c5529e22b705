// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/trend_painting.h"

#include "ui/models/figure_text.h"
#include "ui/views/charts/chart_painting.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace odo {

namespace {

class TrendPaintingWords
{
    Q_DECLARE_TR_FUNCTIONS(TrendPainting)
};

double msOf(Instant instant)
{
    return static_cast<double>(instant.time_since_epoch().count());
}

struct TrendPlot
{
    QRectF rect;
    double firstMs = 0, lastMs = 1;
    AxisTicks values;

    QPointF at(double ms, double value) const
    {
        return {rect.left() + (ms - firstMs) / (lastMs - firstMs) * rect.width(),
                rect.bottom() - (value - values.first) / (values.last() - values.first) * rect.height()};
    }
};

TrendPlot plotOf(const QRectF &rect, const TeamStanding &team)
{
    const double firstMs = msOf(team.runs.front().date);
    const auto [low, high] = std::ranges::minmax(team.figures.values);
    const double spread = team.progress.spread.value_or(0);
    return {rect, firstMs, std::max(msOf(team.runs.back().date), firstMs + 1),
            coveringTicks(low - spread, high + spread, 4)};
}

void drawAxes(QPainter &painter, const TrendPlot &plot, const QString &name, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const double line = QFontMetricsF(painter.font()).height();
    const double left = QFontMetricsF(painter.font()).horizontalAdvance(QStringLiteral("00000.00")) + 14;
    for (const double value : plot.values.values()) {
        const double y = plot.at(plot.firstMs, value).y();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(plot.rect.left(), y), QPointF(plot.rect.right(), y));
        painter.setPen(colours.muted);
        painter.drawText(QRectF(plot.rect.left() - left, y - line / 2, left - 6, line),
                         Qt::AlignRight | Qt::AlignVCenter, plot.values.label(value));
    }
    const auto date = [](double ms) {
        return QLocale().toString(QDateTime::fromMSecsSinceEpoch(qint64(ms)).date(), QLocale::ShortFormat);
    };
    painter.setPen(colours.muted);
    const QRectF below(plot.rect.left(), plot.rect.bottom() + 4, plot.rect.width(), line);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, date(plot.firstMs));
    if (date(plot.lastMs) != date(plot.firstMs))
        painter.drawText(below, Qt::AlignRight | Qt::AlignTop, date(plot.lastMs));
    painter.setPen(colours.text);
    painter.drawText(QRectF(plot.rect.left() - left + 8, plot.rect.top() - line - 6, plot.rect.width(), line),
                     Qt::AlignLeft | Qt::AlignVCenter, name);
}

void drawProgress(QPainter &painter, const TrendPlot &plot, const TeamStanding &team, const QPalette &palette)
{
    const ThemeColours colours = ThemeColours::of(palette);
    const double from = team.progress.change ? team.progress.atStart : team.progress.median;
    const double to = from + (team.progress.change ? team.progress.change->value : 0);
    if (const auto spread = team.progress.spread) {
        QColor band = colours.accent;
        band.setAlphaF(0.15F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(band);
        painter.drawPolygon(
            QPolygonF({plot.at(plot.firstMs, from - *spread), plot.at(plot.firstMs, from + *spread),
                       plot.at(plot.lastMs, to + *spread), plot.at(plot.lastMs, to - *spread)}));
    }
    painter.setPen(QPen(colours.accent, 2, team.progress.isBeyondSpread ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(plot.at(plot.firstMs, from), plot.at(plot.lastMs, to));
    constexpr double radius = 3.5;
    painter.setPen(QPen(colours.card, 1));
    painter.setBrush(colours.text);
    for (const TeamRun &run : team.runs)
        painter.drawEllipse(plot.at(msOf(run.date), run.metric.value), radius, radius);
}

} // namespace

void drawTrend(QPainter &painter, const QRectF &rect, const TeamStanding &team, const QPalette &palette)
{
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetricsF metrics(painter.font());
    const TrendPlot plot = plotOf(rect.adjusted(metrics.horizontalAdvance(QStringLiteral("00000.00")) + 14,
                                                metrics.height() + 8, -16, -metrics.height() - 10),
                                  team);
    const Metric &metric = team.runs.front().metric;
    const QString name = metricName(metric.name);
    drawAxes(painter, plot,
             metric.unit == "1"
                 ? name
                 : TrendPaintingWords::tr("%1 in %2").arg(name, QString::fromStdString(metric.unit)),
             palette);
    drawProgress(painter, plot, team, palette);
}

} // namespace odo
