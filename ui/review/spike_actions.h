// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/overrule_job.h"
#include "ui/models/trial_scene.h"

#include <QList>
#include <QObject>

class QAction;

namespace odo {

class Timeline;

/// What a person can say about the sample under the cursor: that it is to be used, that it is a spike, or that
/// the program is to decide. Owns the actions; who is asked stores the word and analyses again.
class SpikeActions : public QObject
{
    Q_OBJECT
public:
    explicit SpikeActions(Timeline &timeline, QObject *parent = nullptr);

    void setScene(TrialScenePtr scene);
    /// The robot that is meant where a trial has several; an index into TrialScene::robots.
    void setRobot(std::size_t robot);
    const QList<QAction *> &actions() const { return m_actions; }

Q_SIGNALS:
    void said(const odo::OverruleRequest &word);

private:
    QAction *add(const char *name, const QString &text, const QString &toolTip, const QKeySequence &key,
                 OverruleRequest::Word word);
    void say(OverruleRequest::Word word);
    void update();
    const Sample *sample() const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    std::size_t m_robot = 0;
    QList<QAction *> m_actions;
    QAction *m_use, *m_spike, *m_leave;
};

} // namespace odo
