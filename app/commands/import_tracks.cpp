// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/counted.h"
#include "app/commands/import_tracks.h"

#include "app/json_answers.h"
#include "app/task_answers.h"
#include "core/workflow/import_tracks_job.h"

namespace odo {

namespace {

QString robotText(const ImportTracksJob::Imported &one)
{
    const Profile &profile = one.analysis.profile;
    const QString figures = QStringLiteral("%1, %2, path %3 m in %4 s, top speed %5 m/s")
                                .arg(counted(profile.points.size(), QStringLiteral("position")))
                                .arg(counted(profile.spikes.size(), QStringLiteral("spike")))
                                .arg(metricValue(profile, "path_length"), 0, 'f', 3)
                                .arg(metricValue(profile, "duration"), 0, 'f', 2)
                                .arg(metricValue(profile, "max_speed"), 0, 'f', 3);
    return QString::fromStdString(one.robot.name) + QStringLiteral(": ") + figures + taskRemark(profile) + QStringLiteral("\n  ") +
           importedTrackText(one.source);
}

QJsonObject robotJson(const ImportTracksJob::Imported &one)
{
    const Profile &profile = one.analysis.profile;
    QJsonObject json{{QStringLiteral("samples"), qint64(profile.points.size())},
                     {QStringLiteral("spikes"), qint64(profile.spikes.size())},
                     {QStringLiteral("path_length_m"), metricValue(profile, "path_length")},
                     {QStringLiteral("duration_s"), metricValue(profile, "duration")},
                     {QStringLiteral("mean_speed_m_s"), metricValue(profile, "mean_speed")},
                     {QStringLiteral("max_speed_m_s"), metricValue(profile, "max_speed")},
                     {QStringLiteral("imported"), importedTrackJson(one.source)}};
    insertTaskAnswers(json, profile);
    return json;
}

} // namespace

QJsonObject importedTrackJson(const ImportedTrack &source)
{
    return {{QStringLiteral("file"), QString::fromStdString(source.file)},
            {QStringLiteral("sha256"), QString::fromStdString(source.sha256)},
            {QStringLiteral("bytes"), qint64(source.bytes)},
            {QStringLiteral("format"), QString::fromStdString(source.format)},
            {QStringLiteral("noise_mm"), toMillimetres(source.noiseM)},
            {QStringLiteral("reading"), QString::fromStdString(source.reading)}};
}

QString importedTrackText(const ImportedTrack &source)
{
    return QStringLiteral("imported from %1 (%2, SHA-256 %3): %4")
        .arg(QString::fromStdString(source.file), QString::fromStdString(source.format),
             QString::fromStdString(source.sha256.substr(0, 12)), QString::fromStdString(source.reading));
}

Result<void> importTracks(const CommandCall &call, const std::vector<std::pair<std::string, std::string>> &tracks)
{
    ImportTracksSettings settings;
    settings.trial = call.value(QStringLiteral("trial"));
    settings.team = call.value(QStringLiteral("team"));
    settings.task = call.value(QStringLiteral("task"));
    for (const auto &[robot, file] : tracks)
        settings.tracks.emplace_back(robot, file);
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    ImportTracksJob job(std::move(settings));
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    QJsonObject robots;
    QStringList lines(QStringLiteral("Trial %1 imported, tracks: %2")
                          .arg(QString::fromStdString(job.trial().name), QString::number(job.imported().size())));
    for (const ImportTracksJob::Imported &one : job.imported()) {
        robots.insert(QString::fromStdString(one.robot.name), robotJson(one));
        lines << robotText(one);
    }
    call.answer({{QStringLiteral("trial"), QString::fromStdString(job.trial().name)},
                 {QStringLiteral("views"), QJsonObject()},
                 {QStringLiteral("sync"), syncJson(job.trial())},
                 {QStringLiteral("robots"), robots},
                 {QStringLiteral("warnings"), sentencesJson(job.warnings())}},
                lines.join(u'\n'));
    for (const std::string &warning : job.warnings())
        CommandCall::warn(warning);
    return {};
}

} // namespace odo
