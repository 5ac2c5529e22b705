// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/distance_chart.h"

#include "ui/models/comparison_explanation.h"
#include "ui/models/core_words.h"
#include "ui/models/figure_text.h"
#include "ui/models/shown_units.h"
#include "ui/models/timeline.h"
#include "ui/views/chart_bubbles.h"
#include "ui/views/chart_picture.h"
#include "ui/views/comparison_painting.h"
#include "ui/views/series_key.h"
#include "ui/views/theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

namespace odo {

DistanceArea::DistanceArea(Timeline &timeline, Compared what, QWidget *parent)
    : QWidget(parent), m_timeline(timeline), m_what(what), m_bubbles(new ChartBubbles(*this))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&m_timeline, &Timeline::currentChanged, this, qOverload<>(&QWidget::update));
    setRanges();
}

void DistanceArea::setScene(ComparisonScenePtr scene)
{
    m_scene = std::move(scene);
    m_curves.clear();
    if (m_scene)
        m_curves = comparedCurves(*m_scene, m_what);
    setRanges();
}

void DistanceArea::setRanges()
{
    m_plot = comparedPlot(ChartPlot::rectIn(QRectF(rect())), m_scene.get(), m_what, m_curves);
    m_still.forget();
    update();
}

void DistanceArea::paintCursor(QPainter &painter) const
{
    constexpr double rounding = 1e-3;
    m_bubbles->clear();
    double distance = m_scene->distanceAt(0, m_timeline.currentTime());
    if (distance < plot().low - rounding || distance > plot().high + rounding)
        return;
    distance = std::clamp(distance, plot().low, plot().high);
    const ChartPlot shown = plot();
    drawChartCursor(painter, shown, distance, palette());
    double top = shown.rect.top();
    for (const DistanceCurve &curve : m_curves) {
        const auto value = m_what == Compared::Speed ? speedAt(*m_scene, curve.run, distance)
                                                     : differenceAt(*m_scene, curve.run, distance);
        if (!value)
            continue;
        QString text = figureText(value->value, value->sigma, comparedUnit(m_what)).text();
        if (m_what == Compared::Speed || m_curves.size() > 1)
            text = joinedWords(QString::fromStdString(m_scene->name(curve.run)), text);
        const QRectF bubble =
            drawChartBubble(painter, shown, {distance, value->value}, top, text, seriesColour(int(curve.run), palette()), palette());
        m_bubbles->add(bubble, [scene = m_scene, what = m_what, run = curve.run, distance, value = *value] {
            return what == Compared::Speed
                       ? explainSpeedOnWay(*scene, run, distance, figureText(value.value, value.sigma, comparedUnit(what)).text())
                       : explainTimeDifference(*scene, run, distance, {value.value, value.sigma});
        });
        top = bubble.bottom() + bubbleGap;
    }
}

void DistanceArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    m_still.paint(painter, *this, ThemeColours::of(palette()).card,
                  [this](QPainter &still) { drawComparedCurves(still, m_plot, m_what, m_curves, font(), palette()); });
    if (!m_scene)
        return;
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    paintCursor(painter);
    drawChartFocus(painter, *this);
}

void DistanceArea::resizeEvent(QResizeEvent *)
{
    setRanges();
}

void DistanceArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_still.forget();
    QWidget::changeEvent(event);
}

void DistanceArea::goTo(double x)
{
    if (!m_scene)
        return;
    const RunComparison &comparison = m_scene->compared.comparison;
    const auto arrival = comparison.runs.front().arrivals.at(comparison.originM + plot().xAt(x));
    if (!arrival)
        return;
    m_timeline.pause();
    m_timeline.setCurrentTime(m_scene->commonTime(0, fromSeconds(arrival->timeS)));
}

void DistanceArea::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        goTo(event->position().x());
}

void DistanceArea::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons() & Qt::LeftButton)
        goTo(event->position().x());
}

DistanceChart::DistanceChart(Timeline &timeline, Compared what, QWidget *parent)
    : Card(what == Compared::Speed ? tr("Speed along the way") : tr("Time difference along the way"), parent),
      m_what(what), m_area(new DistanceArea(timeline, what)),
      m_key(what == Compared::Speed ? new SeriesKey(this) : nullptr)
{
    setContent(m_area);
    m_area->setAccessibleName(title());
    new ChartPicture(*m_area, [this] { return PictureHeading{title(), m_names, remark()}; }, m_key);
    if (m_key)
        addToHeader(m_key);
}

void DistanceChart::setScene(ComparisonScenePtr scene)
{
    m_names = scene ? scene->names() : QStringList();
    if (m_key)
        m_key->setNames(m_names);
    QString remark;
    if (scene && m_what == Compared::Speed)
        remark = tr("%1 · smoothed ±95 %").arg(shownUnits().speed.name);
    else if (scene)
        remark =
            scene->runCount() == 2
                ? tr("s · above 0: %2 is later than %1 · ±95 % · grey: within the error")
                      .arg(m_names[0], m_names[1])
                : tr("s · above 0: later than %1 · ±95 % · grey: within the error")
                      .arg(m_names[0]);
    setRemark(remark);
    m_area->setScene(std::move(scene));
    m_area->setAccessibleDescription(remark);
}

} // namespace odo
