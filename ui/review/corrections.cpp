// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/corrections.h"

#include "ui/models/timeline.h"

#include <QAction>
#include <QMenu>
#include <algorithm>

namespace odo {

RobotPointing::RobotPointing(Timeline &timeline, QObject *parent)
    : QObject(parent), m_timeline(timeline), m_action(new QAction(tr("&Point out a robot"), this))
{
    m_action->setObjectName(QStringLiteral("pointOutRobot"));
    m_action->setCheckable(true);
    m_action->setShortcut(Qt::Key_P);
    m_action->setToolTip(tr("Wrong object outlined? Click the robot in a view to track the trial again (%1)")
                             .arg(m_action->shortcut().toString(QKeySequence::NativeText)));
    m_action->setEnabled(false);
    connect(m_action, &QAction::toggled, &m_timeline, &Timeline::pause);
}

RobotPointing::~RobotPointing() = default;

void RobotPointing::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_action->setEnabled(!robots().empty());
    m_action->setChecked(false);
}

std::vector<std::string> RobotPointing::robots() const
{
    std::vector<std::string> names;
    if (!m_scene || !m_scene->imported.empty())
        return names;
    for (const SceneRobot &one : m_scene->robots)
        names.push_back(one.robot.name);
    return names;
}

bool RobotPointing::isPointedOut(const std::string &robot) const
{
    return std::ranges::any_of(m_scene->robots, [&](const SceneRobot &one) {
        return one.robot.name == robot &&
               std::ranges::find(m_scene->pointedOut, one.robot.id, &PointedOutRobot::robot) !=
                   m_scene->pointedOut.end();
    });
}

void RobotPointing::fill(QMenu &menu, std::size_t view, const QPointF &pixel)
{
    const std::vector<std::string> all = robots();
    if (all.empty() || view >= m_scene->views.size())
        return;
    const auto shown = [](const std::string &robot) {
        return QString::fromStdString(robot).replace(u'&', QStringLiteral("&&"));
    };
    for (const std::string &robot : all) {
        const RobotPointer pointer{robot,
                                   m_scene->views[view].camera,
                                   toSeconds(m_timeline.currentTime()),
                                   {pixel.x(), pixel.y()},
                                   true};
        connect(menu.addAction(tr("This is %1: track it again").arg(shown(robot))), &QAction::triggered, this,
                [this, pointer] { request(pointer); });
    }
    menu.addSeparator();
    for (const std::string &robot : all)
        if (isPointedOut(robot))
            connect(menu.addAction(tr("Find %1 automatically").arg(shown(robot))), &QAction::triggered, this,
                    [this, robot] {
                        request({robot, {}});
                    });
}

void RobotPointing::request(RobotPointer pointer)
{
    m_action->setChecked(false);
    Q_EMIT requested(QString::fromStdString(m_scene->trial.name), pointer);
}

SpikeActions::SpikeActions(Timeline &timeline, QObject *parent)
    : QObject(parent), m_timeline(timeline),
      m_use(add("useSample", tr("&Use sample"),
                tr("Mark the sample at this moment as valid and use it, even if it was flagged"), Qt::Key_U,
                OverrideRequest::Word::Valid)),
      m_spike(add("markSpike", tr("Mark as &spike"),
                  tr("Mark the sample at this moment as a spike and do not use it"), Qt::Key_X,
                  OverrideRequest::Word::Spike)),
      m_leave(add("leaveSample", tr("&Automatic"), tr("Remove the manual override at this moment"),
                  Qt::Key_Backspace, OverrideRequest::Word::Clear))
{
    connect(&m_timeline, &Timeline::currentChanged, this, &SpikeActions::update);
    update();
}

QAction *SpikeActions::add(const char *name, const QString &text, const QString &toolTip,
                           const QKeySequence &key, OverrideRequest::Word word)
{
    auto *action = new QAction(text, this);
    action->setObjectName(QString::fromLatin1(name));
    action->setToolTip(QStringLiteral("%1 (%2)").arg(toolTip, key.toString(QKeySequence::NativeText)));
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, [this, word] { request(word); });
    m_actions << action;
    return action;
}

void SpikeActions::setScene(TrialScenePtr scene)
{
    const bool sameTrial = m_scene && scene && m_scene->trial.id == scene->trial.id;
    m_scene = std::move(scene);
    if (!sameTrial || m_robot >= m_scene->robots.size())
        m_robot = 0;
    m_frames.clear();
    update();
}

void SpikeActions::setChosen(const std::vector<std::int64_t> &frames)
{
    m_frames = frames;
    update();
}

void SpikeActions::setRobot(std::size_t robot)
{
    m_robot = robot;
    update();
}

const Sample *SpikeActions::sample() const
{
    return sampleOf(m_timeline.currentFrame());
}

/// The chosen ones, or else that under the cursor.
std::vector<const Sample *> SpikeActions::chosen() const
{
    std::vector<const Sample *> samples;
    if (m_frames.size() < 2)
        samples.push_back(sample());
    else
        std::ranges::transform(m_frames, std::back_inserter(samples),
                               [this](std::int64_t frame) { return sampleOf(frame); });
    std::erase(samples, nullptr);
    return samples;
}

/// Null where nothing was measured that could be judged.
const Sample *SpikeActions::sampleOf(std::int64_t frame) const
{
    if (!m_scene || m_robot >= m_scene->robots.size() || !m_scene->robots[m_robot].analysis)
        return nullptr;
    const auto &samples = m_scene->robots[m_robot].analysis->profile.samples;
    const auto found = std::ranges::lower_bound(samples, frame, {}, &Sample::frame);
    const bool isThere = found != samples.end() && found->frame == frame && found->position;
    return isThere ? &*found : nullptr;
}

void SpikeActions::update()
{
    const std::vector<const Sample *> all = chosen();
    for (const auto &[action, word] :
         {std::pair{m_use, OverrideRequest::Word::Valid}, std::pair{m_spike, OverrideRequest::Word::Spike},
          std::pair{m_leave, OverrideRequest::Word::Clear}})
        action->setEnabled(std::ranges::any_of(
            all, [word = word](const Sample *sample) { return isChangedBy(word, *sample); }));
}

void SpikeActions::request(OverrideRequest::Word word)
{
    std::vector<const Sample *> samples = chosen();
    std::erase_if(samples, [word](const Sample *sample) { return !isChangedBy(word, *sample); });
    if (samples.empty())
        return;
    m_timeline.pause();
    OverrideRequest request{m_scene->trial.name, m_scene->robots[m_robot].robot.name, std::nullopt,
                            samples.front()->frame, word};
    if (samples.size() > 1)
        std::ranges::transform(samples, std::back_inserter(request.frames), &Sample::frame);
    Q_EMIT requested(request);
}

} // namespace odo
