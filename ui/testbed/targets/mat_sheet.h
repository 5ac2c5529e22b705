// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/floor_mat.h"
#include "ui/testbed/targets/target_sheet.h"

#include <vector>

class QPainter;

namespace odo {

/// The mat that is asked for.
FloorMat matOf(const TargetSpec &spec);

/// First the plan by which the sheets are put together, then the sheets, row by row from the lower left.
/// Refuses a mat of more sheets than there are numbers for.
Result<std::vector<TargetSheet>> layOutMat(const TargetSpec &spec);

/// As paintTarget, of one of these sheets.
void paintMatSheet(QPainter &painter, const FloorMat &mat, const TargetSheet &sheet);

} // namespace odo
