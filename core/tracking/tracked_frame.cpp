// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/tracked_frame.h"

#include <algorithm>
#include <cmath>

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

} // namespace odo
