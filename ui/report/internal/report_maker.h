// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/job_control.h"
#include "core/workflow/compare/compare_trials.h"
#include "core/workflow/compare/standings.h"
#include "ui/report/trial_report.h"

#include <functional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Takes the pages of a report one after another: a file, a preview, a printer.
using PageSink = std::function<Result<void>(const ReportPage &)>;

/// Makes a report out of a project, on the project's thread, page by page, so that a whole class is never in
/// memory at once. Slow: reads, and decodes pictures; reports progress and asks for cancellation with each
/// trial. Errors: those of reading, of the sink, Cancelled.
using ReportMaker =
    std::function<Result<void>(Project &project, const JobControl &control, const PageSink &sink)>;

Message reportSubject(); ///< "report", what its errors are about

/// A report of each of these trials, in this order.
ReportMaker trialReports(std::vector<std::string> trials, const ReportOptions &options);

/// Two runs left and right, the way of both, the time difference along it, and what differs beyond the error.
ReportMaker comparisonReport(CompareSettings settings, const ReportOptions &options);

/// Which class, and by what its teams are ranked.
struct ClassReportSettings
{
    std::string className;
    std::string task;       ///< empty: the one that most of the class's trials have
    std::string metric;     ///< empty: the score where the task is scored, else the first of tellingMetrics
    bool withTeams = false; ///< and a page for each team
};
/// The ranking of a class, a line for each team with all its runs and its trend. NotFound for a class that is
/// not there or has no run.
ReportMaker classReport(ClassReportSettings settings, const ReportOptions &options);

/// One after the other.
ReportMaker inTurn(std::vector<ReportMaker> makers);

} // namespace odo
