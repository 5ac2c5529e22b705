// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_desk.h"

#include "ui/review/dock_grip.h"
#include "ui/views/camera_view.h"
#include "ui/views/chart_area.h"
#include "ui/views/chart_span.h"
#include "ui/views/floor_map.h"
#include "ui/views/profile_chart.h"

#include <QDockWidget>
#include <QResizeEvent>
#include <QSettings>
#include <QSplitter>

namespace odo {
namespace {

/// Raised when docks come or go: an arrangement of another version is not restored.
constexpr int layoutVersion = 1;
const QString layoutKey = QStringLiteral("review/layout");
const QString splitterKey = QStringLiteral("review/pictures");
constexpr int gap = 8;

/// All of them, beginning with this one.
QList<Quantity> quantitiesFrom(Quantity first)
{
    QList<Quantity> all{Quantity::Speed,    Quantity::Acceleration, Quantity::Heading,
                        Quantity::TurnRate, Quantity::PositionX,    Quantity::PositionY};
    all.move(all.indexOf(first), 0);
    return all;
}

} // namespace

ReviewDesk::ReviewDesk(Timeline &timeline, QWidget *parent)
    : QMainWindow(parent), m_timeline(timeline), m_pictures(new QSplitter), m_map(new FloorMap(timeline)),
      m_span(new ChartSpan(timeline, this)),
      m_speed(new ProfileChart(timeline, *m_span, quantitiesFrom(Quantity::Speed))),
      m_acceleration(new ProfileChart(timeline, *m_span, quantitiesFrom(Quantity::Acceleration)))
{
    setWindowFlags(Qt::Widget);
    setDockNestingEnabled(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    m_pictures->setHandleWidth(gap);
    m_pictures->setChildrenCollapsible(false);
    m_pictures->setMinimumHeight(160);
    m_pictures->addWidget(m_map);
    setCentralWidget(m_pictures);
    m_speedDock = addDock(m_speed, QStringLiteral("speedDock"));
    m_accelerationDock = addDock(m_acceleration, QStringLiteral("accelerationDock"));
    for (ProfileChart *chart : {m_speed, m_acceleration})
        connect(chart, &ProfileChart::quantityChanged, this, &ReviewDesk::quantitiesChanged);
    connect(m_map, &FloorMap::settled, this, &ReviewDesk::settled);
    resetLayout();
}

void ReviewDesk::saveLayout() const
{
    if (!m_restored) // never shown: nothing was arranged
        return;
    QSettings settings;
    settings.setValue(layoutKey, saveState(layoutVersion));
    settings.setValue(splitterKey, m_pictures->saveState());
}

QDockWidget *ReviewDesk::addDock(ProfileChart *chart, const QString &name)
{
    auto *dock = new QDockWidget(chart->title(), this);
    dock->setObjectName(name);
    dock->setWidget(chart);
    dock->setTitleBarWidget(new DockGrip(dock));
    chart->setMinimumSize(220, 90);
    return dock;
}

void ReviewDesk::resetLayout()
{
    for (QDockWidget *dock : {m_speedDock, m_accelerationDock}) {
        dock->setFloating(false);
        addDockWidget(Qt::BottomDockWidgetArea, dock);
        dock->show();
    }
    splitDockWidget(m_speedDock, m_accelerationDock, Qt::Vertical);
    resizeDocks({m_speedDock, m_accelerationDock}, {height() * 31 / 100, height() * 28 / 100}, Qt::Vertical);
    QList<int> widths(m_pictures->count(), 350);
    widths.last() = 320;
    m_pictures->setSizes(widths);
}

void ReviewDesk::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (!m_restored)
        restoreLayout();
    m_restored = true;
}

void ReviewDesk::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    // Docks keep their height by themselves, so that the pictures alone would have to give way.
    const int before = event->oldSize().height(), now = event->size().height();
    if (!m_restored || before <= 0 || before == now)
        return;
    QList<QDockWidget *> docks;
    QList<int> heights;
    for (QDockWidget *dock : {m_speedDock, m_accelerationDock}) {
        const Qt::DockWidgetArea area = dockWidgetArea(dock);
        if (dock->isFloating() || dock->isHidden() ||
            (area != Qt::BottomDockWidgetArea && area != Qt::TopDockWidgetArea))
            continue;
        docks << dock;
        heights << dock->height() * now / before;
    }
    if (!docks.isEmpty())
        resizeDocks(docks, heights, Qt::Vertical);
}

void ReviewDesk::restoreLayout()
{
    const QSettings settings;
    if (!restoreState(settings.value(layoutKey).toByteArray(), layoutVersion))
        resetLayout();
    else
        m_pictures->restoreState(settings.value(splitterKey).toByteArray());
}

QList<QAction *> ReviewDesk::dockActions() const
{
    return {m_speedDock->toggleViewAction(), m_accelerationDock->toggleViewAction()};
}

QList<QAction *> ReviewDesk::chartActions() const
{
    return m_span->actions() << m_map->disagreementAction();
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
    }
    while (m_views.size() < count) {
        auto *view = new CameraView(m_timeline);
        view->setMinimumWidth(180);
        m_pictures->insertWidget(static_cast<int>(m_views.size()), view);
        connect(view, &CameraView::settled, this, &ReviewDesk::settled);
        m_views.push_back(view);
    }
}

void ReviewDesk::setScene(TrialScenePtr scene)
{
    const std::size_t viewCount = scene ? scene->views.size() : 0;
    const bool changed = viewCount != m_views.size();
    setViewCount(viewCount);
    for (std::size_t view = 0; view < viewCount; ++view)
        m_views[view]->setScene(scene, view);
    m_map->setScene(scene);
    m_speed->setScene(scene);
    m_acceleration->setScene(scene);
    if (changed) {
        QList<int> widths(m_pictures->count(), 350);
        widths.last() = 320;
        m_pictures->setSizes(widths);
    }
}

bool ReviewDesk::isSettled() const
{
    return m_map->isSettled() && std::all_of(m_views.begin(), m_views.end(),
                                             [](const CameraView *view) { return view->isSettled(); });
}

} // namespace odo
