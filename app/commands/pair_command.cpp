// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/board_options.h"
#include "app/commands/commands.h"
#include "core/base/units.h"
#include "core/workflow/calibrate/calibrate_pair_job.h"

#include <QJsonArray>

namespace odo {

namespace {

/// "--a 1.png 2.png --b 3.png" with the option before each of its words, as a shell's wildcards leave it out.
QStringList withOptionBeforeEach(const QStringList &arguments, const QStringList &listOptions)
{
    QStringList spread;
    QString current;
    bool isFirst = false;
    for (const QString &word : arguments) {
        if (word.startsWith(u'-') && word != u"-") {
            const QString name = word.section(u'=', 0, 0);
            current = listOptions.contains(name) ? name : QString();
            isFirst = !word.contains(u'=');
        } else if (!current.isEmpty()) {
            if (!isFirst)
                spread << current;
            isFirst = false;
        }
        spread << word;
    }
    return spread;
}

QJsonArray rotationJson(const Eigen::Quaterniond &rotation)
{
    QJsonArray rows;
    const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
    for (int row = 0; row < 3; ++row)
        rows.append(vectorJson(Eigen::Vector3d(matrix.row(row))));
    return rows;
}

const std::string &cameraOf(const CalibratePairJob &job, std::size_t side)
{
    return job.settings().cameras[side];
}

double degreesOf(double radians)
{
    return radians * 180 / EIGEN_PI;
}

QJsonObject pairJson(const CalibratePairJob &job)
{
    const CameraPair &pair = job.pair();
    QJsonArray used, rejected;
    for (const UsedPair &each : pair.used)
        used.append(QJsonObject{{QStringLiteral("a"), QString::fromStdString(each.a)},
                                {QStringLiteral("b"), QString::fromStdString(each.b)},
                                {QStringLiteral("rms_px"), each.rmsPx},
                                {QStringLiteral("corners_left_out"), qint64(each.cornersLeftOut)}});
    for (const RejectedPair &each : pair.rejected)
        rejected.append(QJsonObject{{QStringLiteral("a"), QString::fromStdString(each.a)},
                                    {QStringLiteral("b"), QString::fromStdString(each.b)},
                                    {QStringLiteral("reason"), english(each.reason)}});
    QJsonObject json{
        {QStringLiteral("cameras"),
         namesJson({job.settings().cameras.begin(), job.settings().cameras.end()})},
        {QStringLiteral("baseline_mm"), toMillimetres(pair.baselineM)},
        {QStringLiteral("sigma_mm"), toMillimetres(pair.baselineSigmaM)},
        {QStringLiteral("rms_px"), pair.rmsPx},
        {QStringLiteral("pairs_used"), qint64(pair.used.size())},
        {QStringLiteral("square_mm"), QJsonObject{{QStringLiteral("mean"), toMillimetres(pair.squares.meanM)},
                                                  {QStringLiteral("sd"), toMillimetres(pair.squares.sdM)}}},
        {QStringLiteral("pairs"), used},
        {QStringLiteral("pairs_rejected"), rejected},
        {QStringLiteral("corners_left_out"), qint64(pair.cornersLeftOut())},
        {QStringLiteral("rotation"), rotationJson(pair.bFromA.rotation)},
        {QStringLiteral("translation_mm"), vectorJson(millimetresPerMetre * pair.bFromA.translation)},
        {QStringLiteral("calibrated"), namesJson(job.calibrated())},
        {QStringLiteral("verdict"), english(pair.verdict)}};
    if (const auto &joined = job.joined())
        json.insert(
            QStringLiteral("registered"),
            QJsonObject{
                {QStringLiteral("camera"), QString::fromStdString(cameraOf(job, joined->side))},
                {QStringLiteral("through"), QString::fromStdString(cameraOf(job, 1 - joined->side))},
                {QStringLiteral("layout"), QString::fromStdString(joined->layout)},
                {QStringLiteral("floor_sigma_mm"), toMillimetres(joined->record.registration.floorSigmaM)},
                {QStringLiteral("verdict"), english(joined->record.registration.verdict)}});
    if (const auto &difference = job.difference())
        json.insert(
            QStringLiteral("registrations_differ"),
            QJsonObject{{QStringLiteral("distance_mm"), toMillimetres(difference->distanceM)},
                        {QStringLiteral("distance_sigma_mm"), toMillimetres(difference->distanceSigmaM)},
                        {QStringLiteral("angle_deg"), degreesOf(difference->angle)},
                        {QStringLiteral("angle_sigma_deg"), degreesOf(difference->angleSigma)},
                        {QStringLiteral("significant"), difference->isSignificant}});
    return json;
}

/// What the pair means for the floor.
QStringList floorLines(const CalibratePairJob &job)
{
    QStringList lines;
    if (const auto &joined = job.joined())
        lines << QStringLiteral("Camera %1 was registered to the floor: %2")
                     .arg(QString::fromStdString(cameraOf(job, joined->side)),
                          english(joined->record.registration.verdict));
    if (!job.whyNotJoined().isEmpty())
        lines << QStringLiteral("The other camera was not registered: %1.").arg(english(job.whyNotJoined()));
    if (const auto &difference = job.difference())
        lines << QStringLiteral(
                     "By the registrations, camera %1 is %2 mm (±%3) and %4° (±%5°) from there: %6.")
                     .arg(QString::fromStdString(cameraOf(job, 1)))
                     .arg(toMillimetres(difference->distanceM), 0, 'f', 1)
                     .arg(toMillimetres(difference->distanceSigmaM), 0, 'f', 1)
                     .arg(degreesOf(difference->angle), 0, 'f', 2)
                     .arg(degreesOf(difference->angleSigma), 0, 'f', 2)
                     .arg(difference->isSignificant
                              ? QStringLiteral("more than their uncertainty, so check the camera positions")
                              : QStringLiteral("within uncertainty"));
    return lines;
}

QString pairText(const CalibratePairJob &job)
{
    QStringList lines{english(job.pair().verdict)};
    for (const std::string &camera : job.calibrated())
        lines << QStringLiteral("Camera %1 was calibrated from these images.")
                     .arg(QString::fromStdString(camera));
    lines += floorLines(job);
    for (const RejectedPair &pair : job.pair().rejected)
        lines << QStringLiteral("Not used: %1, %2: %3")
                     .arg(QString::fromStdString(pair.a), QString::fromStdString(pair.b),
                          english(pair.reason));
    return lines.join(u'\n');
}

std::vector<std::filesystem::path> filesOf(const CommandCall &call, const QString &option)
{
    std::vector<std::filesystem::path> files;
    for (const std::string &file : call.texts(option))
        files.emplace_back(file);
    return files;
}

} // namespace

Result<void> runCalibratePair(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("calibrate-pair"),
                      QStringLiteral("P.odo A B --a FILE... --b FILE... [--board 9x6] [--square 25mm] "
                                     "[--pattern checkerboard|charuco] [--json]"),
                      3, 3,
                      QList<QCommandLineOption>{
                          {option::filesOfA, QStringLiteral("Images or videos of the board by camera A."),
                           QStringLiteral("FILE")},
                          {option::filesOfB, QStringLiteral("Those of camera B, taken at the same moments."),
                           QStringLiteral("FILE")}} +
                          boardOptions()},
                     cancel);
    const QStringList lists{QStringLiteral("--a"), QStringLiteral("--b"), QStringLiteral("-a"),
                            QStringLiteral("-b")};
    if (const auto parsed = call.parse(withOptionBeforeEach(arguments, lists)); !parsed || !*parsed)
        return parsed.map([](bool) {});
    for (const QString &needed : {option::filesOfA, option::filesOfB})
        if (!call.isSet(needed))
            return call.missing(needed);
    CalibratePairSettings settings{{call.text(1), call.text(2)},
                                   {filesOf(call, option::filesOfA), filesOf(call, option::filesOfB)},
                                   ODO_TRY(boardFrom(call))};
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadWrite));
    CalibratePairJob job(std::move(settings));
    ODO_TRY(runToEnd(job, *project, call.control()));
    call.answer(pairJson(job), pairText(job));
    return {};
}

} // namespace odo
