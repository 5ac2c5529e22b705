// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/floor_read_out.h"

#include "ui/models/number_text.h"
#include "ui/views/image/camera_view.h"

#include <QLocale>
#include <QStringList>
#include <utility>

namespace odo {

namespace {

QString pixelText(const QPointF &pixel)
{
    QLocale plain;
    plain.setNumberOptions(plain.numberOptions() | QLocale::OmitGroupSeparator);
    return FloorReadOut::tr("u %1 · v %2 px")
        .arg(plain.toString(pixel.x(), 'f', 1), plain.toString(pixel.y(), 'f', 1));
}

} // namespace

PixelOnFloor pixelOnFloor(const FloorRegistration &registration, const FloorView &view)
{
    return [view, sigmaPx = readSigmaPx(registration)](const QPointF &pixel) -> std::optional<ReadPosition> {
        const auto position =
            view.locate({pixel.x(), pixel.y()}, sigmaPx * sigmaPx * Eigen::Matrix2d::Identity(), 0);
        if (!position)
            return std::nullopt;
        return ReadPosition{position->pointInWorld,
                            position->pixelCovariance + position->calibrationCovariance};
    };
}

FloorReadOut::FloorReadOut(CameraView &view) : QObject(&view), m_view(view)
{
    connect(&view, &CameraView::hovered, this, &FloorReadOut::show);
}

void FloorReadOut::setReading(PixelOnFloor reading)
{
    m_reading = std::move(reading);
    show(m_pixel);
}

void FloorReadOut::show(const std::optional<QPointF> &pixel)
{
    m_pixel = pixel;
    const auto read = m_reading && pixel ? m_reading(*pixel) : std::optional<ReadPosition>();
    m_floorText = read ? tr("x %1 · y %2")
                             .arg(coordinateText(read->pointInWorld.x(), read->sigmaM().x()),
                                  coordinateText(read->pointInWorld.y(), read->sigmaM().y()))
                       : QString();
    QStringList parts;
    if (m_reading && pixel) // the floor first: the end may be cut off
        parts << (read ? m_floorText : tr("Not on the floor"));
    if (pixel)
        parts << pixelText(*pixel);
    m_view.setReadOut(parts.join(QStringLiteral(" · ")));
    Q_EMIT shown();
}

} // namespace odo
