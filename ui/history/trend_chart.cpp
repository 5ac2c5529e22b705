// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/trend_chart.h"

#include "ui/views/chart_painting.h"
#include "ui/views/chart_picture.h"
#include "ui/views/theme.h"
#include "ui/views/trend_painting.h"

#include <QPainter>

namespace odo {
TrendChart::TrendChart(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Progress of the team"));
    setFocusPolicy(Qt::StrongFocus);
    new ChartPicture(*this, [this] { return PictureHeading{accessibleName(), {m_name}, {}}; });
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void TrendChart::setTeam(const TeamStanding *team, const QString &name, const QString &progress)
{
    m_team = team ? *team : TeamStanding();
    m_name = name;
    setAccessibleDescription(
        team ? tr("%1: %2 trials, progress: %3").arg(name).arg(team->runs.size()).arg(progress)
             : tr("No team is selected"));
    update();
}

void TrendChart::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setFont(font());
    if (!m_team.runs.empty()) {
        drawTrend(painter, rect(), m_team, palette());
    } else {
        painter.setPen(ThemeColours::of(palette()).muted);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Select a team to see its trials through the term."));
    }
    drawChartFocus(painter, *this);
}

} // namespace odo
