// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/models/trial_scene.h"
#include "ui/report/internal/html_writer.h"
#include "ui/views/curves/chart_content.h"

#include <QString>

namespace odo {

/// Charts and maps as SVG within a page, whose style sheet has their colours by classes and follow
/// its theme. Large series are reduced to what a screen can show. Any thread.

/// A chart: bands, lines, points and spikes with its axes. title: what it shows, for its caption.
void writeChart(HtmlWriter &page, const ChartDrawing &drawing, const QString &title, const QString &remark);

/// Speed and acceleration of a robot's run.
void writeRunCharts(HtmlWriter &page, const Profile &profile);

/// The floor from above, with the robot's path coloured by speed, the task, markers and spikes.
void writeRunMap(HtmlWriter &page, const TrialScene &scene, std::size_t robot);

/// The paths of two runs.
void writeComparedMap(HtmlWriter &page, const ComparisonScene &scene);

} // namespace odo
