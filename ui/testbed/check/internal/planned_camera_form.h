// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/accuracy_map.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;

namespace odo {

/// A planned camera in numbers: position, height, aim point, field of view and image size.
class PlannedCameraForm : public QWidget
{
    Q_OBJECT
public:
    explicit PlannedCameraForm(QWidget *parent = nullptr);
    void setCamera(const PlannedCamera &camera);
    const PlannedCamera &camera() const { return m_camera; }

Q_SIGNALS:
    void edited(); ///< by a person

private:
    QDoubleSpinBox *makeNumber(const QString &name, double least, double most, double step,
                               const QString &unit);
    void read();

    PlannedCamera m_camera;
    QDoubleSpinBox *m_x, *m_y, *m_height, *m_aimX, *m_aimY, *m_direction, *m_angle;
    QComboBox *m_size;
};

} // namespace odo
