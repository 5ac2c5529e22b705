// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/chart_area.h"

#include "ui/models/figure_text.h"
#include "ui/models/timeline.h"
#include "ui/views/decimation.h"
#include "ui/views/theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QtCharts/QAreaSeries>
#include <QtCharts/QChart>
#include <QtCharts/QLineSeries>
#include <QtCharts/QScatterSeries>
#include <QtCharts/QValueAxis>
#include <algorithm>
#include <cmath>

namespace odo {

ChartArea::ChartArea(Timeline &timeline, Quantity quantity, QWidget *parent)
    : QChartView(parent), m_timeline(timeline), m_quantity(quantity), m_timeAxis(new QValueAxis(this)),
      m_valueAxis(new QValueAxis(this))
{
    setFrameShape(QFrame::NoFrame);
    setRenderHint(QPainter::Antialiasing);
    setViewportUpdateMode(QGraphicsView::FullViewportUpdate);
    setFocusPolicy(Qt::StrongFocus);
    chart()->legend()->hide();
    chart()->setBackgroundVisible(false);
    chart()->setAnimationOptions(QChart::NoAnimation);
    chart()->addAxis(m_timeAxis, Qt::AlignBottom);
    chart()->addAxis(m_valueAxis, Qt::AlignLeft);
    for (QValueAxis *axis : {m_timeAxis, m_valueAxis})
        axis->setVisible(false); // drawn by drawAxes: round numbers in the words of the locale
    connect(scene(), &QGraphicsScene::changed, this, &ChartArea::forget);
    connect(&m_timeline, &Timeline::currentChanged, this, [this] { viewport()->update(); });
    applyColours();
    setRanges();
}

ChartArea::~ChartArea() = default;

void ChartArea::forget()
{
    m_still = {};
    viewport()->update();
}

void ChartArea::clearSeries()
{
    m_runs.clear();
    m_measured.clear();
    m_spikes.clear();
    chart()->removeAllSeries();
}

void ChartArea::setScene(TrialScenePtr scene)
{
    clearSeries();
    m_scene = std::move(scene);
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        m_measured.push_back(analysis ? measuredPoints(analysis->profile, m_quantity) : QList<QPointF>());
        if (analysis)
            addRobot(int(robot), analysis->profile);
    }
    setRanges();
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        if (m_scene->robots[robot].analysis && m_quantity == Quantity::Speed)
            addSpikes(m_scene->robots[robot].analysis->profile);
    }
    refill();
    applyColours();
}

void ChartArea::setQuantity(Quantity quantity)
{
    m_quantity = quantity;
    setScene(m_scene);
}

void ChartArea::addRobot(int robot, const Profile &profile)
{
    const auto join = [this](QAbstractSeries *series) {
        chart()->addSeries(series);
        series->attachAxis(m_timeAxis);
        series->attachAxis(m_valueAxis);
    };
    for (CurveRun &run : curveRuns(profile, m_quantity)) {
        if (run.line.size() < 2)
            continue;
        auto *upper = new QLineSeries, *lower = new QLineSeries;
        auto *band = new QAreaSeries(upper, lower);
        upper->setParent(band);
        lower->setParent(band);
        auto *line = new QLineSeries;
        join(band);
        join(line);
        m_runs.push_back({robot, std::move(run), line, upper, lower, band});
    }
}

void ChartArea::addSpikes(const Profile &profile)
{
    auto *series = new QScatterSeries;
    series->setMarkerShape(QScatterSeries::MarkerShapeTriangle);
    series->setMarkerSize(11);
    for (const Spike &spike : profile.spikes) {
        const auto index = static_cast<std::size_t>(spike.sampleIndex);
        if (index >= profile.points.size())
            continue;
        const auto measured = measuredSpeed(profile, index);
        if (!measured && !profile.points[index].valid)
            continue;
        const double value = measured ? *measured : profile.points[index].speedMps;
        // What lies beyond the axis is shown at its end: every spike is to be seen.
        series->append(toSeconds(spike.time), std::clamp(value, m_valueTicks.first, m_valueTicks.last()));
    }
    chart()->addSeries(series);
    series->attachAxis(m_timeAxis);
    series->attachAxis(m_valueAxis);
    m_spikes.append(series);
}

void ChartArea::setRanges()
{
    double low = 0, high = 0;
    for (const Run &run : m_runs) {
        for (const QPointF &point : run.data.line) {
            low = std::min(low, point.y());
            high = std::max(high, point.y());
        }
    }
    // The band counts as long as it does not press the curve flat.
    const double room = 0.25 * std::max(1e-3, high - low);
    const double lineLow = low, lineHigh = high;
    for (const Run &run : m_runs) {
        for (qsizetype i = 0; i < run.data.line.size(); ++i) {
            low = std::min(low, std::max(run.data.lower[i].y(), lineLow - room));
            high = std::max(high, std::min(run.data.upper[i].y(), lineHigh + room));
        }
    }
    if (high - low < 1e-6)
        high = low + 1;
    const int most = std::max(2, int(plotRect().height() / 23));
    m_valueTicks = coveringTicks(low, high, most);
    m_valueAxis->setRange(m_valueTicks.first, m_valueTicks.last());
    m_startS = toSeconds(m_timeline.startTime());
    m_endS = toSeconds(m_timeline.endTime());
    if (m_scene && !m_scene->frameTimes().empty()) {
        m_startS = toSeconds(m_scene->frameTimes().front());
        m_endS = toSeconds(m_scene->frameTimes().back());
    }
    if (m_endS <= m_startS)
        m_endS = m_startS + 1;
    m_timeAxis->setRange(m_startS, m_endS);
}

void ChartArea::refill()
{
    const int columns = std::max(1, int(plotRect().width()));
    for (const Run &run : m_runs) {
        run.line->replace(decimated(run.data.line, m_startS, m_endS, columns));
        run.upper->replace(decimated(run.data.upper, m_startS, m_endS, columns));
        run.lower->replace(decimated(run.data.lower, m_startS, m_endS, columns));
    }
    forget();
}

void ChartArea::applyColours()
{
    const ThemeColours colours = ThemeColours::of(palette());
    setBackgroundBrush(colours.card);
    for (const Run &run : m_runs) {
        const QColor colour = seriesColour(run.robot, palette());
        QColor haze = colour;
        haze.setAlpha(60);
        run.line->setPen(QPen(colour, 1.8, seriesDash(run.robot), Qt::RoundCap, Qt::RoundJoin));
        run.band->setBrush(haze);
        run.band->setPen(Qt::NoPen);
    }
    for (QScatterSeries *series : std::as_const(m_spikes)) {
        series->setColor(colours.spike);
        series->setBorderColor(colours.card);
    }
    forget();
}

QRectF ChartArea::plotRect() const
{
    return ChartPlot::rectIn(QRectF(rect()));
}

ChartPlot ChartArea::plot() const
{
    return {plotRect(), m_startS, m_endS, m_valueTicks};
}

QPointF ChartArea::positionOf(Nanoseconds time, double value) const
{
    return plot().at(toSeconds(time), value);
}

void ChartArea::drawPoints(QPainter &painter) const
{
    QColor colour = ThemeColours::of(palette()).point;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 2.6, Qt::SolidLine, Qt::RoundCap));
    const QRectF plot = plotRect();
    for (const QList<QPointF> &points : m_measured) {
        QList<QPointF> places;
        for (const QPointF &point : decimated(points, m_startS, m_endS, std::max(1, int(plot.width()))))
            places.append(positionOf(fromSeconds(point.x()), point.y()));
        painter.setClipRect(plot);
        painter.drawPoints(places.constData(), int(places.size()));
    }
    painter.setClipping(false);
}

void ChartArea::drawBackground(QPainter *painter, const QRectF &rect)
{
    QChartView::drawBackground(painter, rect);
    painter->save();
    painter->setFont(font());
    drawChartAxes(*painter, plot(), tr("%1 s"), font(), palette());
    drawPoints(*painter);
    if (m_scene && m_runs.empty()) {
        painter->setPen(ThemeColours::of(palette()).muted);
        painter->drawText(plotRect(), Qt::AlignCenter, tr("No curve yet: track the trial"));
    }
    painter->restore();
}

void ChartArea::drawCursor(QPainter &painter) const
{
    if (m_timeline.frameCount() == 0)
        return;
    const double seconds = toSeconds(m_timeline.currentTime());
    drawChartCursor(painter, plot(), seconds, palette());
    const QString unit = curveUnit(m_quantity);
    double top = plotRect().top();
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        const auto value =
            analysis ? curveValueAt(analysis->profile, m_quantity, m_timeline.currentTime()) : std::nullopt;
        if (!value)
            continue;
        QString text = figureText(value->value, value->sigma, unit).text();
        if (m_scene->robots.size() > 1)
            text.prepend(QString::fromStdString(m_scene->robots[robot].robot.name) + QStringLiteral(": "));
        top = drawChartBubble(painter, plot(), {seconds, value->value}, top, text, seriesColour(int(robot), palette()),
                              palette());
    }
}

void ChartArea::paintEvent(QPaintEvent *)
{
    const QSize size = (QSizeF(viewport()->size()) * devicePixelRatioF()).toSize();
    if (m_still.size() != size) {
        m_still = QPixmap(size);
        m_still.setDevicePixelRatio(devicePixelRatioF());
        m_still.fill(ThemeColours::of(palette()).card);
        QPainter painter(&m_still);
        painter.setRenderHint(QPainter::Antialiasing);
        render(&painter, QRectF(viewport()->rect()), viewport()->rect());
    }
    QPainter painter(viewport());
    painter.drawPixmap(0, 0, m_still);
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    drawCursor(painter);
}

void ChartArea::resizeEvent(QResizeEvent *event)
{
    QChartView::resizeEvent(event);
    chart()->setPlotArea(plotRect());
    setRanges();
    refill();
}

void ChartArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        applyColours();
    QChartView::changeEvent(event);
}

void ChartArea::goTo(double x)
{
    m_timeline.setCurrentTime(fromSeconds(plot().xAt(x)));
}

void ChartArea::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_timeline.pause();
    goTo(event->position().x());
}

void ChartArea::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons().testFlag(Qt::LeftButton))
        goTo(event->position().x());
}

void ChartArea::mouseReleaseEvent(QMouseEvent *) {}

} // namespace odo
