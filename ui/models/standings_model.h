// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/standings.h"

#include <QAbstractTableModel>

namespace odo {

/// The teams in their order, with best, median, repeatability and progress in words. GUI thread.
class StandingsModel : public QAbstractTableModel
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

    int rowCount(const QModelIndex &parent = {}) const override;
    int columnCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

private:
    QString display(const TeamStanding &team, int row, int column) const;

    Standings m_standings;
};

/// Whether a team got better through the term, in words.
QString progressText(const TeamStanding &team, const Standings &standings);

} // namespace odo
