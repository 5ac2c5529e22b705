// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/patient_layer.h"

#include "ui/views/charts/chart_image.h"

#include <QPainter>
#include <QWidget>
#include <utility>

namespace odo {

namespace {

void paintWith(QPainter &painter, const QFont &font, const PatientLayer::Paint &paint)
{
    painter.setFont(font);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
}

} // namespace

PatientLayer::PatientLayer(QWidget &view) : QObject(&view), m_view(view)
{
    connect(&m_task, &BackgroundTask::finished, this, &PatientLayer::take);
}

void PatientLayer::forget()
{
    m_shown = {};
    m_made.reset(); // what is being painted is of no use any more
    m_isStale = true;
}

PatientLayer::Painted PatientLayer::emptyAt(const QRectF &frame) const
{
    Painted painted{QImage((QSizeF(m_view.size()) * m_view.devicePixelRatioF()).toSize(),
                           QImage::Format_ARGB32_Premultiplied),
                    frame};
    painted.image.setDevicePixelRatio(m_view.devicePixelRatioF());
    painted.image.fill(Qt::transparent);
    return painted;
}

void PatientLayer::draw(QPainter &painter, const QRectF &frame, bool isLong,
                        const std::function<Paint()> &make)
{
    if (ChartImage::isPaintedBy(painter, m_view)) {
        painter.save();
        paintWith(painter, m_view.font(), make());
        painter.restore();
        return;
    }
    if (m_isStale && isLong && !m_shown.image.isNull()) {
        if (!m_task.isRunning()) // else once that is there
            paintSoon(frame, make());
    } else if (m_isStale) {
        m_isStale = false;
        m_shown = emptyAt(frame);
        QPainter layer(&m_shown.image);
        paintWith(layer, m_view.font(), make());
    }
    const double wider = frame.width() / m_shown.frame.width(),
                 higher = frame.height() / m_shown.frame.height();
    const QSizeF size = m_view.size();
    const QRectF now(frame.left() - wider * m_shown.frame.left(), frame.top() - higher * m_shown.frame.top(),
                     wider * size.width(), higher * size.height());
    if (m_shown.frame == frame)
        painter.drawImage(QPointF(0, 0), m_shown.image);
    else
        painter.drawImage(now, m_shown.image);
}

void PatientLayer::paintSoon(const QRectF &frame, Paint paint)
{
    m_isStale = false;
    m_made = std::make_shared<Painted>(emptyAt(frame));
    m_task.start(
        [made = m_made, font = m_view.font(), paint = std::move(paint)](const JobControl &) -> Result<void> {
            QPainter painter(&made->image);
            paintWith(painter, font, paint);
            return {};
        });
}

void PatientLayer::take()
{
    if (m_made)
        m_shown = std::move(*std::exchange(m_made, nullptr));
    m_view.update();
    Q_EMIT ready();
}

} // namespace odo
