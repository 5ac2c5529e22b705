// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoreboard/internal/qr_code.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <qrencode.h>

namespace odo {

QrCode QrCode::of(const QString &text)
{
    const std::unique_ptr<QRcode, decltype(&QRcode_free)> made(
        QRcode_encodeString8bit(text.toUtf8().constData(), 0, QR_ECLEVEL_M), &QRcode_free);
    if (!made)
        return {};
    QrCode code{made->width, {}};
    const auto modules = std::size_t(made->width) * std::size_t(made->width);
    std::transform(made->data, made->data + modules, std::back_inserter(code.isDark),
                   [](unsigned char module) { return (module & 1) != 0; });
    return code;
}

QrWidget::QrWidget(QWidget *parent) : QWidget(parent)
{
    setFixedSize(240, 240);
}

void QrWidget::setText(const QString &text)
{
    m_code = text.isEmpty() ? QrCode() : QrCode::of(text);
    setAccessibleName(text);
    update();
}

void QrWidget::paintEvent(QPaintEvent *)
{
    constexpr int quietZone = 4; // modules
    if (m_code.side == 0)
        return;
    QPainter painter(this);
    painter.fillRect(rect(), Qt::white);
    // whole pixels of the screen for each module: edges between them would blur
    const double ratio = devicePixelRatioF();
    const int pixels = int(width() * ratio);
    const double module = std::max(1, pixels / (m_code.side + 2 * quietZone)) / ratio;
    const double margin = (width() - module * m_code.side) / 2;
    const QPointF origin(std::floor(margin * ratio) / ratio, std::floor(margin * ratio) / ratio);
    for (int y = 0; y < m_code.side; ++y)
        for (int x = 0; x < m_code.side; ++x)
            if (m_code.isDark[std::size_t(y) * std::size_t(m_code.side) + std::size_t(x)])
                painter.fillRect(QRectF(origin + QPointF(x * module, y * module), QSizeF(module, module)),
                                 Qt::black);
}

} // namespace odo
