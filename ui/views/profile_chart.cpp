// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/profile_chart.h"

#include "ui/models/figure_text.h"
#include "ui/views/chart_area.h"
#include "ui/views/series_key.h"

#include <QStringList>

namespace odo {

ProfileChart::ProfileChart(Timeline &timeline, Quantity quantity, QWidget *parent)
    : Card(quantity == Quantity::Speed ? tr("Speed") : tr("Acceleration"), parent),
      m_area(new ChartArea(timeline, quantity, this)), m_key(new SeriesKey(this)), m_quantity(quantity)
{
    addToHeader(m_key);
    setContent(m_area);
    m_area->setAccessibleName(quantity == Quantity::Speed ? tr("Chart of the speed against time")
                                                          : tr("Chart of the acceleration against time"));
    m_area->viewport()->setAccessibleName(m_area->accessibleName()); // it takes the mouse and the focus frame
    setScene(nullptr);
}

ProfileChart::~ProfileChart() = default;

void ProfileChart::setScene(TrialScenePtr scene)
{
    qsizetype spikes = 0;
    bool analysed = false;
    QStringList spoken, robots;
    for (std::size_t robot = 0; scene && robot < scene->robots.size(); ++robot) {
        const auto &analysis = scene->robots[robot].analysis;
        robots += QString::fromStdString(scene->robots[robot].robot.name);
        if (!analysis)
            continue;
        analysed = true;
        spikes += qsizetype(analysis->profile.spikes.size());
        for (const Metric &metric : analysis->profile.metrics) {
            const bool telling = metric.name == (m_quantity == Quantity::Speed ? "max_speed" : "max_accel");
            if (telling)
                spoken += QStringLiteral("%1: %2 %3")
                              .arg(QString::fromStdString(scene->robots[robot].robot.name),
                                   metricName(metric.name), metricFigure(metric).text());
        }
    }
    const QString unit = m_quantity == Quantity::Speed ? tr("m/s") : tr("m/s\u00b2");
    QStringList remark{unit};
    if (m_quantity == Quantity::Speed && analysed)
        remark += {tr("smoothed \u00b195 %"), tr("measured points"),
                   spikes == 1 ? tr("1 spike") : tr("%1 spikes").arg(spikes)};
    if (m_quantity == Quantity::Acceleration && analysed)
        remark += tr("along the path");
    setRemark(remark.join(QStringLiteral(" \u00b7 ")));
    m_area->setAccessibleDescription(spoken.join(QStringLiteral("; ")));
    m_key->setNames(robots);
    m_area->setScene(std::move(scene));
}

QWidget *ProfileChart::chartArea() const
{
    return m_area;
}

} // namespace odo
