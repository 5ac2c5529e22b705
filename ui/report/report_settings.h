// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/report/internal/report_maker.h"

#include <QImage>
#include <QString>
#include <filesystem>

namespace odo {

/// A school's logo out of a picture file of any kind that Qt reads, made no larger than reports show it. Io,
/// with what to do, where it is not there, no picture, or larger than a hundred megapixels.
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

} // namespace odo
