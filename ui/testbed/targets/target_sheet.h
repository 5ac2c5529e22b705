// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/files/output_file.h"

#include <QPageSize>
#include <QPainterPath>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QStringList>
#include <vector>

class QPagedPaintDevice;
class QPainter;

namespace odo {

/// What is printed: a board that is held before the camera, markers that lie on the floor each by itself, or
/// a mat of them.
enum class TargetKind { Checkerboard, Charuco, Tags, Rings, Mat };

bool isBoard(TargetKind kind);

struct TargetSpec
{
    TargetKind kind = TargetKind::Checkerboard;
    QPageSize::PageSizeId paper = QPageSize::A4;
    int columns = 9, rows = 6; ///< of a board: inner corners; of a mat: sheets
    double squareM = 0.025;    ///< of a board
    double markerM = 0.15;     ///< side of a tag's black square, outer diameter of a ring
    /// One sheet a marker, in the order of the layout: a tag's number is the index of its label.
    QStringList labels{QStringLiteral("O"), QStringLiteral("U"), QStringLiteral("V"), QStringLiteral("D")};
};

/// One sheet of paper. Millimetres from its top left corner, y down.
struct TargetSheet
{
    QSizeF paperMm;   ///< turned as it is to be printed
    QRectF drawingMm; ///< what the ink covers
    QPainterPath ink;
    QString label;           ///< of a marker; empty for a board
    int tag = -1;            ///< number of a tag; none: no tag, or the plan of a mat
    int column = 0, row = 0; ///< of a sheet of a mat, from its lower left
};

/// Margin at each edge of the paper, where printers cannot print, and space beneath the target for the ruler
/// and the text.
inline constexpr double targetMarginMm = 8, targetFootMm = 18;

/// A board's squares or a marker, in the middle of the paper, which is turned where it fits better. Refuses
/// what is not drawn so (fewer than 3 inner corners, a ChArUco board of an even number of rows of squares,
/// which programs number in two ways, more markers or sheets than there are numbers) and what does not fit,
/// saying how large it may be.
Result<std::vector<TargetSheet>> layOutTarget(const TargetSpec &spec);

/// Paints one sheet, black on any background; the painter's unit must be the millimetre, its origin the
/// sheet's top left corner. Beneath the target: a ruler of 100 mm to check the print, and instructions.
void paintTarget(QPainter &painter, const TargetSpec &spec, const TargetSheet &sheet);

/// Sets the paper and paints the sheets to scale, one a page. Error Io when the device takes no painting.
Result<void> printTarget(QPagedPaintDevice &device, const TargetSpec &spec,
                         const std::vector<TargetSheet> &sheets);

/// Arranges and writes a PDF. Errors: those of layOutTarget and OutputFile.
Result<void> writeTargetPdf(const TargetSpec &spec, const OutputTarget &target);

} // namespace odo
