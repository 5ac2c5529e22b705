// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_file.h"
#include "ui/report/page_output.h"

#include <QFile>
#include <memory>

class QPdfWriter;

namespace odo {

/// A PDF that is written page by page, with its fonts embedded and its charts as lines. Under its name there is
/// the old file or the whole new one: what is not finished leaves nothing. One thread.
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

} // namespace odo
