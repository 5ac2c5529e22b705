// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/trial_report.h"

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

/// For the making of a report. A logo that cannot be read is left out: the preferences say why.
ReportOptions optionsOf(const ReportSettings &settings);

} // namespace odo
