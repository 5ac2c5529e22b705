// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/run_presentation.h"

#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/record/internal/live_board.h"
#include "ui/record/internal/run_card.h"

#include <QStringList>
#include <algorithm>

namespace odo {

namespace {

constexpr std::size_t mostRunMetrics = 4;

} // namespace

RunPresentation::RunPresentation(LiveBoard &board, const RunCard &card, QObject *parent)
    : PresentSource(parent), m_board(board), m_card(card)
{
    connect(&card, &RunCard::changed, this, &RunPresentation::changed);
    connect(&card, &RunCard::robotsChanged, this, &RunPresentation::changed);
    connect(&board, &LiveBoard::momentShown, this, &RunPresentation::moved);
}

QWidget *RunPresentation::makeMap()
{
    return m_board.makeMap();
}

PresentedRun RunPresentation::lineUp() const
{
    const NextRun next = m_card.run();
    const QString team = next.team.empty() ? QString() : shownTeam(next.team),
                  trial = QString::fromStdString(next.trial);
    QStringList more;
    if (!team.isEmpty())
        more << trial;
    if (!next.task.empty())
        more << QString::fromStdString(next.task);
    PresentedRun run{team.isEmpty() ? trial : team, more.join(QStringLiteral(" · ")), {}, {}};
    for (const std::string &robot : next.robots)
        run.robots.push_back({QString::fromStdString(robot), shownUnits().speed.name, {}});
    return run;
}

void RunPresentation::begin()
{
    m_hasEnded = false;
    m_last = lineUp();
    Q_EMIT changed();
}

void RunPresentation::setResults(const std::vector<RunResultCard::Result> &results)
{
    const std::size_t most = mostRunMetrics / (m_last.robots.size() > 1 ? 2 : 1);
    for (PresentedRobot &robot : m_last.robots) {
        const auto found = std::ranges::find(results, robot.name, &RunResultCard::Result::robot);
        robot.results.clear();
        if (found == results.end())
            continue;
        for (const Metric &metric : informativeMetrics(found->metrics, most))
            robot.results.emplace_back(metricName(metric.name), metricNumber(metric).text());
    }
    Q_EMIT changed();
}

PresentedRun RunPresentation::run() const
{
    return m_hasEnded ? m_last : lineUp();
}

QString RunPresentation::speed(std::size_t robot) const
{
    const PresentedRun shown = run();
    for (const SeenRobot &seen : m_board.map().robots())
        if (seen.now && seen.now->point.valid &&
            QString::fromStdString(seen.name) == shown.robots[robot].name)
            return presentedSpeed(seen.now->point.speedMps);
    return QStringLiteral("–");
}

} // namespace odo
