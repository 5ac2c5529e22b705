// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profile_chart.h"

#include "ui/models/figure_text.h"
#include "ui/views/chart_area.h"
#include "ui/views/chart_picture.h"
#include "ui/views/chart_span.h"
#include "ui/views/profile_curve.h"
#include "ui/views/robot_colours.h"
#include "ui/views/series_key.h"

#include <QComboBox>
#include <QStringList>

namespace odo {

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
    const auto heading = [this] { return PictureHeading{title(), {m_scene ? QString::fromStdString(m_scene->trial.name) : QString()}, remark()}; };
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
