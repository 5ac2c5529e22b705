// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/internal/calibration_tree.h"

#include "core/base/units.h"
#include "core/exchange/internal/calibration_styles.h"
#include "core/exchange/text_file.h"

#include <algorithm>
#include <string_view>
#include <toml++/toml.h>

namespace odo {

namespace {

std::vector<std::string_view> linesOf(std::string_view text)
{
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        lines.push_back(withoutBlanks(line));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

bool isRemark(std::string_view line)
{
    return line.empty() || line.front() == '#';
}

/// Videre's INI: a section a camera, names on lines of their own, numbers below them.
YamlNode treeOfIni(const std::vector<std::string_view> &lines)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> names{
        {{"width", "image_width"},
         {"height", "image_height"},
         {"camera matrix", "camera_matrix"},
         {"distortion", "distortion_coefficients"}}};
    YamlNode root;
    root.kind = YamlNode::Kind::Mapping;
    root.line = 1;
    YamlNode *values = nullptr;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = lines[i];
        const int number = int(i) + 1;
        if (isRemark(line))
            continue;
        if (line.front() == '[') {
            values = nullptr;
            if (line != "[image]" && line.back() == ']' && !root.find("camera_name"))
                root.entries.push_back(
                    {"camera_name", scalarNode(std::string(line.substr(1, line.size() - 2)), number)});
        } else if (line.find_first_of("0123456789") == std::string_view::npos) {
            const auto known = std::ranges::find(names, line, &decltype(names)::value_type::first);
            values = nullptr;
            if (known == names.end() || root.find(known->second))
                continue;
            YamlNode list;
            list.kind = YamlNode::Kind::Sequence;
            list.line = number;
            root.entries.push_back({std::string(known->second), std::move(list)});
            values = &root.entries.back().value;
        } else if (values != nullptr) {
            for (std::string_view rest = line; !rest.empty();) {
                const auto end = std::min(rest.find_first_of(" \t"), rest.size());
                values->items.push_back(scalarNode(std::string(rest.substr(0, end)), number));
                rest = withoutBlanks(rest.substr(end));
            }
        }
    }
    for (YamlEntry &entry : root.entries) // sizes are one number each
        if (entry.value.items.size() == 1)
            entry.value = YamlNode(entry.value.items.front());
    return root;
}

/// Gives up where a file is nested deeper, or holds more, than any calibration.
class TomlTree
{
public:
    explicit TomlTree(std::size_t mostNodes) : m_left(mostNodes) {}

    bool isTooLarge() const { return m_left == 0; }
    YamlNode nodeOf(const toml::node &from, int depth = 0)
    {
        constexpr int maxDepth = 16;
        YamlNode node;
        node.line = int(from.source().begin.line);
        m_left = depth > maxDepth ? 0 : m_left - (m_left > 0);
        if (m_left == 0)
            return node;
        if (const toml::table *table = from.as_table()) {
            node.kind = YamlNode::Kind::Mapping;
            for (const auto &[key, value] : *table)
                node.entries.push_back({std::string(key.str()), nodeOf(value, depth + 1)});
        } else if (const toml::array *array = from.as_array()) {
            node.kind = YamlNode::Kind::Sequence;
            for (const toml::node &value : *array)
                node.items.push_back(nodeOf(value, depth + 1));
        } else {
            node.kind = YamlNode::Kind::Scalar;
            node.text = textOf(from);
        }
        return node;
    }

private:
    static std::string textOf(const toml::node &from)
    {
        if (const auto text = from.value_exact<std::string>())
            return *text;
        if (const auto whole = from.value_exact<std::int64_t>())
            return std::to_string(*whole);
        if (const auto real = from.value_exact<double>())
            return numberText(*real);
        if (const auto truth = from.value_exact<bool>())
            return *truth ? "true" : "false";
        return {};
    }

    std::size_t m_left;
};

Result<YamlNode> parseToml(const std::filesystem::path &file, const std::string &text, const Message &advice)
{
    constexpr std::size_t maxNodes = 100'000;
    try {
        const toml::table root = toml::parse(text);
        TomlTree tree(maxNodes);
        YamlNode node = tree.nodeOf(root);
        if (tree.isTooLarge())
            return fail(ErrorCode::InvalidInput, atLine(file, 1),
                        ODO_TEXT("exchange.too_many_values", "it holds more than %1 values")(maxNodes),
                        advice);
        node.line = 1;
        return node;
    } catch (const toml::parse_error &problem) {
        return fail(ErrorCode::InvalidInput, atLine(file, int(problem.source().begin.line)),
                    ODO_TEXT("exchange.no_valid_toml",
                             "it is not valid TOML (%1)")(foreignWords(std::string(problem.description()))),
                    advice);
    }
}

/// A table's name in brackets, or a key and its value.
bool isToml(const std::vector<std::string_view> &lines)
{
    const auto first = std::ranges::find_if_not(lines, isRemark);
    if (first == lines.end())
        return false;
    const auto equals = first->find('=');
    return (first->front() == '[' && first->back() == ']' &&
            first->find_first_of(",{\"") == std::string_view::npos) ||
           (equals != std::string_view::npos && first->find_first_of(":{[") > equals);
}

/// Of messages that ROS prints one after the other the first; else all of it.
std::string_view firstMessage(std::string_view text)
{
    constexpr std::string_view divider = "\n---";
    const auto end = text.find(divider);
    const std::string_view first = text.substr(0, end);
    const std::vector<std::string_view> lines = linesOf(first);
    const bool isMessage = std::ranges::any_of(
        lines, [](std::string_view line) { return line.starts_with("k:") || line.starts_with("K:"); });
    return end != std::string_view::npos && isMessage ? first : text;
}

} // namespace

Result<YamlNode> parseCalibrationTree(const std::filesystem::path &file, const std::string &text,
                                      const Message &advice)
{
    const std::vector<std::string_view> lines = linesOf(text);
    if (std::ranges::find(lines, "[image]") != lines.end() &&
        std::ranges::find(lines, "camera matrix") != lines.end())
        return treeOfIni(lines);
    if (const auto first = std::ranges::find_if_not(lines, isRemark);
        first != lines.end() && first->starts_with('<'))
        return treeOfXml(file, text, advice);
    if (auto cameras = treeOfColmap(lines))
        return std::move(*cameras);
    if (isToml(lines))
        return parseToml(file, text, advice);
    return parseYaml(file, std::string(firstMessage(text)), advice);
}

} // namespace odo
