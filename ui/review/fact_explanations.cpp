// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/fact_explanations.h"

#include "ui/models/figure_text.h"

#include <QCoreApplication>

namespace odo {

namespace {

class FactExplanationsWords
{
    Q_DECLARE_TR_FUNCTIONS(FactExplanations)
};

struct StepWords
{
    QString formula, uncertainty;
};

/// As core/trajectory/clip_synchronisation.h and flash_synchronisation.h have it.
std::optional<StepWords> stepWords(const std::string &method)
{
    if (method == "auto")
        return StepWords{
            FactExplanationsWords::tr(
                "The offset at which the tracks of the robot on the floor, as the two views see it, "
                "coincide: least squares of "
                "r(t) = p₁(t) − p₂((t − offset)(1 + rate)), with a constant shift and a small scale between "
                "them, searched in half "
                "frames and refined by Gauss–Newton. The clocks' rate is taken where it is beyond three σ."),
            FactExplanationsWords::tr("from the curvature of the sum of squares and the residual, which is "
                                      "taken as correlated over half a second")};
    if (method == "flash")
        return StepWords{
            FactExplanationsWords::tr("The offset at which the jumps of light that both views saw fall "
                                      "together, taken where no other offset comes within a "
                                      "factor of 150 of its likelihood: the pairs' weighted mean."),
            FactExplanationsWords::tr("of the pairs, of their scatter, and a tenth of a frame interval for "
                                      "each view, for its shutter")};
    if (method == "clock")
        return StepWords{FactExplanationsWords::tr("Each camera's time stamps, related to this computer's "
                                                   "clock by readings of the camera's while it recorded."),
                         FactExplanationsWords::tr("of both relations of the clocks")};
    return std::nullopt;
}

} // namespace

Explanation explainPassages(const TrialScene &scene, std::size_t robot, const QString &value)
{
    Explanation told;
    told.what = FactExplanationsWords::tr("Times at the gates");
    told.value = value;
    told.formula =
        FactExplanationsWords::tr("When the robot's centre crosses the gate's line between its ends, the way "
                                  "the gate is passed: between two frames the smoothed "
                                  "position is the cubic through both places and velocities. It has passed "
                                  "when it was before the line by three σ of the "
                                  "track's own noise and then is past it by as much.");
    told.uncertainty = FactExplanationsWords::tr(
        "σ of the position across the gate over the speed across it, with the calibration's part");
    told.inputs = analysisInputs(scene, robot);
    return told;
}

Explanation explainLap(const TrialScene &scene, std::size_t robot, const Lap &lap, const QString &what)
{
    Explanation told;
    told.what = what;
    told.value = figureText(lap.timeS, lap.sigmaS, QStringLiteral("s")).text();
    told.formula = FactExplanationsWords::tr("From one passing of the start to the finish, or of the one "
                                             "gate to the next; of each split its first passing counts.");
    told.uncertainty = FactExplanationsWords::tr(
        "of both passages; the calibration's error of a gate that is passed twice at one speed cancels");
    for (const Sector &sector : lap.sectors)
        told.inputs << FactExplanationsWords::tr("to %1: %2")
                           .arg(QString::fromStdString(sector.gate),
                                figureText(sector.timeS, sector.sigmaS, QStringLiteral("s")).text());
    told.inputs += analysisInputs(scene, robot);
    return told;
}

Explanation explainFigures(const TrialScene &scene, std::size_t robot, const QString &what, const QString &value, const std::string &stem)
{
    Explanation told;
    told.what = what;
    told.value = value;
    QStringList formulas, uncertainties;
    for (const Metric &metric : scene.robots.at(robot).analysis->profile.metrics) {
        if (!metric.name.starts_with(stem))
            continue;
        const Explanation one = explainMetric(metric, {});
        formulas << QStringLiteral("%1: %2").arg(one.what, one.formula);
        if (!one.uncertainty.isEmpty())
            uncertainties << QStringLiteral("%1: %2").arg(one.what, one.uncertainty);
    }
    told.formula = formulas.join(u'\n');
    told.uncertainty = uncertainties.join(u'\n');
    told.inputs = analysisInputs(scene, robot);
    return told;
}

std::optional<Explanation> explainStep(const SceneView &view, const QString &value)
{
    const auto words = stepWords(view.recording.syncMethod);
    if (!words)
        return std::nullopt;
    Explanation told;
    told.what =
        FactExplanationsWords::tr("View %1 in step with the first").arg(QString::fromStdString(view.camera));
    told.value = value;
    told.formula = words->formula;
    told.uncertainty = words->uncertainty;
    told.inputs << FactExplanationsWords::tr("video %1, %2 frames")
                       .arg(QString::fromStdString(view.file.filename().string()))
                       .arg(view.recording.frameTimes.size());
    return told;
}

std::optional<Explanation> explainHeight(const TrialScene &scene, std::size_t robot)
{
    const auto &analysis = scene.robots.at(robot).analysis;
    if (!analysis || !analysis->profile.heightEstimated)
        return std::nullopt;
    Explanation told;
    told.what = FactExplanationsWords::tr("Height of robot %1")
                    .arg(QString::fromStdString(scene.robots[robot].robot.name));
    told.value = lengthText(analysis->profile.heightM);
    told.formula =
        FactExplanationsWords::tr("The solid (box or cylinder, on the floor or a plate at the robot's top) "
                                  "whose silhouettes the outlines in all views are, by weighted "
                                  "least squares at some forty times of the run; where no such solid "
                                  "explains them, the height at which all views put the robot at the "
                                  "same place.");
    told.inputs = analysisInputs(scene, robot);
    return told;
}

} // namespace odo
