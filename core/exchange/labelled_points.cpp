// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/labelled_points.h"

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/exchange/text_file.h"
#include "core/files/output_file.h"

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace odo {

namespace {

Message labelIsEmpty()
{
    return ODO_TEXT("exchange.label_is_empty", "the label is empty");
}

Message labelIsThere(const std::string &label, int line)
{
    return ODO_TEXT("exchange.label_is_there", "line %2 already has the label '%1'")(Named::marker(label),
                                                                                     line);
}

} // namespace

struct LabelledPoint
{
    std::string label;
    double x = 0, y = 0; ///< in the file's unit
};

/// Reads a CSV file with a column of labels and two of numbers, whose names are given. Refuses, naming the
/// line: labels that are empty or there twice, numbers that are none; and a file without points.
Result<std::vector<LabelledPoint>> readLabelledPoints(const std::filesystem::path &file,
                                                      const std::vector<std::string> &columns)
{
    const auto rows = ODO_TRY(readCsvTable(file, columns));
    std::vector<LabelledPoint> points;
    std::map<std::string, int> lineOfLabel;
    for (const CsvRow &row : rows) {
        const std::string label = csvTextOf(row.cells[0]);
        if (label.empty())
            return fail(ErrorCode::InvalidInput, atLine(file, row.line), labelIsEmpty(),
                        ODO_TEXT("exchange.give_marker_label", "give each marker a label"));
        const auto [earlier, isNew] = lineOfLabel.emplace(label, row.line);
        if (!isNew)
            return fail(ErrorCode::InvalidInput, atLine(file, row.line), labelIsThere(label, earlier->second),
                        labelEachMarker());
        const auto x = ODO_TRY(csvNumber(file, row, 1, columns[1]));
        const auto y = ODO_TRY(csvNumber(file, row, 2, columns[2]));
        points.push_back({label, x, y});
    }
    if (points.empty())
        return fail(ErrorCode::InvalidInput, atLine(file, 1),
                    ODO_TEXT("exchange.no_markers", "no markers follow the header"),
                    ODO_TEXT("exchange.write_line_for_marker", "write one line for each marker"));
    return points;
}

namespace {

/// The millimetres that are read back as the same metres: of the shortest text of any rounding, since a
/// product and the quotient that it came from may differ in the last bit.
std::string millimetreText(double metres)
{
    const double nearest = toMillimetres(metres);
    for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
        std::array<char, 40> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), nearest,
                                       std::chars_format::general, digits);
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
    const auto points = ODO_TRY(readLabelledPoints(file, {"label", "x_mm", "y_mm"}));
    MarkerLayout layout;
    for (const LabelledPoint &point : points)
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

Result<std::vector<MarkerPixel>> readPixelsCsv(const std::filesystem::path &file)
{
    const auto points = ODO_TRY(readLabelledPoints(file, {"label", "u", "v"}));
    std::vector<MarkerPixel> pixels;
    for (const LabelledPoint &point : points)
        pixels.push_back({point.label, {point.x, point.y}});
    return pixels;
}

std::string locatedPointsCsv(const std::vector<LocatedPoint> &points)
{
    // In whole micrometres, for no camera sees less; without a minus before zero.
    const auto millimetresOf = [](double metres) { return std::round(1e6 * metres) / 1e3 + 0.0; };
    std::string text = "label,u,v,x_mm,y_mm,sigma_x_mm,sigma_y_mm\n";
    for (const LocatedPoint &point : points) {
        text +=
            csvText(point.label, ',') + ',' + numberText(point.pixel.x()) + ',' + numberText(point.pixel.y());
        if (point.position) {
            for (const Eigen::Vector2d &pair : {point.position->pointInWorld, point.position->sigmaM()})
                for (const double metres : pair)
                    text += ',' + numberText(millimetresOf(metres));
        } else {
            text += ",,,,";
        }
        text += '\n';
    }
    return text;
}

Result<std::vector<SharedPoint>> readSharedPointsCsv(const std::filesystem::path &file)
{
    const std::vector<std::string> columns{"label", "u", "v", "through_u", "through_v"};
    const auto rows = ODO_TRY(readCsvTable(file, columns));
    std::vector<SharedPoint> points;
    std::map<std::string, int> lineOfLabel;
    for (const CsvRow &row : rows) {
        const std::string &label = row.cells[0];
        if (label.empty())
            return fail(ErrorCode::InvalidInput, atLine(file, row.line), labelIsEmpty(),
                        ODO_TEXT("exchange.give_point_label", "give each point a label"));
        const auto [earlier, isNew] = lineOfLabel.emplace(label, row.line);
        if (!isNew)
            return fail(ErrorCode::InvalidInput, atLine(file, row.line), labelIsThere(label, earlier->second),
                        labelEachPoint());
        std::array<double, 4> numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = ODO_TRY(csvNumber(file, row, i + 1, columns[i + 1]));
        }
        points.push_back({label, {numbers[0], numbers[1]}, {numbers[2], numbers[3]}});
    }
    return points;
}

} // namespace odo
