// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/pixels_csv.h"

#include "core/exchange/labelled_points.h"

namespace odo {

Result<std::vector<MarkerPixel>> readPixelsCsv(const std::filesystem::path &file)
{
    const auto points = readLabelledPoints(file, {"label", "u", "v"});
    if (!points)
        return tl::unexpected(points.error());
    std::vector<MarkerPixel> pixels;
    for (const LabelledPoint &point : *points)
        pixels.push_back({point.label, {point.x, point.y}});
    return pixels;
}

} // namespace odo
