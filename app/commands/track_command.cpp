// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/json_answers.h"
#include "app/option_names.h"
#include "app/task_answers.h"
#include "core/base/units.h"
#include "core/workflow/track_job.h"

namespace odo {

namespace {

QJsonObject robotJson(const TrackedRobot &robot)
{
    const Profile &profile = robot.analysis.profile;
    QJsonObject json{{QStringLiteral("frames"), qint64(robot.frames)},
                     {QStringLiteral("tracked"), qint64(robot.tracked)},
                     {QStringLiteral("spikes"), qint64(profile.spikes.size())},
                     {QStringLiteral("mean_view_disagreement_mm"), toMillimetres(profile.meanViewDisagreementM)},
                     {QStringLiteral("look"), robot.isFoundByColour ? QStringLiteral("colour") : QStringLiteral("any")},
                     {QStringLiteral("height_m"), profile.heightM},
                     {QStringLiteral("path_length_m"), metricValue(profile, "path_length")},
                     {QStringLiteral("duration_s"), metricValue(profile, "duration")},
                     {QStringLiteral("mean_speed_m_s"), metricValue(profile, "mean_speed")},
                     {QStringLiteral("max_speed_m_s"), metricValue(profile, "max_speed")}};
    json.insert(QStringLiteral("clearance_mm"), profile.clearanceM ? QJsonValue(toMillimetres(*profile.clearanceM)) : QJsonValue());
    json.insert(QStringLiteral("doubtful_s"), optionalJson(robot.doubtfulS));
    json.insert(QStringLiteral("doubts"), doubtsJson(robot.analysis.doubtfulNames));
    json.insert(QStringLiteral("occlusions"), occlusionsJson(robot.occlusions));
    insertTaskAnswers(json, profile);
    return json;
}

QString robotText(const TrackedRobot &robot)
{
    const Profile &profile = robot.analysis.profile;
    return QStringLiteral("%1: %2 of %3 frames, %4, path %5 m in %6 s, top speed %7 m/s%8")
        .arg(QString::fromStdString(robot.name))
        .arg(robot.tracked)
        .arg(robot.frames)
        .arg(counted(profile.spikes.size(), QStringLiteral("spike")))
        .arg(metricValue(profile, "path_length"), 0, 'f', 3)
        .arg(metricValue(profile, "duration"), 0, 'f', 2)
        .arg(metricValue(profile, "max_speed"), 0, 'f', 3)
        .arg(taskRemark(profile));
}

/// "R=VIEW,SECONDS,X,Y", or "R=none".
Result<std::vector<RobotPointer>> pointersOf(const CommandCall &call)
{
    const auto pairs = call.pairs(option::at);
    if (!pairs)
        return tl::unexpected(pairs.error());
    constexpr qsizetype figures = 3;
    std::vector<RobotPointer> pointers;
    for (const auto &[robot, where] : *pairs) {
        RobotPointer &pointer = pointers.emplace_back(RobotPointer{robot});
        if (where == "none")
            continue;
        const QStringList parts = QString::fromStdString(where).split(u',');
        const qsizetype first = parts.size() - figures;
        const bool isComplete = first > 0;
        const auto figure = [&](qsizetype i) { return isComplete ? parseNumber(parts[first + i].toStdString()) : Result<double>(); };
        const auto time = figure(0), x = figure(1), y = figure(2);
        if (!isComplete || !time || !x || !y)
            return call.wrongCall(QStringLiteral("--at '%1=%2' is not of the form R=VIEW,SECONDS,X,Y or R=none").arg(QString::fromStdString(robot), QString::fromStdString(where)));
        pointer.view = parts.first(first).join(u',').toStdString();
        pointer.timeS = *time;
        pointer.pixel = {*x, *y};
    }
    return pointers;
}

} // namespace

Result<void> runTrack(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("track"),
                      QStringLiteral("P.odo TRIAL [--robot R]... [--at R=VIEW,SECONDS,X,Y]... [--smoother rts|savgol|tracker|none] [--again] [--json]"), 2, 2,
                      {{option::robot, QStringLiteral("A robot to look for."), QStringLiteral("R")},
                       {option::at, QStringLiteral("Where a robot without a colour is in a picture, in pixels, if the wrong thing was followed; R=none takes it back."), QStringLiteral("R=VIEW,SECONDS,X,Y")},
                       {option::smoother, QStringLiteral("How the curves are made."), QStringLiteral("NAME")},
                       {option::again, QStringLiteral("Analyse the stored observations anew, without decoding the videos.")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    TrackSettings settings;
    settings.robots = call.texts(option::robot);
    settings.again = call.isSet(option::again);
    if (call.isSet(option::smoother)) {
        const auto known = parseSmoother(call.value(option::smoother));
        if (!known)
            return call.wrongCall(QStringLiteral("--smoother is rts, savgol, tracker or none"));
        settings.smoother = *known;
    }
    auto pointers = pointersOf(call);
    if (!pointers)
        return tl::unexpected(pointers.error());
    if (settings.again && !pointers->empty())
        return call.wrongCall(QStringLiteral("--at needs the videos, and --again does not read them"));
    settings.pointers = std::move(*pointers);
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    TrackJob job(call.text(1), std::move(settings));
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    const TrackOutcome &outcome = job.outcome();
    QJsonObject robots;
    QStringList lines;
    for (const TrackedRobot &tracked : outcome.robots) {
        robots.insert(QString::fromStdString(tracked.name), robotJson(tracked));
        lines << robotText(tracked);
    }
    call.answer({{QStringLiteral("trial"), QString::fromStdString(outcome.trial)},
                 {QStringLiteral("robots"), robots},
                 {QStringLiteral("warnings"), sentencesJson(outcome.warnings)},
                 {QStringLiteral("wall_s"), outcome.wallS},
                 {QStringLiteral("decode_s"), outcome.decodeS},
                 {QStringLiteral("frames_per_s"), outcome.framesPerSecond}},
                lines.join(u'\n'));
    for (const std::string &warning : outcome.warnings)
        CommandCall::warn(warning);
    return {};
}

} // namespace odo
