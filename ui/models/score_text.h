// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/scoring.h"
#include "ui/models/explanation.h"
#include "ui/models/figure_text.h"

#include <QString>
#include <QStringList>
#include <optional>

namespace odo {

struct TrialScene;

/// "27 ±1 of 30"
QString scoreText(const Score &score);
/// The same as a large figure, "of 30" in the place of its unit.
FigureText scoreFigure(const Score &score);
/// How a line of a rubric is meant: "30 points at 4 s or less, none at 10 s or more".
QString criterionText(const Criterion &criterion);
/// How a score comes about, a sentence for each line: "Start to finish 5.2 ±0.1 s: 24 ±0.5 of 30 points (…)".
QStringList scoreLines(const Score &score);
/// The bounds of a criterion as people read them: in this unit, so many times the stored number.
struct BoundUnit
{
    QString unit; ///< may be empty
    double factor = 1;
};
BoundUnit boundUnit(const std::string &metric);

/// "How was this computed?" of a score: its lines, then what else went into it, and what its ± is.
Explanation explainScore(const Score &score, const QStringList &inputs = {});

/// What a robot's run in a scene is worth; nullopt: its task is not scored, it was not tracked, or measured
/// by another course.
std::optional<Score> scoreOf(const TrialScene &scene, std::size_t robot);
/// The robot's analysis was measured by another task, or by the task as it was before it was changed.
bool isMeasuredOtherwise(const TrialScene &scene, std::size_t robot);

} // namespace odo
