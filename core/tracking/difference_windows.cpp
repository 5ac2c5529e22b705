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

/// In each band a window is as wide as what was found in the rows near by.
std::vector<DifferenceWindow::Band> bandsOf(const BitMask &found, const PixelRect &rect)
{
    constexpr int step = DifferenceLattice::step, reach = windowMargin / step;
    const int first = rect.y0 / step, count = (rect.height() + step - 1) / step, width = rect.width();
    const int left = rect.x0 / step, right = std::min(found.width(), (rect.x1 + step - 1) / step);
    std::vector<DifferenceWindow::Band> bands(std::size_t(count), {width, 0, 0, 0});
    for (int row = std::max(0, first); row < std::min(found.height(), first + count); ++row) {
        const int begin = found.nextSet(left, row), end = found.lastSet(right, row) + 1;
        if (begin >= end)
            continue;
        for (int i = std::max(0, row - first - reach); i <= std::min(count - 1, row - first + reach); ++i) {
            DifferenceWindow::Band &band = bands[std::size_t(i)];
            band.begin = std::min(band.begin, std::max(0, begin * step - rect.x0 - windowMargin));
            band.end = std::max(band.end, std::min(width, end * step - rect.x0 + windowMargin));
        }
    }
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const DifferenceWindow::Band &above = bands[i > 0 ? i - 1 : 0], &below = bands[std::min(i + 1, bands.size() - 1)];
        const int begin = std::max({above.begin, bands[i].begin, below.begin}), end = std::min({above.end, bands[i].end, below.end});
        bands[i].safeBegin = begin > 0 ? begin + DifferenceWindow::safePx : 0;
        bands[i].safeEnd = std::max(bands[i].safeBegin, end < width ? end - DifferenceWindow::safePx : width);
    }
    return bands;
}

} // namespace

std::vector<std::vector<DifferenceWindow>> windowsAround(const BitMask &differences, const PixelRect &picture)
{
    // One or two samples are noise; those that are two apart belong together.
    constexpr int step = DifferenceLattice::step;
    const BitMask found = differences.crowded().grown();
    std::vector<PixelRect> windows, wide;
    for (const ConnectedPart &part : connectedParts(found)) {
        const PixelRect cells = boundsOf(part), box{cells.x0 * step, cells.y0 * step, cells.x1 * step, cells.y1 * step};
        windows.push_back(grownBy(box, windowMargin, picture));
        wide.push_back(grownBy(box, nearMargin, picture));
    }
    windows = merged(windows);
    std::vector<std::vector<DifferenceWindow>> groups;
    for (const PixelRect &around : merged(wide)) {
        groups.emplace_back();
        for (const PixelRect &window : windows)
            if (around.meets(window))
                groups.back().push_back({window, bandsOf(found, window)});
    }
    return groups;
}

} // namespace odo
