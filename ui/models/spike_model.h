// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QAbstractTableModel>

namespace odo {

/// The spikes of all robots of a trial, in order of time.
class SpikeModel : public QAbstractTableModel
{
    Q_OBJECT
public:
    enum Columns { TimeColumn, ReasonColumn, StateColumn, ColumnCount };
    enum Roles {
        TimeRole = Qt::UserRole, ///< qint64 nanoseconds
        SampleIndexRole,         ///< qint64
        RobotRole,               ///< int, index into TrialScene::robots
        FlagsRole,               ///< uint
        RestoredRole,            ///< bool: a person lifted the flag
        SortRole,                ///< for QSortFilterProxyModel
    };

    explicit SpikeModel(QObject *parent = nullptr);
    void setScene(TrialScenePtr scene);
    /// "3 flagged · 1 restored"
    QString summary() const;

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    struct Row
    {
        int robot;
        Spike spike;
        bool restored;
    };
    void addUsedByHand(int robot, const Profile &profile);
    QVariant display(const Row &row, int column) const;

    TrialScenePtr m_scene;
    std::vector<Row> m_rows;
};

} // namespace odo
