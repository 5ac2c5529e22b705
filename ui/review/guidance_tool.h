// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/track/guidance.h"
#include "ui/models/trial_scene.h"
#include "ui/views/image/image_overlay.h"

#include <QList>
#include <QObject>
#include <QPolygonF>
#include <optional>

class QAction;
class QMenu;

namespace odo {

class Timeline;

/// Areas of a view that the tracker is to ignore or to search: drawn by clicks, corner by corner; Enter or a
/// double click closes one, Backspace removes its last corner, Escape gives it up. And by the mouse's menu,
/// where a robot is in a frame, and when it is not visible. Owns the actions; the receiver of the signals
/// stores what is asked.
class GuidanceTool : public QObject
{
    Q_OBJECT
public:
    explicit GuidanceTool(Timeline &timeline, QObject *parent = nullptr);

    void setScene(TrialScenePtr scene);
    /// To begin an area of either kind, which are checked meanwhile, and to remove all.
    QList<QAction *> actions() const;
    bool isDrawing() const;
    /// A corner in pixels of a view's recording; one in another view begins the area there.
    void addCorner(std::size_t view, const QPointF &pixel);
    /// Where the mouse is; nullopt: in no image.
    void hover(std::size_t view, const std::optional<QPointF> &pixel);
    /// Closes the area. With fewer than three corners it is given up.
    void finish();
    /// What may be said of a pixel of a view and the present time, and removed there.
    void fill(QMenu &menu, std::size_t view, const QPointF &pixel);
    /// What is painted over the views.
    ImageOverlay overlay() const;

Q_SIGNALS:
    void requested(const QString &trial, const odo::GuidanceEdit &edit);
    /// Points by hand, and what is not visible: the stored observations are to be corrected.
    void byHandRequested(const QString &trial, const odo::GuidanceEdit &edit);
    void drawingChanged(bool isDrawing);
    void overlayChanged();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QAction *add(const char *name, const QString &text, const QString &toolTip);
    void begin(QAction *action, bool isStarted);
    void giveUp();
    void request(const GuidanceEdit &edit);
    void fillAreas(QMenu &menu, std::size_t view, const QPointF &pixel);
    void fillByHand(QMenu &menu, std::size_t view, const QPointF &pixel);
    void fillRemovals(QMenu &menu, std::size_t view);
    void setPoint(const std::string &robot, std::size_t view, const QPointF &pixel);
    void requestByHand(const GivenGuidance &given);
    GuidanceItem::Kind kind() const;

    Timeline &m_timeline;
    TrialScenePtr m_scene;
    std::size_t m_view = 0;
    QPolygonF m_corners; ///< of m_view's recording, while one is drawn
    std::optional<QPointF> m_mouse;
    QAction *m_ignore, *m_search, *m_clear;
};

} // namespace odo
