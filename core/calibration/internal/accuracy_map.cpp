// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/accuracy_map.h"

#include "core/calibration/internal/planned_registration.h"
#include "core/calibration/internal/wording.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

std::optional<Matrix2d> covarianceAt(const FloorView &view, const Vector3d &position, double sigmaPx)
{
    const auto pixel = view.pixelFromWorld(position);
    if (!pixel || !isWithin(*pixel, view.camera().intrinsics()))
        return std::nullopt;
    const auto seen = view.locate(*pixel, sigmaPx * sigmaPx * Matrix2d::Identity(), position.z());
    if (!seen)
        return std::nullopt;
    return seen->pixelCovariance + seen->calibrationCovariance;
}

double largestSigma(const Matrix2d &covariance)
{
    return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Matrix2d>(covariance).eigenvalues().y()));
}

} // namespace

FloorGrid gridOver(const MarkerLayout &layout, double marginM, int mostAcross)
{
    if (layout.markers.empty() || mostAcross < 2)
        return {};
    Vector2d lower = layout.markers.front().pointInWorld, upper = lower;
    for (const Marker &marker : layout.markers) {
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    const Vector2d margin = Vector2d::Constant(marginM), size = upper - lower + 2 * margin;
    FloorGrid grid;
    grid.lowerM = lower - margin;
    grid.stepM = std::max(size.maxCoeff() / (mostAcross - 1), 1e-3);
    grid.columns = 1 + static_cast<int>(std::floor(size.x() / grid.stepM + 1e-9));
    grid.rows = 1 + static_cast<int>(std::floor(size.y() / grid.stepM + 1e-9));
    return grid;
}

AccuracyMap accuracyMap(std::span<const FloorView> views, const FloorGrid &grid, double sigmaPx,
                        double heightM)
{
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    const std::size_t positions = static_cast<std::size_t>(std::max(0, grid.columns)) *
                                  static_cast<std::size_t>(std::max(0, grid.rows));
    AccuracyMap map{grid,
                    std::vector<std::vector<double>>(views.size(), std::vector<double>(positions, unseen)),
                    std::vector<double>(positions, unseen)};
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d point = grid.at(column, row);
            Matrix2d information = Matrix2d::Zero();
            for (std::size_t i = 0; i < views.size(); ++i) {
                const auto covariance = covarianceAt(views[i], {point.x(), point.y(), heightM}, sigmaPx);
                if (!covariance)
                    continue;
                map.cameraSigmaM[i][grid.index(column, row)] = largestSigma(*covariance);
                information += covariance->inverse();
            }
            if (information.determinant() > 0)
                map.fusedSigmaM[grid.index(column, row)] = largestSigma(information.inverse());
        }
    }
    return map;
}

namespace {

constexpr double nearABorder = 0.15; // of the extent

/// The sentence about the values. position: of the worst one.
Message metricWords(const AccuracySummary &summary, const Vector2d &position, const Vector2d &lower,
                    const Vector2d &upper, const MarkerLayout &layout)
{
    const auto nearest = std::ranges::min_element(
        layout.markers, {}, [&](const Marker &marker) { return (marker.pointInWorld - position).norm(); });
    const auto isAtBorder = [&](int axis) {
        const double room = nearABorder * (upper[axis] - lower[axis]);
        return position[axis] < lower[axis] + room || position[axis] > upper[axis] - room;
    };
    const int borders = int(isAtBorder(0)) + int(isAtBorder(1));
    const MessageArgument worst = millimetres(summary.worstM), marker = Named::marker(nearest->label);
    if (std::isnan(summary.middleM)) {
        const MessageText &words =
            borders == 2 ? ODO_TEXT("calibration.unseen_middle_corner",
                                    "The middle is out of view, ±%1 in the corner near %2.")
            : borders == 1
                ? ODO_TEXT("calibration.unseen_middle_edge",
                           "The middle is out of view, ±%1 at the edge near %2.")
                : ODO_TEXT("calibration.unseen_middle_near", "The middle is out of view, ±%1 near %2.");
        return words(worst, marker);
    }
    const MessageText &words =
        borders == 2
            ? ODO_TEXT("calibration.middle_and_corner", "±%1 in the middle, ±%2 in the corner near %3.")
        : borders == 1
            ? ODO_TEXT("calibration.middle_and_edge", "±%1 in the middle, ±%2 at the edge near %3.")
            : ODO_TEXT("calibration.middle_and_near", "±%1 in the middle, ±%2 near %3.");
    return words(millimetres(summary.middleM), worst, marker);
}

} // namespace

AccuracySummary summariseAccuracy(const FloorGrid &grid, const std::vector<double> &sigmaM,
                                  const MarkerLayout &layout)
{
    constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
    AccuracySummary summary{
        unseen, unseen, 0,
        ODO_TEXT("calibration.floor_unseen", "None of the floor between the markers is in view.")};
    if (layout.markers.empty())
        return summary;
    Vector2d lower = layout.markers.front().pointInWorld, upper = lower, worst = lower;
    for (const Marker &marker : layout.markers) {
        lower = lower.cwiseMin(marker.pointInWorld);
        upper = upper.cwiseMax(marker.pointInWorld);
    }
    const Vector2d middle = 0.5 * (lower + upper), slack = Vector2d::Constant(0.5 * grid.stepM);
    double fromMiddle = std::numeric_limits<double>::infinity();
    int positions = 0, seen = 0;
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d position = grid.at(column, row);
            if (((position - lower).array() < -slack.array()).any() ||
                ((position - upper).array() > slack.array()).any())
                continue;
            const double sigma = sigmaM[grid.index(column, row)];
            ++positions;
            if ((position - middle).norm() < fromMiddle) {
                fromMiddle = (position - middle).norm();
                summary.middleM = sigma;
            }
            if (std::isnan(sigma))
                continue;
            ++seen;
            if (!(sigma <= summary.worstM)) {
                summary.worstM = sigma;
                worst = position;
            }
        }
    }
    if (seen == 0)
        return summary;
    summary.seenPart = double(seen) / positions;
    summary.words = metricWords(summary, worst, lower, upper, layout);
    if (seen < positions)
        summary.words = joined(
            {std::move(summary.words),
             ODO_TEXT("calibration.floor_part_unseen", "%1 of the floor between the markers is out of view.")(
                 quantity(std::max(1.0, 100 * (1 - summary.seenPart)), 0, "%"))},
            Join::Space);
    return summary;
}

} // namespace odo
