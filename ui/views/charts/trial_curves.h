// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "ui/models/background_task.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/curves/chart_content.h"

#include <QList>
#include <QObject>
#include <QRectF>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QPainter;
class QPalette;

namespace odo {

/// A value beside the cursor.
struct ShownValue
{
    std::size_t robot = 0;
    QRectF bubble; ///< its position
    QString text;  ///< the value with its ± and unit, without a name
};

/// The curves of one quantity of all robots of a trial, for the screen and for whatever else shows them:
/// measured points, lines with their bands, and spikes; a robot is a group. A value; any thread.
class TrialCurves
{
public:
    TrialCurves() = default;
    /// withOutside: over the time, what is outside of the trial's range too, muted and without a band.
    TrialCurves(TrialScenePtr scene, Quantity quantity, const SamplePositions &positions,
                bool withOutside = false);

    /// What a chart shows; nullptr without a scene.
    const ChartContentPtr &content() const { return m_content; }
    /// Each robot's value at a time beside its position on the axis below, where that is visible (not a
    /// number: nowhere); gives them, from above.
    QList<ShownValue> drawValues(QPainter &painter, const ChartPlot &plot, Nanoseconds time,
                                 const std::function<double(std::size_t robot)> &positionOf,
                                 const QPalette &palette) const;

private:
    /// What was measured of a robot last at a time; nullopt: nothing, or not yet.
    std::optional<CurveValue> valueAt(std::size_t robot, Nanoseconds time) const;

    TrialScenePtr m_scene; ///< null: nothing to show
    Quantity m_quantity = Quantity::Speed;
    ChartContentPtr m_content;
    std::vector<std::vector<const ChartCurve *>> m_lines; ///< of the content, those of each robot
    std::vector<int> m_positions;                         ///< of the robots' colours in the palette
};

/// Makes the curves of a chart: at once, or, of a trial so long that the window would have to wait, on a
/// thread of its own. The newest request counts. GUI thread.
class CurveMaker : public QObject
{
    Q_OBJECT
public:
    /// For more samples than this in total it takes a thread.
    static constexpr std::size_t mostAtOnce = 20'000;

    explicit CurveMaker(QObject *parent = nullptr);
    /// scene: null clears. made() follows where it takes a thread.
    void make(TrialScenePtr scene, Quantity quantity, std::shared_ptr<const SamplePositions> positions,
              bool withOutside = false);
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
        std::shared_ptr<const SamplePositions> positions;
        bool withOutside = false;
        TrialCurves curves; ///< once it has run
    };
    void begin();
    void finish();

    TrialCurves m_curves;
    std::shared_ptr<Request> m_wanted;  ///< not delivered yet; null: nothing
    std::shared_ptr<Request> m_running; ///< is being made; perhaps overtaken
    BackgroundTask m_task;
};

/// quantityValues in the unit that people read (curveUnit).
std::vector<std::optional<CurveValue>> curveValues(const Profile &profile, Quantity quantity,
                                                   OtherProfiles others = {});
/// What was measured of the other robots of a trial. They are the scene's.
std::vector<const Profile *> otherProfiles(const TrialScene &scene, std::size_t robot);
/// "m/s", "m/s²", "mm" or as shown_units.h has it; "°", "°/s".
QString curveUnit(Quantity quantity);
/// By how much a value in SI is multiplied for curveUnit.
double curveFactor(Quantity quantity);

/// When each sample was taken, in seconds: its position if the axis below is the time.
std::vector<double> sampleTimes(const Profile &profile);

/// From the lowest to the highest value of the lines among curves, with their bands as long as those do not
/// press the lines flat; 0 is contained unless they are positions.
ValueRange valueRange(const std::vector<ChartCurve> &curves, Quantity quantity);

/// measuredValues at the positions of the samples, in the unit of curveUnit, without bands; empty where
/// nothing but noise could be shown.
CurveRun measuredPoints(const Profile &profile, Quantity quantity, const std::vector<double> &positions);

/// The spikes of a curve of speed, where they were measured or else where the curve is; empty for every other
/// quantity.
CurveRun spikePoints(const Profile &profile, Quantity quantity, const std::vector<double> &positions);

/// The robot's curve of a quantity as a chart shows it, in a palette colour and the dash of the group, dotted
/// where it is bridged; and its measured points (beneath) and spikes (above), of the same group.
struct ProfileCurves
{
    ChartCurve measured, bridged, line, spikes;
};
ProfileCurves profileCurves(const Profile &profile, Quantity quantity, const std::vector<double> &positions,
                            int group = 0, int position = 0, OtherProfiles others = {});

} // namespace odo
