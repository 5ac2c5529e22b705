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
}

void ChromaTable::add(const ChromaTable &other)
{
    for (std::size_t bin = 0; bin < ChromaDensity::binCount; ++bin)
        m_weights[bin] = std::max(m_weights[bin], other.m_weights[bin]);
}

} // namespace odo
