// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/report/report_page.h"

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

} // namespace odo
