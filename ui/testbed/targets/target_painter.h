// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/output_guard.h"
#include "ui/testbed/targets/target_sheet.h"

class QPagedPaintDevice;
class QPainter;

namespace odo {

/// Paints one sheet, black on whatever ground there is; the painter's unit must be the millimetre, its origin the
/// sheet's top left corner. Beneath the figure: a ruler of 100 mm to check the print by, and what to do with it.
void paintTarget(QPainter &painter, const TargetSpec &spec, const TargetSheet &sheet);

/// Sets the paper and paints the sheets to scale, one a page. Error Io when the device takes no painting.
Result<void> printTarget(QPagedPaintDevice &device, const TargetSpec &spec, const std::vector<TargetSheet> &sheets);

/// Lays out and writes a PDF. Errors: those of layOutTarget and OutputFile.
Result<void> writeTargetPdf(const TargetSpec &spec, const OutputTarget &target);

} // namespace odo
