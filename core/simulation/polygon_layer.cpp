// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/polygon_layer.h"

#include <cmath>

namespace odo {
namespace {

double signedArea(std::span<const Eigen::Vector2d> outline)
{
    double doubled = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
        doubled += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * doubled;
}

} // namespace

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
    const double width = m_rect.width();
    for (double y = top; y < bottom;) {
        const int row = static_cast<int>(y);
        const double next = std::min(row + 1.0, bottom);
        const double xa = std::clamp(from.x() + (y - from.y()) * slope, 0.0, width);
        const double xb = std::clamp(from.x() + (next - from.y()) * slope, 0.0, width);
        addSpan(m_changes.data() + static_cast<std::ptrdiff_t>(row) * m_stride, std::min(xa, xb),
                std::max(xa, xb), direction * (next - y), premultiplied);
        y = next;
    }
}

void PolygonLayer::addSpan(Rgb *row, double x0, double x1, double cover, const Rgb &premultiplied) const
{
    // To the right of the edge all of `cover`; in the pixels it crosses the part that lies to its right. The
    // covered part as a function of the pixel's right border is the integral of the edge's distribution along
    // x.
    const int first = static_cast<int>(x0);
    const int last = std::min(static_cast<int>(x1), m_rect.width());
    const auto put = [&](int x, double change) { row[x] += premultiplied * static_cast<float>(change); };
    if (first == last) {
        const double right = first + 1 - 0.5 * (x0 + x1);
        put(first, cover * right);
        put(first + 1, cover * (1 - right));
        return;
    }
    const double density = 1.0 / (x1 - x0);
    double before = 0; // coverage of the pixel to the left
    for (int x = first; x <= last; ++x) {
        // Area to the right of the edge within [x, x+1], for an edge that is spread evenly over [x0, x1].
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
