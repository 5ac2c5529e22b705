// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_placement.h"

#include "core/geometry/homography.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double fullSlopeDegrees = 45;
constexpr double degreesPerRadian = 180 / EIGEN_PI;

double areaOf(const std::array<Vector2d, 4> &outline)
{
    double twice = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vector2d &a = outline[i], &b = outline[(i + 1) % 4];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * std::abs(twice);
}

/// 0 to 1 over the way that the middle of something of this size can go.
double along(double middle, double size, double room)
{
    const double border = std::min(size, 0.9 * room);
    return std::clamp((middle - 0.5 * border) / (room - border), 0.0, 1.0);
}

/// By the derivative of the homography at the board's middle (how it foreshortens) and the change of depth across it
/// (which way it leans): depth is proportional to the third coordinate.
Vector2d slopeAt(const Eigen::Matrix3d &pixelFromBoard, const Vector2d &middle)
{
    const Vector3d image = pixelFromBoard * middle.homogeneous();
    const double w = image.z();
    const Vector2d depthByBoard(pixelFromBoard(2, 0) / w, pixelFromBoard(2, 1) / w);
    Matrix2d pixelByBoard;
    for (int column = 0; column < 2; ++column)
        pixelByBoard.col(column) =
            (pixelFromBoard.col(column).head<2>() - image.head<2>() / w * pixelFromBoard(2, column)) / w;
    const Eigen::JacobiSVD<Matrix2d> svd(pixelByBoard, Eigen::ComputeFullU);
    const Vector2d &scales = svd.singularValues();
    if (!(scales.y() > 0))
        return Vector2d::Zero();
    const double angle = std::acos(std::clamp(scales.y() / scales.x(), 0.0, 1.0)) * degreesPerRadian / fullSlopeDegrees;
    // The picture is shortened along the slope; depth tells its sign.
    const Vector2d axis = svd.matrixU().col(1);
    const Vector2d depthByPixel = pixelByBoard.transpose().inverse() * depthByBoard;
    return angle * (axis.dot(depthByPixel) < 0 ? Vector2d(-axis) : axis);
}

} // namespace

double BoardPlacement::angleDegrees() const { return fullSlopeDegrees * skew(); }

std::optional<BoardPlacement> placementOf(const BoardView &view, int widthPx, int heightPx)
{
    std::vector<PointPair> pairs;
    Vector2d least = Vector2d::Constant(HUGE_VAL), most = -least;
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
        least = least.cwiseMin(view.pointsOnBoard[i]);
        most = most.cwiseMax(view.pointsOnBoard[i]);
    }
    const auto pixelFromBoard = Homography::estimate(pairs);
    if (!pixelFromBoard)
        return std::nullopt;
    BoardPlacement placement;
    const Vector2d corners[] = {least, {most.x(), least.y()}, most, {least.x(), most.y()}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto pixel = pixelFromBoard->map(corners[i]);
        if (!pixel)
            return std::nullopt;
        placement.outline[i] = *pixel;
    }
    const Vector2d middle = 0.5 * (least + most);
    const auto centre = pixelFromBoard->map(middle);
    const double area = areaOf(placement.outline), room = static_cast<double>(widthPx) * heightPx;
    placement.size = std::sqrt(std::min(1.0, area / room));
    placement.place = {along(centre->x(), std::sqrt(area), widthPx), along(centre->y(), std::sqrt(area), heightPx)};
    placement.slope = slopeAt(pixelFromBoard->matrix(), middle);
    return placement;
}

double distanceOf(const BoardPlacement &one, const BoardPlacement &other)
{
    return (one.place - other.place).lpNorm<1>() + std::abs(one.size - other.size) + (one.slope - other.slope).norm();
}

} // namespace odo
