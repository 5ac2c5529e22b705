// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/trajectory/view_disagreement.h"
#include "ui/models/explanation.h"
#include "ui/models/internal/row_table_model.h"
#include "ui/models/trial_scene.h"

#include <QString>
#include <optional>
#include <vector>

namespace odo {

/// A stretch of a trial in which less than usual is known of a robot, and why.
struct UncertainInterval
{
    /// Name: which of several robots it is. Occlusion: a view did not measure all of it. Gap: nothing was
    /// measured of it, and nothing is assumed.
    enum class Kind { Name, Occlusion, Gap };

    std::size_t robot = 0; ///< index into TrialScene::robots
    TimeSpan span;
    Kind kind = Kind::Name;
    QString reason;   ///< "hidden behind Blue 1 in view A"; for an ambiguous name, until when
    QString sentence; ///< "Red 2: hidden behind Blue 1 in view A (3.20 s to 3.90 s)"
};

/// "hidden behind Blue 1 in view A (3.20 s to 3.90 s)", in the language of the windows.
QString occlusionText(const Occlusion &occlusion);
/// Of all robots, in order of time; in the language of the windows.
std::vector<UncertainInterval> uncertainIntervals(const TrialScene &scene);
/// Tool tip for the intervals at or near a time; empty: none.
QString uncertaintyTextAt(const std::vector<UncertainInterval> &stretches, Nanoseconds time,
                          Nanoseconds reach = Nanoseconds{0});

/// Of each robot of a scene; no positions where it was not tracked. Pure, any thread; a millisecond for a
/// thousand frames.
std::vector<ViewDisagreement> disagreementsOf(const TrialScene &scene);

/// "RMS 3.2 mm, median 2.5 mm" and what the stated errors let expect, in two lines.
QString disagreementWords(const ViewDisagreement &disagreement);

Explanation explainDisagreement(const TrialScene &scene, std::size_t robot,
                                const ViewDisagreement &disagreement);

/// The spikes of all robots of a trial, and the stretches in which less than usual is known of one, in order
/// of time.
class SpikeModel : public RowTableModel
{
    Q_OBJECT
public:
    enum Columns { TimeColumn, ReasonColumn, StateColumn, ColumnCount };
    enum Roles {
        TimeRole = Qt::UserRole, ///< qint64 nanoseconds
        SampleIndexRole,         ///< qint64; −1 of a stretch
        RobotRole,               ///< int, index into TrialScene::robots
        FlagsRole,               ///< uint
        RestoredRole,            ///< bool: a person lifted the flag
        SortRole,                ///< for QSortFilterProxyModel
    };

    explicit SpikeModel(QObject *parent = nullptr);
    void setScene(TrialScenePtr scene);
    /// "3 flagged · 1 restored · 2 ambiguous · 1 hidden · 1 not measured"
    QString summary() const;

private:
    int rows() const override { return static_cast<int>(m_rows.size()); }
    QVariant cell(int index, int column, int role) const override;
    QVariant heading(int column, int role) const override;
    struct Row
    {
        int robot = 0;
        Spike spike;
        bool restored = false;
        std::optional<UncertainInterval> stretch = {}; ///< then the spike is its beginning alone
    };
    void addStretches();
    qsizetype stretchesOf(UncertainInterval::Kind kind) const;
    void addUsedByHand(int robot, const Profile &profile);
    QVariant display(const Row &row, int column) const;

    TrialScenePtr m_scene;
    std::vector<Row> m_rows;
};

} // namespace odo
