// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/edge_finder.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr float leastRoom = 5;     ///< luma pixels of the region on a line
constexpr float leastContrast = 6; ///< code values
constexpr int chromaReach = 8;     ///< luma pixels on both sides of the start
constexpr float farthest = 4;      ///< of the edge from the start
constexpr float mostLag = 1.5f;    ///< of the luma's edge from the chroma's
constexpr float mostReach = 8;     ///< of the luma on both sides of the position
constexpr int searchesPerSharpness = 3, leastSharpnesses = 6;
constexpr float chromaHalfWidth = 2; ///< luma pixels: what its filter and its samples blur
constexpr float sharpHalfWidth = 0.75f, sharpReference = 0.75f;
constexpr float slopeWidth = 0.4f; ///< more half width for an edge at 45°, which is the most
constexpr float exposureShare =
    0.05f; ///< of the time between two frames: much of the blur is symmetric and needs no margin
constexpr double colourLength = 256; ///< of a whole-numbered vector along the robot's colour
constexpr float mostMotion = 2;      ///< luma pixels of margin for it

/// Without the call that the library's costs.
int floorOf(float value)
{
    const int towardsZero = static_cast<int>(value);
    return towardsZero - (static_cast<float>(towardsZero) > value ? 1 : 0);
}

} // namespace

EdgeFinder::LinedPlane::LinedPlane(const PlaneView &plane, bool alongX)
    : data(plane.data), along(alongX ? 1 : plane.stride), across(alongX ? plane.stride : 1)
{
}

EdgeFinder::Direction EdgeFinder::directionOf(const Frame &frame, const ChromaGrid &grid,
                                              const OutlineHint &hint, const Eigen::Vector2d &lagPx,
                                              bool alongX)
{
    const int along = alongX ? 0 : 1, across = 1 - along;
    Direction direction;
    direction.u = LinedPlane(grid.u, alongX);
    direction.v = LinedPlane(grid.v, alongX);
    direction.y = LinedPlane(frame.y, alongX);
    direction.samples = alongX ? grid.u.width : grid.u.height;
    direction.lumaSamples = alongX ? frame.y.width : frame.y.height;
    direction.lumaLines = alongX ? frame.y.height : frame.y.width;
    direction.spacing = static_cast<int>(grid.scale[along]);
    direction.pitch = static_cast<int>(grid.scale[across]);
    direction.offset = static_cast<float>(grid.offset[along]);
    direction.shift =
        0.5f * static_cast<float>(direction.pitch - 1) - static_cast<float>(grid.offset[across]);
    direction.lagAlong = static_cast<float>(lagPx[along]);
    direction.lagAcross = static_cast<float>(lagPx[across]);
    direction.motionAlong = static_cast<float>(hint.motionPx[along]);
    direction.motionAcross = static_cast<float>(hint.motionPx[across]);
    return direction;
}

void EdgeFinder::begin(const Frame &frame, const ChromaGrid &grid, const OutlineHint &hint,
                       const Eigen::Vector2d &lagPx)
{
    // Of a step blurred by a Gaussian, references so near show the share erf(x) of the contrast; they are put
    // where they would show nine tenths.
    m_blur = std::max(0.0f, 0.9f - m_sharpness) * 4.0f;
    m_rows = directionOf(frame, grid, hint, lagPx, true);
    m_columns = directionOf(frame, grid, hint, lagPx, false);
    // As many samples for every line as the one needs that needs most: a loop of one length is foreseen.
    const float motion = std::min(mostMotion, exposureShare * static_cast<float>(hint.motionPx.lpNorm<1>()));
    const float reach = std::min(
        sharpHalfWidth + slopeWidth + m_blur + motion + 2 * sharpReference + m_blur + 2.0f, mostReach);
    m_lumaCount = static_cast<int>(2 * reach) + 2;
    const Chroma colour = colourLength * hint.colour.normalized();
    m_colourU = static_cast<int>(std::lround(colour.x()));
    m_colourV = static_cast<int>(std::lround(colour.y()));
    m_sharpnessSum = 0;
    m_sharpnessCount = 0;
    m_searches = 0;
}

EdgeFinder::Lines EdgeFinder::gather(const ScanLine *lines, int count) const
{
    Lines all{};
    for (int k = 0; k < EdgeProfiles::lines; ++k) {
        const ScanLine *line = lines + std::min(k, count - 1);
        all.line[static_cast<std::size_t>(k)] = line;
        all.direction[static_cast<std::size_t>(k)] = line->alongX ? &m_rows : &m_columns;
    }
    all.start = all.each([](const ScanLine &line, const Direction &) { return line.start; });
    all.inward =
        all.each([](const ScanLine &line, const Direction &) { return static_cast<float>(line.inward); });
    all.slope = all.each([](const ScanLine &line, const Direction &) { return line.slope; });
    all.margin = all.each([](const ScanLine &line, const Direction &) { return line.margin; });
    return all;
}

/// The samples of both chroma planes as one value: along the robot's colour. Returns which edges were found.
Int4 EdgeFinder::findInChroma(const Lines &lines, Float4 &positions) const
{
    EdgeProfiles chroma;
    for (int k = 0; k < EdgeProfiles::lines; ++k) {
        const ScanLine &line = *lines.line[static_cast<std::size_t>(k)];
        const Direction &direction = *lines.direction[static_cast<std::size_t>(k)];
        const auto spacing = static_cast<float>(direction.spacing);
        const int count = 2 * chromaReach / direction.spacing;
        const int first = floorOf((line.start - direction.offset) / spacing + 0.5f) - count / 2;
        if (line.margin < leastRoom || (line.line + 1) * direction.pitch > direction.lumaLines || first < 0 ||
            first + count > direction.samples) {
            chroma.setEmpty(k);
            continue;
        }
        const std::uint8_t *u = direction.u.at(line.line, first), *v = direction.v.at(line.line, first);
        chroma.set(k, static_cast<float>(first) * spacing + direction.offset, spacing,
                   static_cast<float>(1 / colourLength), count, [&](int i) {
                       return m_colourU * u[i * direction.u.along] + m_colourV * v[i * direction.v.along];
                   });
    }
    const Float4 most = 0.5f * lines.margin;
    EdgeSearch search{lines.inward, atMost(same(4), most), 2, false};
    const Float4 contrasts = moveToEdges(chroma, search, leastContrast, positions);
    search.halfWidth = atMost(same(3), most);
    moveToEdges(chroma, search, leastContrast, positions);
    // Once more with references as near as its blur allows: a narrow side of the robot is darker than the
    // rest.
    search.halfWidth = atMost(chromaHalfWidth + 0.5f * magnitudeOf(lines.slope) + m_blur, most);
    moveToEdges(chroma, search, leastContrast, positions);
    return contrasts >= leastContrast;
}

/// Moves the positions to the luma's edges near them. Returns which were found: none without contrast.
Int4 EdgeFinder::findInLuma(const Lines &lines, Float4 &positions)
{
    const Float4 motion =
        atMost(same(mostMotion),
               exposureShare * magnitudeOf(lines.each([](const ScanLine &line, const Direction &direction) {
                   return direction.motionAlong - line.slope * direction.motionAcross;
               })));
    EdgeSearch search;
    search.inward = lines.inward;
    search.halfWidth = atMost(sharpHalfWidth + slopeWidth * magnitudeOf(lines.slope) + m_blur + motion,
                              0.5f * lines.margin - 1);
    search.reference = sharpReference + 0.5f * m_blur;
    search.leadOn = true;
    EdgeProfiles luma;
    for (int k = 0; k < EdgeProfiles::lines; ++k) {
        const ScanLine &line = *lines.line[static_cast<std::size_t>(k)];
        const Direction &direction = *lines.direction[static_cast<std::size_t>(k)];
        const int first = floorOf(positions[k] - 0.5f * static_cast<float>(m_lumaCount - 2));
        if ((line.line + 1) * direction.pitch > direction.lumaLines || first < 0 ||
            first + m_lumaCount > direction.lumaSamples) {
            luma.setEmpty(k);
            continue;
        }
        // The mean of the (two middle) luma rows or columns that the line stands for.
        const std::uint8_t *y =
            direction.y.at(line.line * direction.pitch + (direction.pitch - 1) / 2, first);
        const std::uint8_t *beside = direction.pitch == 1 ? y : y + direction.y.across;
        luma.set(k, static_cast<float>(first), 1, 0.5f, m_lumaCount, [&](int i) {
            const std::ptrdiff_t at = i * direction.y.along;
            return y[at] + beside[at];
        });
    }
    const Float4 starts = positions;
    const Float4 before = moveToEdges(luma, search, leastContrast, positions),
                 after = moveToEdges(luma, search, leastContrast, positions);
    const Int4 found = (magnitudeOf(before) >= leastContrast) & (magnitudeOf(after) >= leastContrast) &
                       (magnitudeOf(positions - starts) <= mostLag);
    if (m_searches++ % searchesPerSharpness == 0)
        measureSharpness(luma, lines, positions, found & (motion < 0.5f) & (magnitudeOf(lines.slope) < 0.4f));
    return found;
}

void EdgeFinder::measureSharpness(const EdgeProfiles &luma, const Lines &lines, Float4 positions, Int4 wanted)
{
    const Float4 d = lines.inward;
    const Float4 wide = luma.mean(positions + d * 2.5f, positions + d * 4.0f) -
                        luma.mean(positions - d * 4.0f, positions - d * 2.5f);
    const Float4 close = luma.mean(positions + d * 0.75f, positions + d * 1.5f) -
                         luma.mean(positions - d * 1.5f, positions - d * 0.75f);
    const Float4 sharpness = atMost(atLeast(close / wide, same(0.3f)), same(1));
    wanted &= magnitudeOf(wide) > 2 * leastContrast;
    for (int k = 0; k < EdgeProfiles::lines; ++k) {
        if (wanted[k]) {
            m_sharpnessSum += sharpness[k];
            ++m_sharpnessCount;
        }
    }
}

void EdgeFinder::find(const ScanLine *lines, int count, LineEdge *edges)
{
    const Lines all = gather(lines, count);
    Float4 positions = all.start;
    const Int4 found = findInChroma(all, positions);
    // The chroma's row may differ from the luma's: along a slanted edge that is a shift.
    positions += all.each([](const ScanLine &line, const Direction &direction) {
        return direction.lagAlong + line.slope * (direction.shift - direction.lagAcross);
    });
    Float4 lumaPositions = positions;
    const Int4 byLuma = findInLuma(all, lumaPositions) & found;
    const Float4 lag = byLuma ? lumaPositions - positions : Float4{};
    const Float4 outward = found ? (all.start - positions - lag) * all.inward : Float4{};
    for (int k = 0; k < count; ++k) {
        edges[k].outward = outward[k];
        edges[k].lag = lag[k];
        edges[k].byLuma = byLuma[k] != 0;
        edges[k].good = found[k] != 0 && std::abs(outward[k]) < farthest;
    }
}

void EdgeFinder::learnSharpness()
{
    if (m_sharpnessCount >= leastSharpnesses)
        m_sharpness += 0.2f * (m_sharpnessSum / static_cast<float>(m_sharpnessCount) - m_sharpness);
}

} // namespace odo
