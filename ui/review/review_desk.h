// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/trial_scene.h"

#include <QList>
#include <QMainWindow>
#include <vector>

class QAction;
class QDockWidget;
class QSplitter;

namespace odo {

class CameraView;
class ChartSpan;
class FloorMap;
class ProfileChart;
class Timeline;

/// The part of Review that a person can arrange: the views and the map side by side, the charts in docks
/// around them. The arrangement is read from the settings when first shown, and written there by saveLayout.
class ReviewDesk : public QMainWindow
{
    Q_OBJECT
public:
    explicit ReviewDesk(Timeline &timeline, QWidget *parent = nullptr);

    /// A null scene clears.
    void setScene(TrialScenePtr scene);
    bool isSettled() const;
    /// One a dock: shows and hides it.
    QList<QAction *> dockActions() const;
    /// What the charts show: more, less, all, against time or distance.
    QList<QAction *> chartActions() const;
    void resetLayout();
    void saveLayout() const;

Q_SIGNALS:
    void settled();

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QDockWidget *addDock(ProfileChart *chart, const QString &name);
    void setViewCount(std::size_t count);
    void restoreLayout();

    Timeline &m_timeline;
    QSplitter *m_pictures;
    std::vector<CameraView *> m_views;
    FloorMap *m_map;
    ChartSpan *m_span;
    ProfileChart *m_speed, *m_acceleration;
    QDockWidget *m_speedDock, *m_accelerationDock;
    bool m_restored = false;
};

} // namespace odo
