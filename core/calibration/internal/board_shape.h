// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace odo {

/// How a print differs from the board of equal squares on a plane that it is meant to be, the same in every
/// image. About the board's middle, with u and v the distances from it along its two sides over its extent:
/// the point (x, y) is at (x + skew·(y − y₀), y + stretch·(y − y₀), extent·(a u² + b u v + c v²)). The first
/// side sets the scale, for no image of a print alone says how large it is. Metres.
struct BoardShape
{
    enum Value { Stretch, Skew, BendAlong, BendAcross, BendTwist };
    static constexpr int size = 5;

    Eigen::Vector2d middleM{0, 0};
    double extentM = 1; ///< the longer side
    /// Stretch and skew are shares of a length; the bends are a, c and b, shares of the extent.
    std::array<double, size> values{};

    Eigen::Vector3d at(const Eigen::Vector2d &point) const { return at(point, values.data()); }
    Eigen::Vector3d at(const Eigen::Vector2d &point, const double *value) const
    {
        const Eigen::Vector2d from = point - middleM;
        return {point.x() + value[Skew] * from.y(), point.y() + value[Stretch] * from.y(),
                extentM * bends(from).dot(Eigen::Map<const Eigen::Vector3d>(value + BendAlong))};
    }
    /// How a point of the print moves with the values.
    Eigen::Matrix<double, 3, size> derivative(const Eigen::Vector2d &point) const
    {
        const Eigen::Vector2d from = point - middleM;
        Eigen::Matrix<double, 3, size> by = Eigen::Matrix<double, 3, size>::Zero();
        by(1, Stretch) = by(0, Skew) = from.y();
        by.row(2).tail<3>() = extentM * bends(from).transpose();
        return by;
    }
    /// How far the print bulges over a side of its extent (a sagitta), along the more bent one.
    double bulgeM() const
    {
        return extentM * std::max(std::abs(values[BendAlong]), std::abs(values[BendAcross])) / 4;
    }

private:
    /// Of a, c and b.
    Eigen::Vector3d bends(const Eigen::Vector2d &from) const
    {
        const Eigen::Vector2d part = from / extentM;
        return {part.x() * part.x(), part.y() * part.y(), part.x() * part.y()};
    }
};

} // namespace odo
