// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/task_file.h"

#include "core/base/units.h"
#include "core/exchange/internal/yaml_document.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace odo {

namespace {

Message taskAdvice()
{
    return ODO_TEXT("exchange.write_task_as_shown", "write the task as odograph task list --json shows one");
}

using Kind = YamlNode::Kind;

/// Reads a task from a parsed file; errors name the line of the entry.
class TaskReader
{
public:
    explicit TaskReader(const std::filesystem::path &file) : m_file(file) {}

    Result<Task> read(const YamlNode &root) const
    {
        if (root.kind != Kind::Mapping)
            return failure(root.line, ODO_TEXT("exchange.no_task", "the file holds no task"));
        ODO_TRY(onlyKeys(root, {"template", "gates", "reference_path", "limits", "zones", "name"}));
        Task task;
        for (const auto &[key, node] : root.entries) {
            Result<void> done;
            if (isNull(node))
                continue;
            if (key == "template")
                done = readTemplate(node, task);
            else if (key == "gates")
                done = readGates(node, task);
            else if (key == "reference_path")
                done = readPath(node, task);
            else if (key == "limits")
                done = readLimits(node, task);
            else if (key == "zones")
                done = readZones(node, task);
            if (!done)
                return tl::unexpected(done.error());
        }
        return task;
    }

private:
    static bool isNull(const YamlNode &node) { return node.kind == Kind::Null; }

    tl::unexpected<Error> failure(int line, Message why, Message advice = taskAdvice()) const
    {
        return fail(ErrorCode::InvalidInput, atLine(m_file, line), std::move(why), std::move(advice));
    }
    tl::unexpected<Error> notAList(const YamlNode &node, const std::string &name) const
    {
        return failure(node.line, ODO_TEXT("exchange.not_a_list", "'%1' is not a list in brackets")(name));
    }

    /// An error of the model, at the line of its cause.
    tl::unexpected<Error> at(int line, const Error &error) const
    {
        return failure(line, wholeMessage(error.what, error.why), error.advice);
    }

    Result<void> onlyKeys(const YamlNode &node, std::initializer_list<std::string_view> keys) const
    {
        const MessageArgument list = listed(std::vector<std::string>(keys.begin(), keys.end()),
                                            MessageArgument::Kind::Label, MessageArgument::Joint::Or);
        if (node.kind != Kind::Mapping)
            return failure(node.line, ODO_TEXT("exchange.object_expected", "it must be an object in braces"),
                           ODO_TEXT("exchange.write_object_with", "write one with %1")(list));
        for (const auto &[key, value] : node.entries) {
            if (std::find(keys.begin(), keys.end(), key) == keys.end())
                return failure(
                    value.line,
                    ODO_TEXT("exchange.key_not_known", "the key '%1' is not known")(key.substr(0, 40)),
                    ODO_TEXT("exchange.use_keys", "use %1")(list));
        }
        return {};
    }

    Result<const YamlNode *> entry(const YamlNode &parent, const std::string &key) const
    {
        if (const YamlNode *found = parent.find(key))
            return found;
        return failure(parent.line, entryIsMissing(key));
    }

    Result<double> number(const YamlNode &node, const std::string &name) const
    {
        const auto value = parseNumber(node.text);
        if (node.kind != Kind::Scalar || !value)
            return failure(node.line, notAFiniteNumber(name));
        return *value;
    }

    Result<double> lengthM(const YamlNode &parent, const std::string &key) const
    {
        const auto node = ODO_TRY(entry(parent, key));
        auto value = ODO_TRY(number(*node, key));
        const double metres = fromMillimetres(value); // which may be zero where the millimetres are not
        if (!(metres > 0))
            return failure(node->line, ODO_TEXT("exchange.not_above_zero", "'%1' is not above zero")(key));
        return metres;
    }

    Result<Eigen::Vector2d> point(const YamlNode &node, const std::string &name) const
    {
        if (node.kind != Kind::Sequence || node.items.size() != 2)
            return failure(node.line,
                           ODO_TEXT("exchange.not_a_point", "'%1' is not a point [x, y] in mm")(name));
        const auto x = number(node.items[0], name), y = number(node.items[1], name);
        if (!x || !y)
            return tl::unexpected(x ? y.error() : x.error());
        return Eigen::Vector2d(fromMillimetres(*x), fromMillimetres(*y));
    }

    Result<Eigen::Vector2d> pointIn(const YamlNode &parent, const std::string &key) const
    {
        const auto node = entry(parent, key);
        return node ? point(**node, key) : tl::unexpected(node.error());
    }

    Result<void> readTemplate(const YamlNode &node, Task &into) const
    {
        const auto kind = parseTaskTemplate(node.text);
        if (!kind)
            return at(node.line, kind.error());
        into.kind = *kind;
        return {};
    }

    Result<Gate> readGate(const YamlNode &node) const
    {
        ODO_TRY(onlyKeys(node, {"name", "role", "from_mm", "to_mm"}));
        const auto name = entry(node, "name"), role = entry(node, "role");
        if (!name || !role)
            return tl::unexpected(name ? role.error() : name.error());
        const auto parsed = parseGateRole((*role)->text);
        if (!parsed)
            return at((*role)->line, parsed.error());
        const auto from = pointIn(node, "from_mm"), to = pointIn(node, "to_mm");
        if (!from || !to)
            return tl::unexpected(from ? to.error() : from.error());
        return Gate{(*name)->text, *parsed, *from, *to};
    }

    Result<void> readGates(const YamlNode &node, Task &into) const
    {
        if (node.kind != Kind::Sequence)
            return notAList(node, "gates");
        for (const YamlNode &item : node.items) {
            auto gate = ODO_TRY(readGate(item));
            if (auto valid = checkGate(gate); !valid)
                return at(item.line, valid.error());
            into.gates.push_back(std::move(gate));
            if (auto valid = checkGateAmong(into.gates); !valid)
                return at(item.line, valid.error());
        }
        return {};
    }

    Result<void> readPath(const YamlNode &node, Task &into) const
    {
        ODO_TRY(onlyKeys(node, {"points_mm", "closed", "circle", "figure_eight", "slalom"}));
        int curves = 0;
        for (const auto &[key, value] : node.entries) {
            if (key == "closed")
                continue;
            ++curves;
            const auto path = ODO_TRY(key == "points_mm" ? pointsPath(node, value)
                                      : key == "circle"  ? circle(value)
                                      : key == "slalom"  ? slalom(value)
                                                         : figureEight(value));
            into.path = path;
        }
        if (curves != 1)
            return failure(
                node.line,
                curves == 0
                    ? ODO_TEXT("exchange.path_not_given", "the reference path has no shape")
                    : ODO_TEXT("exchange.path_given_twice", "the reference path has more than one shape"),
                ODO_TEXT("exchange.give_one_path", "give one of points_mm, circle, figure_eight or slalom"));
        if (auto valid = checkReferencePath(into.path); !valid)
            return at(node.line, valid.error());
        return {};
    }

    Result<std::vector<Eigen::Vector2d>> points(const YamlNode &list, const std::string &name) const
    {
        std::vector<Eigen::Vector2d> read;
        if (list.kind != Kind::Sequence)
            return notAList(list, name);
        for (const YamlNode &item : list.items) {
            read.push_back(ODO_TRY(point(item, name)));
        }
        return read;
    }

    Result<ReferencePath> pointsPath(const YamlNode &parent, const YamlNode &list) const
    {
        auto read = ODO_TRY(points(list, "points_mm"));
        ReferencePath path{std::move(read), false};
        if (const YamlNode *closed = parent.find("closed")) {
            if (closed->text != "true" && closed->text != "false")
                return failure(closed->line,
                               ODO_TEXT("exchange.closed_neither", "'closed' is neither true nor false"));
            path.closed = closed->text == "true";
        }
        return path;
    }

    Result<ReferencePath> circle(const YamlNode &node) const
    {
        ODO_TRY(onlyKeys(node, {"centre_mm", "radius_mm"}));
        const auto centre = pointIn(node, "centre_mm");
        const auto radius = ODO_TRY(centre ? lengthM(node, "radius_mm") : tl::unexpected(centre.error()));
        return circlePath(*centre, radius);
    }

    Result<ReferencePath> figureEight(const YamlNode &node) const
    {
        ODO_TRY(onlyKeys(node, {"centre_mm", "half_width_mm", "half_height_mm"}));
        const auto centre = pointIn(node, "centre_mm");
        const auto width = centre ? lengthM(node, "half_width_mm") : tl::unexpected(centre.error());
        const auto height = ODO_TRY(width ? lengthM(node, "half_height_mm") : width);
        return figureEightPath(*centre, *width, height);
    }

    Result<ReferencePath> slalom(const YamlNode &node) const
    {
        ODO_TRY(onlyKeys(node, {"from_mm", "to_mm", "poles", "swing_mm"}));
        const auto from = pointIn(node, "from_mm");
        const auto to = from ? pointIn(node, "to_mm") : from;
        const auto swing = to ? lengthM(node, "swing_mm") : tl::unexpected(to.error());
        const auto poles = ODO_TRY(swing ? entry(node, "poles") : tl::unexpected(swing.error()));
        const auto count = number(*poles, "poles");
        constexpr double mostPoles = 100;
        if (!count || *count < 1 || *count > mostPoles || *count != std::floor(*count))
            return failure(poles->line,
                           ODO_TEXT("exchange.wrong_poles", "'poles' is not a whole number from 1 to 100"));
        if ((*to - *from).norm() <= 0)
            return failure(node.line,
                           ODO_TEXT("exchange.slalom_without_length", "the slalom ends where it starts"));
        return slalomPath(*from, *to, static_cast<int>(*count), *swing);
    }

    Result<void> readLimits(const YamlNode &node, Task &into) const
    {
        ODO_TRY(onlyKeys(node, {"speed_mm_s", "acceleration_mm_s2"}));
        for (const auto &[key, value] : node.entries) {
            if (isNull(value))
                continue;
            const auto limit = ODO_TRY(lengthM(node, key));
            (key == "speed_mm_s" ? into.limits.maxSpeedMps : into.limits.maxAccelMps2) = limit;
        }
        return {};
    }

    Result<Zone> readZone(const YamlNode &node) const
    {
        ODO_TRY(onlyKeys(node, {"name", "rule", "corners_mm", "rectangle_mm"}));
        const auto name = entry(node, "name"), rule = entry(node, "rule");
        if (!name || !rule)
            return tl::unexpected(name ? rule.error() : name.error());
        const auto parsed = parseZoneRule((*rule)->text);
        if (!parsed)
            return at((*rule)->line, parsed.error());
        const YamlNode *corners = node.find("corners_mm"), *rectangle = node.find("rectangle_mm");
        if ((corners == nullptr) == (rectangle == nullptr))
            return failure(
                node.line,
                corners ? ODO_TEXT("exchange.zone_given_twice", "the zone has more than one shape")
                        : ODO_TEXT("exchange.zone_not_given", "the zone has no shape"),
                ODO_TEXT("exchange.give_one_zone",
                         "give all corners in order as corners_mm, or two opposite corners as rectangle_mm"));
        auto read = ODO_TRY(corners ? points(*corners, "corners_mm") : points(*rectangle, "rectangle_mm"));
        if (corners)
            return Zone{(*name)->text, *parsed, std::move(read)};
        if (read.size() != 2)
            return failure(
                rectangle->line, ODO_TEXT("exchange.not_two_corners", "'rectangle_mm' is not two corners"),
                ODO_TEXT("exchange.give_two_corners", "give two opposite corners: [[x, y], [x, y]]"));
        return rectangularZone((*name)->text, *parsed, read.front(), read.back());
    }

    Result<void> readZones(const YamlNode &node, Task &into) const
    {
        if (node.kind != Kind::Sequence)
            return notAList(node, "zones");
        for (const YamlNode &item : node.items) {
            auto zone = ODO_TRY(readZone(item));
            if (auto valid = checkZone(zone); !valid)
                return at(item.line, valid.error());
            into.zones.push_back(std::move(zone));
            if (auto valid = checkZoneAmong(into.zones); !valid)
                return at(item.line, valid.error());
        }
        return {};
    }

    const std::filesystem::path &m_file;
};

} // namespace

Result<Task> readTaskFile(const std::filesystem::path &file)
{
    const auto text = ODO_TRY(readTextFile(file));
    const auto root = ODO_TRY(parseYaml(file, text, taskAdvice()));
    return TaskReader(file).read(root);
}

} // namespace odo
