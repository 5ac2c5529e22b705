// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/saddle_points.h"

#include "core/base/cancel_scope.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace odo {

namespace {

constexpr int ringSamples = 32;
constexpr float ringRadius = 5;
constexpr float leastSaddleContrast = 12; // grey levels between the fields
constexpr std::size_t mostPoints = 3000; // a picture of gravel has no end of them
constexpr float twoPi = 2 * std::numbers::pi_v<float>;

/// Angles where the ring crosses its middle grey, if there are exactly four that lie opposite one another.
std::optional<std::array<float, 4>> crossings(const std::array<float, ringSamples> &ring)
{
    const auto [low, high] = std::ranges::minmax(ring);
    if (high - low < leastSaddleContrast)
        return std::nullopt;
    const float middle = 0.5F * (low + high);
    std::array<float, 4> angles{};
    std::size_t count = 0;
    for (int i = 0; i < ringSamples; ++i) {
        const float here = ring[static_cast<std::size_t>(i)] - middle;
        const float next = ring[static_cast<std::size_t>((i + 1) % ringSamples)] - middle;
        if ((here > 0) == (next > 0))
            continue;
        if (count == 4)
            return std::nullopt;
        angles[count++] = (static_cast<float>(i) + here / (here - next)) * twoPi / ringSamples;
    }
    if (count != 4)
        return std::nullopt;
    constexpr float mostBend = 0.7F, leastField = 0.35F; // radians
    for (std::size_t i = 0; i < 2; ++i) {
        if (std::abs(angles[i + 2] - angles[i] - twoPi / 2) > mostBend)
            return std::nullopt;
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const float field = i < 3 ? angles[i + 1] - angles[i] : angles[0] + twoPi - angles[3];
        if (field < leastField)
            return std::nullopt;
    }
    return angles;
}

std::optional<SaddlePoint> describe(const cv::Mat &smoothed, cv::Point2f position)
{
    std::array<float, ringSamples> ring{};
    for (int i = 0; i < ringSamples; ++i) {
        const float angle = static_cast<float>(i) * twoPi / ringSamples;
        ring[static_cast<std::size_t>(i)] =
            greyAt(smoothed, position + ringRadius * cv::Point2f(std::cos(angle), std::sin(angle)));
    }
    const auto angles = crossings(ring);
    if (!angles)
        return std::nullopt;
    SaddlePoint point{position, {}};
    for (std::size_t i = 0; i < 2; ++i) {
        const float angle = 0.5F * ((*angles)[i] + (*angles)[i + 2] - twoPi / 2);
        point.edges[i] = {std::cos(angle), std::sin(angle)};
    }
    return point;
}

constexpr float leastStrength = 100;
constexpr int peakReach = 3; // pixels either side in which a peak is the highest

using Peak = std::pair<float, cv::Point2f>;

/// The negative determinant of the Hessian: large where the grey surface is a saddle.
cv::Mat saddleStrength(const cv::Mat &smoothed)
{
    cv::Mat xx, yy, xy, strength;
    cv::Sobel(smoothed, xx, CV_32F, 2, 0);
    cv::Sobel(smoothed, yy, CV_32F, 0, 2);
    cv::Sobel(smoothed, xy, CV_32F, 1, 1);
    strength = xy.mul(xy) - xx.mul(yy);
    return strength;
}

/// Peaks of the strength in some rows of the picture; `strongest` is raised to the strength there.
void addPeaks(const cv::Mat &smoothed, cv::Range rows, std::vector<Peak> &peaks, double &strongest)
{
    const cv::Range wider(std::max(rows.start - peakReach, 0), std::min(rows.end + peakReach, smoothed.rows));
    const cv::Mat strength = saddleStrength(smoothed.rowRange(wider));
    cv::Mat highest;
    cv::dilate(strength, highest, cv::Mat::ones(2 * peakReach + 1, 2 * peakReach + 1, CV_8U));
    double most = 0;
    cv::minMaxLoc(strength, nullptr, &most);
    strongest = std::max(strongest, most);
    for (int y = std::max(rows.start, 2); y < std::min(rows.end, smoothed.rows - 2); ++y) {
        const auto *row = strength.ptr<float>(y - wider.start);
        const auto *top = highest.ptr<float>(y - wider.start);
        for (int x = 2; x < strength.cols - 2; ++x) {
            if (row[x] >= leastStrength && row[x] == top[x])
                peaks.emplace_back(row[x], cv::Point2f(static_cast<float>(x), static_cast<float>(y)));
        }
    }
}

} // namespace

float greyAt(const cv::Mat &picture, cv::Point2f position)
{
    const float x = std::clamp(position.x, 0.0F, static_cast<float>(picture.cols - 1));
    const float y = std::clamp(position.y, 0.0F, static_cast<float>(picture.rows - 1));
    const int column = std::min(static_cast<int>(x), picture.cols - 2);
    const int row = std::min(static_cast<int>(y), picture.rows - 2);
    const float right = x - static_cast<float>(column), down = y - static_cast<float>(row);
    const auto *upper = picture.ptr<std::uint8_t>(row) + column;
    const auto *lower = picture.ptr<std::uint8_t>(row + 1) + column;
    const float above = upper[0] + right * static_cast<float>(upper[1] - upper[0]);
    const float below = lower[0] + right * static_cast<float>(lower[1] - lower[0]);
    return above + down * (below - above);
}

std::vector<SaddlePoint> findSaddlePoints(const cv::Mat &smoothed)
{
    constexpr int band = 256; // rows at a time: their numbers of 32 bits take many times the memory of the picture
    double strongest = 0;
    std::vector<Peak> peaks;
    for (int y = 0; y < smoothed.rows; y += band) {
        endIfCancelled();
        addPeaks(smoothed, {y, std::min(y + band, smoothed.rows)}, peaks, strongest);
    }
    const auto least = static_cast<float>(0.005 * strongest);
    std::erase_if(peaks, [&](const Peak &peak) { return peak.first < least; });
    std::ranges::sort(peaks, std::greater<>(), &Peak::first);
    if (peaks.size() > mostPoints)
        peaks.resize(mostPoints);
    std::vector<SaddlePoint> points;
    for (const auto &peak : peaks) {
        if (const auto point = describe(smoothed, peak.second))
            points.push_back(*point);
    }
    return points;
}

} // namespace odo
