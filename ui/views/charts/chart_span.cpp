// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/chart_span.h"

#include "core/analysis/motion_stretches.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/trial_curves.h"

#include <QAction>
#include <algorithm>
#include <cmath>

namespace odo {
namespace {
constexpr double keyStep = 1.5;
} // namespace

ChartSpan::ChartSpan(Timeline &timeline, QObject *parent) : AxisSpan(parent), m_timeline(timeline)
{
    makeActions();
    connect(&m_timeline, &Timeline::currentChanged, this, &ChartSpan::followTime);
}

void ChartSpan::makeActions()
{
    const auto add = [this](const QString &name, const QString &text, const QKeySequence &key) {
        auto *action = new QAction(text, this);
        action->setObjectName(name);
        action->setShortcut(key);
        m_actions << action;
        return action;
    };
    const auto about = [this] { return std::clamp(cursorPosition(m_timeline.currentTime()), low(), high()); };
    connect(add(QStringLiteral("zoomIn"), tr("Charts: show &less"), QKeySequence(Qt::CTRL | Qt::Key_Plus)),
            &QAction::triggered, this, [this, about] { zoom(keyStep, about()); });
    connect(add(QStringLiteral("zoomOut"), tr("Charts: show &more"), QKeySequence(Qt::CTRL | Qt::Key_Minus)),
            &QAction::triggered, this, [this, about] { zoom(1 / keyStep, about()); });
    connect(add(QStringLiteral("zoomAll"), tr("Charts: show &all"), QKeySequence(Qt::CTRL | Qt::Key_0)),
            &QAction::triggered, this, [this] { showAll(); });
    m_distance = add(QStringLiteral("againstDistance"), tr("Charts over &distance"), QKeySequence(Qt::Key_D));
    m_distance->setCheckable(true);
    connect(m_distance, &QAction::toggled, this,
            [this](bool on) { setAgainst(on ? Against::Distance : Against::Time); });
}

void ChartSpan::setScene(TrialScenePtr scene)
{
    if (scene == m_scene)
        return;
    m_scene = std::move(scene);
    makePositions();
}

void ChartSpan::setAgainst(Against against)
{
    m_distance->setChecked(against == Against::Distance);
    if (against == m_against)
        return;
    m_against = against;
    makePositions();
}

void ChartSpan::makePositions()
{
    auto all = std::make_shared<SamplePositions>();
    double from = 0, to = 0;
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        std::vector<double> positions;
        if (const auto &analysis = m_scene->robots[robot].analysis) {
            const Profile &profile = analysis->profile;
            positions = m_against == Against::Distance ? distanceTravelled(profile.samples, profile.points)
                                                       : sampleTimes(profile);
            if (m_against == Against::Distance && !positions.empty())
                to = std::max(to, positions.back());
        }
        all->push_back(std::move(positions));
    }
    m_positions = std::move(all);
    if (m_against == Against::Time && m_scene && !m_scene->frameTimes().empty()) {
        from = toSeconds(m_scene->frameTimes().front());
        to = toSeconds(m_scene->frameTimes().back());
    }
    setWhole(from, to);
    Q_EMIT axisChanged();
}

void ChartSpan::followTime()
{
    if (showsAll())
        return;
    const double position = cursorPosition(m_timeline.currentTime()), width = high() - low();
    if (position > high())
        show(position - 0.1 * width, position + 0.9 * width);
    else if (position < low())
        show(position - 0.9 * width, position + 0.1 * width);
}

std::size_t ChartSpan::firstTracked() const
{
    const auto tracked =
        std::find_if(m_positions->begin(), m_positions->end(),
                     [](const std::vector<double> &positions) { return !positions.empty(); });
    return static_cast<std::size_t>(tracked - m_positions->begin());
}

double ChartSpan::positionOf(std::size_t robot, Nanoseconds time) const
{
    if (m_against == Against::Time)
        return toSeconds(time);
    if (robot >= m_positions->size() || m_positions->at(robot).empty())
        return 0;
    const std::vector<double> &positions = m_positions->at(robot);
    const std::vector<Sample> &samples = m_scene->robots[robot].analysis->profile.samples;
    const auto after =
        std::upper_bound(samples.begin(), samples.end(), time,
                         [](Nanoseconds wanted, const Sample &sample) { return wanted < sample.time; });
    if (after == samples.begin())
        return positions.front();
    if (after == samples.end())
        return positions.back();
    const auto i = static_cast<std::size_t>(after - samples.begin());
    const double part =
        toSeconds(time - samples[i - 1].time) / toSeconds(samples[i].time - samples[i - 1].time);
    return std::lerp(positions[i - 1], positions[i], part);
}

double ChartSpan::cursorPosition(Nanoseconds time) const
{
    return positionOf(firstTracked(), time);
}

Nanoseconds ChartSpan::timeAt(double position) const
{
    const std::size_t robot = firstTracked();
    if (m_against == Against::Time || robot >= m_positions->size())
        return fromSeconds(position);
    const std::vector<double> &positions = m_positions->at(robot);
    const auto at = std::lower_bound(positions.begin(), positions.end(), position);
    const auto index = std::min(at - positions.begin(), static_cast<std::ptrdiff_t>(positions.size()) - 1);
    return m_scene->robots[robot].analysis->profile.samples[static_cast<std::size_t>(index)].time;
}

} // namespace odo
