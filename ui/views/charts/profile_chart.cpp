// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/profile_chart.h"

#include "ui/models/number_text.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/charts/series_colours.h"
#include "ui/views/charts/trial_curves.h"

#include <QComboBox>
#include <QPainter>
#include <QStandardItemModel>
#include <QStringList>
#include <algorithm>
#include <limits>

namespace odo {

namespace {

ChartAxes axesOf(const ChartSpan &span, Quantity quantity)
{
    const bool isTime = span.against() == ChartSpan::Against::Time;
    return {isTime ? ShownUnit{QStringLiteral("s"), 1} : shownUnits().distance, curveUnit(quantity)};
}

} // namespace

ChartArea::ChartArea(Timeline &timeline, ChartSpan &span, Quantity quantity, QWidget *parent)
    : ChartView(span, axesOf(span, quantity), parent), m_timeline(timeline), m_span(span),
      m_quantity(quantity), m_bubbles(new ChartBubbles(*this)), m_maker(new CurveMaker(this))
{
    for (const auto signal : {&Timeline::currentChanged, &Timeline::selectionChanged})
        connect(&m_timeline, signal, viewport(), qOverload<>(&QWidget::update));
    connect(m_maker, &CurveMaker::made, this, [this] {
        showCurves();
        Q_EMIT settled();
    });
    connect(&m_span, &ChartSpan::axisChanged, this, &ChartArea::rebuild);
}

ChartArea::~ChartArea() = default;

void ChartArea::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_stretches = m_scene ? uncertainIntervals(*m_scene) : std::vector<UncertainInterval>();
    m_fit.reset();
    showAllGroups();
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
    showFit();
}

void ChartArea::rebuild()
{
    if (m_span.scene() != m_scene) // a scene comes to the span first, and to the charts one after the other
        return;
    m_maker->make(m_scene, m_quantity, m_span.positions(), m_span.against() == ChartSpan::Against::Time);
    showCurves();
}

void ChartArea::showCurves()
{
    setAxes(axesOf(m_span, m_quantity));
    std::vector<ChartStretch> stretches;
    for (const UncertainInterval &one : m_stretches)
        stretches.push_back({m_span.positionOf(one.robot, one.span.begin),
                             m_span.positionOf(one.robot, one.span.end),
                             one.kind == UncertainInterval::Kind::Name});
    setContent(m_maker->curves().content(), std::move(stretches));
    showFit();
}

/// Dashed, over a rim, to contrast with the curve.
void ChartArea::showFit()
{
    if (!m_fit || m_fit->quantity != m_quantity) {
        setOverlay({});
        return;
    }
    constexpr int pieces = 120;
    CurveRun values;
    for (int i = 0; i <= pieces; ++i) {
        const Nanoseconds time = m_fit->span.begin + (m_fit->span.end - m_fit->span.begin) * i / pieces;
        values.points.emplace_back(m_span.positionOf(m_fit->robot, time),
                                   CurveValue{curveFactor(m_quantity) * m_fit->fit.at(toSeconds(time)), 0});
    }
    ChartCurve rim, line;
    rim.runs = line.runs = {values};
    rim.group = line.group = -1;
    rim.ink = ChartInk::Ground;
    rim.widthPx = 5;
    line.ink = ChartInk::Text;
    line.widthPx = 2;
    line.dash = Qt::DashLine;
    setOverlay({rim, line});
}

void ChartArea::paintOver(QPainter &painter)
{
    if (m_scene && m_scene->trial.range && m_span.against() == ChartSpan::Against::Time)
        drawChartOutside(painter, plot(), toSeconds(m_scene->trial.range->begin),
                         toSeconds(m_scene->trial.range->end), palette());
    if (const auto &range = m_timeline.selection())
        drawChartRange(painter, plot(), m_span.cursorPosition(range->begin),
                       m_span.cursorPosition(range->end), palette());
    m_bubbles->clear();
    if (m_timeline.frameCount() == 0)
        return;
    const Nanoseconds now = m_timeline.currentTime();
    if (const double position = m_span.cursorPosition(now);
        position >= m_span.low() && position <= m_span.high())
        drawChartCursor(painter, plot(), position, palette());
    const auto positionOf = [this, now](std::size_t robot) {
        return isGroupShown(int(robot)) ? m_span.positionOf(robot, now)
                                        : std::numeric_limits<double>::quiet_NaN();
    };
    for (const ShownValue &value : m_maker->curves().drawValues(painter, plot(), now, positionOf, palette()))
        m_bubbles->add(value.bubble, [scene = m_scene, quantity = m_quantity, now, value] {
            return explainCurve(*scene, value.robot, quantity, now, value.text);
        });
}

QString ChartArea::wordsAt(const QPoint &position) const
{
    constexpr int reachPx = 3;
    const Nanoseconds time = m_span.timeAt(plot().xAt(position.x()));
    return uncertaintyTextAt(m_stretches, time, m_span.timeAt(plot().xAt(position.x() + reachPx)) - time);
}

void ChartArea::goTo(double x)
{
    m_timeline.pause();
    m_timeline.setCurrentTime(m_span.timeAt(x));
}

void ChartArea::dragTo(double from, double x)
{
    m_timeline.setSelection(TimeSpan{m_span.timeAt(from), m_span.timeAt(x)});
    m_timeline.setCurrentTime(m_span.timeAt(x));
}

namespace {

/// The most informative metric of a quantity; empty: none.
std::string tellingMetric(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
        return "max_speed";
    case Quantity::Acceleration:
        return "max_accel";
    case Quantity::TurnRate:
        return "max_turn_rate";
    case Quantity::Distance:
        return "path_length";
    default:
        return {};
    }
}

/// Of others the raw differences are nothing but noise.
bool hasMeasuredPoints(Quantity quantity)
{
    return quantity != Quantity::TurnRate && quantity != Quantity::LateralAcceleration &&
           quantity != Quantity::Jerk && quantity != Quantity::Distance && quantity != Quantity::Separation;
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
    case Quantity::VelocityX:
        return ProfileChart::tr("Velocity X");
    case Quantity::VelocityY:
        return ProfileChart::tr("Velocity Y");
    case Quantity::LateralAcceleration:
        return ProfileChart::tr("Lateral acceleration");
    case Quantity::Jerk:
        return ProfileChart::tr("Jerk");
    case Quantity::Distance:
        return ProfileChart::tr("Distance travelled");
    case Quantity::Displacement:
        return ProfileChart::tr("Distance from the start");
    case Quantity::Separation:
        return ProfileChart::tr("Distance to the nearest robot");
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
    connect(m_key, &SeriesKey::toggled, m_area, &ChartView::setGroupShown);
    if (quantities.size() > 1) {
        m_choice = new QComboBox(this);
        m_choice->setAccessibleName(tr("Quantity of the chart"));
        m_choice->setFocusPolicy(Qt::TabFocus); // Space goes on playing
        for (const Quantity quantity : quantities)
            m_choice->addItem(quantityName(quantity));
        connect(m_choice, &QComboBox::currentIndexChanged, this,
                [this](int index) { setQuantity(m_quantities.at(index)); });
        addToHeader(m_choice);
    }
    setContent(m_area);
    const auto heading = [this] {
        return ImageHeading{
            title(), {m_scene ? QString::fromStdString(m_scene->trial.name) : QString()}, remark()};
    };
    new ChartImage(*m_area, heading, m_key);
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
    QStringList robots;
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot)
        robots += QString::fromStdString(m_scene->robots[robot].robot.name);
    // Not at every change of what is shown: the key then keeps what is hidden.
    offerSeparation(robots.size() > 1);
    m_key->setNames(robots, m_scene ? paletteIndices(*m_scene) : std::vector<int>());
    describe();
}

/// A robot alone has no other one.
void ProfileChart::offerSeparation(bool isOffered)
{
    const auto row = static_cast<int>(m_quantities.indexOf(Quantity::Separation));
    if (!m_choice || row < 0)
        return;
    auto *model = qobject_cast<QStandardItemModel *>(m_choice->model());
    model->item(row)->setEnabled(isOffered);
}

void ProfileChart::describe()
{
    qsizetype spikes = 0;
    bool analysed = false, showsBody = false;
    QStringList spoken;
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        if (!analysis)
            continue;
        analysed = true;
        spikes += qsizetype(analysis->profile.spikes.size());
        showsBody = showsBody || std::ranges::any_of(analysis->profile.points, [](const ProfilePoint &point) {
                        return point.body.has_value();
                    });
        for (const Metric &metric : analysis->profile.metrics) {
            if (metric.name == tellingMetric(m_quantity))
                spoken += QStringLiteral("%1: %2 %3")
                              .arg(QString::fromStdString(m_scene->robots[robot].robot.name),
                                   metricName(metric.name), metricNumber(metric).text());
        }
    }
    QStringList remark{curveUnit(m_quantity)};
    if (analysed)
        remark += tr("smoothed ±95 %");
    if (analysed && hasMeasuredPoints(m_quantity))
        remark += tr("measured points");
    if (m_quantity == Quantity::Speed && analysed)
        remark += spikes == 1 ? tr("1 spike") : tr("%1 spikes").arg(spikes);
    if (m_quantity == Quantity::Acceleration && analysed)
        remark += tr("along the path");
    if (m_quantity == Quantity::Heading && analysed)
        remark +=
            showsBody ? tr("of the body, anticlockwise from X") : tr("of the motion, anticlockwise from X");
    if (m_quantity == Quantity::TurnRate && analysed)
        remark += tr("anticlockwise positive");
    if (m_quantity == Quantity::LateralAcceleration && analysed)
        remark += tr("to the left positive");
    if (m_quantity == Quantity::Jerk && analysed)
        remark += tr("along the path, mean over %1").arg(secondsText(fromSeconds(jerkSpanS)));
    if (m_area->hasUncertainIntervals())
        remark += tr("shaded: hidden, ambiguous or not measured");
    setRemark(remark.join(QStringLiteral(" · ")));
    m_area->setAccessibleName((m_span.against() == ChartSpan::Against::Time ? tr("Chart: %1 over time")
                                                                            : tr("Chart: %1 over distance"))
                                  .arg(quantityName(m_quantity)));
    m_area->setAccessibleDescription(spoken.join(QStringLiteral("; ")));
}

bool ProfileChart::isSettled() const
{
    return m_area->isSettled();
}

ChartArea *ProfileChart::chartArea() const
{
    return m_area;
}

} // namespace odo
