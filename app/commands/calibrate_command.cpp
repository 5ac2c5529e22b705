// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "app/counted.h"
#include "app/json_answers.h"
#include "app/option_names.h"
#include "core/base/units.h"
#include "core/workflow/calibrate_job.h"

namespace odo {

namespace {

Result<CalibrateSettings> calibrateSettings(const CommandCall &call)
{
    CalibrateSettings settings;
    settings.camera = call.text(1);
    for (const QString &file : call.positionals().mid(2))
        settings.files.emplace_back(file.toStdString());
    if (call.isSet(option::board)) {
        const auto size = call.sizePair(option::board);
        if (!size)
            return tl::unexpected(size.error());
        settings.board.columns = int(size->first);
        settings.board.rows = int(size->second);
        if (settings.board.columns < 3 || settings.board.rows < 3 || settings.board.columns > 100 ||
            settings.board.rows > 100)
            return call.wrongCall(QStringLiteral("--board counts inner corners, 3x3 to 100x100"));
    }
    if (call.isSet(option::square)) {
        const auto side = call.lengthM(option::square);
        if (!side)
            return tl::unexpected(side.error());
        settings.board.squareM = *side;
    }
    const std::string patternName = call.value(option::pattern);
    if (patternName == "charuco")
        settings.board.pattern = BoardPattern::Charuco;
    else if (patternName == "checkerboard")
        settings.board.pattern = BoardPattern::Checkerboard;
    else if (call.isSet(option::pattern))
        return call.wrongCall(QStringLiteral("--pattern is checkerboard or charuco"));
    const std::string modelName = call.value(option::model);
    if (modelName == "standard")
        settings.model = LensModel::Standard;
    else if (modelName == "rational")
        settings.model = LensModel::Rational;
    else if (modelName == "fisheye")
        settings.model = LensModel::Fisheye;
    else if (call.isSet(option::model))
        return call.wrongCall(QStringLiteral("--model is standard, rational or fisheye"));
    return settings;
}

QJsonObject calibrationJson(const CalibrateJob &job)
{
    const IntrinsicCalibration &calibration = job.calibration();
    QJsonArray rejected;
    for (const RejectedPicture &picture : calibration.rejected)
        rejected.append(QJsonObject{{QStringLiteral("file"), QString::fromStdString(picture.file)},
                                    {QStringLiteral("reason"), QString::fromStdString(picture.reason)}});
    QJsonObject perImage;
    for (const CalibrationPicture &picture : calibration.pictures)
        perImage.insert(QString::fromStdString(picture.view.source), picture.rmsPx);
    QJsonObject answer{{QStringLiteral("camera"), QString::fromStdString(job.settings().camera)},
            {QStringLiteral("rms_px"), calibration.rmsPx},
            {QStringLiteral("images_used"), qint64(calibration.picturesUsed())},
            {QStringLiteral("images_rejected"), rejected},
            {QStringLiteral("intrinsics"), intrinsicsJson(calibration.intrinsics)},
            {QStringLiteral("per_image_rms_px"), perImage},
            {QStringLiteral("crossvalidation_px"), calibration.crossValidationPx},
            {QStringLiteral("lens_reason"), QString::fromStdString(calibration.lensReason)},
            {QStringLiteral("corners_left_out"), qint64(calibration.cornersLeftOut())},
            {QStringLiteral("corners_disagreeing"), calibration.disagreeingPart},
            {QStringLiteral("verdict"), QString::fromStdString(calibration.verdict)}};
    if (calibration.onFloor)
        answer.insert(QStringLiteral("on_floor_mm"),
                      QJsonObject{{QStringLiteral("middle"), toMillimetres(calibration.onFloor->middleM)},
                                  {QStringLiteral("worst"), toMillimetres(calibration.onFloor->worstM)},
                                  {QStringLiteral("where"), QString::fromStdString(calibration.onFloor->worstWhere)}});
    return answer;
}

} // namespace

Result<void> runCalibrate(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("calibrate"),
                      QStringLiteral("P.odo CAMERA IMAGE|VIDEO... [--board 9x6] [--square 25mm] "
                                     "[--pattern checkerboard|charuco] [--model standard|rational|fisheye] [--json]"),
                      3, -1,
                      {{option::board, QStringLiteral("Inner corners; found out when not given."), QStringLiteral("CxR")},
                       {option::square, QStringLiteral("Side of a square."), QStringLiteral("LENGTH")},
                       {option::pattern, QStringLiteral("What is printed on the board; found out when not given."), QStringLiteral("PATTERN")},
                       {option::model, QStringLiteral("How the lens is modelled; the one that foretells best when not given."), QStringLiteral("MODEL")}}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    auto settings = calibrateSettings(call);
    if (!settings)
        return tl::unexpected(settings.error());
    const auto project = call.openProject(0, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    CalibrateJob job(std::move(*settings));
    if (auto done = runToEnd(job, **project, call.control()); !done)
        return done;
    call.answer(calibrationJson(job), QStringLiteral("%1\nRMS %2 px over %3; %4 not used.")
                                          .arg(QString::fromStdString(job.calibration().verdict))
                                          .arg(job.calibration().rmsPx, 0, 'f', 3)
                                          .arg(counted(job.calibration().picturesUsed(), QStringLiteral("picture")))
                                          .arg(job.calibration().rejected.size()));
    return {};
}

} // namespace odo
