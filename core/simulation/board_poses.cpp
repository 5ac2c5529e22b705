// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/board_poses.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace odo {

namespace {

constexpr double borderPx = 8; // a corner nearer to the edge than this lacks its surroundings

bool allCornersVisible(const CameraModel &camera, const SimulatedBoard &board, const RigidTransform &cameraFromBoard)
{
    // One square beyond the inner corners, so that the outer squares are in the picture as well.
    for (const double column : {-1.0, double(board.columns)}) {
        for (const double row : {-1.0, double(board.rows)}) {
            const Eigen::Vector3d corner(column * board.squareM, row * board.squareM, 0);
            const auto pixel = camera.project(cameraFromBoard * corner);
            if (!pixel || pixel->x() < borderPx || pixel->y() < borderPx ||
                pixel->x() > camera.intrinsics().widthPx - 1 - borderPx ||
                pixel->y() > camera.intrinsics().heightPx - 1 - borderPx)
                return false;
        }
    }
    return true;
}

RigidTransform randomPose(const CameraModel &camera, const SimulatedBoard &board, std::mt19937 &random)
{
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const Intrinsics &lens = camera.intrinsics();
    const double boardWidthM = (board.columns + 1) * board.squareM;
    const double share = uniform(0.3, 0.7); // of the picture's width
    const double distanceM = lens.fxPx * boardWidthM / (share * lens.widthPx);
    const Eigen::Vector2d target(uniform(0.2, 0.8) * lens.widthPx, uniform(0.2, 0.8) * lens.heightPx);
    const double tilt = uniform(0.2, 0.7), towards = uniform(0, 2 * std::numbers::pi);
    RigidTransform pose;
    pose.rotation = Eigen::AngleAxisd(uniform(-0.3, 0.3), Eigen::Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(tilt, Eigen::Vector3d(std::cos(towards), std::sin(towards), 0));
    const Eigen::Vector3d middle((board.columns - 1) * board.squareM / 2, (board.rows - 1) * board.squareM / 2, 0);
    const Eigen::Vector3d place((target.x() - lens.cxPx) / lens.fxPx * distanceM,
                                (target.y() - lens.cyPx) / lens.fyPx * distanceM, distanceM);
    pose.translation = place - pose.rotation * middle;
    return pose;
}

} // namespace

std::vector<RigidTransform> heldBoardPoses(const CameraModel &camera, const SimulatedBoard &board, int count,
                                           std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::vector<RigidTransform> poses;
    while (static_cast<int>(poses.size()) < count) {
        const RigidTransform pose = randomPose(camera, board, random);
        if (allCornersVisible(camera, board, pose))
            poses.push_back(pose);
    }
    return poses;
}

} // namespace odo
