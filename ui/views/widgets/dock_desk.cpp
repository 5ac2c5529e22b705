// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/widgets/dock_desk.h"

#include <QAction>
#include <QDockWidget>
#include <QPainter>
#include <QResizeEvent>
#include <QSettings>
#include <QSplitter>
#include <QWidget>
#include <algorithm>
#include <utility>

namespace odo {

/// A thin strip in place of a dock's title bar, which its card has already: it is dragged to move the dock,
/// double clicked to let it float.
class DockGrip : public QWidget
{
    Q_OBJECT
public:
    explicit DockGrip(QWidget *parent = nullptr);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
};

namespace {
constexpr int gripHeight = 8;
constexpr int dots = 5;
constexpr double dotSide = 2.5, dotDistance = 6;
} // namespace

DockGrip::DockGrip(QWidget *parent) : QWidget(parent)
{
    setCursor(Qt::SizeAllCursor);
    setToolTip(tr("Drag to move, double-click to float"));
}

QSize DockGrip::sizeHint() const
{
    return {60, gripHeight};
}

void DockGrip::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    QColor colour = palette().color(QPalette::WindowText);
    colour.setAlphaF(0.25f);
    painter.setBrush(colour);
    const QPointF first(width() / 2.0 - (dots - 1) * dotDistance / 2, height() / 2.0);
    for (int i = 0; i < dots; ++i)
        painter.drawEllipse(first + QPointF(i * dotDistance, 0), dotSide / 2, dotSide / 2);
}

namespace {

/// Raised when docks come or go: an arrangement of another version is not restored.
constexpr int layoutVersion = 2;
constexpr int gap = 8;
constexpr int imageWidth = 350, mapWidth = 320;

QString layoutKey(const QString &mode)
{
    return mode + QStringLiteral("/layout");
}
QString imagesKey(const QString &mode)
{
    return mode + QStringLiteral("/pictures");
}

} // namespace

DockDesk::DockDesk(const QString &mode, QWidget *parent)
    : QMainWindow(parent), m_mode(mode), m_images(new QSplitter)
{
    setWindowFlags(Qt::Widget);
    setDockNestingEnabled(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    m_images->setHandleWidth(gap);
    m_images->setChildrenCollapsible(false);
    m_images->setMinimumHeight(136);
    setCentralWidget(m_images);
}

void DockDesk::addDock(QWidget *content, const QString &name, const QString &title, int percent)
{
    auto *dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(content);
    dock->setTitleBarWidget(new DockGrip(dock));
    content->setMinimumSize(220, 90);
    m_docks.push_back({dock, percent});
}

void DockDesk::addHiddenDock(QWidget *content, const QString &name, const QString &title)
{
    addDock(content, name, title, 0);
    m_docks.back().isHidden = true;
    constexpr int leastHeight = 120; // some rows
    content->setMinimumHeight(leastHeight);
    QDockWidget *dock = m_docks.back().widget;
    // from behind the other tabs to the front
    connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
        if (shown)
            dock->raise();
    });
}

void DockDesk::saveLayout() const
{
    if (!m_restored) // never shown: nothing was arranged
        return;
    QSettings settings;
    settings.setValue(layoutKey(m_mode), m_isEnlarged ? m_layoutBefore : saveState(layoutVersion));
    settings.setValue(imagesKey(m_mode), m_isEnlarged ? m_imagesBefore : m_images->saveState());
}

void DockDesk::toggleEnlarged(QWidget *pane)
{
    if (m_isEnlarged)
        return endEnlarging();
    m_layoutBefore = saveState(layoutVersion);
    m_imagesBefore = m_images->saveState();
    m_isEnlarged = true;
    for (int i = 0; i < m_images->count(); ++i)
        if (QWidget *other = m_images->widget(i); other != pane && other->isVisibleTo(m_images)) {
            other->hide();
            m_hidden << other;
        }
    for (const Dock &dock : m_docks)
        if (!dock.widget->isFloating())
            dock.widget->hide();
}

void DockDesk::endEnlarging()
{
    if (!std::exchange(m_isEnlarged, false))
        return;
    for (const QPointer<QWidget> &other : std::exchange(m_hidden, {}))
        if (other)
            other->show();
    restoreState(m_layoutBefore, layoutVersion);
    m_images->restoreState(m_imagesBefore);
}

void DockDesk::restoreLayout()
{
    const QSettings settings;
    if (!restoreState(settings.value(layoutKey(m_mode)).toByteArray(), layoutVersion))
        resetLayout();
    else
        m_images->restoreState(settings.value(imagesKey(m_mode)).toByteArray());
}

void DockDesk::resetLayout()
{
    endEnlarging();
    QDockWidget *above = nullptr;
    QList<QDockWidget *> docks;
    QList<int> heights;
    for (const Dock &dock : m_docks) {
        dock.widget->setFloating(false);
        addDockWidget(Qt::BottomDockWidgetArea, dock.widget);
        if (dock.isHidden) {
            tabifyDockWidget(above, dock.widget);
            dock.widget->hide();
            continue;
        }
        dock.widget->show();
        if (above)
            splitDockWidget(above, dock.widget, Qt::Vertical);
        above = dock.widget;
        docks << dock.widget;
        heights << height() * dock.percent / 100;
    }
    resizeDocks(docks, heights, Qt::Vertical);
    equaliseViews();
}

int DockDesk::leastViewWidth(std::size_t views)
{
    constexpr int usual = 150, together = 360, least = 60;
    return views < 2 ? usual : std::clamp(together / static_cast<int>(views), least, usual);
}

void DockDesk::equaliseViews()
{
    endEnlarging();
    QList<int> widths(m_images->count(), imageWidth);
    if (!widths.isEmpty())
        widths.last() = mapWidth;
    m_images->setSizes(widths);
}

QList<QAction *> DockDesk::dockActions() const
{
    QList<QAction *> actions;
    for (const Dock &dock : m_docks)
        actions << dock.widget->toggleViewAction();
    return actions;
}

void DockDesk::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (!m_restored)
        restoreLayout();
    m_restored = true;
}

void DockDesk::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    // Docks keep their height by themselves, so only the images would shrink.
    const int before = event->oldSize().height(), now = event->size().height();
    if (!m_restored || before <= 0 || before == now)
        return;
    QList<QDockWidget *> docks;
    QList<int> heights;
    for (const Dock &dock : m_docks) {
        const Qt::DockWidgetArea area = dockWidgetArea(dock.widget);
        if (dock.widget->isFloating() || dock.widget->isHidden() ||
            (area != Qt::BottomDockWidgetArea && area != Qt::TopDockWidgetArea))
            continue;
        docks << dock.widget;
        heights << dock.widget->height() * now / before;
    }
    if (!docks.isEmpty())
        resizeDocks(docks, heights, Qt::Vertical);
}

} // namespace odo

#include "dock_desk.moc"
