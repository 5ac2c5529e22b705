// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report_page.h"
#include "ui/report/trial_content.h"

namespace odo {

/// What all reports are told.
struct ReportOptions
{
    Paper paper = Paper::A4;
    Letterhead letterhead;
    bool withMethod = false; ///< a second page, with the method and a summary of what was measured
};

/// The report of a trial: a page for each robot, or one that says that it was not tracked yet; and on demand
/// the page of its method after it. Pure; the pages share the content.
ReportPages trialPages(const TrialContentPtr &content, const ReportOptions &options);

/// Line, title and facts that stand at the head of a trial's pages; a name is literal (literalName).
QString trialTitle(const TrialScene &scene, std::size_t robot);
QStringList trialHeadFacts(const TrialScene &scene, std::size_t robot);

} // namespace odo
