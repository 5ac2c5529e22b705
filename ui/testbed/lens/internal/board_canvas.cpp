// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/lens/internal/board_canvas.h"

#include "ui/views/image/image_painting.h"
#include "ui/views/widgets/theme.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace odo {
namespace {

// Okabe and Ito's blue, orange and sky blue: everyone can distinguish them, and the shapes differ too.
const QColor keptColour(0, 158, 115), seenColour(230, 159, 0), wantedColour(86, 180, 233),
    coveredColour(0, 114, 178);
constexpr int mostShade = 90, fullAtCorners = 60;
constexpr double longestArrow = 0.08; // of the image width

} // namespace

BoardCanvas::BoardCanvas(QWidget *parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Image of the board"));
}

void BoardCanvas::setContent(Content content)
{
    m_content = std::move(content);
    update();
}

void BoardCanvas::setEmptyText(const QString &text)
{
    m_emptyText = text;
    update();
}

QRectF BoardCanvas::imageRect() const
{
    QSizeF size = m_content.size;
    size.scale(this->size(), Qt::KeepAspectRatio);
    return QRectF(QPointF(0.5 * (width() - size.width()), 0.5 * (height() - size.height())), size);
}

/// Pixel (0,0) is the centre of the first.
QPointF BoardCanvas::fromPixel(const QRectF &position, const Eigen::Vector2d &pixel) const
{
    return position.topLeft() + QPointF((pixel.x() + 0.5) * position.width() / m_content.size.width(),
                                        (pixel.y() + 0.5) * position.height() / m_content.size.height());
}

void BoardCanvas::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.imageBackground);
    if (m_content.image.isNull()) {
        painter.setPen(colours.muted);
        painter.drawText(rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
        return;
    }
    const QRectF position = imageRect();
    painter.drawImage(position, m_content.image);
    painter.setClipRect(position);
    paintCoverage(painter, position);
    paintWanted(painter, position);
    paintCorners(painter, position);
    paintResiduals(painter, position);
    if (!m_content.label.isEmpty())
        drawTag(painter, position.topLeft() + QPointF(10, 20), m_content.label, Qt::white, position);
}

void BoardCanvas::paintCoverage(QPainter &painter, const QRectF &position) const
{
    if (!m_content.coverage)
        return;
    const double w = position.width() / BoardCoverage::across, h = position.height() / BoardCoverage::down;
    for (int row = 0; row < BoardCoverage::down; ++row) {
        for (int column = 0; column < BoardCoverage::across; ++column) {
            const int count = m_content.coverage->corners[std::size_t(row * BoardCoverage::across + column)];
            if (count == 0)
                continue;
            QColor shade = coveredColour;
            shade.setAlpha(25 + (mostShade - 25) * std::min(count, fullAtCorners) / fullAtCorners);
            painter.fillRect(
                QRectF(position.x() + column * w, position.y() + row * h, w, h).adjusted(1, 1, -1, -1),
                shade);
        }
    }
}

void BoardCanvas::paintWanted(QPainter &painter, const QRectF &position) const
{
    if (!m_content.wanted)
        return;
    QPolygonF outline;
    for (const Eigen::Vector2d &corner : m_content.wanted->outline)
        outline << fromPixel(position, corner);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 150), 5));
    painter.drawPolygon(outline);
    painter.setPen(QPen(wantedColour, 2.5, Qt::DashLine));
    painter.drawPolygon(outline);
}

void BoardCanvas::paintCorners(QPainter &painter, const QRectF &position) const
{
    const double radius = 3.5;
    for (const Eigen::Vector2d &corner : m_content.corners) {
        const QPointF at = fromPixel(position, corner);
        painter.setPen(QPen(QColor(0, 0, 0, 170), 3));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, radius, radius);
        painter.setPen(QPen(m_content.counts ? keptColour : seenColour, 1.6));
        if (m_content.counts)
            painter.setBrush(keptColour);
        painter.drawEllipse(at, radius, radius);
    }
}

/// Magnified until the longest is visible; the factor is shown.
void BoardCanvas::paintResiduals(QPainter &painter, const QRectF &position) const
{
    double longest = 0;
    for (const Eigen::Vector2d &residual : m_content.residuals)
        longest = std::max(longest, residual.norm());
    if (!(longest > 0) || m_content.residuals.size() != m_content.corners.size())
        return;
    const double factor = longestArrow * m_content.size.width() / longest;
    for (std::size_t i = 0; i < m_content.corners.size(); ++i) {
        const QPointF from = fromPixel(position, m_content.corners[i]);
        const QPointF to = fromPixel(position, m_content.corners[i] + factor * m_content.residuals[i]);
        for (const auto &[colour, width] :
             {std::pair(QColor(0, 0, 0, 170), 4.0), std::pair(seenColour, 2.0)}) {
            painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(from, to);
        }
    }
    drawTag(painter, position.bottomLeft() + QPointF(10, -20),
            tr("residuals, longest %1 px").arg(QLocale().toString(longest, 'f', 2)), Qt::white, position);
}

} // namespace odo
