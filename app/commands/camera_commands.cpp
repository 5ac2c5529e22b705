// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/board_options.h"
#include "app/commands/commands.h"
#include "core/base/units.h"
#include "core/capture/camera_source.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/calibrate_job.h"
#include "core/workflow/calibrate/cameras.h"
#include "ui/models/shown_message.h"
#include "ui/testbed/targets/target_sheet.h"

#include <QJsonArray>
#include <QMap>

namespace odo {

Result<void> runCamera(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("camera"),
                      QStringLiteral("add P.odo CAMERA [--device URI]"),
                      3,
                      3,
                      {{option::device, QStringLiteral("Address of the device that delivers its frames."),
                        QStringLiteral("URI")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.positional(0) != QStringLiteral("add"))
        return call.verbNotKnown();
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto added = changing(*project, addCameraWords(call.text(2)), [&] {
        return project->cameras().add({0, call.text(2), call.value(option::device)});
    });
    if (!added)
        return tl::unexpected(added.error());
    const QString name = QString::fromStdString(added->name);
    call.answer({{QStringLiteral("camera"), name}}, QStringLiteral("Camera %1 added.").arg(name));
    return {};
}

namespace {

constexpr qsizetype mostFormatsNamed = 3;

/// The first formats, and how many more there are.
QString formatWords(const QStringList &formats)
{
    const QString words = formats.mid(0, mostFormatsNamed).join(QStringLiteral("; "));
    const qsizetype more = formats.size() - mostFormatsNamed;
    return more > 0 ? words + QStringLiteral("; and %1 more (see --json)").arg(more) : words;
}

} // namespace

Result<void> runCameras(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("cameras"), QStringLiteral("[--json]"), 0, 0, {}}, cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    QJsonArray cameras;
    QStringList lines;
    for (const CameraDescription &camera : listCameras()) {
        const QString uri = QString::fromStdString(camera.uri), name = english(camera.name);
        QStringList formats;
        for (const CameraFormat &format : camera.formats)
            formats << english(format.words);
        cameras.append(QJsonObject{{QStringLiteral("uri"), uri},
                                   {QStringLiteral("kind"), QString::fromStdString(camera.kind)},
                                   {QStringLiteral("name"), name},
                                   {QStringLiteral("serial"), QString::fromStdString(camera.serial)},
                                   {QStringLiteral("formats"), QJsonArray::fromStringList(formats)},
                                   {QStringLiteral("busy"), camera.busy}});
        QStringList about{name};
        if (camera.busy)
            about << QStringLiteral("used by another program");
        else if (!formats.isEmpty())
            about << formatWords(formats);
        lines << QStringLiteral("%1  %2").arg(uri, -20).arg(about.join(QStringLiteral(", ")));
    }
    call.answer({{QStringLiteral("cameras"), cameras}}, lines.join(u'\n'));
    return {};
}

namespace {

Result<CalibrateSettings> calibrateSettings(const CommandCall &call)
{
    CalibrateSettings settings;
    settings.camera = call.text(1);
    for (const QString &file : call.positionals().mid(2))
        settings.files.emplace_back(file.toStdString());
    settings.board = ODO_TRY(boardFrom(call));
    const std::string modelName = call.value(option::model);
    if (modelName == "standard")
        settings.model = LensModel::Standard;
    else if (modelName == "rational")
        settings.model = LensModel::Rational;
    else if (modelName == "fisheye")
        settings.model = LensModel::Fisheye;
    else if (call.isSet(option::model))
        return call.wrongCall(ODO_TEXT("app.model_is", "--model is standard, rational or fisheye"));
    return settings;
}

QJsonObject calibrationJson(const CalibrateJob &job)
{
    const IntrinsicCalibration &calibration = job.calibration();
    QJsonArray rejected;
    std::vector<RejectedImage> unused = calibration.rejected;
    for (RejectedImage &image : calibration.imagesContradicting())
        unused.push_back(std::move(image));
    for (const RejectedImage &image : unused)
        rejected.append(QJsonObject{{QStringLiteral("file"), QString::fromStdString(image.file)},
                                    {QStringLiteral("reason"), english(image.reason)}});
    QJsonObject perImage;
    QJsonArray repeated;
    for (const CalibrationImage &image : calibration.images) {
        if (!image.repeats.isEmpty())
            repeated.append(QJsonObject{{QStringLiteral("file"), QString::fromStdString(image.view.source)},
                                        {QStringLiteral("reason"), english(image.repeats)}});
        perImage.insert(QString::fromStdString(image.view.source), image.rmsPx);
    }
    QJsonObject answer{{QStringLiteral("camera"), QString::fromStdString(job.settings().camera)},
                       {QStringLiteral("rms_px"), calibration.rmsPx},
                       {QStringLiteral("images_used"), qint64(calibration.imagesUsed())},
                       {QStringLiteral("images_rejected"), rejected},
                       {QStringLiteral("images_repeated"), repeated},
                       {QStringLiteral("intrinsics"), intrinsicsJson(calibration.intrinsics)},
                       {QStringLiteral("per_image_rms_px"), perImage},
                       {QStringLiteral("crossvalidation_px"), calibration.crossValidationPx},
                       {QStringLiteral("lens_reason"), english(calibration.modelReason)},
                       {QStringLiteral("corners_left_out"), qint64(calibration.cornersLeftOut())},
                       {QStringLiteral("corners_disagreeing"), calibration.disagreeingPart},
                       {QStringLiteral("verdict"), english(calibration.verdict)}};
    if (calibration.onFloor)
        answer.insert(QStringLiteral("on_floor_mm"),
                      QJsonObject{{QStringLiteral("middle"), toMillimetres(calibration.onFloor->middleM)},
                                  {QStringLiteral("worst"), toMillimetres(calibration.onFloor->worstM)},
                                  {QStringLiteral("where"), english(calibration.onFloor->worstWhere)}});
    return answer;
}

} // namespace

Result<void> runCalibrate(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("calibrate"),
         QStringLiteral("P.odo CAMERA IMAGE|VIDEO... [--board 9x6] [--square 25mm] "
                        "[--pattern checkerboard|charuco] [--model standard|rational|fisheye] [--json]"),
         3, -1,
         boardOptions() +
             QList<QCommandLineOption>{
                 {option::model,
                  QStringLiteral("Lens model; default: the one that best predicts held-out images."),
                  QStringLiteral("MODEL")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    auto settings = ODO_TRY(calibrateSettings(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    CalibrateJob job(std::move(settings));
    ODO_TRY(runToEnd(job, *project, call.control()));
    call.answer(calibrationJson(job),
                QStringLiteral("%1\nRMS %2 px over %3; %4 not used.")
                    .arg(english(job.calibration().verdict))
                    .arg(job.calibration().rmsPx, 0, 'f', 3)
                    .arg(counted(job.calibration().imagesUsed(), QStringLiteral("image")))
                    .arg(job.calibration().rejected.size() + job.calibration().imagesContradicting().size() +
                         job.calibration().imagesRepeated()));
    return {};
}

Result<void> runIntrinsics(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("intrinsics"),
         QStringLiteral("import P.odo CAMERA FILE [--entry NAME] | export P.odo CAMERA FILE [--force]"),
         4,
         4,
         {{option::entry, QStringLiteral("Which of several cameras in the file."), QStringLiteral("NAME")},
          forceOption()}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const bool importing = call.positional(0) == QStringLiteral("import");
    if (!importing && call.positional(0) != QStringLiteral("export"))
        return call.wrongCall(
            ODO_TEXT("app.neither_import_nor_export", "'%1' is neither import nor export")(call.text(0)));
    const auto project =
        ODO_TRY(call.openProject(1, importing ? Project::Access::ReadWrite : Project::Access::ReadOnly));
    QJsonObject json{{QStringLiteral("camera"), call.positional(2)},
                     {QStringLiteral("file"), call.positional(3)}};
    if (importing) {
        const auto record =
            ODO_TRY(importIntrinsics(*project, call.text(2), call.text(3), call.value(option::entry)));
        json.insert(QStringLiteral("intrinsics"), intrinsicsJson(record.calibration.intrinsics));
    } else {
        const auto output =
            ODO_TRY(CommandOutput::of(call, call.positional(3), FileKind::Yaml, project.get()));
        ODO_TRY(exportIntrinsics(*project, call.text(2), output.target()));
        return output.finish(call, json, QStringLiteral("Wrote %1.").arg(call.positional(3)));
    }
    call.answer(json, QStringLiteral("Camera %1 has new intrinsics.").arg(call.positional(2)));
    return {};
}

namespace {

Result<TargetSpec> targetFrom(const CommandCall &call)
{
    static const QMap<QString, TargetKind> kinds{{QStringLiteral("checkerboard"), TargetKind::Checkerboard},
                                                 {QStringLiteral("charuco"), TargetKind::Charuco},
                                                 {QStringLiteral("tags"), TargetKind::Tags},
                                                 {QStringLiteral("rings"), TargetKind::Rings}};
    static const QMap<QString, QPageSize::PageSizeId> papers{{QStringLiteral("a4"), QPageSize::A4},
                                                             {QStringLiteral("letter"), QPageSize::Letter},
                                                             {QStringLiteral("a3"), QPageSize::A3}};
    TargetSpec spec;
    if (!kinds.contains(call.positional(0)))
        return call.wrongCall(ODO_TEXT("app.target_not_known",
                                       "'%1' is not checkerboard, charuco, tags or rings")(call.text(0)));
    spec.kind = kinds.value(call.positional(0));
    const QString paper = QString::fromStdString(call.value(option::paper)).toLower();
    if (!papers.contains(paper))
        return call.wrongCall(ODO_TEXT("app.target_paper_is", "--paper is a4, letter or a3"));
    spec.paper = papers.value(paper);
    const auto board = call.sizePair(option::board);
    const auto square = call.lengthM(option::square), size = call.lengthM(option::size);
    if (!board)
        return tl::unexpected(board.error());
    if (!square || !size)
        return tl::unexpected(square ? size.error() : square.error());
    spec.columns = int(board->first);
    spec.rows = int(board->second);
    spec.squareM = *square;
    spec.markerM = *size;
    spec.labels.clear();
    for (const QString &label :
         QString::fromStdString(call.value(option::labels)).split(QLatin1Char(','), Qt::SkipEmptyParts))
        spec.labels << label.trimmed();
    return spec;
}

} // namespace

Result<void> runTarget(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("target"),
         QStringLiteral("checkerboard|charuco|tags|rings -o FILE.pdf [--force] [--paper a4|letter|a3] "
                        "[--board 9x6] [--square 25mm] "
                        "[--size 150mm] [--labels O,U,V,D]"),
         1, 1,
         outputOptions(QStringLiteral("The PDF to write.")) +
             QList<QCommandLineOption>{
                 {option::paper, QStringLiteral("Paper size."), QStringLiteral("PAPER"),
                  QStringLiteral("a4")},
                 {option::board, QStringLiteral("Inner corners of a board."), QStringLiteral("CxR"),
                  QStringLiteral("9x6")},
                 {option::square, QStringLiteral("Side of a square of a board."), QStringLiteral("LENGTH"),
                  QStringLiteral("25mm")},
                 {option::size, QStringLiteral("Side of a tag's black square, diameter of a ring."),
                  QStringLiteral("LENGTH"), QStringLiteral("150mm")},
                 {option::labels, QStringLiteral("Labels of the floor markers, in the order of the layout."),
                  QStringLiteral("LABELS"), QStringLiteral("O,U,V,D")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::output))
        return call.missing(option::output);
    const auto spec = ODO_TRY(targetFrom(call));
    const QString file = QString::fromStdString(call.value(option::output));
    const auto output = ODO_TRY(CommandOutput::of(call, file, FileKind::Pdf, nullptr));
    ODO_TRY(writeTargetPdf(spec, output.target()));
    return output.finish(call,
                         {{QStringLiteral("file"), file},
                          {QStringLiteral("sheets"), isBoard(spec.kind) ? 1 : int(spec.labels.size())}},
                         QStringLiteral("Wrote %1. Print it at 100 % and check its ruler.").arg(file));
}

} // namespace odo
