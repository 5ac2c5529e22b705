// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/models/trial_scene.h"
#include "ui/views/trial_curves.h"

#include <QObject>
#include <memory>
#include <vector>

namespace odo {

/// Makes the curves of a chart: at once, or, of a trial so long that the window would have to wait, on a thread of its own. The newest
/// request counts. GUI thread.
class CurveMaker : public QObject
{
    Q_OBJECT
public:
    /// Of more samples than this all together it takes a thread.
    static constexpr std::size_t mostAtOnce = 20'000;

    explicit CurveMaker(QObject *parent = nullptr);
    /// scene: null clears. made() follows where it takes a thread.
    void make(TrialScenePtr scene, Quantity quantity, std::shared_ptr<const SamplePlaces> places);
    /// What was made last; empty while something is being made.
    const TrialCurves &curves() const { return m_curves; }
    bool isRunning() const { return m_wanted != nullptr; }

Q_SIGNALS:
    void made(); ///< on a thread

private:
    struct Request
    {
        TrialScenePtr scene;
        Quantity quantity = Quantity::Speed;
        std::shared_ptr<const SamplePlaces> places;
        TrialCurves curves; ///< once it has run
    };
    void begin();
    void finish();

    TrialCurves m_curves;
    std::shared_ptr<Request> m_wanted;  ///< not told yet; null: nothing
    std::shared_ptr<Request> m_running; ///< is being made; perhaps overtaken
    BackgroundTask m_task;
};

} // namespace odo
