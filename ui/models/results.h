// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/profile.h"
#include "core/analysis/scoring.h"
#include "core/workflow/compare/trial_metrics.h"
#include "ui/models/explanation.h"
#include "ui/models/internal/row_table_model.h"
#include "ui/models/number_text.h"

#include <QString>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// This many metrics of a run, the most informative first: the time of the task before all; others fill up
/// the rest.
std::vector<Metric> informativeMetrics(const std::vector<Metric> &all, std::size_t count);

/// Names of metrics in that order.
std::vector<std::string> informativeMetricNames(const std::vector<std::string> &names);

struct TrialScene;

/// "27 ±1 of 30"
QString scoreText(const Score &score);
/// The same as a large value, with "of 30" instead of its unit.
NumberText scoreNumber(const Score &score);
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

/// The teams in their order, with best, median, repeatability and progress in words. GUI thread.
class StandingsModel : public RowTableModel
{
    Q_OBJECT
public:
    enum Columns {
        RankColumn,
        TeamColumn,
        ClassColumn,
        RunsColumn,
        BestColumn,
        MedianColumn,
        SpreadColumn,
        ProgressColumn,
        ColumnCount
    };

    explicit StandingsModel(QObject *parent = nullptr);
    void setStandings(Standings standings);
    const TeamStanding &team(int row) const { return m_standings.teams.at(static_cast<std::size_t>(row)); }
    const Standings &standings() const { return m_standings; }
    QString teamName(int row) const;

private:
    int rows() const override { return static_cast<int>(m_standings.teams.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    QString display(const TeamStanding &team, int row, int column) const;

    Standings m_standings;
};

/// Whether a team got better through the term, in words.
QString progressText(const TeamStanding &team, const Standings &standings);

} // namespace odo
