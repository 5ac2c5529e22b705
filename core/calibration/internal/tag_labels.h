// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/internal/tag_families.h"
#include "core/calibration/marker_layout.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace odo {

/// What a label says of tags: "100", "tag 100", "id 100", "36h11:100", "DICT_4X4_50:7" (the middle of a tag),
/// "100.tl" (a corner of it, with tl, tr, br, bl as its print is read upright), "12+13+14+15" (the middle of
/// several tags).
struct TagLabel
{
    std::optional<TagFamily> family; ///< nullopt: it names none
    std::vector<int> numbers;
    std::optional<int> corner; ///< clockwise from the top left

    bool operator==(const TagLabel &) const = default;
};

/// nullopt: the label is no number.
std::optional<TagLabel> tagLabel(std::string_view label);

/// Refuses a layout with a label that names a family of tags, but none of its tags. Where more than half of
/// the labels are tags, also one that is written as one and is none ("12+", "3.xx"), and two that name the
/// same point of a tag: their markers would be sought under other tags.
Result<void> checkTagLabels(const MarkerLayout &layout);

/// A marker of a layout as a point of tags.
struct TaggedPoint
{
    std::size_t marker = 0; ///< index in the layout
    std::vector<TagName> tags;
    std::optional<int> corner;

    bool operator==(const TaggedPoint &) const = default;
};

/// A reading of a layout: which tags its markers are.
struct TagRule
{
    bool byPlace = false; ///< the tag's number is the marker's index in the layout, whatever the label
    bool isNamed = false; ///< every label names its family
    std::vector<TaggedPoint> points;

    /// Its tags may be there though it does not fit: the family that Odograph prints, or one that is named.
    bool isExpected() const;
    bool uses(TagFamily family) const;
};

/// The readings of a layout that are possible, first those of the family that Odograph prints. Labels that
/// name the same point of a tag are in none by numbers.
std::vector<TagRule> tagRules(const MarkerLayout &layout);

} // namespace odo
