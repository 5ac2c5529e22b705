// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/floor_reading.h"

#include <QObject>
#include <QPointF>
#include <QString>
#include <functional>
#include <optional>

namespace odo {

class CameraView;

/// Where a pixel of a registered camera lies on the floor; nullopt: not on it.
using PixelOnFloor = std::function<std::optional<ReadPosition>(const QPointF &pixel)>;
/// With the whole σ of a pixel that is read by a person, as FloorReading has it.
PixelOnFloor pixelOnFloor(const FloorRegistration &registration, const FloorView &view);

/// The pixel under the mouse in a camera's image, and its floor position with σ, as `odograph locate`
/// computes it. GUI thread.
class FloorReadOut : public QObject
{
    Q_OBJECT
public:
    /// Lives with the view.
    explicit FloorReadOut(CameraView &view);

    /// Of the camera that the view shows; empty: it is not registered.
    void setReading(PixelOnFloor reading);
    /// The floor position as it is shown; empty: none.
    QString floorText() const { return m_floorText; }
    void show(const std::optional<QPointF> &pixel);

Q_SIGNALS:
    void shown();

private:
    CameraView &m_view;
    PixelOnFloor m_reading;
    std::optional<QPointF> m_pixel; ///< under the mouse
    QString m_floorText;
};

} // namespace odo
