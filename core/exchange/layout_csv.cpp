// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/layout_csv.h"

#include "core/base/units.h"
#include "core/exchange/csv_table.h"
#include "core/exchange/labelled_points.h"
#include "core/exchange/text_file.h"
#include "core/files/output_file.h"

#include <array>
#include <charconv>
#include <limits>

namespace odo {

namespace {

/// The millimetres that are read back as the same metres: of the shortest text of any rounding, since a product and the
/// quotient that it came from may differ in the last bit.
std::string millimetreText(double metres)
{
    const double nearest = toMillimetres(metres);
    for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
        std::array<char, 40> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), nearest, std::chars_format::general, digits);
        double rounded = 0;
        std::from_chars(text.data(), end.ptr, rounded);
        if (fromMillimetres(rounded) == metres)
            return numberText(rounded);
    }
    return numberText(nearest);
}

} // namespace

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

Result<void> writeLayoutCsv(const OutputTarget &target, const MarkerLayout &layout)
{
    std::string text = "label,x_mm,y_mm\n";
    for (const Marker &marker : layout.markers)
        text += csvText(marker.label, ',') + ',' + millimetreText(marker.pointInWorld.x()) + ',' +
                millimetreText(marker.pointInWorld.y()) + '\n';
    return writeOutput(target, text);
}

} // namespace odo
