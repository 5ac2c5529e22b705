// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/explanation.h"

#include "core/analysis/metric_table.h"
#include "core/analysis/task_metrics.h"
#include "core/video/frame_times.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

namespace odo {

namespace {

class AnalysisWords
{
    Q_DECLARE_TR_FUNCTIONS(AnalysisWords)
};

QString millisecondText(double seconds)
{
    return AnalysisWords::tr("%1 ms").arg(QLocale().toString(seconds * 1e3, 'f', 1));
}

QString begunText(double offsetS)
{
    return offsetS < 0 ? AnalysisWords::tr("started %1 earlier").arg(millisecondText(-offsetS))
                       : AnalysisWords::tr("started %1 later").arg(millisecondText(offsetS));
}

} // namespace

QString smootherText(Smoother smoother)
{
    switch (smoother) {
    case Smoother::Rts:
        return AnalysisWords::tr("Kalman/RTS, noise from the data");
    case Smoother::SavGol:
        return AnalysisWords::tr("Savitzky–Golay, cubic, 11 points");
    case Smoother::Tracker:
        return AnalysisWords::tr("differences as in Tracker");
    case Smoother::None:
        break;
    }
    return AnalysisWords::tr("none: raw differences");
}

QString stepText(const RecordingRecord &view)
{
    const QString sigma = millisecondText(view.startOffsetSigmaS), begun = begunText(view.startOffsetS);
    if (view.syncMethod == "told")
        return AnalysisWords::tr("%1, set by hand").arg(begun);
    QString text;
    if (view.syncMethod == "auto")
        text = AnalysisWords::tr("synchronised to %1 by the motion; %2").arg(sigma, begun);
    else if (view.syncMethod == "flash")
        text = AnalysisWords::tr("synchronised to %1 by a flash of light; %2").arg(sigma, begun);
    else if (view.syncMethod == "audio")
        text = AnalysisWords::tr("synchronised to %1 by sound; %2").arg(sigma, begun);
    else if (view.syncMethod == "clock")
        text = AnalysisWords::tr("synchronised to %1 by the cameras' time stamps; %2").arg(sigma, begun);
    else
        return AnalysisWords::tr("assumed to start at the same time");
    if (view.clockRate != 0)
        text += view.clockRate > 0
                    ? AnalysisWords::tr(", clock %1 ppm fast").arg(std::lround(view.clockRate * 1e6))
                    : AnalysisWords::tr(", clock %1 ppm slow").arg(std::lround(-view.clockRate * 1e6));
    return text;
}

QString unevenText(const RecordingRecord &view)
{
    const auto uneven = unevenRate(view.frameTimes);
    const auto ms = [](Nanoseconds interval) {
        return QLocale().toString(toSeconds(interval) * 1e3, 'f', 0);
    };
    return uneven ? AnalysisWords::tr("%1 to %2 ms apart").arg(ms(uneven->shortest), ms(uneven->longest))
                  : QString();
}

namespace {

class ExplanationWords
{
    Q_DECLARE_TR_FUNCTIONS(Explanation)
};

QString smootherSource(Smoother smoother)
{
    switch (smoother) {
    case Smoother::Rts:
        return ExplanationWords::tr(
            "smoothed by Kalman filter and RTS smoother, noise by maximum likelihood (Rauch, "
            "Tung, Striebel 1965; Bar-Shalom et al. 2001)");
    case Smoother::SavGol:
        return ExplanationWords::tr("smoothed by a cubic through eleven points (Savitzky and Golay 1964)");
    case Smoother::Tracker:
        return ExplanationWords::tr("differences as in Tracker, positions not smoothed");
    case Smoother::None:
        break;
    }
    return ExplanationWords::tr("raw differences (Park 2018, eq. 6 to 8), nothing smoothed");
}

QString viewNames(const TrialScene &scene)
{
    QStringList names;
    for (const SceneView &view : scene.views)
        if (view.floorView)
            names << QString::fromStdString(view.camera);
    return names.join(QStringLiteral(", "));
}

/// How the samples became curves.
QStringList methodLines(const AnalysisRecord &analysis)
{
    return {smootherSource(analysis.options.smoother),
            (analysis.profile.heightEstimated ? ExplanationWords::tr("robot %1 high (estimated)")
                                              : ExplanationWords::tr("robot %1 high"))
                .arg(lengthText(analysis.profile.heightM)),
            ExplanationWords::tr("analysis %1 by Odograph %2")
                .arg(analysis.id)
                .arg(QString::fromStdString(analysis.softwareVersion))};
}

struct CurveWords
{
    QString name, formula, uncertainty;
};

/// The formulas are those of core/analysis/quantity_curve.h.
CurveWords curveWords(Quantity quantity)
{
    const QString ofVelocity = ExplanationWords::tr(
        "σ of the smoothed velocity there, including the calibration's scale uncertainty");
    switch (quantity) {
    case Quantity::Speed:
        return {ExplanationWords::tr("Speed"),
                ExplanationWords::tr("|v| = √(vx² + vy²) of the smoothed curve at this frame"), ofVelocity};
    case Quantity::Acceleration:
        return {ExplanationWords::tr("Acceleration"),
                ExplanationWords::tr("a·v/|v| of the smoothed curve at this frame: along the path, negative "
                                     "when braking; |a| while the robot stands still"),
                ExplanationWords::tr(
                    "σ of the smoothed acceleration there, including the calibration's scale uncertainty")};
    case Quantity::Heading:
        return {
            ExplanationWords::tr("Heading"),
            ExplanationWords::tr("Of the body where its outline or an imported track shows it: the smoothed "
                                 "heading. Elsewhere the direction of motion: atan2(vy, vx) of the "
                                 "smoothed curve, kept where the robot stands still and continued where "
                                 "it reverses. Anticlockwise from X, without jumps of a whole turn."),
            ExplanationWords::tr("of the body: σ of its smoothed heading; of the direction of motion: σ of "
                                 "the velocity across the motion divided by the speed")};
    case Quantity::TurnRate:
        return {ExplanationWords::tr("Turn rate"),
                ExplanationWords::tr("Of the body where its heading was measured: the rate of the smoothed "
                                     "heading. Elsewhere (vx·ay − vy·ax)/|v|² of the smoothed curve."),
                ExplanationWords::tr("of the body: σ of the smoothed heading's rate; of the direction of "
                                     "motion: σ² = σa²/|v|² + |a|²σv²/|v|⁴, first order")};
    case Quantity::VelocityX:
    case Quantity::VelocityY:
        return {quantity == Quantity::VelocityX ? ExplanationWords::tr("Velocity X")
                                                : ExplanationWords::tr("Velocity Y"),
                ExplanationWords::tr("the velocity of the smoothed curve at this frame along that axis"),
                ofVelocity};
    case Quantity::LateralAcceleration:
        return {
            ExplanationWords::tr("Lateral acceleration"),
            ExplanationWords::tr("(vx·ay − vy·ax)/|v| of the smoothed curve at this frame: across the "
                                 "path, positive to the left"),
            ExplanationWords::tr("σ² = σa² + (a·v/|v|)²σv²/|v|², first order: of the acceleration, and of "
                                 "the direction of motion")};
    case Quantity::Jerk:
        return {
            ExplanationWords::tr("Jerk"),
            ExplanationWords::tr("(a(t₂) − a(t₁))/(t₂ − t₁) along the path, from the smoothed "
                                 "accelerations half of %1 before and after this frame; its length "
                                 "while the robot stands still")
                .arg(secondsText(fromSeconds(jerkSpanS))),
            ExplanationWords::tr("σ² = (σ₁² + σ₂² − 2ρσ₁σ₂)/(t₂ − t₁)², ρ the correlation of both errors")};
    case Quantity::Distance:
        return {ExplanationWords::tr("Distance travelled"),
                ExplanationWords::tr("the integral of the smoothed speed over the time in which the robot "
                                     "moves, up to this frame"),
                ExplanationWords::tr("of the positions at the ends of each motion, of errors across the path "
                                     "where it turns, and of the calibration's scale; without what the robot "
                                     "may have done while it was not measured")};
    case Quantity::Displacement:
        return {ExplanationWords::tr("Distance from the start"),
                ExplanationWords::tr("the straight line from the first smoothed position to this frame's"),
                ExplanationWords::tr("of both positions along that line, and of the calibration's scale")};
    case Quantity::Separation:
        return {ExplanationWords::tr("Distance to the nearest robot"),
                ExplanationWords::tr("between the reference points of both robots at this frame's time, on "
                                     "the smoothed curves"),
                ExplanationWords::tr("of both positions along that line, and of the calibration's scale")};
    case Quantity::PositionX:
    case Quantity::PositionY:
        break;
    }
    return {quantity == Quantity::PositionX ? ExplanationWords::tr("Position X")
                                            : ExplanationWords::tr("Position Y"),
            ExplanationWords::tr("the smoothed curve at this frame"),
            ExplanationWords::tr("σ of the smoothed position, including the calibration's part")};
}

/// What was measured at a sample, and whether it counted.
QStringList sampleLines(const TrialScene &scene, std::size_t robot, std::size_t index)
{
    const Sample &sample = scene.robots.at(robot).analysis->profile.samples[index];
    QStringList lines;
    if (!sample.position) {
        lines << ExplanationWords::tr("no view found the robot in this frame: the curve bridges the gap");
        return lines;
    }
    lines << ExplanationWords::tr("measured there: %1, %2 ±%3")
                 .arg(distanceText(sample.position->x()), distanceText(sample.position->y()),
                      lengthText(std::sqrt(sample.covariance.trace() / 2)));
    QStringList views;
    for (std::size_t view = 0; view < scene.views.size() && view < 32; ++view)
        if ((sample.views >> view & 1U) != 0)
            views << QString::fromStdString(scene.views[view].camera);
    if (!views.isEmpty())
        lines << ExplanationWords::tr("by %1").arg(views.join(QStringLiteral(", ")));
    if (isRejected(sample.flags))
        lines << ExplanationWords::tr("it is flagged and not used: the curve follows its neighbours");
    return lines;
}

/// Which of the two directions a heading or a turn rate is of.
QString headingLine(const ProfilePoint &point)
{
    return point.body ? ExplanationWords::tr("of the robot's body, which was measured")
                      : ExplanationWords::tr("of the direction of motion");
}

/// What a flag means: the words of SampleFlag.
QStringList flagMeanings(SampleFlags flags)
{
    struct Meaning
    {
        SampleFlag flag;
        QString words;
    };
    const std::array<Meaning, 9> meanings{{
        {SampleFlag::Jump, ExplanationWords::tr("Jump: the position does not fit the motion before and after "
                                                "(χ² with two degrees of freedom, 99.9 %).")},
        {SampleFlag::SpeedLimit,
         ExplanationWords::tr(
             "Limit: to get there, the robot had to exceed the speed limit of the task or of the analysis.")},
        {SampleFlag::AccelerationLimit,
         ExplanationWords::tr("Limit: to get there, the robot had to exceed the acceleration limit of the "
                              "task or of the analysis.")},
        {SampleFlag::ViewsDisagree,
         ExplanationWords::tr("Views disagree: their floor positions differ by more than their uncertainty "
                              "and their usual disagreement explain (χ², 99.9 %).")},
        {SampleFlag::LowScore, ExplanationWords::tr("Low score: the tracker was not sure of what it saw.")},
        {SampleFlag::Lost, ExplanationWords::tr("Lost: no view found the robot.")},
        {SampleFlag::DuplicateFrame,
         ExplanationWords::tr(
             "Repeated frame: the camera delivered the same frame twice, so its time is unknown.")},
        {SampleFlag::Interpolated,
         ExplanationWords::tr("Bridged: the curve crosses a gap without measurements.")},
        {SampleFlag::ByHand,
         ExplanationWords::tr("By hand: a manual override replaces the result of the analysis.")},
    }};
    QStringList words;
    for (const Meaning &meaning : meanings)
        if (hasFlag(flags, meaning.flag))
            words << meaning.words;
    return words;
}

} // namespace

QString Explanation::text() const
{
    QStringList parts{value.isEmpty() ? what : joinedWords(what, value)};
    const auto add = [&parts](const QString &name, const QString &words) {
        if (!words.isEmpty())
            parts << QString() << name << words;
    };
    add(ExplanationWords::tr("How it is computed"), formula);
    add(ExplanationWords::tr("What ± contains (one standard deviation)"), uncertainty);
    add(ExplanationWords::tr("What went into it"), inputs.join(u'\n'));
    add(ExplanationWords::tr("Source"), source);
    return parts.join(u'\n');
}

QStringList analysisInputs(const TrialRecord &trial, const AnalysisRecord &analysis)
{
    QStringList lines;
    lines << ExplanationWords::tr("trial %1, robot %2")
                 .arg(QString::fromStdString(trial.name), QString::fromStdString(analysis.robotName));
    return lines + methodLines(analysis);
}

QStringList analysisInputs(const TrialScene &scene, std::size_t robot)
{
    QStringList lines;
    const SceneRobot &shown = scene.robots.at(robot);
    lines << ExplanationWords::tr("trial %1, robot %2")
                 .arg(QString::fromStdString(scene.trial.name), QString::fromStdString(shown.robot.name));
    if (!shown.analysis)
        return lines;
    const auto &samples = shown.analysis->profile.samples;
    const auto used = std::count_if(samples.begin(), samples.end(), [](const Sample &sample) {
        return sample.position && !isRejected(sample.flags);
    });
    lines << ExplanationWords::tr("%1 of %2 samples used").arg(used).arg(samples.size());
    if (const QString views = viewNames(scene); !views.isEmpty())
        lines << ExplanationWords::tr("views: %1").arg(views);
    return lines + methodLines(*shown.analysis);
}

QStringList zoneBreachLines(const TrialScene &scene, std::size_t robot)
{
    const std::optional<AnalysisRecord> &analysis = scene.robots.at(robot).analysis;
    QStringList lines;
    if (!analysis || !scene.task || analysis->task != scene.taskId)
        return lines;
    for (const ZoneBreach &breach :
         findZoneBreaches(scene.task->zones, analysis->profile.samples, analysis->profile.points))
        lines << ExplanationWords::tr("%1: from %2 to %3, at most %4 beyond the edge")
                     .arg(QString::fromStdString(breach.zone), secondsText(breach.from),
                          secondsText(breach.to), lengthText(breach.depthM));
    return lines;
}

Explanation explainMetric(const Metric &metric, const QStringList &inputs)
{
    Explanation explanation{metricName(metric.name), metricNumber(metric).text(), {}, {}, inputs, {}};
    if (const MetricKind *kind = metricKind(metric.name)) {
        explanation.formula = shownWords(kind->formula);
        if (metric.sigma)
            explanation.uncertainty = shownWords(kind->uncertainty);
        explanation.source = QString::fromUtf8(kind->source.data(), qsizetype(kind->source.size()));
    }
    return explanation;
}

Explanation explainMetric(const TrialScene &scene, std::size_t robot, const Metric &metric)
{
    QStringList inputs = analysisInputs(scene, robot);
    if (metric.name.starts_with("zone_"))
        inputs = zoneBreachLines(scene, robot) + inputs;
    return explainMetric(metric, inputs);
}

Explanation explainCurve(const TrialScene &scene, std::size_t robot, Quantity quantity, Nanoseconds time,
                         const QString &value)
{
    const CurveWords words = curveWords(quantity);
    Explanation explanation{ExplanationWords::tr("%1 at %2").arg(words.name, secondsText(time)),
                            value,
                            words.formula,
                            words.uncertainty,
                            {},
                            {}};
    const auto &analysis = scene.robots.at(robot).analysis;
    if (analysis) {
        const auto &samples = analysis->profile.samples;
        const auto after = std::ranges::upper_bound(samples, time, {}, &Sample::time);
        if (after != samples.begin()) {
            const auto index = static_cast<std::size_t>(after - samples.begin()) - 1;
            explanation.inputs = sampleLines(scene, robot, index);
            if (quantity == Quantity::Heading || quantity == Quantity::TurnRate)
                explanation.inputs << headingLine(analysis->profile.points[index]);
        }
    }
    explanation.inputs += analysisInputs(scene, robot);
    return explanation;
}

Explanation explainSpike(const TrialScene &scene, std::size_t robot, const Spike &spike)
{
    Explanation explanation{ExplanationWords::tr("Spike at %1").arg(secondsText(spike.time)),
                            shownWords(reasonAmong(scene.robots[robot].occlusions, spike)),
                            flagMeanings(spike.flags).join(u'\n'),
                            {},
                            analysisInputs(scene, robot),
                            {}};
    explanation.formula += u'\n';
    explanation.formula += isRejected(spike.flags)
                               ? ExplanationWords::tr("The sample is kept, but not used for the curve.")
                               : ExplanationWords::tr("The curve uses the sample nevertheless: its faulty "
                                                      "part was left out, or a manual override restored it.");
    const auto index = static_cast<std::size_t>(spike.sampleIndex);
    const Profile &profile = scene.robots.at(robot).analysis->profile;
    if (index < profile.samples.size() && profile.samples[index].viewDisagreementM)
        explanation.inputs.prepend(ExplanationWords::tr("the views' floor positions differ by %1 there")
                                       .arg(lengthText(*profile.samples[index].viewDisagreementM)));
    return explanation;
}

} // namespace odo
