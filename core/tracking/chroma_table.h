// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/chroma_density.h"

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

private:
    std::array<std::uint8_t, ChromaDensity::binCount> m_weights{};
};

} // namespace odo
