// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/json_answers.h"
#include "app/option_names.h"
#include "core/exchange/shared_points_csv.h"
#include "core/project/repositories.h"
#include "core/workflow/register_job.h"
#include "core/workflow/register_joint_job.h"
#include "core/workflow/register_through_job.h"

namespace odo {

namespace {

QJsonObject registrationJson(const std::string &cameraName, const std::string &layoutName, const FloorRegistration &registration)
{
    QJsonArray markers;
    for (const MarkerError &marker : registration.markers)
        markers.append(QJsonObject{{QStringLiteral("label"), QString::fromStdString(marker.label)},
                                   {QStringLiteral("error_mm"), toMillimetres(marker.errorM)}});
    const Eigen::Vector3d position = registration.worldFromCamera.translation;
    return {{QStringLiteral("camera"), QString::fromStdString(cameraName)},
            {QStringLiteral("layout"), QString::fromStdString(layoutName)},
            {QStringLiteral("rms_px"), registration.rmsPx},
            {QStringLiteral("rms_mm"), toMillimetres(registration.rmsM)},
            {QStringLiteral("camera_position_m"), vectorJson(position)},
            {QStringLiteral("height_above_floor_m"), position.z()},
            {QStringLiteral("markers"), markers},
            {QStringLiteral("verdict"), QString::fromStdString(registration.verdict)}};
}

/// "LABEL=U,V" of each --hint.
Result<std::vector<MarkerPixel>> hintsOf(const CommandCall &call)
{
    const auto pairs = call.pairs(option::hint);
    if (!pairs)
        return tl::unexpected(pairs.error());
    std::vector<MarkerPixel> hints;
    for (const auto &[label, place] : *pairs) {
        const auto comma = place.find(',');
        const auto u = parseNumber(place.substr(0, comma));
        const auto v = comma == std::string::npos ? u : parseNumber(place.substr(comma + 1));
        if (comma == std::string::npos || !u || !v)
            return call.wrongCall(QStringLiteral("--hint takes LABEL=U,V"));
        hints.push_back({label, {*u, *v}});
    }
    return hints;
}

Result<void> registerByMarkers(CommandCall &call)
{
    auto hints = hintsOf(call);
    if (!hints)
        return tl::unexpected(hints.error());
    const RegisterSettings settings{call.value(option::camera), call.value(option::layout), call.value(option::pixels),
                                    call.isSet(option::image) ? call.value(option::image) : call.value(option::video), {}, {}, std::move(*hints)};
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    RegisterJob job(settings);
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    const FloorRegistration &registration = job.record().registration;
    call.answer(registrationJson(settings.camera, settings.layout, registration), QString::fromStdString(registration.verdict));
    return {};
}

Result<void> registerThroughCamera(CommandCall &call)
{
    const auto points = readSharedPointsCsv(call.value(option::pixels));
    if (!points)
        return tl::unexpected(points.error());
    const RegisterThroughSettings settings{call.value(option::camera), call.value(option::through), *points};
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    RegisterThroughJob job(settings);
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    const FloorRegistration &registration = job.record().registration;
    QJsonObject answer = registrationJson(settings.camera, job.layoutName(), registration);
    answer.insert(QStringLiteral("through"), QString::fromStdString(settings.through));
    call.answer(answer, QString::fromStdString(registration.verdict));
    return {};
}

Result<void> registerAgain(CommandCall &call)
{
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    const auto record = registerWithLensInForce(**project, call.value(option::camera));
    if (!record)
        return tl::unexpected(record.error());
    const auto used = (*project)->layouts().get(record->layout);
    if (!used)
        return tl::unexpected(used.error());
    call.answer(registrationJson(call.value(option::camera), used->layout.name, record->registration), QString::fromStdString(record->registration.verdict));
    return {};
}

Result<void> registerTogether(CommandCall &call)
{
    RegisterJointSettings settings{call.value(option::layout)};
    if (call.isSet(option::tape)) {
        const auto sigma = call.lengthM(option::tape);
        if (!sigma)
            return tl::unexpected(sigma.error());
        settings.tapeSigmaM = *sigma;
    }
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    RegisterJointJob job(settings);
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    const JointRegistration &outcome = job.joint();
    QJsonArray cameras, markers;
    QStringList lines;
    for (std::size_t i = 0; i < outcome.registrations.size(); ++i) {
        const FloorRegistration &registration = outcome.registrations[i];
        cameras.append(registrationJson(job.cameras()[i], settings.layout, registration));
        lines << QString::fromStdString(job.cameras()[i] + ": ±" + formatNumber(toMillimetres(registration.floorSigmaM), 1) +
                                        " mm among the markers, which fit to " +
                                        formatNumber(toMillimetres(registration.rmsM), 1) + " mm RMS.");
    }
    for (const JointMarker &marker : outcome.markers)
        markers.append(QJsonObject{{QStringLiteral("label"), QString::fromStdString(marker.label)},
                                   {QStringLiteral("cameras"), marker.cameras},
                                   {QStringLiteral("off_x_mm"), toMillimetres(marker.offM.x())},
                                   {QStringLiteral("off_y_mm"), toMillimetres(marker.offM.y())},
                                   {QStringLiteral("sigma_x_mm"), toMillimetres(std::sqrt(marker.covariance(0, 0)))},
                                   {QStringLiteral("sigma_y_mm"), toMillimetres(std::sqrt(marker.covariance(1, 1)))},
                                   {QStringLiteral("suspicious"), marker.isSuspicious}});
    lines << QString::fromStdString(outcome.verdict);
    call.answer({{QStringLiteral("layout"), QString::fromStdString(settings.layout)},
                 {QStringLiteral("cameras"), cameras},
                 {QStringLiteral("markers"), markers},
                 {QStringLiteral("rms_px"), outcome.rmsPx},
                 {QStringLiteral("verdict"), QString::fromStdString(outcome.verdict)}},
                lines.join(u'\n'));
    return {};
}

} // namespace

Result<void> runRegister(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("register"),
         QStringLiteral("P.odo --camera CAMERA (--layout NAME [--pixels pixels.csv | --image F.png | --video F.mp4 [--hint LABEL=U,V]...] | "
                        "--through CAMERA --pixels pairs.csv | --again) [--json], or P.odo --joint --layout NAME [--tape 2mm] [--json]"),
         1, 1,
         {{option::camera, QStringLiteral("The camera to register."), QStringLiteral("CAMERA")},
          {option::layout, QStringLiteral("The marker layout it sees."), QStringLiteral("NAME")},
          {option::through, QStringLiteral("A registered camera that sees the same points of the floor."), QStringLiteral("CAMERA")},
          {option::pixels, QStringLiteral("Where the markers are: label,u,v; with --through: label,u,v,through_u,through_v."),
           QStringLiteral("FILE")},
          {option::image, QStringLiteral("A picture to find them in."), QStringLiteral("FILE")},
          {option::video, QStringLiteral("A video to find them in."), QStringLiteral("FILE")},
          {option::again, QStringLiteral("By the markers it was registered with before, with the lens in force now.")},
          {option::joint, QStringLiteral("Registers all cameras of the layout together, by the pixels they were registered with.")},
          {option::tape, QStringLiteral("With --joint: how well the markers' places were measured (2mm)."), QStringLiteral("LENGTH")},
          {option::hint, QStringLiteral("A marker told by hand, where rings look the same from several sides."),
           QStringLiteral("LABEL=U,V")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.isSet(option::joint)) {
        for (const QString &other : {option::again, option::camera, option::through, option::pixels, option::image, option::video, option::hint}) {
            if (call.isSet(other))
                return call.wrongCall(QStringLiteral("--joint and --%1 exclude each other").arg(other));
        }
        if (!call.isSet(option::layout))
            return call.wrongCall(QStringLiteral("--joint needs --layout"));
        return registerTogether(call);
    }
    if (!call.isSet(option::camera))
        return call.wrongCall(QStringLiteral("--camera is missing"));
    if (call.isSet(option::again)) {
        for (const QString &other : {option::layout, option::through, option::pixels, option::image, option::video, option::hint}) {
            if (call.isSet(other))
                return call.wrongCall(QStringLiteral("--again and --%1 exclude each other").arg(other));
        }
        return registerAgain(call);
    }
    if (call.isSet(option::through)) {
        for (const QString &other : {option::layout, option::image, option::video}) {
            if (call.isSet(other))
                return call.wrongCall(QStringLiteral("--through and --%1 exclude each other").arg(other));
        }
        if (!call.isSet(option::pixels))
            return call.wrongCall(QStringLiteral("--through needs --pixels"));
        return registerThroughCamera(call);
    }
    if (!call.isSet(option::layout))
        return call.wrongCall(QStringLiteral("--layout is missing"));
    if (call.isSet(option::image) && call.isSet(option::video))
        return call.wrongCall(QStringLiteral("--image and --video exclude each other"));
    return registerByMarkers(call);
}

} // namespace odo
