// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QMenu>
#include <QStringList>
#include <QStyledItemDelegate>

namespace odo {

class TrialModel;
class TrialTable;

/// Edits cells of the list of trials: a date in a field for dates, other cells in a line that is completed
/// from what its column offers.
class TrialCellDelegate : public QStyledItemDelegate
{
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    /// Words to complete from, by column.
    void setOffer(const QMap<int, QStringList> &offer) { m_offer = offer; }
    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;

private:
    QMap<int, QStringList> m_offer;
};

/// Which columns the list of trials shows beside those that it always has: notes, and people's own variables.
/// A menu, also of the list's headings; remembered. GUI thread.
class TrialColumns : public QMenu
{
    Q_OBJECT
public:
    /// Both must outlive it.
    TrialColumns(TrialModel &trials, TrialTable &table);
    /// Shows and hides as was chosen. To be called after the trials have changed.
    void showChosen();

private:
    void fill();
    QStringList optional() const; ///< names of all columns that can be chosen
    void choose(const QString &column, bool isShown);

    TrialModel &m_trials;
    TrialTable &m_table;
    QStringList m_chosen;
};

} // namespace odo
