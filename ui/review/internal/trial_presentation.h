// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"
#include "ui/views/present/present_source.h"

#include <QPointer>

namespace odo {

class FloorMap;
class Timeline;

/// The trial of Review for a presentation. It moves with the same time line. GUI thread.
class TrialPresentation : public PresentSource
{
    Q_OBJECT
public:
    explicit TrialPresentation(Timeline &timeline, QObject *parent = nullptr);
    /// Null: none.
    void setScene(const TrialScenePtr &scene);
    QWidget *makeMap() override;
    PresentedRun run() const override;
    QString speed(std::size_t robot) const override;
    void move(Move how) override;
    bool isSettled() const override;

private:
    PresentedRobot robotAt(std::size_t robot) const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    QPointer<FloorMap> m_map; ///< that was made last
};

} // namespace odo
