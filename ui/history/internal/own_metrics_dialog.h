// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exchange/own_metric.h"

#include <QDialog>
#include <vector>

class QDialogButtonBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

/// The metrics that are defined on this computer, kept in the settings.
std::vector<OwnMetric> storedOwnMetrics();
void storeOwnMetrics(const std::vector<OwnMetric> &metrics);

/// Defines metrics by formulas: a row each, with name, unit and formula; says what is wrong with the first
/// that cannot be used. GUI thread.
class OwnMetricsDialog : public QDialog
{
    Q_OBJECT
public:
    /// table: whose metrics and variables formulas can use; its rows don't matter.
    OwnMetricsDialog(const ResultTable &table, const std::vector<OwnMetric> &metrics,
                     QWidget *parent = nullptr);
    std::vector<OwnMetric> metrics() const;

private:
    void addRow(const OwnMetric &metric);
    void check();

    ResultTable m_table; ///< without rows
    QTableWidget *m_rows;
    QPushButton *m_remove;
    QLabel *m_problem;
    QDialogButtonBox *m_buttons;
};

} // namespace odo
