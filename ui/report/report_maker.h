// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/workflow/compare/compare_trials.h"
#include "core/workflow/compare/trial_metrics.h"
#include "ui/models/comparison_scene.h"
#include "ui/report/trial_report.h"

#include <QImage>
#include <QString>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Takes the pages of a report one after another: a file, a preview, a printer.
using PageSink = std::function<Result<void>(const ReportPage &)>;

/// Makes a report out of a project, on the project's thread, page by page, so that a whole class is never in
/// memory at once. Slow: reads, and decodes images; reports progress and asks for cancellation with each
/// trial. Errors: those of reading, of the sink, Cancelled.
using ReportMaker =
    std::function<Result<void>(Project &project, const JobControl &control, const PageSink &sink)>;

Message reportSubject(); ///< "report", what its errors are about

/// A report of each of these trials, in this order.
ReportMaker trialReports(std::vector<std::string> trials, const ReportOptions &options);

/// Two runs left and right, the paths of both, the time difference along them, and the significant
/// differences.
ReportMaker comparisonReport(CompareSettings settings, const ReportOptions &options);

/// Which class, and by what its teams are ranked.
struct ClassReportSettings
{
    std::string className;
    std::string task;   ///< empty: the one that most of the class's trials have
    std::string metric; ///< empty: the score where the task is scored, else the first of informativeMetrics
    bool withTeams = false; ///< and a page for each team
};
/// The ranking of a class, a line for each team with all its runs and its trend. NotFound for a class that is
/// not there or has no run.
ReportMaker classReport(ClassReportSettings settings, const ReportOptions &options);

/// One after the other.
ReportMaker inTurn(std::vector<ReportMaker> makers);

/// A school's logo out of an image file of any kind that Qt reads, made no larger than reports show it. Io,
/// with what to do, where it is not there, no image, or larger than a hundred megapixels.
Result<QImage> readLogo(const std::filesystem::path &file);

/// What is remembered of reports on this computer.
struct ReportSettings
{
    QString school, remark;
    QString logoFile; ///< empty: none
    Paper paper = Paper::A4;
    bool withMethod = false;
};
/// The paper is the locale's until one was chosen. GUI thread.
ReportSettings storedReportSettings();
void storeReportSettings(const ReportSettings &settings);

/// A report by what is remembered, the options of which include the logo: it is read when the report is made,
/// on that thread. One that cannot be read is left out: the preferences say why.
ReportMaker reportBy(const ReportSettings &settings, std::function<ReportMaker(const ReportOptions &)> of);

/// The report of a comparison: the first run at the left, the second at the right, between them the paths of
/// both; below the speed and the time difference over distance, the sectors, and the metrics with what is not
/// significant in grey. Of more runs each is compared with the first on a page of its own. Takes the images
/// of the views now (slow); the pages themselves are pure.
ReportPages comparisonPages(const ComparisonScenePtr &scene, const ReportOptions &options);

} // namespace odo
