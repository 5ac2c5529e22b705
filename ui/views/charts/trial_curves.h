// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/chart_painting.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/charts/profile_curve.h"

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

namespace odo {

/// A value that stands beside the cursor.
struct ShownValue
{
    std::size_t robot = 0;
    QRectF bubble; ///< where it stands
    QString text;  ///< the value with its error and unit, without a name
};

/// The curves of one quantity of all robots of a trial, for the screen and for whatever else shows them:
/// measured points, lines with their bands, and spikes. A value; painting on any thread.
class TrialCurves
{
public:
    TrialCurves() = default;
    TrialCurves(TrialScenePtr scene, Quantity quantity, const SamplePlaces &places);

    /// Of all curves; 0 to 1 where there is none.
    const ValueRange &range() const { return m_range; }
    /// What was measured of a robot last at a time; nullopt: nothing, or not yet.
    std::optional<CurveValue> valueAt(std::size_t robot, Nanoseconds time) const;

    /// All but the axes; a sentence where no robot was tracked. Spikes beyond the axis are shown at its end.
    void draw(QPainter &painter, const ChartPlot &plot, const QPalette &palette) const;
    /// Each robot's value at a time beside its place on the axis below, where that is visible; gives them,
    /// from above.
    QList<ShownValue> drawValues(QPainter &painter, const ChartPlot &plot, Nanoseconds time,
                                 const std::function<double(std::size_t robot)> &placeOf,
                                 const QPalette &palette) const;

private:
    struct RobotCurves
    {
        std::vector<CurveRun> runs; ///< in order
        QList<QPointF> measured, spikes;
    };
    RobotCurves curvesOf(const Profile &profile, const std::vector<double> &places) const;

    TrialScenePtr m_scene; ///< null: nothing to show
    Quantity m_quantity = Quantity::Speed;
    std::vector<RobotCurves> m_curves; ///< one a robot
    std::vector<int> m_places;         ///< of the robots' colours in the palette
    ValueRange m_range;
};

/// Makes the curves of a chart: at once, or, of a trial so long that the window would have to wait, on a
/// thread of its own. The newest request counts. GUI thread.
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
