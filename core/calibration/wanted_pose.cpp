// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/wanted_pose.h"

#include "core/geometry/camera_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace odo {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double tiltRadians = 35 * EIGEN_PI / 180;
constexpr double closeEnough = 0.12;

struct Candidate
{
    Vector2d place;  ///< of the middle, −1 to 1 of what is free
    double size;     ///< of the picture's height or width, whichever is tighter
    Vector2d towards; ///< the side that leans away
};

/// The plainest first.
std::vector<Candidate> candidates()
{
    const Vector2d none(0, 0), left(-1, 0), right(1, 0), up(0, -1), down(0, 1);
    std::vector<Candidate> all{{{0, 0}, 0.75, none}, {{0, 0}, 0.65, left}, {{0, 0}, 0.65, right},
                               {{0, 0}, 0.65, up},   {{0, 0}, 0.65, down}};
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

/// The board's picture through a lens of ordinary width, moved to its place.
std::optional<BoardPlacement> placed(const Candidate &candidate, int columns, int rows, int widthPx, int heightPx)
{
    const CameraModel camera = CameraModel::assumed(widthPx, heightPx);
    const double halfWidth = 0.5 * (columns - 1), halfHeight = 0.5 * (rows - 1);
    const double focal = camera.intrinsics().fxPx;
    const double depth = focal / candidate.size * std::max(2 * halfWidth / widthPx, 2 * halfHeight / heightPx);
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
    const Vector2d picture(widthPx, heightPx), extent = most - least;
    // Outside the inner corners lies a row of squares, and a little white.
    const Vector2d margin(1.2 * extent.x() / (columns - 1), 1.2 * extent.y() / (rows - 1));
    // A tilted board's near side may reach out of the picture: then it is held a little farther away.
    const Vector2d free = picture - 2 * margin;
    const double scale = std::min({1.0, free.x() / extent.x(), free.y() / extent.y()});
    const Vector2d room = 0.5 * (free - scale * extent);
    const Vector2d middle = 0.5 * picture + candidate.place.cwiseProduct(room);
    for (Vector2d &pixel : view.pixels)
        pixel = middle + scale * (pixel - 0.5 * (least + most));
    return placementOf(view, widthPx, heightPx);
}

} // namespace

WantedPose wantedPose(const std::vector<BoardPlacement> &taken, int columns, int rows, int widthPx, int heightPx)
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
    const Vector2d place = wanted.placement.place - now.place, slope = wanted.placement.slope - now.slope;
    const double size = wanted.placement.size - now.size;
    struct Step
    {
        double amount;
        BoardHint less, more;
    };
    // A place away from where it belongs hides what the slope looks like, so it counts twice.
    const std::array<Step, 5> steps{{{2 * place.x(), BoardHint::Left, BoardHint::Right},
                                     {2 * place.y(), BoardHint::Up, BoardHint::Down},
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
