// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/floor_map.h"

#include "ui/views/map_area.h"

namespace odo {

FloorMap::FloorMap(Timeline &timeline, QWidget *parent)
    : Card(tr("Top-down map"), parent), m_area(new MapArea(timeline, this))
{
    setContent(m_area);
    setRemark(tr("coloured by speed"));
    m_area->setAccessibleName(tr("Map of the floor with the robots' trails"));
    connect(m_area, &MapArea::settled, this, &FloorMap::settled);
}

FloorMap::~FloorMap() = default;

void FloorMap::setScene(TrialScenePtr scene)
{
    m_area->setScene(std::move(scene));
}
bool FloorMap::isSettled() const
{
    return m_area->isSettled();
}
QPointF FloorMap::fromWorld(const Eigen::Vector2d &pointInWorld) const
{
    return m_area->fromWorld(pointInWorld);
}
QWidget *FloorMap::mapArea() const
{
    return m_area;
}

} // namespace odo
