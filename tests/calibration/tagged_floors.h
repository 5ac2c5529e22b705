// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/internal/tag_families.h"
#include "core/calibration/marker_layout.h"
#include "core/geometry/floor_view.h"
#include "tests/calibration/floor_views.h"

#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

namespace odo::test {

/// A tag on the floor, its border square as large as said, turned counter-clockwise.
struct DrawnTag
{
    TagName name;
    Eigen::Vector2d middle;
    double sideM = 0.16, turnRad = 0;
};

/// A dark disc on the floor.
struct DrawnDot
{
    Eigen::Vector2d middle;
    double radiusM = 0.03;
};

/// A dark square on the floor, along its axes.
struct DrawnSquare
{
    Eigen::Vector2d middle;
    double sideM = 0.1;
};

struct TaggedFloor
{
    std::vector<DrawnTag> tags;
    std::vector<DrawnSquare> squares;
    std::vector<DrawnDot> dots;
    double blurPx = 0.6, noiseSigma = 2;
    double darkest = 1; ///< at the image's left side, of the light at its right side
    std::uint32_t seed = 1;
};

/// Grey value of a floor position.
class FloorLook
{
public:
    explicit FloorLook(const TaggedFloor &floor) : m_floor(floor)
    {
        for (const DrawnTag &tag : floor.tags) {
            m_cells.push_back(*tagCells(tag.name));
            m_turns.push_back(Eigen::Rotation2Dd(-tag.turnRad).toRotationMatrix() * (2 / tag.sideM));
        }
    }

    double at(const Eigen::Vector2d &point) const
    {
        for (const DrawnDot &dot : m_floor.dots) {
            if ((point - dot.middle).squaredNorm() < dot.radiusM * dot.radiusM)
                return 30;
        }
        for (const DrawnSquare &square : m_floor.squares) {
            if ((point - square.middle).cwiseAbs().maxCoeff() < square.sideM / 2)
                return 30;
        }
        for (std::size_t i = 0; i < m_cells.size(); ++i) {
            const DrawnTag &tag = m_floor.tags[i];
            const Eigen::Vector2d away = point - tag.middle;
            if (std::max(std::abs(away.x()), std::abs(away.y())) > 2 * tag.sideM)
                continue;
            const Eigen::Vector2d local = m_turns[i] * away;
            const TagCells &cells = m_cells[i];
            const double cell = 2 * cells.reach / cells.side;
            const double u = local.x(), v = -local.y();
            if (std::max(std::abs(u), std::abs(v)) < cells.reach)
                return cells.white[std::size_t(int((v + cells.reach) / cell) * cells.side +
                                               int((u + cells.reach) / cell))]
                           ? 225
                           : 30;
            if (std::max(std::abs(u), std::abs(v)) < cells.reach + 1.2 * cell)
                return 225;
        }
        const auto tile = std::lround(std::floor(point.x() / 0.5) + std::floor(point.y() / 0.5));
        return 165 + 8.0 * double(tile % 2 != 0);
    }

private:
    const TaggedFloor &m_floor;
    std::vector<TagCells> m_cells;
    std::vector<Eigen::Matrix2d> m_turns;
};

/// What a view sees of it, through JPEG.
inline Frame drawTaggedFloor(const FloorView &view, const TaggedFloor &floor)
{
    constexpr int parts = 4;
    const Intrinsics &lens = view.camera().intrinsics();
    const FloorLook look(floor);
    cv::Mat image(lens.heightPx, lens.widthPx, CV_8UC1);
    const auto pointAt = [&](double x, double y) {
        return view.floorFromPixel({x - 0.5, y - 0.5}, 0).value_or(Eigen::Vector2d(1e6, 1e6));
    };
    std::vector<Eigen::Vector2d> above(std::size_t(lens.widthPx) + 1), below = above;
    for (int x = 0; x <= lens.widthPx; ++x)
        above[std::size_t(x)] = pointAt(x, 0);
    for (int y = 0; y < lens.heightPx; ++y, std::swap(above, below)) {
        for (int x = 0; x <= lens.widthPx; ++x)
            below[std::size_t(x)] = pointAt(x, y + 1);
        for (int x = 0; x < lens.widthPx; ++x) {
            double sum = 0;
            const auto i = std::size_t(x);
            for (int part = 0; part < parts * parts; ++part) {
                const double u = (part % parts + 0.5) / parts, v = (part / parts + 0.5) / parts;
                sum += look.at((1 - v) * ((1 - u) * above[i] + u * above[i + 1]) +
                               v * ((1 - u) * below[i] + u * below[i + 1]));
            }
            const double light = floor.darkest + (1 - floor.darkest) * x / lens.widthPx;
            image.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(light * sum / (parts * parts));
        }
    }
    return asByWebcam(frameOf(image), floor.blurPx, floor.noiseSigma, floor.seed);
}

/// Some camera that has all positions in its picture.
inline FloorView someView(const std::vector<Eigen::Vector2d> &positions, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    MarkerLayout layout;
    for (const Eigen::Vector2d &position : positions) {
        middle += position / double(positions.size());
        layout.markers.push_back({"", position});
    }
    static constexpr int sizes[][2] = {{1280, 720}, {1920, 1080}, {1024, 768}};
    for (;;) {
        const auto &size = sizes[random() % 3];
        const double direction = 2 * EIGEN_PI * share(random), away = 0.5 + 2.5 * share(random);
        const Eigen::Vector3d position(middle.x() + away * std::cos(direction),
                                       middle.y() + away * std::sin(direction), 1.4 + 2 * share(random));
        const Eigen::Vector3d aim(middle.x() + 0.3 * (share(random) - 0.5),
                                  middle.y() + 0.3 * (share(random) - 0.5), 0);
        const FloorView view =
            simulatedView(position, aim, size[0], size[1], size[0] * (0.5 + 0.4 * share(random)));
        if (!markersIn(view, layout, 40).empty())
            return view;
    }
}

} // namespace odo::test
