// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/compare/trial_metrics.h"
#include "ui/report/report_maker.h"

#include <memory>

namespace odo {

/// What the report of a class says: immutable values.
struct ClassContent
{
    ClassReportSettings settings; ///< with task and metric chosen
    Standings standings;
    int leftOut = 0; ///< trials of the task that were measured by another course
    int bad = 0;     ///< trials that are left out for a bad verdict
    int trials = 0;  ///< of the class in the task, those without a metric too
};
using ClassContentPtr = std::shared_ptr<const ClassContent>;

/// Reads the standings of a class. On the project's thread. Errors: NotFound, with the classes there are, for
/// a class or a task that is not there, or where no run of the class has the metric; those of the
/// repositories.
Result<ClassContentPtr> readClassContent(Project &project, const ClassReportSettings &settings);

/// The report of a class: its metrics, then a line for each team in the order of the ranking, with every run
/// as a dot on one scale, median, spread and progress; as many pages as that takes. On demand a page for each
/// team after it: its runs through the term, and a list of them. Pure.
ReportPages classPages(const ClassContentPtr &content, const ReportOptions &options);

} // namespace odo
