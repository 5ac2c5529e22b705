// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/certificate/certificate.h"

namespace odo {

/// Fills in the errors of an outcome from its runs, each compared with its truth at the same times.
void addErrors(CertificateOutcome &outcome);

} // namespace odo
