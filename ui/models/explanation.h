// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "core/project/records.h"
#include "ui/models/trial_scene.h"

#include <QString>
#include <QStringList>

namespace odo {

/// The inputs of metrics, in phrases that fit a line.

/// "Kalman/RTS, noise from the data"
QString smootherText(Smoother smoother);
/// How a view was synchronised with the first: "synchronised to 1.2 ms by the motion; started 3.0 ms later".
QString stepText(const RecordingRecord &view);
/// The frame intervals of a camera with an uneven rate: "9 to 46 ms apart"; empty where the rate is even.
QString unevenText(const RecordingRecord &view);

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

/// When and how far a robot was beyond the edges of its task's zones, a line each; none where it was measured
/// by another course.
QStringList zoneBreachLines(const TrialScene &scene, std::size_t robot);

/// Of the curve of a quantity at a moment of a robot's: that of the last sample not after it. value: as it is
/// shown there.
Explanation explainCurve(const TrialScene &scene, std::size_t robot, Quantity quantity, Nanoseconds time,
                         const QString &value);

/// What is known of an analysis without its series: smoother, height, version.
QStringList analysisInputs(const TrialRecord &trial, const AnalysisRecord &analysis);
/// Of a metric, with its inputs.
Explanation explainMetric(const Metric &metric, const QStringList &inputs);
/// Of a metric of a robot's analysis. An unknown one has only its name and inputs.
Explanation explainMetric(const TrialScene &scene, std::size_t robot, const Metric &metric);
/// Of a flag on a sample of a robot: what was tested, and what happens to the sample.
Explanation explainSpike(const TrialScene &scene, std::size_t robot, const Spike &spike);

} // namespace odo
