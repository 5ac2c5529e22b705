// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/rgb_picture.h"

#include <span>
#include <vector>

namespace odo {

/// The exact share of every pixel that polygons cover, each with a colour. Polygons of one layer add up: they
/// must not overlap (the faces of a body, the cells of a tag), or share the time (the sub-steps of an
/// exposure, each with a weight), so that seams between neighbours and blurred edges come out exactly.
///
/// Signed-area accumulation: each edge writes the change that it makes to the coverage of the pixels on its
/// row, and one running sum a row gives the coverage of all polygons at once (the method of FreeType's smooth
/// rasteriser and of font-rs). A pixel is the square of side 1 about its centre.
class PolygonLayer
{
public:
    explicit PolygonLayer(const PixelRect &rect);

    /// Adds a closed polygon, in luma pixels, in either orientation; parts outside the rectangle are cut off.
    void add(std::span<const Eigen::Vector2d> outline, const Rgb &colour, double weight = 1.0);
    /// Paints the layer over a picture. The layer is used up by it.
    void paintOver(RgbPicture &picture);

private:
    void addEdge(Eigen::Vector2d from, Eigen::Vector2d to, const Rgb &premultiplied);
    void addSpan(Rgb *row, double xa, double xb, double cover, const Rgb &premultiplied) const;

    PixelRect m_rect;
    int m_stride;
    std::vector<Rgb> m_changes; ///< premultiplied colour and, fourth, coverage
};

} // namespace odo
