// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/analysis/quantity_curve.h"
#include "ui/models/trial_scene.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/dock_desk.h"

#include <QList>
#include <QPointer>
#include <optional>
#include <vector>

class QAction;

namespace odo {

class CameraView;
class ChartSpan;
class FloorMap;
class IntervalPanel;
class SmoothingPanel;
class FloorReadOut;
class PresentSource;
class PresentWindow;
class ProfileChart;
class SampleTable;
class Timeline;
class TrialPresentation;
class ZoomPan;
struct FitOverlay;

/// The part of Review that a person can arrange: the views and the map side by side, two charts in docks, and
/// one of all samples that is hidden at first.
class ReviewDesk : public DockDesk
{
    Q_OBJECT
public:
    explicit ReviewDesk(Timeline &timeline, QWidget *parent = nullptr);
    ~ReviewDesk() override;

    /// A null scene clears.
    void setScene(const TrialScenePtr &scene);
    bool isSettled() const;
    /// What charts, map and views show: more, less, all, against time or distance; the views' disagreement;
    /// the robots' silhouettes; how closely a view or the map is looked at; the page for the projector.
    QList<QAction *> viewActions() const;
    /// What the charts show, from above.
    QList<Quantity> quantities() const;
    /// Drawn over the curve that it is of; nullopt: none.
    void setFit(const std::optional<FitOverlay> &fit);
    /// While it waits for a position in an image.
    void setPointing(bool pointing);
    /// Painted over the images; empty: nothing.
    void setOverlay(ImageOverlay overlay);
    void updateOverlay();
    /// What the page for the projector shows instead of the trial; null, or when it goes: the trial again.
    void setPresented(PresentSource *source);

Q_SIGNALS:
    void settled();
    void quantitiesChanged();
    /// In pixels of a view's recording, and on the screen.
    void pointedAt(std::size_t view, const QPointF &pixel, const QPoint &global);
    /// While it waits for positions: a double click, whose first click was one.
    void pointingEnded();
    /// The pixel of a view's recording under the mouse; nullopt where the mouse has left the image.
    void hovered(std::size_t view, const std::optional<QPointF> &pixel);

private:
    void setViewCount(std::size_t count);
    void showOutlines(bool shown);
    void makeZoomActions();
    void showLoupe(bool shown);
    void showPresentation(bool shown);
    /// What zooms by keys while the mouse is over it, or was last.
    void addPane(QWidget *pane, ZoomPan &zoom);

    Timeline &m_timeline;
    std::vector<CameraView *> m_views;
    std::vector<FloorReadOut *> m_readOuts; ///< one a view
    FloorMap *m_map;
    ChartSpan *m_span;
    ProfileChart *m_speed, *m_acceleration;
    IntervalPanel *m_intervals;
    SmoothingPanel *m_smoothing;
    SampleTable *m_samples;
    bool m_isPointing = false;
    ImageOverlay m_overlay;
    QAction *m_outlines; ///< kept in the settings
    QAction *m_loupe;
    QAction *m_present;
    QPointer<PresentWindow> m_presentation; ///< while it is open
    TrialPresentation *m_trial;
    QPointer<PresentSource> m_presented;
    TrialScenePtr m_scene;
    QList<QAction *> m_zoomActions;
    QPointer<QWidget> m_pane; ///< that the keys mean
    QPointer<ZoomPan> m_zoom; ///< its own
};

} // namespace odo
