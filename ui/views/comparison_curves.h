// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/comparison_scene.h"
#include "ui/views/profile_curve.h"

#include <QList>
#include <vector>

namespace odo {

/// A curve of one run over the distance, in its stretches without gaps; x: metres along the common path.
struct DistanceCurve
{
    struct Stretch
    {
        CurveRun curve;     ///< with its 95 % band
        bool faint = false; ///< within the error
    };
    std::size_t run = 0;
    std::vector<Stretch> stretches;
};

/// What is shown against the distance.
enum class Compared { Speed, TimeDifference };
/// "m/s" or as shown_units.h has it; "s".
QString comparedUnit(Compared what);

/// The speed of every run where it first came to each station, in the unit that is shown.
std::vector<DistanceCurve> speedCurves(const ComparisonScene &scene);
/// How much later each run but the first is, seconds; faint where that is within its error.
std::vector<DistanceCurve> differenceCurves(const ComparisonScene &scene);

std::vector<DistanceCurve> comparedCurves(const ComparisonScene &scene, Compared what);

/// The same at one place; nullopt where a run was not there.
std::optional<CurveValue> speedAt(const ComparisonScene &scene, std::size_t run, double distanceM);
std::optional<CurveValue> differenceAt(const ComparisonScene &scene, std::size_t run, double distanceM);

} // namespace odo
