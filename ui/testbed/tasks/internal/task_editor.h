// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/scoring.h"
#include "core/analysis/task_templates.h"
#include "core/calibration/marker_layout.h"
#include "core/project/records.h"

#include <QDialog>
#include <QStringList>
#include <QWidget>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;
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
    TaskRecord task; ///< a name; a new task with an empty course gets one from its template
    std::vector<Criterion> scoring;
    QStringList taken;                  ///< names of other tasks
    std::vector<std::string> metrics;   ///< that a rubric can use
    std::optional<MarkerLayout> layout; ///< drawn under the task
    QString remark;                     ///< what changing it means for trials; may be empty
};

/// Makes or changes a task: template and sizes, gates and zones on the map and in tables, limits, scoring.
/// Stores nothing: that is up to whoever opened it, once it is accepted.
class TaskEditor : public QDialog
{
    Q_OBJECT
public:
    explicit TaskEditor(TaskDraft draft, QWidget *parent = nullptr);

    TaskRecord task() const;
    std::vector<Criterion> scoring() const;
    /// Its first problem, in a sentence; empty: none.
    QString problem() const;

private:
    QWidget *makeCourse();
    QLayout *makeButtons();
    void connectAll();
    void recreate();
    void takeGates();
    void takeZones();
    void moveGate(int gate, const Eigen::Vector2d &from, const Eigen::Vector2d &to);
    void moveZone(int zone, const std::vector<Eigen::Vector2d> &corners);
    void takeLimits();
    void importFile();
    void check();

    const QStringList m_taken;
    TaskRecord m_task;
    QString m_templateProblem; ///< why the course could not be rebuilt
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

/// Which template a task is, and how large it is made, in millimetres and degrees: only the sizes that the
/// template has are asked for.
class TemplateForm : public QWidget
{
    Q_OBJECT
public:
    explicit TemplateForm(QWidget *parent = nullptr);
    /// Emits nothing.
    void setTemplate(TaskTemplate kind, const TemplateSizes &sizes);
    TaskTemplate kind() const;
    TemplateSizes sizes() const;

Q_SIGNALS:
    /// The user chose another template or size: rebuild the course.
    void changed();

private:
    QDoubleSpinBox *addLength(const QString &words);
    void showSizes();

    QFormLayout *m_form;
    QComboBox *m_kind;
    QDoubleSpinBox *m_x, *m_y, *m_length, *m_width, *m_direction, *m_gate;
    QSpinBox *m_poles;
};

/// "Straight line"
QString templateName(TaskTemplate kind);

} // namespace odo
