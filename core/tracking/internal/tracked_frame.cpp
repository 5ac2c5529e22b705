// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/tracked_frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace odo {

namespace {

constexpr int mostSearchSamples = 160'000; ///< per plane and frame, in a whole-frame search
constexpr int mostCountedSamples = 20'000;

} // namespace

TrackedFrame::TrackedFrame(const Frame &frame) : m_frame(&frame), m_grid(frame)
{
    const double samples = static_cast<double>(m_grid.u.width) * m_grid.u.height;
    m_searchStep = std::max(1, static_cast<int>(std::ceil(std::sqrt(samples / mostSearchSamples))));
    m_countStep = std::max(1, static_cast<int>(std::ceil(std::sqrt(samples / mostCountedSamples))));
}

bool TrackedFrame::complete()
{
    if (!m_frame->validRegion)
        return true;
    auto whole = wholeFrame(*m_frame);
    if (!whole)
        return false;
    m_whole = std::move(*whole);
    m_frame = &*m_whole;
    m_grid = ChromaGrid(*m_frame);
    return true;
}

ChromaDensity TrackedFrame::backgroundWithout(const ChromaRect &rect)
{
    if (!m_counts) {
        m_counts.emplace();
        m_counts->count(m_grid, m_grid.bounds(), m_countStep);
    }
    ChromaDensity density = *m_counts;
    ChromaRect inside = rect.clippedTo(m_grid.bounds());
    if (!inside.isEmpty()) {
        // The same samples that were counted: on the same lattice.
        inside.left = (inside.left + m_countStep - 1) / m_countStep * m_countStep;
        inside.top = (inside.top + m_countStep - 1) / m_countStep * m_countStep;
        density.count(m_grid, inside, m_countStep, -1.0f);
    }
    density.normalise();
    density.blur(1);
    return density;
}

namespace {

bool rowsEqual(const PlaneView &a, const PlaneView &b, const PixelRect &part, int step)
{
    for (int y = part.y0; y < part.y1; y += step) {
        if (std::memcmp(a.row(y) + part.x0, b.row(y) + part.x0, static_cast<std::size_t>(part.width())) != 0)
            return false;
    }
    return true;
}

PixelRect partOf(const Frame &frame)
{
    return frame.validRegion.value_or(PixelRect{0, 0, frame.y.width, frame.y.height});
}

/// Whether two frames of one layout are equal where both are decoded.
bool framesEqual(const Frame &a, const Frame &b, int step)
{
    const PixelRect part = partOf(a).clipped(partOf(b));
    if (part.isEmpty())
        return true;
    const int shiftX = a.format.chromaShiftX, shiftY = a.format.chromaShiftY;
    const PixelRect chroma{part.x0 >> shiftX, part.y0 >> shiftY, (part.x1 + (1 << shiftX) - 1) >> shiftX,
                           (part.y1 + (1 << shiftY) - 1) >> shiftY};
    return rowsEqual(a.u, b.u, chroma, step) && rowsEqual(a.v, b.v, chroma, step) &&
           rowsEqual(a.y, b.y, part, step);
}

bool sameSize(const Frame &a, const Frame &b)
{
    return a.y.width == b.y.width && a.y.height == b.y.height && a.u.width == b.u.width &&
           a.u.height == b.u.height;
}

bool repeats(const Frame &last, const Frame &frame)
{
    if (!sameSize(last, frame) || !framesEqual(last, frame, 16) || !framesEqual(last, frame, 1))
        return false;
    if (!last.validRegion && !frame.validRegion)
        return true;
    const auto wholeLast = wholeFrame(last), whole = wholeFrame(frame);
    return wholeLast && whole && framesEqual(*wholeLast, *whole, 1);
}

} // namespace

bool DuplicateDetector::repeatsTheLast(const Frame &frame)
{
    const bool again = m_last && repeats(*m_last, frame);
    m_last = frame;
    return again;
}

void stamp(std::vector<Observation> &observations, const Frame &frame, bool repeats)
{
    for (Observation &observation : observations) {
        observation.frame = frame.index;
        observation.time = frame.time;
        observation.duplicateFrame = repeats;
    }
}

} // namespace odo
