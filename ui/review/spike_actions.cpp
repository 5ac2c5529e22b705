// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/spike_actions.h"

#include "ui/models/timeline.h"

#include <QAction>
#include <algorithm>

namespace odo {

SpikeActions::SpikeActions(Timeline &timeline, QObject *parent)
    : QObject(parent), m_timeline(timeline),
      m_use(add("useSample", tr("&Use sample"),
                tr("What was measured at this moment is right and is to be used, whatever speaks against it"),
                Qt::Key_U, OverruleRequest::Word::Valid)),
      m_spike(add("markSpike", tr("Mark as &spike"),
                  tr("What was measured at this moment is wrong and is not to be used"), Qt::Key_X,
                  OverruleRequest::Word::Spike)),
      m_leave(add("leaveSample", tr("&Automatic"), tr("Takes back what was said by hand at this moment"),
                  Qt::Key_Backspace, OverruleRequest::Word::Clear))
{
    connect(&m_timeline, &Timeline::currentChanged, this, &SpikeActions::update);
    update();
}

QAction *SpikeActions::add(const char *name, const QString &text, const QString &toolTip, const QKeySequence &key,
                           OverruleRequest::Word word)
{
    auto *action = new QAction(text, this);
    action->setObjectName(QString::fromLatin1(name));
    action->setToolTip(QStringLiteral("%1 (%2)").arg(toolTip, key.toString(QKeySequence::NativeText)));
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, [this, word] { say(word); });
    m_actions << action;
    return action;
}

void SpikeActions::setScene(TrialScenePtr scene)
{
    const bool sameTrial = m_scene && scene && m_scene->trial.id == scene->trial.id;
    m_scene = std::move(scene);
    if (!sameTrial || m_robot >= m_scene->robots.size())
        m_robot = 0;
    update();
}

void SpikeActions::setRobot(std::size_t robot)
{
    m_robot = robot;
    update();
}

/// Null where nothing was measured that could be judged.
const Sample *SpikeActions::sample() const
{
    if (!m_scene || m_robot >= m_scene->robots.size() || !m_scene->robots[m_robot].analysis)
        return nullptr;
    const auto &samples = m_scene->robots[m_robot].analysis->profile.samples;
    const auto found = std::ranges::lower_bound(samples, std::int64_t(m_timeline.currentFrame()), {}, &Sample::frame);
    const bool isThere = found != samples.end() && found->frame == m_timeline.currentFrame() && found->position;
    return isThere ? &*found : nullptr;
}

void SpikeActions::update()
{
    const Sample *here = sample();
    m_use->setEnabled(here && isRejected(here->flags));
    m_spike->setEnabled(here && !isRejected(here->flags));
    m_leave->setEnabled(here && hasFlag(here->flags, SampleFlag::ByHand));
}

void SpikeActions::say(OverruleRequest::Word word)
{
    const Sample *here = sample();
    if (!here)
        return;
    m_timeline.pause();
    Q_EMIT said({m_scene->trial.name, m_scene->robots[m_robot].robot.name, std::nullopt, here->frame, word});
}

} // namespace odo
