// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QWidget>

namespace odo {

/// A robot from above, heading to the right, with the point of it that is measured.
class RobotFootprint : public QWidget
{
    Q_OBJECT
public:
    explicit RobotFootprint(QWidget *parent = nullptr);

    /// Its size, reference point and colour count. One without a size is drawn with a usual one, which words() say.
    void setRobot(const RobotRecord &robot);
    QString words() const;

    QSize sizeHint() const override { return {220, 150}; }
    QSize minimumSizeHint() const override { return {120, 130}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    RobotRecord m_robot; ///< with a size
    bool m_isSizeGiven = false;
};

} // namespace odo
