// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace odo {

class BadgeLabel;
class ElidedLabel;
class PresentSource;

/// A run for a projector: team, map, the speed now and the results, in type that grows with the window. Space
/// plays, the arrows step, F11 fills the screen, Esc closes it. GUI thread.
class PresentWindow : public QWidget
{
    Q_OBJECT
public:
    /// beside: a window of its own, on another screen than this one's if there is one.
    explicit PresentWindow(QWidget &beside);
    /// Shown until it goes or another one comes; null: nothing.
    void setSource(PresentSource *source);
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
    void addRobot(const struct PresentedRobot &robot, bool isNamed);
    void showSpeeds();
    void fitType();

    QWidget &m_beside;
    QPointer<PresentSource> m_source;
    ElidedLabel *m_team, *m_more;
    BadgeLabel *m_badge;
    QHBoxLayout *m_body;
    QWidget *m_map = nullptr;
    QWidget *m_results;
    QVBoxLayout *m_column;
    std::vector<RobotPart> m_robots;
};

} // namespace odo
