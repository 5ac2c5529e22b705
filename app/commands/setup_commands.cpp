// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/answers.h"
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/exchange/task_file.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/tracking/chroma.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/trials/trial_changes.h"
#include "ui/models/shown_message.h"

#include <QJsonArray>
#include <array>
#include <cmath>

namespace odo {

namespace {

/// "x,y,w,h" in whole pixels.
Result<PixelRect> boxFrom(const CommandCall &call)
{
    const QStringList texts = QString::fromStdString(call.value(option::box)).split(u',');
    std::array<int, 4> numbers{};
    bool good = texts.size() == qsizetype(numbers.size());
    for (std::size_t i = 0; good && i < numbers.size(); ++i)
        numbers[i] = texts[qsizetype(i)].trimmed().toInt(&good);
    const auto [x, y, width, height] = numbers;
    constexpr int most = 1 << 20; // wider than any image, and far from overflowing
    if (!good || width <= 0 || height <= 0 || std::max({std::abs(x), std::abs(y), width, height}) > most)
        return call.wrongCall(ODO_TEXT("app.not_a_box", "--box '%1' is not of the form x,y,w,h in pixels")(
            call.value(option::box)));
    return PixelRect{x, y, x + width, y + height};
}

/// The colour of what is in a box of an image.
Result<RgbColour> pickedColour(const CommandCall &call)
{
    if (!call.isSet(option::box))
        return call.wrongCall(ODO_TEXT("app.pick_needs_box", "--pick needs --box x,y,w,h round the robot"));
    const auto box = ODO_TRY(boxFrom(call));
    bool isWhole = true;
    const qint64 frame = call.isSet(option::frame)
                             ? QString::fromStdString(call.value(option::frame)).toLongLong(&isWhole)
                             : 0;
    if (!isWhole || frame < 0)
        return call.wrongCall(
            ODO_TEXT("app.not_a_frame", "--frame '%1' is not a whole number")(call.value(option::frame)));
    const auto image = ODO_TRY(imageOf(call.value(option::pick), frame));
    const auto picked = pickColour(image, box);
    return picked ? Result<RgbColour>(picked->colour) : tl::unexpected(picked.error());
}

/// None: a robot of any look.
Result<std::optional<RgbColour>> colourFrom(const CommandCall &call)
{
    if (call.isSet(option::colour) && call.isSet(option::pick))
        return call.wrongCall(ODO_TEXT("app.two_colours", "--colour and --pick are two colours"));
    if (call.isSet(option::pick))
        return pickedColour(call);
    if (!call.isSet(option::colour))
        return std::nullopt;
    const auto colour = parseColour(call.value(option::colour));
    if (!colour)
        return call.wrongCall(ODO_TEXT("app.colour_is", "%1 is %2")(colour.error().what, colour.error().why));
    return *colour;
}

Result<RobotRecord> robotFrom(const CommandCall &call)
{
    RobotRecord robot;
    robot.name = call.text(2);
    const auto colour = ODO_TRY(colourFrom(call));
    robot.colour = colour;
    const std::string height = call.isSet(option::height) ? call.value(option::height) : "auto";
    if (height == "free") {
        robot.heightMode = RobotRecord::Height::Free;
    } else if (height != "auto") {
        const auto heightM = ODO_TRY(call.lengthM(option::height));
        robot.heightMode = RobotRecord::Height::Given;
        robot.heightM = heightM;
    }
    if (call.isSet(option::size)) {
        const auto size = ODO_TRY(call.sizePair(option::size));
        robot.lengthM = fromMillimetres(size.first);
        robot.widthM = fromMillimetres(size.second);
    }
    if (call.isSet(option::reference)) {
        const QStringList parts = QString::fromStdString(call.value(option::reference)).split(u',');
        const auto forward = parseNumber(parts.front().toStdString()),
                   left = parseNumber(parts.back().toStdString());
        if (parts.size() != 2 || !forward || !left)
            return call.wrongCall(
                ODO_TEXT("app.not_a_reference",
                         "--reference '%1' is not of the form FORWARD,LEFT, two numbers in millimetres")(
                    call.value(option::reference)));
        robot.referenceM = {fromMillimetres(*forward), fromMillimetres(*left)};
    }
    return robot;
}

} // namespace

Result<void> runRobot(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("robot"),
         QStringLiteral("add P.odo NAME [--colour #rrggbb|--pick FILE --box x,y,w,h [--frame N]] [--height "
                        "60mm|auto|free] "
                        "[--size 260x190] [--reference 20,0]"),
         3,
         3,
         {{option::colour,
           QStringLiteral(
               "The robot's colour, if it has a distinct one; without it the robot may have any look."),
           QStringLiteral("#rrggbb")},
          {option::pick, QStringLiteral("A video or image to take the colour from."), QStringLiteral("FILE")},
          {option::box, QStringLiteral("A box closely round the robot in it, in pixels from the top left."),
           QStringLiteral("x,y,w,h")},
          {option::frame, QStringLiteral("Which frame of the video; the first is 0."), QStringLiteral("N")},
          {option::height,
           QStringLiteral(
               "Height of its top; auto estimates it from the views; free triangulates every frame."),
           QStringLiteral("LENGTH")},
          {option::size, QStringLiteral("Length and width in mm."), QStringLiteral("LxW")},
          {option::reference,
           QStringLiteral("The point that is measured, in mm from the footprint's centre: forward along its "
                          "heading, and to its left."),
           QStringLiteral("FORWARD,LEFT")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.positional(0) != QStringLiteral("add"))
        return call.verbNotKnown();
    const auto robot = ODO_TRY(robotFrom(call));
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto added =
        changing(*project, addRobotWords(robot.name), [&] { return project->robots().add(robot); });
    if (!added)
        return tl::unexpected(added.error());
    const QString name = QString::fromStdString(added->name),
                  colour = added->colour ? QString::fromStdString(added->colour->toString()) : QString();
    call.answer({{QStringLiteral("robot"), name},
                 {QStringLiteral("colour"), colour.isEmpty() ? QJsonValue() : QJsonValue(colour)}},
                colour.isEmpty() ? QStringLiteral("Robot %1 added; it may have any look.").arg(name)
                                 : QStringLiteral("Robot %1 added, colour %2.").arg(name, colour));
    return {};
}

namespace {

QString summary(const TaskRecord &task)
{
    const std::string_view kind = taskTemplateWord(task.task.kind);
    return QStringLiteral("  %1  %2  %3%4%5%6")
        .arg(QString::fromStdString(task.name), -24)
        .arg(QString::fromUtf8(kind.data(), qsizetype(kind.size())), -13)
        .arg(counted(task.task.gates.size(), QStringLiteral("gate")))
        .arg(task.task.path.points.empty() ? QString() : QStringLiteral(", reference path"),
             task.task.limits.maxSpeedMps || task.task.limits.maxAccelMps2 ? QStringLiteral(", limits")
                                                                           : QString(),
             task.task.zones.empty()
                 ? QString()
                 : QStringLiteral(", ") + counted(task.task.zones.size(), QStringLiteral("zone")));
}

Result<void> addTask(const CommandCall &call)
{
    const auto task = ODO_TRY(readTaskFile(call.text(3)));
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto added = changing(*project, addTaskWords(call.text(2)), [&] {
        return project->tasks().add({0, call.text(2), task});
    });
    if (!added)
        return tl::unexpected(added.error());
    call.answer(taskJson(*added), QStringLiteral("Task added:\n%1").arg(summary(*added)));
    return {};
}

Result<void> listTasks(const CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadOnly));
    const auto all = ODO_TRY(project->tasks().all());
    QJsonArray tasks;
    QStringList lines;
    for (const TaskRecord &task : all) {
        tasks.append(taskJson(task));
        lines << summary(task);
    }
    call.answer({{QStringLiteral("tasks"), tasks}},
                lines.isEmpty() ? QStringLiteral("No task yet; add one with odograph task add.")
                                : lines.join(u'\n'));
    return {};
}

Result<void> setTask(const CommandCall &call)
{
    const auto project = ODO_TRY(call.openProject(1, Project::Access::ReadWrite));
    const auto trial = ODO_TRY(project->trials().find(call.text(2)));
    const auto task = ODO_TRY(project->tasks().find(call.text(3)));
    ODO_TRY(editTrial(*project, trial.id, {.task = task.name}));
    const QString trialName = QString::fromStdString(trial.name),
                  taskName = QString::fromStdString(task.name);
    call.answer({{QStringLiteral("trial"), trialName}, {QStringLiteral("task"), taskName}},
                QStringLiteral("Trial %1 has the task %2; measure it with: odograph track %3 %1 --again")
                    .arg(trialName, taskName, call.positional(1)));
    return {};
}

} // namespace

Result<void> runTask(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call({QStringLiteral("task"),
                      QStringLiteral("add P.odo NAME task.json | list P.odo | set P.odo TRIAL TASK [--json]"),
                      2,
                      4,
                      {}},
                     cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    const QString verb = call.positional(0);
    const auto count = call.positionals().size();
    if (verb == QStringLiteral("add") && count == 4)
        return addTask(call);
    if (verb == QStringLiteral("list") && count == 2)
        return listTasks(call);
    if (verb == QStringLiteral("set") && count == 4)
        return setTask(call);
    return call.wrongCall(
        ODO_TEXT("app.task_verbs", "give add P.odo NAME task.json, list P.odo, or set P.odo TRIAL NAME"));
}

} // namespace odo
