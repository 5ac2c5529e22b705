// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/exchange/text_sink.h"
#include "core/project/records.h"

#include <string>
#include <string_view>

namespace odo {

enum class CsvStyle {
    Analysis,      ///< UTF-8 without mark, `,` and `.`: for programs
    International, ///< with mark, `,` and `.`: for spreadsheets
    Continental,   ///< with mark, `;` and `,`: for spreadsheets where the comma is decimal
};
/// "analysis", "international", "continental"; NotFound for another word.
Result<CsvStyle> parseCsvStyle(std::string_view name);

/// One robot's track as the command line promises it: a header line, then a row for each frame of the first
/// view. Millimetres and seconds in the shortest form that reads back exactly; what is missing or not finite
/// is empty. The same bytes in every locale. Cells of text that a spreadsheet would take as a formula begin
/// with an apostrophe.
std::string trackCsv(const AnalysisRecord &analysis, CsvStyle style);
Result<void> writeTrackCsv(const AnalysisRecord &analysis, CsvStyle style, const TextSink &sink);

} // namespace odo
