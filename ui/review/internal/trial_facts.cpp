// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/internal/trial_facts.h"

#include "core/analysis/gate_passages.h"
#include "core/base/file_system.h"
#include "core/workflow/track/track_warnings.h"
#include "ui/models/explanation.h"
#include "ui/models/number_text.h"
#include "ui/models/results.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_lines.h"
#include "ui/models/verdict_mark.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <filesystem>
#include <optional>

namespace odo {

/// "How was this computed?" of the facts of a trial's card that are measured.

namespace {

class FactExplanationsWords
{
    Q_DECLARE_TR_FUNCTIONS(FactExplanations)
};

struct StepWords
{
    QString formula, uncertainty;
};

/// As clip_synchronisation.h, flash_synchronisation.h and sound_synchronisation.h have it
/// (core/synchronisation).
std::optional<StepWords> stepWords(const std::string &method)
{
    if (method == "auto")
        return StepWords{FactExplanationsWords::tr(
                             "The time offset at which the robot's floor tracks from the two views coincide: "
                             "least squares of r(t) = p₁(t) − p₂((t − offset)(1 + rate)), with a constant "
                             "shift and a small scale between them, searched in steps of half a frame and "
                             "refined by Gauss–Newton. The clock rate is used if it exceeds three σ."),
                         FactExplanationsWords::tr("from the curvature of the sum of squares and from the "
                                                   "residual, assumed to be correlated over half a second")};
    if (method == "flash")
        return StepWords{
            FactExplanationsWords::tr(
                "The time offset at which the jumps in brightness in both views coincide: the weighted mean "
                "of the pairs. It is used if every other offset is at least 150 times less likely."),
            FactExplanationsWords::tr("from the pairs and their scatter, plus a tenth of a frame interval "
                                      "per view for its shutter")};
    if (method == "audio")
        return StepWords{
            FactExplanationsWords::tr(
                "The time offset at which claps, knocks or whistles in the sound of both views coincide: the "
                "weighted mean of the pairs, less the time that sound takes to reach each camera. It is used "
                "if "
                "every other offset is at least 150 times less likely."),
            FactExplanationsWords::tr(
                "from the pairs, from where on the floor the sound may have come, 50 ppm "
                "of the time from the start of the recording to the sound, and 2 ms by which "
                "each camera may record its sound early or late")};
    if (method == "clock")
        return StepWords{
            FactExplanationsWords::tr("Each camera's time stamps, converted to this computer's clock by "
                                      "reading the camera's clock during the recording."),
            FactExplanationsWords::tr("from both clock conversions")};
    return std::nullopt;
}

} // namespace

/// The times at which a robot passed the gates.
Explanation explainPassages(const TrialScene &scene, std::size_t robot, const QString &value)
{
    Explanation explanation;
    explanation.what = FactExplanationsWords::tr("Times at the gates");
    explanation.value = value;
    explanation.formula = FactExplanationsWords::tr(
        "When the robot's reference point crosses the gate's line between its ends, in the direction of the "
        "gate. Between two frames, the smoothed position is the cubic through both positions and velocities. "
        "A passage counts if the point was before the line by three σ of the track's own noise and then is "
        "past it by as much.");
    explanation.uncertainty = FactExplanationsWords::tr(
        "σ of the position across the gate divided by the speed across it, including the calibration's part");
    explanation.inputs = analysisInputs(scene, robot);
    return explanation;
}

/// A whole lap, or run from start to finish.
Explanation explainLap(const TrialScene &scene, std::size_t robot, const Lap &lap, const QString &what)
{
    Explanation explanation;
    explanation.what = what;
    explanation.value = numberText(lap.timeS, lap.sigmaS, QStringLiteral("s")).text();
    explanation.formula = FactExplanationsWords::tr(
        "From a passage of the start to one of the finish, or from one passage of a start-finish gate to the "
        "next. Of each split, the first passage counts.");
    explanation.uncertainty =
        FactExplanationsWords::tr("from both passages; the calibration's uncertainty cancels "
                                  "for a gate passed twice at the same speed");
    for (const Sector &sector : lap.sectors)
        explanation.inputs << FactExplanationsWords::tr("to %1: %2")
                                  .arg(QString::fromStdString(sector.gate),
                                       numberText(sector.timeS, sector.sigmaS, QStringLiteral("s")).text());
    explanation.inputs += analysisInputs(scene, robot);
    return explanation;
}

/// Several metrics of one kind beneath one another: those whose names begin so ("cross_track", "zone_").
Explanation explainMetrics(const TrialScene &scene, std::size_t robot, const QString &what,
                           const QString &value, const std::string &stem)
{
    Explanation explanation;
    explanation.what = what;
    explanation.value = value;
    QStringList formulas, uncertainties;
    for (const Metric &metric : scene.robots.at(robot).analysis->profile.metrics) {
        if (!metric.name.starts_with(stem))
            continue;
        const Explanation one = explainMetric(metric, {});
        formulas << QStringLiteral("%1: %2").arg(one.what, one.formula);
        if (!one.uncertainty.isEmpty())
            uncertainties << QStringLiteral("%1: %2").arg(one.what, one.uncertainty);
    }
    explanation.formula = formulas.join(u'\n');
    explanation.uncertainty = uncertainties.join(u'\n');
    explanation.inputs = analysisInputs(scene, robot);
    return explanation;
}

/// How a view was synchronised with the first; nullopt: the offset was entered, or the same start was
/// assumed, and nothing was computed.
std::optional<Explanation> explainStep(const SceneView &view, const QString &value)
{
    const auto words = stepWords(view.recording.syncMethod);
    if (!words)
        return std::nullopt;
    Explanation explanation;
    explanation.what = FactExplanationsWords::tr("Synchronisation of view %1 with the first")
                           .arg(QString::fromStdString(view.camera));
    explanation.value = value;
    explanation.formula = words->formula;
    explanation.uncertainty = words->uncertainty;
    explanation.inputs << FactExplanationsWords::tr("video %1, %2 frames")
                              .arg(QString::fromStdString(view.file.filename().string()))
                              .arg(view.recording.frameTimes.size());
    return explanation;
}

/// The robot's height; nullopt: it was entered.
std::optional<Explanation> explainHeight(const TrialScene &scene, std::size_t robot)
{
    const auto &analysis = scene.robots.at(robot).analysis;
    if (!analysis || !analysis->profile.heightEstimated)
        return std::nullopt;
    Explanation explanation;
    explanation.what = FactExplanationsWords::tr("Height of robot %1")
                           .arg(QString::fromStdString(scene.robots[robot].robot.name));
    explanation.value = lengthText(analysis->profile.heightM);
    explanation.formula = FactExplanationsWords::tr(
        "The solid (box or cylinder, on the floor or a plate at the robot's top) whose silhouettes best "
        "match the outlines in all views, by weighted least squares at about forty times of the run. If no "
        "such solid explains them: the height at which all views give the same floor position.");
    explanation.inputs = analysisInputs(scene, robot);
    return explanation;
}

namespace {

class TrialFactsWords
{
    Q_DECLARE_TR_FUNCTIONS(TrialFacts)
};

QString robotText(const SceneRobot &robot)
{
    QString name = QString::fromStdString(robot.robot.name);
    if (!robot.analysis || robot.analysis->views.empty()) // an imported track has no height
        return name;
    const QString height = lengthText(robot.analysis->profile.heightM);
    return robot.analysis->profile.heightEstimated
               ? TrialFactsWords::tr("%1, %2 high (estimated)").arg(name, height)
               : TrialFactsWords::tr("%1, %2 high").arg(name, height);
}

QString viewText(const SceneView &view)
{
    return TrialFactsWords::tr("%1: %2×%3, %4 frames")
        .arg(QString::fromStdString(view.camera))
        .arg(view.recording.widthPx)
        .arg(view.recording.heightPx)
        .arg(view.recording.frameTimes.size());
}

/// What is worse comes in the place of the badge that the rate varies, of which the words remain.
Fact viewFact(const SceneView &view)
{
    Fact fact{TrialFactsWords::tr("View"), viewText(view), {}};
    if (const QString uneven = unevenText(view.recording); !uneven.isEmpty()) {
        fact.value += u'\n' + uneven;
        fact.badge = {TrialFactsWords::tr("rate varies"), BadgeState::Neutral};
    }
    if (!files::exists(view.file))
        fact.badge = {TrialFactsWords::tr("video missing"), BadgeState::Bad};
    else if (!view.floorView)
        fact.badge = {TrialFactsWords::tr("not registered"), BadgeState::Warning};
    return fact;
}

Fact stepFact(const SceneView &view)
{
    Fact fact{
        TrialFactsWords::tr("Synchronisation"),
        TrialFactsWords::tr("%1: %2").arg(QString::fromStdString(view.camera), stepText(view.recording)),
        {},
        explainStep(view, stepText(view.recording))};
    if (view.recording.syncMethod != "told" && !isStepMeasured(view.recording))
        fact.badge = {TrialFactsWords::tr("not synchronised"), BadgeState::Warning};
    return fact;
}

/// Where an imported track came from, and how it was read.
QString importText(const ImportedTrack &source)
{
    return QString::fromStdString(source.file) + u'\n' + shownWords(source.reading) + u'\n' +
           TrialFactsWords::tr("SHA-256 %1…").arg(QString::fromStdString(source.sha256.substr(0, 12)));
}

QString timeText(double seconds, double sigmaS)
{
    return numberText(seconds, sigmaS, QStringLiteral("s")).text();
}

/// When the robot passed each gate, and the laps with their sectors.
QList<Fact> gateFacts(const TrialScene &scene)
{
    const Profile &profile = scene.robots.front().analysis->profile;
    QList<Fact> facts;
    QStringList gates;
    for (const GatePassage &passage : profile.passages)
        gates << TrialFactsWords::tr("%1 at %2")
                     .arg(QString::fromStdString(passage.gate),
                          timeText(toSeconds(passage.time), passage.sigmaS));
    if (!gates.isEmpty())
        facts.append({TrialFactsWords::tr("Gates"),
                      gates.join(u'\n'),
                      {},
                      explainPassages(scene, 0, gates.join(u'\n'))});
    const bool oneGate =
        std::any_of(profile.passages.begin(), profile.passages.end(),
                    [](const GatePassage &passage) { return passage.role == GateRole::StartFinish; });
    int number = 0;
    for (const Lap &lap : lapsOf(profile.passages)) {
        QStringList lines(timeText(lap.timeS, lap.sigmaS));
        for (const Sector &sector : lap.sectors) {
            if (lap.sectors.size() > 1)
                lines << TrialFactsWords::tr("to %1 %2")
                             .arg(QString::fromStdString(sector.gate), timeText(sector.timeS, sector.sigmaS));
        }
        const QString what =
            (oneGate ? TrialFactsWords::tr("Lap %1") : TrialFactsWords::tr("Run %1")).arg(++number);
        facts.append({what, lines.join(u'\n'), {}, explainLap(scene, 0, lap, what)});
    }
    return facts;
}

/// How well the reference path was kept.
QString pathText(const Profile &profile)
{
    QStringList lines;
    for (const Metric &metric : profile.metrics) {
        const QString valueText = metricNumber(metric).text();
        if (metric.name == "cross_track_mean")
            lines << TrialFactsWords::tr("off by %1 on average").arg(valueText);
        else if (metric.name == "cross_track_rms")
            lines << TrialFactsWords::tr("%1 (RMS)").arg(valueText);
        else if (metric.name == "cross_track_max")
            lines << TrialFactsWords::tr("%1 at most").arg(valueText);
        else if (metric.name == "cross_track_bias")
            lines << TrialFactsWords::tr("%1 to the left").arg(valueText);
        else if (metric.name == "path_completed")
            lines << TrialFactsWords::tr("%1 of it completed").arg(valueText);
    }
    return lines.join(u'\n');
}

/// Where the first robot was beyond zones, and when it was in each; empty where the task has none or it was
/// measured by another course.
QString zonesText(const TrialScene &scene)
{
    if (!scene.task || scene.task->zones.empty() || isMeasuredOtherwise(scene, 0))
        return {};
    QStringList lines = zoneBreachLines(scene, 0);
    if (lines.isEmpty())
        lines << TrialFactsWords::tr("kept");
    return (lines + zoneVisitLines(scene, 0)).join(u'\n');
}

/// How far the results can be relied on, and the reasons why not.
void addVerdict(const TrialVerdict &verdict, QList<Fact> &facts)
{
    if (verdict.checks.empty())
        return;
    const bool isOpen = verdict.level() == CheckLevel::Doubtful && !verdict.isAccepted();
    facts.append({TrialFactsWords::tr("Verdict"),
                  verdictText(verdict),
                  verdictBadge(verdict),
                  {},
                  isOpen                 ? TrialFactsWords::tr("Accept…")
                  : verdict.isAccepted() ? TrialFactsWords::tr("Withdraw")
                                         : QString()});
}

/// The task, with what a run is worth in it.
void addTask(const TrialScene &scene, QList<Fact> &facts)
{
    if (scene.trial.task.empty())
        return;
    const bool isOtherwise = !scene.robots.empty() && isMeasuredOtherwise(scene, 0);
    facts.append({TrialFactsWords::tr("Task"), QString::fromStdString(scene.trial.task),
                  isOtherwise
                      ? Badge{TrialFactsWords::tr("analysed with a different course"), BadgeState::Warning}
                      : Badge()});
    for (std::size_t robot = 0; robot < scene.robots.size(); ++robot) {
        const std::optional<Score> score = scoreOf(scene, robot);
        if (!score)
            continue;
        const QString points = scoreText(*score);
        facts.append({TrialFactsWords::tr("Score"),
                      scene.robots.size() == 1
                          ? points
                          : joinedWords(QString::fromStdString(scene.robots[robot].robot.name), points),
                      {},
                      explainScore(*score, analysisInputs(scene, robot))});
    }
    if (isOtherwise && !scene.scoring.empty())
        facts.append(
            {TrialFactsWords::tr("Score"),
             TrialFactsWords::tr("none until you reanalyse the trial: the task has a different course now"),
             {}});
}

} // namespace

QList<Fact> trialFacts(const TrialScene &scene)
{
    QList<Fact> facts;
    const auto add = [&facts](const QString &name, const QString &value) {
        if (!value.isEmpty())
            facts.append(Fact{name, value, {}, std::nullopt});
    };
    const TrialRecord &trial = scene.trial;
    addVerdict(scene.verdict, facts);
    add(TrialFactsWords::tr("Team"), shownTeam(trial));
    add(TrialFactsWords::tr("Class"), QString::fromStdString(trial.className));
    addTask(scene, facts);
    if (trial.range)
        add(TrialFactsWords::tr("Range"),
            TrialFactsWords::tr("%1 to %2 of %3")
                .arg(secondsText(trial.range->begin), secondsText(trial.range->end),
                     secondsText(fromSeconds(trial.durationS))));
    for (std::size_t robot = 0; robot < scene.robots.size(); ++robot)
        facts.append(
            {TrialFactsWords::tr("Robot"), robotText(scene.robots[robot]), {}, explainHeight(scene, robot)});
    add(TrialFactsWords::tr("Date"), shortDate(trial.date));
    for (const auto &[name, value] : trial.variables)
        add(QString::fromStdString(name), QString::fromStdString(value));
    if (scene.layout)
        add(TrialFactsWords::tr("Testbed"),
            TrialFactsWords::tr("markers “%1”").arg(QString::fromStdString(scene.layout->name)));
    for (const SceneView &view : scene.views)
        facts.append(viewFact(view));
    for (const ImportedTrack &source : scene.imported)
        add(TrialFactsWords::tr("Imported"), importText(source));
    for (std::size_t view = 1; view < scene.views.size(); ++view)
        facts.append(stepFact(scene.views[view]));
    if (const QStringList lines = passportLines(passportOf(scene)); !lines.isEmpty())
        facts.append({TrialFactsWords::tr("In millimetres"),
                      lines.join(u'\n'),
                      {},
                      explainPassport(scene, lines.join(u'\n'))});
    if (!scene.robots.empty() && scene.robots.front().analysis) {
        const AnalysisRecord &analysis = *scene.robots.front().analysis;
        facts += gateFacts(scene);
        if (const QString path = pathText(analysis.profile); !path.isEmpty())
            facts.append({TrialFactsWords::tr("Path"),
                          path,
                          {},
                          explainMetrics(scene, 0, TrialFactsWords::tr("Distance from the path"), path,
                                         "cross_track")});
        if (const QString zones = zonesText(scene); !zones.isEmpty())
            facts.append({TrialFactsWords::tr("Zones"),
                          zones,
                          {},
                          explainMetrics(scene, 0, TrialFactsWords::tr("Zones"), zones, "zone_")});
        add(TrialFactsWords::tr("Smoother"), smootherText(analysis.options.smoother));
        add(TrialFactsWords::tr("Analysed"),
            TrialFactsWords::tr("%1, Odograph %2")
                .arg(shortDate(analysis.made), QString::fromStdString(analysis.softwareVersion)));
    }
    add(TrialFactsWords::tr("Note"), QString::fromStdString(trial.notes));
    return facts;
}

} // namespace odo
