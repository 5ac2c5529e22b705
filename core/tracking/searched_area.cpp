// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/searched_area.h"

#include <array>
#include <cstdio>
#include <string_view>

namespace odo {

bool isWithin(const PixelPolygon &polygon, const Eigen::Vector2d &pixel)
{
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        if ((a.y() > pixel.y()) == (b.y() > pixel.y()))
            continue;
        const double crossing = a.x() + (pixel.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        inside ^= pixel.x() < crossing;
    }
    return inside;
}

namespace {

constexpr std::string_view searchedWords = "; searched in", ignoringWords = "; ignoring";

} // namespace

std::string noteOf(const SearchedArea &area)
{
    std::string note;
    const auto add = [&note](std::string_view word, const std::vector<PixelPolygon> &polygons) {
        for (const PixelPolygon &polygon : polygons) {
            note += word;
            for (const Eigen::Vector2d &corner : polygon) {
                std::array<char, 64> text{};
                std::snprintf(text.data(), text.size(), " %.1f,%.1f", corner.x(), corner.y());
                note += text.data();
            }
        }
    };
    add(searchedWords, area.search);
    add(ignoringWords, area.ignored);
    return note;
}

std::string areaNoteIn(const std::string &note)
{
    std::string own;
    for (std::size_t at = note.find("; "); at != std::string::npos;) {
        const std::size_t end = note.find("; ", at + 1);
        const std::string_view part = std::string_view(note).substr(at, end - at);
        if (part.starts_with(searchedWords) || part.starts_with(ignoringWords))
            own += part;
        at = end;
    }
    return own;
}

} // namespace odo
