// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/range_actions.h"

#include "ui/models/timeline.h"

#include <QAction>
#include <QKeySequence>
#include <algorithm>

namespace odo {

RangeActions::RangeActions(Timeline &timeline, QObject *parent) : QObject(parent), m_timeline(timeline)
{
    connect(add("trialStart", tr("Set &start here"),
                tr("The results are of the run from this time on; before it nothing counts."), Qt::Key_I),
            &QAction::triggered, this, &RangeActions::startHere);
    connect(add("trialEnd", tr("Set &end here"),
                tr("The results are of the run up to this time; after it nothing counts."), Qt::Key_O),
            &QAction::triggered, this, &RangeActions::endHere);
    m_motion = add("trialMotion", tr("From first to last &motion"),
                   tr("The results are of the run from when a robot first moves to when it last does."), {});
    connect(m_motion, &QAction::triggered, this, [this] { Q_EMIT requested(RangeOfMotion()); });
    m_whole = add("wholeRun", tr("&Whole run"), tr("The results are of all of the trial again."), {});
    connect(m_whole, &QAction::triggered, this, [this] { Q_EMIT requested(WholeRun()); });
    setScene(nullptr);
}

QAction *RangeActions::add(const char *name, const QString &text, const QString &toolTip,
                           const QKeySequence &key)
{
    auto *action = new QAction(text, this);
    action->setObjectName(QString::fromLatin1(name));
    action->setToolTip(toolTip);
    action->setShortcut(key);
    m_actions << action;
    return action;
}

void RangeActions::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    const bool isTracked = m_scene && std::ranges::any_of(m_scene->robots, [](const SceneRobot &robot) {
                               return robot.analysis.has_value();
                           });
    for (QAction *action : std::as_const(m_actions))
        action->setEnabled(m_scene && !m_scene->trial.unfinished);
    m_motion->setEnabled(m_motion->isEnabled() && isTracked);
    m_whole->setEnabled(m_whole->isEnabled() && m_scene->trial.range);
}

void RangeActions::request(const TimeSpan &range)
{
    if (range.begin <= m_timeline.startTime() && range.end >= m_timeline.endTime())
        Q_EMIT requested(WholeRun());
    else
        Q_EMIT requested(RangeSeconds{toSeconds(range.begin), toSeconds(range.end)});
}

/// Up to the end that it had, unless that has passed.
void RangeActions::startHere()
{
    const Nanoseconds now = m_timeline.currentTime();
    const Nanoseconds end = rangeOf(m_scene->trial).end;
    request({now, now < end ? end : m_timeline.endTime()});
}

void RangeActions::endHere()
{
    const Nanoseconds now = m_timeline.currentTime();
    const Nanoseconds start = rangeOf(m_scene->trial).begin;
    request({start < now ? start : m_timeline.startTime(), now});
}

} // namespace odo
