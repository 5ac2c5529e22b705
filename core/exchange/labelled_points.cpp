// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/labelled_points.h"

#include "core/exchange/csv_table.h"
#include "core/exchange/text_file.h"

#include <map>

namespace odo {

Result<std::vector<LabelledPoint>> readLabelledPoints(const std::filesystem::path &file,
                                                      const std::vector<std::string> &columns)
{
    const auto rows = readCsvTable(file, columns);
    if (!rows)
        return tl::unexpected(rows.error());
    std::vector<LabelledPoint> points;
    std::map<std::string, int> lineOfLabel;
    for (const CsvRow &row : *rows) {
        const std::string label = csvTextOf(row.cells[0]);
        if (label.empty())
            return fail(ErrorCode::InvalidInput, atLine(file, row.line), "the label is empty",
                        "give each marker a label");
        const auto [earlier, isNew] = lineOfLabel.emplace(label, row.line);
        if (!isNew)
            return fail(ErrorCode::InvalidInput, atLine(file, row.line),
                        "the label '" + label + "' is in line " + std::to_string(earlier->second) +
                            " already",
                        "give each marker a label of its own");
        const auto x = csvNumber(file, row, 1, columns[1]);
        if (!x)
            return tl::unexpected(x.error());
        const auto y = csvNumber(file, row, 2, columns[2]);
        if (!y)
            return tl::unexpected(y.error());
        points.push_back({label, *x, *y});
    }
    if (points.empty())
        return fail(ErrorCode::InvalidInput, atLine(file, 1), "there are no markers below the header",
                    "write one line for each marker");
    return points;
}

} // namespace odo
