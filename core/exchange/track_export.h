// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/exchange/text_file.h"
#include "core/project/records.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace odo {

enum class CsvStyle {
    Analysis,      ///< UTF-8 without mark, `,` and `.`: for programs
    International, ///< with mark, `,` and `.`: for spreadsheets
    Continental,   ///< with mark, `;` and `,`: for spreadsheets where the comma is decimal
};
/// "analysis", "international", "continental"; NotFound for another word.
Result<CsvStyle> parseCsvStyle(std::string_view name);

/// The unit of all lengths of a table, also in speeds and accelerations.
enum class CsvLength { Millimetres, Centimetres, Metres, Inches };
/// "mm", "cm", "m", "in"; nullopt for another word.
std::optional<CsvLength> csvLengthFromWord(std::string_view word);

/// The names of the columns of a track as CSV, in their order.
std::vector<std::string> csvColumns(CsvLength unit = CsvLength::Millimetres);
/// Columns of a track as CSV, by their positions; columns: their names in millimetres, in any order, each
/// once. NotFound for
/// another name, InvalidInput for one that is named twice.
Result<std::vector<std::size_t>> parseCsvColumns(const std::vector<std::string> &columns);

/// One robot's track as the command line promises it: a header line, then a row for each frame of the first
/// view. Lengths in the unit (the columns are named after it: "x_m") and seconds, in the shortest form that
/// reads back exactly; what is missing or not finite is empty. The same bytes in every locale. Cells of text
/// that a spreadsheet would take as a formula begin with an apostrophe.
std::string trackCsv(const AnalysisRecord &analysis, CsvStyle style);
/// columns: only those, in that order; empty: all.
Result<void> writeTrackCsv(const AnalysisRecord &analysis, CsvStyle style, const TextSink &sink,
                           std::span<const std::size_t> columns = {},
                           CsvLength unit = CsvLength::Millimetres);

/// Tracks for other programs: the points where the profile is valid, metres and seconds, the same bytes in
/// every locale.

/// TUM, as evo reads it: "timestamp tx ty tz qx qy qz qw" with single blanks and none at the end of a line; z
/// = 0 and a rotation about Z only: the heading (headingsOf), 0 where none is known.
std::string trackTum(const AnalysisRecord &analysis);
Result<void> writeTrackTum(const AnalysisRecord &analysis, const TextSink &sink);

/// A robot's name as trackTracker writes it: one word that Tracker takes neither for a number nor for a
/// remark.
std::string trackerName(std::string name);

/// Text that Tracker (Open Source Physics) imports as a data track: the robot's name, then t, x and y parted
/// by tabs; a line for each frame, with blank cells where nothing is known, and no delimiter at the end of a
/// line, which Tracker would take for one column more.
std::string trackTracker(const AnalysisRecord &analysis);
Result<void> writeTrackTracker(const AnalysisRecord &analysis, const TextSink &sink);

} // namespace odo
