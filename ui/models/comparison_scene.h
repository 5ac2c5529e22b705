// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/run_differences.h"
#include "core/workflow/compare/compare_trials.h"
#include "ui/models/explanation.h"
#include "ui/models/internal/row_table_model.h"
#include "ui/models/trial_scene.h"

#include <QStringList>
#include <memory>
#include <vector>

namespace odo {

/// Everything that Compare shows of its runs: an immutable value, safe to share with any thread.
struct ComparisonScene
{
    CompareSettings settings;          ///< that it was made by
    std::vector<TrialScenePtr> scenes; ///< one a run
    std::vector<std::size_t> robots;   ///< of each run its robot in its scene
    ComparedTrials trials;
    TrialComparison compared;

    std::size_t runCount() const { return scenes.size(); }
    const RobotRecord &robot(std::size_t run) const { return scenes[run]->robots[robots[run]].robot; }
    const Profile &profile(std::size_t run) const { return trials.runs[run].analysis.profile; }
    std::string name(std::size_t run) const { return runName(trials.runs[run]); }
    QStringList names() const; ///< of all runs
    /// The common time, 0 at what counts as the same moment, and a run's own.
    Nanoseconds ownTime(std::size_t run, Nanoseconds common) const;
    Nanoseconds commonTime(std::size_t run, Nanoseconds own) const;
    /// From the earliest frame of all runs to the last one, at the first run's interval: the time line of the
    /// comparison.
    std::vector<Nanoseconds> frameTimes() const;
    /// How far along the common path a run is, distance 0 as in the comparison.
    double distanceAt(std::size_t run, Nanoseconds common) const;
    /// Where a run is; nullopt where it is not known.
    const ProfilePoint *pointAt(std::size_t run, Nanoseconds common) const;
    /// The rectangle of the floor that matters to any of them.
    Eigen::AlignedBox2d floorBounds() const;
};

using ComparisonScenePtr = std::shared_ptr<const ComparisonScene>;

/// Reads and compares, on the project's thread. Errors: those of loadTrialScene, readComparedTrials and
/// compareTrials.
Result<ComparisonScenePtr> loadComparisonScene(Project &project, const CompareSettings &settings);

/// "How was this computed?" of what Compare shows of a run against the first one. run: 1 or more. distances
/// as in the comparison, metres.

/// A row of the metrics: the difference of both runs, and whether it is significant.
Explanation explainDifference(const ComparisonScene &scene, std::size_t run, const MetricDifference &metric);
/// A line of the sectors.
Explanation explainSector(const ComparisonScene &scene, std::size_t run, const SectorTimes &sector);
/// The time difference at a point of the path.
Explanation explainTimeDifference(const ComparisonScene &scene, std::size_t run, double distanceM,
                                  const Difference &difference);
/// A run's speed where it first reached a point of the path; value: as it is shown. run: 0 or more.
Explanation explainSpeedOverDistance(const ComparisonScene &scene, std::size_t run, double distanceM,
                                     const QString &value);

/// Metrics of two runs side by side with their difference: a row a metric or a sector. Differences that are
/// not significant are muted, and say so in words.
class DifferenceModel : public RowTableModel
{
    Q_OBJECT
public:
    enum Columns { NameColumn, FirstColumn, SecondColumn, DifferenceColumn, ColumnCount };
    enum Roles {
        SignificantRole = Qt::UserRole, ///< bool; false also where there is nothing to compare
    };

    explicit DifferenceModel(QObject *parent = nullptr);
    void setMetrics(const std::vector<MetricDifference> &metrics);
    /// Of a run against the first one.
    void setSectors(const std::vector<SectorTimes> &sectors, std::size_t run);
    /// Above the columns of the two runs.
    void setRunNames(const QString &first, const QString &second);

private:
    int rows() const override { return static_cast<int>(m_rows.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    struct Row
    {
        QString name, first, second, difference;
        bool isCompared = false, isSignificant = false;
    };
    void setRows(std::vector<Row> rows);

    std::vector<Row> m_rows;
    QString m_first, m_second;
};

} // namespace odo
