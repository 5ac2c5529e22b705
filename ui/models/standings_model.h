// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/standings.h"
#include "ui/models/row_table_model.h"

namespace odo {

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
