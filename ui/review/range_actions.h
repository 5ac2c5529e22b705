// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/trials/trial_range.h"
#include "ui/models/trial_scene.h"

#include <QList>
#include <QObject>

class QAction;

namespace odo {

class Timeline;

/// Which part of a trial's time its results are of: it starts or ends at the time that is shown, is that of
/// the motion, or all of it. Owns the actions; who is asked stores the range.
class RangeActions : public QObject
{
    Q_OBJECT
public:
    explicit RangeActions(Timeline &timeline, QObject *parent = nullptr);

    void setScene(TrialScenePtr scene);
    const QList<QAction *> &actions() const { return m_actions; }
    /// Asks for a range, as whole as the time line: for none.
    void request(const TimeSpan &range);

Q_SIGNALS:
    void requested(const odo::RangeChoice &range);

private:
    QAction *add(const char *name, const QString &text, const QString &toolTip, const QKeySequence &key);
    void startHere();
    void endHere();

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    QList<QAction *> m_actions;
    QAction *m_motion, *m_whole;
};

} // namespace odo
