// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board_placement.h"

#include "core/geometry/camera_model.h"
#include "core/geometry/homography.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace odo {

namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double fullSlopeDegrees = BoardPlacement::fullSlopeDegrees;
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

/// 0 to 1 over the range in which the middle of something of this size can be.
double along(double middle, double size, double room)
{
    const double border = std::min(size, 0.9 * room);
    return std::clamp((middle - 0.5 * border) / (room - border), 0.0, 1.0);
}

/// By the derivative of the homography at the board's middle (how it foreshortens) and the change of depth
/// across it (which way it leans): depth is proportional to the third coordinate.
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
    const double angle =
        std::acos(std::clamp(scales.y() / scales.x(), 0.0, 1.0)) * degreesPerRadian / fullSlopeDegrees;
    // The image is shortened along the slope; depth gives its sign.
    const Vector2d axis = svd.matrixU().col(1);
    const Vector2d depthByPixel = pixelByBoard.transpose().inverse() * depthByBoard;
    return angle * (axis.dot(depthByPixel) < 0 ? Vector2d(-axis) : axis);
}

/// A board's extent and its map to the image.
struct MappedBoard
{
    Vector2d least, most;
    Homography pixelFromBoard;

    Vector2d middle() const { return 0.5 * (least + most); }
};

std::optional<MappedBoard> mapped(const BoardView &view)
{
    std::vector<PointPair> pairs;
    Vector2d least = Vector2d::Constant(HUGE_VAL), most = -least;
    for (std::size_t i = 0; i < view.pixels.size(); ++i) {
        pairs.push_back({view.pointsOnBoard[i], view.pixels[i], {}});
        least = least.cwiseMin(view.pointsOnBoard[i]);
        most = most.cwiseMax(view.pointsOnBoard[i]);
    }
    const auto pixelFromBoard = Homography::estimate(pairs);
    return pixelFromBoard ? std::optional(MappedBoard{least, most, *pixelFromBoard}) : std::nullopt;
}

} // namespace

double BoardPlacement::angleDegrees() const
{
    return fullSlopeDegrees * skew();
}

std::optional<Eigen::Vector2d> slopeOf(const BoardView &view)
{
    const auto board = mapped(view);
    return board ? std::optional(slopeAt(board->pixelFromBoard.matrix(), board->middle())) : std::nullopt;
}

std::optional<BoardPlacement> placementOf(const BoardView &view, int widthPx, int heightPx)
{
    const auto board = mapped(view);
    if (!board)
        return std::nullopt;
    const Vector2d &least = board->least, &most = board->most;
    BoardPlacement placement;
    const Vector2d corners[] = {least, {most.x(), least.y()}, most, {least.x(), most.y()}};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto pixel = board->pixelFromBoard.map(corners[i]);
        if (!pixel)
            return std::nullopt;
        placement.outline[i] = *pixel;
    }
    const auto centre = board->pixelFromBoard.map(board->middle());
    const double area = areaOf(placement.outline), room = static_cast<double>(widthPx) * heightPx;
    placement.size = std::sqrt(std::min(1.0, area / room));
    placement.position = {along(centre->x(), std::sqrt(area), widthPx),
                          along(centre->y(), std::sqrt(area), heightPx)};
    placement.slope = slopeAt(board->pixelFromBoard.matrix(), board->middle());
    return placement;
}

double distanceOf(const BoardPlacement &one, const BoardPlacement &other)
{
    return (one.position - other.position).lpNorm<1>() + std::abs(one.size - other.size) +
           (one.slope - other.slope).norm();
}

namespace {

constexpr double wantedPosition = 0.7, wantedSize = 0.4, wantedSlope = 0.5;
constexpr int wantedImages = 10, manyImages = 40;
constexpr double wantedPart = 0.5;

double part(double value, double wanted)
{
    return std::clamp(value / wanted, 0.0, 1.0);
}

/// How far the slopes spread: the largest difference of two. One tilt against a frontal image is half of it.
double spreadOfSlopes(const std::vector<BoardPlacement> &placements)
{
    double widest = 0;
    for (const BoardPlacement &one : placements) {
        widest = std::max(widest, 0.5 * one.skew());
        for (const BoardPlacement &other : placements)
            widest = std::max(widest, 0.5 * (one.slope - other.slope).norm());
    }
    return widest;
}

} // namespace

double BoardCoverage::coveredPart() const
{
    const auto covered = std::ranges::count_if(corners, [](int count) { return count > 0; });
    return static_cast<double>(covered) / static_cast<double>(corners.size());
}

bool BoardCoverage::isEnough() const
{
    const bool full = x >= 1 && y >= 1 && size >= 1 && skew >= 1 && coveredPart() >= wantedPart;
    return (full && images >= wantedImages) || images >= manyImages;
}

BoardCoverage coverageOf(const std::vector<BoardView> &views, const std::vector<BoardPlacement> &placements,
                         int widthPx, int heightPx)
{
    BoardCoverage coverage;
    coverage.images = static_cast<int>(views.size());
    for (const BoardView &view : views) {
        for (const Eigen::Vector2d &pixel : view.pixels) {
            const int x = std::clamp(static_cast<int>(pixel.x() * BoardCoverage::across / widthPx), 0,
                                     BoardCoverage::across - 1);
            const int y = std::clamp(static_cast<int>(pixel.y() * BoardCoverage::down / heightPx), 0,
                                     BoardCoverage::down - 1);
            ++coverage.corners[static_cast<std::size_t>(y * BoardCoverage::across + x)];
        }
    }
    if (placements.empty())
        return coverage;
    Eigen::Vector2d least = placements.front().position, most = least;
    double largest = 0;
    for (const BoardPlacement &placement : placements) {
        least = least.cwiseMin(placement.position);
        most = most.cwiseMax(placement.position);
        largest = std::max(largest, placement.size);
    }
    coverage.x = part((most - least).x(), wantedPosition);
    coverage.y = part((most - least).y(), wantedPosition);
    coverage.size = part(largest, wantedSize);
    coverage.skew = part(spreadOfSlopes(placements), wantedSlope);
    return coverage;
}

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double tiltRadians = 35 * EIGEN_PI / 180;
constexpr double closeEnough = 0.12;

struct Candidate
{
    Vector2d position; ///< of the middle, −1 to 1 of what is free
    double size;       ///< of the image's height or width, whichever is tighter
    Vector2d towards;  ///< the side that leans away
};

/// The plainest first.
std::vector<Candidate> candidates()
{
    const Vector2d none(0, 0), left(-1, 0), right(1, 0), up(0, -1), down(0, 1);
    std::vector<Candidate> all{{{0, 0}, 0.75, none},
                               {{0, 0}, 0.65, left},
                               {{0, 0}, 0.65, right},
                               {{0, 0}, 0.65, up},
                               {{0, 0}, 0.65, down}};
    for (const Vector2d &corner : {Vector2d(-1, -1), Vector2d(1, -1), Vector2d(1, 1), Vector2d(-1, 1)}) {
        all.push_back({corner, 0.4, none});
        all.push_back({corner, 0.4, {corner.x(), 0}});
        all.push_back({corner, 0.4, {0, -corner.y()}});
    }
    for (const Vector2d &side : {left, right, up, down})
        all.push_back({side, 0.5, Vector2d(-side)});
    all.push_back({none, 0.3, none});
    all.push_back({none, 0.85, left});
    all.push_back({none, 0.85, down});
    return all;
}

/// The board projected with ordinary intrinsics, moved to its position.
std::optional<BoardPlacement> placed(const Candidate &candidate, int columns, int rows, int widthPx,
                                     int heightPx)
{
    const CameraModel camera = CameraModel::assumed(widthPx, heightPx);
    const double halfWidth = 0.5 * (columns - 1), halfHeight = 0.5 * (rows - 1);
    const double focal = camera.intrinsics().fxPx;
    const double depth =
        focal / candidate.size * std::max(2 * halfWidth / widthPx, 2 * halfHeight / heightPx);
    // Away on the right is a turn about the vertical axis that takes +x to +z.
    const Eigen::Quaterniond turn =
        Eigen::AngleAxisd(-candidate.towards.x() * tiltRadians, Vector3d::UnitY()) *
        Eigen::AngleAxisd(candidate.towards.y() * tiltRadians, Vector3d::UnitX());
    BoardView view{{}, columns, rows, {}, {}};
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            const Vector2d point((2 * x - 1) * halfWidth, (2 * y - 1) * halfHeight);
            const auto pixel =
                camera.project(turn * Vector3d(point.x(), point.y(), 0) + Vector3d(0, 0, depth));
            if (!pixel)
                return std::nullopt;
            view.pixels.push_back(*pixel);
            view.pointsOnBoard.push_back(point);
        }
    }
    Vector2d least = view.pixels[0], most = least;
    for (const Vector2d &pixel : view.pixels) {
        least = least.cwiseMin(pixel);
        most = most.cwiseMax(pixel);
    }
    const Vector2d image(widthPx, heightPx), extent = most - least;
    // Outside the inner corners lies a row of squares, and a little white.
    const Vector2d margin(1.2 * extent.x() / (columns - 1), 1.2 * extent.y() / (rows - 1));
    // A tilted board's near side may leave the image: then hold it a little farther away.
    const Vector2d free = image - 2 * margin;
    const double scale = std::min({1.0, free.x() / extent.x(), free.y() / extent.y()});
    const Vector2d room = 0.5 * (free - scale * extent);
    const Vector2d middle = 0.5 * image + candidate.position.cwiseProduct(room);
    for (Vector2d &pixel : view.pixels)
        pixel = middle + scale * (pixel - 0.5 * (least + most));
    return placementOf(view, widthPx, heightPx);
}

} // namespace

WantedPose wantedPose(const std::vector<BoardPlacement> &taken, int columns, int rows, int widthPx,
                      int heightPx)
{
    WantedPose best;
    double farthest = -1;
    for (const Candidate &candidate : candidates()) {
        const auto placement = placed(candidate, columns, rows, widthPx, heightPx);
        if (!placement)
            continue;
        double nearest = taken.empty() ? 0 : std::numeric_limits<double>::infinity();
        for (const BoardPlacement &there : taken)
            nearest = std::min(nearest, distanceOf(*placement, there));
        if (nearest > farthest + 1e-9) {
            farthest = nearest;
            best.placement = *placement;
        }
    }
    return best;
}

BoardHint hintTowards(const WantedPose &wanted, const BoardPlacement &now)
{
    const Vector2d position = wanted.placement.position - now.position,
                   slope = wanted.placement.slope - now.slope;
    const double size = wanted.placement.size - now.size;
    struct Step
    {
        double amount;
        BoardHint less, more;
    };
    // A wrong position hides the slope, so it counts twice.
    const std::array<Step, 5> steps{{{2 * position.x(), BoardHint::Left, BoardHint::Right},
                                     {2 * position.y(), BoardHint::Up, BoardHint::Down},
                                     {2 * size, BoardHint::Farther, BoardHint::Closer},
                                     {slope.x(), BoardHint::TiltLeft, BoardHint::TiltRight},
                                     {slope.y(), BoardHint::TiltUp, BoardHint::TiltDown}}};
    const Step *largest = &steps.front();
    for (const Step &step : steps)
        if (std::abs(step.amount) > std::abs(largest->amount))
            largest = &step;
    if (std::abs(largest->amount) < 2 * closeEnough)
        return BoardHint::HoldStill;
    return largest->amount < 0 ? largest->less : largest->more;
}

} // namespace odo
