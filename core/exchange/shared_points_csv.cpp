// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/shared_points_csv.h"

#include "core/exchange/csv_table.h"
#include "core/exchange/text_file.h"

#include <array>
#include <map>

namespace odo {

Result<std::vector<SharedPoint>> readSharedPointsCsv(const std::filesystem::path &file)
{
    const std::vector<std::string> columns{"label", "u", "v", "through_u", "through_v"};
    const auto rows = readCsvTable(file, columns);
    if (!rows)
        return tl::unexpected(rows.error());
    std::vector<SharedPoint> points;
    std::map<std::string, int> lineOfLabel;
    for (const CsvRow &row : *rows) {
        const std::string &label = row.cells[0];
        if (label.empty())
            return fail(ErrorCode::InvalidInput, atLine(file, row.line), "the label is empty",
                        "give each point a label");
        const auto [earlier, isNew] = lineOfLabel.emplace(label, row.line);
        if (!isNew)
            return fail(ErrorCode::InvalidInput, atLine(file, row.line),
                        "the label '" + label + "' is in line " + std::to_string(earlier->second) +
                            " already",
                        "give each point a label of its own");
        std::array<double, 4> numbers{};
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const auto number = csvNumber(file, row, i + 1, columns[i + 1]);
            if (!number)
                return tl::unexpected(number.error());
            numbers[i] = *number;
        }
        points.push_back({label, {numbers[0], numbers[1]}, {numbers[2], numbers[3]}});
    }
    return points;
}

} // namespace odo
