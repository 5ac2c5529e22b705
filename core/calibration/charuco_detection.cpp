// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/charuco_detection.h"

#include "core/base/cancel_scope.h"
#include "core/calibration/charuco_layout.h"
#include "core/calibration/search_scale.h"
#include "core/geometry/homography.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

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

/// The markers of a picture that is `scale` times as large as the one their corners are given in.
std::vector<ReadMarker> readMarkers(const cv::Mat &picture, double scale, const NamedDictionary &dictionary)
{
    endIfCancelled();
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    cv::aruco::detectMarkers(picture, cv::aruco::getPredefinedDictionary(dictionary.dictionary), corners,
                             ids);
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
        if (sameId.size() == 1) // one number in two places: one of them is wrong, and nothing says which
            markers.push_back(sameId.front());
    }
    return markers;
}

/// A board's corner as the two markers beside it foretell it.
struct ForetoldCorner
{
    Vector2d pointInSquares, pixel;
    double nearestMarkerPx = 0;
    int markers = 0;
};

/// Corners between markers, in squares from the board's top left; only those with both markers read.
std::vector<ForetoldCorner> foretellCorners(const std::vector<ReadMarker> &markers,
                                            const CharucoLayout &layout, double markerRatio)
{
    std::map<std::array<int, 2>, ForetoldCorner> corners;
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
            ForetoldCorner &corner = corners[{at.y(), at.x()}];
            const double distance = (*pixel - marker.corners[i]).norm();
            corner.nearestMarkerPx =
                corner.markers == 0 ? distance : std::min(corner.nearestMarkerPx, distance);
            corner.pointInSquares = at.cast<double>();
            corner.pixel = (corner.pixel * corner.markers + *pixel) / (corner.markers + 1);
            ++corner.markers;
        }
    }
    std::vector<ForetoldCorner> sure;
    for (const auto &[at, corner] : corners) {
        if (corner.markers == 2)
            sure.push_back(corner);
    }
    return sure;
}

BoardView refined(const cv::Mat &luma, const std::vector<ForetoldCorner> &corners,
                  const CharucoLayout &layout, const BoardSpec &spec, const std::string &source)
{
    BoardView view{source, layout.squaresX - 1, layout.squaresY - 1, {}, {}, BoardPattern::Charuco};
    for (const ForetoldCorner &corner : corners) {
        // The window must not reach the markers, whose corners would pull.
        const int half = std::clamp(static_cast<int>(corner.nearestMarkerPx / std::sqrt(2.0)) - 1, 2,
                                    widestCornerWindowPx);
        std::vector<cv::Point2f> place{
            {static_cast<float>(corner.pixel.x()), static_cast<float>(corner.pixel.y())}};
        if (!cv::Rect2f(1, 1, static_cast<float>(luma.cols - 2), static_cast<float>(luma.rows - 2))
                 .contains(place[0]))
            continue;
        cv::cornerSubPix(luma, place, {half, half}, {-1, -1},
                         {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 50, 0.005});
        const Vector2d pixel(static_cast<double>(place[0].x), static_cast<double>(place[0].y));
        if ((pixel - corner.pixel).norm() > half)
            continue;
        view.pixels.push_back(pixel);
        view.pointsOnBoard.emplace_back(spec.squareM * (corner.pointInSquares - Vector2d(1, 1)));
    }
    return view;
}

} // namespace

Result<BoardView> findCharucoBoard(const cv::Mat &luma, const BoardSpec &spec, const std::string &source)
{
    const std::vector<NamedDictionary> dictionaries = dictionariesFor(spec.dictionary);
    if (dictionaries.empty())
        return fail(ErrorCode::InvalidInput, source, "there is no marker dictionary " + spec.dictionary,
                    "name one like DICT_6X6_250, or leave it out");
    const double scale = searchScale(luma);
    const cv::Mat searched = reduced(luma, scale);
    cv::Mat inverted;
    cv::bitwise_not(searched, inverted);
    std::size_t mostMarkers = 0;
    for (const cv::Mat *picture : {&searched, &std::as_const(inverted)}) {
        for (const NamedDictionary &dictionary : dictionaries) {
            const std::vector<ReadMarker> markers = readMarkers(*picture, scale, dictionary);
            mostMarkers = std::max(mostMarkers, markers.size());
            const auto layout = explainMarkers(markers, spec.columns, spec.rows);
            if (!layout)
                continue;
            const double ratio = measuredMarkerRatio(markers, *layout);
            BoardView view = refined(luma, foretellCorners(markers, *layout, ratio), *layout, spec, source);
            if (view.pixels.size() < leastCornersOfView)
                return refuseBoard(
                    source, "only " + std::to_string(view.pixels.size()) + " corners of the board are seen",
                    "show more of the board");
            return view;
        }
    }
    if (mostMarkers < 4)
        return refuseBoard(source,
                           "no board found: " + std::to_string(mostMarkers) + " of its markers could be read",
                           "show the board larger, sharp and well lit");
    const std::string size = spec.columns > 0 ? " of " + std::to_string(spec.columns) + "x" +
                                                    std::to_string(spec.rows) + " inner corners"
                                              : "";
    return refuseBoard(source, "the markers that were read do not lie as on a ChArUco board" + size,
                       spec.columns > 0 ? "count the inner corners, or leave the size out"
                                        : "show one ChArUco board");
}

} // namespace odo
