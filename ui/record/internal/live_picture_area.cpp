// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/live_picture_area.h"

#include "ui/views/charts/series_colours.h"
#include "ui/views/picture/picture_overlay.h"
#include "ui/views/picture/picture_painting.h"
#include "ui/views/widgets/theme.h"

#include <QEvent>
#include <QPainter>
#include <QtMath>

namespace odo {
namespace {

constexpr std::size_t placesShown = 300; // ten seconds at 30 frames a second
/// So many new positions are painted with each frame before they join the layer of the others: stroking the
/// whole path each time costs more than everything else here.
constexpr std::size_t placesPaintedAnew = 12;
constexpr int usualWidth = 1280, usualHeight = 720;

/// Those that are wholly inside.
QRect wholePixelsOf(const QRectF &area)
{
    return QRect(QPoint(qCeil(area.left()), qCeil(area.top())),
                 QPoint(qFloor(area.right()) - 1, qFloor(area.bottom()) - 1));
}

} // namespace

LivePictureArea::LivePictureArea(QWidget *parent) : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void LivePictureArea::setFloor(TrialScenePtr floor, std::size_t view)
{
    m_floor = std::move(floor);
    m_view = view;
    forgetLayers();
    update();
}

void LivePictureArea::setRobots(std::vector<RobotRecord> robots)
{
    m_robots = std::move(robots);
    m_colours = colourPlaces(m_robots);
    forgetWays();
}

void LivePictureArea::forgetWays()
{
    m_ways.assign(m_robots.size(), {});
    m_wayLayer = {};
    update();
}

void LivePictureArea::setPicture(const LivePicture &picture)
{
    if (picture.takenPx != m_picture.takenPx)
        forgetLayers();
    m_picture = picture;
    update();
}

void LivePictureArea::addPlace(std::size_t robot, const Eigen::Vector2d &place)
{
    if (robot >= m_ways.size())
        return;
    Way &way = m_ways[robot];
    way.places.push_back(place);
    if (way.places.size() - way.inLayer > placesPaintedAnew)
        m_wayLayer = {};
}

void LivePictureArea::setWords(const QString &words)
{
    if (words == m_words)
        return;
    m_words = words;
    update();
}

const FloorView *LivePictureArea::floorView() const
{
    const bool known = m_floor && m_view < m_floor->views.size() && m_floor->views[m_view].floorView;
    return known ? &*m_floor->views[m_view].floorView : nullptr;
}

QRectF LivePictureArea::pictureRect() const
{
    const QSize taken = m_picture.takenPx.isEmpty() ? QSize(usualWidth, usualHeight) : m_picture.takenPx;
    return fittedRect(taken, QSizeF(size()), devicePixelRatioF());
}

void LivePictureArea::forgetLayers()
{
    m_floorLayer = {};
    m_wayLayer = {};
}

PictureMap LivePictureArea::pictureMap() const
{
    return [taken = m_picture.takenPx, shown = pictureRect()](const QPointF &pixel) {
        return fromPicturePixel(pixel, taken, shown);
    };
}

void LivePictureArea::renderFloorLayer()
{
    m_floorLayer = QPixmap((QSizeF(size()) * devicePixelRatioF()).toSize());
    m_floorLayer.setDevicePixelRatio(devicePixelRatioF());
    m_floorLayer.fill(Qt::transparent);
    if (!floorView())
        return;
    QPainter painter(&m_floorLayer);
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(pictureRect());
    const PictureMap map = pictureMap();
    paintFloorGrid(painter, *m_floor, *floorView(), map);
    paintAxes(painter, *m_floor, *floorView(), map);
}

/// The floor with all paths as they are now, without the oldest positions.
void LivePictureArea::renderWayLayer()
{
    if (m_floorLayer.isNull())
        renderFloorLayer();
    m_wayLayer = m_floorLayer;
    QPainter painter(&m_wayLayer);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(pictureRect());
    for (std::size_t robot = 0; robot < m_ways.size(); ++robot) {
        Way &way = m_ways[robot];
        if (way.places.size() > placesShown)
            way.places.erase(way.places.begin(), way.places.end() - static_cast<std::ptrdiff_t>(placesShown));
        way.inLayer = way.places.size();
        paintWayOf(painter, robot, way.places);
    }
}

void LivePictureArea::paintWayOf(QPainter &painter, std::size_t robot, const Places &places) const
{
    if (floorView())
        paintWay(painter, places, m_robots[robot].heightM.value_or(0), *floorView(), pictureMap(),
                 colourOnPicture(m_colours[robot]));
}

void LivePictureArea::paintRobots(QPainter &painter) const
{
    for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
        const Way &way = m_ways[robot];
        const auto first = static_cast<std::ptrdiff_t>(way.inLayer > 0 ? way.inLayer - 1 : 0);
        paintWayOf(painter, robot, Places(way.places.begin() + first, way.places.end()));
        if (robot < m_picture.observations.size() && m_picture.observations[robot].found)
            paintOutline(painter, m_picture.observations[robot], QString::fromStdString(m_robots[robot].name),
                         colourOnPicture(m_colours[robot]), pictureMap());
    }
}

void LivePictureArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    if (!hasPicture()) {
        painter.fillRect(rect(), colours.pictureGround);
    } else {
        for (const QRect &beside : QRegion(rect()) - wholePixelsOf(pictureRect()))
            painter.fillRect(beside, colours.pictureGround);
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(pictureRect(), m_picture.image);
        if (m_wayLayer.isNull())
            renderWayLayer();
        painter.drawPixmap(0, 0, m_wayLayer);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setClipRect(pictureRect());
        paintRobots(painter);
        painter.setClipping(false);
    }
    if (m_words.isEmpty())
        return;
    if (hasPicture())
        painter.fillRect(
            pictureRect(),
            QColor(0, 0, 0, 150)); // keeps the words legible and shows that the frame is not live
    painter.setPen(hasPicture() ? QColor(Qt::white) : colours.muted);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_words);
}

void LivePictureArea::resizeEvent(QResizeEvent *)
{
    forgetLayers();
    Q_EMIT shownSizeChanged((QSizeF(size()) * devicePixelRatioF()).toSize());
}

void LivePictureArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        forgetLayers();
    QWidget::changeEvent(event);
}

} // namespace odo
