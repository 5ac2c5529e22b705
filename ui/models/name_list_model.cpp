// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/name_list_model.h"

namespace odo {

NameListModel::NameListModel(QStringList names, QStringList words, QObject *parent)
    : QAbstractListModel(parent), m_names(std::move(names)), m_words(std::move(words))
{
    Q_ASSERT(m_names.size() == m_words.size());
}

int NameListModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_names.size());
}

QVariant NameListModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole)
        return m_words.at(index.row());
    return role == NameRole ? QVariant(m_names.at(index.row())) : QVariant();
}

} // namespace odo
