// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/commands/import_command.h"
#include "core/project/repositories.h"
#include "core/workflow/known_truth.h"
#include "core/workflow/track/robot_names.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/track/trial_occlusions.h"
#include "core/workflow/trial_sources.h"

#include <QDateTime>
#include <algorithm>
#include <cmath>

namespace odo {

Result<void> runList(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("list"), QStringLiteral("P.odo [--json]"), 1, 1, {}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    const auto title = ODO_TRY(project->title());
    const auto all = ODO_TRY(project->trials().all());
    QJsonArray trials;
    QStringList lines(QString::fromStdString(title));
    for (const TrialRecord &trial : all) {
        QJsonArray robots;
        for (const std::string &robot : trial.robotNames)
            robots.append(QString::fromStdString(robot));
        trials.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(trial.name)},
                                  {QStringLiteral("team"), QString::fromStdString(trial.teamName)},
                                  {QStringLiteral("task"), QString::fromStdString(trial.task)},
                                  {QStringLiteral("date"), dateText(trial.date)},
                                  {QStringLiteral("robots"), robots},
                                  {QStringLiteral("duration_s"), trial.durationS},
                                  {QStringLiteral("views"), trial.viewCount}});
        lines << QStringLiteral("  %1  %2  %3  %4 s  %5")
                     .arg(QString::fromStdString(trial.name), -24)
                     .arg(QString::fromStdString(trial.teamName), -16)
                     .arg(dateText(trial.date))
                     .arg(trial.durationS, 0, 'f', 2)
                     .arg(counted(trial.viewCount, QStringLiteral("view")));
    }
    call.answer(
        {{QStringLiteral("title"), QString::fromStdString(title)}, {QStringLiteral("trials"), trials}},
        lines.join(u'\n'));
    return {};
}

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
    QJsonArray overrules;
    for (const Overrule &overrule : analysis.options.overrules)
        overrules.append(QJsonObject{{QStringLiteral("frame"), qint64(overrule.frame)},
                                     {QStringLiteral("spike"), overrule.isSpike}});
    QJsonObject json{
        {QStringLiteral("overrules"), overrules},
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

QString metricText(const Metric &metric)
{
    const bool isCount = metric.unit == "1" && !metric.sigma && metric.value == std::round(metric.value);
    const int decimals = isCount ? 0 : metric.sigma && *metric.sigma < 0.0005 ? 4 : 3;
    QString line = QStringLiteral("  %1 %2")
                       .arg(QString::fromStdString(metric.name), -16)
                       .arg(metric.value, 0, 'f', decimals);
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
    for (const DoubtfulName &doubt : analysis.doubtfulNames)
        lines << QStringLiteral("  %1").arg(english(doubtfulNamesSentence({&doubt, 1}, analysis.robotName)));
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
    if (analyses.empty())
        lines << QStringLiteral("Not tracked yet; run: odograph track %1 %2")
                     .arg(call.positional(0), call.positional(1));
    std::vector<const RecordingRecord *> used;
    for (std::size_t v = 0; !analyses.empty() && v < recordings.size(); ++v) {
        const std::vector<RecordId> &registrations = analyses.front().registrations;
        if (v < registrations.size() && registrations[v] != 0)
            used.push_back(&recordings[v]);
    }
    warnings = stepWarnings(trial.name, used);
    const auto occlusions = ODO_TRY(trialOcclusions(project, trial.id, analyses));
    for (std::size_t a = 0; a < analyses.size(); ++a) {
        const AnalysisRecord &analysis = analyses[a];
        const auto truth = ODO_TRY(project.trials().truth(trial.id, analysis.robot));
        std::optional<TruthAccuracy> accuracy;
        if (truth)
            accuracy = compareWithTruth(analysis.profile, *truth);
        QJsonObject robot{{QStringLiteral("metrics"), metricsJson(analysis.profile.metrics)},
                          {QStringLiteral("spikes"), spikesJson(analysis.profile.spikes, occlusions[a])},
                          {QStringLiteral("doubts"), doubtsJson(analysis.doubtfulNames)},
                          {QStringLiteral("occlusions"), occlusionsJson(occlusions[a])},
                          {QStringLiteral("doubtful_s"), doubtfulSeconds(analysis.doubtfulNames)},
                          {QStringLiteral("height_m"), analysis.profile.heightM},
                          {QStringLiteral("height_estimated"), analysis.profile.heightEstimated},
                          {QStringLiteral("provenance"), provenanceJson(analysis, imported)}};
        insertTaskAnswers(robot, analysis.profile);
        if (accuracy)
            robot.insert(QStringLiteral("truth"), truthJson(*accuracy));
        robots.insert(QString::fromStdString(analysis.robotName), robot);
        lines << robotText(analysis, occlusions[a], accuracy);
        if (const ImportedTrack *source = sourceOf(analysis, imported))
            lines << QStringLiteral("  ") + importedTrackText(*source);
        for (Message &warning : analysisWarnings(analysis, trial.name))
            warnings.push_back(std::move(warning));
    }
    call.answer({{QStringLiteral("trial"), QString::fromStdString(trial.name)},
                 {QStringLiteral("team"), QString::fromStdString(trial.teamName)},
                 {QStringLiteral("task"), QString::fromStdString(trial.task)},
                 {QStringLiteral("notes"), QString::fromStdString(trial.notes)},
                 {QStringLiteral("views"), views},
                 {QStringLiteral("sync"), syncJson(trial)},
                 {QStringLiteral("robots"), robots},
                 {QStringLiteral("warnings"), sentencesJson(warnings)}},
                lines.join(u'\n'));
    for (const Message &warning : warnings)
        CommandCall::warn(warning);
    return {};
}

} // namespace odo
