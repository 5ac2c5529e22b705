// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QString>
#include <QStringList>

namespace odo {

/// "How was this computed?" of one number: plain text that can be copied.
struct Explanation
{
    QString what;        ///< "Top speed"
    QString value;       ///< "2.06 ±0.02 m/s"
    QString formula;     ///< in words and signs
    QString uncertainty; ///< what ± contains; empty: it has none
    QStringList inputs;  ///< what went into it, a line each
    QString source;      ///< author, year; empty: none

    QString text() const;
};

/// What an analysis was made of: samples used and left out, smoother, views, height, version.
QStringList analysisInputs(const TrialScene &scene, std::size_t robot);

/// Of a figure of a robot's analysis. One that is not known is told by its name and inputs alone.
Explanation explainMetric(const TrialScene &scene, std::size_t robot, const Metric &metric);
/// Of a flag that a sample of a robot bears: what was looked at, and what becomes of the sample.
Explanation explainSpike(const TrialScene &scene, std::size_t robot, const Spike &spike);

} // namespace odo
