// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/import_trial_job.h"

#include <QWidget>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;

namespace odo {

class ElidedLabel;

/// One row for each view but the first: how it gets in step with the first one, and by hand how much later it began.
class ViewSteps : public QWidget
{
    Q_OBJECT
public:
    explicit ViewSteps(QWidget *parent = nullptr);
    /// One view more; nothing is asked of the first one.
    void addView();
    /// The views' cameras as they are called now, in order.
    void setCameras(const QStringList &cameras);
    /// What was chosen for a view, counted from 0; that of the first one is of no use.
    ImportSettings::ViewStep step(std::size_t view) const;
    /// All that takes the focus, in order.
    QList<QWidget *> fields() const;

private:
    struct Row
    {
        ElidedLabel *camera;
        QComboBox *how;
        QDoubleSpinBox *later;
    };
    QGridLayout *m_grid;
    std::size_t m_views = 0;
    std::vector<Row> m_rows;
};

} // namespace odo
