// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/quantity_curve.h"
#include "ui/report/run_events.h"

#include <QRectF>

class QPainter;

namespace odo {

/// A curve of a run against the time, with its ±95 % band, the measured points beneath, spikes as triangles and
/// hatched, and the events' numbers above; with title. Painted by what the charts of the screen are painted by.
void drawRunChart(QPainter &painter, const QRectF &rect, const Profile &profile, Quantity quantity,
                  const std::vector<RunEvent> &events);

/// The number of an event in a disc, of a spike in a square, so that they differ without colour.
void drawEventNumber(QPainter &painter, const QPointF &centre, const RunEvent &event);
constexpr double eventNumberRadius = 6.5;

} // namespace odo
