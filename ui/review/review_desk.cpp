// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_desk.h"

#include "ui/review/internal/interval_panel.h"
#include "ui/review/internal/sample_table.h"
#include "ui/review/internal/smoothing_panel.h"
#include "ui/review/internal/trial_presentation.h"
#include "ui/views/charts/chart_span.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/image/camera_view.h"
#include "ui/views/image/floor_read_out.h"
#include "ui/views/map/floor_map.h"
#include "ui/views/present/present_window.h"
#include "ui/views/widgets/zoom_pan.h"

#include <QAction>
#include <QSettings>
#include <QSplitter>

namespace odo {
namespace {

const QString outlinesKey = QStringLiteral("review/silhouettes");

/// All of them, beginning with this one.
QList<Quantity> quantitiesFrom(Quantity first)
{
    const std::span<const Quantity> offered = allQuantities();
    QList<Quantity> all(offered.begin(), offered.end());
    all.move(all.indexOf(first), 0);
    return all;
}

} // namespace

ReviewDesk::ReviewDesk(Timeline &timeline, QWidget *parent)
    : DockDesk(QStringLiteral("review"), parent), m_timeline(timeline), m_map(new FloorMap(timeline)),
      m_span(new ChartSpan(timeline, this)),
      m_speed(new ProfileChart(timeline, *m_span, quantitiesFrom(Quantity::Speed))),
      m_acceleration(new ProfileChart(timeline, *m_span, quantitiesFrom(Quantity::Acceleration))),
      m_intervals(new IntervalPanel), m_smoothing(new SmoothingPanel), m_samples(new SampleTable(timeline)),
      m_outlines(new QAction(tr("&Silhouettes of the robots"), this)),
      m_loupe(new QAction(tr("Lo&upe on the robot"), this)), m_present(new QAction(tr("&Present"), this)),
      m_trial(new TrialPresentation(timeline, this)), m_presented(m_trial)
{
    middle().addWidget(m_map);
    addDock(m_speed, QStringLiteral("speedDock"), m_speed->title(), 31);
    addDock(m_acceleration, QStringLiteral("accelerationDock"), m_acceleration->title(), 28);
    addHiddenDock(m_intervals, QStringLiteral("intervalDock"), m_intervals->title());
    addHiddenDock(m_smoothing, QStringLiteral("smoothingDock"), m_smoothing->title());
    addHiddenDock(m_samples, QStringLiteral("dataDock"), m_samples->title());
    for (ProfileChart *chart : {m_speed, m_acceleration})
        connect(chart, &ProfileChart::quantityChanged, this, &ReviewDesk::quantitiesChanged);
    for (ProfileChart *chart : {m_speed, m_acceleration})
        connect(chart, &ProfileChart::settled, this, &ReviewDesk::settled);
    connect(m_map, &FloorMap::settled, this, &ReviewDesk::settled);
    connect(m_intervals, &IntervalPanel::settled, this, &ReviewDesk::settled);
    connect(m_smoothing, &SmoothingPanel::settled, this, &ReviewDesk::settled);
    m_outlines->setObjectName(QStringLiteral("silhouettes"));
    m_outlines->setToolTip(tr("Outline the detected robots in each view"));
    m_outlines->setShortcut(QKeySequence(Qt::Key_S));
    m_outlines->setCheckable(true);
    m_outlines->setChecked(QSettings().value(outlinesKey, true).toBool());
    connect(m_outlines, &QAction::toggled, this, &ReviewDesk::showOutlines);
    m_loupe->setObjectName(QStringLiteral("loupe"));
    m_loupe->setToolTip(tr("Show the surroundings of the robot eight times as large as recorded"));
    m_loupe->setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_L));
    m_loupe->setCheckable(true);
    connect(m_loupe, &QAction::toggled, this, &ReviewDesk::showLoupe);
    m_present->setObjectName(QStringLiteral("present"));
    m_present->setToolTip(
        tr("Team, map, speed and result in large type, on a second screen if there is one"));
    m_present->setShortcut(QKeySequence(Qt::Key_F5));
    m_present->setCheckable(true);
    connect(m_present, &QAction::toggled, this, &ReviewDesk::showPresentation);
    makeZoomActions();
    addPane(m_map, m_map->zoom());
    resetLayout();
}

ReviewDesk::~ReviewDesk()
{
    delete m_presentation; // a window of its own, whose source goes
}

void ReviewDesk::showPresentation(bool shown)
{
    if (!shown) {
        if (m_presentation)
            m_presentation->close();
        return;
    }
    m_presentation = new PresentWindow(*window());
    m_presentation->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_presentation, &PresentWindow::closed, m_present, [this] { m_present->setChecked(false); });
    m_presentation->setSource(m_presented);
    m_presentation->present();
}

void ReviewDesk::setPresented(PresentSource *source)
{
    if (m_presented == (source ? source : m_trial))
        return;
    m_presented = source ? source : m_trial;
    if (m_presentation)
        m_presentation->setSource(m_presented);
}

void ReviewDesk::makeZoomActions()
{
    const auto add = [this](const char *name, const QString &text, Qt::Key key, const auto &work) {
        auto *action = new QAction(text, this);
        action->setObjectName(QString::fromLatin1(name));
        action->setShortcut(QKeySequence(key));
        connect(action, &QAction::triggered, this, work);
        m_zoomActions << action;
    };
    add("viewZoomIn", tr("Zoom &in"), Qt::Key_Plus, [this] { m_zoom->zoomIn(); });
    add("viewZoomOut", tr("Zoom &out"), Qt::Key_Minus, [this] { m_zoom->zoomOut(); });
    add("viewFit", tr("Zoom to &fit"), Qt::Key_0, [this] { m_zoom->fit(); });
    add("viewEnlarge", tr("&Enlarge, or back"), Qt::Key_E, [this] { toggleEnlarged(m_pane); });
    for (QAction *action : m_zoomActions)
        action->setToolTip(tr("Of the view or map under the mouse"));
}

void ReviewDesk::addPane(QWidget *pane, ZoomPan &zoom)
{
    const auto use = [this, pane, &zoom] {
        m_pane = pane;
        m_zoom = &zoom;
    };
    use();
    connect(&zoom, &ZoomPan::used, this, use);
    connect(&zoom, &ZoomPan::doubleClicked, this, [this, pane] {
        if (m_isPointing)
            Q_EMIT pointingEnded();
        else
            toggleEnlarged(pane);
    });
}

QList<QAction *> ReviewDesk::viewActions() const
{
    return m_span->actions() << m_map->disagreementAction() << m_outlines << m_loupe << m_zoomActions
                             << m_present;
}

void ReviewDesk::showOutlines(bool shown)
{
    QSettings().setValue(outlinesKey, shown);
    for (CameraView *view : m_views)
        view->setOutlinesShown(shown);
}

void ReviewDesk::showLoupe(bool shown)
{
    for (CameraView *view : m_views)
        view->setLoupeShown(shown);
}

void ReviewDesk::setPointing(bool pointing)
{
    m_isPointing = pointing;
    for (CameraView *view : m_views)
        view->setPointing(pointing);
}

void ReviewDesk::setOverlay(ImageOverlay overlay)
{
    m_overlay = std::move(overlay);
    for (CameraView *view : m_views)
        view->setOverlay(m_overlay);
}

void ReviewDesk::updateOverlay()
{
    for (CameraView *view : m_views)
        view->imageArea()->update();
}

QList<Quantity> ReviewDesk::quantities() const
{
    return {m_speed->quantity(), m_acceleration->quantity()};
}

void ReviewDesk::setFit(const std::optional<FitOverlay> &fit)
{
    m_speed->setFit(fit);
    m_acceleration->setFit(fit);
}

void ReviewDesk::setViewCount(std::size_t count)
{
    while (m_views.size() > count) {
        delete m_views.back();
        m_views.pop_back();
        m_readOuts.pop_back();
    }
    while (m_views.size() < count) {
        auto *view = new CameraView(m_timeline);
        view->setOutlinesShown(m_outlines->isChecked());
        view->setLoupeShown(m_loupe->isChecked());
        middle().insertWidget(static_cast<int>(m_views.size()), view);
        view->setPointing(m_isPointing);
        view->setOverlay(m_overlay);
        connect(view, &CameraView::hovered, this,
                [this, number = m_views.size()](const std::optional<QPointF> &pixel) {
                    Q_EMIT hovered(number, pixel);
                });
        connect(view, &CameraView::settled, this, &ReviewDesk::settled);
        connect(view, &CameraView::pointedAt, this,
                [this, number = m_views.size()](const QPointF &pixel, const QPoint &global) {
                    Q_EMIT pointedAt(number, pixel, global);
                });
        m_views.push_back(view);
        m_readOuts.push_back(new FloorReadOut(*view));
        addPane(view, view->zoom());
    }
}

void ReviewDesk::setScene(const TrialScenePtr &scene)
{
    const std::size_t viewCount = scene ? scene->views.size() : 0;
    const bool changed = viewCount != m_views.size();
    if (changed)
        endEnlarging(); // what is enlarged may go
    setViewCount(viewCount);
    for (CameraView *view : m_views)
        view->setMinimumWidth(leastViewWidth(viewCount));
    if (!m_zoom) {
        m_pane = m_map;
        m_zoom = &m_map->zoom();
    }
    for (std::size_t view = 0; view < viewCount; ++view) {
        const SceneView &shown = scene->views[view];
        m_views[view]->setScene(scene, view);
        m_readOuts[view]->setReading(shown.floorView && shown.registration
                                         ? pixelOnFloor(*shown.registration, *shown.floorView)
                                         : PixelOnFloor());
    }
    m_map->setScene(scene);
    m_speed->setScene(scene);
    m_acceleration->setScene(scene);
    m_intervals->setScene(scene);
    m_smoothing->setScene(scene);
    m_samples->setScene(scene);
    m_scene = scene;
    m_trial->setScene(scene);
    if (changed)
        equaliseViews();
}

bool ReviewDesk::isSettled() const
{
    return m_map->isSettled() && m_speed->isSettled() && m_acceleration->isSettled() &&
           m_intervals->isSettled() && m_smoothing->isSettled() &&
           std::all_of(m_views.begin(), m_views.end(),
                       [](const CameraView *view) { return view->isSettled(); });
}

} // namespace odo
