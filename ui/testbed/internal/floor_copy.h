// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>

class QAction;

namespace odo {

class CameraView;
class FloorReadOut;

/// A menu on a camera's image, or Ctrl+C while the mouse is over it, copies the floor position under the
/// mouse. GUI thread.
class FloorCopy : public QObject
{
    Q_OBJECT
public:
    /// Lives with the view; copying is an action of it. readOut must outlive it.
    FloorCopy(CameraView &view, FloorReadOut &readOut);

private:
    void openMenu(const QPointF &pixel, const QPoint &global);

    CameraView &m_view;
    FloorReadOut &m_readOut;
    QAction *m_copy;
};

} // namespace odo
