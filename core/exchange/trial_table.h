// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/text_file.h"
#include "core/exchange/track_export.h"
#include "core/files/output_file.h"
#include "core/project/records.h"
#include "core/project/verdict_repository.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace odo {

/// A metric of the table; its values all have that unit.
struct TrialTableColumn
{
    std::string metric, unit;
};

/// A robot in a trial.
struct TrialTableRow
{
    TrialRecord trial;
    std::string robot;                   ///< empty: the trial was not tracked
    std::optional<TrialVerdict> verdict; ///< none: not known
    /// By another course than the trial's task has, so that times and scores of the task do not count.
    bool isMeasuredOtherwise = false;
    std::vector<std::optional<Metric>> metrics; ///< one for each column; none: it has no such metric
};

/// A metric over the runs of a group, in the unit of its column. Plain values.
struct ResultStatistics
{
    std::string group;      ///< such as the team's name; empty: of nothing, or all runs
    std::size_t column = 0; ///< of the table
    std::size_t count = 0;  ///< of values that count, at least one
    double mean = 0, median = 0, least = 0, most = 0;
    /// Standard error of the mean, deviation/√count; of a single run its own σ, if it is known.
    std::optional<double> meanSigma;
    std::optional<double> deviation; ///< standard deviation of one run (n − 1); none for a single one
    std::optional<double> variation; ///< deviation/|mean|; none where that is not defined
};

/// Trials and their metrics, for a spreadsheet or a program. Nothing is left out or averaged: what a value is
/// worth is beside it.
struct ResultTable
{
    std::vector<std::string> variables; ///< that the trials have, a column each
    std::vector<TrialTableColumn> columns;
    std::vector<TrialTableRow> rows;
    std::vector<ResultStatistics> statistics; ///< for a sheet of their own; a CSV does not have them
};

/// As CSV: a header line without blanks, then a row for each robot of each trial; each metric has a column
/// with its unit, and one of its σ. at_least names the metrics that can only be larger; a value that is
/// missing is empty. Any thread.
Result<void> writeTrialTableCsv(const ResultTable &table, CsvStyle style, const TextSink &sink);

/// As an XLSX workbook of one sheet, and another one with the statistics if there are any; headers are
/// frozen, numbers are numbers and dates are dates, lower bounds are shown with "≥", uncertain and bad
/// verdicts are coloured. Any thread. Errors: those of OutputFile.
Result<void> writeTrialTableXlsx(const ResultTable &table, const OutputTarget &target);

} // namespace odo
