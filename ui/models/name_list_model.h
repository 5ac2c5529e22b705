// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QStringList>

namespace odo {

/// Names for a list to choose from, each with the words that it is shown by. For thousands of them: a combo
/// box's own items would take longer than the window may. GUI thread.
class NameListModel : public QAbstractListModel
{
    Q_OBJECT
public:
    enum Roles {
        NameRole = Qt::UserRole, ///< QString
    };
    /// words: as many as names.
    NameListModel(QStringList names, QStringList words, QObject *parent = nullptr);
    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    int indexOf(const QString &name) const { return static_cast<int>(m_names.indexOf(name)); } ///< −1: none

private:
    const QStringList m_names, m_words;
};

} // namespace odo
