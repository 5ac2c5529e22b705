// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_health.h"
#include "core/workflow/record/live_tracking.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/widgets/fact_list.h"

#include <QList>
#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// Where a robot is, as a line says it.
struct SeenRobot
{
    std::string name;
    std::optional<LivePosition> now; ///< empty: not seen just now
};

/// How cameras, step, map and disk do, and where the robots are, a line each. Losses are those since
/// `before`.
QList<Fact> healthFacts(const CaptureHealth &health, const std::vector<WantedCamera> &cameras,
                        const LiveFigures &live, const std::vector<SeenRobot> &robots = {},
                        const CaptureHealth &before = {});

/// What a person must know now, in a sentence; the worst first; empty: all is well.
QString troubleWords(const CaptureHealth &health, const std::vector<WantedCamera> &cameras);
/// That a camera cannot tell where a robot is; empty where all can.
QString unregisteredWords(const std::vector<WantedCamera> &cameras);

} // namespace odo
