// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_labels.h"

#include "core/calibration/internal/layout_board.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

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

namespace {

/// A label taken apart: "36h11", "100" and "tl" of "36h11:100.tl".
struct LabelParts
{
    std::string family; ///< in small letters; empty: there is none, or only such a word as "tag"
    std::string number;
    std::optional<int> corner;
};

LabelParts partsOf(std::string_view label)
{
    std::string text(label);
    for (char &c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        if (c == ':' || c == '#')
            c = ' ';
    }
    LabelParts parts;
    std::string_view left = trimmed(text);
    for (std::size_t i = 0; i < cornerNames.size(); ++i) {
        if (left.ends_with(cornerNames[i])) {
            parts.corner = static_cast<int>(i);
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
    if (std::ranges::find(tagWords, before) == tagWords.end())
        parts.family = before;
    parts.number = number;
    return parts;
}

/// "12+": numbers, but not as they are to be written.
bool areMiswritten(const std::string &numbers)
{
    return numbers.find('+') != std::string::npos && std::ranges::any_of(numbers, isDigit) &&
           std::ranges::all_of(numbers, [](char c) { return isDigit(c) || c == '+'; }) &&
           numbersOf(numbers).empty();
}

/// "3.xx": a number and two letters that are no corner.
bool hasOtherCorner(const std::string &number)
{
    constexpr std::size_t letters = 2;
    const std::size_t point = number.find('.');
    return point != std::string::npos && point > 0 && number.size() == point + 1 + letters &&
           std::all_of(number.begin(), number.begin() + std::ptrdiff_t(point), isDigit) &&
           std::all_of(number.begin() + std::ptrdiff_t(point) + 1, number.end(),
                       [](char c) { return c >= 'a' && c <= 'z'; });
}

/// Why a label names no tag though its family says that it is one; empty where it names one or no family.
Message faultOfNamed(const LabelParts &parts, const std::vector<int> &numbers)
{
    const auto family = parts.family.empty() ? std::nullopt : tagFamilyNamed(parts.family);
    if (!family)
        return {};
    if (numbers.empty())
        return ODO_TEXT("calibration.no_tag_number",
                        "'%1' is not the number of a tag")(Named::marker(parts.number));
    for (const int number : numbers) {
        if (!tagCells({*family, number}))
            return ODO_TEXT("calibration.no_such_tag", "%1 has no tag %2")(nameOf(*family), number);
    }
    return {};
}

/// The same beside others that are tags.
Message faultAmongTags(const LabelParts &parts, const std::vector<int> &numbers)
{
    if (hasOtherCorner(parts.number))
        return ODO_TEXT("calibration.no_such_corner", "the corners of a tag are tl, tr, br and bl");
    if (parts.corner && numbers.size() > 1)
        return ODO_TEXT("calibration.corner_of_many_tags", "a corner is that of one tag");
    if (areMiswritten(parts.number))
        return ODO_TEXT("calibration.no_tag_number",
                        "'%1' is not the number of a tag")(Named::marker(parts.number));
    return {};
}

tl::unexpected<Error> refuseLabel(const std::string &label, const Message &why)
{
    return fail(
        ErrorCode::InvalidInput,
        ODO_TEXT("calibration.label_of_layout", "label '%1' of the layout")(Named::marker(label)), why,
        ODO_TEXT("calibration.write_tags_as",
                 "write a tag as 100 or 36h11:100, its corner as 100.tl, the middle of two as 12+13"));
}

} // namespace

Result<void> checkTagLabels(const MarkerLayout &layout)
{
    const auto tags = std::ranges::count_if(
        layout.markers, [](const Marker &one) { return tagLabel(one.label).has_value(); });
    const bool areTags = 2 * std::size_t(tags) > layout.markers.size();
    std::vector<std::pair<TagLabel, std::string>> known;
    for (const Marker &marker : layout.markers) {
        if (boardCorner(marker.label))
            continue;
        const LabelParts parts = partsOf(marker.label);
        const std::vector<int> numbers = numbersOf(parts.number);
        Message fault = faultOfNamed(parts, numbers);
        if (fault.isEmpty() && areTags)
            fault = faultAmongTags(parts, numbers);
        if (!fault.isEmpty())
            return refuseLabel(marker.label, fault);
        const auto label = tagLabel(marker.label);
        if (!label || !areTags)
            continue;
        const auto same = std::ranges::find(known, *label, &std::pair<TagLabel, std::string>::first);
        if (same != known.end())
            return refuseLabel(marker.label,
                               ODO_TEXT("calibration.same_tag_as",
                                        "it names the same tag as '%1'")(Named::marker(same->second)));
        known.emplace_back(*label, marker.label);
    }
    return {};
}

std::optional<TagLabel> tagLabel(std::string_view label)
{
    const LabelParts parts = partsOf(label);
    TagLabel result{std::nullopt, numbersOf(parts.number), parts.corner};
    if (result.numbers.empty() || (result.corner && result.numbers.size() > 1))
        return std::nullopt;
    if (parts.family.empty())
        return result;
    result.family = tagFamilyNamed(parts.family);
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
