// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/live_picture_area.h"

#include "ui/views/picture_fit.h"
#include "ui/views/picture_overlay.h"
#include "ui/views/theme.h"

#include <QEvent>
#include <QPainter>

namespace odo {
namespace {

constexpr std::size_t placesShown = 300; // ten seconds
constexpr int usualWidth = 1280, usualHeight = 720;

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
    m_floorLayer = {};
    update();
}

void LivePictureArea::setRobots(std::vector<RobotRecord> robots)
{
    m_robots = std::move(robots);
    forgetWays();
}

void LivePictureArea::forgetWays()
{
    m_ways.assign(m_robots.size(), {});
    update();
}

void LivePictureArea::setPicture(const LivePicture &picture)
{
    if (picture.takenPx != m_picture.takenPx)
        m_floorLayer = {};
    m_picture = picture;
    update();
}

void LivePictureArea::addPlace(std::size_t robot, const Eigen::Vector2d &place)
{
    if (robot >= m_ways.size())
        return;
    auto &way = m_ways[robot];
    way.push_back(place);
    if (way.size() > placesShown)
        way.erase(way.begin(), way.end() - static_cast<std::ptrdiff_t>(placesShown));
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
    const PictureMap map = [this](const QPointF &pixel) {
        return fromPicturePixel(pixel, m_picture.takenPx, pictureRect());
    };
    paintFloorGrid(painter, *m_floor, *floorView(), map);
    paintAxes(painter, *m_floor, *floorView(), map);
}

void LivePictureArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.fillRect(rect(), colours.pictureGround);
    if (hasPicture()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(pictureRect(), m_picture.image);
        if (m_floorLayer.isNull())
            renderFloorLayer();
        painter.drawPixmap(0, 0, m_floorLayer);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setClipRect(pictureRect());
        const PictureMap map = [this](const QPointF &pixel) {
            return fromPicturePixel(pixel, m_picture.takenPx, pictureRect());
        };
        for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
            if (floorView())
                paintWay(painter, m_ways[robot], m_robots[robot].heightM.value_or(0), *floorView(), map);
            if (robot < m_picture.observations.size() && m_picture.observations[robot].found)
                paintEllipse(painter, m_picture.observations[robot].ellipse,
                             QString::fromStdString(m_robots[robot].name), map);
        }
        painter.setClipping(false);
    }
    if (m_words.isEmpty())
        return;
    if (hasPicture())
        painter.fillRect(
            pictureRect(),
            QColor(0, 0, 0, 150)); // the words can be read, and nobody takes the picture for a live one
    painter.setPen(hasPicture() ? QColor(Qt::white) : colours.muted);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, m_words);
}

void LivePictureArea::resizeEvent(QResizeEvent *)
{
    m_floorLayer = {};
    Q_EMIT shownSizeChanged((QSizeF(size()) * devicePixelRatioF()).toSize());
}

void LivePictureArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_floorLayer = {};
    QWidget::changeEvent(event);
}

} // namespace odo
