// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_call.h"
#include "app/commands/commands.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

const QString colourOption = QStringLiteral("colour"), heightOption = QStringLiteral("height"),
              sizeOption = QStringLiteral("size");

Result<RobotRecord> robotFrom(const CommandCall &call)
{
    RobotRecord robot;
    robot.name = call.text(2);
    if (!call.isSet(colourOption))
        return call.wrongCall(QStringLiteral("--colour is missing"));
    const auto colour = parseColour(call.value(colourOption));
    if (!colour)
        return call.wrongCall(QString::fromStdString(colour.error().what + " is " + colour.error().why));
    robot.colour = *colour;
    const std::string height = call.isSet(heightOption) ? call.value(heightOption) : "auto";
    if (height == "free") {
        robot.heightMode = RobotRecord::Height::Free;
    } else if (height != "auto") {
        const auto heightM = call.lengthM(heightOption);
        if (!heightM)
            return tl::unexpected(heightM.error());
        robot.heightMode = RobotRecord::Height::Told;
        robot.heightM = *heightM;
    }
    if (call.isSet(sizeOption)) {
        const auto size = call.sizePair(sizeOption);
        if (!size)
            return tl::unexpected(size.error());
        robot.lengthM = fromMillimetres(size->first);
        robot.widthM = fromMillimetres(size->second);
    }
    return robot;
}

} // namespace

Result<void> runRobot(const QStringList &arguments, const CancelToken &cancel)
{
    CommandCall call(
        {QStringLiteral("robot"), QStringLiteral("add P.odo NAME --colour #rrggbb [--height 60mm|auto|free] [--size 260x190]"),
         3, 3,
         {{colourOption, QStringLiteral("The robot's colour."), QStringLiteral("#rrggbb")},
          {heightOption, QStringLiteral("Height of its top; auto estimates it from the views; free triangulates every frame."),
           QStringLiteral("LENGTH")},
          {sizeOption, QStringLiteral("Length and width in mm."), QStringLiteral("LxW")}}},
        cancel);
    if (const auto parsed = call.parse(arguments); !parsed || !*parsed)
        return parsed.map([](bool) {});
    if (call.positional(0) != QStringLiteral("add"))
        return call.wrongCall(QStringLiteral("'%1' is not known").arg(call.positional(0)));
    const auto robot = robotFrom(call);
    if (!robot)
        return tl::unexpected(robot.error());
    const auto project = call.openProject(1, Project::Access::ReadWrite);
    if (!project)
        return tl::unexpected(project.error());
    const auto added = (*project)->robots().add(*robot);
    if (!added)
        return tl::unexpected(added.error());
    call.answer({{QStringLiteral("robot"), call.positional(2)},
                 {QStringLiteral("colour"), QString::fromStdString(robot->colour.toString())}},
                QStringLiteral("Robot %1 added.").arg(call.positional(2)));
    return {};
}

} // namespace odo
