// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/scoring.h"

#include <QStringList>
#include <QWidget>
#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

/// The rubric of a task: a line for each scored metric, with its points, and an explanation of the lines.
class ScoringTable : public QWidget
{
    Q_OBJECT
public:
    /// metrics: identifiers of the metrics to choose from.
    explicit ScoringTable(const std::vector<std::string> &metrics, QWidget *parent = nullptr);
    void setCriteria(const std::vector<Criterion> &criteria);
    const std::vector<Criterion> &criteria() const { return m_criteria; }

Q_SIGNALS:
    void changed();

private:
    void show(int row);
    void showAll();
    void showWords();
    void readRow(int row);
    void add();
    void remove();

    const std::vector<std::string> m_metrics;
    std::vector<Criterion> m_criteria;
    QTableWidget *m_table;
    QPushButton *m_remove;
    QLabel *m_words;
    bool m_isShowing = false;
};

} // namespace odo
