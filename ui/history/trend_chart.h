// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/standings.h"

#include <QWidget>

namespace odo {

/// A team's runs through the term: a point each, the line of progress through them, and the band of the
/// spread about it. What it shows is told in words as its accessible description.
class TrendChart : public QWidget
{
    Q_OBJECT
public:
    explicit TrendChart(QWidget *parent = nullptr);
    /// nullptr: no team. name: the team's, as it is shown.
    void setTeam(const TeamStanding *team, const QString &name, const QString &progress);

    QSize sizeHint() const override { return {600, 190}; }
    QSize minimumSizeHint() const override { return {240, 120}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    TeamStanding m_team; ///< of no runs: nothing is shown
    QString m_name;
};

} // namespace odo
