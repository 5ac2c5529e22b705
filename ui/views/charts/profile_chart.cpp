// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/profile_chart.h"

#include "ui/models/figure_text.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_bubbles.h"
#include "ui/views/charts/chart_picture.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/charts/profile_curve.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QComboBox>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace odo {

ChartArea::ChartArea(Timeline &timeline, ChartSpan &span, Quantity quantity, QWidget *parent)
    : QWidget(parent), m_timeline(timeline), m_span(span), m_quantity(quantity),
      m_bubbles(new ChartBubbles(*this)), m_maker(new CurveMaker(this))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    for (const auto signal : {&Timeline::currentChanged, &Timeline::selectionChanged})
        connect(&m_timeline, signal, this, qOverload<>(&QWidget::update));
    connect(m_maker, &CurveMaker::made, this, [this] {
        setTicks();
        Q_EMIT settled();
    });
    connect(&m_span, &ChartSpan::spanChanged, this, &ChartArea::forget);
    connect(&m_span, &ChartSpan::axisChanged, this, &ChartArea::rebuild);
    setTicks();
}

ChartArea::~ChartArea() = default;

void ChartArea::forget()
{
    m_still.forget();
    update();
}

void ChartArea::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_stretches = m_scene ? doubtfulStretches(*m_scene) : std::vector<DoubtfulStretch>();
    m_fit.reset();
    rebuild();
}

void ChartArea::setQuantity(Quantity quantity)
{
    m_quantity = quantity;
    rebuild();
}

void ChartArea::setFit(std::optional<FitOverlay> fit)
{
    m_fit = std::move(fit);
    update();
}

void ChartArea::rebuild()
{
    if (m_span.scene() != m_scene) // a scene comes to the span first, and to the charts one after the other
        return;
    m_maker->make(m_scene, m_quantity, m_span.places());
    setTicks();
}

void ChartArea::setTicks()
{
    const int most = std::max(2, int(plotRect().height() / 23));
    const ValueRange &range = m_maker->curves().range();
    m_valueTicks = coveringTicks(range.low, range.high, most);
    forget();
}

QRectF ChartArea::plotRect() const
{
    return ChartPlot::rectIn(QRectF(rect()));
}

ChartPlot ChartArea::plot() const
{
    return {plotRect(), m_span.low(), m_span.high(), m_valueTicks};
}

QPointF ChartArea::positionOf(Nanoseconds time, double value) const
{
    return plot().at(m_span.cursorPlace(time), value);
}

void ChartArea::drawStill(QPainter &painter) const
{
    const bool isTime = m_span.against() == ChartSpan::Against::Time;
    drawChartAxes(painter, plot(), isTime ? ShownUnit{QStringLiteral("s"), 1} : shownUnits().distance, font(),
                  palette());
    drawStretches(painter);
    m_maker->curves().draw(painter, plot(), palette());
}

void ChartArea::drawStretches(QPainter &painter) const
{
    for (const DoubtfulStretch &one : m_stretches) {
        const double from = m_span.placeOf(one.robot, one.span.begin),
                     to = m_span.placeOf(one.robot, one.span.end);
        if (from <= m_span.high() && to >= m_span.low())
            drawChartDoubt(painter, plot(), from, to, one.kind == DoubtfulStretch::Kind::Name, palette());
    }
}

void ChartArea::drawFit(QPainter &painter) const
{
    constexpr int pieces = 120;
    QList<QPointF> values;
    for (int i = 0; i <= pieces; ++i) {
        const Nanoseconds time = m_fit->span.begin + (m_fit->span.end - m_fit->span.begin) * i / pieces;
        values << QPointF(m_span.placeOf(m_fit->robot, time),
                          curveFactor(m_quantity) * m_fit->fit.at(toSeconds(time)));
    }
    drawChartFit(painter, plot(), values, palette());
}

void ChartArea::drawCursor(QPainter &painter) const
{
    m_bubbles->clear();
    if (m_timeline.frameCount() == 0)
        return;
    const Nanoseconds now = m_timeline.currentTime();
    if (const double place = m_span.cursorPlace(now); place >= m_span.low() && place <= m_span.high())
        drawChartCursor(painter, plot(), place, palette());
    const auto placeOf = [this, now](std::size_t robot) { return m_span.placeOf(robot, now); };
    for (const ShownValue &value : m_maker->curves().drawValues(painter, plot(), now, placeOf, palette()))
        m_bubbles->add(value.bubble, [scene = m_scene, quantity = m_quantity, now, value] {
            return explainCurve(*scene, value.robot, quantity, now, value.text);
        });
}

bool ChartArea::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    constexpr int reachPx = 3;
    const auto *help = static_cast<QHelpEvent *>(event);
    const Nanoseconds time = timeAt(help->pos().x());
    const QString words = plotRect().contains(help->pos())
                              ? doubtfulWordsAt(m_stretches, time, timeAt(help->pos().x() + reachPx) - time)
                              : QString();
    showToolTip(*help, words, this);
    return true;
}

void ChartArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    m_still.paint(painter, *this, ThemeColours::of(palette()).card,
                  [this](QPainter &still) { drawStill(still); });
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    if (const auto &range = m_timeline.selection())
        drawChartRange(painter, plot(), m_span.cursorPlace(range->begin), m_span.cursorPlace(range->end),
                       palette());
    if (m_fit && m_fit->quantity == m_quantity)
        drawFit(painter);
    drawCursor(painter);
    drawChartFocus(painter, *this);
}

void ChartArea::resizeEvent(QResizeEvent *)
{
    setTicks();
}

void ChartArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        forget();
    QWidget::changeEvent(event);
}

Nanoseconds ChartArea::timeAt(double x) const
{
    return m_span.timeAt(plot().xAt(x));
}

void ChartArea::mousePressEvent(QMouseEvent *event)
{
    const double x = event->position().x();
    if (event->button() == Qt::MiddleButton)
        m_pannedX = x;
    if (event->button() != Qt::LeftButton)
        return;
    m_pressedX = x;
    m_isDragged = false;
    m_timeline.pause();
    m_timeline.setCurrentTime(timeAt(x));
}

void ChartArea::mouseMoveEvent(QMouseEvent *event)
{
    const double x = event->position().x();
    if (event->buttons().testFlag(Qt::MiddleButton)) {
        m_span.pan((m_pannedX - x) / std::max(1.0, plotRect().width()));
        m_pannedX = x;
    }
    if (!event->buttons().testFlag(Qt::LeftButton) || !m_pressedX)
        return;
    m_isDragged = m_isDragged || std::abs(x - *m_pressedX) >= QApplication::startDragDistance();
    if (!m_isDragged)
        return;
    m_timeline.setSelection(TimeSpan{timeAt(*m_pressedX), timeAt(x)});
    m_timeline.setCurrentTime(timeAt(x));
}

void ChartArea::mouseReleaseEvent(QMouseEvent *)
{
    m_pressedX.reset();
}

void ChartArea::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        m_span.showAll();
}

void ChartArea::wheelEvent(QWheelEvent *event)
{
    constexpr double notch = 120, zoomStep = 1.25, panStep = 0.1;
    const QPoint turned = event->angleDelta();
    const bool isSideways = std::abs(turned.x()) > std::abs(turned.y());
    if (isSideways || event->modifiers().testFlag(Qt::ShiftModifier))
        m_span.pan(-panStep * (isSideways ? turned.x() : turned.y()) / notch);
    else
        m_span.zoom(std::pow(zoomStep, turned.y() / notch), plot().xAt(event->position().x()));
    event->accept();
}

namespace {

/// The metric that tells most of a quantity; empty: none.
std::string tellingMetric(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
        return "max_speed";
    case Quantity::Acceleration:
        return "max_accel";
    case Quantity::TurnRate:
        return "max_turn_rate";
    default:
        return {};
    }
}

} // namespace

QString quantityName(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
        return ProfileChart::tr("Speed");
    case Quantity::Acceleration:
        return ProfileChart::tr("Acceleration");
    case Quantity::Heading:
        return ProfileChart::tr("Heading");
    case Quantity::TurnRate:
        return ProfileChart::tr("Turn rate");
    case Quantity::PositionX:
        return ProfileChart::tr("Position X");
    case Quantity::PositionY:
        break;
    }
    return ProfileChart::tr("Position Y");
}

ProfileChart::ProfileChart(Timeline &timeline, Quantity quantity, QWidget *parent)
    : ProfileChart(timeline, *new ChartSpan(timeline), {quantity}, parent)
{
    m_span.setParent(this);
}

ProfileChart::ProfileChart(Timeline &timeline, ChartSpan &span, QList<Quantity> quantities, QWidget *parent)
    : Card(quantityName(quantities.first()), parent), m_span(span),
      m_area(new ChartArea(timeline, span, quantities.first(), this)), m_key(new SeriesKey(this)),
      m_quantities(quantities), m_quantity(quantities.first())
{
    addToHeader(m_key);
    if (quantities.size() > 1) {
        m_choice = new QComboBox(this);
        m_choice->setAccessibleName(tr("Quantity that the chart shows"));
        m_choice->setFocusPolicy(Qt::TabFocus); // Space goes on playing
        for (const Quantity quantity : quantities)
            m_choice->addItem(quantityName(quantity));
        connect(m_choice, &QComboBox::currentIndexChanged, this,
                [this](int index) { setQuantity(m_quantities.at(index)); });
        addToHeader(m_choice);
    }
    setContent(m_area);
    const auto heading = [this] {
        return PictureHeading{
            title(), {m_scene ? QString::fromStdString(m_scene->trial.name) : QString()}, remark()};
    };
    new ChartPicture(*m_area, heading, m_key);
    connect(m_area, &ChartArea::settled, this, &ProfileChart::settled);
    connect(&m_span, &ChartSpan::axisChanged, this, &ProfileChart::describe);
    setScene(nullptr);
}

ProfileChart::~ProfileChart() = default;

void ProfileChart::setQuantity(Quantity quantity)
{
    if (quantity == m_quantity)
        return;
    m_quantity = quantity;
    if (m_choice)
        m_choice->setCurrentIndex(static_cast<int>(m_quantities.indexOf(quantity)));
    setTitle(quantityName(quantity));
    m_area->setQuantity(quantity);
    describe();
    Q_EMIT quantityChanged();
}

void ProfileChart::setFit(std::optional<FitOverlay> fit)
{
    m_area->setFit(std::move(fit));
}

void ProfileChart::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_span.setScene(m_scene);
    m_area->setScene(m_scene);
    describe();
}

void ProfileChart::describe()
{
    qsizetype spikes = 0;
    bool analysed = false;
    QStringList spoken, robots;
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        robots += QString::fromStdString(m_scene->robots[robot].robot.name);
        if (!analysis)
            continue;
        analysed = true;
        spikes += qsizetype(analysis->profile.spikes.size());
        for (const Metric &metric : analysis->profile.metrics) {
            if (metric.name == tellingMetric(m_quantity))
                spoken += QStringLiteral("%1: %2 %3")
                              .arg(QString::fromStdString(m_scene->robots[robot].robot.name),
                                   metricName(metric.name), metricFigure(metric).text());
        }
    }
    QStringList remark{curveUnit(m_quantity)};
    if (analysed)
        remark += tr("smoothed ±95 %");
    if (analysed && m_quantity != Quantity::TurnRate)
        remark += tr("measured points");
    if (m_quantity == Quantity::Speed && analysed)
        remark += spikes == 1 ? tr("1 spike") : tr("%1 spikes").arg(spikes);
    if (m_quantity == Quantity::Acceleration && analysed)
        remark += tr("along the path");
    if (m_quantity == Quantity::Heading && analysed)
        remark += tr("of the motion, anticlockwise from X");
    if (m_quantity == Quantity::TurnRate && analysed)
        remark += tr("anticlockwise positive");
    if (m_area->hasDoubtfulStretches())
        remark += tr("shaded: hidden or doubtful");
    setRemark(remark.join(QStringLiteral(" · ")));
    m_area->setAccessibleName((m_span.against() == ChartSpan::Against::Time
                                   ? tr("Chart: %1 against time")
                                   : tr("Chart: %1 against the distance"))
                                  .arg(quantityName(m_quantity)));
    m_area->setAccessibleDescription(spoken.join(QStringLiteral("; ")));
    m_key->setNames(robots, m_scene ? colourPlaces(*m_scene) : std::vector<int>());
}

bool ProfileChart::isSettled() const
{
    return m_area->isSettled();
}

QWidget *ProfileChart::chartArea() const
{
    return m_area;
}

} // namespace odo
