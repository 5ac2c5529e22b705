// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/internal/report_painting.h"
#include "ui/report/internal/trial_content.h"

#include <QStringList>

class QPainter;

namespace odo {

/// By what a run was measured, for the foot of its page: a line for the views with their calibration,
/// registration error, rate and lost frames, one for step, smoother and version. Empty lines are left out.
QStringList provenanceLines(const TrialContent &content, std::size_t robot);

/// Frames that are missing among the times of a view: a step of n intervals misses n − 1.
int missingFrames(const std::vector<Nanoseconds> &times);

/// The second page of a trial's report: how each large metric was computed, and a summary of what was
/// measured.
void paintMethodPage(QPainter &painter, const QRectF &sheet, const TrialContent &content, std::size_t robot,
                     const Letterhead &letterhead);

/// The settings of all reports.
struct ReportOptions
{
    Paper paper = Paper::A4;
    Letterhead letterhead;
    bool withMethod = false; ///< a second page, with the method and a summary of what was measured
};

/// The report of a trial: a page for each robot, or one that says that it was not tracked yet; and on demand
/// the page of its method after it. Pure; the pages share the content.
ReportPages trialPages(const TrialContentPtr &content, const ReportOptions &options);

/// Line, title and facts at the head of a trial's pages; a name is literal (literalName).
QString trialTitle(const TrialScene &scene, std::size_t robot);
QStringList trialHeadFacts(const TrialScene &scene, std::size_t robot);

} // namespace odo
