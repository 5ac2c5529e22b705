// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/school/school_sync.h"

#include <QDialog>
#include <vector>

class QLabel;
class QListWidget;
class QTableWidget;

namespace odo {

/// What was changed here and elsewhere, with both values. Accepted: it need not be shown again. GUI thread.
class ConflictDialog : public QDialog
{
    Q_OBJECT
public:
    explicit ConflictDialog(std::vector<SchoolConflict> conflicts, QWidget *parent = nullptr);

private:
    void showConflict(int row);

    const std::vector<SchoolConflict> m_conflicts;
    QListWidget *m_list;
    QLabel *m_inForce;
    QTableWidget *m_values;
};

} // namespace odo
