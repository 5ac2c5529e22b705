// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma_density.h"

#include <cstring>

namespace odo {

/// For each chroma bin the probability (0 to 255) that a sample of it is the robot's, the robot and the rest
/// being equally likely beforehand. What the hot loops look into.
class ChromaTable
{
public:
    static constexpr std::uint8_t threshold = 128; ///< at least this is taken as the robot's

    ChromaTable() = default;
    /// Weight = F/(F + B + doubt): robot and background as densities that sum to about one; doubt is what a
    /// chroma that was never seen at all has against it.
    ChromaTable(const ChromaDensity &robot, const ChromaDensity &background, float doubt);

    /// Takes what either table takes.
    void add(const ChromaTable &other);

    std::uint8_t weight(std::uint8_t u, std::uint8_t v) const
    {
        return m_weights[ChromaDensity::binOf(u, v)];
    }

    static constexpr int blockSamples = 16;
    /// Whether any of so many samples side by side may be the robot's: false spares looking at each.
    bool mayTakeBlock(const std::uint8_t *u, const std::uint8_t *v) const
    {
        using Bytes = std::uint8_t __attribute__((vector_size(blockSamples)));
        using Longs = std::uint64_t __attribute__((vector_size(blockSamples)));
        Bytes us, vs;
        std::memcpy(&us, u, sizeof(us));
        std::memcpy(&vs, v, sizeof(vs));
        const auto any = reinterpret_cast<Longs>((us - m_leastU <= m_rangeU) & (vs - m_leastV <= m_rangeV));
        return (any[0] | any[1]) != 0;
    }

private:
    void findBox();
    static void setRange(const std::array<std::uint8_t, ChromaDensity::binsPerAxis> &most,
                         std::uint8_t &least, std::uint8_t &range);

    std::array<std::uint8_t, ChromaDensity::binCount> m_weights{};
    std::uint8_t m_leastU = 0, m_rangeU = 0, m_leastV = 0, m_rangeV = 0; ///< code values of all that is taken
};

} // namespace odo
