// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/view_change.h"

#include "core/base/percentile.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace odo {

namespace {

constexpr int widestPx = 1280;      // of an image in which points are looked for
constexpr int mostPoints = 2000;    // of an image
constexpr double nearerThan = 0.75; // the next, which a match must be
constexpr std::size_t fewestAlike = 24;
// of the points that agree, of the width: their standard deviation, a third where they are all over the
// image. What fills less of it may have moved by itself.
constexpr double leastSpread = 0.2;
constexpr double alikePx = 1;           // points agree with a change to this
constexpr double closePx = 0.5;         // and those by which it is held against none
constexpr double clearlyMore = 1.5;     // points must follow a change than nothing
constexpr double ofAnother = 5;         // as many, for another view than before
constexpr double samePx = 0.6;          // as far as this nothing has changed
constexpr double farthest = 0.05;       // of the width, that a push shifts
constexpr double mostZoom = 0.03;       // of a push
constexpr double mostTurnRad = 0.08727; // 5°

struct Points
{
    std::vector<cv::KeyPoint> at;
    cv::Mat descriptors;
};

Points pointsOf(const cv::Mat &image)
{
    Points points;
    cv::SIFT::create(mostPoints)->detectAndCompute(image, cv::noArray(), points.at, points.descriptors);
    return points;
}

/// Where a point of the scene is in the one image and in the other.
struct Matches
{
    std::vector<cv::Point2d> before, now;
};

/// The nearest to each, where it is clearly nearer than the next; -1 elsewhere.
std::vector<int> nearestOf(const cv::BFMatcher &matcher, const cv::Mat &from, const cv::Mat &to)
{
    std::vector<std::vector<cv::DMatch>> found;
    matcher.knnMatch(from, to, found, 2);
    std::vector<int> nearest;
    for (const auto &candidates : found) {
        const bool isClear = candidates.size() == 2 &&
                             double(candidates[0].distance) < nearerThan * double(candidates[1].distance);
        nearest.push_back(isClear ? candidates[0].trainIdx : -1);
    }
    return nearest;
}

Matches matched(const Points &before, const Points &now)
{
    Matches matches;
    if (before.at.size() < fewestAlike || now.at.size() < fewestAlike)
        return matches;
    const cv::BFMatcher matcher(cv::NORM_L2);
    const std::vector<int> forth = nearestOf(matcher, before.descriptors, now.descriptors),
                           back = nearestOf(matcher, now.descriptors, before.descriptors);
    for (std::size_t i = 0; i < forth.size(); ++i) {
        if (forth[i] < 0 || back[std::size_t(forth[i])] != int(i))
            continue;
        matches.before.emplace_back(before.at[i].pt);
        matches.now.emplace_back(now.at[std::size_t(forth[i])].pt);
    }
    return matches;
}

Eigen::Vector2d moved(const Eigen::Matrix3d &homography, const cv::Point2d &point)
{
    return (homography * Eigen::Vector3d(point.x, point.y, 1)).hnormalized();
}

/// A homography, and the points that follow it.
struct Fit
{
    Eigen::Matrix3d homography = Eigen::Matrix3d::Identity();
    std::size_t alike = 0;            ///< that follow it
    std::size_t close = 0, still = 0; ///< that follow it, and that stayed, within less
    double spreadPx = 0, shiftPx = 0; ///< of those that follow it
};

std::optional<Fit> fitted(const Matches &matches)
{
    if (matches.before.size() < fewestAlike)
        return std::nullopt;
    const cv::Mat found = cv::findHomography(matches.before, matches.now, cv::USAC_MAGSAC, 2 * alikePx);
    if (found.empty())
        return std::nullopt;
    Fit fit;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            fit.homography(row, column) = found.at<double>(row, column);
    std::vector<double> shifts;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double squares = 0;
    for (std::size_t i = 0; i < matches.before.size(); ++i) {
        const Eigen::Vector2d before(matches.before[i].x, matches.before[i].y),
            now(matches.now[i].x, matches.now[i].y), expected = moved(fit.homography, matches.before[i]);
        const double offPx = (now - expected).norm();
        fit.still += (now - before).norm() < closePx ? 1 : 0;
        fit.close += offPx < closePx ? 1 : 0;
        if (!(offPx < alikePx))
            continue;
        ++fit.alike;
        shifts.push_back((expected - before).norm());
        sum += before;
        squares += before.squaredNorm();
    }
    if (fit.alike < fewestAlike)
        return std::nullopt;
    const auto count = double(fit.alike);
    fit.spreadPx = std::sqrt(std::max(0.0, squares / count - (sum / count).squaredNorm()));
    fit.shiftPx = upperMedian(std::move(shifts));
    return fit;
}

/// Zoom and turn are by the slopes of the homography at the centre of the image.
ViewChange changeBy(const Fit &fit, bool isMirrored, const cv::Size &size, double scale)
{
    using Kind = ViewChange::Kind;
    const cv::Point2d centre(size.width / 2.0, size.height / 2.0);
    const Eigen::Vector2d at = moved(fit.homography, centre);
    Eigen::Matrix2d slopes;
    slopes.col(0) = moved(fit.homography, centre + cv::Point2d(1, 0)) - at;
    slopes.col(1) = moved(fit.homography, centre + cv::Point2d(0, 1)) - at;
    const double zoom = std::sqrt(std::abs(slopes.determinant())),
                 turnRad = std::atan2(slopes(1, 0) - slopes(0, 1), slopes(0, 0) + slopes(1, 1));
    const auto follow = double(fit.close), still = double(fit.still);
    const Kind other = std::abs(turnRad) > mostTurnRad       ? Kind::Turned
                       : std::abs(zoom - 1) > mostZoom       ? Kind::Zoomed
                       : fit.shiftPx > farthest * size.width ? Kind::Panned
                                                             : Kind::Same;
    Kind kind = Kind::Same;
    if (isMirrored)
        kind = Kind::Mirrored;
    else if (other != Kind::Same && follow > ofAnother * still)
        kind = other;
    else if (other == Kind::Same && fit.shiftPx > samePx && follow > clearlyMore * still)
        kind = Kind::Shifted;
    return {kind, fit.shiftPx / scale, zoom, turnRad};
}

cv::Mat grey(const PlaneView &luma, double scale)
{
    cv::Mat image(luma.height, luma.width, CV_8UC1, const_cast<std::uint8_t *>(luma.data),
                  std::size_t(luma.stride));
    if (scale < 1)
        cv::resize(image, image, {}, scale, scale, cv::INTER_AREA);
    return image;
}

std::optional<ViewChange> changeBetween(const PlaneView &before, const PlaneView &now)
{
    const double scale = std::min(1.0, double(widestPx) / std::max(before.width, before.height));
    const cv::Mat earlier = grey(before, scale), later = grey(now, scale);
    const Points pointsBefore = pointsOf(earlier);
    bool isMirrored = false;
    auto fit = fitted(matched(pointsBefore, pointsOf(later)));
    if (!fit) {
        cv::Mat mirrored;
        cv::flip(later, mirrored, 1);
        fit = fitted(matched(pointsBefore, pointsOf(mirrored)));
        isMirrored = true;
    }
    if (!fit || fit->spreadPx < leastSpread * earlier.cols)
        return std::nullopt;
    return changeBy(*fit, isMirrored, earlier.size(), scale);
}

} // namespace

std::optional<ViewChange> changeOfView(const PlaneView &before, const PlaneView &now)
{
    if (before.width != now.width || before.height != now.height || before.width <= 0 || before.height <= 0)
        return std::nullopt;
    try {
        return changeBetween(before, now);
    } catch (const cv::Exception &) { // images as narrow as a line, or too little memory
        return std::nullopt;
    }
}

} // namespace odo
