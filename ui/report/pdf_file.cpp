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

PdfFile::PdfFile(const std::filesystem::path &file, const QString &title)
    : m_title(title), m_file(QString::fromStdString(file.string()))
{
}

PdfFile::~PdfFile() = default;

tl::unexpected<Error> PdfFile::failure() const
{
    return fail(ErrorCode::Io, "report '" + m_file.fileName().toStdString() + "'", m_file.errorString().toStdString(),
                "check the folder, the rights and the room on the disk; nothing was written");
}

Result<void> PdfFile::begin(const PageFormat &format)
{
    if (!m_file.open(QIODevice::WriteOnly))
        return failure();
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
        return failure();
    return {};
}

Result<void> PdfFile::finish()
{
    if (!m_writer)
        return fail(ErrorCode::InvalidInput, "report '" + m_file.fileName().toStdString() + "'", "it has no page",
                    "choose a trial or a class");
    m_painter->end();
    m_painter.reset();
    m_writer.reset();
    if (!m_file.commit())
        return failure();
    return {};
}

} // namespace odo
