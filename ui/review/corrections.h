// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/reanalysis.h"
#include "core/workflow/track/track_job.h"
#include "ui/models/trial_scene.h"

#include <QList>
#include <QObject>

class QAction;
class QMenu;
class QPointF;

namespace odo {

class Timeline;

/// Where the tracker took something else for a robot, or lost it, the user points the robot out in an image,
/// in as many frames as needed: by a click after the action, or by the context menu at any time. The receiver
/// of the signal tracks the trial again.
class RobotPointing : public QObject
{
    Q_OBJECT
public:
    explicit RobotPointing(Timeline &timeline, QObject *parent = nullptr);
    ~RobotPointing() override;

    void setScene(TrialScenePtr scene);
    QAction *action() const { return m_action; } ///< checked while it waits for a click
    /// What may be said of a pixel of a view's recording at the present time; empty: nothing.
    void fill(QMenu &menu, std::size_t view, const QPointF &pixel);

Q_SIGNALS:
    void requested(const QString &trial, const odo::RobotPointer &pointer);

private:
    std::vector<std::string> robots() const;
    bool isPointedOut(const std::string &robot) const;
    void request(RobotPointer pointer);

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    QAction *m_action;
};

/// What a person can say about the sample under the cursor, or about several that are chosen: that it is to
/// be used, that it is a spike, or that the program is to decide. Owns the actions; who is asked stores the
/// word and analyses again.
class SpikeActions : public QObject
{
    Q_OBJECT
public:
    explicit SpikeActions(Timeline &timeline, QObject *parent = nullptr);

    void setScene(TrialScenePtr scene);
    /// The robot that is meant where a trial has several; an index into TrialScene::robots.
    void setRobot(std::size_t robot);
    /// Samples of that robot, by their frames of the first view; fewer than two: the one under the cursor.
    void setChosen(const std::vector<std::int64_t> &frames);
    const QList<QAction *> &actions() const { return m_actions; }

Q_SIGNALS:
    void requested(const odo::OverrideRequest &word);

private:
    QAction *add(const char *name, const QString &text, const QString &toolTip, const QKeySequence &key,
                 OverrideRequest::Word word);
    void request(OverrideRequest::Word word);
    void update();
    const Sample *sample() const;
    const Sample *sampleOf(std::int64_t frame) const;
    std::vector<const Sample *> chosen() const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    std::size_t m_robot = 0;
    std::vector<std::int64_t> m_frames; ///< that are chosen
    QList<QAction *> m_actions;
    QAction *m_use, *m_spike, *m_leave;
};

} // namespace odo
