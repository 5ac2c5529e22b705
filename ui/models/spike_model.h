// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/doubtful_stretches.h"
#include "ui/models/row_table_model.h"

#include <optional>

namespace odo {

/// The spikes of all robots of a trial, and the stretches in which less than usual is known of one, in order of time.
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
    /// "3 flagged · 1 restored · 2 doubtful · 1 hidden"
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
        std::optional<DoubtfulStretch> stretch = {}; ///< then the spike is its beginning alone
    };
    void addStretches();
    qsizetype stretchesOf(DoubtfulStretch::Kind kind) const;
    void addUsedByHand(int robot, const Profile &profile);
    QVariant display(const Row &row, int column) const;

    TrialScenePtr m_scene;
    std::vector<Row> m_rows;
};

} // namespace odo
