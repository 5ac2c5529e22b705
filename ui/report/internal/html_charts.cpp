// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/quantity_curve.h"
#include "ui/report/internal/html_figures.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/charts/trial_curves.h"
#include "ui/views/curves/simplified_line.h"

#include <QCoreApplication>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr double chartWidth = 480, chartHeight = 230;
constexpr double leftMargin = 46, rightMargin = 10, topMargin = 16, bottomMargin = 34;
constexpr std::size_t mostPoints = 1500, mostSpikes = 300, mostLinePoints = 3000;
constexpr double finest = 0.15; // of a unit of the drawing

class HtmlChartWords
{
    Q_DECLARE_TR_FUNCTIONS(HtmlChart)
};

QString coordinate(double value)
{
    return QString::number(std::round(10 * value) / 10, 'g', 7);
}

QString pathThrough(const QPolygonF &line)
{
    QString path;
    for (const QPointF &point : line)
        path += (path.isEmpty() ? u'M' : u'L') + coordinate(point.x()) + u' ' + coordinate(point.y());
    return path;
}

/// How a curve is called in the style sheet.
QString inkOf(const ChartCurve &curve)
{
    constexpr int colours = 6;
    switch (curve.ink) {
    case ChartInk::Series:
        return QStringLiteral("s%1").arg(curve.position % colours);
    case ChartInk::Spike:
        return QStringLiteral("spike");
    case ChartInk::Muted:
    case ChartInk::Point:
        return QStringLiteral("faint");
    case ChartInk::Text:
    case ChartInk::Accent:
    case ChartInk::Ground:
        break;
    }
    return QStringLiteral("ink");
}

class SvgChart
{
public:
    SvgChart(HtmlWriter &page, const ChartDrawing &drawing)
        : m_page(page), m_drawing(drawing),
          m_values(coveringTicks(drawing.content->range.low, drawing.content->range.high, 6)),
          m_plot{QRectF(leftMargin, topMargin, chartWidth - leftMargin - rightMargin,
                        chartHeight - topMargin - bottomMargin),
                 drawing.low,
                 drawing.high,
                 {m_values.first, m_values.last()}}
    {
    }

    void write(const QString &title)
    {
        m_page.open("svg", {{"viewBox", QStringLiteral("0 0 %1 %2").arg(chartWidth).arg(chartHeight)},
                            {"role", QStringLiteral("img")},
                            {"aria-label", title}});
        for (const ChartStretch &stretch : m_drawing.stretches)
            writeStretch(stretch);
        writeGrid();
        for (const ChartCurve &curve : m_drawing.content->curves)
            if (curve.hasBand)
                writeBand(curve);
        for (const ChartCurve &curve : m_drawing.content->curves)
            writeCurve(curve);
        m_page.close();
    }

private:
    QPointF at(double x, double value) const
    {
        const QPointF point = m_plot.at(x, value);
        return {point.x(), std::clamp(point.y(), m_plot.rect.top() - 4, m_plot.rect.bottom() + 4)};
    }

    void writeStretch(const ChartStretch &stretch)
    {
        const double from = m_plot.at(stretch.from, 0).x(), to = m_plot.at(stretch.to, 0).x();
        m_page.shape("rect", {{"class", QStringLiteral("gap")},
                              {"x", coordinate(from)},
                              {"y", coordinate(topMargin)},
                              {"width", coordinate(std::max(1.0, to - from))},
                              {"height", coordinate(m_plot.rect.height())}});
    }

    void writeLabel(double x, double y, const QString &text, const char *anchor)
    {
        m_page.element("text", text,
                       {{"x", coordinate(x)}, {"y", coordinate(y)}, {"text-anchor", QLatin1String(anchor)}});
    }

    void writeGrid()
    {
        const QRectF &rect = m_plot.rect;
        QString lines;
        for (const double value : m_values.values()) {
            const double y = m_plot.at(0, value).y();
            lines += QStringLiteral("M%1 %2H%3")
                         .arg(coordinate(rect.left()), coordinate(y), coordinate(rect.right()));
            writeLabel(rect.left() - 5, y + 4, m_values.label(value), "end");
        }
        const double perSi = m_drawing.axes.below.perSi;
        const AxisTicks below = niceTicks(perSi * m_drawing.low, perSi * m_drawing.high, 7);
        for (const double value : below.values()) {
            const double x = m_plot.at(value / perSi, 0).x();
            lines += QStringLiteral("M%1 %2v4").arg(coordinate(x), coordinate(rect.bottom()));
            writeLabel(x, rect.bottom() + 17, below.label(value), "middle");
        }
        m_page.shape("path", {{"class", QStringLiteral("grid")}, {"d", lines}});
        writeLabel(rect.right(), rect.bottom() + 31, m_drawing.axes.below.name, "end");
    }

    /// Of a run of points, both edges of the band or the line itself; of a long one what each column holds.
    void writeBand(const ChartCurve &curve)
    {
        if (visibleCount(curve.runs, m_drawing.low, m_drawing.high) > mostLinePoints)
            return writeColumns(curve, true);
        QString path;
        for (const CurveRun &run : curve.runs) {
            QPolygonF upper, lower;
            for (const BandPoint &point : run.points) {
                upper << at(point.x, point.high());
                lower << at(point.x, point.low());
            }
            QPolygonF edge = simplified(upper, finest), back = simplified(lower, finest);
            std::reverse(back.begin(), back.end());
            if (edge.size() > 1)
                path += pathThrough(edge + back) + u'Z';
        }
        if (!path.isEmpty())
            m_page.shape("path", {{"class", QStringLiteral("band ") + inkOf(curve)}, {"d", path}});
    }

    void writeColumns(const ChartCurve &curve, bool isBand)
    {
        constexpr int columns = int(chartWidth - leftMargin - rightMargin);
        QString path;
        for (const CurveColumn &column : curveColumns(curve.runs, m_drawing.low, m_drawing.high, columns)) {
            const double x = leftMargin + column.index + 0.5;
            const double low = at(0, isBand ? column.bandLow : column.low).y(),
                         high = at(0, isBand ? column.bandHigh : column.high).y();
            path +=
                QStringLiteral("M%1 %2V%3").arg(coordinate(x), coordinate(low + 0.3), coordinate(high - 0.3));
        }
        m_page.shape("path", {{"class", (isBand ? QStringLiteral("columns ") : QStringLiteral("line ")) +
                                            inkOf(curve)},
                              {"d", path}});
    }

    void writeCurve(const ChartCurve &curve)
    {
        if (curve.kind == ChartCurve::Kind::Line)
            return writeLine(curve);
        const bool isSpike = curve.kind == ChartCurve::Kind::Spikes;
        QString path;
        std::size_t count = 0;
        for (const CurveRun &run : curve.runs)
            count += run.points.size();
        const std::size_t most = isSpike ? mostSpikes : mostPoints,
                          step = std::max<std::size_t>(1, (count + most - 1) / most);
        std::size_t number = 0;
        for (const CurveRun &run : curve.runs)
            for (const BandPoint &point : run.points) {
                if (number++ % step != 0)
                    continue;
                const QPointF centre = at(point.x, point.value);
                path += isSpike
                            ? QStringLiteral("M%1 %2l4 7h-8Z")
                                  .arg(coordinate(centre.x()), coordinate(centre.y() - 4))
                            : QStringLiteral("M%1 %2h0").arg(coordinate(centre.x()), coordinate(centre.y()));
            }
        if (!path.isEmpty())
            m_page.shape("path", {{"class", isSpike ? QStringLiteral("spikes") : QStringLiteral("dots")},
                                  {"d", path}});
    }

    void writeLine(const ChartCurve &curve)
    {
        if (visibleCount(curve.runs, m_drawing.low, m_drawing.high) > mostLinePoints)
            return writeColumns(curve, false);
        QString path;
        for (const CurveRun &run : curve.runs) {
            QPolygonF line;
            for (const BandPoint &point : run.points)
                line << at(point.x, point.value);
            if (line.size() > 1)
                path += pathThrough(simplified(line, finest));
        }
        if (path.isEmpty())
            return;
        HtmlAttributes attributes{{"class", QStringLiteral("line ") + inkOf(curve)}, {"d", path}};
        if (curve.dash != Qt::SolidLine)
            attributes << std::pair("stroke-dasharray", curve.dash == Qt::DotLine ? QStringLiteral("2 3")
                                                                                  : QStringLiteral("6 4"));
        m_page.shape("path", attributes);
    }

    HtmlWriter &m_page;
    const ChartDrawing &m_drawing;
    const AxisTicks m_values;
    const ChartPlot m_plot;
};

void writeRunChart(HtmlWriter &page, const Profile &profile, Quantity quantity, const QString &title)
{
    const std::vector<double> times = sampleTimes(profile);
    ProfileCurves curves = profileCurves(profile, quantity, times);
    std::erase_if(curves.line.runs, [](const CurveRun &run) { return !run.isLine(); });
    if (curves.line.runs.empty())
        return;
    auto content = std::make_shared<ChartContent>();
    content->curves = {std::move(curves.measured), std::move(curves.bridged), std::move(curves.line),
                       std::move(curves.spikes)};
    content->range = valueRange(content->curves, quantity);
    ChartDrawing drawing;
    drawing.content = std::move(content);
    drawing.low = times.front();
    drawing.high = std::max(times.back(), times.front() + 1e-3);
    for (const TimeSpan &gap : profile.gaps)
        drawing.stretches.push_back({toSeconds(gap.begin), toSeconds(gap.end)});
    writeChart(
        page, drawing, title,
        profile.gaps.empty()
            ? HtmlChartWords::tr("smoothed, with its ±95 % band; dots: as measured")
            : HtmlChartWords::tr("smoothed, with its ±95 % band; dots: as measured; shaded: not measured"));
}

} // namespace

void writeChart(HtmlWriter &page, const ChartDrawing &drawing, const QString &title, const QString &remark)
{
    page.open("figure");
    SvgChart(page, drawing).write(title);
    page.open("figcaption");
    page.element("strong", title);
    page.text(QStringLiteral(" – ") + remark);
    page.close();
    page.close();
}

void writeRunCharts(HtmlWriter &page, const Profile &profile)
{
    writeRunChart(page, profile, Quantity::Speed,
                  HtmlChartWords::tr("Speed, %1").arg(curveUnit(Quantity::Speed)));
    writeRunChart(
        page, profile, Quantity::Acceleration,
        HtmlChartWords::tr("Acceleration along the path, %1").arg(curveUnit(Quantity::Acceleration)));
}

} // namespace odo
