// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/region_edge.h"

#include "core/tracking/difference_test.h"

#include <algorithm>

namespace odo {

namespace {

constexpr int edgePx = 2, softEdgePx = 4;  // to both sides of the edge, and inside where only its hue tells it
constexpr int edgeReach = 4, hueReach = 6; // pixels around one on the edge, in which both sides are looked at
static_assert(RegionEdge::marginPx >= edgePx + hueReach);
constexpr int sumRows = 2 * hueReach + 2;   // kept of the sums
constexpr float half = 0.5F;
constexpr float lightUnit = 4096; // of the fixed-point sum

constexpr int halfWord = 32, chromaOffset = 32768;

std::uint64_t twoSums(std::uint32_t lower, std::uint32_t upper)
{
    return lower | (std::uint64_t(upper) << halfWord);
}

} // namespace

RegionEdge::Sides RegionEdge::sidesOf(const Sums &sums)
{
    const auto lower = [](std::uint64_t both) { return float(std::int32_t(both)); };
    const auto upper = [](std::uint64_t both) { return float(std::int32_t(both >> halfWord)); };
    Sides sides{lower(sums.insideLuma), lower(sums.outsideLight), {}, 1};
    if (sides.inside > 0) {
        const float perPixel = 1 / sides.inside, perChroma = perPixel / ComparedWindow::chromaUnit, offset = float(chromaOffset) * sides.inside;
        sides.colour = {upper(sums.insideLuma) * perPixel, (lower(sums.chroma) - offset) * perChroma, (upper(sums.chroma) - offset) * perChroma};
    }
    if (sides.outside > 0)
        sides.light = upper(sums.outsideLight) / (lightUnit * sides.outside);
    return sides;
}

/// The part of a pixel that a region covers; `otherwise` where the two sides look alike.
float RegionEdge::coveredPart(const ComparedWindow &w, const Sides &sides, int x, int y, float otherwise)
{
    if (sides.inside == 0)
        return otherwise;
    const PixelColour seen = w.seen(x, y), lit = w.behind(x, y), behind{sides.light * lit.luma, sides.light * lit.u, sides.light * lit.v};
    const float dy = sides.colour.luma - behind.luma, du = sides.colour.u - behind.u, dv = sides.colour.v - behind.v;
    const float lumaNoise2 = w.lumaNoise2(x, y), chromaNoise2 = w.chromaNoise2(x, y);
    const float contrast = dy * dy * chromaNoise2 + (du * du + dv * dv) * lumaNoise2; // times both variances, as `along`
    if (contrast < differsInSigmas2 * lumaNoise2 * chromaNoise2)
        return otherwise;
    const float along = (seen.luma - behind.luma) * dy * chromaNoise2 + ((seen.u - behind.u) * du + (seen.v - behind.v) * dv) * lumaNoise2;
    return std::clamp(along / contrast, 0.0F, 1.0F);
}

void RegionEdge::measure(const ComparedWindow &w, const FloorShade &shade, const PixelRect &part, const BitMask &region, const BitMask &cut)
{
    BitMask core = region.eroded(edgePx, false);
    const BitMask near = region.dilated(edgePx) - cut;
    BitMask soft = near & shade.byHue().cropped(part);
    if (!soft.isEmpty()) {
        soft -= region.eroded(softEdgePx, false);
        core -= soft;
    }
    m_width = part.width();
    m_height = part.height();
    m_covered.create(m_height, m_width);
    const BitMask edge = near - core, shaded = shade.shade().cropped(part);
    m_sums.resize(std::size_t(sumRows) * std::size_t(m_width + 1));
    std::fill_n(sumsRow(0), m_width + 1, Sums{});
    for (int y = -hueReach; y < m_height; ++y) { // the sums are as far ahead as is looked at
        if (y + hueReach < m_height)
            sumUp(w, shaded, part, core, near, y + hueReach);
        if (y < 0)
            continue;
        edge.forEachInRow(y, [&](int x) {
            const Sides sides = sidesOf(around(x, y, soft.at(x, y) ? hueReach : edgeReach));
            m_covered(y, x) = coveredPart(w, sides, part.x0 + x, part.y0 + y, region.at(x, y) ? 1.0F : 0.0F);
        });
    }
    const Sides all = sidesOf(sumsRow(m_height)[m_width]);
    m_meanChroma = Chroma(double(all.colour.u), double(all.colour.v));
    const PixelRect box = near.bounds();
    findPoints(PixelRect{box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1}.clipped({0, 0, m_width, m_height}), {w.rect().x0 + part.x0, w.rect().y0 + part.y0});
}

RegionEdge::Sums *RegionEdge::sumsRow(int y)
{
    return m_sums.data() + std::ptrdiff_t(y % sumRows) * (m_width + 1);
}

/// Makes the sums of all rows up to a row from those of the rows before it, and begins the row's covered parts.
void RegionEdge::sumUp(const ComparedWindow &w, const BitMask &shade, const PixelRect &part, const BitMask &core, const BitMask &near, int y)
{
    for (std::vector<std::uint8_t> *row : {&m_isCore, &m_isNear, &m_isShade})
        row->resize(std::size_t(m_width));
    core.copyRow(y, 0, m_width, m_isCore.data());
    near.copyRow(y, 0, m_width, m_isNear.data());
    shade.copyRow(y, 0, m_width, m_isShade.data());
    const std::uint8_t *luma = w.lumaRow(part.y0 + y) + part.x0;
    const std::int16_t *u = w.uRow(part.y0 + y) + part.x0, *v = w.vRow(part.y0 + y) + part.x0;
    float *covered = m_covered[y];
    for (int x = 0; x < m_width; ++x)
        covered[x] = m_isCore[std::size_t(x)];
    const Sums *above = sumsRow(y);
    Sums *sums = sumsRow(y + 1), row{};
    sums[0] = row;
    for (int x = 0; x < m_width; ++x) {
        const auto at = std::size_t(x);
        if (m_isCore[at]) {
            row.insideLuma += twoSums(1, std::uint32_t(luma[x] - w.gain().black));
            row.chroma += twoSums(std::uint32_t(u[x] + chromaOffset), std::uint32_t(v[x] + chromaOffset));
        } else if (!m_isNear[at]) {
            const float light = m_isShade[at] ? w.seen(part.x0 + x, part.y0 + y).luma / w.behind(part.x0 + x, part.y0 + y).luma : 1.0F;
            row.outsideLight += twoSums(1, std::uint32_t(lightUnit * light));
        }
        sums[x + 1] = {above[x + 1].insideLuma + row.insideLuma, above[x + 1].chroma + row.chroma, above[x + 1].outsideLight + row.outsideLight};
    }
}

/// Of the square around a pixel that reaches so far to each side.
RegionEdge::Sums RegionEdge::around(int x, int y, int reach)
{
    const int left = std::max(0, x - reach), right = std::min(m_width, x + reach + 1);
    const Sums *above = sumsRow(std::max(0, y - reach)), *below = sumsRow(std::min(m_height, y + reach + 1));
    const auto sum = [&](std::uint64_t Sums::*of) { return below[right].*of - below[left].*of - above[right].*of + above[left].*of; };
    return {sum(&Sums::insideLuma), sum(&Sums::chroma), sum(&Sums::outsideLight)};
}

void RegionEdge::findPoints(const PixelRect &box, const Eigen::Vector2d &origin)
{
    m_points.clear();
    // Of each line from one end; turn: 1 or −1, to which side a hull turns that goes from line to line.
    const auto walk = [&](int from, int to, int begin, int end, double turn, const auto &valueAt, const auto &pointAt) {
        const std::size_t first = m_points.size();
        const int step = begin < end ? 1 : -1;
        for (int line = from; line < to; ++line) {
            float before = 0;
            for (int at = begin; at != end; at += step) {
                const float here = valueAt(line, at);
                if (here >= half) {
                    const double back = at != begin ? double((here - half) / (here - before)) : 0;
                    addToChain(first, turn, origin + pointAt(line, at - step * back));
                    break;
                }
                before = here;
            }
        }
    };
    const auto inRow = [&](int y, int x) { return m_covered(y, x); };
    const auto inColumn = [&](int x, int y) { return m_covered(y, x); };
    const auto onRow = [](int y, double x) { return Eigen::Vector2d(x, y); };
    const auto onColumn = [](int x, double y) { return Eigen::Vector2d(x, y); };
    walk(box.y0, box.y1, box.x0, box.x1, -1, inRow, onRow);
    walk(box.y0, box.y1, box.x1 - 1, box.x0 - 1, 1, inRow, onRow);
    walk(box.x0, box.x1, box.y0, box.y1, 1, inColumn, onColumn);
    walk(box.x0, box.x1, box.y1 - 1, box.y0 - 1, -1, inColumn, onColumn);
}

/// Adds a point to those from `first` on, of which stay those that a hull may have as corners.
void RegionEdge::addToChain(std::size_t first, double turn, const Eigen::Vector2d &point)
{
    while (m_points.size() >= first + 2) {
        const Eigen::Vector2d last = m_points.back(), along = last - m_points[m_points.size() - 2], on = point - last;
        if (turn * (along.x() * on.y() - along.y() * on.x()) > 0)
            break;
        m_points.pop_back();
    }
    m_points.push_back(point);
}

} // namespace odo
