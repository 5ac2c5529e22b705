// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"
#include "ui/models/own_changes.h"

#include <QDialog>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

class Project;

/// The robots of a project: added, changed, deleted, each as one change that can be undone, here too (Ctrl+Z
/// takes back what was done here). On the project's thread; the project must outlive it.
class RobotsDialog : public QDialog
{
    Q_OBJECT
public:
    explicit RobotsDialog(Project &project, bool readOnly = false, QWidget *parent = nullptr);

Q_SIGNALS:
    void changed(); ///< the project

private:
    void refresh(const std::string &choose);
    const RobotRecord *current() const;
    void add();
    void change();
    void remove();
    void apply(const QString &words, const std::string &choose, const std::function<Result<void>()> &work);
    void tell(const Result<QString> &outcome, const std::string &choose);

    Project &m_project;
    OwnChanges m_changes;
    const bool m_readOnly;
    std::vector<RobotRecord> m_robots;
    QTableWidget *m_table;
    QPushButton *m_add, *m_edit, *m_remove;
    QLabel *m_message;
};

} // namespace odo
