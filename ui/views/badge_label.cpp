// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/badge_label.h"

#include "ui/views/theme.h"

#include <QPainter>

namespace odo {

BadgeLabel::BadgeLabel(const Badge &badge, QWidget *parent) : QLabel(parent)
{
    setTextFormat(Qt::PlainText);
    setAlignment(Qt::AlignCenter);
    setContentsMargins(8, 1, 8, 1);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Maximum);
    setBadge(badge);
}

void BadgeLabel::setBadge(const Badge &badge)
{
    m_state = badge.state;
    setText(badge.text);
    setHidden(badge.text.isEmpty());
    update();
}

void BadgeLabel::paintEvent(QPaintEvent *)
{
    const BadgeColours colours = badgeColours(m_state, palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.ground);
    const qreal radius = qMin(9.0, height() / 2.0);
    painter.drawRoundedRect(rect(), radius, radius);
    painter.setPen(colours.text);
    painter.drawText(contentsRect(), Qt::AlignCenter, text());
}

} // namespace odo
