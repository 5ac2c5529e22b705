// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/limit_check.h"

#include "core/base/units.h"
#include "core/project/connection.h"
#include "core/project/limits.h"

namespace odo {

namespace {

struct TextColumn
{
    const char *table, *column;
    int most;
};
constexpr TextColumn texts[] = {
    {"trial", "name", maxNameLength},       {"team", "name", maxNameLength},   {"class", "name", maxNameLength}, {"robot", "name", maxNameLength},
    {"camera", "name", maxNameLength},      {"layout", "name", maxNameLength}, {"task", "name", maxNameLength},  {"marker", "label", maxNameLength},
    {"gate", "name", maxNameLength},        {"zone", "name", maxNameLength},   {"trial_tag", "tag", maxNameLength},
    {"team_member", "name", maxNameLength}, {"trial", "notes", maxTextLength}, {"property", "value", maxNameLength}};

struct NumberColumn
{
    const char *table, *column;
    double most;
};
constexpr NumberColumn numbers[] = {
    {"marker", "x_m", 1000},          {"marker", "y_m", 1000},
    {"robot", "height_m", largestRobotM},  {"robot", "length_m", largestRobotM},
    {"robot", "width_m", largestRobotM},   {"robot", "ABS(reference_forward_m)", largestRobotM},
    {"robot", "ABS(reference_left_m)", largestRobotM}, {"recording", "frames_per_second", highestFrameRate},
    {"trial", "duration_s", largestNumber}, {"registration", "x_m", largestNumber},
    {"registration", "y_m", largestNumber}, {"registration", "z_m", largestNumber}};

struct ListOf
{
    const char *table, *owner;
    std::size_t most;
};
constexpr ListOf lists[] = {{"recording", "trial", mostViews}, {"trial_robot", "trial", mostRobots}, {"trial_tag", "trial", mostTags}, {"marker", "layout", mostMarkers}};

constexpr const char *advice = "the rest is not read; change it here, or where the file comes from";

} // namespace

Result<std::vector<ProjectProblem>> beyondLimits(const ProjectConnection &connection)
{
    std::vector<ProjectProblem> problems;
    const auto count = [&](const char *sql, const char *table, const char *column, const std::string &most, const auto &words) -> Result<void> {
        const auto found = connection.number(QString::fromLatin1(sql).arg(QLatin1String(table), QLatin1String(column), QString::fromStdString(most)));
        if (found && *found > 0)
            problems.push_back({words(std::to_string(*found)), connection.file().filename().string(), advice});
        return found ? Result<void>() : tl::unexpected(found.error());
    };
    for (const TextColumn &text : texts) {
        const std::string most = std::to_string(text.most), name = std::string(text.table) + "." + text.column;
        if (auto done = count("SELECT COUNT(*) FROM %1 WHERE length(%2)>%3", text.table, text.column, most,
                              [&](const std::string &found) { return name + ": texts of more than " + most + " characters: " + found; });
            !done)
            return tl::unexpected(done.error());
    }
    for (const NumberColumn &number : numbers) {
        const std::string most = formatNumber(number.most, 0), name = std::string(number.table) + "." + number.column;
        if (auto done = count("SELECT COUNT(*) FROM %1 WHERE abs(%2)>%3", number.table, number.column, most,
                              [&](const std::string &found) { return name + ": numbers beyond " + most + ": " + found; });
            !done)
            return tl::unexpected(done.error());
    }
    for (const ListOf &list : lists) {
        const std::string most = std::to_string(list.most), owner = list.owner, name = list.table;
        if (auto done = count("SELECT COALESCE(MAX(n), 0) FROM (SELECT COUNT(*) AS n FROM %1 GROUP BY %2_id) WHERE n>%3", list.table, list.owner, most,
                              [&](const std::string &found) { return name + ": more than " + most + " of one " + owner + ": " + found; });
            !done)
            return tl::unexpected(done.error());
    }
    return problems;
}

} // namespace odo
