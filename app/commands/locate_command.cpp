// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/commands.h"
#include "core/exchange/labelled_points.h"
#include "core/files/protected_files.h"
#include "core/workflow/calibrate/floor_readings.h"

#include <QJsonArray>

namespace odo {

namespace {

QJsonObject locatedJson(const LocatedPoint &point)
{
    const auto millimetresOf = [&](Eigen::Index axis) {
        return point.position ? std::optional(toMillimetres(point.position->pointInWorld[axis]))
                              : std::nullopt;
    };
    const auto sigmaOf = [&](Eigen::Index axis) {
        return point.position ? std::optional(toMillimetres(point.position->sigmaM()[axis])) : std::nullopt;
    };
    return {{QStringLiteral("label"), QString::fromStdString(point.label)},
            {QStringLiteral("u"), point.pixel.x()},
            {QStringLiteral("v"), point.pixel.y()},
            {QStringLiteral("x_mm"), optionalJson(millimetresOf(0))},
            {QStringLiteral("y_mm"), optionalJson(millimetresOf(1))},
            {QStringLiteral("sigma_x_mm"), optionalJson(sigmaOf(0))},
            {QStringLiteral("sigma_y_mm"), optionalJson(sigmaOf(1))}};
}

QJsonObject locatedJson(const CommandCall &call, const LocatedPoints &located, double heightM)
{
    QJsonArray points;
    for (const LocatedPoint &point : located.points)
        points.append(locatedJson(point));
    return {{QStringLiteral("camera"), call.positional(1)},
            {QStringLiteral("registration"), qint64(located.registration)},
            {QStringLiteral("height_mm"), toMillimetres(heightM)},
            {QStringLiteral("pixel_sigma_px"), located.pixelSigmaPx},
            {QStringLiteral("lens_assumed"), located.areIntrinsicsAssumed},
            {QStringLiteral("points"), points}};
}

/// What a person should know who reads only the table.
void warnOfOutside(const LocatedPoints &located)
{
    const auto outside = located.outside();
    if (!outside.empty())
        CommandCall::warn(ODO_TEXT("app.points_outside_image", "outside the image of %1: %2")(
            sizeText(located.widthPx, located.heightPx), listed(outside, MessageArgument::Kind::Marker)));
}

Result<double> heightOf(const CommandCall &call)
{
    constexpr double highestM = 1000;
    const auto height = parseLengthM(call.value(option::height));
    if (!height || !(*height >= 0 && *height <= highestM))
        return call.wrongCall(ODO_TEXT("app.not_a_height", "--%1 '%2' is not a length from 0 to 1 km")(
            option::height.toStdString(), call.value(option::height)));
    return *height;
}

} // namespace

Result<void> runLocate(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("locate"),
         QStringLiteral("P.odo CAMERA --pixels points.csv [--height 0mm] [-o out.csv] [--force] [--json]"), 2,
         2,
         outputOptions(QStringLiteral("The table to write; default: standard output.")) +
             QList<QCommandLineOption>{
                 {option::pixels, QStringLiteral("The image points: label,u,v."), QStringLiteral("FILE")},
                 {option::height, QStringLiteral("How high above the floor the points are."),
                  QStringLiteral("LENGTH"), QStringLiteral("0mm")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (!call.isSet(option::pixels))
        return call.missing(option::pixels);
    const double heightM = ODO_TRY(heightOf(call));
    const auto project = ODO_TRY(call.openProject(0, Project::Access::ReadOnly));
    std::optional<CommandOutput> output;
    if (call.isSet(option::output))
        output = ODO_TRY(CommandOutput::of(call, QString::fromStdString(call.value(option::output)),
                                           FileKind::Csv, project.get()));
    const auto located = ODO_TRY(locatePoints(*project, call.text(1), call.value(option::pixels), heightM));
    const std::string table = locatedPointsCsv(located.points);
    if (output)
        ODO_TRY(writeOutput(output->target(), table));
    warnOfOutside(located);
    const QJsonObject json = locatedJson(call, located, heightM);
    if (output)
        return output->finish(
            call, json, QStringLiteral("Wrote %1.").arg(QString::fromStdString(call.value(option::output))));
    call.answer(json, QString::fromStdString(table).chopped(1));
    return {};
}

} // namespace odo
