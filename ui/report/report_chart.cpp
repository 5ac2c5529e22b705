// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_chart.h"

#include "ui/report/report_painting.h"
#include "ui/views/curve_painting.h"
#include "ui/views/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <limits>

namespace odo {

namespace {

constexpr double printFineness = 6; // columns to 1/96 inch

class ReportChartWords
{
    Q_DECLARE_TR_FUNCTIONS(ReportChart)
};

QString titleOf(Quantity quantity)
{
    return quantity == Quantity::Speed
               ? ReportChartWords::tr("Speed, %1").arg(curveUnit(quantity))
               : ReportChartWords::tr("Acceleration along the path, %1").arg(curveUnit(quantity));
}

/// Slanted lines over the time of the spikes: they survive a copier.
void drawHatch(QPainter &painter, const ChartPlot &plot, double from, double to)
{
    constexpr double least = 5, apart = 4;
    const double middle = (plot.at(from, 0).x() + plot.at(to, 0).x()) / 2;
    const double half = std::max(least, plot.at(to, 0).x() - plot.at(from, 0).x()) / 2;
    const QRectF box = QRectF(middle - half, plot.rect.top(), 2 * half, plot.rect.height()).intersected(plot.rect);
    painter.save();
    painter.setClipRect(box);
    painter.setPen(QPen(ThemeColours::of(reportPalette()).spike, 0.6));
    for (double y = box.top() - box.width(); y < box.bottom() + box.width(); y += apart)
        painter.drawLine(QPointF(box.left(), y + box.width()), QPointF(box.right(), y));
    painter.restore();
}

void drawEvents(QPainter &painter, const ChartPlot &plot, const std::vector<RunEvent> &events)
{
    double last = -std::numeric_limits<double>::infinity();
    for (const RunEvent &event : events) {
        const double x = plot.at(toSeconds(event.time), 0).x();
        if (event.kind != RunEvent::Kind::Spike) {
            painter.setPen(QPen(ThemeColours::of(reportPalette()).muted, 0.8, Qt::DotLine));
            painter.drawLine(QPointF(x, plot.rect.top()), QPointF(x, plot.rect.bottom()));
        }
        // Numbers that are close to one another stand side by side.
        last = std::max(x, last + 2 * eventNumberRadius + 1);
        drawEventNumber(painter, QPointF(last, plot.rect.top() - eventNumberRadius - 1), event);
    }
}

} // namespace

void drawEventNumber(QPainter &painter, const QPointF &centre, const RunEvent &event)
{
    const ThemeColours colours = ThemeColours::of(reportPalette());
    const bool isSpike = event.kind == RunEvent::Kind::Spike;
    const QRectF box(centre.x() - eventNumberRadius, centre.y() - eventNumberRadius, 2 * eventNumberRadius,
                     2 * eventNumberRadius);
    painter.setPen(QPen(colours.card, 1));
    painter.setBrush(isSpike ? colours.spike : colours.text);
    if (isSpike)
        painter.drawRect(box);
    else
        painter.drawEllipse(box);
    painter.setFont(reportFont(smallSize - 1, QFont::DemiBold));
    painter.setPen(colours.card);
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, QString::number(event.number));
}

void drawRunChart(QPainter &painter, const QRectF &rect, const Profile &profile, Quantity quantity,
                  const std::vector<RunEvent> &events)
{
    const QPalette &palette = reportPalette();
    const ThemeColours colours = ThemeColours::of(palette);
    const QRectF room =
        drawPartTitle(painter, rect, titleOf(quantity),
                      ReportChartWords::tr("smoothed, with its ±95 % band; dots: as measured"));
    const std::vector<double> times = sampleTimes(profile);
    std::vector<CurveRun> runs = curveRuns(curveValues(profile, quantity), times);
    std::erase_if(runs, [](const CurveRun &run) { return !run.isLine(); });
    if (runs.empty()) {
        drawLine(painter, room, ReportChartWords::tr("No curve: the robot was not seen"),
                 reportFont(bodySize), colours.muted, Qt::AlignCenter);
        return;
    }
    std::vector<const CurveRun *> shown;
    for (const CurveRun &run : runs)
        shown.push_back(&run);
    const ValueRange range = valueRange(shown, quantity);
    painter.save();
    painter.translate(rect.left(), room.top());
    ChartPlot plot{ChartPlot::rectIn(QRectF(0, 0, room.width(), room.height())).adjusted(0, 6, 0, 0),
                   times.front(), std::max(times.back(), times.front() + 1e-3), {}, printFineness};
    plot.values = coveringTicks(range.low, range.high, std::max(2, int(plot.rect.height() / 20)));
    const QFont font = reportFont(smallSize);
    painter.setFont(font);
    drawChartAxes(painter, plot, {QStringLiteral("s"), 1}, font, palette);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const RunEvent &event : events)
        if (event.kind == RunEvent::Kind::Spike)
            drawHatch(painter, plot, toSeconds(event.time), toSeconds(event.until));
    drawCurvePoints(painter, plot, measuredPoints(profile, quantity, times), colours.point);
    for (const CurveRun &run : runs)
        drawCurveRun(painter, plot, run, {seriesColour(0, palette), Qt::SolidLine});
    painter.setRenderHint(QPainter::Antialiasing);
    drawChartSpikes(painter, plot, spikePoints(profile, quantity, times), palette);
    drawEvents(painter, plot, events);
    painter.restore();
}

} // namespace odo
