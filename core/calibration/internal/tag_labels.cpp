// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_labels.h"

#include "core/calibration/internal/layout_board.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace odo {

namespace {

constexpr std::size_t mostDigits = 5;
constexpr std::array<std::string_view, 4> cornerNames{".tl", ".tr", ".br", ".bl"};
constexpr std::array<std::string_view, 4> tagWords{"apriltag", "aruco", "tag", "id"};

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return text;
}

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// "12" or "12+13".
std::vector<int> numbersOf(std::string_view text)
{
    std::vector<int> numbers;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('+'), text.size());
        const std::string number(text.substr(0, end));
        if (number.empty() || number.size() > mostDigits || !std::ranges::all_of(number, isDigit) ||
            end + 1 == text.size())
            return {};
        numbers.push_back(std::stoi(number));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    std::ranges::sort(numbers);
    return std::ranges::adjacent_find(numbers) == numbers.end() ? numbers : std::vector<int>();
}

/// Each label's point, of the families that they name and of `family` where they name none.
std::vector<TaggedPoint> pointsByNumber(const std::vector<std::optional<TagLabel>> &labels, TagFamily family)
{
    std::vector<TaggedPoint> points;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (!labels[i])
            continue;
        TaggedPoint point{i, {}, labels[i]->corner};
        for (const int number : labels[i]->numbers)
            point.tags.push_back({labels[i]->family.value_or(family), number});
        points.push_back(std::move(point));
    }
    const std::vector<TaggedPoint> all = points;
    std::erase_if(points, [&](const TaggedPoint &point) {
        return std::ranges::any_of(all, [&](const TaggedPoint &other) {
            return other.marker != point.marker && other.tags == point.tags && other.corner == point.corner;
        });
    });
    return points;
}

} // namespace

std::optional<TagLabel> tagLabel(std::string_view label)
{
    std::string text(label);
    for (char &c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        if (c == ':' || c == '#')
            c = ' ';
    }
    TagLabel result;
    std::string_view left = trimmed(text);
    for (std::size_t i = 0; i < cornerNames.size(); ++i) {
        if (left.ends_with(cornerNames[i])) {
            result.corner = static_cast<int>(i);
            left = trimmed(left.substr(0, left.size() - cornerNames[i].size()));
            break;
        }
    }
    const std::size_t space = left.rfind(' ');
    std::string_view number = space == std::string_view::npos ? left : left.substr(space + 1);
    const std::string_view before = space == std::string_view::npos ? "" : trimmed(left.substr(0, space));
    for (const std::string_view word : tagWords) {
        if (before.empty() && number.starts_with(word)) {
            number.remove_prefix(word.size());
            break;
        }
    }
    result.numbers = numbersOf(number);
    if (result.numbers.empty() || (result.corner && result.numbers.size() > 1))
        return std::nullopt;
    if (before.empty() || std::ranges::find(tagWords, before) != tagWords.end())
        return result;
    result.family = tagFamilyNamed(before);
    return result.family ? std::optional(result) : std::nullopt;
}

bool TagRule::isExpected() const
{
    return isNamed || uses(printedTagFamily().front());
}

bool TagRule::uses(TagFamily family) const
{
    return std::ranges::any_of(points, [&](const TaggedPoint &point) {
        return std::ranges::find(point.tags, family, &TagName::family) != point.tags.end();
    });
}

std::vector<TagRule> tagRules(const MarkerLayout &layout)
{
    std::vector<std::optional<TagLabel>> labels;
    for (const Marker &marker : layout.markers)
        labels.push_back(tagLabel(marker.label));
    const bool allNamed =
        std::ranges::all_of(labels, [](const auto &label) { return label && label->family; });
    TagRule byPlace{true, false, {}};
    for (std::size_t i = 0; i < layout.markers.size(); ++i) {
        if (!boardCorner(layout.markers[i].label))
            byPlace.points.push_back({i, {{printedTagFamily().front(), static_cast<int>(i)}}, std::nullopt});
    }
    std::vector<TagRule> rules;
    const auto add = [&](TagRule rule) {
        if (!rule.points.empty() && std::ranges::find(rules, rule.points, &TagRule::points) == rules.end())
            rules.push_back(std::move(rule));
    };
    if (!allNamed)
        add(byPlace);
    for (const TagFamily family : allTagFamilies())
        add({false, allNamed, pointsByNumber(labels, family)});
    return rules;
}

} // namespace odo
