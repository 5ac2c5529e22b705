// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/difference_windows.h"

#include "core/tracking/connected_parts.h"
#include "core/tracking/difference_lattice.h"

namespace odo {

namespace {

constexpr int windowMargin = 12, nearMargin = 20; // luma pixels around what was found on the lattice

PixelRect grownBy(const PixelRect &rect, int margin, const PixelRect &picture)
{
    return PixelRect{rect.x0 - margin, rect.y0 - margin, rect.x1 + margin, rect.y1 + margin}.clipped(picture);
}

/// Rectangles that hold those given and do not overlap.
std::vector<PixelRect> merged(const std::vector<PixelRect> &rects)
{
    std::vector<PixelRect> apart;
    for (PixelRect rect : rects) {
        for (std::size_t i = 0; i < apart.size();) {
            if (!apart[i].meets(rect)) {
                ++i;
                continue;
            }
            rect = rect.united(apart[i]);
            apart.erase(apart.begin() + std::ptrdiff_t(i));
            i = 0;
        }
        apart.push_back(rect);
    }
    return apart;
}

} // namespace

std::vector<std::vector<PixelRect>> windowsAround(const BitMask &differences, const PixelRect &picture)
{
    // One or two samples are noise; those that are two apart belong together.
    constexpr int step = DifferenceLattice::step;
    std::vector<PixelRect> windows, wide;
    for (const ConnectedPart &part : connectedParts(differences.crowded().grown())) {
        const PixelRect cells = boundsOf(part);
        const PixelRect box{cells.x0 * step, cells.y0 * step, cells.x1 * step, cells.y1 * step};
        windows.push_back(grownBy(box, windowMargin, picture));
        wide.push_back(grownBy(box, nearMargin, picture));
    }
    windows = merged(windows);
    std::vector<std::vector<PixelRect>> groups;
    for (const PixelRect &around : merged(wide)) {
        groups.emplace_back();
        for (const PixelRect &window : windows)
            if (around.meets(window))
                groups.back().push_back(window);
    }
    return groups;
}

} // namespace odo
