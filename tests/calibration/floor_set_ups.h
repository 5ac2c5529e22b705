// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_registration.h"
#include "core/simulation/demo_testbed.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

// Drawn floors with markers, seen through drawn lenses.
namespace odo::test {

inline constexpr double floorLengthM = 3, floorDepthM = 2.2;

enum class LensKind { Straight, Webcam, ActionCamera, Fisheye, LongLens };
enum class Arrangement { AllRound, Row, Rim };

inline double across(std::mt19937 &random)
{
    return std::uniform_real_distribution<double>(-1, 1)(random);
}

inline double share(std::mt19937 &random)
{
    return std::uniform_real_distribution<double>(0, 1)(random);
}

inline Intrinsics drawnLens(LensKind kind, std::mt19937 &random)
{
    Intrinsics lens{
        1280, 720, 0, 0, 639.5 + 12 * across(random), 359.5 + 12 * across(random), LensModel::Standard,
        {},   {}};
    const auto draw = [&](double middle, double reach) { return middle + reach * across(random); };
    switch (kind) {
    case LensKind::Straight:
        lens.fxPx = 1280 * draw(0.95, 0.25);
        lens.distortion = {draw(0, 0.01), 0, 0, 0, 0};
        break;
    case LensKind::Webcam:
        lens.fxPx = 1280 * draw(0.75, 0.12);
        lens.distortion = {draw(-0.12, 0.1), draw(0.05, 0.05), draw(0, 0.0007), draw(0, 0.0007), 0};
        break;
    case LensKind::ActionCamera:
        lens.fxPx = 1280 * draw(0.5, 0.08);
        lens.distortion = {draw(-0.27, 0.05), draw(0.1, 0.03), draw(0, 0.0005), draw(0, 0.0005), -0.015};
        break;
    case LensKind::Fisheye:
        lens.model = LensModel::Fisheye;
        lens.fxPx = 1280 * draw(0.45, 0.06);
        lens.distortion = {draw(0, 0.01), draw(0, 0.005), 0, 0};
        break;
    case LensKind::LongLens:
        lens.fxPx = 1280 * draw(1.4, 0.3);
        lens.distortion = {draw(-0.25, 0.2), draw(0, 0.2), 0, 0, 0};
        break;
    }
    lens.fyPx = lens.fxPx * draw(1, 0.002);
    return lens;
}

/// A camera somewhere about the floor, aimed at its middle.
inline FloorView drawnFloorView(const Intrinsics &lens, std::mt19937 &random)
{
    const double direction = 2 * EIGEN_PI * share(random);
    const double awayM = (2 + 1.5 * share(random)) * std::max(0.6, lens.fxPx / 1200);
    const Eigen::Vector3d position(floorLengthM / 2 + awayM * std::cos(direction),
                                   floorDepthM / 2 + awayM * std::sin(direction), 1.3 + 1.5 * share(random));
    const FloorView aimed = simulatedView(position, {floorLengthM / 2, floorDepthM / 2, 0}, lens.widthPx,
                                          lens.heightPx, lens.fxPx);
    return FloorView(CameraModel::create(lens).value(), aimed.worldFromCamera(),
                     Eigen::Matrix<double, 6, 6>::Zero());
}

/// The pixel of a floor point that the image shows.
inline std::optional<Eigen::Vector2d> shownPixel(const FloorView &view, const Eigen::Vector2d &point)
{
    const auto pixel = view.pixelFromWorld({point.x(), point.y(), 0});
    if (!pixel || pixel->x() < 0 || pixel->y() < 0 || pixel->x() > 1279 || pixel->y() > 719)
        return std::nullopt;
    return pixel;
}

/// Markers as a person measures and marks them.
struct MarkedFloor
{
    MarkerLayout layout;
    std::vector<MarkerPixel> pixels;

    MarkedFloor(const FloorView &view, Arrangement arrangement, std::size_t count, double tapeM,
                double noisePx, std::mt19937 &random)
    {
        std::normal_distribution<double> normal(0, 1);
        const int side = static_cast<int>(4 * share(random));
        layout.name = "floor";
        for (int tries = 0; tries < 5000 && pixels.size() < count; ++tries) {
            const Eigen::Vector2d point = drawnPoint(arrangement, side, random);
            const auto pixel = shownPixel(view, point);
            const auto isNear = [&](const Marker &marker) {
                return (marker.pointInWorld - point).norm() < 0.06;
            };
            if (!pixel || std::ranges::any_of(layout.markers, isNear))
                continue;
            const std::string label = "m" + std::to_string(pixels.size());
            layout.markers.push_back(
                {label, point + tapeM * Eigen::Vector2d(normal(random), normal(random))});
            pixels.push_back({label, *pixel + noisePx * Eigen::Vector2d(normal(random), normal(random))});
        }
    }

private:
    static Eigen::Vector2d drawnPoint(Arrangement arrangement, int side, std::mt19937 &random)
    {
        Eigen::Vector2d point(floorLengthM * share(random), floorDepthM * share(random));
        if (arrangement == Arrangement::Row)
            point.y() = 0.8 + 0.35 * share(random);
        if (arrangement != Arrangement::Rim)
            return point;
        double &along = side < 2 ? point.x() : point.y();
        const double size = side < 2 ? floorLengthM : floorDepthM;
        along = side % 2 == 0 ? 0.25 * along : size - 0.25 * along;
        return point;
    }
};

} // namespace odo::test
