// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/internal/searched_mask.h"

#include <algorithm>
#include <cmath>

namespace odo {

namespace {

/// Adds the samples of a polygon row by row, between the edges that cross the row.
void addPolygon(const PixelPolygon &polygon, const SampleLattice &lattice, BitMask &into)
{
    std::vector<double> crossings;
    for (int row = 0; row < lattice.rows; ++row) {
        const double y = lattice.firstPx.y() + row * lattice.stepPx.y();
        crossings.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            if ((a.y() > y) != (b.y() > y))
                crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
        std::ranges::sort(crossings);
        const auto columnFrom = [&](double x) {
            const double column = std::ceil((x - lattice.firstPx.x()) / lattice.stepPx.x());
            return int(std::clamp(column, 0.0, double(lattice.columns)));
        };
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int first = columnFrom(crossings[i]), end = columnFrom(crossings[i + 1]);
            if (first < end)
                into.setRun(row, first, end);
        }
    }
}

BitMask samplesIn(const std::vector<PixelPolygon> &polygons, const SampleLattice &lattice)
{
    BitMask samples(lattice.columns, lattice.rows);
    for (const PixelPolygon &polygon : polygons)
        addPolygon(polygon, lattice, samples);
    return samples;
}

} // namespace

BitMask searchedSamples(const SearchedArea &area, const SampleLattice &lattice)
{
    BitMask searched = area.search.empty() ? BitMask(lattice.columns, lattice.rows).complement()
                                           : samplesIn(area.search, lattice);
    return searched -= samplesIn(area.ignored, lattice);
}

bool isCutBy(const BitMask &searched, const BitMask &set, int offsetX, int offsetY)
{
    const BitMask around = set.grown();
    bool isCut = false;
    for (int y = 0; y < around.height() && !isCut; ++y) {
        const int row = offsetY + y;
        if (row < 0 || row >= searched.height())
            continue;
        around.forEachInRow(y, [&](int x) {
            const int column = offsetX + x;
            isCut |= column >= 0 && column < searched.width() && !searched.at(column, row);
        });
    }
    return isCut;
}

} // namespace odo
