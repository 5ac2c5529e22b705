// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/analysis/task.h"
#include "core/base/error.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

#include <algorithm>
#include <utility>

namespace odo {

namespace {

const QString robotColumns =
    QStringLiteral("SELECT id, name, colour, height_mode, height_m, length_m, width_m, drawing_colour, "
                   "reference_forward_m, reference_left_m FROM robot ");

std::optional<double> sizeOf(const Statement &row, int column)
{
    const auto size = row.optionalReal(column);
    return size ? std::optional(std::clamp(*size, 0.0, double(largestRobotM))) : size;
}

/// As it is stored: nothing for a robot of any look.
std::string storedColour(const RobotRecord &robot)
{
    return robot.colour ? robot.colour->toString() : std::string();
}

Result<std::optional<RgbColour>> colourOf(const std::string &stored)
{
    if (stored.empty())
        return std::nullopt;
    return parseColour(stored);
}

Result<RobotRecord> robotOf(const Statement &row)
{
    RobotRecord robot;
    robot.id = row.integer(0);
    robot.name = row.name(1);
    const auto colour = ODO_TRY(colourOf(row.text(2)));
    const auto mode = ODO_TRY(fromStoredWord(heightModeWords, row.text(3), robotSubject(robot.name)));
    robot.colour = colour;
    robot.heightMode = mode;
    robot.heightM = sizeOf(row, 4);
    robot.lengthM = sizeOf(row, 5);
    robot.widthM = sizeOf(row, 6);
    robot.drawingColour = ODO_TRY(fromStoredWord(drawingColourWords, row.text(7), robotSubject(robot.name)));
    robot.referenceM = {row.real(8), row.real(9)};
    return robot;
}

RobotRecord withNormalName(RobotRecord robot)
{
    robot.name = normalName(robot.name);
    return robot;
}

Result<void> checkRobot(const RobotRecord &robot)
{
    ODO_TRY(checkName(RecordKind::Robot, robot.name));
    const auto refuse = [&robot](Message why, Message advice) {
        return fail(ErrorCode::InvalidInput, robotSubject(robot.name), std::move(why), std::move(advice));
    };
    if (robot.heightMode == RobotRecord::Height::Given && !robot.heightM)
        return refuse(ODO_TEXT("project.height_not_given", "it needs a fixed height, but none is given"),
                      ODO_TEXT("project.give_a_height", "enter a height, or have it estimated"));
    if (robot.heightM && !(*robot.heightM >= 0))
        return refuse(ODO_TEXT("project.height_below_floor", "its height is below the floor"),
                      ODO_TEXT("project.height_from_0", "give a height of 0 or more"));
    for (const auto &size : {robot.lengthM, robot.widthM}) {
        if (size && !(*size > 0))
            return refuse(
                ODO_TEXT("project.size_not_above_0", "its size is not above 0"),
                ODO_TEXT("project.give_robot_size", "give length and width in millimetres, like 260x190"));
    }
    const MessageArgument largest = quantity(largestRobotM, 0, "m");
    for (const auto &size : {robot.heightM, robot.lengthM, robot.widthM}) {
        if (size && *size > largestRobotM)
            return refuse(ODO_TEXT("project.robot_too_large", "it is larger than %1")(largest),
                          checkTheNumbers());
    }
    if (!(robot.referenceM.cwiseAbs().maxCoeff() <= largestRobotM))
        return refuse(ODO_TEXT("project.reference_too_far",
                               "its reference point is more than %1 from its centre")(largest),
                      checkTheNumbers());
    if (!robot.referenceM.isZero() && robot.heightMode == RobotRecord::Height::Free)
        return refuse(
            ODO_TEXT(
                "project.reference_without_heading",
                "a reference point off its centre needs a heading, but a robot of changing height has none"),
            ODO_TEXT("project.leave_one_out", "use only one of the two"));
    return {};
}

} // namespace

RobotRepository::RobotRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<RobotRecord> RobotRepository::add(const RobotRecord &given)
{
    const RobotRecord robot = withNormalName(given);
    return transact(m_connection, [&]() -> Result<RobotRecord> {
        ODO_TRY(checkRobot(robot));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Robot, robot.name));
        Statement insert(m_connection,
                         QStringLiteral("INSERT INTO robot (name, colour, height_mode, height_m, "
                                        "length_m, width_m, drawing_colour, reference_forward_m, "
                                        "reference_left_m) VALUES (?,?,?,?,?,?,?,?,?)"));
        insert.bind(robot.name).bind(storedColour(robot)).bind(storedWord(heightModeWords, robot.heightMode));
        insert.bind(robot.heightM).bind(robot.lengthM).bind(robot.widthM);
        insert.bind(storedWord(drawingColourWords, robot.drawingColour));
        ODO_TRY(insert.bind(robot.referenceM.x()).bind(robot.referenceM.y()).run());
        RobotRecord stored = robot;
        stored.id = insert.insertedId();
        return stored;
    });
}

Result<std::vector<RobotRecord>> RobotRepository::all() const
{
    std::vector<RobotRecord> robots;
    Statement select(m_connection, robotColumns + QStringLiteral("ORDER BY id"));
    auto read = select.eachRow([&robots](const Statement &row) -> Result<void> {
        robots.push_back(ODO_TRY(robotOf(row)));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return robots;
}

Result<RobotRecord> RobotRepository::find(const std::string &name) const
{
    const auto id = ODO_TRY(idNamed(m_connection, RecordKind::Robot, name));
    if (id == 0)
        return noSuchName(m_connection, RecordKind::Robot, name);
    return get(id);
}

Result<RobotRecord> RobotRepository::get(RecordId id) const
{
    Statement select(m_connection, robotColumns + QStringLiteral("WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(m_connection, RecordKind::Robot, id);
    return robotOf(select);
}

Result<void> RobotRepository::set(const RobotRecord &given)
{
    const RobotRecord robot = withNormalName(given);
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = ODO_TRY(get(robot.id));
        ODO_TRY(checkRobot(robot));
        if (known.name != robot.name)
            ODO_TRY(checkNameIsFree(m_connection, RecordKind::Robot, robot.name));
        Statement update(m_connection,
                         QStringLiteral("UPDATE robot SET name=?, colour=?, height_mode=?, height_m=?, "
                                        "length_m=?, width_m=?, drawing_colour=?, reference_forward_m=?, "
                                        "reference_left_m=? WHERE id=?"));
        update.bind(robot.name).bind(storedColour(robot)).bind(storedWord(heightModeWords, robot.heightMode));
        update.bind(robot.heightM).bind(robot.lengthM).bind(robot.widthM);
        update.bind(storedWord(drawingColourWords, robot.drawingColour));
        return update.bind(robot.referenceM.x()).bind(robot.referenceM.y()).bind(robot.id).run();
    });
}

Result<void> RobotRepository::remove(RecordId robot)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto known = ODO_TRY(get(robot));
        Statement used(m_connection, QStringLiteral("SELECT 1 FROM trial_robot WHERE robot_id=? UNION "
                                                    "SELECT 1 FROM analysis WHERE robot_id=? UNION "
                                                    "SELECT 1 FROM observation_series WHERE robot_id=? UNION "
                                                    "SELECT 1 FROM imported_track WHERE robot_id=?"));
        const auto isUsed = ODO_TRY(used.bind(robot).bind(robot).bind(robot).bind(robot).firstRow());
        if (isUsed)
            return fail(ErrorCode::InvalidInput, robotSubject(known.name),
                        ODO_TEXT("project.robot_drove", "a trial uses it"),
                        joined({keepIt(), ODO_TEXT("project.robot_can_be_renamed", "you can rename it")},
                               Join::Semicolon));
        ODO_TRY(runFor(m_connection, "DELETE FROM team_robot WHERE robot_id=?", robot));
        return runFor(m_connection, "DELETE FROM robot WHERE id=?", robot);
    });
}

} // namespace odo
