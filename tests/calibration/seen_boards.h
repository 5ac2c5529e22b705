// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board_detection.h"
#include "core/geometry/camera_model.h"
#include "core/geometry/floor_view.h"

#include <random>
#include <string>
#include <vector>

/// A board of 9×6 corners of 30 mm as a camera sees it; the pose turns it by tilts (radians) about the
/// board's axes.
inline odo::BoardView see(const odo::CameraModel &camera, const Eigen::Vector3d &centre, double tiltX,
                          double tiltY, double turn, std::mt19937 &random, double noisePx)
{
    using Eigen::Vector3d;
    std::normal_distribution<double> noise(0, 1);
    const Eigen::Quaterniond rotation = Eigen::AngleAxisd(tiltX, Vector3d::UnitX()) *
                                        Eigen::AngleAxisd(tiltY, Vector3d::UnitY()) *
                                        Eigen::AngleAxisd(turn, Vector3d::UnitZ());
    odo::BoardView view{"picture", 9, 6, {}, {}};
    for (int y = 0; y < 6; ++y) {
        for (int x = 0; x < 9; ++x) {
            const Eigen::Vector2d point(0.03 * x, 0.03 * y);
            const auto pixel =
                camera.project(rotation * Vector3d(point.x() - 0.12, point.y() - 0.075, 0) + centre);
            if (!pixel)
                continue;
            view.pixels.push_back(*pixel + noisePx * Eigen::Vector2d(noise(random), noise(random)));
            view.pointsOnBoard.push_back(point);
        }
    }
    return view;
}

/// Boards held by a careful person, with so much noise on each coordinate.
inline std::vector<odo::BoardView> tiltedViews(const odo::CameraModel &camera, int count, double noisePx,
                                               unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> across(-1, 1);
    std::vector<odo::BoardView> views;
    for (int i = 0; i < count; ++i) {
        const double depth = 0.55 + 0.25 * across(random);
        views.push_back(see(camera, {0.4 * depth * across(random), 0.22 * depth * across(random), depth},
                            0.7 * across(random), 0.7 * across(random), 3 * across(random), random, noisePx));
        views.back().source = "picture" + std::to_string(i);
    }
    return views;
}
