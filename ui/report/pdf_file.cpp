// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/pdf_file.h"

#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

namespace odo {

namespace {

constexpr int dotsPerInch = 1200; // lines are vectors; this is the grid of their ends

QPageLayout layoutOf(const PageFormat &format)
{
    return {QPageSize(format.paper == Paper::Letter ? QPageSize::Letter : QPageSize::A4),
            format.isLandscape ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)};
}

} // namespace

PdfFile::PdfFile(OutputTarget target, const QString &title) : m_target(std::move(target)), m_title(title) {}

PdfFile::~PdfFile() = default;

Result<void> PdfFile::begin(const PageFormat &format)
{
    auto opened = OutputFile::open(m_target, FileKind::Pdf);
    if (!opened)
        return tl::unexpected(opened.error());
    m_output = std::move(*opened);
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
        if (auto begun = begin(page.format); !begun)
            return begun;
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
        return fail(ErrorCode::InvalidInput, "report '" + m_target.file.string() + "'", "it has no page",
                    "choose a trial or a class");
    m_painter->end();
    m_painter.reset();
    m_writer.reset();
    if (!m_file.flush() || m_file.error() != QFileDevice::NoError)
        return m_output->failure(m_file.errorString().toStdString());
    m_file.close();
    return m_output->commit();
}

} // namespace odo
