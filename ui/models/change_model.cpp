// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/change_model.h"

#include "ui/models/core_words.h"

#include <QDateTime>
#include <QLocale>

namespace odo {

namespace {

QString kindWord(ChangeEntry::Kind kind)
{
    switch (kind) {
    case ChangeEntry::Kind::Made:
        return ChangeModel::tr("made");
    case ChangeEntry::Kind::Undone:
        return ChangeModel::tr("undone");
    case ChangeEntry::Kind::Redone:
        return ChangeModel::tr("made again");
    }
    return {};
}

} // namespace

ChangeModel::ChangeModel(std::vector<ChangeEntry> changes, QObject *parent)
    : RowTableModel(ColumnCount, parent), m_changes(std::move(changes))
{
    setText({});
}

void ChangeModel::setText(const QString &text)
{
    beginResetModel();
    m_shown.clear();
    for (std::size_t i = 0; i < m_changes.size(); ++i)
        if (shownWords(m_changes[i].words).contains(text, Qt::CaseInsensitive))
            m_shown.push_back(i);
    endResetModel();
}

QVariant ChangeModel::cell(int index, int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    const ChangeEntry &change = m_changes[m_shown[static_cast<std::size_t>(index)]];
    switch (column) {
    case DateColumn:
        return QLocale().toString(QDateTime::fromMSecsSinceEpoch(change.made.time_since_epoch().count()),
                                  QLocale::ShortFormat);
    case KindColumn:
        return kindWord(change.kind);
    default:
        return shownWords(change.words);
    }
}

QVariant ChangeModel::heading(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case DateColumn:
        return tr("When");
    case KindColumn:
        return tr("How");
    default:
        return tr("What");
    }
}

} // namespace odo
