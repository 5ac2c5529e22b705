// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/trial_presentation.h"

#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_names.h"
#include "ui/models/timeline.h"
#include "ui/models/verdict_mark.h"
#include "ui/views/map/floor_map.h"

#include <QStringList>

namespace odo {

namespace {

constexpr std::size_t mostMetrics = 4;

} // namespace

TrialPresentation::TrialPresentation(Timeline &timeline, QObject *parent)
    : PresentSource(parent), m_timeline(timeline)
{
    connect(&m_timeline, &Timeline::currentChanged, this, &TrialPresentation::moved);
}

void TrialPresentation::setScene(const TrialScenePtr &scene)
{
    m_scene = scene;
    if (m_map)
        m_map->setScene(scene);
    Q_EMIT changed();
}

QWidget *TrialPresentation::makeMap()
{
    m_map = new FloorMap(m_timeline);
    m_map->setScene(m_scene);
    return m_map;
}

bool TrialPresentation::isSettled() const
{
    return !m_map || m_map->isSettled();
}

PresentedRun TrialPresentation::run() const
{
    if (!m_scene)
        return {};
    const QString team = shownTeam(m_scene->trial), trial = QString::fromStdString(m_scene->trial.name);
    QStringList more;
    if (!team.isEmpty())
        more << trial;
    if (m_scene->task)
        more << QString::fromStdString(m_scene->trial.task);
    PresentedRun run{team.isEmpty() ? trial : team, more.join(QStringLiteral(" · ")), {}, {}};
    if (m_scene->verdict.level() != CheckLevel::Pass)
        run.badge = verdictBadge(m_scene->verdict);
    for (std::size_t robot = 0; robot < m_scene->robots.size(); ++robot)
        run.robots.push_back(robotAt(robot));
    return run;
}

PresentedRobot TrialPresentation::robotAt(std::size_t robot) const
{
    const SceneRobot &shown = m_scene->robots[robot];
    PresentedRobot presented{QString::fromStdString(shown.robot.name), shownUnits().speed.name, {}};
    if (const auto score = scoreOf(*m_scene, robot))
        presented.results.emplace_back(metricName("score"), scoreNumber(*score).text());
    if (!shown.analysis) {
        presented.unit = tr("Not tracked yet");
        return presented;
    }
    const std::size_t most = mostMetrics / (m_scene->robots.size() > 1 ? 2 : 1);
    for (const Metric &metric : informativeMetrics(shown.analysis->profile.metrics, most))
        presented.results.emplace_back(metricName(metric.name), metricNumber(metric).text());
    return presented;
}

QString TrialPresentation::speed(std::size_t robot) const
{
    const auto &analysis = m_scene->robots[robot].analysis;
    if (!analysis)
        return {};
    const Nanoseconds time = m_timeline.currentTime();
    const Profile &profile = partAt(*analysis, time);
    const std::ptrdiff_t index = pointIndexAt(profile, time);
    const bool isKnown = index >= 0 && profile.points[static_cast<std::size_t>(index)].valid;
    return isKnown ? presentedSpeed(profile.points[static_cast<std::size_t>(index)].speedMps)
                   : QStringLiteral("–");
}

void TrialPresentation::move(Move how)
{
    if (how == Move::Play)
        m_timeline.toggle();
    else
        m_timeline.step(how == Move::Back ? -1 : 1);
}

} // namespace odo
