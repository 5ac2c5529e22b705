// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/targets/target_painter.h"

#include "core/base/units.h"
#include "core/files/output_file.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFont>
#include <QLocale>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <algorithm>

namespace odo {
namespace {

constexpr double rulerMm = 100, rulerStepMm = 10;
constexpr double lineMm = 0.25, wordsMm = 3.1;
constexpr double tickMm = 6;
constexpr double largestLetterMm = 45, smallestLetterMm = 12;
constexpr double millimetresAnInch = 25.4;
constexpr int printResolution = 1200; // a cell's edge lands within 0.02 mm

class TargetPainter
{
    Q_DECLARE_TR_FUNCTIONS(TargetPainter)
};

/// A font whose letters are so high in the painter's unit; fonts are asked for in whole units, hence the scale.
void paintText(QPainter &painter, const QRectF &placeMm, double heightMm, int flags, const QString &text, bool bold = false)
{
    constexpr double scale = 0.01;
    painter.save();
    painter.translate(placeMm.topLeft());
    painter.scale(scale, scale);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(qRound(heightMm / scale));
    font.setBold(bold);
    painter.setFont(font);
    painter.drawText(QRectF(QPointF(0, 0), placeMm.size() / scale), flags, text);
    painter.restore();
}

void paintRuler(QPainter &painter, QPointF start)
{
    painter.drawLine(start, start + QPointF(rulerMm, 0));
    for (double mm = 0; mm <= rulerMm; mm += rulerStepMm) {
        const bool half = mm == 0 || mm == rulerMm / 2 || mm == rulerMm;
        painter.drawLine(start + QPointF(mm, 0), start + QPointF(mm, half ? -4 : -2.5));
        if (half)
            paintText(painter, {start.x() + mm - 15, start.y() - 8.5, 30, 4}, wordsMm, Qt::AlignHCenter | Qt::AlignVCenter,
                      mm < rulerMm ? QLocale().toString(mm, 'f', 0) : TargetPainter::tr("100 mm"));
    }
}

QString length(double metres) { return TargetPainter::tr("%1 mm").arg(QLocale().toString(toMillimetres(metres), 'g', 5)); }

QString title(const TargetSpec &spec, const TargetSheet &sheet)
{
    switch (spec.kind) {
    case TargetKind::Checkerboard:
        return TargetPainter::tr("Checkerboard, %1 × %2 inner corners, squares of %3").arg(spec.columns).arg(spec.rows).arg(length(spec.squareM));
    case TargetKind::Charuco:
        return TargetPainter::tr("ChArUco board, %1 × %2 inner corners, squares of %3").arg(spec.columns).arg(spec.rows).arg(length(spec.squareM));
    case TargetKind::Tags:
        return TargetPainter::tr("Floor marker %1 (tag 36h11 number %2), %3").arg(sheet.label).arg(sheet.tag).arg(length(spec.markerM));
    case TargetKind::Rings:
        return TargetPainter::tr("Floor marker %1 (ring), %2").arg(sheet.label, length(spec.markerM));
    }
    return {};
}

QString advice(TargetKind kind)
{
    return isBoard(kind) ? TargetPainter::tr("Print at 100 % (actual size). Glue it flat onto something stiff, measure a square, and tell "
                                 "Odograph what you measured.")
                         : TargetPainter::tr("Print at 100 % (actual size). Lay it flat; the marker's place is its middle, where the four "
                                 "lines at the edges point.");
}

void paintMarker(QPainter &painter, const TargetSheet &sheet)
{
    const QPointF middle = sheet.figureMm.center();
    const double right = sheet.paperMm.width() - targetMarginMm, bottom = sheet.paperMm.height() - targetMarginMm - targetFootMm;
    painter.drawLine(QPointF(targetMarginMm, middle.y()), QPointF(targetMarginMm + tickMm, middle.y()));
    painter.drawLine(QPointF(right - tickMm, middle.y()), QPointF(right, middle.y()));
    painter.drawLine(QPointF(middle.x(), targetMarginMm), QPointF(middle.x(), targetMarginMm + tickMm));
    painter.drawLine(QPointF(middle.x(), bottom - tickMm), QPointF(middle.x(), bottom));
    // Above the figure and its white rim, and as large as there is room: it is read standing.
    const double rim = sheet.figureMm.height() / 6;
    const double letter = std::clamp(sheet.figureMm.top() - rim - targetMarginMm, smallestLetterMm, largestLetterMm);
    paintText(painter, {targetMarginMm, targetMarginMm, middle.x() - targetMarginMm - tickMm, letter}, letter,
              Qt::AlignLeft | Qt::AlignTop, sheet.label, true);
}

} // namespace

void paintTarget(QPainter &painter, const TargetSpec &spec, const TargetSheet &sheet)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(sheet.ink, Qt::black);
    painter.setPen(QPen(Qt::black, lineMm, Qt::SolidLine, Qt::FlatCap));
    if (!isBoard(spec.kind))
        paintMarker(painter, sheet);
    const double foot = sheet.paperMm.height() - targetMarginMm;
    paintRuler(painter, {targetMarginMm, foot - 1});
    const double left = targetMarginMm + rulerMm + 12, width = sheet.paperMm.width() - targetMarginMm - left;
    paintText(painter, {left, foot - targetFootMm + 2, width, targetFootMm - 1}, wordsMm, Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap,
              title(spec, sheet) + QLatin1Char('\n') + advice(spec.kind));
    painter.restore();
}

Result<void> printTarget(QPagedPaintDevice &device, const TargetSpec &spec, const std::vector<TargetSheet> &sheets)
{
    QPainter painter;
    for (const TargetSheet &sheet : sheets) {
        const bool upright = sheet.paperMm.height() >= sheet.paperMm.width();
        device.setPageLayout(QPageLayout(QPageSize(spec.paper), upright ? QPageLayout::Portrait : QPageLayout::Landscape, {},
                                         QPageLayout::Millimeter));
        if (painter.isActive() ? !device.newPage() : !painter.begin(&device))
            return fail(ErrorCode::Io, "target", "it could not be printed", "look whether the printer is ready");
        // Printers begin where they can print; the sheet begins at the edge of the paper.
        const QRectF printable = device.pageLayout().paintRect(QPageLayout::Millimeter);
        painter.resetTransform();
        painter.scale(device.logicalDpiX() / millimetresAnInch, device.logicalDpiY() / millimetresAnInch);
        painter.translate(-printable.topLeft());
        paintTarget(painter, spec, sheet);
    }
    if (!painter.end())
        return fail(ErrorCode::Io, "target", "it could not be printed", "look whether the printer is ready");
    return {};
}

Result<void> writeTargetPdf(const TargetSpec &spec, const OutputTarget &target)
{
    const auto sheets = layOutTarget(spec);
    if (!sheets)
        return tl::unexpected(sheets.error());
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter pdf(&buffer);
    pdf.setResolution(printResolution);
    pdf.setCreator(QStringLiteral("Odograph"));
    pdf.setTitle(title(spec, sheets->front()));
    if (auto printed = printTarget(pdf, spec, *sheets); !printed)
        return printed;
    return writeOutput(target, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace odo
