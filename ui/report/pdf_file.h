// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/whole_file.h"
#include "ui/report/page_output.h"

#include <filesystem>
#include <memory>

class QPdfWriter;

namespace odo {

/// A PDF that is written page by page, with its fonts embedded and its charts as lines. Under its name there is
/// the old file or the whole new one: what is not finished leaves nothing. One thread.
class PdfFile : public PageOutput
{
public:
    PdfFile(const std::filesystem::path &file, const QString &title);
    ~PdfFile() override;

    /// Io where the file cannot be written.
    Result<void> add(const ReportPage &page) override;
    /// Io likewise.
    Result<void> finish() override;

private:
    Result<void> begin(const PageFormat &format);
    tl::unexpected<Error> failure() const;

    QString m_title;
    WholeFile m_file;
    std::unique_ptr<QPdfWriter> m_writer; ///< null: no page yet
    std::unique_ptr<QPainter> m_painter;
};

} // namespace odo
