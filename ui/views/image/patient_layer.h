// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"

#include <QImage>
#include <QObject>
#include <QRectF>
#include <functional>
#include <memory>

class QPainter;
class QWidget;

namespace odo {

/// What lies over the ground of a view that can be zoomed, kept as an image. Where it takes long to paint at
/// another place or size, that is done on a thread of its own, and meanwhile what was painted before is shown
/// where it belongs now, a little blurred. GUI thread.
class PatientLayer : public QObject
{
    Q_OBJECT
public:
    /// Called on any thread: owns all that it needs.
    using Paint = std::function<void(QPainter &)>;

    /// The view must outlive it.
    explicit PatientLayer(QWidget &view);
    /// It shows something else now.
    void forget();
    /// It shows the same at another place or size.
    void renew() { m_isStale = true; }
    /// frame: where something of it, always the same, is in the view now. make: gives what paints it as it is
    /// now. isLong: that takes more than a few milliseconds.
    void draw(QPainter &painter, const QRectF &frame, bool isLong, const std::function<Paint()> &make);
    bool isSettled() const { return !m_task.isRunning(); }

Q_SIGNALS:
    void ready(); ///< it was painted on its thread

private:
    struct Painted
    {
        QImage image;
        QRectF frame;
    };
    Painted emptyAt(const QRectF &frame) const;
    void paintSoon(const QRectF &frame, Paint paint);
    void take();

    QWidget &m_view;
    bool m_isStale = true;
    Painted m_shown; ///< without an image: none yet
    std::shared_ptr<Painted> m_made;
    BackgroundTask m_task;
};

} // namespace odo
