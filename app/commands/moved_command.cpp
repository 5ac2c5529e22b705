// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/json_answers.h"
#include "app/option_names.h"
#include "core/workflow/moved_job.h"

namespace odo {

namespace {

QString verdictName(MovedCheck::Verdict verdict)
{
    switch (verdict) {
    case MovedCheck::Verdict::CameraMoved:
        return QStringLiteral("camera");
    case MovedCheck::Verdict::MarkersMoved:
        return QStringLiteral("markers");
    case MovedCheck::Verdict::Still:
        break;
    }
    return QStringLiteral("nothing");
}

QJsonObject movedJson(const QString &cameraName, const MovedCheck &check)
{
    QJsonArray markers;
    for (const MarkerShift &marker : check.markers)
        markers.append(QJsonObject{{QStringLiteral("label"), QString::fromStdString(marker.label)},
                                   {QStringLiteral("shift_px"), marker.shiftPx},
                                   {QStringLiteral("shift_mm"), toMillimetres(marker.shiftM)},
                                   {QStringLiteral("limit_px"), marker.limitPx},
                                   {QStringLiteral("moved"), marker.isMoved()}});
    return {{QStringLiteral("camera"), cameraName},
            {QStringLiteral("moved"), verdictName(check.verdict)},
            {QStringLiteral("shift_px"), check.shiftPx},
            {QStringLiteral("shift_mm"), toMillimetres(check.shiftM)},
            {QStringLiteral("markers"), markers},
            {QStringLiteral("missing"), sentencesJson(check.missing)},
            {QStringLiteral("verdict"), QString::fromStdString(check.words)}};
}

} // namespace

Result<void> runMoved(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("moved"), QStringLiteral("P.odo --camera CAMERA --image F.png [--json]"), 1, 1,
                      {{option::camera, QStringLiteral("The registered camera."), QStringLiteral("CAMERA")},
                       {option::image, QStringLiteral("A picture of it as it stands now."), QStringLiteral("FILE")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::camera) || !call.isSet(option::image))
        return call.wrongCall(QStringLiteral("--camera and --image are needed"));
    // What was found is kept where it can be; where it cannot, it is told all the same.
    auto project = call.openProject(0, Project::Access::ReadWrite);
    const bool canKeep = project || project.error().code != ErrorCode::ReadOnly;
    if (!canKeep)
        project = call.openProject(0, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    MovedJob job({call.value(option::camera), call.value(option::image), {}});
    auto done = job.prepare(**project);
    if (done)
        done = job.run(call.control());
    if (canKeep && done)
        done = job.commit(**project);
    else if (canKeep && done.error().code == ErrorCode::Undetermined)
        if (auto kept = keepNotTold(**project, call.value(option::camera), done.error()); !kept)
            return kept;
    if (!done)
        return done;
    const MovedCheck &check = job.check();
    call.answer(movedJson(QString::fromStdString(call.value(option::camera)), check), QString::fromStdString(check.words));
    if (check.verdict == MovedCheck::Verdict::Still)
        return {};
    return fail(ErrorCode::InvalidInput, "camera '" + call.value(option::camera) + "'",
                check.verdict == MovedCheck::Verdict::CameraMoved ? "it has moved since it was registered"
                                                                  : "a marker has moved since it was registered",
                "see the answer for what to do");
}

} // namespace odo
