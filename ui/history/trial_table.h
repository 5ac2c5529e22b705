// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTableView>

namespace odo {

class TrialModel;

/// The list of trials in History: rows that are sorted by their headings, chosen one by one or many, and opened by a double click or Enter. Its
/// columns are fitted to its width, whatever that becomes. GUI thread.
class TrialTable : public QTableView
{
    Q_OBJECT
public:
    /// The model must outlive it.
    explicit TrialTable(TrialModel &model, QWidget *parent = nullptr);
    /// Empty: none.
    QString currentTrial() const;
    QStringList selectedTrials() const; ///< from top to bottom
    /// Stores what is being written into a cell, which ends with it. A row that goes does so itself.
    void storeEdited();
    /// To be called after the rows have changed.
    void fit();

Q_SIGNALS:
    void opened(const QString &trial);

protected:
    void rowsAboutToBeRemoved(const QModelIndex &parent, int first, int last) override;
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
};

} // namespace odo
