// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/layout_board.h"

#include "core/calibration/board_detection.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>

namespace odo {

namespace {

constexpr int mostBoardCorners = 30; // each way, as findBoard

/// The number that a text begins with, which is then without it.
std::optional<int> takenNumber(std::string_view &text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || number < 0)
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

bool takenSign(std::string_view &text, char sign)
{
    if (text.empty() || text.front() != sign)
        return false;
    text.remove_prefix(1);
    return true;
}

} // namespace

std::optional<BoardCorner> boardCorner(std::string_view label)
{
    std::string plain;
    for (const char c : label) {
        if (c != ' ')
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    constexpr std::string_view word = "charuco";
    std::string_view left = plain;
    if (!left.starts_with(word))
        return std::nullopt;
    left.remove_prefix(word.size());
    const auto columns = takenNumber(left);
    if (!columns || !takenSign(left, 'x'))
        return std::nullopt;
    const auto rows = takenNumber(left);
    if (!rows || !takenSign(left, ':'))
        return std::nullopt;
    const auto number = takenNumber(left);
    if (!number || !left.empty() || *columns > mostBoardCorners || *rows > mostBoardCorners ||
        *number >= *columns * *rows)
        return std::nullopt;
    return BoardCorner{*columns, *rows, *number};
}

Result<std::vector<MarkerPixel>> findBoardCorners(const Frame &frame, const MarkerLayout &layout)
{
    std::vector<MarkerPixel> markers;
    std::optional<BoardView> view;
    for (const Marker &marker : layout.markers) {
        const auto corner = boardCorner(marker.label);
        if (!corner)
            continue;
        if (!view) {
            BoardSpec spec;
            spec.pattern = BoardPattern::Charuco;
            spec.columns = corner->columns;
            spec.rows = corner->rows;
            spec.squareM = 1;
            view = ODO_TRY(findBoard(frame, spec, {}));
        }
        if (corner->columns != view->columns || corner->rows != view->rows)
            continue;
        for (std::size_t i = 0; i < view->pixels.size(); ++i) {
            const Eigen::Vector2d &at = view->pointsOnBoard[i];
            if (std::lround(at.y()) * view->columns + std::lround(at.x()) == corner->number)
                markers.push_back({marker.label, view->pixels[i]});
        }
    }
    return markers;
}

} // namespace odo
