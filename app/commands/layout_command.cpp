// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/command_output.h"
#include "app/commands/commands.h"
#include "core/exchange/labelled_points.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/mat_job.h"
#include "ui/models/shown_message.h"

#include <cmath>

namespace odo {

namespace {

QJsonArray markersJson(const MarkerLayout &layout)
{
    QJsonArray markers;
    for (const Marker &marker : layout.markers)
        markers.append(QJsonObject{{QStringLiteral("label"), QString::fromStdString(marker.label)},
                                   {QStringLiteral("x_mm"), toMillimetres(marker.pointInWorld.x())},
                                   {QStringLiteral("y_mm"), toMillimetres(marker.pointInWorld.y())}});
    return markers;
}

QString markersText(const MarkerLayout &layout)
{
    QStringList lines;
    for (const Marker &marker : layout.markers)
        lines << QStringLiteral("%1  %2 mm, %3 mm")
                     .arg(QString::fromStdString(marker.label),
                          QString::fromStdString(formatNumber(toMillimetres(marker.pointInWorld.x()), 1)),
                          QString::fromStdString(formatNumber(toMillimetres(marker.pointInWorld.y()), 1)));
    return lines.join(u'\n');
}

QStringList names(const std::vector<RegisteredCamera> &cameras)
{
    QStringList list;
    for (const RegisteredCamera &camera : cameras)
        list << QString::fromStdString(camera.camera.name);
    return list;
}

Result<void> add(CommandCall &call)
{
    auto layout = ODO_TRY(readLayoutCsv(call.text(3)));
    layout.name = call.text(2);
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto added =
        changing(*project, addLayoutWords(layout.name), [&] { return project->layouts().add(layout); });
    if (!added)
        return tl::unexpected(added.error());
    const int markers = int(layout.markers.size());
    const QString name = QString::fromStdString(added->layout.name);
    call.answer({{QStringLiteral("layout"), name}, {QStringLiteral("markers"), markers}},
                QStringLiteral("Layout %1 has %2.").arg(name, counted(markers, QStringLiteral("marker"))));
    return {};
}

/// Of the printed mat that an image or a video shows.
Result<void> mat(CommandCall &call)
{
    MatSettings settings{{call.text(2)}, std::nullopt};
    if (call.isSet(option::checkLine)) {
        settings.checkLineM = ODO_TRY(call.lengthM(option::checkLine));
    }
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    FindMatJob job(std::move(settings));
    ODO_TRY(runToEnd(job, *project, call.control()));
    const QString name = QString::fromStdString(job.layoutName());
    const int markers = int(matLayout(job.mat()).markers.size());
    if (!call.isSet(option::checkLine))
        CommandCall::warn(
            ODO_TEXT("app.print_taken_as_true",
                     "the print is assumed to be true to scale; measure the mat's check line and give "
                     "it by --check-line, since printers often shrink by 2 to 4 %"));
    call.answer({{QStringLiteral("layout"), name}, {QStringLiteral("markers"), markers}},
                QStringLiteral("Layout %1 has %2.").arg(name, counted(markers, QStringLiteral("marker"))));
    return {};
}

Result<void> list(CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const auto layouts = ODO_TRY(project->layouts().all());
    QJsonArray json;
    QStringList lines;
    for (const LayoutRecord &layout : layouts) {
        const auto cameras = ODO_TRY(camerasOnLayout(*project, layout.id));
        const QStringList registered = names(cameras);
        const QString name = QString::fromStdString(layout.layout.name);
        const int markers = int(layout.layout.markers.size());
        json.append(QJsonObject{{QStringLiteral("name"), name},
                                {QStringLiteral("markers"), markers},
                                {QStringLiteral("cameras"), QJsonArray::fromStringList(registered)}});
        lines << QStringLiteral("%1: %2, %3")
                     .arg(name, counted(markers, QStringLiteral("marker")),
                          registered.isEmpty() ? QStringLiteral("no camera registered")
                                               : registered.join(QStringLiteral(", ")));
    }
    if (lines.isEmpty())
        lines << QStringLiteral("No layout yet.");
    call.answer({{QStringLiteral("layouts"), json}}, lines.join(u'\n'));
    return {};
}

Result<void> show(CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const auto layout = ODO_TRY(project->layouts().find(call.text(2)));
    const auto cameras = ODO_TRY(camerasOnLayout(*project, layout.id));
    call.answer({{QStringLiteral("layout"), call.positional(2)},
                 {QStringLiteral("markers"), markersJson(layout.layout)},
                 {QStringLiteral("cameras"), QJsonArray::fromStringList(names(cameras))}},
                markersText(layout.layout));
    return {};
}

Result<void> exportCsv(CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const auto layout = ODO_TRY(project->layouts().find(call.text(2)));
    const auto output = ODO_TRY(CommandOutput::of(call, call.positional(3), FileKind::Csv, project.get()));
    ODO_TRY(writeLayoutCsv(output.target(), layout.layout));
    return output.finish(
        call, {{QStringLiteral("layout"), call.positional(2)}, {QStringLiteral("file"), call.positional(3)}},
        QStringLiteral("Layout %1 is written to %2.").arg(call.positional(2), call.positional(3)));
}

/// "A,B" split at the only comma.
Result<std::pair<std::string, std::string>> commaPair(const CommandCall &call, const QString &option)
{
    const QStringList parts = QString::fromStdString(call.value(option)).split(u',');
    if (parts.size() != 2 || parts[0].isEmpty() || parts[1].isEmpty())
        return call.wrongCall(
            ODO_TEXT("app.takes_two", "--%1 takes two, with a comma between")(option.toStdString()));
    return std::pair(parts[0].toStdString(), parts[1].toStdString());
}

Result<AxesChange> changeOf(const CommandCall &call)
{
    AxesChange change;
    change.originMarker = call.value(option::origin);
    if (call.isSet(option::originAt)) {
        const auto location = commaPair(call, option::originAt);
        const auto x =
            location ? parseLengthM(location->first) : Result<double>(tl::unexpected(location.error()));
        const auto y = location ? parseLengthM(location->second) : x;
        if (!x || !y)
            return tl::unexpected(!x ? x.error() : y.error());
        change.originM = Eigen::Vector2d(*x, *y);
    }
    if (call.isSet(option::turn)) {
        const auto degrees = ODO_TRY(call.number(option::turn));
        if (std::abs(degrees) > 360)
            return call.wrongCall(ODO_TEXT("app.turn_takes", "--turn takes degrees from -360 to 360"));
        change.turnDegrees = degrees;
    }
    if (call.isSet(option::xAxis)) {
        change.xAlong = ODO_TRY(commaPair(call, option::xAxis));
    }
    if (call.isSet(option::reverse)) {
        const std::string axes = call.value(option::reverse);
        if (axes != "x" && axes != "y" && axes != "xy")
            return call.wrongCall(ODO_TEXT("app.reverse_takes", "--reverse takes x, y or xy"));
        change.reverseX = axes != "y";
        change.reverseY = axes != "x";
    }
    if (call.isSet(option::unit)) {
        change.lengthFactor = ODO_TRY(lengthFactorFrom(call.value(option::unit)));
    }
    return change;
}

Result<void> transform(CommandCall &call)
{
    const auto change = ODO_TRY(changeOf(call));
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto outcome = ODO_TRY(changeLayoutAxes(*project, call.text(2), change));
    QStringList cameras, tasks;
    for (const std::string &camera : outcome.cameras)
        cameras << QString::fromStdString(camera);
    for (const std::string &task : outcome.movedTasks)
        tasks << QString::fromStdString(task);
    const QString carried =
        cameras.isEmpty()
            ? QStringLiteral("No camera is registered to it.")
            : QStringLiteral("Registrations updated: %1.").arg(cameras.join(QStringLiteral(", ")));
    const QString moved = tasks.isEmpty()
                              ? QString()
                              : QStringLiteral("\nTasks updated: %1.").arg(tasks.join(QStringLiteral(", ")));
    call.answer({{QStringLiteral("layout"), call.positional(2)},
                 {QStringLiteral("markers"), markersJson(outcome.layout.layout)},
                 {QStringLiteral("cameras"), QJsonArray::fromStringList(cameras)},
                 {QStringLiteral("tasks"), QJsonArray::fromStringList(tasks)}},
                markersText(outcome.layout.layout) + u'\n' + carried + moved);
    if (!outcome.tasks.empty())
        CommandCall::warn(ODO_TEXT("app.tasks_stay",
                                   "the gates and paths of tasks keep their coordinates in the old axes; "
                                   "they are used on other floors, too: %1")(
            listed(outcome.tasks, MessageArgument::Kind::Task, MessageArgument::Joint::Comma)));
    return {};
}

} // namespace

Result<void> runLayout(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("layout"),
         QStringLiteral(
             "add P.odo NAME layout.csv | mat P.odo IMAGE|VIDEO [--check-line 985mm] | list P.odo | show "
             "P.odo LAYOUT | export P.odo LAYOUT "
             "layout.csv [--force] | "
             "transform P.odo LAYOUT [--origin LABEL | --origin-at X,Y] [--turn DEGREES | --x-axis "
             "LABEL,LABEL] "
             "[--reverse x|y|xy] [--unit mm|cm|m|inch] [--json]"),
         2,
         4,
         {{option::checkLine,
           QStringLiteral("The length of the mat's check line as measured, where the print is not to scale."),
           QStringLiteral("LENGTH")},
          {option::origin, QStringLiteral("The marker to use as the origin."), QStringLiteral("LABEL")},
          {option::originAt, QStringLiteral("The point to use as the origin."), QStringLiteral("X,Y")},
          {option::turn, QStringLiteral("The angle of the new X in the old axes, counter-clockwise."),
           QStringLiteral("DEGREES")},
          {option::xAxis, QStringLiteral("X runs from the first marker to the second."),
           QStringLiteral("LABEL,LABEL")},
          {option::reverse, QStringLiteral("Reverses both axes: xy."), QStringLiteral("AXES")},
          forceOption(),
          {option::unit, QStringLiteral("The unit of the layout's numbers, if they were wrongly read as mm."),
           QStringLiteral("UNIT")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    struct Verb
    {
        const char *name;
        int positionals;
        Result<void> (*run)(CommandCall &);
    };
    static constexpr Verb verbs[] = {{"add", 4, add},          {"mat", 3, mat},
                                     {"list", 2, list},        {"show", 3, show},
                                     {"export", 4, exportCsv}, {"transform", 3, transform}};
    for (const Verb &verb : verbs) {
        if (call.positional(0) != QLatin1String(verb.name))
            continue;
        if (call.positionals().size() != verb.positionals)
            return call.wrongCall(ODO_TEXT("app.verb_takes_arguments",
                                           "'%1' takes %2 arguments")(call.text(0), verb.positionals - 1));
        return verb.run(call);
    }
    return call.verbNotKnown();
}

} // namespace odo
