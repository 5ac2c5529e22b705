// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/report_page.h"

#include <QPainter>
#include <cmath>

namespace odo {

namespace {

const QString letterWord = QStringLiteral("letter");

} // namespace

Paper paperFromWord(const QString &word)
{
    return word == letterWord ? Paper::Letter : Paper::A4;
}

QString paperWord(Paper paper)
{
    return paper == Paper::Letter ? letterWord : QStringLiteral("a4");
}

QSizeF PageFormat::size() const
{
    constexpr double perMm = unitsPerInch / 25.4;
    const QSizeF upright = paper == Paper::Letter ? QSizeF(8.5, 11) * unitsPerInch : QSizeF(210, 297) * perMm;
    return isLandscape ? upright.transposed() : upright;
}

QRectF PageFormat::content() const
{
    return QRectF(QPointF(0, 0), size()).adjusted(margin, margin, -margin, -margin);
}

QImage pagePicture(const ReportPage &page, int widthPx)
{
    const QSizeF size = page.format.size();
    const double scale = widthPx / size.width();
    QImage picture(widthPx, int(std::lround(size.height() * scale)), QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
    painter.scale(scale, scale);
    page.paint(painter);
    return picture;
}

} // namespace odo
