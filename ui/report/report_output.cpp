// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_output.h"

#include "core/project/project.h"

#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QPrinter>
#include <algorithm>

namespace odo {

namespace {

constexpr int dotsPerInch = 1200; // lines are vectors; this is the grid of their ends

QPageLayout layoutOf(const PageFormat &format)
{
    return {QPageSize(format.paper == Paper::Letter ? QPageSize::Letter : QPageSize::A4),
            format.isLandscape ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)};
}

tl::unexpected<Error> noPage(Message what)
{
    return fail(ErrorCode::InvalidInput, std::move(what), ODO_TEXT("ui.no_page", "it has no page"),
                ODO_TEXT("ui.choose_trial_or_class", "choose a trial or a class"));
}

} // namespace

PdfFile::PdfFile(OutputTarget target, const QString &title) : m_target(std::move(target)), m_title(title) {}

PdfFile::~PdfFile() = default;

Result<void> PdfFile::begin(const PageFormat &format)
{
    m_output = ODO_TRY(OutputFile::open(m_target, FileKind::Pdf));
    if (!m_file.open(m_output->descriptor(), QIODevice::WriteOnly))
        return m_output->failure(m_file.errorString().toStdString());
    m_writer = std::make_unique<QPdfWriter>(&m_file);
    m_writer->setTitle(m_title);
    m_writer->setCreator(QStringLiteral("Odograph " ODOGRAPH_VERSION));
    m_writer->setResolution(dotsPerInch);
    m_writer->setPageLayout(layoutOf(format));
    m_painter = std::make_unique<QPainter>(m_writer.get());
    return {};
}

Result<void> PdfFile::add(const ReportPage &page)
{
    if (!m_writer) {
        ODO_TRY(begin(page.format));
    } else {
        m_writer->setPageLayout(layoutOf(page.format));
        m_writer->newPage();
    }
    m_painter->save();
    m_painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    m_painter->scale(dotsPerInch / PageFormat::unitsPerInch, dotsPerInch / PageFormat::unitsPerInch);
    page.paint(*m_painter);
    m_painter->restore();
    if (m_file.error() != QFileDevice::NoError)
        return m_output->failure(m_file.errorString().toStdString());
    return {};
}

Result<void> PdfFile::finish()
{
    if (!m_writer)
        return noPage(ODO_TEXT("ui.report_file", "report '%1'")(Named::file(m_target.file)));
    m_painter->end();
    m_painter.reset();
    m_writer.reset();
    if (!m_file.flush() || m_file.error() != QFileDevice::NoError)
        return m_output->failure(m_file.errorString().toStdString());
    m_file.close();
    return m_output->commit();
}

namespace {

tl::unexpected<Error> failure(const QPrinter &printer, Message why)
{
    return fail(ErrorCode::Io,
                ODO_TEXT("ui.printing_on", "printing on '%1'")(printer.printerName().toStdString()),
                std::move(why),
                ODO_TEXT("ui.look_at_printer", "check the printer and its queue, or save the report as PDF"));
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
            return failure(*m_printer, ODO_TEXT("ui.no_further_page", "it accepts no more pages"));
    } else {
        m_painter = std::make_unique<QPainter>();
        if (!m_painter->begin(m_printer.get())) {
            m_painter.reset();
            return failure(*m_printer, ODO_TEXT("ui.printer_not_reached", "it cannot be reached"));
        }
    }
    // The margins of the page are wider than those of printers: sheet is placed on sheet.
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
        return noPage(reportSubject());
    const bool isPrinted = m_painter->end();
    m_painter.reset();
    return isPrinted ? Result<void>()
                     : failure(*m_printer, ODO_TEXT("ui.pages_not_taken", "it did not accept the pages"));
}

ReportJob::ReportJob(ReportMaker maker, std::unique_ptr<PageOutput> output)
    : m_maker(std::move(maker)), m_output(std::move(output))
{
}

Result<void> ReportJob::prepare(Project &project)
{
    m_project = project.file();
    return {};
}

Result<void> ReportJob::run(const JobControl &control)
{
    const auto project = ODO_TRY(Project::openAgain(m_project, Project::Access::ReadOnly));
    // gone with what it holds, however this ends
    const std::unique_ptr<PageOutput> output = std::move(m_output);
    auto made = m_maker(*project, control, [&](const ReportPage &page) -> Result<void> {
        ++m_pageCount;
        return output->add(page);
    });
    if (!made)
        return made;
    if (control.isCancelled())
        return cancelled(reportSubject());
    return output->finish();
}

Result<void> ReportJob::commit(Project &)
{
    return {};
}

} // namespace odo
