// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/page_output.h"

#include <memory>

class QPainter;
class QPrinter;

namespace odo {

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

} // namespace odo
