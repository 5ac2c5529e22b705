// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/exchange/result_statistics.h"
#include "ui/models/background_task.h"

#include <QStringList>
#include <QWidget>
#include <memory>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTableView;
class QTimer;

namespace odo {

class Card;
class Project;
class ResultsModel;
class ResultStatisticsModel;
struct ChosenOutput;

/// Results as a table: a row for each robot of each trial, chosen metrics with their σ, and beneath it mean,
/// median, standard deviation and coefficient of variation of the selected rows (or of all that are shown),
/// grouped. Copied with headings, saved as CSV or XLSX. Reads and writes on threads of its own. GUI thread.
class ResultsPanel : public QWidget
{
    Q_OBJECT
public:
    explicit ResultsPanel(Project &project, QWidget *parent = nullptr);
    ~ResultsPanel() override;
    /// Reads the project; filters, groups and metrics stay as they are chosen.
    void refresh();
    /// Teams are shown by another name now.
    void updateTeams();
    /// Nothing is being read or written.
    bool isSettled() const;

Q_SIGNALS:
    void trialChosen(const QString &name); ///< to be opened in Review
    void saved(const QString &file);
    void failed(const odo::Error &error);
    void settled();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Reading;
    void makeHeader();
    void makeTables();
    void take(Result<Reading> reading);
    void offerMetrics();
    void askOwnMetrics();
    void chooseMetric(const QString &name, bool isChosen);
    void showMetrics();
    void filter();
    void showStatistics();
    void copy(QTableView &table);
    void askSave();
    void save(const ChosenOutput &output);
    ResultGrouping grouping() const;
    std::vector<std::size_t> countedRows() const;
    void fit();
    void fitStatistics();

    ProjectReader *m_reader;
    BackgroundTask m_saving;
    Project &m_project;
    ResultsModel *m_model;
    ResultStatisticsModel *m_statistics;
    QStringList m_metrics; ///< chosen, by their names; kept in the settings
    Card *m_card;
    QComboBox *m_class, *m_task, *m_groups;
    QLineEdit *m_search;
    QPushButton *m_metricButton;
    QMenu *m_metricMenu;
    QTableView *m_table, *m_statisticsTable;
    QLabel *m_statisticsTitle;
    QTimer *m_statisticsTimer;
};

} // namespace odo
