// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/marker_layout.h"
#include "core/project/records.h"
#include "core/trajectory/scoring.h"

#include <QDialog>
#include <QStringList>
#include <optional>

class QDoubleSpinBox;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QTabWidget;

namespace odo {

class GateTable;
class ScoringTable;
class TaskCanvas;
class TemplateForm;
class ZoneTable;

/// What a task editor begins with.
struct TaskDraft
{
    TaskRecord task; ///< a name; an empty course of a new one is made from the template that it tells
    std::vector<Criterion> scoring;
    QStringList taken;                  ///< names of other tasks
    std::vector<std::string> metrics;   ///< that a rubric can use
    std::optional<MarkerLayout> layout; ///< drawn under the task
    QString remark;                     ///< what changing it means for trials; may be empty
};

/// Makes or changes a task: template and sizes, gates and zones on the map and in tables, limits, scoring. Stores
/// nothing: that is up to whoever opened it, once it is accepted.
class TaskEditor : public QDialog
{
    Q_OBJECT
public:
    explicit TaskEditor(TaskDraft draft, QWidget *parent = nullptr);

    TaskRecord task() const;
    std::vector<Criterion> scoring() const;
    /// What is wrong with it as it stands, in a sentence; empty: nothing.
    QString problem() const;

private:
    QWidget *makeCourse();
    QLayout *makeButtons();
    void connectAll();
    void makeAnew();
    void takeGates();
    void takeZones();
    void moveGate(int gate, const Eigen::Vector2d &from, const Eigen::Vector2d &to);
    void moveZone(int zone, const std::vector<Eigen::Vector2d> &corners);
    void takeLimits();
    void importFile();
    void check();

    const QStringList m_taken;
    TaskRecord m_task;
    QString m_templateProblem; ///< why the course could not be made anew
    QLineEdit *m_name;
    TemplateForm *m_template;
    GateTable *m_gates;
    QDoubleSpinBox *m_speed, *m_accel;
    ZoneTable *m_zones;
    ScoringTable *m_scoring;
    TaskCanvas *m_canvas;
    QTabWidget *m_tabs;
    QLabel *m_message;
    QPushButton *m_save;
};

} // namespace odo
