// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/job_control.h"

#include <QString>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Of what a page is made.
struct HtmlPageSettings
{
    std::vector<std::string> trials;         ///< a section each, in this order; of two their comparison too
    std::string robot = {};                  ///< empty: all of each trial
    QString language = QStringLiteral("en"); ///< code of the language that words are shown in
};

/// One page of HTML with everything in it: map, charts, metrics with ±, verdict, spikes, synchronisation and
/// where it all comes from. It needs no network and no script, follows the reader's light or dark theme and
/// the width of the screen, and an XML parser can read it. Project's thread. Errors: those of reading;
/// NotFound for a trial that was not tracked, or in which that robot was not; Cancelled.
Result<std::string> htmlPage(Project &project, const HtmlPageSettings &settings, const JobControl &control);

} // namespace odo
