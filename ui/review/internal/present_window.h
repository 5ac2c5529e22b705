// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QWidget>
#include <vector>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace odo {

class BadgeLabel;
class ElidedLabel;
class FloorMap;
class Timeline;

/// The trial of Review for a projector: team, map, the speed now and the results, in type that grows with the
/// window. It moves with the same time line. Space plays, the arrows step, F11 fills the screen, Esc closes
/// it. GUI thread.
class PresentWindow : public QWidget
{
    Q_OBJECT
public:
    /// beside: a window of its own, on another screen than this one's if there is one.
    PresentWindow(Timeline &timeline, QWidget &beside);
    /// A null scene clears.
    void setScene(const TrialScenePtr &scene);
    /// Fills a second screen; on the only one it is a window.
    void present();
    bool isSettled() const;

Q_SIGNALS:
    void closed();

protected:
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void closeEvent(QCloseEvent *event) override;

private:
    /// What is shown of a robot.
    struct RobotPart
    {
        QLabel *name, *speed, *unit;
        std::vector<QLabel *> captions, values;
    };
    void fill();
    void addRobot(std::size_t robot);
    void followTime();
    void fitType();

    Timeline &m_timeline;
    QWidget &m_beside;
    TrialScenePtr m_scene;
    ElidedLabel *m_team, *m_trial;
    BadgeLabel *m_verdict;
    FloorMap *m_map;
    QWidget *m_results;
    QVBoxLayout *m_column;
    std::vector<RobotPart> m_robots;
};

} // namespace odo
