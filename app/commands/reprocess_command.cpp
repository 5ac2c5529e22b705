// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/json_answers.h"
#include "app/option_names.h"
#include "core/workflow/reprocess_job.h"

namespace odo {

namespace {

QJsonObject changeJson(const ProfileChange &change)
{
    QJsonArray metrics;
    for (const MetricChange &metric : change.metrics)
        metrics.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(metric.name)},
                                   {QStringLiteral("unit"), QString::fromStdString(metric.unit)},
                                   {QStringLiteral("before"), optionalJson(metric.before)},
                                   {QStringLiteral("after"), optionalJson(metric.after)},
                                   {QStringLiteral("sigma"), optionalJson(metric.sigma)}});
    return {{QStringLiteral("largest_shift_mm"), toMillimetres(change.largestShiftM)},
            {QStringLiteral("largest_at_s"), toSeconds(change.largestAt)},
            {QStringLiteral("rms_shift_mm"), toMillimetres(change.rmsShiftM)},
            {QStringLiteral("spikes_before"), qint64(change.spikesBefore)},
            {QStringLiteral("spikes_after"), qint64(change.spikesAfter)},
            {QStringLiteral("metrics"), metrics},
            {QStringLiteral("verdict"), QString::fromStdString(change.words)}};
}

} // namespace

Result<void> runReprocess(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("reprocess"), QStringLiteral("P.odo TRIAL [--keep] [--json]"), 2, 2,
                      {{option::keep, QStringLiteral("Store the new analyses; without it only what would change is told.")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto project = call.openProject(0, call.isSet(option::keep) ? Project::Access::ReadWrite : Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    ReprocessJob job(call.text(1));
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    if (call.isSet(option::keep))
        if (auto kept = job.keep(**project); !kept)
            return kept;
    QJsonObject robots;
    QStringList lines;
    for (const ReprocessedRobot &robot : job.robots()) {
        robots.insert(QString::fromStdString(robot.name), changeJson(robot.change));
        lines << QStringLiteral("%1: %2").arg(QString::fromStdString(robot.name), QString::fromStdString(robot.change.words));
    }
    if (!call.isSet(option::keep))
        lines << QStringLiteral("Nothing was stored; --keep stores it.");
    call.answer({{QStringLiteral("trial"), call.positional(1)}, {QStringLiteral("robots"), robots}, {QStringLiteral("kept"), call.isSet(option::keep)}},
                lines.join(u'\n'));
    return {};
}

} // namespace odo
