// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/internal/triangulated_squares.h"

#include "core/calibration/internal/lens_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A corner in both images, and in space by camera A's axes.
struct TriangulatedCorner
{
    Vector2d onBoard;
    Vector3d inA;
};

std::optional<Vector3d> triangulated(const Vector2d &pixelA, const Vector2d &pixelB, Vector3d point,
                                     const CameraModel &a, const CameraModel &b, const RigidTransform &bFromA)
{
    const Eigen::Matrix3d turn = bFromA.rotation.toRotationMatrix();
    for (int round = 0; round < 8; ++round) {
        Eigen::Matrix<double, 2, 3> byPointA, byPointB;
        const auto seenA = a.project(point, byPointA), seenB = b.project(bFromA * point, byPointB);
        if (!seenA || !seenB)
            return std::nullopt;
        Eigen::Matrix<double, 4, 3> byPoint;
        byPoint << byPointA, byPointB * turn;
        Eigen::Vector4d off;
        off << *seenA - pixelA, *seenB - pixelB;
        const Vector3d step = -(byPoint.transpose() * byPoint).ldlt().solve(byPoint.transpose() * off);
        if (!step.allFinite())
            return std::nullopt;
        point += step;
        if (step.norm() < 1e-9)
            break;
    }
    return point;
}

std::vector<TriangulatedCorner> triangulatedCorners(const PairedBoards &pair,
                                                    const RigidTransform &aFromBoard, const CameraModel &a,
                                                    const CameraModel &b, const RigidTransform &bFromA,
                                                    double squareM)
{
    std::vector<TriangulatedCorner> corners;
    for (std::size_t i = 0; i < pair.a.pixels.size(); ++i) {
        const Vector2d &onBoard = pair.a.pointsOnBoard[i];
        for (std::size_t j = 0; j < pair.b.pixels.size(); ++j) {
            if ((pair.b.pointsOnBoard[j] - onBoard).norm() > 0.1 * squareM)
                continue;
            const auto inA = triangulated(pair.a.pixels[i], pair.b.pixels[j],
                                          aFromBoard * Vector3d(onBoard.x(), onBoard.y(), 0), a, b, bFromA);
            if (inA)
                corners.push_back({onBoard, *inA});
            break;
        }
    }
    return corners;
}

} // namespace

TriangulatedSquares triangulatedSquares(std::span<const PairedBoards> pairs, const CameraModel &a,
                                        const CameraModel &b, const PairFit &fit)
{
    std::vector<double> sides;
    for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
        const double squareM = squareSideM(pairs[pair].a);
        const auto corners =
            triangulatedCorners(pairs[pair], fit.aFromBoard[pair], a, b, fit.bFromA, squareM);
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (std::abs((corners[i].onBoard - corners[j].onBoard).norm() - squareM) < 0.1 * squareM)
                    sides.push_back((corners[i].inA - corners[j].inA).norm());
    }
    TriangulatedSquares squares;
    squares.count = sides.size();
    for (const double side : sides)
        squares.meanM += side / double(sides.size());
    for (const double side : sides)
        squares.sdM += std::pow(side - squares.meanM, 2);
    squares.sdM = sides.size() > 1 ? std::sqrt(squares.sdM / double(sides.size() - 1)) : 0;
    return squares;
}

} // namespace odo
