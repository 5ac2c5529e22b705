// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/quantity_curve.h"
#include "ui/models/comparison_scene.h"
#include "ui/models/trial_scene.h"
#include "ui/report/internal/report_painting.h"
#include "ui/views/map/map_painting.h"

#include <QRectF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

class QPainter;

namespace odo {

/// Something of a run that a report names: its number is on the map, on the charts and in a list.
struct RunEvent
{
    enum class Kind { Motion, Gap, Gate, TopSpeed, Spike };
    Kind kind = Kind::Motion;
    int number = 0; ///< from 1
    Nanoseconds time{0};
    Nanoseconds until{0};     ///< of spikes in a row the last one's, of a gap its end; else as time
    Eigen::Vector2d position; ///< on the floor
    QString words;
};

/// Start and end of the motion, the gaps in which nothing was measured, the gates passed, the top speed, and
/// the spikes (those in a row as one), in the order of time. Where that is more than `most`, spikes are left
/// out first, those of the fewest samples before others, then gates, then gaps, short ones before long ones.
std::vector<RunEvent> runEvents(const Profile &profile, std::size_t most);

/// A curve of a run against the time, with its ±95 % band, the measured points beneath, spikes as triangles
/// and hatched, and the events' numbers above; with title. Painted by what the charts of the screen are
/// painted by.
void drawRunChart(QPainter &painter, const QRectF &rect, const Profile &profile, Quantity quantity,
                  const std::vector<RunEvent> &events);

/// The number of an event in a disc, of a spike in a square, so that they differ without colour.
void drawEventNumber(QPainter &painter, const QPointF &centre, const RunEvent &event);
constexpr double eventNumberRadius = 6.5;

/// Ground, grid and markers in a frame, and whatever comes on them.
void drawFramedMap(QPainter &painter, const QRectF &rect, const Eigen::AlignedBox2d &bounds,
                   const std::optional<MarkerLayout> &layout,
                   const std::function<void(const MapPlan &)> &drawRest);

/// Gates or zones with names fit for paper.
template <class Each>
std::vector<Each> literalNames(std::vector<Each> all)
{
    for (Each &each : all)
        each.name = literalName(each.name).toStdString();
    return all;
}

/// The floor from above with a robot's path coloured by speed, the gates and the course of the task, spikes,
/// and the events' numbers; the paths of other robots are thin and grey. Painted by what the map of the
/// screen is painted by, without the floor image: paper stays light.
void drawRunMap(QPainter &painter, const QRectF &rect, const TrialScene &scene, std::size_t robot,
                const std::vector<RunEvent> &events);

/// The paths of these runs in their colours and dashes, with the gates across the common path.
void drawComparedMap(QPainter &painter, const QRectF &rect, const ComparisonScene &scene,
                     const std::vector<std::size_t> &runs);

} // namespace odo
