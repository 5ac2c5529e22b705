// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/badge_delegate.h"

#include "ui/views/theme.h"

#include <QApplication>
#include <QPainter>

namespace odo {
namespace {

constexpr int marginPx = 6, paddingPx = 8;

} // namespace

BadgeDelegate::BadgeDelegate(int textRole, int stateRole, QObject *parent)
    : QStyledItemDelegate(parent), m_textRole(textRole), m_stateRole(stateRole)
{
}

void BadgeDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const QString text = index.data(m_textRole).toString();
    if (text.isEmpty())
        return QStyledItemDelegate::paint(painter, option, index);
    QStyleOptionViewItem ground = option; // selection and focus as everywhere, without the words
    initStyleOption(&ground, index);
    ground.text.clear();
    (ground.widget ? ground.widget->style() : QApplication::style())->drawControl(QStyle::CE_ItemViewItem, &ground, painter, ground.widget);
    const BadgeColours colours = badgeColours(static_cast<BadgeState>(index.data(m_stateRole).toInt()), option.palette);
    const QFontMetrics metrics(ground.font);
    QRect badge(0, 0, metrics.horizontalAdvance(text) + 2 * paddingPx, metrics.height() + 2);
    badge.moveCenter(option.rect.center());
    badge.moveLeft(option.rect.left() + marginPx);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(ground.font);
    painter->setPen(Qt::NoPen);
    painter->setBrush(colours.ground);
    painter->drawRoundedRect(badge, badge.height() / 2.0, badge.height() / 2.0);
    painter->setPen(colours.text);
    painter->drawText(badge, Qt::AlignCenter, text);
    painter->restore();
}

QSize BadgeDelegate::sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const
{
    const QSize plain = QStyledItemDelegate::sizeHint(option, index);
    const QFontMetrics metrics(option.font);
    const int width = metrics.horizontalAdvance(index.data(m_textRole).toString()) + 2 * (paddingPx + marginPx);
    return {std::max(plain.width(), width), std::max(plain.height(), metrics.height() + 6)};
}

} // namespace odo
