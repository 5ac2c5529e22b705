// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/base/error.h"
#include "core/exchange/labelled_points.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/camera_position_job.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/register_job.h"
#include "core/workflow/track/stored_verdicts.h"

namespace odo {

namespace {

QString intrinsicsSourceName(IntrinsicsSource source)
{
    switch (source) {
    case IntrinsicsSource::Calibration:
        return QStringLiteral("calibration");
    case IntrinsicsSource::Floor:
        return QStringLiteral("floor");
    case IntrinsicsSource::Assumed:
        break;
    }
    return QStringLiteral("assumed");
}

QString patternName(ResidualPattern pattern)
{
    switch (pattern) {
    case ResidualPattern::Intrinsics:
        return QStringLiteral("lens");
    case ResidualPattern::Layout:
        return QStringLiteral("layout");
    case ResidualPattern::None:
        break;
    }
    return QStringLiteral("none");
}

/// sigma_fx is null where the lens states no uncertainty.
QJsonObject lensJson(const Intrinsics &lens, bool isCalibrated)
{
    QJsonObject json = intrinsicsJson(lens);
    json.insert(QStringLiteral("source"), intrinsicsSourceName(intrinsicsSourceOf(lens, isCalibrated)));
    json.insert(QStringLiteral("sigma_fx"),
                lens.covariance.size() > 0 ? QJsonValue(std::sqrt(lens.covariance(0, 0))) : QJsonValue());
    return json;
}

QJsonObject registrationJson(const std::string &cameraName, const std::string &layoutName,
                             const FloorRegistration &registration, bool isLensCalibrated)
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
            {QStringLiteral("lens"), lensJson(registration.intrinsics, isLensCalibrated)},
            {QStringLiteral("residual_pattern"), patternName(registration.residualPattern)},
            {QStringLiteral("verdict"), english(registration.verdict)}};
}

/// "LABEL=U,V" of each --hint.
Result<std::vector<MarkerPixel>> hintsOf(const CommandCall &call)
{
    const auto pairs = ODO_TRY(call.pairs(option::hint));
    std::vector<MarkerPixel> hints;
    for (const auto &[label, location] : pairs) {
        const auto comma = location.find(',');
        const auto u = parseNumber(location.substr(0, comma));
        const auto v = comma == std::string::npos ? u : parseNumber(location.substr(comma + 1));
        if (comma == std::string::npos || !u || !v)
            return call.wrongCall(ODO_TEXT("app.hint_takes", "--hint takes LABEL=U,V"));
        hints.push_back({label, {*u, *v}});
    }
    return hints;
}

Result<void> registerByMarkers(CommandCall &call)
{
    auto hints = ODO_TRY(hintsOf(call));
    const RegisterSettings settings{call.value(option::camera),
                                    call.value(option::layout),
                                    call.value(option::pixels),
                                    call.isSet(option::image) ? call.value(option::image)
                                                              : call.value(option::video),
                                    {},
                                    {},
                                    std::move(hints)};
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    RegisterJob job(settings);
    ODO_TRY(runToEnd(job, *project, call.control()));
    const FloorRegistration &registration = job.record().registration;
    const bool isLensCalibrated = job.record().intrinsics != 0;
    call.answer(registrationJson(settings.camera, settings.layout, registration, isLensCalibrated),
                english(registration.verdict));
    return {};
}

Result<void> startRegisterViaCamera(CommandCall &call)
{
    const auto points = ODO_TRY(readSharedPointsCsv(call.value(option::pixels)));
    const RegisterViaCameraSettings settings{call.value(option::camera), call.value(option::through), points};
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    RegisterViaCameraJob job(settings);
    ODO_TRY(runToEnd(job, *project, call.control()));
    const FloorRegistration &registration = job.record().registration;
    QJsonObject answer =
        registrationJson(settings.camera, job.layoutName(), registration, job.record().intrinsics != 0);
    answer.insert(QStringLiteral("through"), QString::fromStdString(settings.reference));
    call.answer(answer, english(registration.verdict));
    return {};
}

Result<void> registerAgain(CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    const auto record = ODO_TRY(registerWithCurrentIntrinsics(*project, call.value(option::camera)));
    const auto used = ODO_TRY(project->layouts().get(record.layout));
    call.answer(registrationJson(call.value(option::camera), used.layout.name, record.registration, true),
                english(record.registration.verdict));
    return {};
}

Result<void> registerTogether(CommandCall &call)
{
    RegisterJointSettings settings{call.value(option::layout)};
    if (call.isSet(option::tape)) {
        settings.tapeSigmaM = ODO_TRY(call.lengthM(option::tape));
    }
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    RegisterJointJob job(settings);
    ODO_TRY(runToEnd(job, *project, call.control()));
    const JointRegistration &outcome = job.joint();
    QJsonArray cameras, markers;
    QStringList lines;
    for (std::size_t i = 0; i < outcome.registrations.size(); ++i) {
        const FloorRegistration &registration = outcome.registrations[i];
        cameras.append(registrationJson(job.cameras()[i], settings.layout, registration,
                                        job.before()[i].intrinsics != 0));
        lines << QString::fromStdString(job.cameras()[i] + ": ±" +
                                        formatNumber(toMillimetres(registration.floorSigmaM), 1) +
                                        " mm among the markers, which fit to " +
                                        formatNumber(toMillimetres(registration.rmsM), 1) + " mm RMS.");
    }
    for (const JointMarker &marker : outcome.markers)
        markers.append(
            QJsonObject{{QStringLiteral("label"), QString::fromStdString(marker.label)},
                        {QStringLiteral("cameras"), marker.cameras},
                        {QStringLiteral("off_x_mm"), toMillimetres(marker.offM.x())},
                        {QStringLiteral("off_y_mm"), toMillimetres(marker.offM.y())},
                        {QStringLiteral("sigma_x_mm"), toMillimetres(std::sqrt(marker.covariance(0, 0)))},
                        {QStringLiteral("sigma_y_mm"), toMillimetres(std::sqrt(marker.covariance(1, 1)))},
                        {QStringLiteral("suspicious"), marker.isSuspicious}});
    lines << english(outcome.verdict);
    call.answer({{QStringLiteral("layout"), QString::fromStdString(settings.layout)},
                 {QStringLiteral("cameras"), cameras},
                 {QStringLiteral("markers"), markers},
                 {QStringLiteral("rms_px"), outcome.rmsPx},
                 {QStringLiteral("verdict"), english(outcome.verdict)}},
                lines.join(u'\n'));
    return {};
}

} // namespace

Result<void> runRegister(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("register"),
         QStringLiteral(
             "P.odo --camera CAMERA (--layout LAYOUT [--pixels pixels.csv | --image F.png | --video "
             "F.mp4 [--hint LABEL=U,V]...] | "
             "--through CAMERA --pixels pairs.csv | --again) [--json] | P.odo --joint --layout "
             "LAYOUT [--tape 2mm] [--json]"),
         1,
         1,
         {{option::camera, QStringLiteral("The camera to register."), QStringLiteral("CAMERA")},
          {option::layout, QStringLiteral("The marker layout it sees."), QStringLiteral("LAYOUT")},
          {option::through, QStringLiteral("A registered camera that sees the same floor points."),
           QStringLiteral("CAMERA")},
          {option::pixels,
           QStringLiteral("Where the markers are: label,u,v; with --through: label,u,v,through_u,through_v."),
           QStringLiteral("FILE")},
          {option::image, QStringLiteral("An image in which to detect the markers."), QStringLiteral("FILE")},
          {option::video, QStringLiteral("A video in which to detect the markers."), QStringLiteral("FILE")},
          {option::again,
           QStringLiteral("Registers again from the same markers, with the current lens calibration.")},
          {option::joint,
           QStringLiteral(
               "Registers all cameras of the layout jointly, from the pixels they were registered with.")},
          {option::tape, QStringLiteral("With --joint: uncertainty of the measured marker positions (2mm)."),
           QStringLiteral("LENGTH")},
          {option::hint,
           QStringLiteral("A marker identified by hand, if the rings look the same from several sides."),
           QStringLiteral("LABEL=U,V")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.isSet(option::joint)) {
        for (const QString &other : {option::again, option::camera, option::through, option::pixels,
                                     option::image, option::video, option::hint}) {
            if (call.isSet(other))
                return call.exclude(option::joint, other);
        }
        if (!call.isSet(option::layout))
            return call.lacks(option::joint, option::layout);
        return registerTogether(call);
    }
    if (!call.isSet(option::camera))
        return call.missing(option::camera);
    if (call.isSet(option::again)) {
        for (const QString &other :
             {option::layout, option::through, option::pixels, option::image, option::video, option::hint}) {
            if (call.isSet(other))
                return call.exclude(option::again, other);
        }
        return registerAgain(call);
    }
    if (call.isSet(option::through)) {
        for (const QString &other : {option::layout, option::image, option::video}) {
            if (call.isSet(other))
                return call.exclude(option::through, other);
        }
        if (!call.isSet(option::pixels))
            return call.lacks(option::through, option::pixels);
        return startRegisterViaCamera(call);
    }
    if (!call.isSet(option::layout))
        return call.missing(option::layout);
    if (call.isSet(option::image) && call.isSet(option::video))
        return call.exclude(option::image, option::video);
    return registerByMarkers(call);
}

namespace {

QString verdictName(CameraPositionCheck::Verdict verdict)
{
    switch (verdict) {
    case CameraPositionCheck::Verdict::CameraMoved:
        return QStringLiteral("camera");
    case CameraPositionCheck::Verdict::MarkersMoved:
        return QStringLiteral("markers");
    case CameraPositionCheck::Verdict::Still:
        break;
    }
    return QStringLiteral("nothing");
}

QJsonObject movedJson(const QString &cameraName, const CameraPositionCheck &check)
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
            {QStringLiteral("missing"), namesJson(check.missing)},
            {QStringLiteral("verdict"), english(check.words)}};
}

} // namespace

Result<void> runCheckPosition(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("moved"),
         QStringLiteral("P.odo --camera CAMERA --image F.png [--json]"),
         1,
         1,
         {{option::camera, QStringLiteral("The registered camera."), QStringLiteral("CAMERA")},
          {option::image, QStringLiteral("A current image from the camera."), QStringLiteral("FILE")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::camera) || !call.isSet(option::image))
        return call.wrongCall(ODO_TEXT("app.camera_and_image_needed", "--camera and --image are needed"));
    // The outcome is stored if the project can be written to, and reported in any case.
    auto project = call.openProject(0, Project::Access::ReadWrite);
    const bool canKeep = project || project.error().code != ErrorCode::ReadOnly;
    if (!canKeep)
        project = call.openProject(0, Project::Access::ReadOnly);
    if (!project)
        return tl::unexpected(project.error());
    CameraPositionJob job({call.value(option::camera), call.value(option::image), {}});
    auto done = job.prepare(**project);
    if (done)
        done = job.run(call.control());
    if (canKeep && done)
        done = job.commit(**project);
    if (canKeep && done)
        done = storeMissingVerdicts(**project);
    else if (canKeep && done.error().code == ErrorCode::Undetermined)
        ODO_TRY(keepUndetermined(**project, call.value(option::camera), done.error()));
    if (!done)
        return done;
    const CameraPositionCheck &check = job.check();
    call.answer(movedJson(QString::fromStdString(call.value(option::camera)), check), english(check.words));
    if (check.verdict == CameraPositionCheck::Verdict::Still)
        return {};
    return fail(ErrorCode::InvalidInput, cameraSubject(call.value(option::camera)),
                check.verdict == CameraPositionCheck::Verdict::CameraMoved
                    ? ODO_TEXT("app.camera_moved", "it has moved since it was registered")
                    : ODO_TEXT("app.marker_moved", "a marker has moved since it was registered"),
                ODO_TEXT("app.see_answer", "see the output for what to do"));
}

namespace {

const std::pair<Revision::Kind, const char *> kinds[] = {{Revision::Kind::Calibration, "calibration"},
                                                         {Revision::Kind::Registration, "registration"}};

QString kindName(Revision::Kind kind)
{
    return QString::fromLatin1(kinds[kind == Revision::Kind::Calibration ? 0 : 1].second);
}

QJsonObject revisionJson(const Revision &revision)
{
    return {{QStringLiteral("kind"), kindName(revision.kind)},
            {QStringLiteral("id"), qint64(revision.id)},
            {QStringLiteral("made"), dateText(revision.made)},
            {QStringLiteral("software_version"), QString::fromStdString(revision.softwareVersion)},
            {QStringLiteral("origin"), english(revision.origin)},
            {QStringLiteral("evidence"), revision.evidence},
            {QStringLiteral("rms_px"), revision.rmsPx},
            {QStringLiteral("verdict"), english(revision.verdict)},
            {QStringLiteral("in_force"), revision.isCurrent},
            {QStringLiteral("trials"), namesJson(revision.trials)}};
}

QString revisionText(const Revision &revision)
{
    QString text = QStringLiteral("%1:%2  %3  %4, %5 px")
                       .arg(kindName(revision.kind))
                       .arg(revision.id)
                       .arg(dateText(revision.made), english(revision.origin))
                       .arg(revision.rmsPx, 0, 'f', 2);
    if (!revision.trials.empty())
        text += QStringLiteral(", ") + counted(revision.trials.size(), QStringLiteral("trial"));
    return revision.isCurrent ? text + QStringLiteral(", in force") : text;
}

/// "registration:7" into its kind and number.
Result<std::pair<Revision::Kind, RecordId>> chosenOf(const CommandCall &call)
{
    const QString text = QString::fromStdString(call.value(option::use));
    bool isNumber = false;
    const RecordId id = text.section(u':', 1).toLongLong(&isNumber);
    for (const auto &[kind, name] : kinds)
        if (isNumber && text.section(u':', 0, 0) == QLatin1String(name))
            return std::pair(kind, id);
    return call.wrongCall(ODO_TEXT("app.use_takes", "--use takes calibration:NUMBER or registration:NUMBER"));
}

} // namespace

Result<void> runRevisions(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("revisions"),
                      QStringLiteral("P.odo CAMERA [--use calibration:N|registration:N] [--json]"),
                      2,
                      2,
                      {{option::use, QStringLiteral("Use this revision until the next one is created."),
                        QStringLiteral("KIND:N")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const auto chosen =
        ODO_TRY(call.isSet(option::use) ? chosenOf(call) : std::pair<Revision::Kind, RecordId>());
    const auto project = ODO_TRY(call.openProject(0, call.isSet(option::use) ? Project::Access::ReadWrite
                                                                             : Project::Access::ReadOnly));
    if (call.isSet(option::use))
        ODO_TRY(chooseRevision(*project, call.text(1), chosen.first, chosen.second));
    const auto revisions = ODO_TRY(revisionsOf(*project, call.text(1)));
    QJsonArray json;
    QStringList lines;
    for (const Revision &revision : revisions) {
        json.append(revisionJson(revision));
        lines << revisionText(revision);
    }
    if (lines.isEmpty())
        lines << QStringLiteral("Camera %1 is neither calibrated nor registered.").arg(call.positional(1));
    call.answer({{QStringLiteral("camera"), call.positional(1)}, {QStringLiteral("revisions"), json}},
                lines.join(u'\n'));
    return {};
}

} // namespace odo
