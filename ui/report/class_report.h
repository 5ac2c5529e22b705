// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/class_content.h"

namespace odo {

/// The report of a class: its figures together, then a line for each team in the order of the ranking, with every run
/// as a dot on one scale, median, spread and progress; as many pages as that takes. On demand a page for each team
/// after it: its runs through the term, and a list of them. Pure.
ReportPages classPages(const ClassContentPtr &content, const ReportOptions &options);

} // namespace odo
