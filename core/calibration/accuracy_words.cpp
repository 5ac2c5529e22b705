// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/accuracy_words.h"

#include "core/base/units.h"
#include "core/calibration/wording.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace odo {

namespace {

using Eigen::Vector2d;

constexpr double nearABorder = 0.15; // of the extent

std::string whereOf(const Vector2d &place, const Vector2d &lower, const Vector2d &upper, const MarkerLayout &layout)
{
    const auto nearest = std::ranges::min_element(
        layout.markers, {}, [&](const Marker &marker) { return (marker.pointInWorld - place).norm(); });
    const auto isAtBorder = [&](int axis) {
        const double room = nearABorder * (upper[axis] - lower[axis]);
        return place[axis] < lower[axis] + room || place[axis] > upper[axis] - room;
    };
    const int borders = int(isAtBorder(0)) + int(isAtBorder(1));
    return std::string(borders == 2 ? "in the corner near " : borders == 1 ? "at the edge near " : "near ") + nearest->label;
}

} // namespace

AccuracySummary summariseAccuracy(const FloorGrid &grid, const std::vector<double> &sigmaM, const MarkerLayout &layout)
{
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    AccuracySummary summary{unseen, unseen, 0, "None of the floor among the markers is seen."};
    if (layout.markers.empty())
        return summary;
    Vector2d lower = layout.markers.front().pointInWorld, upper = lower, worst = lower;
    for (const Marker &marker : layout.markers) {
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    const Vector2d middle = 0.5 * (lower + upper), slack = Vector2d::Constant(0.5 * grid.stepM);
    double fromMiddle = std::numeric_limits<double>::infinity();
    int places = 0, seen = 0;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d place = grid.at(column, row);
            if (((place - lower).array() < -slack.array()).any() || ((place - upper).array() > slack.array()).any())
                continue;
            const double sigma = sigmaM[grid.index(column, row)];
            ++places;
            if ((place - middle).norm() < fromMiddle) {
                fromMiddle = (place - middle).norm();
                summary.middleM = sigma;
            }
            if (std::isnan(sigma))
                continue;
            ++seen;
            if (!(sigma <= summary.worstM)) {
                summary.worstM = sigma;
                worst = place;
            }
        }
    }
    if (seen == 0)
        return summary;
    summary.seenPart = double(seen) / places;
    summary.words = std::isnan(summary.middleM) ? "The middle is not seen" : std::string("±") + millimetres(summary.middleM) + " in the middle";
    summary.words += std::string(", ±") + millimetres(summary.worstM) + " " + whereOf(worst, lower, upper, layout) + ".";
    if (seen < places)
        summary.words += ' ' + formatNumber(std::max(1.0, 100 * (1 - summary.seenPart)), 0) + " % of the floor among the markers is not seen.";
    return summary;
}

} // namespace odo
