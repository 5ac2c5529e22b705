// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/internal/motion.h"
#include "tests/acceptance/scenes/seeded_draw.h"

namespace odo::test {

using SharedMotion = std::shared_ptr<const Motion>;

/// Trajectories on the floor of 3 m × 2.2 m with drawn parameters; a robot of 30 cm stays on the floor.
SharedMotion drawnLine(SeededDraw &draw, double durationS);
SharedMotion drawnCircle(SeededDraw &draw);
SharedMotion drawnFigureEight(SeededDraw &draw, double topSpeedMps);
SharedMotion drawnStopAndGo(SeededDraw &draw);
/// A smooth random walk with turns, at 0.15 to 1.6 m/s on its way, for stepS · (points - 1).
SharedMotion drawnWander(SeededDraw &draw, int points, double stepS);
/// Crawls at 25 to 50 mm/s along a line.
SharedMotion drawnCrawl(SeededDraw &draw, double durationS);
/// Runs against a wall at impactS and is thrown back with a part of its speed, within 30 ms.
SharedMotion drawnCollision(SeededDraw &draw, double impactS);

} // namespace odo::test
