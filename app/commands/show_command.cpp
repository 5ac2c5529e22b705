// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/trial_commands.h"
#include "core/analysis/smoothing/cutoff_residuals.h"
#include "core/analysis/zone_visits.h"
#include "core/exchange/trial_json.h"
#include "core/project/repositories.h"
#include "core/project/school_repository.h"
#include "core/workflow/known_truth.h"
#include "core/workflow/track/settled_views.h"
#include "core/workflow/track/sync_passport.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/track/trial_occlusions.h"
#include "core/workflow/track/trial_verdict.h"
#include "core/workflow/trial_sources.h"
#include "core/workflow/turned_recordings.h"

#include <QDateTime>
#include <QJsonArray>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

QJsonObject truthJson(const TruthAccuracy &accuracy)
{
    return {{QStringLiteral("compared"), qint64(accuracy.compared)},
            {QStringLiteral("position_rms_mm"), toMillimetres(accuracy.positionRmsM)},
            {QStringLiteral("velocity_rms_mm_s"), toMillimetres(accuracy.velocityRmsMps)},
            {QStringLiteral("acceleration_rms_mm_s2"), toMillimetres(accuracy.accelerationRmsMps2)},
            {QStringLiteral("inside_95_x"), accuracy.insideX95},
            {QStringLiteral("inside_95_y"), accuracy.insideY95},
            {QStringLiteral("inside_95_speed"), accuracy.insideSpeed95}};
}

/// Where the track came from; nullptr: our own views measured it.
const ImportedTrack *sourceOf(const AnalysisRecord &analysis, const std::vector<ImportedTrack> &imported)
{
    const auto its = std::ranges::find(imported, analysis.robot, &ImportedTrack::robot);
    return its == imported.end() ? nullptr : &*its;
}

QJsonObject provenanceJson(const AnalysisRecord &analysis, const std::vector<ImportedTrack> &imported)
{
    const std::string_view smoother = smootherName(analysis.options.smoother);
    QJsonArray registrations;
    for (const RecordId id : analysis.registrations)
        registrations.append(qint64(id));
    QJsonArray overrides;
    for (const ManualOverride &manualOverride : analysis.options.overrides)
        overrides.append(QJsonObject{{QStringLiteral("frame"), qint64(manualOverride.frame)},
                                     {QStringLiteral("spike"), manualOverride.isSpike}});
    QJsonObject json{
        {QStringLiteral("overrules"), overrides},
        {QStringLiteral("analysis"), qint64(analysis.id)},
        {QStringLiteral("made"),
         QDateTime::fromMSecsSinceEpoch(analysis.made.time_since_epoch().count(), Qt::UTC)
             .toString(Qt::ISODate)},
        {QStringLiteral("software"), QString::fromStdString(analysis.softwareVersion)},
        {QStringLiteral("smoother"), QString::fromUtf8(smoother.data(), qsizetype(smoother.size()))},
        {QStringLiteral("registrations"), registrations}};
    if (const ImportedTrack *source = sourceOf(analysis, imported))
        json.insert(QStringLiteral("imported"), importedTrackJson(*source));
    return json;
}

QJsonValue valueJson(const std::optional<double> &value, double factor)
{
    return value ? QJsonValue(*value * factor) : QJsonValue();
}

QJsonObject passportJson(const SyncPassport &passport)
{
    constexpr double milli = 1e3, million = 1e6;
    QJsonObject views;
    for (const ViewPassport &view : passport.views)
        views.insert(QString::fromStdString(view.camera),
                     QJsonObject{{QStringLiteral("time_sigma_ms"), valueJson(view.sigmaTimeS, milli)},
                                 {QStringLiteral("drift_ppm"), view.clockRate * million},
                                 {QStringLiteral("drift_sigma_ppm"), valueJson(view.sigmaClockRate, million)},
                                 {QStringLiteral("frames_apart_mean_ms"), view.meanApartS * milli},
                                 {QStringLiteral("frames_apart_max_ms"), view.mostApartS * milli},
                                 {QStringLiteral("cost_mm"),
                                  view.costM ? QJsonValue(toMillimetres(view.costM->value)) : QJsonValue()},
                                 {QStringLiteral("cost_sigma_mm"),
                                  view.costM ? QJsonValue(toMillimetres(view.costM->sigma)) : QJsonValue()}});
    QJsonObject json{{QStringLiteral("views"), views}};
    if (passport.topSpeedMps) {
        json.insert(QStringLiteral("top_speed_m_s"), passport.topSpeedMps->value);
        json.insert(QStringLiteral("top_speed_sigma_m_s"), passport.topSpeedMps->sigma);
    }
    if (passport.residualS) {
        json.insert(QStringLiteral("residual_ms"), passport.residualS->value * milli);
        json.insert(QStringLiteral("residual_sigma_ms"), passport.residualS->sigma * milli);
        json.insert(QStringLiteral("residual_significant"), passport.isResidualSignificant);
    }
    return json;
}

/// By the task that it was measured by.
Result<std::vector<ZoneVisits>> zoneVisitsOf(Project &project, const AnalysisRecord &analysis)
{
    if (analysis.task == 0)
        return std::vector<ZoneVisits>();
    const auto task = ODO_TRY(project.tasks().get(analysis.task));
    return findZoneVisits(task.task.zones, analysis.profile.samples, analysis.profile.points);
}

/// How strongly the curve is smoothed, and what other cut-offs would take away.
QJsonObject smoothingJson(const CutoffAnalysis &analysis)
{
    QJsonObject json;
    const auto add = [&json](const QString &name, const QString &unit, const std::optional<CurveValue> &value,
                             double factor) {
        json.insert(name + unit, value ? QJsonValue(factor * value->value) : QJsonValue());
        json.insert(name + QStringLiteral("_sigma") + unit,
                    value ? QJsonValue(factor * value->sigma) : QJsonValue());
    };
    const QString hertz = QStringLiteral("_hz"), millimetres = QStringLiteral("_mm");
    add(QStringLiteral("cutoff"), hertz, analysis.automaticHz, 1);
    add(QStringLiteral("residual"), millimetres, analysis.automaticResidualM, toMillimetres(1));
    add(QStringLiteral("noise"), millimetres, analysis.noiseM, toMillimetres(1));
    add(QStringLiteral("residual_analysis_cutoff"), hertz, analysis.chosenHz, 1);
    json.insert(QStringLiteral("stated_noise_mm"), toMillimetres(analysis.statedNoiseM));
    QJsonArray residuals;
    for (const CutoffResidual &each : analysis.residuals)
        residuals.append(QJsonObject{{QStringLiteral("cutoff_hz"), each.cutoffHz},
                                     {QStringLiteral("residual_mm"), toMillimetres(each.residualM)},
                                     {QStringLiteral("sigma_mm"), toMillimetres(each.sigmaM)}});
    json.insert(QStringLiteral("residuals"), residuals);
    return json;
}

QJsonArray zonesJson(const std::vector<ZoneVisits> &zones)
{
    QJsonArray array;
    for (const ZoneVisits &zone : zones) {
        QJsonArray visits;
        for (const TimeSpan &visit : zone.visits)
            visits.append(QJsonObject{{QStringLiteral("from_s"), toSeconds(visit.begin)},
                                      {QStringLiteral("to_s"), toSeconds(visit.end)}});
        const auto latency = [&zone](double CurveValue::*part) {
            return zone.latencyS ? QJsonValue((*zone.latencyS).*part) : QJsonValue();
        };
        array.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(zone.zone)},
                                 {QStringLiteral("inside_s"), zone.insideS.value},
                                 {QStringLiteral("inside_sigma_s"), zone.insideS.sigma},
                                 {QStringLiteral("at_least"), zone.isAtLeast},
                                 {QStringLiteral("entries"), zone.entries},
                                 {QStringLiteral("begins_inside"), zone.beginsInside},
                                 {QStringLiteral("latency_s"), latency(&CurveValue::value)},
                                 {QStringLiteral("latency_sigma_s"), latency(&CurveValue::sigma)},
                                 {QStringLiteral("visits"), visits}});
    }
    return array;
}

QString zoneText(const ZoneVisits &zone)
{
    QString line =
        QStringLiteral("  zone %1: inside for %2%3 s ±%4 s, %5 entered")
            .arg(QString::fromStdString(zone.zone), zone.isAtLeast ? QStringLiteral("at least ") : QString())
            .arg(zone.insideS.value, 0, 'f', 3)
            .arg(zone.insideS.sigma, 0, 'f', 3)
            .arg(counted(zone.entries, QStringLiteral("time")));
    if (zone.latencyS)
        line += QStringLiteral(", first after %1 s ±%2 s")
                    .arg(zone.latencyS->value, 0, 'f', 3)
                    .arg(zone.latencyS->sigma, 0, 'f', 3);
    return line;
}

QString metricText(const Metric &metric)
{
    const bool isCount = metric.unit == "1" && !metric.sigma && metric.value == std::round(metric.value);
    const int decimals = isCount ? 0 : metric.sigma && *metric.sigma < 0.0005 ? 4 : 3;
    QString line = QStringLiteral("  %1 %2")
                       .arg(QString::fromStdString(metric.name), -16)
                       .arg((metric.isAtLeast ? QStringLiteral("at least ") : QString()) +
                            QString::number(metric.value, 'f', decimals));
    if (metric.sigma)
        line += QStringLiteral(" ±%1").arg(*metric.sigma, 0, 'f', decimals);
    return metric.unit == "1" ? line : line + QStringLiteral(" ") + QString::fromStdString(metric.unit);
}

QStringList robotText(const AnalysisRecord &analysis, const std::vector<Occlusion> &occlusions,
                      const std::optional<TruthAccuracy> &accuracy)
{
    QStringList lines(QStringLiteral("Robot %1").arg(QString::fromStdString(analysis.robotName)));
    for (const Metric &metric : analysis.profile.metrics)
        lines << metricText(metric);
    lines << taskLines(analysis.profile);
    for (const Spike &spike : analysis.profile.spikes)
        lines << QStringLiteral("  spike at %1 s: %2")
                     .arg(toSeconds(spike.time), 0, 'f', 3)
                     .arg(english(reasonAmong(occlusions, spike)));
    for (const AmbiguousName &ambiguity : analysis.ambiguousNames)
        lines << QStringLiteral("  %1").arg(english(ambiguousNamesText({&ambiguity, 1}, analysis.robotName)));
    for (const Occlusion &one : occlusions)
        lines << QStringLiteral("  %1").arg(english(occlusionSentence(one)));
    if (accuracy)
        lines << QStringLiteral("  against the known truth: %1 mm, %2 mm/s, %3 mm/s² RMS")
                     .arg(toMillimetres(accuracy->positionRmsM), 0, 'f', 2)
                     .arg(toMillimetres(accuracy->velocityRmsMps), 0, 'f', 1)
                     .arg(toMillimetres(accuracy->accelerationRmsMps2), 0, 'f', 0);
    return lines;
}

} // namespace

Result<void> runShow(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("show"), QStringLiteral("P.odo TRIAL [--json]"), 2, 2, {}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto opened = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    Project &project = *opened;
    const auto trial = ODO_TRY(project.trials().find(call.text(1)));
    const auto recordings = ODO_TRY(project.trials().recordings(trial.id));
    const auto analyses = ODO_TRY(project.analyses().current(trial.id));

    QJsonObject views;
    for (const RecordingRecord &recording : recordings) {
        QJsonObject view = recordingJson(recording);
        view.insert(QStringLiteral("file"), QString::fromStdString(recording.path));
        view.insert(QStringLiteral("sha256"), QString::fromStdString(recording.sha256));
        views.insert(QString::fromStdString(recording.cameraName), view);
    }
    const auto imported = ODO_TRY(importedTracksOf(project, trial));
    QJsonObject robots;
    std::vector<Message> warnings;
    QStringList lines(QStringLiteral("Trial %1, team %2")
                          .arg(QString::fromStdString(trial.name), QString::fromStdString(trial.teamName)));
    lines << stepSentences(recordings);
    const auto identity = ODO_TRY(project.school().known(SchoolKind::Trial, trial.id));
    const bool isElsewhere = recordings.empty() && identity && !identity->views.empty();
    if (isElsewhere)
        lines << QStringLiteral("Its recordings are at %1").arg(QString::fromStdString(identity->owner));
    if (trial.range)
        lines << english(rangeSentence(trial));
    if (analyses.empty())
        lines << QStringLiteral("Not tracked yet; run: odograph track %1 %2")
                     .arg(call.positional(0), call.positional(1));
    std::vector<const RecordingRecord *> all, used;
    for (const RecordingRecord &recording : recordings)
        all.push_back(&recording);
    if (!analyses.empty())
        for (const std::size_t view : usedViews(analyses.front(), recordings.size()))
            used.push_back(all[view]);
    warnings = stepWarnings(trial.name, used);
    for (const RecordingRecord &recording : recordings)
        if (Message sentence = storedFrameWarning(trial.name, recording, project.resolve(recording));
            !sentence.isEmpty())
            warnings.push_back(std::move(sentence));
    const auto verdict = ODO_TRY(verdictOn(project, trial, all, analyses));
    lines << verdictLines(verdict);
    const auto occlusions = ODO_TRY(trialOcclusions(project, trial.id, analyses));
    for (std::size_t a = 0; a < analyses.size(); ++a) {
        const AnalysisRecord &analysis = analyses[a];
        const auto truth = ODO_TRY(project.trials().truth(trial.id, analysis.robot));
        std::optional<TruthAccuracy> accuracy;
        if (truth)
            accuracy = compareWithTruth(analysis.profile, *truth);
        QJsonObject robot{{QStringLiteral("metrics"), metricsJson(analysis.profile.metrics)},
                          {QStringLiteral("spikes"), spikesJson(analysis.profile.spikes, occlusions[a])},
                          {QStringLiteral("doubts"), ambiguitiesJson(analysis.ambiguousNames)},
                          {QStringLiteral("occlusions"), occlusionsJson(occlusions[a])},
                          {QStringLiteral("doubtful_s"), ambiguousSeconds(analysis.ambiguousNames)},
                          {QStringLiteral("height_m"), analysis.profile.heightM},
                          {QStringLiteral("height_estimated"), analysis.profile.heightEstimated},
                          {QStringLiteral("provenance"), provenanceJson(analysis, imported)}};
        insertMeasuredTime(robot, analysis.profile);
        insertTaskAnswers(robot, analysis.profile);
        const auto zones = ODO_TRY(zoneVisitsOf(project, analysis));
        robot.insert(QStringLiteral("zones"), zonesJson(zones));
        robot.insert(QStringLiteral("smoothing"), smoothingJson(cutoffAnalysis(analysis.profile)));
        if (accuracy)
            robot.insert(QStringLiteral("truth"), truthJson(*accuracy));
        robots.insert(QString::fromStdString(analysis.robotName), robot);
        lines << robotText(analysis, occlusions[a], accuracy);
        for (const ZoneVisits &zone : zones)
            lines << zoneText(zone);
        if (const ImportedTrack *source = sourceOf(analysis, imported))
            lines << QStringLiteral("  ") + importedTrackText(*source);
        for (Message &warning : analysisWarnings(analysis, trial.name))
            warnings.push_back(std::move(warning));
    }
    std::vector<const Profile *> profiles;
    for (const AnalysisRecord &analysis : analyses)
        profiles.push_back(&analysis.profile);
    const SyncPassport passport = syncPassport(trial, all, profiles);
    for (const Message &sentence : passportSentences(passport))
        lines << english(sentence) + u'.';
    QJsonObject answer{{QStringLiteral("trial"), QString::fromStdString(trial.name)},
                       {QStringLiteral("team"), QString::fromStdString(trial.teamName)},
                       {QStringLiteral("task"), QString::fromStdString(trial.task)},
                       {QStringLiteral("notes"), QString::fromStdString(trial.notes)},
                       {QStringLiteral("variables"), variablesJson(trial)},
                       {QStringLiteral("views"), views},
                       {QStringLiteral("sync"), syncJson(trial)},
                       {QStringLiteral("sync_passport"), passportJson(passport)},
                       {QStringLiteral("range"), rangeJson(trial)},
                       {QStringLiteral("verdict"), verdictJson(verdict)},
                       {QStringLiteral("robots"), robots},
                       {QStringLiteral("warnings"), sentencesJson(warnings)}};
    if (isElsewhere)
        answer.insert(QStringLiteral("recordings_at"), QString::fromStdString(identity->owner));
    call.answer(answer, lines.join(u'\n'));
    for (const Message &warning : warnings)
        CommandCall::warn(warning);
    return {};
}

} // namespace odo
