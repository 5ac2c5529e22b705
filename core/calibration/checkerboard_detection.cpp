// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/checkerboard_detection.h"

#include "core/base/cancel_scope.h"
#include "core/base/units.h"
#include "core/calibration/corner_grid.h"
#include "core/calibration/saddle_points.h"
#include "core/calibration/search_scale.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace odo {

namespace {

using cv::Point2f;

constexpr double firstSearchSide =
    1000; // pixels: search a picture of this size first, it is fast and forgives noise
constexpr double leastSearchSide = 240;
constexpr float windowOfSpacing = 0.5F;
constexpr float mostMoved = 0.3F; // of the spacing, when a corner is refined
constexpr float worstBlurOfSpacing = 0.4F;
constexpr float worstBlurPx = 12;
constexpr double leastPartOfBoard = 2.0 / 3;

std::string sizeText(int columns, int rows)
{
    return std::to_string(columns) + "x" + std::to_string(rows);
}

bool isSize(const CornerGrid &grid, int columns, int rows)
{
    return (grid.columns == columns && grid.rows == rows) || (grid.columns == rows && grid.rows == columns);
}

bool isWanted(const CornerGrid &grid, const BoardSpec &spec)
{
    if (spec.columns == 0)
        return grid.corners.size() >= 12;
    return isSize(grid, spec.columns, spec.rows);
}

CornerGrid searchScales(const cv::Mat &luma, const BoardSpec &spec)
{
    const double side = std::max(luma.cols, luma.rows);
    const double first = std::min(1.0, firstSearchSide / side);
    std::vector<double> scales{first};
    if (const double largest = searchScale(luma); first < largest)
        scales.push_back(largest); // small squares
    if (0.5 * first * side > leastSearchSide)
        scales.push_back(0.5 * first); // blurred ones
    CornerGrid best;
    for (double scale : scales) {
        endIfCancelled();
        CornerGrid grid = findCornerGrid(reduced(luma, scale));
        for (Point2f &corner : grid.corners)
            corner = unscaled(corner, scale);
        if (isWanted(grid, spec))
            return grid;
        if (grid.corners.size() > best.corners.size())
            best = std::move(grid);
    }
    return best;
}

/// The same corners read a quarter turn further.
CornerGrid turned(const CornerGrid &grid)
{
    CornerGrid result{grid.rows, grid.columns, {}};
    for (int y = 0; y < result.rows; ++y) {
        for (int x = 0; x < result.columns; ++x)
            result.corners.push_back(grid.at(y, grid.rows - 1 - x));
    }
    return result;
}

/// Of the turns that fit into so many columns and rows, the one that starts nearest to the top left; empty if
/// none does.
CornerGrid oriented(const CornerGrid &grid, int columns, int rows)
{
    const auto start = [](const CornerGrid &g) { return g.corners.front().x + g.corners.front().y; };
    CornerGrid best, candidate = grid;
    for (int turn = 0; turn < 4; ++turn) {
        candidate = turned(candidate);
        const bool fits = candidate.columns <= columns && candidate.rows <= rows;
        if (fits && (best.corners.empty() || start(candidate) < start(best)))
            best = candidate;
    }
    return best;
}

/// Whether the next line of corners beyond a side of the grid would leave the picture.
bool leavesPicture(const CornerGrid &grid, const cv::Mat &luma, bool alongColumns)
{
    const int lines = alongColumns ? grid.columns : grid.rows,
              length = alongColumns ? grid.rows : grid.columns;
    const auto at = [&](int line, int i) { return alongColumns ? grid.at(line, i) : grid.at(i, line); };
    for (const auto &[last, before] : {std::pair(0, 1), std::pair(lines - 1, lines - 2)}) {
        for (int i = 0; i < length; ++i) {
            const Point2f next = 2 * at(last, i) - at(before, i);
            const float margin = 0.1F * static_cast<float>(cv::norm(next - at(last, i)));
            if (next.x < margin || next.y < margin || next.x > static_cast<float>(luma.cols) - margin ||
                next.y > static_cast<float>(luma.rows) - margin)
                return true;
        }
    }
    return false;
}

/// The width over which an edge of the board goes from 10 to 90 % of its step; nullopt without a clear step.
std::optional<float> edgeWidth(const cv::Mat &luma, Point2f middle, Point2f across, float length)
{
    std::vector<float> profile;
    constexpr int samplesPerPixel = 2;
    const int half = static_cast<int>(0.4F * length * samplesPerPixel);
    for (int i = -half; i <= half; ++i)
        profile.push_back(greyAt(luma, middle + across * (static_cast<float>(i) / samplesPerPixel)));
    if (profile.size() < 5 || std::abs(profile.back() - profile.front()) < 10)
        return std::nullopt;
    const auto crossing = [&](float part) {
        const float level = profile.front() + part * (profile.back() - profile.front());
        const bool rising = profile.back() > profile.front();
        const auto first =
            std::ranges::find_if(profile, [&](float v) { return rising ? v >= level : v <= level; });
        return static_cast<float>(first - profile.begin());
    };
    return (crossing(0.9F) - crossing(0.1F)) / samplesPerPixel;
}

/// The blur of the worse direction: motion blurs only the edges across it.
float blurOf(const cv::Mat &luma, const CornerGrid &grid)
{
    std::vector<float> widths;
    const auto look = [&](Point2f a, Point2f b) {
        const Point2f along = b - a;
        const auto length = static_cast<float>(cv::norm(along));
        if (const auto width = edgeWidth(luma, 0.5F * (a + b), Point2f(-along.y, along.x) / length, length))
            widths.push_back(*width);
    };
    for (int y = 1; y < grid.rows; ++y) {
        for (int x = 1; x < grid.columns; ++x) {
            look(grid.at(x - 1, y), grid.at(x, y));
            look(grid.at(x, y - 1), grid.at(x, y));
        }
    }
    if (widths.empty())
        return 0;
    std::ranges::sort(widths);
    return widths[widths.size() * 3 / 4];
}

Result<CornerGrid> refined(const cv::Mat &luma, const CornerGrid &grid, float blur, const std::string &source)
{
    const float spacing = grid.spacing();
    if (blur > worstBlurOfSpacing * spacing || blur > worstBlurPx)
        return refuseBoard(source,
                           "the board is blurred: its edges are " +
                               formatNumber(static_cast<double>(blur), 0) + " pixels wide",
                           "hold it still, and focus the camera");
    CornerGrid sharp = grid;
    const int half = std::clamp(static_cast<int>(windowOfSpacing * spacing), 2, widestCornerWindowPx);
    cv::cornerSubPix(luma, sharp.corners, {half, half}, {-1, -1},
                     {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 50, 0.005});
    for (std::size_t i = 0; i < sharp.corners.size(); ++i) {
        if (cv::norm(sharp.corners[i] - grid.corners[i]) > static_cast<double>(mostMoved * spacing))
            return refuseBoard(source, "a corner of the board cannot be made out",
                               "keep the board clear and well lit");
    }
    return sharp;
}

BoardView viewOf(const CornerGrid &grid, const BoardSpec &spec, const std::string &source)
{
    BoardView view{source,
                   spec.columns > 0 ? spec.columns : grid.columns,
                   spec.columns > 0 ? spec.rows : grid.rows,
                   {},
                   {}};
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns; ++x) {
            const Point2f &corner = grid.at(x, y);
            view.pixels.emplace_back(static_cast<double>(corner.x), static_cast<double>(corner.y));
            view.pointsOnBoard.emplace_back(x * spec.squareM, y * spec.squareM);
        }
    }
    return view;
}

/// The board as told, turned upright; also one that is cut off by the picture's border.
Result<CornerGrid> matched(const cv::Mat &luma, const CornerGrid &grid, const BoardSpec &spec,
                           const std::string &source)
{
    if (spec.columns == 0)
        return oriented(grid, std::max(grid.columns, grid.rows), std::min(grid.columns, grid.rows));
    const CornerGrid upright = oriented(grid, spec.columns, spec.rows);
    if (isSize(grid, spec.columns, spec.rows))
        return upright;
    const std::string found = sizeText(std::max(grid.columns, grid.rows), std::min(grid.columns, grid.rows));
    const std::string asked = sizeText(spec.columns, spec.rows);
    const bool cutOff = !upright.corners.empty() &&
                        (upright.columns == spec.columns || leavesPicture(upright, luma, true)) &&
                        (upright.rows == spec.rows || leavesPicture(upright, luma, false));
    if (!cutOff)
        return refuseBoard(source, "this board has " + found + " inner corners, " + asked + " was asked for",
                           "count the inner corners, or leave the size out");
    if (static_cast<double>(upright.corners.size()) < leastPartOfBoard * spec.columns * spec.rows)
        return refuseBoard(
            source, "the board is cut off: only " + found + " of its " + asked + " inner corners are seen",
            "keep the whole board in the picture");
    return upright;
}

} // namespace

Result<BoardView> findCheckerboard(const cv::Mat &luma, const BoardSpec &spec, const std::string &source)
{
    const CornerGrid grid = searchScales(luma, spec);
    if (grid.corners.empty())
        return refuseBoard(source, "no board found", "show the whole board, flat, sharp and well lit");
    const auto upright = matched(luma, grid, spec, source);
    if (!upright)
        return tl::unexpected(upright.error());
    const float blur = blurOf(luma, *upright);
    const auto sharp = refined(luma, *upright, blur, source);
    if (!sharp)
        return tl::unexpected(sharp.error());
    BoardView view = viewOf(*sharp, spec, source);
    view.edgeWidthPx = static_cast<double>(blur);
    return view;
}

} // namespace odo
