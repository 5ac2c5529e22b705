// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/output_file.h"
#include "core/workflow/job.h"
#include "ui/report/internal/report_painting.h"
#include "ui/report/report_maker.h"

#include <QFile>
#include <filesystem>
#include <memory>

class QPainter;
class QPdfWriter;
class QPrinter;

namespace odo {

/// Where the pages of a report go. One thread at a time.
class PageOutput
{
public:
    virtual ~PageOutput() = default; ///< what was not finished leaves nothing
    virtual Result<void> add(const ReportPage &page) = 0;
    /// Once, after the last page. InvalidInput where there was none.
    virtual Result<void> finish() = 0;
};

/// A PDF that is written page by page, with its fonts embedded and its charts as lines. Under its name there
/// is the old file or the whole new one: what is not finished leaves nothing. One thread.
class PdfFile : public PageOutput
{
public:
    PdfFile(OutputTarget target, const QString &title);
    ~PdfFile() override;

    /// Errors: those of OutputFile.
    Result<void> add(const ReportPage &page) override;
    /// Likewise.
    Result<void> finish() override;

private:
    Result<void> begin(const PageFormat &format);

    const OutputTarget m_target;
    const QString m_title;
    std::unique_ptr<OutputFile> m_output; ///< null: no page yet
    QFile m_file;                         ///< writes to it
    std::unique_ptr<QPdfWriter> m_writer;
    std::unique_ptr<QPainter> m_painter;
};

/// Pages on a printer that a person has set up. A page is made as large as the printable part of the paper
/// allows, whatever paper that is.
class PrintedPages : public PageOutput
{
public:
    explicit PrintedPages(std::unique_ptr<QPrinter> printer);
    ~PrintedPages() override;
    /// Io where the printer does not take it.
    Result<void> add(const ReportPage &page) override;
    Result<void> finish() override;

private:
    std::unique_ptr<QPrinter> m_printer;
    std::unique_ptr<QPainter> m_painter; ///< null: no page yet
};

/// Makes a report and gives its pages to a file or a printer. It reads by a connection of its own while it
/// runs, so the project never waits; what fails or is cancelled leaves nothing.
class ReportJob : public Job
{
public:
    ReportJob(ReportMaker maker, std::unique_ptr<PageOutput> output);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override; ///< nothing

    int pageCount() const { return m_pageCount; } ///< after run

private:
    ReportMaker m_maker;
    std::unique_ptr<PageOutput> m_output;
    std::filesystem::path m_project;
    int m_pageCount = 0;
};

} // namespace odo
