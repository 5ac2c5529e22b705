// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/targets/target_sheet.h"

#include "core/base/units.h"
#include "core/calibration/charuco_layout.h"
#include "core/files/output_file.h"
#include "core/simulation/tag_pattern.h"
#include "ui/testbed/targets/internal/sheet_drawing.h"
#include "ui/testbed/targets/mat_sheet.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QLocale>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <QTransform>
#include <algorithm>
#include <cmath>
#include <string>

namespace odo {

namespace {

constexpr int fewestCorners = 3, mostCorners = 30;
constexpr int mostTags = 587;           // of the family 36h11
constexpr int mostCharucoMarkers = 250; // of the dictionary 6X6_250
constexpr double charucoMarkerRatio = 0.6;
constexpr double ringHole = 0.5; // inner over outer diameter

/// The squares of one colour, and in the others the markers; in squares.
QPainterPath boardInk(const TargetSpec &spec)
{
    const CharucoLayout layout{spec.columns + 1, spec.rows + 1, false};
    QPainterPath path;
    for (int y = 0; y < layout.squaresY; ++y) {
        for (int x = y % 2; x < layout.squaresX; x += 2)
            path.addRect(x, y, 1, 1);
    }
    for (int id = 0; spec.kind == TargetKind::Charuco && id < layout.markerCount(); ++id) {
        const Eigen::Vector2i square = *layout.squareOf(id);
        const TagPattern pattern = arucoPattern(id);
        const double cell = charucoMarkerRatio / pattern.side, edge = 0.5 * (1 - charucoMarkerRatio);
        path.addPath(
            QTransform(cell, 0, 0, cell, square.x() + edge, square.y() + edge).map(darkCells(pattern)));
    }
    return path;
}

QPainterPath ringInk()
{
    QPainterPath path; // odd-even: the second circle is the hole
    path.addEllipse(QPointF(0.5, 0.5), 0.5, 0.5);
    path.addEllipse(QPointF(0.5, 0.5), 0.5 * ringHole, 0.5 * ringHole);
    return path;
}

Message targetSubject()
{
    return ODO_TEXT("ui.target", "target");
}

tl::unexpected<Error> refuse(Message why, Message advice)
{
    return fail(ErrorCode::InvalidInput, targetSubject(), std::move(why), std::move(advice));
}

Result<void> checkDrawable(const TargetSpec &spec)
{
    if (!isBoard(spec.kind)) {
        if (spec.labels.isEmpty())
            return refuse(ODO_TEXT("ui.no_marker_to_print", "no marker to print"),
                          ODO_TEXT("ui.name_one_marker", "name at least one, for example O"));
        if (spec.labels.size() > mostTags)
            return refuse(ODO_TEXT("ui.only_so_many_tags", "only %1 tags exist")(mostTags),
                          ODO_TEXT("ui.print_fewer_markers", "print fewer markers"));
        return {};
    }
    if (std::min(spec.columns, spec.rows) < fewestCorners || std::max(spec.columns, spec.rows) > mostCorners)
        return refuse(ODO_TEXT("ui.board_has_corners", "a board has 3 to 30 inner corners each way"),
                      ODO_TEXT("ui.give_board_size", "give a size such as 9x6"));
    if (spec.kind == TargetKind::Charuco && (spec.rows + 1) % 2 == 0)
        return refuse(
            ODO_TEXT("ui.charuco_numbered_in_two_ways",
                     "programs number a ChArUco board with %1 rows of squares in two different ways")(
                spec.rows + 1),
            ODO_TEXT("ui.take_even_rows", "use an even number of rows of inner corners, such as 9x6"));
    if (spec.kind == TargetKind::Charuco &&
        CharucoLayout{spec.columns + 1, spec.rows + 1, false}.markerCount() > mostCharucoMarkers)
        return refuse(
            ODO_TEXT("ui.only_so_many_charuco_markers", "only 250 markers exist for a ChArUco board"),
            ODO_TEXT("ui.take_fewer_squares", "use fewer squares"));
    return {};
}

/// How much larger the target could be on a paper of this size.
double roomFor(QSizeF paperMm, QSizeF drawingMm)
{
    return std::min((paperMm.width() - 2 * targetMarginMm) / drawingMm.width(),
                    (paperMm.height() - 2 * targetMarginMm - targetFootMm) / drawingMm.height());
}

} // namespace

bool isBoard(TargetKind kind)
{
    return kind == TargetKind::Checkerboard || kind == TargetKind::Charuco;
}

Result<std::vector<TargetSheet>> layOutTarget(const TargetSpec &spec)
{
    if (spec.kind == TargetKind::Mat)
        return layOutMat(spec);
    ODO_TRY(checkDrawable(spec));
    const bool board = isBoard(spec.kind);
    const double unitMm = toMillimetres(board ? spec.squareM : spec.markerM);
    if (!std::isfinite(unitMm) || unitMm <= 0)
        return refuse(ODO_TEXT("ui.size_is_no_length", "its size is not a length"),
                      board ? ODO_TEXT("ui.give_square_side", "give the side of a square, such as 25mm")
                            : ODO_TEXT("ui.give_marker_size", "give its size, such as 150mm"));
    const QSizeF drawingMm =
        board ? unitMm * QSizeF(spec.columns + 1, spec.rows + 1) : QSizeF(unitMm, unitMm);
    // A tag can only be read with a white rim of one of its eight cells.
    const QSizeF roomMm = spec.kind == TargetKind::Tags ? drawingMm * 1.25 : drawingMm;
    const QSizeF upright = QPageSize(spec.paper).size(QPageSize::Millimeter);
    const QSizeF paperMm =
        roomFor(upright, roomMm) >= roomFor(upright.transposed(), roomMm) ? upright : upright.transposed();
    if (const double room = roomFor(paperMm, roomMm); room < 1)
        return refuse(
            ODO_TEXT("ui.does_not_fit_on", "%1 by %2 do not fit on %3")(
                quantity(roomMm.width(), 0), quantity(roomMm.height(), 0, "mm"),
                QPageSize(spec.paper).name().toStdString()),
            (board ? ODO_TEXT("ui.make_squares_smaller", "make the squares at most %1, or use larger paper")
                   : ODO_TEXT("ui.make_marker_smaller", "make it at most %1, or use larger paper"))(
                quantity(std::floor(room * unitMm), 0, "mm")));
    const QRectF positionMm(QPointF(0.5 * (paperMm.width() - drawingMm.width()),
                                    0.5 * (paperMm.height() - targetFootMm - drawingMm.height())),
                            drawingMm);
    const QTransform onPaper(unitMm, 0, 0, unitMm, positionMm.x(), positionMm.y());
    if (board)
        return std::vector<TargetSheet>{{paperMm, positionMm, onPaper.map(boardInk(spec)), {}, -1}};
    std::vector<TargetSheet> sheets;
    for (int i = 0; i < spec.labels.size(); ++i) {
        const bool tag = spec.kind == TargetKind::Tags;
        sheets.push_back(
            {paperMm, positionMm, onPaper.map(tag ? tagInk(i) : ringInk()), spec.labels.at(i), tag ? i : -1});
    }
    return sheets;
}

namespace {

constexpr double rulerMm = 100, rulerStepMm = 10;
constexpr double tickMm = 6;
constexpr double largestLetterMm = 45, smallestLetterMm = 12;
constexpr double millimetresAnInch = 25.4;
constexpr int printResolution = 1200; // a cell's edge lands within 0.02 mm

class TargetPainter
{
    Q_DECLARE_TR_FUNCTIONS(TargetPainter)
};

void paintRuler(QPainter &painter, QPointF start)
{
    painter.drawLine(start, start + QPointF(rulerMm, 0));
    for (double mm = 0; mm <= rulerMm; mm += rulerStepMm) {
        const bool half = mm == 0 || mm == rulerMm / 2 || mm == rulerMm;
        painter.drawLine(start + QPointF(mm, 0), start + QPointF(mm, half ? -4 : -2.5));
        if (half)
            paintText(painter, {start.x() + mm - 15, start.y() - 8.5, 30, 4}, sheetTextMm,
                      Qt::AlignHCenter | Qt::AlignVCenter,
                      mm < rulerMm ? QLocale().toString(mm, 'f', 0) : TargetPainter::tr("100 mm"));
    }
}

QString length(double metres)
{
    return TargetPainter::tr("%1 mm").arg(QLocale().toString(toMillimetres(metres), 'g', 5));
}

QString title(const TargetSpec &spec, const TargetSheet &sheet)
{
    switch (spec.kind) {
    case TargetKind::Checkerboard:
        return TargetPainter::tr("Checkerboard, %1 × %2 inner corners, squares of %3")
            .arg(spec.columns)
            .arg(spec.rows)
            .arg(length(spec.squareM));
    case TargetKind::Charuco:
        return TargetPainter::tr("ChArUco board, %1 × %2 inner corners, squares of %3")
            .arg(spec.columns)
            .arg(spec.rows)
            .arg(length(spec.squareM));
    case TargetKind::Tags:
        return TargetPainter::tr("Floor marker %1 (tag 36h11 number %2), %3")
            .arg(sheet.label)
            .arg(sheet.tag)
            .arg(length(spec.markerM));
    case TargetKind::Rings:
        return TargetPainter::tr("Floor marker %1 (ring), %2").arg(sheet.label, length(spec.markerM));
    case TargetKind::Mat:
        return TargetPainter::tr("Floor mat of %1 × %2 sheets").arg(spec.columns).arg(spec.rows);
    }
    return {};
}

QString advice(TargetKind kind)
{
    return isBoard(kind)
               ? TargetPainter::tr("Print at 100 % (actual size). Glue it flat onto something stiff, measure "
                                   "a square, and enter its side in Odograph.")
               : TargetPainter::tr("Print at 100 % (actual size). Lay it flat; the marker's position is its "
                                   "middle, where the four lines at the edges point.");
}

void paintMarker(QPainter &painter, const TargetSheet &sheet)
{
    const QPointF middle = sheet.drawingMm.center();
    const double right = sheet.paperMm.width() - targetMarginMm,
                 bottom = sheet.paperMm.height() - targetMarginMm - targetFootMm;
    painter.drawLine(QPointF(targetMarginMm, middle.y()), QPointF(targetMarginMm + tickMm, middle.y()));
    painter.drawLine(QPointF(right - tickMm, middle.y()), QPointF(right, middle.y()));
    painter.drawLine(QPointF(middle.x(), targetMarginMm), QPointF(middle.x(), targetMarginMm + tickMm));
    painter.drawLine(QPointF(middle.x(), bottom - tickMm), QPointF(middle.x(), bottom));
    // Above the target and its white rim, and as large as fits: it is read from standing height.
    const double rim = sheet.drawingMm.height() / 6;
    const double letter =
        std::clamp(sheet.drawingMm.top() - rim - targetMarginMm, smallestLetterMm, largestLetterMm);
    paintText(painter, {targetMarginMm, targetMarginMm, middle.x() - targetMarginMm - tickMm, letter}, letter,
              Qt::AlignLeft | Qt::AlignTop, sheet.label, true);
}

} // namespace

void paintTarget(QPainter &painter, const TargetSpec &spec, const TargetSheet &sheet)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(sheet.ink, Qt::black);
    if (spec.kind == TargetKind::Mat) {
        paintMatSheet(painter, matOf(spec), sheet);
        painter.restore();
        return;
    }
    painter.setPen(QPen(Qt::black, sheetLineMm, Qt::SolidLine, Qt::FlatCap));
    if (!isBoard(spec.kind))
        paintMarker(painter, sheet);
    const double foot = sheet.paperMm.height() - targetMarginMm;
    paintRuler(painter, {targetMarginMm, foot - 1});
    const double left = targetMarginMm + rulerMm + 12, width = sheet.paperMm.width() - targetMarginMm - left;
    paintText(painter, {left, foot - targetFootMm + 2, width, targetFootMm - 1}, sheetTextMm,
              Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap,
              title(spec, sheet) + QLatin1Char('\n') + advice(spec.kind));
    painter.restore();
}

namespace {

tl::unexpected<Error> notPrinted()
{
    return fail(ErrorCode::Io, targetSubject(), ODO_TEXT("ui.not_printed", "it could not be printed"),
                ODO_TEXT("ui.is_printer_ready", "check that the printer is ready"));
}

} // namespace

Result<void> printTarget(QPagedPaintDevice &device, const TargetSpec &spec,
                         const std::vector<TargetSheet> &sheets)
{
    QPainter painter;
    for (const TargetSheet &sheet : sheets) {
        const bool upright = sheet.paperMm.height() >= sheet.paperMm.width();
        device.setPageLayout(QPageLayout(QPageSize(spec.paper),
                                         upright ? QPageLayout::Portrait : QPageLayout::Landscape, {},
                                         QPageLayout::Millimeter));
        if (painter.isActive() ? !device.newPage() : !painter.begin(&device))
            return notPrinted();
        // Printers begin where they can print; the sheet begins at the edge of the paper.
        const QRectF printable = device.pageLayout().paintRect(QPageLayout::Millimeter);
        painter.resetTransform();
        painter.scale(device.logicalDpiX() / millimetresAnInch, device.logicalDpiY() / millimetresAnInch);
        painter.translate(-printable.topLeft());
        paintTarget(painter, spec, sheet);
    }
    if (!painter.end())
        return notPrinted();
    return {};
}

Result<void> writeTargetPdf(const TargetSpec &spec, const OutputTarget &target)
{
    const auto sheets = ODO_TRY(layOutTarget(spec));
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&buffer);
    pdf.setResolution(printResolution);
    pdf.setCreator(QStringLiteral("Odograph"));
    pdf.setTitle(title(spec, sheets.front()));
    ODO_TRY(printTarget(pdf, spec, sheets));
    return writeOutput(target, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace odo
