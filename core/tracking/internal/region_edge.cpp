// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/region_edge.h"

#include "core/geometry/silhouette.h"
#include "core/tracking/internal/compared_window.h"
#include "core/tracking/internal/difference_windows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace odo {

void EdgePixels::makeRoom(std::size_t pixels)
{
    if (pixels <= at.size())
        return;
    at.resize(pixels);
    around.resize(pixels);
    found.resize(pixels);
    for (std::vector<float> *values :
         {&luma, &u, &v, &lumaBehind, &uBehind, &vBehind, &lumaNoise2, &chromaNoise2})
        values->resize(pixels);
}

void EdgePixels::findCovered() // plainly, so that several are computed at once
{
    if (count == 0)
        return;
    float *__restrict into = found.front().data();
    for (std::size_t i = 0, end = count; i < end; ++i, into += 2) {
        const Sums &sums = around[i];
        const float perPixel = 1 / float(sums[insideCount]),
                    perChroma = perPixel / ComparedWindow::chromaUnit;
        const int isNoneOutside = sums[outsideCount] == 0; // it counts as one in full light
        const float light = float(sums[outsideLight] + isNoneOutside * lightUnit) /
                            float((sums[outsideCount] + isNoneOutside) * lightUnit);
        const float perTint =
            1 / (float(sums[outsideCount] + isNoneOutside) * float(ComparedWindow::chromaUnit));
        const float lumaOutside = light * lumaBehind[i],
                    uOutside = light * uBehind[i] + float(sums[outsideTintU]) * perTint,
                    vOutside = light * vBehind[i] + float(sums[outsideTintV]) * perTint;
        const float dy = float(sums[insideLuma]) * perPixel - lumaOutside;
        const float du = float(sums[insideU]) * perChroma - uOutside,
                    dv = float(sums[insideV]) * perChroma - vOutside;
        const float y2 = lumaNoise2[i], c2 = chromaNoise2[i];
        const float contrast = dy * dy * c2 + (du * du + dv * dv) * y2; // times both variances, as `along`
        const float along =
            (luma[i] - lumaOutside) * dy * c2 + ((u[i] - uOutside) * du + (v[i] - vOutside) * dv) * y2;
        into[0] = along / contrast;
        into[1] = contrast - differsInSigmas2 * y2 * c2;
    }
}

namespace {

// to both sides of the edge, and inside if only the hue shows it
constexpr int edgePx = 2, softEdgePx = 4;
constexpr int edgeReach = 4, hueReach = 6; // pixels around one on the edge, in which both sides are read
static_assert(RegionEdge::marginPx >= edgePx + hueReach);
constexpr float half = 0.5F;

Chroma meanChromaOf(const ComparedWindow &w, const PixelRect &part, const BitMask &pixels)
{
    std::int64_t count = 0, uSum = 0, vSum = 0;
    for (int y = 0; y < pixels.height(); ++y) {
        const std::int16_t *u = w.uRow(part.y0 + y) + part.x0, *v = w.vRow(part.y0 + y) + part.x0;
        pixels.forEachRunInRow(y, [&](int x0, int x1) {
            count += x1 - x0;
            uSum += std::accumulate(u + x0, u + x1, 0);
            vSum += std::accumulate(v + x0, v + x1, 0);
        });
    }
    const double scale = count > 0 ? 1 / (double(count) * double(ComparedWindow::chromaUnit)) : 0;
    return Chroma(double(uSum), double(vSum)) * scale;
}

} // namespace

void RegionEdge::measure(const ComparedWindow &w, const FloorShade &shade, const PixelRect &part,
                         const BitMask &region, const BitMask &cut)
{
    Surroundings all{w, part, region.eroded(edgePx, false), region.dilated(edgePx) - cut,
                     shade.shade().cropped(part)};
    BitMask soft = all.near & shade.byHue().cropped(part);
    m_edge.count = 0;
    if (!soft.isEmpty()) {
        soft -= region.eroded(softEdgePx, false);
        all.core -= soft;
        addEdge(all, soft, hueReach);
    }
    addEdge(all, all.near - all.core - soft, edgeReach);
    m_edge.findCovered();
    cover(region);
    m_meanChroma = meanChromaOf(w, part, all.core);
    findPoints({w.rect().x0 + part.x0, w.rect().y0 + part.y0});
}

/// Adds pixels on the edge, with both sides of it in the square around each that reaches so far.
void RegionEdge::addEdge(const Surroundings &all, const BitMask &edge, int reach)
{
    const BitMask around = edge.grown(reach), outside = around - all.near;
    const Summed summed{all.core & around, outside - all.shaded, outside & all.shaded};
    const PixelRect box = edge.bounds();
    m_columns.assign(std::size_t(edge.width() + 2 * reach), {});
    m_shadedRows.resize(2 * hueReach + 2); // up to the row that is taken away again
    // the sums are as far ahead as is read
    for (int y = std::max(0, box.y0 - reach); y < box.y1 + reach; ++y) {
        if (y < box.y1)
            all.window.fetchNoise(all.part.y0 + y, all.part.x0 + box.x0, all.part.x0 + box.x1);
        if (y < edge.height()) {
            readShaded(all, summed.shaded, y);
            sumUp(all, summed, y, reach, [](std::int32_t &sum, int value) { sum += value; });
        }
        const int row = y - reach, left = row - reach - 1;
        if (left >= 0)
            sumUp(all, summed, left, reach, [](std::int32_t &sum, int value) { sum -= value; });
        if (row >= 0)
            addEdgeRow(all, edge, reach, row);
    }
}

std::vector<RegionEdge::Shaded> &RegionEdge::shadedRow(int y)
{
    return m_shadedRows[std::size_t(y) % m_shadedRows.size()];
}

void RegionEdge::readShaded(const Surroundings &all, const BitMask &shaded, int y)
{
    std::vector<Shaded> &row = shadedRow(y);
    row.resize(std::size_t(shaded.width()));
    shaded.forEachInRow(y, [&](int x) {
        const PixelColour seen = all.window.seen(all.part.x0 + x, all.part.y0 + y),
                          behind = all.window.behind(all.part.x0 + x, all.part.y0 + y);
        const float light = seen.luma / behind.luma;
        row[std::size_t(x)] = {int(float(EdgePixels::lightUnit) * light),
                               int((seen.u - light * behind.u) * ComparedWindow::chromaUnit),
                               int((seen.v - light * behind.v) * ComparedWindow::chromaUnit)};
    });
}

/// Changes the columns' sums by a row's pixels.
template <class Change>
void RegionEdge::sumUp(const Surroundings &all, const Summed &summed, int y, int reach, const Change &change)
{
    using E = EdgePixels;
    const ComparedWindow &w = all.window;
    const int left = all.part.x0, top = all.part.y0, black = w.gain().black;
    const std::uint8_t *luma = w.lumaRow(top + y) + left;
    const std::int16_t *u = w.uRow(top + y) + left, *v = w.vRow(top + y) + left;
    E::Sums *columns = m_columns.data() + reach;
    summed.inside.forEachRunInRow(y, [&](int x0, int x1) {
        for (int x = x0; x < x1; ++x) {
            change(columns[x][E::insideCount], 1);
            change(columns[x][E::insideLuma], luma[x] - black);
            change(columns[x][E::insideU], u[x]);
            change(columns[x][E::insideV], v[x]);
        }
    });
    summed.lit.forEachRunInRow(y, [&](int x0, int x1) {
        for (int x = x0; x < x1; ++x) {
            change(columns[x][E::outsideCount], 1);
            change(columns[x][E::outsideLight], E::lightUnit);
        }
    });
    const std::vector<Shaded> &shaded = shadedRow(y);
    summed.shaded.forEachInRow(y, [&](int x) {
        change(columns[x][E::outsideCount], 1);
        change(columns[x][E::outsideLight], shaded[std::size_t(x)].light);
        change(columns[x][E::outsideTintU], shaded[std::size_t(x)].tintU);
        change(columns[x][E::outsideTintV], shaded[std::size_t(x)].tintV);
    });
}

void RegionEdge::addEdgeRow(const Surroundings &all, const BitMask &edge, int reach, int y)
{
    EdgePixels &pixels = m_edge;
    pixels.makeRoom(pixels.count + std::size_t(edge.width()));
    const std::size_t first = pixels.count;
    EdgePixels::Sums sums{};
    int begin = 0, end = 0; // of the columns that are in the sums
    edge.forEachInRow(y, [&](int x) {
        if (x >= end) {
            sums = {};
            begin = end = x;
        }
        for (; end <= x + 2 * reach; ++end)
            for (std::size_t k = 0; k < sums.size(); ++k)
                sums[k] += m_columns[std::size_t(end)][k];
        for (; begin < x; ++begin)
            for (std::size_t k = 0; k < sums.size(); ++k)
                sums[k] -= m_columns[std::size_t(begin)][k];
        pixels.around[pixels.count] = sums;
        pixels.at[pixels.count++] = {x, y};
    });
    if (pixels.count > first)
        readEdgeRow(all, edge, y, first);
}

/// Reads a row's pixels of the edge, which have numbers from first on.
void RegionEdge::readEdgeRow(const Surroundings &all, const BitMask &edge, int y, std::size_t first)
{
    const ComparedWindow &w = all.window;
    EdgePixels &pixels = m_edge;
    const int left = all.part.x0, row = all.part.y0 + y;
    const int firstX = edge.nextSet(0, y), lastX = edge.lastSet(edge.width(), y) + 1;
    m_lumaNoise2.resize(std::size_t(w.width()));
    m_chromaNoise2.resize(std::size_t(w.width()));
    w.readLumaNoise2(row, left + firstX, left + lastX, m_lumaNoise2.data());
    w.readChromaNoise2(row, left + firstX, left + lastX, m_chromaNoise2.data());
    std::size_t i = first;
    edge.forEachRunInRow(y, [&](int x0, int x1) {
        std::copy(m_lumaNoise2.begin() + (x0 - firstX), m_lumaNoise2.begin() + (x1 - firstX),
                  pixels.lumaNoise2.begin() + std::ptrdiff_t(i));
        std::copy(m_chromaNoise2.begin() + (x0 - firstX), m_chromaNoise2.begin() + (x1 - firstX),
                  pixels.chromaNoise2.begin() + std::ptrdiff_t(i));
        for (int x = left + x0; x < left + x1; ++x, ++i) {
            const PixelColour seen = w.seen(x, row), behind = w.behind(x, row);
            pixels.luma[i] = seen.luma;
            pixels.u[i] = seen.u;
            pixels.v[i] = seen.v;
            pixels.lumaBehind[i] = behind.luma;
            pixels.uBehind[i] = behind.u;
            pixels.vBehind[i] = behind.v;
        }
    });
}

/// Finds what the region covers of each pixel: on the edge as was found where its sides differ, otherwise all
/// or nothing.
void RegionEdge::cover(const BitMask &region)
{
    m_mostly = region;
    m_isBlend.reset(region.width(), region.height());
    m_covered.resize(std::size_t(region.width()) * std::size_t(region.height()));
    for (std::size_t i = 0; i < m_edge.count; ++i) {
        const auto [part, clearness] = m_edge.found[i];
        const int x = m_edge.at[i].x(), y = m_edge.at[i].y();
        if (clearness >= 0) {
            m_isBlend.set(x, y);
            m_covered[std::size_t(y * region.width() + x)] = std::clamp(part, 0.0F, 1.0F);
            m_mostly.put(x, y, part >= half);
        }
    }
}

float RegionEdge::coveredAt(int x, int y) const
{
    if (m_isBlend.at(x, y))
        return m_covered[std::size_t(y * m_isBlend.width() + x)];
    return m_mostly.at(x, y) ? 1.0F : 0.0F;
}

/// Of a pixel that is mostly covered and the one before it, which is not or lies outside: how far before the
/// middle of the former the edge is.
double RegionEdge::backFrom(int x, int y, int xBefore, int yBefore) const
{
    if (xBefore < 0 || yBefore < 0 || xBefore >= m_mostly.width() || yBefore >= m_mostly.height())
        return 0;
    const float here = coveredAt(x, y), before = coveredAt(xBefore, yBefore);
    return double((here - half) / (here - before));
}

void RegionEdge::findPoints(const Eigen::Vector2d &origin)
{
    m_points.clear();
    const BitMask &mostly = m_mostly;
    const PixelRect box = mostly.bounds();
    // turn: 1 or −1, to which side a hull turns that goes from line to line
    const auto addRows = [&](double turn, int step, const auto &endOf) {
        const std::size_t first = m_points.size();
        for (int y = box.y0; y < box.y1; ++y)
            if (const int x = endOf(y); x >= 0 && x < mostly.width())
                addToChain(m_points, first, turn,
                           origin + Eigen::Vector2d(x - step * backFrom(x, y, x - step, y), y));
    };
    addRows(-1, 1, [&](int y) { return mostly.nextSet(0, y); });
    addRows(1, -1, [&](int y) { return mostly.lastSet(mostly.width(), y); });
    const auto addColumns = [&](double turn, int step, const std::vector<int> &ends) {
        const std::size_t first = m_points.size();
        for (int x = box.x0; x < box.x1; ++x)
            if (const int y = ends[std::size_t(x)]; y >= 0)
                addToChain(m_points, first, turn,
                           origin + Eigen::Vector2d(x, y - step * backFrom(x, y, x, y - step)));
    };
    addColumns(1, 1, mostly.topOfColumns());
    addColumns(-1, -1, mostly.bottomOfColumns());
}

} // namespace odo
