// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QWidget>

class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace odo {

class Card;
class Project;
class TrialDetail;
class TrialModel;

/// History: all trials of the project, searched, sorted and opened; what is known of the one that is
/// selected. Uses the project on its own thread. The project must outlive the page.
class HistoryPage : public QWidget
{
    Q_OBJECT
public:
    explicit HistoryPage(Project &project, QWidget *parent = nullptr);

    /// Reads the project, keeping the selection. Call it once the signals are connected, and after every
    /// change.
    void refresh();
    void selectTrial(const QString &name);

Q_SIGNALS:
    void trialChosen(const QString &name); ///< to be opened in Review
    void compareRequested(const QStringList &trials); ///< two or more
    void notesChanged(const QString &trial);
    void failed(const odo::Error &error);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makeTable();
    QString currentTrial() const;
    QStringList selectedTrials() const; ///< from top to bottom
    void showSelection();
    void filter(const QString &text);
    void showCurrent();
    void showCount();

    Project &m_project;
    TrialModel *m_trials;
    QSortFilterProxyModel *m_sorted;
    QLineEdit *m_search;
    QPushButton *m_compare;
    QTableView *m_table;
    Card *m_tableCard = nullptr;
    TrialDetail *m_detail;
};

} // namespace odo
