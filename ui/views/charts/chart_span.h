// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/charts/chart_axis.h"

#include <QList>
#include <memory>
#include <vector>

class QAction;

namespace odo {

class Timeline;

/// Where each sample of each robot lies on the axis below, a list a robot; they never fall. Empty for a robot
/// that was not tracked.
using SamplePositions = std::vector<std::vector<double>>;

/// What of a run the charts of a page show: against the time (seconds) or against the distance travelled
/// (metres), and from where to where. One for all charts of a page, so they line up below one another. When
/// the shared time leaves what is visible, it follows. GUI thread.
class ChartSpan : public AxisSpan
{
    Q_OBJECT
public:
    enum class Against { Time, Distance };

    explicit ChartSpan(Timeline &timeline, QObject *parent = nullptr);

    /// Shows all of it, unless it is the scene that is shown.
    void setScene(TrialScenePtr scene);
    const TrialScenePtr &scene() const { return m_scene; }
    Against against() const { return m_against; }
    void setAgainst(Against against);

    const std::shared_ptr<const SamplePositions> &positions() const { return m_positions; }
    /// Where a robot is at a time, straight between its samples; of one that was not tracked the time itself,
    /// or 0.
    double positionOf(std::size_t robot, Nanoseconds time) const;
    /// The cursor's position: that of the first robot that was tracked.
    double cursorPosition(Nanoseconds time) const;
    /// The time at which the cursor is at a position; if the robot stops there, when it arrived.
    Nanoseconds timeAt(double position) const;

    /// To show less, more, all, and to change what is below: with words and keys, for menus and pages.
    QList<QAction *> actions() const { return m_actions; }

Q_SIGNALS:
    void axisChanged(); ///< the positions
private:
    void makeActions();
    void makePositions();
    void followTime();
    std::size_t firstTracked() const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    Against m_against = Against::Time;
    std::shared_ptr<const SamplePositions> m_positions = std::make_shared<SamplePositions>();
    QList<QAction *> m_actions;
    QAction *m_distance = nullptr;
};

} // namespace odo
