// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/json_answers.h"
#include "core/workflow/register_job.h"

namespace odo {

namespace {

const QString camera = QStringLiteral("camera"), layout = QStringLiteral("layout"), pixels = QStringLiteral("pixels"),
              image = QStringLiteral("image"), video = QStringLiteral("video");

QJsonObject answerJson(const RegisterSettings &settings, const FloorRegistration &registration)
{
    QJsonArray markers;
    for (const MarkerError &marker : registration.markers)
        markers.append(QJsonObject{{QStringLiteral("label"), QString::fromStdString(marker.label)},
                                   {QStringLiteral("error_mm"), toMillimetres(marker.errorM)}});
    const Eigen::Vector3d position = registration.worldFromCamera.translation;
    return {{QStringLiteral("camera"), QString::fromStdString(settings.camera)},
            {QStringLiteral("layout"), QString::fromStdString(settings.layout)},
            {QStringLiteral("rms_px"), registration.rmsPx},
            {QStringLiteral("rms_mm"), toMillimetres(registration.rmsM)},
            {QStringLiteral("camera_position_m"), vectorJson(position)},
            {QStringLiteral("height_above_floor_m"), position.z()},
            {QStringLiteral("markers"), markers},
            {QStringLiteral("verdict"), QString::fromStdString(registration.verdict)}};
}

} // namespace

Result<void> runRegister(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("register"),
         QStringLiteral("P.odo --camera CAMERA --layout NAME [--pixels pixels.csv | --image F.png | --video F.mp4] [--json]"),
         1, 1,
         {{camera, QStringLiteral("The camera to register."), QStringLiteral("CAMERA")},
          {layout, QStringLiteral("The marker layout it sees."), QStringLiteral("NAME")},
          {pixels, QStringLiteral("Where the markers are: label,u,v."), QStringLiteral("FILE")},
          {image, QStringLiteral("A picture to find them in."), QStringLiteral("FILE")},
          {video, QStringLiteral("A video to find them in."), QStringLiteral("FILE")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    for (const QString &needed : {camera, layout}) {
        if (!call.isSet(needed))
            return call.wrongCall(QStringLiteral("--%1 is missing").arg(needed));
    }
    if (call.isSet(image) && call.isSet(video))
        return call.wrongCall(QStringLiteral("--image and --video exclude each other"));
    const RegisterSettings settings{call.value(camera), call.value(layout), call.value(pixels),
                                    call.isSet(image) ? call.value(image) : call.value(video), {}};
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    RegisterJob job(settings);
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    const FloorRegistration &registration = job.record().registration;
    call.answer(answerJson(settings, registration), QString::fromStdString(registration.verdict));
    return {};
}

} // namespace odo
