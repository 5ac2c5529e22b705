// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/chroma_table.h"

#include <algorithm>

namespace odo {

ChromaTable::ChromaTable(const ChromaDensity &robot, const ChromaDensity &background, float doubt)
{
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin) {
        const float likelihood = robot[bin];
        const float all = likelihood + background[bin] + doubt;
        m_weights[bin] = all > 0 ? static_cast<std::uint8_t>(255.0f * likelihood / all + 0.5f) : 0;
    }
    findBox();
}

void ChromaTable::findBox()
{
    constexpr std::size_t n = ChromaDensity::binsPerAxis;
    std::array<std::uint8_t, n> mostOfU{}, mostOfV{}; // weights
    for (std::size_t u = 0; u < n; ++u) {
        const std::uint8_t *weights = &m_weights[u * n];
        mostOfU[u] = *std::max_element(weights, weights + n);
        for (std::size_t v = 0; v < n; ++v)
            mostOfV[v] = std::max(mostOfV[v], weights[v]);
    }
    setRange(mostOfU, m_leastU, m_rangeU);
    setRange(mostOfV, m_leastV, m_rangeV);
}

/// Of a table that takes nothing the range is a single bin: no harm.
void ChromaTable::setRange(const std::array<std::uint8_t, ChromaDensity::binsPerAxis> &most,
                           std::uint8_t &least, std::uint8_t &range)
{
    const auto isTaken = [](std::uint8_t weight) { return weight >= threshold; };
    const auto first = std::find_if(most.begin(), most.end(), isTaken);
    const auto beyond = std::find_if(most.rbegin(), most.rend(), isTaken).base();
    const auto bins = static_cast<int>(std::max<std::ptrdiff_t>(beyond - first, 1));
    const auto start = static_cast<int>(std::min<std::ptrdiff_t>(first - most.begin(), most.size() - 1));
    least = static_cast<std::uint8_t>(start << ChromaDensity::binShift);
    range = static_cast<std::uint8_t>((bins << ChromaDensity::binShift) - 1);
}

void ChromaTable::add(const ChromaTable &other)
{
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin)
        m_weights[bin] = std::max(m_weights[bin], other.m_weights[bin]);
    findBox();
}

} // namespace odo
