// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/tag_families.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <opencv2/aruco/dictionary.hpp>
#include <utility>
#include <vector>
extern "C" {
#include <apriltag/apriltag.h>
#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h10.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagStandard41h12.h>
}

namespace odo {

namespace {

struct FamilyFacts
{
    TagFamily family;
    const char *name;
    int mendedCells;
    apriltag_family_t *(*create)(); ///< nullptr: a dictionary of OpenCV
    void (*destroy)(apriltag_family_t *);
    cv::aruco::PREDEFINED_DICTIONARY_NAME dictionary;
};

using namespace cv::aruco; // NOLINT(google-build-using-namespace): names of its dictionaries

constexpr std::array<FamilyFacts, 10> familyFacts{{
    {TagFamily::AprilTag36h11, "AprilTag 36h11", 1, tag36h11_create, tag36h11_destroy, {}},
    {TagFamily::AprilTag36h10, "AprilTag 36h10", 1, tag36h10_create, tag36h10_destroy, {}},
    {TagFamily::AprilTag25h9, "AprilTag 25h9", 1, tag25h9_create, tag25h9_destroy, {}},
    {TagFamily::AprilTag16h5, "AprilTag 16h5", 0, tag16h5_create, tag16h5_destroy, {}},
    {TagFamily::AprilTag41h12,
     "AprilTag Standard41h12",
     1,
     tagStandard41h12_create,
     tagStandard41h12_destroy,
     {}},
    {TagFamily::Aruco7x7, "ArUco 7X7", 1, nullptr, nullptr, DICT_7X7_1000},
    {TagFamily::Aruco6x6, "ArUco 6X6", 1, nullptr, nullptr, DICT_6X6_1000},
    {TagFamily::Aruco5x5, "ArUco 5X5", 1, nullptr, nullptr, DICT_5X5_1000},
    {TagFamily::ArucoOriginal, "ArUco original", 0, nullptr, nullptr, DICT_ARUCO_ORIGINAL},
    {TagFamily::Aruco4x4, "ArUco 4X4", 0, nullptr, nullptr, DICT_4X4_1000},
}};

const FamilyFacts &factsOf(TagFamily family)
{
    return *std::ranges::find(familyFacts, family, &FamilyFacts::family);
}

/// A dictionary of OpenCV in the form of libapriltag.
struct DictionaryFamily
{
    apriltag_family_t family{};
    std::vector<std::uint64_t> codes;
    std::vector<std::uint32_t> x, y;
    std::string name;
};

/// libapriltag turns a code by a quarter by shifting it by a quarter of its bits: those of one quadrant come
/// first, then the same ones turned, and the middle last.
std::vector<std::pair<int, int>> cellsByQuadrants(int across)
{
    std::vector<std::pair<int, int>> quadrant, cells;
    for (int ring = 0; ring < across / 2; ++ring) {
        for (int i = ring; i < across - 1 - ring; ++i)
            quadrant.emplace_back(i, ring);
    }
    for (int quarter = 0; quarter < 4; ++quarter) {
        cells.insert(cells.end(), quadrant.begin(), quadrant.end());
        for (auto &cell : quadrant)
            cell = {across - 1 - cell.second, cell.first};
    }
    if (across % 2 == 1)
        cells.emplace_back(across / 2, across / 2);
    return cells;
}

void destroyDictionary(apriltag_family_t *family)
{
    // The family is the first member of what was made.
    delete reinterpret_cast<DictionaryFamily *>(family); // NOLINT
}

apriltag_family_t *createDictionary(const FamilyFacts &facts)
{
    const cv::Ptr<Dictionary> dictionary = getPredefinedDictionary(facts.dictionary);
    auto made = std::make_unique<DictionaryFamily>();
    const auto cells = cellsByQuadrants(dictionary->markerSize);
    for (const auto &[x, y] : cells) {
        made->x.push_back(static_cast<std::uint32_t>(x + 1));
        made->y.push_back(static_cast<std::uint32_t>(y + 1));
    }
    for (int number = 0; number < dictionary->bytesList.rows; ++number) {
        const cv::Mat bits =
            Dictionary::getBitsFromByteList(dictionary->bytesList.row(number), dictionary->markerSize);
        std::uint64_t code = 0;
        for (const auto &[x, y] : cells)
            code = (code << 1) | (bits.at<std::uint8_t>(y, x) != 0 ? 1U : 0U);
        made->codes.push_back(code);
    }
    made->name = facts.name;
    made->family.ncodes = static_cast<std::uint32_t>(made->codes.size());
    made->family.codes = made->codes.data();
    made->family.width_at_border = dictionary->markerSize + 2;
    made->family.total_width = dictionary->markerSize + 4;
    made->family.nbits = static_cast<std::uint32_t>(cells.size());
    made->family.bit_x = made->x.data();
    made->family.bit_y = made->y.data();
    made->family.h = 1;
    made->family.name = made->name.data();
    return &made.release()->family;
}

} // namespace

std::span<const TagFamily> allTagFamilies()
{
    static constexpr auto all = [] {
        std::array<TagFamily, familyFacts.size()> families{};
        std::ranges::transform(familyFacts, families.begin(), &FamilyFacts::family);
        return families;
    }();
    return all;
}

std::span<const TagFamily> printedTagFamily()
{
    return allTagFamilies().first(1);
}

std::string nameOf(TagFamily family)
{
    return factsOf(family).name;
}

std::optional<TagFamily> tagFamilyNamed(std::string_view name)
{
    std::string plain;
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    for (const std::string_view word : {"dict", "apriltag", "aruco", "tag", "standard"}) {
        if (plain.starts_with(word))
            plain.erase(0, word.size());
    }
    static constexpr std::array<std::pair<std::string_view, TagFamily>, 6> others{{
        {"36h11", TagFamily::AprilTag36h11},
        {"36h10", TagFamily::AprilTag36h10},
        {"25h9", TagFamily::AprilTag25h9},
        {"16h5", TagFamily::AprilTag16h5},
        {"41h12", TagFamily::AprilTag41h12},
        {"original", TagFamily::ArucoOriginal},
    }};
    for (const auto &[word, family] : others) {
        if (plain == word)
            return family;
    }
    static constexpr std::array<std::pair<std::string_view, TagFamily>, 4> sizes{{
        {"4x4", TagFamily::Aruco4x4},
        {"5x5", TagFamily::Aruco5x5},
        {"6x6", TagFamily::Aruco6x6},
        {"7x7", TagFamily::Aruco7x7},
    }};
    for (const auto &[word, family] : sizes) {
        const std::string count = plain.starts_with(word) ? plain.substr(word.size()) : "none";
        if (count.empty() || count == "50" || count == "100" || count == "250" || count == "1000")
            return family;
    }
    return std::nullopt;
}

bool isReadByChance(TagFamily family)
{
    return factsOf(family).mendedCells == 0;
}

int mendedCells(TagFamily family)
{
    return factsOf(family).mendedCells;
}

ReadFamily readFamily(TagFamily family)
{
    const FamilyFacts &facts = factsOf(family);
    if (facts.create != nullptr)
        return {facts.create(), facts.destroy};
    return {createDictionary(facts), destroyDictionary};
}

std::optional<TagCells> tagCells(const TagName &tag)
{
    const ReadFamily made = readFamily(tag.family);
    const apriltag_family_t &family = *made;
    if (tag.number < 0 || static_cast<std::uint32_t>(tag.number) >= family.ncodes)
        return std::nullopt;
    // Of a family with bits outside its border all cells count, of another the black square.
    const int side = family.reversed_border ? family.total_width : family.width_at_border;
    const int margin = (side - family.width_at_border) / 2;
    TagCells cells{side, std::vector<bool>(static_cast<std::size_t>(side * side), false),
                   double(side) / family.width_at_border};
    const auto cell = [&](int x, int y) {
        return cells.white.begin() + static_cast<std::ptrdiff_t>((y + margin) * side + x + margin);
    };
    if (family.reversed_border) {
        for (int y = 0; y < family.width_at_border; ++y) {
            for (int x = 0; x < family.width_at_border; ++x)
                *cell(x, y) = true;
        }
    }
    const std::uint64_t code = family.codes[tag.number];
    for (std::uint32_t i = 0; i < family.nbits; ++i)
        *cell(static_cast<int>(family.bit_x[i]), static_cast<int>(family.bit_y[i])) =
            (code >> (family.nbits - i - 1)) & 1;
    return cells;
}

} // namespace odo
