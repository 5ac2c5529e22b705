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

enum EdgeSum { inside, lumaInside, uInside, vInside, outside, lightOutside };

float signedSum(std::uint32_t sum)
{
    return float(std::int32_t(sum));
}

/// The part of a pixel that a region covers, from the sums around it; `otherwise` where the two sides look alike.
float coveredPart(const ComparedWindow &w, const std::array<std::uint32_t, 8> &sums, int x, int y, float otherwise)
{
    if (sums[inside] == 0)
        return otherwise;
    const float perPixel = 1 / float(sums[inside]), perChroma = perPixel / ComparedWindow::chromaUnit;
    const float light = sums[outside] > 0 ? float(sums[lightOutside]) / (lightUnit * float(sums[outside])) : 1;
    const PixelColour seen = w.seen(x, y), lit = w.behind(x, y), behind{light * lit.luma, light * lit.u, light * lit.v};
    const float dy = signedSum(sums[lumaInside]) * perPixel - behind.luma;
    const float du = signedSum(sums[uInside]) * perChroma - behind.u, dv = signedSum(sums[vInside]) * perChroma - behind.v;
    const float lumaNoise2 = w.lumaNoise2(x, y), chromaNoise2 = w.chromaNoise2(x, y);
    const float contrast = dy * dy * chromaNoise2 + (du * du + dv * dv) * lumaNoise2; // times both variances, as `along`
    if (contrast < differsInSigmas2 * lumaNoise2 * chromaNoise2)
        return otherwise;
    const float along = (seen.luma - behind.luma) * dy * chromaNoise2 + ((seen.u - behind.u) * du + (seen.v - behind.v) * dv) * lumaNoise2;
    return std::clamp(along / contrast, 0.0F, 1.0F);
}

} // namespace

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
    m_covered = 0;
    core.forEach([&](int x, int y) { m_covered(y, x) = 1; });
    const BitMask edge = near - core, shaded = shade.shade().cropped(part);
    m_sums.resize(std::size_t(sumRows) * std::size_t(m_width + 1));
    std::fill_n(sumsRow(0), m_width + 1, Sums{});
    for (int y = -hueReach; y < m_height; ++y) { // the sums are as far ahead as is looked at
        if (y + hueReach < m_height)
            sumUp(w, shaded, part, core, near, y + hueReach);
        if (y < 0)
            continue;
        edge.forEachInRow(y, [&](int x) {
            const Sums sums = around(x, y, soft.at(x, y) ? hueReach : edgeReach);
            m_covered(y, x) = coveredPart(w, sums, part.x0 + x, part.y0 + y, region.at(x, y) ? 1.0F : 0.0F);
        });
    }
    const Sums &all = sumsRow(m_height)[m_width];
    m_meanChroma = Chroma(signedSum(all[uInside]), signedSum(all[vInside])) / double(ComparedWindow::chromaUnit * float(std::max(1U, all[inside])));
    const PixelRect box = near.bounds();
    findPoints(PixelRect{box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1}.clipped({0, 0, m_width, m_height}), {w.rect().x0 + part.x0, w.rect().y0 + part.y0});
}

RegionEdge::Sums *RegionEdge::sumsRow(int y)
{
    return m_sums.data() + std::ptrdiff_t(y % sumRows) * (m_width + 1);
}

/// Of all rows before a row they are known; makes those with it.
void RegionEdge::sumUp(const ComparedWindow &w, const BitMask &shade, const PixelRect &part, const BitMask &core, const BitMask &near, int y)
{
    for (std::vector<std::uint8_t> *row : {&m_isCore, &m_isNear, &m_isShade})
        row->resize(std::size_t(m_width));
    core.copyRow(y, 0, m_width, m_isCore.data());
    near.copyRow(y, 0, m_width, m_isNear.data());
    shade.copyRow(y, 0, m_width, m_isShade.data());
    const std::uint8_t *luma = w.lumaRow(part.y0 + y) + part.x0;
    const std::int16_t *u = w.uRow(part.y0 + y) + part.x0, *v = w.vRow(part.y0 + y) + part.x0;
    const Sums *above = sumsRow(y);
    Sums *sums = sumsRow(y + 1), row{};
    sums[0] = row;
    for (int x = 0; x < m_width; ++x) {
        const auto at = std::size_t(x);
        if (m_isCore[at]) {
            row[inside] += 1;
            row[lumaInside] += std::uint32_t(luma[x] - w.gain().black);
            row[uInside] += std::uint32_t(std::int32_t(u[x]));
            row[vInside] += std::uint32_t(std::int32_t(v[x]));
        } else if (!m_isNear[at]) {
            row[outside] += 1;
            row[lightOutside] += std::uint32_t(m_isShade[at] ? lightUnit * w.seen(part.x0 + x, part.y0 + y).luma / w.behind(part.x0 + x, part.y0 + y).luma : lightUnit);
        }
        for (std::size_t k = 0; k < row.size(); ++k)
            sums[x + 1][k] = above[x + 1][k] + row[k];
    }
}

/// Of the square around a pixel that reaches so far to each side.
RegionEdge::Sums RegionEdge::around(int x, int y, int reach)
{
    const int left = std::max(0, x - reach), right = std::min(m_width, x + reach + 1);
    const Sums *above = sumsRow(std::max(0, y - reach)), *below = sumsRow(std::min(m_height, y + reach + 1));
    Sums sums;
    for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] = below[right][k] - below[left][k] - above[right][k] + above[left][k];
    return sums;
}

void RegionEdge::findPoints(const PixelRect &box, const Eigen::Vector2d &origin)
{
    m_points.clear();
    const auto walk = [&](int from, int to, int first, int last, const auto &valueAt, const auto &pointAt) {
        for (int line = from; line < to; ++line) {
            for (const int step : {1, -1}) {
                float before = 0;
                const int begin = step > 0 ? first : last - 1, end = step > 0 ? last : first - 1;
                for (int at = begin; at != end; at += step) {
                    const float here = valueAt(line, at);
                    if (here >= half) {
                        const double back = at != begin ? double((here - half) / (here - before)) : 0;
                        m_points.push_back(origin + pointAt(line, at - step * back));
                        break;
                    }
                    before = here;
                }
            }
        }
    };
    walk(box.y0, box.y1, box.x0, box.x1, [&](int y, int x) { return m_covered(y, x); }, [](int y, double x) { return Eigen::Vector2d(x, y); });
    walk(box.x0, box.x1, box.y0, box.y1, [&](int x, int y) { return m_covered(y, x); }, [](int x, double y) { return Eigen::Vector2d(x, y); });
}

} // namespace odo
