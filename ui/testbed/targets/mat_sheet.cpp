// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/targets/mat_sheet.h"

#include "core/base/units.h"
#include "ui/testbed/targets/internal/sheet_drawing.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QTransform>
#include <algorithm>

namespace odo {

namespace {

class MatWords
{
    Q_DECLARE_TR_FUNCTIONS(MatWords)
};

constexpr double marginMm = 1000 * matMarginM;

QPageSize::PageSizeId pageOf(FloorMat::Paper paper)
{
    switch (paper) {
    case FloorMat::Paper::A4:
        break;
    case FloorMat::Paper::Letter:
        return QPageSize::Letter;
    case FloorMat::Paper::A3:
        return QPageSize::A3;
    }
    return QPageSize::A4;
}

QSizeF sheetMm(const FloorMat &mat)
{
    const Eigen::Vector2d sheet = matSheetM(mat.paper);
    return {toMillimetres(sheet.x()), toMillimetres(sheet.y())};
}

/// A position of a sheet's part of the mat on its paper.
QPointF onPaper(const TargetSheet &sheet, const Eigen::Vector2d &pointM)
{
    return {marginMm + toMillimetres(pointM.x()),
            sheet.paperMm.height() - marginMm - toMillimetres(pointM.y())};
}

TargetSheet sheetAt(const FloorMat &mat, QSizeF paperMm, int column, int row)
{
    TargetSheet sheet;
    sheet.paperMm = paperMm;
    sheet.column = column;
    sheet.row = row;
    const double side = toMillimetres(matTagM);
    for (const MatTag &tag : matTags(mat.paper, column, row)) {
        const QPointF corner = onPaper(sheet, tag.middle) - QPointF(side / 2, side / 2);
        sheet.ink.addPath(QTransform(side, 0, 0, side, corner.x(), corner.y()).map(tagInk(tag.number)));
        sheet.tag = std::max(sheet.tag, tag.number);
    }
    sheet.drawingMm = sheet.ink.boundingRect();
    return sheet;
}

} // namespace

FloorMat matOf(const TargetSpec &spec)
{
    FloorMat mat{FloorMat::Paper::A4, spec.columns, spec.rows, 1};
    for (const auto paper : {FloorMat::Paper::A4, FloorMat::Paper::Letter, FloorMat::Paper::A3}) {
        if (pageOf(paper) == spec.paper)
            mat.paper = paper;
    }
    return mat;
}

Result<std::vector<TargetSheet>> layOutMat(const TargetSpec &spec)
{
    const FloorMat mat = matOf(spec);
    if (mat.columns < 1 || mat.rows < 1 || mat.columns > FloorMat::mostColumns ||
        mat.rows > FloorMat::mostRows)
        return fail(ErrorCode::InvalidInput, ODO_TEXT("ui.floor_mat", "floor mat"),
                    ODO_TEXT("ui.mat_has_sheets", "a mat has 1 to %1 sheets in a row and 1 to %2 rows")(
                        FloorMat::mostColumns, FloorMat::mostRows),
                    ODO_TEXT("ui.give_mat_size", "give a size such as 4x3"));
    const QSizeF paperMm = QPageSize(pageOf(mat.paper)).size(QPageSize::Millimeter).transposed();
    TargetSheet plan;
    plan.paperMm = paperMm;
    std::vector<TargetSheet> sheets{plan};
    for (int row = 0; row < mat.rows; ++row) {
        for (int column = 0; column < mat.columns; ++column)
            sheets.push_back(sheetAt(mat, paperMm, column, row));
    }
    return sheets;
}

namespace {

QString sheetName(int column, int row)
{
    return MatWords::tr("Row %1, sheet %2").arg(row + 1).arg(column + 1);
}

QString lineWords(const FloorMat &mat)
{
    return MatWords::tr("%1 mm").arg(QLocale().toString(toMillimetres(matLineM(mat)), 'f', 0));
}

/// Where sheets meet: a dashed line to cut along, or a thin one up to which the next sheet is laid.
void paintEdges(QPainter &painter, const FloorMat &mat, const TargetSheet &sheet)
{
    const QRectF area(QPointF(marginMm, sheet.paperMm.height() - marginMm - sheetMm(mat).height()),
                      sheetMm(mat));
    const auto line = [&](bool isThere, Qt::PenStyle style, QPointF from, QPointF to) {
        if (!isThere)
            return;
        painter.setPen(QPen(Qt::darkGray, sheetLineMm, style, Qt::FlatCap));
        painter.drawLine(from, to);
    };
    line(sheet.column > 0, Qt::DashLine, area.topLeft(), area.bottomLeft());
    line(sheet.row > 0, Qt::DashLine, area.bottomLeft(), area.bottomRight());
    line(sheet.column + 1 < mat.columns, Qt::SolidLine, area.topRight(), area.bottomRight());
    line(sheet.row + 1 < mat.rows, Qt::SolidLine, area.topLeft(), area.topRight());
}

/// This sheet's part of the line by which the print is checked.
void paintCheckLine(QPainter &painter, const FloorMat &mat, const TargetSheet &sheet)
{
    if (sheet.row > 0)
        return;
    const double left = sheet.column * matSheetM(mat.paper).x(), right = left + matSheetM(mat.paper).x();
    const double from = std::max(left, matLineStartM.x()),
                 to = std::min(right, matLineStartM.x() + matLineM(mat));
    if (from >= to)
        return;
    const auto at = [&](double xM, double upMm = 0) {
        return onPaper(sheet, {xM - left, matLineStartM.y()}) - QPointF(0, upMm);
    };
    painter.setPen(QPen(Qt::black, sheetLineMm, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(at(from), at(to));
    for (const double end : {matLineStartM.x(), matLineStartM.x() + matLineM(mat)}) {
        if (end >= left && end <= right)
            painter.drawLine(at(end, -2.5), at(end, 2.5));
    }
    if (sheet.column == 0)
        paintText(painter, {at(from, 4.4) + QPointF(2, 0), QSizeF(150, 4)}, sheetTextMm,
                  Qt::AlignLeft | Qt::AlignVCenter,
                  MatWords::tr("This line is %1 long on the whole mat. Measure it.").arg(lineWords(mat)));
}

void paintSheetName(QPainter &painter, const FloorMat &mat, const TargetSheet &sheet)
{
    painter.setPen(Qt::black);
    const bool isWide = mat.paper == FloorMat::Paper::A3; // with room below its tags, not beside them
    const QPointF corner = onPaper(sheet, isWide ? Eigen::Vector2d(0.0125, 0.052)
                                                 : Eigen::Vector2d(0.006, matSheetM(mat.paper).y() - 0.012));
    const QSizeF size = isWide ? QSizeF(370, 8) : QSizeF(58, 24);
    const int flags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
    constexpr double nameMm = 6;
    paintText(painter, {corner, size}, nameMm, flags, sheetName(sheet.column, sheet.row), true);
    paintText(painter, {corner + QPointF(0, size.height()), QSizeF(size.width(), 60)}, sheetTextMm, flags,
              MatWords::tr("Floor mat of %1 × %2 sheets. Print at 100 % (actual size). Cut along the dashed "
                           "lines.")
                  .arg(mat.columns)
                  .arg(mat.rows));
}

void paintPlan(QPainter &painter, const FloorMat &mat, const TargetSheet &plan)
{
    constexpr double titleMm = 7, stepMm = 4.2, gapMm = 8, stepsMm = 62;
    const QRectF page = QRectF(QPointF(0, 0), plan.paperMm).adjusted(15, 14, -15, -14);
    paintText(painter, {page.topLeft(), QSizeF(page.width(), titleMm * 1.6)}, titleMm,
              Qt::AlignLeft | Qt::AlignTop,
              MatWords::tr("Floor mat of %1 × %2 sheets").arg(mat.columns).arg(mat.rows), true);
    const QStringList steps{
        MatWords::tr("1. Print all pages at 100 % (actual size), not fitted to the page."),
        MatWords::tr("2. Cut each sheet along its dashed lines. Lay it on its neighbours, up to their thin "
                     "lines, as drawn below, and tape the sheets together."),
        MatWords::tr("3. Measure the line at the lower edge. It should be %1 long; Odograph asks for what "
                     "you measure.")
            .arg(lineWords(mat)),
        MatWords::tr("4. Lay the mat flat where every camera sees all of it. The lower left corner is the "
                     "origin, the lower edge the x axis.")};
    paintText(painter, {page.left(), page.top() + titleMm * 1.8, page.width(), stepsMm}, stepMm,
              Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, steps.join(QLatin1Char('\n')));
    const QRectF room = page.adjusted(0, titleMm * 1.8 + stepsMm + gapMm, 0, 0);
    const QSizeF whole(mat.columns * sheetMm(mat).width(), mat.rows * sheetMm(mat).height());
    const double scale = std::min(room.width() / whole.width(), room.height() / whole.height());
    const QPointF lowerLeft(room.center().x() - scale * whole.width() / 2, room.bottom());
    painter.setPen(QPen(Qt::black, sheetLineMm));
    for (int row = 0; row < mat.rows; ++row) {
        for (int column = 0; column < mat.columns; ++column) {
            const QSizeF size = scale * sheetMm(mat);
            const QRectF box(lowerLeft + QPointF(column * size.width(), -(row + 1) * size.height()), size);
            painter.drawRect(box);
            for (const MatTag &tag : matTags(mat.paper, column, row)) {
                const double side = scale * toMillimetres(matTagM);
                const QPointF middle = box.bottomLeft() + scale * QPointF(toMillimetres(tag.middle.x()),
                                                                          -toMillimetres(tag.middle.y()));
                const QTransform there(side, 0, 0, side, middle.x() - side / 2, middle.y() - side / 2);
                painter.fillPath(there.map(tagInk(tag.number)), QColor(0, 0, 0, 60));
            }
            paintText(painter, box, std::min(stepMm, 0.16 * size.height()),
                      Qt::AlignCenter | Qt::TextWordWrap, sheetName(column, row), true);
        }
    }
}

} // namespace

void paintMatSheet(QPainter &painter, const FloorMat &mat, const TargetSheet &sheet)
{
    painter.setPen(Qt::black);
    if (sheet.tag < 0)
        return paintPlan(painter, mat, sheet);
    paintEdges(painter, mat, sheet);
    paintCheckLine(painter, mat, sheet);
    paintSheetName(painter, mat, sheet);
}

} // namespace odo
