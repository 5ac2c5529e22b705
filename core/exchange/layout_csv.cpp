// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/layout_csv.h"

#include "core/base/units.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/labelled_points.h"
#include "core/exchange/text_file.h"

namespace odo {

Result<MarkerLayout> readLayoutCsv(const std::filesystem::path &file)
{
    const auto points = readLabelledPoints(file, {"label", "x_mm", "y_mm"});
    if (!points)
        return tl::unexpected(points.error());
    MarkerLayout layout;
    for (const LabelledPoint &point : *points)
        layout.markers.push_back({point.label, {fromMillimetres(point.x), fromMillimetres(point.y)}});
    return layout;
}

Result<void> writeLayoutCsv(const std::filesystem::path &file, const MarkerLayout &layout)
{
    std::string text = "label,x_mm,y_mm\n";
    for (const Marker &marker : layout.markers)
        text += csvCell(marker.label, ',') + ',' + numberText(toMillimetres(marker.pointInWorld.x())) + ',' +
                numberText(toMillimetres(marker.pointInWorld.y())) + '\n';
    return writeTextFile(file, text);
}

} // namespace odo
