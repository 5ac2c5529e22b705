// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/trend_chart.h"

#include "ui/models/figure_text.h"
#include "ui/views/axis_ticks.h"
#include "ui/views/theme.h"

#include <QDateTime>
#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace odo {
namespace {

double msOf(Instant instant)
{
    return static_cast<double>(instant.time_since_epoch().count());
}

} // namespace

TrendChart::TrendChart(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Progress of the team"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void TrendChart::setTeam(const TeamStanding *team, const QString &name, const QString &progress)
{
    m_team = team ? *team : TeamStanding();
    setAccessibleDescription(
        team ? tr("%1: %2 trials, progress: %3").arg(name).arg(team->runs.size()).arg(progress)
             : tr("No team is selected"));
    if (!m_team.runs.empty()) {
        m_firstMs = msOf(m_team.runs.front().date);
        m_lastMs = std::max(msOf(m_team.runs.back().date), m_firstMs + 1);
        const auto [low, high] = std::ranges::minmax(m_team.figures.values);
        const double spread = m_team.progress.spread.value_or(0);
        const AxisTicks ticks = coveringTicks(low - spread, high + spread, 4);
        m_low = ticks.first;
        m_high = ticks.last();
        const std::string &unit = m_team.runs.front().metric.unit;
        m_unit = unit == "1" ? QString() : QString::fromStdString(unit);
    }
    update();
}

QPointF TrendChart::place(const QRectF &plot, double ms, double value) const
{
    return {plot.left() + (ms - m_firstMs) / (m_lastMs - m_firstMs) * plot.width(),
            plot.bottom() - (value - m_low) / (m_high - m_low) * plot.height()};
}

void TrendChart::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    const QFontMetricsF metrics(font());
    if (m_team.runs.empty()) {
        painter.setPen(colours.muted);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Select a team to see its trials through the term."));
        return;
    }
    const QRectF plot = QRectF(rect()).adjusted(metrics.horizontalAdvance(QStringLiteral("00000.00")) + 14,
                                                metrics.height() + 8, -16, -metrics.height() - 10);
    drawAxes(painter, plot);
    drawProgress(painter, plot);
}

void TrendChart::drawAxes(QPainter &painter, const QRectF &plot) const
{
    const ThemeColours colours = ThemeColours::of(palette());
    const AxisTicks ticks = coveringTicks(m_low, m_high, 4);
    const double line = QFontMetricsF(font()).height();
    for (const double value : ticks.values()) {
        const double y = place(plot, m_firstMs, value).y();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(colours.muted);
        painter.drawText(QRectF(0, y - line / 2, plot.left() - 6, line), Qt::AlignRight | Qt::AlignVCenter,
                         ticks.label(value));
    }
    const auto date = [](double ms) {
        return QLocale().toString(QDateTime::fromMSecsSinceEpoch(qint64(ms)).date(), QLocale::ShortFormat);
    };
    painter.setPen(colours.muted);
    const QRectF below(plot.left(), plot.bottom() + 4, plot.width(), line);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, date(m_firstMs));
    if (date(m_lastMs) != date(m_firstMs))
        painter.drawText(below, Qt::AlignRight | Qt::AlignTop, date(m_lastMs));
    const QString name = metricName(m_team.runs.front().metric.name);
    painter.setPen(colours.text);
    painter.drawText(QRectF(8, 2, width() - 16, line), Qt::AlignLeft | Qt::AlignVCenter,
                     m_unit.isEmpty() ? name : tr("%1 in %2").arg(name, m_unit));
}

void TrendChart::drawProgress(QPainter &painter, const QRectF &plot) const
{
    const ThemeColours colours = ThemeColours::of(palette());
    const double from = m_team.progress.change ? m_team.progress.atStart : m_team.progress.median;
    const double to = from + (m_team.progress.change ? m_team.progress.change->value : 0);
    if (const auto spread = m_team.progress.spread) {
        QColor band = colours.accent;
        band.setAlphaF(0.15F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(band);
        painter.drawPolygon(
            QPolygonF({place(plot, m_firstMs, from - *spread), place(plot, m_firstMs, from + *spread),
                       place(plot, m_lastMs, to + *spread), place(plot, m_lastMs, to - *spread)}));
    }
    // A line that the spread explains is dashed: it may be none.
    painter.setPen(QPen(colours.accent, 2, m_team.progress.isBeyondSpread ? Qt::SolidLine : Qt::DashLine));
    painter.drawLine(place(plot, m_firstMs, from), place(plot, m_lastMs, to));
    constexpr double radius = 3.5;
    painter.setPen(QPen(colours.card, 1));
    painter.setBrush(colours.text);
    for (const TeamRun &run : m_team.runs)
        painter.drawEllipse(place(plot, msOf(run.date), run.metric.value), radius, radius);
}

} // namespace odo
