// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/acceptance/scenes/scene_bars.h"

#include <QJsonObject>

namespace odo::test {

/// The table's head, and a line for one measured scene.
QString tableHead();
QString tableLine(const MeasuredScene &measured);
/// A line for each bar: the figure, what is demanded, and whether it is met.
QString barsTable(const std::vector<BarResult> &bars);

QJsonObject reportJson(const std::vector<MeasuredScene> &scenes, const std::vector<BarResult> &bars);

} // namespace odo::test
