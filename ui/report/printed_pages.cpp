// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/printed_pages.h"

#include <QPainter>
#include <QPrinter>
#include <algorithm>

namespace odo {

namespace {

tl::unexpected<Error> failure(const QPrinter &printer, const char *why)
{
    return fail(ErrorCode::Io, "printing on '" + printer.printerName().toStdString() + "'", why,
                "look at the printer and its queue, or save the report as PDF");
}

} // namespace

PrintedPages::PrintedPages(std::unique_ptr<QPrinter> printer) : m_printer(std::move(printer)) {}

PrintedPages::~PrintedPages()
{
    if (m_painter)
        m_printer->abort();
}

Result<void> PrintedPages::add(const ReportPage &page)
{
    m_printer->setPageOrientation(page.format.isLandscape ? QPageLayout::Landscape : QPageLayout::Portrait);
    if (m_painter) {
        if (!m_printer->newPage())
            return failure(*m_printer, "it takes no further page");
    } else {
        m_painter = std::make_unique<QPainter>();
        if (!m_painter->begin(m_printer.get())) {
            m_painter.reset();
            return failure(*m_printer, "it cannot be reached");
        }
    }
    // The margins of the page are wider than those of printers: sheet lies on sheet where it has room.
    const QSizeF sheet = page.format.size();
    const QRectF paper = m_printer->paperRect(QPrinter::DevicePixel),
                 printable = m_printer->pageRect(QPrinter::DevicePixel);
    const double scale = std::min(paper.width() / sheet.width(), paper.height() / sheet.height());
    m_painter->save();
    m_painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    m_painter->translate(paper.topLeft() - printable.topLeft());
    m_painter->scale(scale, scale);
    page.paint(*m_painter);
    m_painter->restore();
    return {};
}

Result<void> PrintedPages::finish()
{
    if (!m_painter)
        return fail(ErrorCode::InvalidInput, "report", "it has no page", "choose a trial or a class");
    const bool isPrinted = m_painter->end();
    m_painter.reset();
    return isPrinted ? Result<void>() : failure(*m_printer, "it did not take the pages");
}

} // namespace odo
