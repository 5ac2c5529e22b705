// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_detection.h"

#include "core/base/job_control.h"
#include "core/calibration/charuco_layout.h"
#include "core/calibration/internal/corner_grid.h"
#include "core/calibration/internal/luma_matrix.h"
#include "core/calibration/internal/marker_candidates.h"
#include "core/calibration/internal/wording.h"
#include "core/geometry/homography.h"
#include "core/video/image.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/aruco.hpp>
#include <opencv2/core.hpp>
#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace odo {

namespace {

using Eigen::Vector2d;

struct NamedDictionary
{
    const char *name;
    cv::aruco::PREDEFINED_DICTIONARY_NAME dictionary;
};

/// The smaller dictionaries of a family are the beginning of its largest one.
constexpr NamedDictionary largestDictionaries[] = {
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
    {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11},
};
constexpr NamedDictionary smallDictionaries[] = {
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},   {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250}, {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100}, {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50},   {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250}, {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100}, {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
};

std::vector<NamedDictionary> dictionariesFor(const std::string &name)
{
    std::vector<NamedDictionary> chosen;
    for (const NamedDictionary &candidate : largestDictionaries) {
        if (name.empty() || name == candidate.name)
            chosen.push_back(candidate);
    }
    for (const NamedDictionary &candidate : smallDictionaries) {
        if (name == candidate.name)
            chosen.push_back(candidate);
    }
    return chosen;
}

/// The markers of an image that is `scale` times as large as the one their corners are given in.
std::vector<ReadMarker> readMarkers(const cv::Mat &image, double scale, const NamedDictionary &dictionary)
{
    endIfCancelled();
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    cv::aruco::detectMarkers(image, cv::aruco::getPredefinedDictionary(dictionary.dictionary), corners, ids);
    std::map<int, std::vector<ReadMarker>> byId;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        ReadMarker marker{ids[i], {}};
        for (std::size_t corner = 0; corner < 4; ++corner)
            marker.corners[corner] = {unscaled(static_cast<double>(corners[i][corner].x), scale),
                                      unscaled(static_cast<double>(corners[i][corner].y), scale)};
        byId[ids[i]].push_back(marker);
    }
    std::vector<ReadMarker> markers;
    for (const auto &[id, sameId] : byId) {
        if (sameId.size() == 1) // one number at two positions: one is wrong, and we cannot know which
            markers.push_back(sameId.front());
    }
    return markers;
}

/// Fewer of an image's candidates than a board needs, since a reduced image shows fewer.
constexpr int leastLikelyMarkers = 3;

/// A board's corner as the two markers beside it predict it.
struct PredictedCorner
{
    Vector2d pointInSquares, pixel;
    double nearestMarkerPx = 0;
    int markers = 0;
};

/// Corners between markers, in squares from the board's top left; only those with both markers read.
std::vector<PredictedCorner> predictCorners(const std::vector<ReadMarker> &markers,
                                            const CharucoLayout &layout, double markerRatio)
{
    std::map<std::array<int, 2>, PredictedCorner> corners;
    for (const ReadMarker &marker : markers) {
        const auto square = layout.squareOf(marker.id);
        const double margin = 0.5 * (1 - markerRatio);
        std::vector<PointPair> pairs;
        const Vector2d local[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (std::size_t i = 0; i < 4; ++i)
            pairs.push_back({square->cast<double>() + Vector2d(margin, margin) + markerRatio * local[i],
                             marker.corners[i],
                             {}});
        const auto pixelFromSquare = Homography::estimate(pairs);
        for (std::size_t i = 0; pixelFromSquare && i < 4; ++i) {
            const Eigen::Vector2i at = *square + local[i].cast<int>();
            if (at.x() < 1 || at.y() < 1 || at.x() >= layout.squaresX || at.y() >= layout.squaresY)
                continue;
            const auto pixel = pixelFromSquare->map(at.cast<double>());
            if (!pixel)
                continue;
            PredictedCorner &corner = corners[{at.y(), at.x()}];
            const double distance = (*pixel - marker.corners[i]).norm();
            corner.nearestMarkerPx =
                corner.markers == 0 ? distance : std::min(corner.nearestMarkerPx, distance);
            corner.pointInSquares = at.cast<double>();
            corner.pixel = (corner.pixel * corner.markers + *pixel) / (corner.markers + 1);
            ++corner.markers;
        }
    }
    std::vector<PredictedCorner> sure;
    for (const auto &[at, corner] : corners) {
        if (corner.markers == 2)
            sure.push_back(corner);
    }
    return sure;
}

std::string boardText(int columns, int rows)
{
    return std::to_string(columns) + "x" + std::to_string(rows);
}

Message boardOfOtherCorners(const std::string &found, const std::string &asked)
{
    return ODO_TEXT("calibration.board_of_other_size", "this board has %1 inner corners, not %2")(found,
                                                                                                  asked);
}

Message noBoardFound()
{
    return ODO_TEXT("calibration.no_board_found", "no board found");
}

Message countCorners()
{
    return ODO_TEXT("calibration.count_corners", "count the inner corners, or leave the size out");
}

BoardView refined(const cv::Mat &luma, const std::vector<PredictedCorner> &corners,
                  const CharucoLayout &layout, const BoardSpec &spec, const std::string &source)
{
    BoardView view{source, layout.squaresX - 1, layout.squaresY - 1, {}, {}, BoardPattern::Charuco};
    for (const PredictedCorner &corner : corners) {
        // The window must not reach the markers, whose corners would pull.
        const int half = std::clamp(static_cast<int>(corner.nearestMarkerPx / std::sqrt(2.0)) - 1, 2,
                                    widestCornerWindowPx);
        std::vector<cv::Point2f> position{
            {static_cast<float>(corner.pixel.x()), static_cast<float>(corner.pixel.y())}};
        if (!cv::Rect2f(1, 1, static_cast<float>(luma.cols - 2), static_cast<float>(luma.rows - 2))
                 .contains(position[0]))
            continue;
        cv::cornerSubPix(luma, position, {half, half}, {-1, -1},
                         {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 50, 0.005});
        const Vector2d pixel(static_cast<double>(position[0].x), static_cast<double>(position[0].y));
        if ((pixel - corner.pixel).norm() > half)
            continue;
        view.pixels.push_back(pixel);
        view.pointsOnBoard.emplace_back(spec.squareM * (corner.pointInSquares - Vector2d(1, 1)));
    }
    return view;
}

} // namespace

/// findBoard for BoardPattern::Charuco. Boards that are printed inverted (bright markers on dark) are found
/// as well, and both ways of laying out a board with an even number of rows (OpenCV changed it in 4.6). An
/// inner corner counts when both markers beside it were read.
Result<BoardView> findCharucoBoard(const cv::Mat &luma, const BoardSpec &spec, const std::string &source)
{
    const std::vector<NamedDictionary> dictionaries = dictionariesFor(spec.dictionary);
    if (dictionaries.empty())
        return fail(
            ErrorCode::InvalidInput, nameAlone(source),
            ODO_TEXT("calibration.no_dictionary", "marker dictionary %1 does not exist")(spec.dictionary),
            ODO_TEXT("calibration.name_dictionary", "name one like DICT_6X6_250, or leave it out"));
    const double scale = searchScale(luma);
    const cv::Mat searched = reduced(luma, scale);
    cv::Mat inverted;
    cv::bitwise_not(searched, inverted);
    std::size_t mostMarkers = 0;
    for (const cv::Mat *image : {&searched, &std::as_const(inverted)}) {
        MarkerCandidates candidates(*image);
        for (const NamedDictionary &dictionary : dictionaries) {
            const int likely = candidates.countIn(*cv::aruco::getPredefinedDictionary(dictionary.dictionary));
            if (likely < leastLikelyMarkers)
                continue;
            const std::vector<ReadMarker> markers = readMarkers(*image, scale, dictionary);
            mostMarkers = std::max(mostMarkers, markers.size());
            const auto layout = explainMarkers(markers, spec.columns, spec.rows);
            if (!layout)
                continue;
            const double ratio = measuredMarkerRatio(markers, *layout);
            BoardView view = refined(luma, predictCorners(markers, *layout, ratio), *layout, spec, source);
            if (view.pixels.size() < leastCornersOfView)
                return refuseBoard(source,
                                   ODO_TEXT("calibration.few_corners_seen",
                                            "only %1 corners of the board are visible")(view.pixels.size()),
                                   ODO_TEXT("calibration.show_more_of_board", "show more of the board"));
            return view;
        }
    }
    if (mostMarkers < 4)
        return refuseBoard(
            source,
            joined({noBoardFound(),
                    ODO_TEXT("calibration.markers_read", "%1 of its markers could be read")(mostMarkers)},
                   Join::Colon),
            ODO_TEXT("calibration.show_board_larger", "show the board larger, sharp and well lit"));
    if (spec.columns > 0)
        return refuseBoard(source,
                           ODO_TEXT("calibration.no_charuco_of_size",
                                    "the detected markers do not match a ChArUco board of %1 inner corners")(
                               boardText(spec.columns, spec.rows)),
                           countCorners());
    return refuseBoard(
        source, ODO_TEXT("calibration.no_charuco", "the detected markers do not match a ChArUco board"),
        ODO_TEXT("calibration.show_one_charuco", "show one ChArUco board"));
}

namespace {

using cv::Point2f;

constexpr double firstSearchSide =
    1000; // pixels: search an image of this size first, it is fast and forgives noise
constexpr double leastSearchSide = 240;
constexpr float windowOfSpacing = 0.5F;
constexpr float mostMoved = 0.3F; // of the spacing, when a corner is refined
constexpr float worstBlurOfSpacing = 0.4F;
constexpr float worstBlurPx = 12;
constexpr double leastPartOfBoard = 2.0 / 3;

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

/// Whether the next line of corners beyond a side of the grid would leave the image.
bool leavesImage(const CornerGrid &grid, const cv::Mat &luma, bool alongColumns)
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
                           joined({ODO_TEXT("calibration.board_blurred", "the board is blurred"),
                                   edgesAreWide(static_cast<double>(blur))},
                                  Join::Colon),
                           ODO_TEXT("calibration.hold_board_still", "hold it still, and focus the camera"));
    CornerGrid sharp = grid;
    const int half = std::clamp(static_cast<int>(windowOfSpacing * spacing), 2, widestCornerWindowPx);
    cv::cornerSubPix(luma, sharp.corners, {half, half}, {-1, -1},
                     {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 50, 0.005});
    for (std::size_t i = 0; i < sharp.corners.size(); ++i) {
        if (cv::norm(sharp.corners[i] - grid.corners[i]) > static_cast<double>(mostMoved * spacing))
            return refuseBoard(source,
                               ODO_TEXT("calibration.corner_unclear", "one corner of the board is unclear"),
                               ODO_TEXT("calibration.keep_board_clear", "keep the board clear and well lit"));
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

/// The board of the given size, turned upright, even if the image border cuts it off.
Result<CornerGrid> matched(const cv::Mat &luma, const CornerGrid &grid, const BoardSpec &spec,
                           const std::string &source)
{
    if (spec.columns == 0)
        return oriented(grid, std::max(grid.columns, grid.rows), std::min(grid.columns, grid.rows));
    const CornerGrid upright = oriented(grid, spec.columns, spec.rows);
    if (isSize(grid, spec.columns, spec.rows))
        return upright;
    const std::string found = boardText(std::max(grid.columns, grid.rows), std::min(grid.columns, grid.rows));
    const std::string asked = boardText(spec.columns, spec.rows);
    const bool cutOff = !upright.corners.empty() &&
                        (upright.columns == spec.columns || leavesImage(upright, luma, true)) &&
                        (upright.rows == spec.rows || leavesImage(upright, luma, false));
    if (!cutOff)
        return refuseBoard(source, boardOfOtherCorners(found, asked), countCorners());
    if (static_cast<double>(upright.corners.size()) < leastPartOfBoard * spec.columns * spec.rows)
        return refuseBoard(source,
                           joined({ODO_TEXT("calibration.board_cut_off", "the board is cut off"),
                                   ODO_TEXT("calibration.board_part_seen",
                                            "only %1 of its %2 inner corners are visible")(found, asked)},
                                  Join::Colon),
                           ODO_TEXT("calibration.keep_whole_board", "keep the whole board in view"));
    return upright;
}

} // namespace

/// findBoard for BoardPattern::Checkerboard. A board of a given size that is partly outside the image counts
/// with its visible corners (at least two thirds).
Result<BoardView> findCheckerboard(const cv::Mat &luma, const BoardSpec &spec, const std::string &source)
{
    const CornerGrid grid = searchScales(luma, spec);
    if (grid.corners.empty())
        return refuseBoard(
            source, noBoardFound(),
            ODO_TEXT("calibration.show_whole_board", "show the whole board, flat, sharp and well lit"));
    const auto upright = ODO_TRY(matched(luma, grid, spec, source));
    const float blur = blurOf(luma, upright);
    const auto sharp = ODO_TRY(refined(luma, upright, blur, source));
    BoardView view = viewOf(sharp, spec, source);
    view.edgeWidthPx = static_cast<double>(blur);
    return view;
}

tl::unexpected<Error> refuseBoard(const std::string &source, Message why, Message advice)
{
    return fail(ErrorCode::Undetermined, nameAlone(source), std::move(why), std::move(advice));
}

Message otherSizeThanMost(int widthPx, int heightPx, int mostWidthPx, int mostHeightPx)
{
    return ODO_TEXT("calibration.other_picture_size",
                    "it is %1×%2, the other images are %3×%4")(widthPx, heightPx, mostWidthPx, mostHeightPx);
}

Message boardOfOtherSize(const BoardView &view, const BoardSpec &wanted)
{
    return boardOfOtherCorners(boardText(view.columns, view.rows), boardText(wanted.columns, wanted.rows));
}

Result<BoardView> findBoard(const Frame &frame, const BoardSpec &spec, const std::string &source)
{
    if (frame.y.data == nullptr || frame.y.width < 32 || frame.y.height < 32)
        return refuseBoard(source,
                           ODO_TEXT("calibration.too_small_for_board", "the image is too small for a board"),
                           useCameraImage());
    const bool told = spec.columns != 0 || spec.rows != 0;
    if (told && (spec.columns < 3 || spec.rows < 3))
        return fail(
            ErrorCode::InvalidInput, nameAlone(source),
            ODO_TEXT("calibration.told_board_too_small",
                     "a board of %1 inner corners is too small")(boardText(spec.columns, spec.rows)),
            ODO_TEXT("calibration.give_board_size", "give at least 3x3, such as 9x6, or leave the size out"));
    if (!(spec.squareM > 0))
        return fail(ErrorCode::InvalidInput, nameAlone(source),
                    ODO_TEXT("calibration.squares_without_size", "the squares have no size"),
                    ODO_TEXT("calibration.give_square_size", "give a size such as 25mm"));
    try {
        const cv::Mat luma = lumaMatrix(frame);
        if (spec.pattern == BoardPattern::Checkerboard)
            return findCheckerboard(luma, spec, source);
        auto charuco = findCharucoBoard(luma, spec, source);
        if (charuco || spec.pattern)
            return charuco;
        return findCheckerboard(luma, spec, source);
    } catch (const cv::Exception &exception) {
        return fail(ErrorCode::Internal, nameAlone(source), foreignWords(exception.what()),
                    useAnotherImage());
    }
}

} // namespace odo
