// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/certificate/certificate.h"
#include "ui/report/report_maker.h"

#include <functional>
#include <memory>

namespace odo {

/// What a certificate says: immutable values, safe to share with any thread.
struct CertificateContent
{
    CertificateSetUp setUp;
    CertificateOutcome outcome;
    Instant made;
};
using CertificateContentPtr = std::shared_ptr<const CertificateContent>;

/// The certificate of a project's set-up: simulates it (makeCertificate) when the pages are made. taken: gets
/// the content first; may be empty.
ReportMaker certificateReport(CertificateSettings settings, const ReportOptions &options,
                              std::function<void(const CertificateContentPtr &)> taken = {});

/// Its two pages: the errors with a map of the run and what they are worth; then the errors over the time,
/// the cameras and the remarks. Pure.
ReportPages certificatePages(const CertificateContentPtr &content, const ReportOptions &options);

} // namespace odo
