// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/internal/polygon_layer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace odo {

PolygonLayer::PolygonLayer(const PixelRect &rect)
    : m_rect(rect), m_stride(rect.width() + 2),
      m_changes(static_cast<std::size_t>(m_stride) * static_cast<std::size_t>(rect.height()), Rgb::Zero())
{
}

void PolygonLayer::add(std::span<const Eigen::Vector2d> outline, const Rgb &colour, double weight)
{
    if (outline.size() < 3)
        return;
    Rgb premultiplied = colour;
    premultiplied[3] = 1.f;
    premultiplied *= static_cast<float>(signedArea(outline) > 0 ? -weight : weight);
    const Eigen::Vector2d origin(m_rect.x0 - 0.5, m_rect.y0 - 0.5);
    for (std::size_t i = 0; i < outline.size(); ++i)
        addEdge(outline[i] - origin, outline[(i + 1) % outline.size()] - origin, premultiplied);
}

void PolygonLayer::addEdge(Eigen::Vector2d from, Eigen::Vector2d to, const Rgb &premultiplied)
{
    if (from.y() == to.y())
        return;
    const double direction = from.y() < to.y() ? 1.0 : -1.0;
    if (direction < 0)
        std::swap(from, to);
    const double slope = (to.x() - from.x()) / (to.y() - from.y());
    const double top = std::max(from.y(), 0.0),
                 bottom = std::min(to.y(), static_cast<double>(m_rect.height()));
    for (double y = top; y < bottom;) {
        const int row = static_cast<int>(y);
        const double next = std::min(row + 1.0, bottom);
        addSpan(m_changes.data() + static_cast<std::ptrdiff_t>(row) * m_stride,
                from.x() + (y - from.y()) * slope, from.x() + (next - from.y()) * slope,
                direction * (next - y), premultiplied);
        y = next;
    }
}

void PolygonLayer::addSpan(Rgb *row, double xa, double xb, double cover, const Rgb &premultiplied) const
{
    const auto put = [&](int x, double change) { row[x] += premultiplied * static_cast<float>(change); };
    // What is cut off on the left covers the whole row, what is cut off on the right nothing.
    const double width = m_rect.width(), length = std::abs(xb - xa);
    const double x0 = std::clamp(std::min(xa, xb), 0.0, width), x1 = std::clamp(std::max(xa, xb), 0.0, width);
    if (x1 - x0 < length) {
        const double cutOff = std::clamp(-std::min(xa, xb), 0.0, length);
        put(0, cover * cutOff / length);
        cover *= (x1 - x0) / length;
    } else if (std::max(xa, xb) <= 0 || std::min(xa, xb) >= width) {
        put(0, xa < width ? cover : 0.0);
        return;
    }
    // To the right of the edge all of `cover`; in the pixels it crosses the part that lies to its right, for
    // an edge that is spread evenly over [x0, x1].
    const int first = static_cast<int>(x0);
    const int last = std::min(static_cast<int>(x1), m_rect.width());
    if (first == last) {
        const double right = first + 1 - 0.5 * (x0 + x1);
        put(first, cover * right);
        put(first + 1, cover * (1 - right));
        return;
    }
    const double density = 1.0 / (x1 - x0);
    double before = 0; // coverage of the pixel to the left
    for (int x = first; x <= last; ++x) {
        const double a = std::max(x0, static_cast<double>(x)), b = std::min(x1, x + 1.0);
        const double reached = (a - x0) * density;
        const double share = (b - a) * density;
        const double coverage = reached + share * (x + 1 - 0.5 * (a + b));
        put(x, cover * (coverage - before));
        before = coverage;
    }
    put(last + 1, cover * (1.0 - before));
}

void PolygonLayer::paintOver(RgbImage &image)
{
    const PixelRect rect = m_rect.clipped(image.rect());
    for (int y = rect.y0; y < rect.y1; ++y) {
        const Rgb *changes = m_changes.data() + static_cast<std::ptrdiff_t>(y - m_rect.y0) * m_stride;
        Rgb *pixels = image.row(y) - image.rect().x0;
        Rgb sum = Rgb::Zero();
        for (int x = m_rect.x0; x < rect.x1; ++x) {
            sum += changes[x - m_rect.x0];
            if (sum[3] > 1e-5f && x >= rect.x0)
                pixels[x] = pixels[x] * (1.f - std::min(sum[3], 1.f)) + sum;
        }
    }
}

namespace {

// Bending of a mild lens is about 1e-4 / px: the sagitta of such an edge is 16² · 1e-4 / 8 = 0.003 px at
// most.
constexpr double edgeStepPx = 16.0;
// How far beyond the frame's border, relative to its half size, polygons are cut.
constexpr double frustumMargin = 0.06;

/// The range of x/z and y/z that the frame's border sees.
struct DirectionBounds
{
    Eigen::Vector2d lower{1e9, 1e9}, upper{-1e9, -1e9};
};

DirectionBounds directionsOfBorder(const CameraModel &camera)
{
    const double w = camera.intrinsics().widthPx - 0.5, h = camera.intrinsics().heightPx - 0.5;
    DirectionBounds bounds;
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i) {
        const double x = -0.5 + (w + 0.5) * i / steps, y = -0.5 + (h + 0.5) * i / steps;
        for (const Eigen::Vector2d &pixel : {Eigen::Vector2d(x, -0.5), Eigen::Vector2d(x, h),
                                             Eigen::Vector2d(-0.5, y), Eigen::Vector2d(w, y)}) {
            const auto direction = camera.unproject(pixel);
            if (!direction || direction->z() <= 1e-3)
                continue;
            const Eigen::Vector2d ratio = direction->head<2>() / direction->z();
            bounds.lower = bounds.lower.cwiseMin(ratio);
            bounds.upper = bounds.upper.cwiseMax(ratio);
        }
    }
    assert(bounds.lower.x() < bounds.upper.x() && bounds.lower.y() < bounds.upper.y());
    const Eigen::Vector2d margin = frustumMargin * (bounds.upper - bounds.lower) / 2;
    return {bounds.lower - margin, bounds.upper + margin};
}

} // namespace

ImageOutline::ImageOutline(CameraModel camera, RigidTransform cameraFromSource)
    : m_camera(std::move(camera)), m_cameraFromSource(std::move(cameraFromSource))
{
    const DirectionBounds b = directionsOfBorder(m_camera);
    m_inward = {{1, 0, -b.lower.x()}, {-1, 0, b.upper.x()}, {0, 1, -b.lower.y()}, {0, -1, b.upper.y()}};
}

PixelRect ImageOutline::imageRect() const
{
    return {0, 0, m_camera.intrinsics().widthPx, m_camera.intrinsics().heightPx};
}

std::vector<Eigen::Vector3d> ImageOutline::clipped(std::vector<Eigen::Vector3d> polygon) const
{
    // Sutherland and Hodgman 1974: one plane after the other.
    for (const Eigen::Vector3d &inward : m_inward) {
        std::vector<Eigen::Vector3d> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const double da = inward.dot(a), db = inward.dot(b);
            if (da >= 0)
                kept.push_back(a);
            if ((da >= 0) != (db >= 0))
                kept.emplace_back(a + (b - a) * (da / (da - db)));
        }
        polygon = std::move(kept);
    }
    return polygon;
}

std::vector<Eigen::Vector2d> ImageOutline::of(std::span<const Eigen::Vector3d> polygon) const
{
    std::vector<Eigen::Vector3d> inCamera;
    inCamera.reserve(polygon.size() + 4);
    for (const Eigen::Vector3d &point : polygon)
        inCamera.push_back(m_cameraFromSource * point);
    inCamera = clipped(std::move(inCamera));

    std::vector<Eigen::Vector2d> outline;
    for (std::size_t i = 0; i < inCamera.size(); ++i) {
        const Eigen::Vector3d &a = inCamera[i], &b = inCamera[(i + 1) % inCamera.size()];
        const auto start = m_camera.project(a), end = m_camera.project(b);
        if (!start || !end)
            return {};
        outline.push_back(*start);
        const int steps = std::max(1, static_cast<int>(std::ceil((*end - *start).norm() / edgeStepPx)));
        for (int k = 1; k < steps; ++k) {
            const auto between = m_camera.project(a + (b - a) * (static_cast<double>(k) / steps));
            if (between)
                outline.push_back(*between);
        }
    }
    return outline;
}

PixelRect boundsOf(std::span<const Eigen::Vector2d> outline)
{
    if (outline.empty())
        return {};
    Eigen::Vector2d lower = outline.front(), upper = outline.front();
    for (const Eigen::Vector2d &point : outline) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    return {static_cast<int>(std::floor(lower.x() + 0.5)), static_cast<int>(std::floor(lower.y() + 0.5)),
            static_cast<int>(std::ceil(upper.x() + 0.5)) + 1,
            static_cast<int>(std::ceil(upper.y() + 0.5)) + 1};
}

namespace {

double cross(const Eigen::Vector2d &a, const Eigen::Vector2d &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// The part of a polygon to the left (side 1) or to the right (−1) of the line from a to b.
ConvexPolygon cut(const ConvexPolygon &polygon, const Eigen::Vector2d &a, const Eigen::Vector2d &b,
                  double side)
{
    ConvexPolygon kept;
    if (polygon.empty())
        return kept;
    kept.reserve(polygon.size() + 1);
    const auto beyond = [&](const Eigen::Vector2d &point) { return side * cross(b - a, point - a); };
    double atP = beyond(polygon.front());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double atQ = beyond(q);
        if (atP >= 0)
            kept.push_back(p);
        if ((atP >= 0) != (atQ >= 0))
            kept.emplace_back(p + (q - p) * (atP / (atP - atQ)));
        atP = atQ;
    }
    return kept;
}

/// Whether an edge of the first has all of the second on its outer side: as is true for most parts of a body
/// in relation to each other.
bool isApart(const ConvexPolygon &hole, const ConvexPolygon &polygon)
{
    for (std::size_t i = 0; i < hole.size(); ++i) {
        const Eigen::Vector2d &a = hole[i], along = hole[(i + 1) % hole.size()] - a;
        if (std::ranges::all_of(polygon,
                                [&](const Eigen::Vector2d &point) { return cross(along, point - a) <= 0; }))
            return true;
    }
    return false;
}

} // namespace

double signedArea(std::span<const Eigen::Vector2d> polygon)
{
    double doubled = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return 0.5 * doubled;
}

std::vector<ConvexPolygon> outsideOf(const ConvexPolygon &hole, const ConvexPolygon &polygon)
{
    if (isApart(hole, polygon))
        return {polygon};
    const double least = 1e-9 * signedArea(polygon); // what rounding leaves
    std::vector<ConvexPolygon> pieces;
    ConvexPolygon rest = polygon;
    for (std::size_t i = 0; i < hole.size() && !rest.empty(); ++i) {
        const Eigen::Vector2d &a = hole[i], &b = hole[(i + 1) % hole.size()];
        if (ConvexPolygon outside = cut(rest, a, b, -1); signedArea(outside) > least)
            pieces.push_back(std::move(outside));
        rest = cut(rest, a, b, 1);
    }
    // All of it outside comes back in one piece.
    return signedArea(rest) > least ? pieces : std::vector<ConvexPolygon>{polygon};
}

} // namespace odo
