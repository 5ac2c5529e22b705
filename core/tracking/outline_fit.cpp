// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/outline_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int mostLines = 160, leastLines = 16;
constexpr float leastWidth = 13;   ///< luma pixels: of a smaller region the two sides disturb one another
constexpr float leastRoom = 5;     ///< luma pixels of the region on a line
constexpr float leastShare = 0.4f; ///< of lines that found an edge
constexpr float leastContrast = 6; ///< code values
constexpr int chromaReach = 8;     ///< luma pixels on both sides of the start
constexpr float farthest = 4;      ///< of the edge from the start
constexpr float mostLag = 1.5f;    ///< of the luma's edge from the chroma's
constexpr float chromaSettled = 0.3f, lumaSettled = 0.1f; ///< moved by less it stays where it is
constexpr float chromaHalfWidth = 2;                      ///< luma pixels: what its filter and its samples blur
constexpr float stray = 2.5f;                             ///< of an edge from the median of its neighbours
constexpr float mostReach = 8;                            ///< of the luma on both sides of the place
constexpr int linesPerSharpness = 3, leastSharpnesses = 6;
constexpr float sharpHalfWidth = 0.75f, sharpReference = 0.75f;
constexpr float exposureShare =
    0.05f; ///< of the time between two frames: much of the blur is symmetric and needs no room
constexpr int fitsForLag = 100;
constexpr double leastLag = 0.25;               ///< luma pixels
constexpr double unknownVariance = 0.15 * 0.15; ///< of an edge, where there are too few to tell
constexpr double modelVariance = 0.01 * 0.01;

/// The samples of a chroma plane pair along a line, as one figure: along the robot's colour.
EdgeProfile chromaProfile(const ChromaGrid &grid, const ScanLine &line, int first, int count,
                          const Chroma &along)
{
    const auto spacing = static_cast<float>(line.alongX ? grid.scale.x() : grid.scale.y());
    const auto offset = static_cast<float>(line.alongX ? grid.offset.x() : grid.offset.y());
    EdgeProfile profile(static_cast<float>(first) * spacing + offset, spacing);
    const auto eu = static_cast<float>(along.x()), ev = static_cast<float>(along.y());
    const std::uint8_t *u = line.alongX ? grid.u.row(line.line) + first : grid.u.row(first) + line.line;
    const std::uint8_t *v = line.alongX ? grid.v.row(line.line) + first : grid.v.row(first) + line.line;
    const std::ptrdiff_t stepU = line.alongX ? 1 : grid.u.stride, stepV = line.alongX ? 1 : grid.v.stride;
    for (int i = 0; i < count; ++i, u += stepU, v += stepV)
        profile.add(eu * static_cast<float>(*u) + ev * static_cast<float>(*v));
    return profile;
}

/// The mean of the luma rows (or columns) that a line stands for.
EdgeProfile lumaProfile(const PlaneView &plane, const ScanLine &line, int first, int count, int lines)
{
    EdgeProfile profile(static_cast<float>(first), 1);
    const std::uint8_t *y =
        line.alongX ? plane.row(line.line * lines) + first : plane.row(first) + line.line * lines;
    const std::ptrdiff_t step = line.alongX ? 1 : plane.stride, across = line.alongX ? plane.stride : 1;
    const float scale = 1.0f / static_cast<float>(lines);
    for (int i = 0; i < count; ++i, y += step) {
        const int sum = lines == 1 ? *y : y[0] + y[across];
        profile.add(scale * static_cast<float>(sum));
    }
    return profile;
}

/// A polygon through points of a smooth curve cuts off a little of it at each chord: moved outwards by a
/// twelfth of the second difference its corners enclose the curve's own area (to the fourth order of the
/// pitch).
void roundOut(std::vector<Eigen::Vector2d> &points)
{
    Eigen::Vector2d before = points.back();
    const Eigen::Vector2d first = points.front();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d here = points[i], after = i + 1 < points.size() ? points[i + 1] : first;
        points[i] = here - (before - 2 * here + after) / 12;
        before = here;
    }
}

/// Without the call that the library's costs.
int floorOf(float value)
{
    const int towardsZero = static_cast<int>(value);
    return towardsZero - (static_cast<float>(towardsZero) > value ? 1 : 0);
}

/// An index about a ring, from less than once around outside of it.
std::size_t wrapped(int i, int n)
{
    return static_cast<std::size_t>(i < 0 ? i + n : i < n ? i : i - n);
}

float medianOf(std::vector<float> &values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

/// Sets the place to the luma's edge near it. False without contrast.
bool OutlineFit::locateInLuma(const Frame &frame, const ScanLine &line, int lines, float motion, float &place)
{
    // Of a step blurred by a Gaussian, references so near show the share erf(x) of the contrast; they are put
    // where they would show nine tenths.
    const float blur = blurBeyondSharp();
    EdgeSearch search;
    search.inward = static_cast<float>(line.inward);
    search.halfWidth =
        std::min(sharpHalfWidth + 0.4f * std::abs(line.slope) + blur + motion, 0.5f * line.room - 1);
    search.reference = sharpReference + 0.5f * blur;
    search.leadOn = true;
    const float reach = std::min(search.halfWidth + 2 * search.reference + 2.0f, mostReach);
    const int first = floorOf(place - reach);
    const int count = std::min(static_cast<int>(2 * reach) + 2, EdgeProfile::mostSamples);
    if (first < 0 || first + count > (line.alongX ? frame.y.width : frame.y.height))
        return false;
    const EdgeProfile luma = lumaProfile(frame.y, line, first, count, lines);
    const float start = place;
    float contrast = 0;
    for (int pass = 0; pass < 2; ++pass) {
        const float before = place;
        contrast = moveToEdge(luma, search, leastContrast, place);
        if (std::abs(contrast) < leastContrast || std::abs(place - start) > mostLag)
            return false;
        if (std::abs(place - before) < lumaSettled)
            break;
    }
    if (line.line % linesPerSharpness == 0 && motion < 0.5f && std::abs(line.slope) < 0.4f &&
        luma.covers(place - 4, place + 4)) {
        const float d = search.inward;
        const float wide =
            luma.mean(place + d * 2.5f, place + d * 4) - luma.mean(place - d * 4, place - d * 2.5f);
        const float close =
            luma.mean(place + d * 0.75f, place + d * 1.5f) - luma.mean(place - d * 1.5f, place - d * 0.75f);
        if (std::abs(wide) > 2 * leastContrast) {
            m_sharpnessSum += std::clamp(close / wide, 0.3f, 1.0f);
            ++m_sharpnessCount;
        }
    }
    return true;
}

OutlineFit::Edge OutlineFit::locate(const Frame &frame, const ChromaGrid &grid, const ScanLine &line,
                                    const OutlineHint &hint)
{
    Edge edge;
    const int s = static_cast<int>(line.alongX ? grid.scale.x() : grid.scale.y());
    const int lines = static_cast<int>(line.alongX ? grid.scale.y() : grid.scale.x());
    const auto offset = static_cast<float>(line.alongX ? grid.offset.x() : grid.offset.y());
    const int count = 2 * chromaReach / s;
    const int first = floorOf((line.start - offset) / static_cast<float>(s) + 0.5f) - count / 2;
    if (line.room < leastRoom || first < 0 || first + count > (line.alongX ? grid.u.width : grid.u.height) ||
        (line.line + 1) * lines > (line.alongX ? frame.y.height : frame.y.width))
        return edge;
    const EdgeProfile chroma = chromaProfile(grid, line, first, count, hint.colour);
    const float most = 0.5f * line.room;
    EdgeSearch search{static_cast<float>(line.inward), std::min(4.0f, most), 2, false};
    float place = line.start;
    if (moveToEdge(chroma, search, leastContrast, place) < leastContrast)
        return edge;
    if (std::abs(place - line.start) > chromaSettled) {
        search.halfWidth = std::min(3.0f, most);
        moveToEdge(chroma, search, leastContrast, place);
    }
    // Once more with references as near as its blur allows: a narrow side of the robot is darker than the rest.
    search.halfWidth = std::min(chromaHalfWidth + 0.5f * std::abs(line.slope) + blurBeyondSharp(), most);
    moveToEdge(chroma, search, leastContrast, place);
    // The chroma's row may lie beside the luma's: along a slanted edge that is a shift.
    const auto across = static_cast<float>(line.alongX ? grid.offset.y() : grid.offset.x());
    place += line.slope * (0.5f * static_cast<float>(lines - 1) - across);
    place += static_cast<float>(alongLine(line).dot(m_lag));
    const auto motion = static_cast<float>(line.alongX ? hint.motionPx.x() - line.slope * hint.motionPx.y()
                                                       : hint.motionPx.y() - line.slope * hint.motionPx.x());
    float lumaPlace = place;
    edge.byLuma =
        locateInLuma(frame, line, lines, std::min(2.0f, exposureShare * std::abs(motion)), lumaPlace);
    edge.lag = edge.byLuma ? lumaPlace - place : 0;
    edge.outward = ((edge.byLuma ? lumaPlace : place) - line.start) * -static_cast<float>(line.inward);
    edge.good = std::abs(edge.outward) < farthest;
    return edge;
}

void OutlineFit::putOutliersAside()
{
    constexpr int reach = 3;
    const int n = static_cast<int>(m_edges.size());
    m_near.clear();
    for (int i = 0; i < n; ++i) {
        const float own = m_edges[static_cast<std::size_t>(i)].outward;
        std::array<float, 2 * reach + 1> around;
        int count = 0;
        float least = own, most = own;
        for (int k = -reach; k <= reach; ++k) {
            const Edge &edge = m_edges[wrapped(i + k, n)];
            if (!edge.good)
                continue;
            around[static_cast<std::size_t>(count++)] = edge.outward;
            least = std::min(least, edge.outward);
            most = std::max(most, edge.outward);
        }
        // No edge strays from the median of such as lie closer together, whatever it is.
        if (count == 0 || most - least < stray) {
            m_near.push_back(own);
            continue;
        }
        const auto middle = around.begin() + count / 2;
        std::nth_element(around.begin(), middle, around.begin() + count);
        m_near.push_back(*middle);
    }
    for (int i = 0; i < n; ++i) {
        Edge &edge = m_edges[static_cast<std::size_t>(i)];
        edge.good = edge.good && std::abs(edge.outward - m_near[static_cast<std::size_t>(i)]) < stray;
    }
}

/// Where no edge was found the outline follows the hull, shifted as the nearest edges are.
void OutlineFit::fillGaps(const std::vector<ScanLine> &lines)
{
    const std::size_t n = lines.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (m_edges[i].good)
            continue;
        std::size_t before = 1, after = 1;
        while (!m_edges[(i + n - before) % n].good)
            ++before;
        while (!m_edges[(i + after) % n].good)
            ++after;
        const float part = static_cast<float>(before) / static_cast<float>(before + after);
        m_edges[i].outward =
            (1 - part) * m_edges[(i + n - before) % n].outward + part * m_edges[(i + after) % n].outward;
    }
}

/// Variance of one line's edge, for lines taken as independent: of what is left of a place when a cubic
/// through its neighbours is taken away, so that neither slope nor curvature counts.
double OutlineFit::varianceOfEdges(const std::vector<ScanLine> &lines)
{
    m_near.clear();
    m_far.clear();
    const int n = static_cast<int>(lines.size());
    const auto leftOver = [&](int i, int step) -> float {
        constexpr float weights[] = {-1.0f / 6, 4.0f / 6, -1, 4.0f / 6, -1.0f / 6};
        float sum = 0;
        for (int k = -2; k <= 2; ++k) {
            const std::size_t j = wrapped(i + k * step, n);
            if (!m_edges[j].good || lines[j].alongX != lines[static_cast<std::size_t>(i)].alongX ||
                lines[j].inward != lines[static_cast<std::size_t>(i)].inward)
                return -1;
            sum +=
                weights[k + 2] * (lines[j].start - static_cast<float>(lines[j].inward) * m_edges[j].outward);
        }
        return std::abs(sum);
    };
    for (int i = 0; i < n; ++i) {
        if (const float near = leftOver(i, 1); near >= 0)
            m_near.push_back(near);
        if (const float far = leftOver(i, 2); far >= 0)
            m_far.push_back(far);
    }
    if (m_near.size() < 6 || m_far.size() < 6)
        return unknownVariance;
    // A median is 0.6745 standard deviations; the weights' squares sum to 70/36.
    constexpr double toVariance = 36.0 / (0.6745 * 0.6745 * 70);
    const double near = std::pow(medianOf(m_near), 2), far = std::pow(medianOf(m_far), 2);
    return toVariance * near * std::clamp(far / std::max(near, 1e-6), 1.0, 4.0);
}

void OutlineFit::gather(const ChromaGrid &grid, const std::vector<ScanLine> &lines, Outline &outline)
{
    outline.points.clear();
    outline.found.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const ScanLine &line = lines[i];
        const Edge &edge = m_edges[i];
        const double perLine = line.alongX ? grid.scale.y() : grid.scale.x();
        const double across = line.line * perLine + 0.5 * (perLine - 1);
        const double along = static_cast<double>(line.start - static_cast<float>(line.inward) * edge.outward);
        outline.points.emplace_back(line.alongX ? along : across, line.alongX ? across : along);
        outline.found.push_back(edge.good);
    }
    roundOut(outline.points);
    outline.moments = polygonMoments(outline.points);
    // An edge that moves by δ sweeps the area δ · pitch, which draws the centre towards it.
    const double variance = varianceOfEdges(lines);
    outline.centreCovariance.setZero();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const double pitch = m_scanLines.stride() * (lines[i].alongX ? grid.scale.y() : grid.scale.x());
        const Eigen::Vector2d draw =
            (outline.points[i] - outline.moments.centrePx) * (pitch / outline.moments.areaPx2);
        outline.centreCovariance += variance * draw * draw.transpose();
    }
    outline.centreCovariance.diagonal().array() += modelVariance;
}

/// By how much a lag of the chroma plane moves the chroma's edge along a line.
Eigen::Vector2d OutlineFit::alongLine(const ScanLine &line)
{
    const auto slope = static_cast<double>(line.slope);
    return {line.alongX ? 1 : -slope, line.alongX ? -slope : 1};
}

/// The chroma's samples lie elsewhere than the stream says when its edges keep away from the luma's,
/// everywhere in the same direction. A siting is wrong by half a pixel or not at all; less is shading. What
/// all outlines up to this one say is put right in this one already.
void OutlineFit::learnLag(const std::vector<ScanLine> &lines)
{
    if (m_lagFits >= fitsForLag)
        return;
    ++m_lagFits;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!m_edges[i].good || !m_edges[i].byLuma)
            continue;
        const Eigen::Vector2d row = alongLine(lines[i]);
        m_lagNormal += row * row.transpose();
        m_lagRight += row * (static_cast<double>(m_edges[i].lag) + row.dot(m_lag));
    }
    if (!(m_lagNormal.determinant() > 1))
        return;
    const Eigen::Vector2d mean = m_lagNormal.inverse() * m_lagRight, before = m_lag;
    for (int axis = 0; axis < 2; ++axis)
        m_lag[axis] = std::abs(mean[axis]) > leastLag ? std::copysign(0.5, mean[axis]) : 0.0;
    if (m_lag == before)
        return;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto more = static_cast<float>(alongLine(lines[i]).dot(m_lag - before));
        if (!m_edges[i].byLuma)
            m_edges[i].outward -= more * static_cast<float>(lines[i].inward);
    }
}

bool OutlineFit::fit(const Frame &frame, const ChromaGrid &grid, const RegionMask &mask,
                     const OutlineHint &hint, Outline &outline)
{
    const std::vector<ScanLine> &lines = m_scanLines.layAround(mask, grid, mostLines);
    outline.goodShare = 0;
    outline.solidity = m_scanLines.solidity();
    if (m_scanLines.narrowestPx(grid) < leastWidth)
        return false;
    if (static_cast<int>(lines.size()) < leastLines)
        return false;
    OutlineHint unit = hint;
    unit.colour.normalize();
    m_edges.clear();
    m_sharpnessSum = 0;
    m_sharpnessCount = 0;
    for (const ScanLine &line : lines)
        m_edges.push_back(locate(frame, grid, line, unit));
    putOutliersAside();
    learnLag(lines);
    const auto good =
        std::count_if(m_edges.begin(), m_edges.end(), [](const Edge &edge) { return edge.good; });
    outline.goodShare = static_cast<double>(good) / static_cast<double>(lines.size());
    if (good < leastLines || outline.goodShare < static_cast<double>(leastShare))
        return false;
    if (m_sharpnessCount >= leastSharpnesses)
        m_sharpness += 0.2f * (m_sharpnessSum / static_cast<float>(m_sharpnessCount) - m_sharpness);
    fillGaps(lines);
    gather(grid, lines, outline);
    return outline.moments.areaPx2 > 0;
}

} // namespace odo
