// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/image/internal/image_area.h"

#include "core/workflow/trial_sources.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/image/internal/loupe.h"
#include "ui/views/image/patient_layer.h"
#include "ui/views/widgets/theme.h"
#include "ui/views/widgets/zoom_pan.h"

#include <QContextMenuEvent>
#include <QLineF>
#include <QList>
#include <QMouseEvent>
#include <QPainter>
#include <cmath>
#include <utility>

namespace odo {

namespace {

/// Logical pixels for one of the recording: at most; from when they are seen one by one; and with lines
/// between them.
constexpr double mostPerPx = 48, singlePixelsFrom = 3, gridFrom = 12;

void paintPixelGrid(QPainter &painter, const QRectF &whole, const QRectF &seen, double perPx)
{
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(QColor(128, 128, 128, 110), 0)); // to be seen on dark and on light pixels
    QList<QLineF> lines;
    for (double x = whole.left() + std::ceil((seen.left() - whole.left()) / perPx) * perPx; x <= seen.right();
         x += perPx)
        lines << QLineF(x, seen.top(), x, seen.bottom());
    for (double y = whole.top() + std::ceil((seen.top() - whole.top()) / perPx) * perPx; y <= seen.bottom();
         y += perPx)
        lines << QLineF(seen.left(), y, seen.right(), y);
    painter.drawLines(lines);
}

} // namespace

ImageArea::ImageArea(Timeline &timeline, QWidget *parent)
    : QWidget(parent), m_timeline(timeline), m_zoom(new ZoomPan(*this)), m_floorLayer(new PatientLayer(*this))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setFocusPolicy(Qt::TabFocus); // its keys are those of who looks closely
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_zoom->setDragFilter([this](const QPointF &) { return !m_isPointing; });
    connect(m_zoom, &ZoomPan::changed, this, &ImageArea::showZoomed);
    connect(&m_timeline, &Timeline::currentChanged, this, &ImageArea::ask);
    connect(&m_fetcher, &FrameFetcher::frameReady, this, &ImageArea::showImage);
    connect(&m_fetcher, &FrameFetcher::failed, this, &ImageArea::showFailure);
    connect(m_floorLayer, &PatientLayer::ready, this, [this] {
        if (isSettled())
            Q_EMIT settled();
    });
}

const SceneView *ImageArea::sceneView() const
{
    return m_scene && m_view < m_scene->views.size() ? &m_scene->views[m_view] : nullptr;
}

void ImageArea::setScene(TrialScenePtr scene, std::size_t view)
{
    const SceneView *before = sceneView();
    const std::filesystem::path fileBefore = before ? before->file : std::filesystem::path();
    m_scene = std::move(scene);
    m_view = view;
    m_floorLayer->forget();
    const SceneView *shown = sceneView();
    const std::filesystem::path file = shown ? shown->file : std::filesystem::path();
    if (file != fileBefore) {
        m_fetcher.setFile(file, shown ? knownRecording(shown->recording) : KnownRecording());
        m_image = {};
        m_shownFrame = -1;
        m_failure.clear();
        m_zoom->fit();
    }
    frameImage();
    ask();
    update();
}

void ImageArea::setOverlay(ImageOverlay overlay)
{
    m_overlay = std::move(overlay);
    update();
}

void ImageArea::setRobotColour(const QColor &colour)
{
    m_style.colour = colour;
    m_floorLayer->forget();
    update();
}

void ImageArea::setOutlinesShown(bool shown)
{
    m_style.withOutlines = shown;
    update();
}

void ImageArea::setLoupeShown(bool shown)
{
    m_hasLoupe = shown;
    ask();
    update();
}

std::optional<qint64> ImageArea::wantedFrame() const
{
    if (!sceneView())
        return std::nullopt;
    return m_scene->frameAt(m_view, m_timeline.currentTime());
}

void ImageArea::ask()
{
    const auto frame = wantedFrame();
    if (const bool was = std::exchange(m_isOutside, !frame); m_isOutside || was)
        // outside of the recording it says so; within it no longer, even before the image arrives
        update();
    if (!frame)
        return;
    if (isVisible())
        m_fetcher.request(*frame, wantedSize());
    if (!m_failure.isEmpty())
        update();
}

void ImageArea::showImage(qint64 frame, const QImage &image)
{
    m_image = image;
    m_shownFrame = frame;
    m_failure.clear();
    update();
    if (isSettled())
        Q_EMIT settled();
}

void ImageArea::showFailure(qint64 frame, const QString &message)
{
    m_image = {};
    m_shownFrame = frame;
    m_failure = message;
    update();
    Q_EMIT settled();
}

bool ImageArea::isSettled() const
{
    const auto frame = wantedFrame();
    return !frame || !m_failure.isEmpty() ||
           (m_shownFrame == *frame && m_fetcher.isIdle() && m_floorLayer->isSettled());
}

QSize ImageArea::imageSizePx() const
{
    const SceneView *view = sceneView();
    return view ? QSize(view->recording.widthPx, view->recording.heightPx) : QSize();
}

QRectF ImageArea::imageRect() const
{
    return m_zoom->state().toShown(fittedRect(imageSizePx(), QSizeF(size()), devicePixelRatioF()));
}

/// In device pixels. Enlarged, it is the recording's own size, or as often halved as that is still at least
/// as fine as what is shown: so zooming seldom needs another image.
QSize ImageArea::wantedSize() const
{
    const QSize shown = (imageRect().size() * devicePixelRatioF()).toSize();
    if (m_hasLoupe)
        return imageSizePx();
    if (m_zoom->state().isFitted())
        return shown;
    QSize size = imageSizePx();
    while (size.width() / 2 >= shown.width())
        size = QSize(size.width() / 2, size.height() / 2);
    return size;
}

/// After another image or another size of the widget.
void ImageArea::frameImage()
{
    const QSize px = imageSizePx();
    const QRectF fitted = fittedRect(px, QSizeF(size()), devicePixelRatioF());
    m_zoom->setFrame(fitted,
                     px.isEmpty() || fitted.isEmpty() ? 1.0 : mostPerPx * px.width() / fitted.width());
}

void ImageArea::showZoomed()
{
    m_floorLayer->renew();
    ask();
    update();
}

void ImageArea::setPointing(bool pointing)
{
    m_isPointing = pointing;
    setCursor(pointing ? Qt::CrossCursor : Qt::ArrowCursor);
}

/// Whether there is an image at a position of the widget.
bool ImageArea::pointAt(const QPoint &position, const QPoint &global)
{
    if (!sceneView() || m_image.isNull() || !imageRect().contains(position))
        return false;
    Q_EMIT pointedAt(toImagePixel(position, imageSizePx(), imageRect()), global);
    return true;
}

void ImageArea::mousePressEvent(QMouseEvent *event)
{
    if (!m_isPointing || event->button() != Qt::LeftButton ||
        !pointAt(event->position().toPoint(), event->globalPosition().toPoint()))
        QWidget::mousePressEvent(event);
}

void ImageArea::mouseMoveEvent(QMouseEvent *event)
{
    const bool isOnImage = sceneView() && !m_image.isNull() && imageRect().contains(event->position());
    Q_EMIT hovered(isOnImage ? std::optional(toImagePixel(event->position(), imageSizePx(), imageRect()))
                             : std::nullopt);
    QWidget::mouseMoveEvent(event);
}

void ImageArea::leaveEvent(QEvent *event)
{
    Q_EMIT hovered(std::nullopt);
    QWidget::leaveEvent(event);
}

void ImageArea::setReadOut(const QString &text)
{
    if (std::exchange(m_readOut, text) != text)
        update();
}

void ImageArea::contextMenuEvent(QContextMenuEvent *event)
{
    if (event->reason() != QContextMenuEvent::Mouse || !pointAt(event->pos(), event->globalPos()))
        QWidget::contextMenuEvent(event);
}

QPointF ImageArea::fromImagePixels(const QPointF &pixel) const
{
    return fromImagePixel(pixel, imageSizePx(), imageRect());
}

void ImageArea::drawFloor(QPainter &painter)
{
    const QRectF whole = imageRect();
    m_floorLayer->draw(painter, whole, hasLongTrail(*m_scene), [&]() -> PatientLayer::Paint {
        return [scene = m_scene, view = m_view, style = m_style, px = imageSizePx(), whole,
                seen = whole.intersected(QRectF(rect()))](QPainter &layer) {
            layer.setClipRect(seen);
            paintFloor(
                layer, *scene, view, [&](const QPointF &pixel) { return fromImagePixel(pixel, px, whole); },
                style);
        };
    });
}

void ImageArea::paintRobots(QPainter &painter, qint64 frame) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(imageRect().intersected(QRectF(rect())));
    const ImageMap toWidget = [this](const QPointF &pixel) { return fromImagePixels(pixel); };
    for (std::size_t robot = 0; robot < m_scene->robots.size(); ++robot)
        paintRobot(painter, *m_scene, m_view, robot, frame, toWidget, m_style);
    if (m_overlay)
        m_overlay(painter, m_view, frame, toWidget);
    painter.restore();
}

/// About the first robot that this view detected.
void ImageArea::paintLoupe(QPainter &painter, qint64 frame) const
{
    const QRectF seen = imageRect().intersected(QRectF(rect()));
    for (std::size_t robot = 0; robot < m_scene->robots.size(); ++robot) {
        const Observation *observation = m_scene->observationAt(m_view, robot, frame);
        if (!observation || !observation->found)
            continue;
        const Eigen::Vector2d &centre = observation->ellipse.centrePx;
        return drawLoupe(
            painter, seen, m_image, imageSizePx(), {centre.x(), centre.y()},
            [&](const ImageMap &map) { paintRobot(painter, *m_scene, m_view, robot, frame, map, m_style); });
    }
}

void ImageArea::paintMessage(QPainter &painter, const QString &message) const
{
    const QRect position = rect().adjusted(16, 16, -16, -16);
    const bool onImage = !m_image.isNull();
    painter.setPen(onImage ? QColor(Qt::white) : ThemeColours::of(palette()).muted);
    painter.drawText(position, Qt::AlignCenter | Qt::TextWordWrap, message);
}

/// Only the part that is seen.
void ImageArea::paintImage(QPainter &painter) const
{
    const QRectF whole = imageRect();
    if (m_zoom->state().isFitted()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(whole, m_image);
        return;
    }
    const QRectF seen = whole.intersected(QRectF(rect()));
    const double perPx = whole.width() / imageSizePx().width(); // logical pixels
    const double across = m_image.width() / whole.width(), down = m_image.height() / whole.height();
    const QRectF part((seen.left() - whole.left()) * across, (seen.top() - whole.top()) * down,
                      seen.width() * across, seen.height() * down);
    const bool areSinglePixels = perPx >= singlePixelsFrom && m_image.width() == imageSizePx().width();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !areSinglePixels);
    painter.drawImage(seen, m_image, part);
    if (perPx >= gridFrom && areSinglePixels)
        paintPixelGrid(painter, whole, seen, perPx);
}

void ImageArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.fillRect(rect(), ThemeColours::of(palette()).imageBackground);
    if (!sceneView()) {
        paintMessage(painter, tr("No view"));
        return;
    }
    if (!m_image.isNull())
        paintImage(painter);
    const auto wanted = wantedFrame();
    if (wanted || !m_image.isNull()) // nothing to lie on where the camera showed nothing yet
        drawFloor(painter);
    if (!m_failure.isEmpty())
        paintMessage(painter, m_failure);
    else if (!wanted)
        paintMessage(painter, tr("This camera was not recording at this time"));
    // The overlay belongs to the image that is shown, even while a newer one is on its way.
    const qint64 frame = m_image.isNull() ? wanted.value_or(-1) : m_shownFrame;
    if (wanted && frame >= 0)
        paintRobots(painter, frame);
    if (m_hasLoupe && wanted && frame >= 0)
        paintLoupe(painter, frame);
    if (!m_readOut.isEmpty())
        drawReadOut(painter, imageRect().intersected(QRectF(rect())), m_readOut);
    drawChartFocus(painter, *this);
}

void ImageArea::resizeEvent(QResizeEvent *)
{
    m_floorLayer->renew();
    frameImage();
    ask();
}

void ImageArea::showEvent(QShowEvent *)
{
    ask();
}

void ImageArea::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        m_floorLayer->forget();
    QWidget::changeEvent(event);
}

} // namespace odo
