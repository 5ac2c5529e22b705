// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/live_image_area.h"

#include "ui/views/charts/series_colours.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/widgets/theme.h"

#include <QEvent>
#include <QPainter>
#include <QtMath>

namespace odo {
namespace {

constexpr std::size_t positionsShown = 300; // ten seconds at 30 frames a second
/// So many new positions are painted with each frame before they join the layer of the others: stroking the
/// whole path each time costs more than everything else here.
constexpr std::size_t positionsRepainted = 12;
constexpr int usualWidth = 1280, usualHeight = 720;

/// Those that are wholly inside.
QRect wholePixelsOf(const QRectF &area)
{
    return QRect(QPoint(qCeil(area.left()), qCeil(area.top())),
                 QPoint(qFloor(area.right()) - 1, qFloor(area.bottom()) - 1));
}

} // namespace

LiveImageArea::LiveImageArea(QWidget *parent) : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LiveImageArea::setFloor(TrialScenePtr floor, std::size_t view)
{
    m_floor = std::move(floor);
    m_view = view;
    forgetLayers();
    update();
}

void LiveImageArea::setRobots(std::vector<RobotRecord> robots)
{
    m_robots = std::move(robots);
    m_colours = paletteIndices(m_robots);
    forgetPaths();
}

void LiveImageArea::forgetPaths()
{
    m_paths.assign(m_robots.size(), {});
    m_pathLayer = {};
    update();
}

void LiveImageArea::setImage(const LiveFrame &live)
{
    if (live.takenPx != m_live.takenPx)
        forgetLayers();
    m_live = live;
    update();
}

void LiveImageArea::addPosition(std::size_t robot, const Eigen::Vector2d &position)
{
    if (robot >= m_paths.size())
        return;
    RobotPath &path = m_paths[robot];
    path.positions.push_back(position);
    if (path.positions.size() - path.inLayer > positionsRepainted)
        m_pathLayer = {};
}

void LiveImageArea::setWords(const QString &words)
{
    if (words == m_words)
        return;
    m_words = words;
    update();
}

const FloorView *LiveImageArea::floorView() const
{
    const bool known = m_floor && m_view < m_floor->views.size() && m_floor->views[m_view].floorView;
    return known ? &*m_floor->views[m_view].floorView : nullptr;
}

QRectF LiveImageArea::imageRect() const
{
    const QSize taken = m_live.takenPx.isEmpty() ? QSize(usualWidth, usualHeight) : m_live.takenPx;
    return fittedRect(taken, QSizeF(size()), devicePixelRatioF());
}

void LiveImageArea::forgetLayers()
{
    m_floorLayer = {};
    m_pathLayer = {};
}

ImageMap LiveImageArea::imageMap() const
{
    return [taken = m_live.takenPx, shown = imageRect()](const QPointF &pixel) {
        return fromImagePixel(pixel, taken, shown);
    };
}

void LiveImageArea::renderFloorLayer()
{
    m_floorLayer = QPixmap((QSizeF(size()) * devicePixelRatioF()).toSize());
    m_floorLayer.setDevicePixelRatio(devicePixelRatioF());
    m_floorLayer.fill(Qt::transparent);
    if (!floorView())
        return;
    QPainter painter(&m_floorLayer);
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(imageRect());
    const ImageMap map = imageMap();
    paintFloorGrid(painter, *m_floor, *floorView(), map);
    paintAxes(painter, *m_floor, *floorView(), map);
}

/// The floor with all paths as they are now, without the oldest positions.
void LiveImageArea::renderPathLayer()
{
    if (m_floorLayer.isNull())
        renderFloorLayer();
    m_pathLayer = m_floorLayer;
    QPainter painter(&m_pathLayer);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(imageRect());
    for (std::size_t robot = 0; robot < m_paths.size(); ++robot) {
        RobotPath &path = m_paths[robot];
        if (path.positions.size() > positionsShown)
            path.positions.erase(path.positions.begin(),
                                 path.positions.end() - static_cast<std::ptrdiff_t>(positionsShown));
        path.inLayer = path.positions.size();
        paintPathOf(painter, robot, path.positions);
    }
}

void LiveImageArea::paintPathOf(QPainter &painter, std::size_t robot, const Positions &positions) const
{
    if (floorView())
        paintPath(painter, positions, m_robots[robot].heightM.value_or(0), *floorView(), imageMap(),
                  colourOnImage(m_colours[robot]));
}

void LiveImageArea::paintRobots(QPainter &painter) const
{
    for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
        const RobotPath &path = m_paths[robot];
        const auto first = static_cast<std::ptrdiff_t>(path.inLayer > 0 ? path.inLayer - 1 : 0);
        paintPathOf(painter, robot, Positions(path.positions.begin() + first, path.positions.end()));
        if (robot < m_live.observations.size() && m_live.observations[robot].found)
            paintOutline(painter, m_live.observations[robot], QString::fromStdString(m_robots[robot].name),
                         colourOnImage(m_colours[robot]), imageMap());
    }
}

void LiveImageArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    if (!hasFrame()) {
        painter.fillRect(rect(), colours.imageBackground);
    } else {
        for (const QRect &beside : QRegion(rect()) - wholePixelsOf(imageRect()))
            painter.fillRect(beside, colours.imageBackground);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(imageRect(), m_live.image);
        if (m_pathLayer.isNull())
            renderPathLayer();
        painter.drawPixmap(0, 0, m_pathLayer);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setClipRect(imageRect());
        paintRobots(painter);
        painter.setClipping(false);
    }
    if (m_words.isEmpty())
        return;
    if (hasFrame())
        painter.fillRect(
            imageRect(),
            QColor(0, 0, 0, 150)); // keeps the words legible and shows that the frame is not live
    painter.setPen(hasFrame() ? QColor(Qt::white) : colours.muted);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_words);
}

void LiveImageArea::resizeEvent(QResizeEvent *)
{
    forgetLayers();
    Q_EMIT shownSizeChanged((QSizeF(size()) * devicePixelRatioF()).toSize());
}

void LiveImageArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        forgetLayers();
    QWidget::changeEvent(event);
}

} // namespace odo
