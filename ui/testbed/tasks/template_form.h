// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/task_templates.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QSpinBox;

namespace odo {

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
    /// A person chose another template or size: the course is to be made anew.
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
