// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/table_list.h"

#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QHeaderView>
#include <QPainter>
#include <QTableView>
#include <algorithm>

namespace odo {

namespace {

constexpr int marginPx = 6, paddingPx = 8;

} // namespace

BadgeDelegate::BadgeDelegate(int textRole, int stateRole, QObject *parent)
    : QStyledItemDelegate(parent), m_textRole(textRole), m_stateRole(stateRole)
{
}

void BadgeDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const
{
    const QString text = index.data(m_textRole).toString();
    if (text.isEmpty())
        return QStyledItemDelegate::paint(painter, option, index);
    QStyleOptionViewItem ground = option; // selection and focus as everywhere, without the words
    initStyleOption(&ground, index);
    ground.text.clear();
    (ground.widget ? ground.widget->style() : QApplication::style())
        ->drawControl(QStyle::CE_ItemViewItem, &ground, painter, ground.widget);
    const BadgeColours colours =
        badgeColours(static_cast<BadgeState>(index.data(m_stateRole).toInt()), option.palette);
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
    const int width =
        metrics.horizontalAdvance(index.data(m_textRole).toString()) + 2 * (paddingPx + marginPx);
    return {std::max(plain.width(), width), std::max(plain.height(), metrics.height() + 6)};
}

void showAsList(QTableView &table)
{
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setShowGrid(false);
    table.setTabKeyNavigation(false);
    table.verticalHeader()->hide();
    table.horizontalHeader()->setHighlightSections(false);
    table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

namespace {

/// The widest first, pixel by pixel, down to a width or that of its heading; gives what is still missing.
int shrink(QHeaderView &header, const QList<int> &columns, int least, int missing)
{
    const auto spareOf = [&](int column) {
        return header.sectionSize(column) - std::max(least, header.sectionSizeHint(column));
    };
    for (; missing > 0; --missing) {
        const auto widest = std::ranges::max_element(
            columns, {}, [&](int column) { return spareOf(column) > 0 ? header.sectionSize(column) : 0; });
        if (widest == columns.end() || spareOf(*widest) <= 0)
            break;
        header.resizeSection(*widest, header.sectionSize(*widest) - 1);
    }
    return missing;
}

} // namespace

void fitColumns(QTableView &table, int taking, const QList<int> &shrinkable)
{
    table.resizeColumnsToContents();
    QHeaderView &header = *table.horizontalHeader();
    const int letter = table.fontMetrics().averageCharWidth(), least = 8 * letter, leastFirst = 12 * letter,
              enough = 16 * letter;
    const int spare = table.viewport()->width() - header.length();
    if (spare > 0)
        return header.resizeSection(taking, header.sectionSize(taking) + spare);
    int missing = -spare;
    missing = shrink(header, shrinkable, enough, missing);
    missing = shrink(header, shrinkable.mid(1), least, missing);
    shrink(header, shrinkable.mid(0, 1), leastFirst, missing);
}

} // namespace odo
