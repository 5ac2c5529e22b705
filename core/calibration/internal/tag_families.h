// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/tag_alignment.h"

#include <compare>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

struct apriltag_family;

namespace odo {

/// The kinds of square tags that are read. OpenCV's dictionaries of one size (4X4_50 to 4X4_1000) are one
/// family: the smaller ones begin with the same tags.
enum class TagFamily {
    AprilTag36h11,
    AprilTag36h10,
    AprilTag25h9,
    AprilTag16h5,
    AprilTag41h12,
    Aruco7x7,
    Aruco6x6,
    Aruco5x5,
    ArucoOriginal,
    Aruco4x4
};

/// All of them; the one that Odograph prints first.
std::span<const TagFamily> allTagFamilies();
/// That one alone.
std::span<const TagFamily> printedTagFamily();

/// "AprilTag 36h11", "ArUco 4X4".
std::string nameOf(TagFamily family);
/// "36h11", "tag36h11", "AprilTag 36h11", "4X4", "DICT_4X4_50", "ArUco 4x4"; case, spaces and signs do not
/// count.
std::optional<TagFamily> tagFamilyNamed(std::string_view name);

/// So few cells that a black square, or a tag of another family, often reads as one of them.
bool isReadByChance(TagFamily family);

/// One tag of all.
struct TagName
{
    TagFamily family = TagFamily::AprilTag36h11;
    int number = 0;

    auto operator<=>(const TagName &) const = default;
};

/// The cells of a tag; nullopt where the family has no such number.
std::optional<TagCells> tagCells(const TagName &tag);

/// A family as libapriltag reads it. It must outlive the detector it is added to, and is in one at a time.
using ReadFamily = std::unique_ptr<apriltag_family, void (*)(apriltag_family *)>;
ReadFamily readFamily(TagFamily family);
/// How many wrong cells are mended in reading one.
int mendedCells(TagFamily family);

} // namespace odo
