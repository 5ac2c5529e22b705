// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/polygon_layer.h"

#include "core/simulation/convex_polygon.h"

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

void PolygonLayer::paintOver(RgbPicture &picture)
{
    const PixelRect rect = m_rect.clipped(picture.rect());
    for (int y = rect.y0; y < rect.y1; ++y) {
        const Rgb *changes = m_changes.data() + static_cast<std::ptrdiff_t>(y - m_rect.y0) * m_stride;
        Rgb *pixels = picture.row(y) - picture.rect().x0;
        Rgb sum = Rgb::Zero();
        for (int x = m_rect.x0; x < rect.x1; ++x) {
            sum += changes[x - m_rect.x0];
            if (sum[3] > 1e-5f && x >= rect.x0)
                pixels[x] = pixels[x] * (1.f - std::min(sum[3], 1.f)) + sum;
        }
    }
}

} // namespace odo
