// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_reading.h"

#include <QObject>
#include <QPointF>
#include <optional>

class QAction;

namespace odo {

class CameraView;

/// The floor position under the mouse in a camera's image, with its σ, as `odograph locate` computes it; a
/// menu on the image, or Ctrl+C while the mouse is over it, copies it.
class FloorReadOut : public QObject
{
    Q_OBJECT
public:
    /// Lives with the view; copying is an action of it.
    explicit FloorReadOut(CameraView &view);

    /// Of the camera that the view shows; nullopt: it is not registered.
    void setReading(std::optional<FloorReading> reading);

private:
    void show(const std::optional<QPointF> &pixel);
    void openMenu(const QPointF &pixel, const QPoint &global);
    void copy();

    CameraView &m_view;
    std::optional<FloorReading> m_reading;
    std::optional<QPointF> m_pixel; ///< under the mouse
    QString m_text;                 ///< as it is shown
    QAction *m_copy;
};

} // namespace odo
