// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report_maker.h"

#include <QString>

namespace odo {

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

/// A report by what is remembered, the options of which include the logo: it is read when the report is made, on that
/// thread. One that cannot be read is left out: the preferences say why.
ReportMaker reportBy(const ReportSettings &settings, std::function<ReportMaker(const ReportOptions &)> of);

} // namespace odo
