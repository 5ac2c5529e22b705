// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/bit_mask.h"

#include <span>
#include <vector>

namespace odo {

/// Pixels of a row from x0 up to, not including, x1.
struct PixelRun
{
    int y = 0, x0 = 0, x1 = 0;
};

/// Pixels that hang together: their runs from top to bottom, each row's from left to right.
using ConnectedPart = std::span<const PixelRun>;

/// The parts of a set, the one with the topmost pixel first. Holds their runs.
class ConnectedParts
{
public:
    ConnectedParts() = default;
    /// Runs part by part; ends: of each part, how many runs there are up to its last.
    ConnectedParts(std::vector<PixelRun> runs, const std::vector<std::size_t> &ends);
    ConnectedParts(const ConnectedParts &) = delete;
    ConnectedParts &operator=(const ConnectedParts &) = delete;
    ConnectedParts(ConnectedParts &&) noexcept = default;
    ConnectedParts &operator=(ConnectedParts &&) noexcept = default;

    std::size_t size() const { return m_parts.size(); }
    bool empty() const { return m_parts.empty(); }
    const ConnectedPart &operator[](std::size_t i) const { return m_parts[i]; }
    auto begin() const { return m_parts.begin(); }
    auto end() const { return m_parts.end(); }

private:
    std::vector<PixelRun> m_runs;
    std::vector<ConnectedPart> m_parts; ///< of the runs
};

/// Pixels that only touch at a corner hang together. Pure.
ConnectedParts connectedParts(const BitMask &set);
PixelRect boundsOf(const ConnectedPart &part);
bool contains(const ConnectedPart &part, int x, int y);

/// Whether a part encloses pixels that do not belong to it. Pure.
bool enclosesAny(const ConnectedPart &part);
/// The set and all of the image that it encloses. Pure.
BitMask withoutHoles(const BitMask &set);

} // namespace odo
