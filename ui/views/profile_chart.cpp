// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profile_chart.h"

#include "ui/models/figure_text.h"
#include "ui/views/chart_area.h"
#include "ui/views/profile_curve.h"
#include "ui/views/series_key.h"

#include <QComboBox>
#include <QStringList>

namespace odo {

namespace {

struct QuantityWords
{
    QString name, spoken;
    std::string metric; ///< that tells most of it; empty: none
};

QuantityWords wordsOf(Quantity quantity)
{
    switch (quantity) {
    case Quantity::Speed:
        return {ProfileChart::tr("Speed"), ProfileChart::tr("Chart of the speed against time"), "max_speed"};
    case Quantity::Acceleration:
        return {ProfileChart::tr("Acceleration"), ProfileChart::tr("Chart of the acceleration against time"),
                "max_accel"};
    case Quantity::Heading:
        return {ProfileChart::tr("Heading"), ProfileChart::tr("Chart of the heading against time"), {}};
    case Quantity::TurnRate:
        return {ProfileChart::tr("Turn rate"), ProfileChart::tr("Chart of the turn rate against time"),
                "max_turn_rate"};
    case Quantity::PositionX:
        return {ProfileChart::tr("Position X"), ProfileChart::tr("Chart of the position along X against time"), {}};
    case Quantity::PositionY:
        break;
    }
    return {ProfileChart::tr("Position Y"), ProfileChart::tr("Chart of the position along Y against time"), {}};
}

} // namespace

ProfileChart::ProfileChart(Timeline &timeline, Quantity quantity, QWidget *parent)
    : ProfileChart(timeline, QList<Quantity>{quantity}, parent)
{
}

ProfileChart::ProfileChart(Timeline &timeline, QList<Quantity> quantities, QWidget *parent)
    : Card(wordsOf(quantities.first()).name, parent), m_area(new ChartArea(timeline, quantities.first(), this)),
      m_key(new SeriesKey(this)), m_quantity(quantities.first())
{
    addToHeader(m_key);
    if (quantities.size() > 1) {
        auto *choice = new QComboBox(this);
        choice->setAccessibleName(tr("Quantity that the chart shows"));
        for (const Quantity quantity : quantities)
            choice->addItem(wordsOf(quantity).name);
        connect(choice, &QComboBox::currentIndexChanged, this,
                [this, quantities](int index) { setQuantity(quantities.at(index)); });
        addToHeader(choice);
    }
    setContent(m_area);
    setScene(nullptr);
}

ProfileChart::~ProfileChart() = default;

void ProfileChart::setQuantity(Quantity quantity)
{
    m_quantity = quantity;
    setTitle(wordsOf(quantity).name);
    m_area->setQuantity(quantity);
    describe();
}

void ProfileChart::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
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
            if (metric.name == wordsOf(m_quantity).metric)
                spoken += QStringLiteral("%1: %2 %3")
                              .arg(QString::fromStdString(m_scene->robots[robot].robot.name),
                                   metricName(metric.name), metricFigure(metric).text());
        }
    }
    QStringList remark{curveUnit(m_quantity)};
    if (m_quantity == Quantity::Speed && analysed)
        remark += {tr("smoothed \u00b195 %"), tr("measured points"),
                   spikes == 1 ? tr("1 spike") : tr("%1 spikes").arg(spikes)};
    if (m_quantity == Quantity::Acceleration && analysed)
        remark += tr("along the path");
    if (m_quantity == Quantity::Heading && analysed)
        remark += tr("of the motion, anticlockwise from X");
    if (m_quantity == Quantity::TurnRate && analysed)
        remark += tr("anticlockwise positive");
    setRemark(remark.join(QStringLiteral(" \u00b7 ")));
    m_area->setAccessibleName(wordsOf(m_quantity).spoken);
    m_area->viewport()->setAccessibleName(m_area->accessibleName()); // it takes the mouse and the focus frame
    m_area->setAccessibleDescription(spoken.join(QStringLiteral("; ")));
    m_key->setNames(robots);
}

QWidget *ProfileChart::chartArea() const
{
    return m_area;
}

} // namespace odo
