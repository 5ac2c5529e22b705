// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QStringList>
#include <QTableWidget>
#include <map>
#include <string>
#include <vector>

namespace odo {

/// People's own variables of one trial or several, a row each with name and value, and an empty last row for
/// a new one. Where the trials differ in a value it shows "several", which stays unless another is written.
/// GUI thread.
class VariableTable : public QTableWidget
{
    Q_OBJECT
public:
    enum Columns { NameColumn, ValueColumn, ColumnCount };

    /// known: names to complete from.
    VariableTable(const std::vector<TrialRecord> &trials, const QStringList &known,
                  QWidget *parent = nullptr);
    /// Stores what is being written into a cell.
    void storeEdited();
    /// What is to be changed in each trial; empty: it loses that variable.
    std::map<std::string, std::string> changes() const;
    /// A name that is written twice; empty: none.
    QString repeatedName() const;
    /// Removes the row that is current, if it holds a variable.
    void removeCurrent();

    QSize sizeHint() const override;

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void addRow(const QString &name, const QString &value, bool areSeveral);
    void keepEmptyRow();
    QString textAt(int row, int column) const;

    std::map<std::string, QString> m_before; ///< names that the trials have; null values: several
};

} // namespace odo
