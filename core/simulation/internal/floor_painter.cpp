// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/floor_painter.h"

#include "core/simulation/internal/polygon_layer.h"
#include "core/simulation/scene.h"
#include "core/simulation/tag_pattern.h"

#include <cmath>
#include <optional>

namespace odo {
namespace {

constexpr double groutM = 0.006;
const Rgb paperWhite(240, 240, 238, 0), inkBlack(26, 26, 28, 0);

/// Smooth noise in [-1, 1] with features of the size of the lattice (Perlin 1985, value noise).
double valueNoise(const Eigen::Vector2d &point, double latticeM, std::uint64_t seed)
{
    const double gx = point.x() / latticeM, gy = point.y() / latticeM;
    const double ix = std::floor(gx), iy = std::floor(gy);
    const double fx = gx - ix, fy = gy - iy;
    const double u = fx * fx * (3 - 2 * fx), v = fy * fy * (3 - 2 * fy);
    const auto corner = [&](double x, double y) {
        const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
        const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
        return randomSigned(randomHash(seed, column), row);
    };
    const double top = corner(ix, iy) * (1 - u) + corner(ix + 1, iy) * u;
    const double bottom = corner(ix, iy + 1) * (1 - u) + corner(ix + 1, iy + 1) * u;
    return top * (1 - v) + bottom * v;
}

double grain(const Eigen::Vector2d &point, std::uint64_t seed)
{
    // No finer than two pixels of an ordinary view, or it would flicker between neighbouring pixels.
    return 0.40 * valueNoise(point, 0.42, seed) + 0.25 * valueNoise(point, 0.11, seed + 1) +
           0.35 * valueNoise(point, 0.024, seed + 2);
}

/// Floor points at the pixels of a grid, from which those between are interpolated: for texture only, whose
/// position need not be exact.
class FloorGrid
{
public:
    FloorGrid(const FloorView &view, int width, int height) : m_columns(width / step + 2)
    {
        for (int y = 0; y < height + step; y += step)
            for (int x = 0; x < m_columns * step; x += step)
                m_points.push_back(view.floorFromPixel({x, y}, 0.0));
    }

    std::optional<Eigen::Vector2d> at(int x, int y) const
    {
        const std::size_t i = static_cast<std::size_t>(y / step) * static_cast<std::size_t>(m_columns) +
                              static_cast<std::size_t>(x / step);
        const auto below = i + static_cast<std::size_t>(m_columns);
        if (below + 1 >= m_points.size() || !m_points[i] || !m_points[i + 1] || !m_points[below] ||
            !m_points[below + 1])
            return std::nullopt;
        const double u = static_cast<double>(x % step) / step, v = static_cast<double>(y % step) / step;
        return (1 - v) * ((1 - u) * *m_points[i] + u * *m_points[i + 1]) +
               v * ((1 - u) * *m_points[below] + u * *m_points[below + 1]);
    }

private:
    static constexpr int step = 4;
    int m_columns;
    std::vector<std::optional<Eigen::Vector2d>> m_points;
};

class FloorPainter
{
public:
    FloorPainter(const SimulatedFloor &floor, const FloorView &view)
        : m_floor(floor), m_view(view), m_outline(view.camera(), view.cameraFromWorld()),
          m_seed(floor.textureSeed), m_image(m_outline.imageRect())
    {
    }

    RgbImage paint()
    {
        paintRoom();
        paintTiles();
        paintGrain();
        for (const FloorPatch &patch : m_floor.patches)
            paintPatch(patch);
        if (m_floor.markerSideM > 0)
            for (std::size_t i = 0; i < m_floor.markers.markers.size(); ++i) {
                const Marker &marker = m_floor.markers.markers[i];
                paintMarker(marker.pointInWorld,
                            m_floor.areTagsByLabel ? std::stoi(marker.label) : static_cast<int>(i));
            }
        return std::move(m_image);
    }

private:
    void paintRoom()
    {
        const PixelRect rect = m_image.rect();
        for (int y = rect.y0; y < rect.y1; ++y) {
            const float light = 0.86f + 0.22f * static_cast<float>(y) / static_cast<float>(rect.height());
            std::fill_n(m_image.row(y), rect.width(), toRgb(m_floor.surroundings) * light);
        }
    }

    void paintTiles()
    {
        paintOne(floorRectangle(m_floor.lower, m_floor.upper), toRgb(m_floor.colour) * 0.86f);
        PolygonLayer tiles(m_image.rect());
        const double tile = m_floor.tileM;
        const Eigen::Array2i first = (m_floor.lower.array() / tile).floor().cast<int>();
        const Eigen::Array2i last = (m_floor.upper.array() / tile).ceil().cast<int>();
        const Eigen::Vector2d gap = Eigen::Vector2d::Constant(groutM / 2);
        for (int j = first.y(); j < last.y(); ++j) {
            for (int i = first.x(); i < last.x(); ++i) {
                const Eigen::Vector2d lower = Eigen::Vector2d(i * tile, j * tile) + gap;
                const Eigen::Vector2d upper = Eigen::Vector2d((i + 1) * tile, (j + 1) * tile) - gap;
                const Eigen::Vector2d from = lower.cwiseMax(m_floor.lower + 2 * gap);
                const Eigen::Vector2d to = upper.cwiseMin(m_floor.upper - 2 * gap);
                if (from.x() >= to.x() || from.y() >= to.y())
                    continue;
                const double tone = randomSigned(randomHash(m_seed, static_cast<std::uint64_t>(i + 1000)),
                                                 static_cast<std::uint64_t>(j + 1000));
                const double light = 1.0 + 0.35 * m_floor.textureAmplitude * tone;
                tiles.add(m_outline.of(floorRectangle(from, to)),
                          toRgb(m_floor.colour) * static_cast<float>(light));
            }
        }
        tiles.paintOver(m_image);
    }

    void paintGrain()
    {
        const PixelRect rect = m_image.rect();
        const FloorGrid grid(m_view, rect.width(), rect.height());
        for (int y = rect.y0; y < rect.y1; ++y) {
            Rgb *pixels = m_image.row(y);
            for (int x = rect.x0; x < rect.x1; ++x)
                if (const auto point = grid.at(x, y))
                    pixels[x] *= static_cast<float>(1.0 + m_floor.textureAmplitude * grain(*point, m_seed));
        }
    }

    void paintPatch(const FloorPatch &patch)
    {
        std::vector<Eigen::Vector3d> corners;
        for (const Eigen::Vector2d &corner : patch.corners)
            corners.emplace_back(corner.x(), corner.y(), 0.0);
        paintOne(corners, toRgb(patch.colour));
    }

    void paintMarker(const Eigen::Vector2d &centre, int id)
    {
        if (m_floor.markerShape == MarkerShape::Tag)
            paintTag(centre, id);
        else
            paintRound(centre);
    }

    void paintRound(const Eigen::Vector2d &centre)
    {
        const double radius = m_floor.markerSideM / 2;
        const Eigen::Vector2d paper = Eigen::Vector2d::Constant(1.3 * radius);
        paintOne(floorRectangle(centre - paper, centre + paper), paperWhite);
        paintOne(circle(centre, radius), inkBlack);
        if (m_floor.markerShape == MarkerShape::Ring)
            paintOne(circle(centre, radius / 2), paperWhite);
    }

    static std::vector<Eigen::Vector3d> circle(const Eigen::Vector2d &centre, double radius)
    {
        constexpr int corners = 120; // within 0.03 % of the radius
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2 * EIGEN_PI * i / corners;
            points.emplace_back(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle),
                                0.0);
        }
        return points;
    }

    void paintTag(const Eigen::Vector2d &centre, int id)
    {
        const TagPattern pattern = aprilTagPattern(id);
        const double cell = m_floor.markerSideM / (pattern.side - 2);
        const double half = cell * pattern.side / 2;
        const Eigen::Vector2d paper = Eigen::Vector2d::Constant(half + 0.5 * cell);
        paintOne(floorRectangle(centre - paper, centre + paper), paperWhite);
        PolygonLayer ink(m_image.rect());
        for (int row = 0; row < pattern.side; ++row) {
            for (int column = 0; column < pattern.side; ++column) {
                if (!pattern.isBlack(column, row))
                    continue;
                // The pattern's rows run down the paper, which lies with its top towards V.
                const Eigen::Vector2d lower =
                    centre + Eigen::Vector2d(column * cell - half, half - (row + 1) * cell);
                const Eigen::Vector2d upper = lower + Eigen::Vector2d::Constant(cell);
                ink.add(m_outline.of(floorRectangle(lower, upper)), inkBlack);
            }
        }
        ink.paintOver(m_image);
    }

    void paintOne(const std::vector<Eigen::Vector3d> &corners, const Rgb &colour)
    {
        const std::vector<Eigen::Vector2d> outline = m_outline.of(corners);
        const PixelRect rect = boundsOf(outline).clipped(m_image.rect());
        if (rect.isEmpty())
            return;
        PolygonLayer layer(rect);
        layer.add(outline, colour);
        layer.paintOver(m_image);
    }

    const SimulatedFloor &m_floor;
    const FloorView &m_view;
    const ImageOutline m_outline;
    const std::uint64_t m_seed;
    RgbImage m_image;
};

} // namespace

RgbImage paintFloor(const SimulatedFloor &floor, const FloorView &view)
{
    return FloorPainter(floor, view).paint();
}

std::vector<Eigen::Vector3d> floorRectangle(const Eigen::Vector2d &lower, const Eigen::Vector2d &upper)
{
    return {{lower.x(), lower.y(), 0},
            {upper.x(), lower.y(), 0},
            {upper.x(), upper.y(), 0},
            {lower.x(), upper.y(), 0}};
}

} // namespace odo
