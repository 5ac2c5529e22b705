// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/quantity_curve.h"
#include "ui/models/trial_scene.h"

#include <QList>
#include <QMainWindow>
#include <optional>
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
struct FitOverlay;

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
    /// What charts and map show: more, less, all, against time or distance; the views' disagreement.
    QList<QAction *> chartActions() const;
    /// What the charts show, from above.
    QList<Quantity> quantities() const;
    /// Drawn over the curve that it is of; nullopt: none.
    void setFit(const std::optional<FitOverlay> &fit);
    void resetLayout();
    void saveLayout() const;

Q_SIGNALS:
    void settled();
    void quantitiesChanged();

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
