// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/region_edge.h"

#include "core/geometry/silhouette.h"
#include "core/tracking/internal/compared_window.h"
#include "core/tracking/internal/difference_windows.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

namespace odo {

namespace {

constexpr int patchReach = 3; // of the patches that are judged, pixels to each side
constexpr int patchRows = 2 * patchReach + 1, patchPixels = patchRows * patchRows;
constexpr int leastPatch = 16;     // pixels
constexpr int flatness = 4;        // the variance of the texture behind against that of what is seen
constexpr double clearTexture = 6; // its variance against the noise's
// code values, of a patch's mean chroma against that of the floor in shadow
constexpr float otherHue = 2.2F;
constexpr double codedChroma = 0.05; // of the chroma's variation about a pixel: by which a codec errs
constexpr double mostMirrored = 0.2; // of a floor's luma: what it mirrors of the room
constexpr float logUnit = 1024;      // of the fixed-point sums: finer than the steps of code values
constexpr int hueUnit = 256;
constexpr std::int64_t ratioUnit = 1 << 30,
                       ratioPerHue = ratioUnit * int(ComparedWindow::chromaUnit) / hueUnit;

// A log sum holds three sums in one number: of the logarithms of luma above black in units of 1 / logUnit
// (the upper bits), of the pixels (6 bits), and of the squares of the logarithms (the lower 32 bits). A patch
// is too small for one to run into the next.
constexpr int pixelsShift = 32, logShift = 38;
static_assert(patchPixels < 1 << (logShift - pixelsShift));

/// The log sum of one pixel, for each luma above black.
std::array<std::uint64_t, 256> makeLogSums()
{
    std::array<std::uint64_t, 256> sums{};
    for (std::size_t i = 1; i < sums.size(); ++i) {
        const auto log = std::uint64_t(std::lround(logUnit * std::log(float(i))));
        sums[i] = (log << logShift) + (std::uint64_t(1) << pixelsShift) + log * log;
    }
    return sums;
}

std::size_t pixelsIn(std::uint64_t logSum)
{
    return (logSum >> pixelsShift) % (1U << (logShift - pixelsShift));
}

/// n² times the variance of n logarithms.
std::int64_t scaledVariance(std::size_t n, std::uint64_t logSum)
{
    const auto sum = std::int64_t(logSum >> logShift), squares = std::int64_t(std::uint32_t(logSum));
    return std::int64_t(n) * squares - sum * sum;
}

/// By how much the summed chroma of n pixels of the floor's own hue may be off.
constexpr auto mostOff = [] {
    std::array<std::int64_t, patchPixels + 1> most{};
    for (std::size_t n = 0; n < most.size(); ++n)
        most[n] = std::int64_t(otherHue * float(hueUnit) * float(n));
    return most;
}();

/// How much the background's chroma varies about a pixel, as far as its patch reaches.
float chromaTexture(const ComparedWindow &window, int x, int y)
{
    const PixelColour here = window.behind(x, y);
    float most = 0;
    for (const int cy : {std::max(0, y - patchReach), std::min(window.height() - 1, y + patchReach)}) {
        for (const int cx : {std::max(0, x - patchReach), std::min(window.width() - 1, x + patchReach)}) {
            const PixelColour corner = window.behind(cx, cy);
            most = std::max({most, std::abs(corner.u - here.u), std::abs(corner.v - here.v)});
        }
    }
    return most;
}

/// Whether the summed chroma of n pixels is off that of the floor in shadow by more than its own, than
/// shadows are tinted, and than a codec errs where the floor's chroma varies. A glossy floor mirrors neutral
/// light of the room; where a dark robot is mirrored instead, that is missing, and the floor's hue is purer
/// than in shadow.
bool isOtherHue(const ComparedWindow &window, std::size_t n, std::int64_t offU, std::int64_t offV, int x,
                int y)
{
    if (std::max(std::abs(offU), std::abs(offV)) <= mostOff[n])
        return false;
    const PixelColour seen = window.seen(x, y), behind = window.behind(x, y);
    const Chroma off{double(offU), double(offV)}, hue = hueUnit * double(n) * Chroma(behind.u, behind.v);
    const double darker = 1 - double(seen.luma) / std::max(1.0, double(behind.luma)),
                 purer = std::clamp(off.dot(hue) / std::max(1.0, hue.squaredNorm()), 0.0,
                                    std::clamp(darker, 0.0, mostMirrored));
    const double tint = window.shadow().tint * std::max(0.0, double(behind.luma) - double(seen.luma)),
                 coded = codedChroma * double(chromaTexture(window, x, y));
    return (off - purer * hue).cwiseAbs().maxCoeff() >
           double(mostOff[n]) + hueUnit * double(n) * (tint + coded);
}

} // namespace

void FloorShade::Sums::add(const Sums &other)
{
    seen += other.seen;
    behind += other.behind;
    offU += other.offU;
    offV += other.offV;
}

void FloorShade::Sums::remove(const Sums &other)
{
    seen -= other.seen;
    behind -= other.behind;
    offU -= other.offU;
    offV -= other.offV;
}

void FloorShade::find(const ComparedWindow &window)
{
    m_shade = window.darkened();
    m_byHue.reset(m_shade.width(), m_shade.height());
    readGain(window.gain());
    m_columns.assign(std::size_t(m_shade.width() + 2 * patchReach), {});
    m_rows.resize(patchRows);
    for (std::vector<Sums> &row : m_rows)
        row.resize(std::size_t(m_shade.width()));
    const PixelRect box = m_shade.bounds();
    for (int y = box.y0; y < box.y1 + patchReach; ++y) {
        if (y - patchRows >= box.y0)
            removeRow(window, y - patchRows); // the one above the patch of the row judged now
        if (y < box.y1)
            takeRow(window, y);
        if (y - patchReach >= box.y0)
            judgeRow(window, y - patchReach);
    }
}

/// Divides once for each luma instead of for each pixel.
void FloorShade::readGain(const LightGain &gain)
{
    for (int i = 0; i < int(m_perLuma.size()); ++i)
        m_perLuma[std::size_t(i)] = std::int32_t(float(ratioUnit) / std::max(1.0F, gain.factor * float(i)));
}

std::vector<FloorShade::Sums> &FloorShade::rowAt(int y)
{
    return m_rows[std::size_t(y) % patchRows];
}

void FloorShade::removeRow(const ComparedWindow &window, int y)
{
    const Sums *sums = rowAt(y).data();
    Sums *columns = m_columns.data() + patchReach;
    window.darkened().forEachInRow(y, [&](int x) { columns[x].remove(sums[x]); });
}

/// Adds a row to the columns. Floor in shadow has the chroma of the background times the ratio of luma as
/// seen to that of the background.
void FloorShade::takeRow(const ComparedWindow &window, int y)
{
    static const std::array<std::uint64_t, 256> logSums = makeLogSums();
    const auto black = std::size_t(window.gain().black);
    const std::uint8_t *luma = window.lumaRow(y), *lumaBehind = window.lumaBehindRow(y);
    const std::int16_t *u = window.uRow(y), *v = window.vRow(y), *uBehind = window.uBehindRow(y),
                       *vBehind = window.vBehindRow(y);
    const auto off = [](std::int64_t seen, std::int64_t behind, std::int64_t ratio) {
        return (ratioUnit * seen - ratio * behind) / ratioPerHue;
    };
    Sums *sums = rowAt(y).data(), *columns = m_columns.data() + patchReach;
    window.darkened().forEachInRow(y, [&](int x) {
        // both above 0; the gain would add to all logarithms, and to no variance
        const std::size_t now = luma[x] - black, before = lumaBehind[x] - black;
        const std::int64_t ratio = std::int64_t(now) * m_perLuma[before]; // of luma
        sums[x] = {logSums[now], logSums[before], off(u[x], uBehind[x], ratio), off(v[x], vBehind[x], ratio)};
        columns[x].add(sums[x]);
    });
}

/// Takes from the shade what the patch around it shows to be none.
void FloorShade::judgeRow(const ComparedWindow &window, int y)
{
    Sums sums;
    int next = -1; // the pixel whose patch the sums hold, save for its last column
    window.darkened().forEachInRow(y, [&](int x) {
        const Sums *patch = m_columns.data() + x; // its first column
        if (x != next) {
            sums = {};
            for (int i = 0; i < patchRows - 1; ++i)
                sums.add(patch[i]);
        }
        sums.add(patch[patchRows - 1]);
        judge(window, sums, x, y);
        sums.remove(patch[0]);
        next = x + 1;
    });
}

/// Compares the variances of the logarithms, which a shadow's factor leaves as they are.
inline void FloorShade::judge(const ComparedWindow &window, const Sums &sums, int x, int y)
{
    const std::size_t n = pixelsIn(sums.seen);
    if (n < leastPatch)
        return;
    if (isOtherHue(window, n, sums.offU, sums.offV, x, y)) {
        m_byHue.set(x, y);
        m_shade.clear(x, y);
        return;
    }
    const std::int64_t varianceBehind = scaledVariance(n, sums.behind);
    if (flatness * scaledVariance(n, sums.seen) >= varianceBehind)
        return;
    const float luma = std::max(1.0F, window.seen(x, y).luma);
    if (double(varianceBehind) * double(squared(luma)) >
        clearTexture * double(n * n) * double(squared(logUnit) * window.lumaNoise2(x, y)))
        m_shade.clear(x, y);
}

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
    findPoints(all.near, {w.rect().x0 + part.x0, w.rect().y0 + part.y0});
}

/// Adds pixels on the edge, with both sides of it in the square around each that reaches so far.
void RegionEdge::addEdge(const Surroundings &all, const BitMask &edge, int reach)
{
    const BitMask around = edge.grown(reach), outside = around - all.near;
    const Summed summed{all.core & around, outside - all.shaded, outside & all.shaded};
    const PixelRect box = edge.bounds();
    m_columns.assign(std::size_t(edge.width() + 2 * reach), {});
    // the sums are as far ahead as is read
    for (int y = std::max(0, box.y0 - reach); y < box.y1 + reach; ++y) {
        if (y < edge.height())
            sumUp(all, summed, y, reach, [](std::int32_t &sum, int value) { sum += value; });
        const int row = y - reach, left = row - reach - 1;
        if (left >= 0)
            sumUp(all, summed, left, reach, [](std::int32_t &sum, int value) { sum -= value; });
        if (row >= 0)
            addEdgeRow(all, edge, reach, row);
    }
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
    summed.shaded.forEachInRow(y, [&](int x) {
        const PixelColour seen = w.seen(left + x, top + y), behind = w.behind(left + x, top + y);
        const float light = seen.luma / behind.luma;
        change(columns[x][E::outsideCount], 1);
        change(columns[x][E::outsideLight], int(float(E::lightUnit) * light));
        change(columns[x][E::outsideTintU], int((seen.u - light * behind.u) * ComparedWindow::chromaUnit));
        change(columns[x][E::outsideTintV], int((seen.v - light * behind.v) * ComparedWindow::chromaUnit));
    });
}

void RegionEdge::addEdgeRow(const Surroundings &all, const BitMask &edge, int reach, int y)
{
    const ComparedWindow &w = all.window;
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
        pixels.at[pixels.count++] = std::size_t(y * edge.width() + x);
    });
    const int left = all.part.x0 - y * edge.width(), row = all.part.y0 + y;
    for (std::size_t i = first; i < pixels.count; ++i) {
        const PixelColour seen = w.seen(left + int(pixels.at[i]), row),
                          behind = w.behind(left + int(pixels.at[i]), row);
        pixels.luma[i] = seen.luma;
        pixels.u[i] = seen.u;
        pixels.v[i] = seen.v;
        pixels.lumaBehind[i] = behind.luma;
        pixels.uBehind[i] = behind.u;
        pixels.vBehind[i] = behind.v;
    }
    for (std::size_t i = first; i < pixels.count; ++i) {
        pixels.lumaNoise2[i] = w.lumaNoise2(left + int(pixels.at[i]), row);
        pixels.chromaNoise2[i] = w.chromaNoise2(left + int(pixels.at[i]), row);
    }
}

/// Fills in what the region covers of each pixel: on the edge as was found where its sides differ, otherwise
/// all or nothing.
void RegionEdge::cover(const BitMask &region)
{
    m_covered.create(region.height(), region.width());
    for (int y = 0; y < region.height(); ++y) {
        std::fill_n(m_covered[y], region.width(), 0.0F);
        region.forEachRunInRow(
            y, [&](int x0, int x1) { std::fill(m_covered[y] + x0, m_covered[y] + x1, 1.0F); });
    }
    float *covered = m_covered[0];
    for (std::size_t i = 0; i < m_edge.count; ++i)
        if (const auto [part, clearness] = m_edge.found[i]; clearness >= 0)
            covered[m_edge.at[i]] = std::clamp(part, 0.0F, 1.0F);
}

void RegionEdge::findPoints(const BitMask &near, const Eigen::Vector2d &origin)
{
    m_points.clear();
    // Of lines from one end, each from the pixel before the first that may belong to the region as far as
    // there is such; turn: 1 or −1, to which side a hull turns that goes from line to line.
    const auto walk = [&](int from, int to, double turn, int step, const auto &spanOf, const auto &valueAt,
                          const auto &pointAt) {
        const std::size_t first = m_points.size();
        for (int line = from; line < to; ++line) {
            const auto [low, high] = spanOf(line);
            const int begin = step > 0 ? low : high - 1, end = step > 0 ? high : low - 1;
            float before = 0;
            for (int at = begin; at != end; at += step) {
                const float here = valueAt(line, at);
                if (here >= half) {
                    const double back = at != begin ? double((here - half) / (here - before)) : 0;
                    addToChain(m_points, first, turn, origin + pointAt(line, at - step * back));
                    break;
                }
                before = here;
            }
        }
    };
    const PixelRect box = near.bounds();
    const auto inRow = [&](int y, int x) { return m_covered(y, x); };
    const auto inColumn = [&](int x, int y) { return m_covered(y, x); };
    const auto onRow = [](int y, double x) { return Eigen::Vector2d(x, y); };
    const auto onColumn = [](int x, double y) { return Eigen::Vector2d(x, y); };
    const auto ofRow = [&](int y) {
        const int last = near.lastSet(near.width(), y);
        return last < 0 ? std::pair(0, 0)
                        : std::pair(std::max(0, near.nextSet(0, y) - 1), std::min(near.width(), last + 2));
    };
    const auto ofColumn = [&](int) {
        return std::pair(std::max(0, box.y0 - 1), std::min(near.height(), box.y1 + 1));
    };
    walk(box.y0, box.y1, -1, 1, ofRow, inRow, onRow);
    walk(box.y0, box.y1, 1, -1, ofRow, inRow, onRow);
    walk(box.x0, box.x1, 1, 1, ofColumn, inColumn, onColumn);
    walk(box.x0, box.x1, -1, -1, ofColumn, inColumn, onColumn);
}

} // namespace odo
