// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/job.h"
#include "ui/report/report_maker.h"

#include <filesystem>

namespace odo {

/// Writes a report to a PDF file. It reads by a connection of its own while it runs, so the project never waits;
/// a failed or cancelled report leaves no file, and the file that was there before as it was.
class ReportJob : public Job
{
public:
    ReportJob(ReportMaker maker, std::filesystem::path file, QString title);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    const std::filesystem::path &file() const { return m_file; }
    int pageCount() const { return m_pageCount; } ///< after run

private:
    ReportMaker m_maker;
    std::filesystem::path m_file, m_project;
    QString m_title;
    int m_pageCount = 0;
};

} // namespace odo
