// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/internal/annotated_frame.h"

#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"
#include "ui/models/verdict_mark.h"
#include "ui/views/charts/chart_image.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/charts/profile_chart.h"
#include "ui/views/charts/trial_curves.h"
#include "ui/views/image/camera_view.h"
#include "ui/views/image/image_overlay.h"
#include "ui/views/map/trial_map.h"
#include "ui/views/widgets/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace odo {
namespace {

class AnnotatedFrameWords
{
    Q_DECLARE_TR_FUNCTIONS(AnnotatedFrame)
};

/// What is painted in: whatever the size of the video, text has the same share of it.
constexpr double leastWidth = 1280, leastHeight = 720;
constexpr double imageGap = 10, headerHeight = 46, titleHeight = 26;
constexpr double textPx = 13, headingPx = 20;

QRectF snapped(const QRectF &rect, double scale)
{
    const auto whole = [scale](double length) { return std::round(length * scale) / scale; };
    return {QPointF(whole(rect.left()), whole(rect.top())),
            QPointF(whole(rect.right()), whole(rect.bottom()))};
}

/// As a card of the window: rounded, with a thin border.
void paintCard(QPainter &painter, const QRectF &rect, const QColor &ground, const QPalette &palette)
{
    painter.setPen(QPen(ThemeColours::of(palette).border, 1));
    painter.setBrush(ground);
    painter.drawRoundedRect(rect.adjusted(-0.5, -0.5, 0.5, 0.5), 4, 4);
}

/// Team, task, and what the verdict is where it was not passed.
QString trialFacts(const TrialScene &scene)
{
    QStringList facts;
    for (const QString &fact : {shownTeam(scene.trial), QString::fromStdString(scene.trial.task)})
        if (!fact.isEmpty())
            facts << fact;
    if (scene.verdict.level() != CheckLevel::Pass)
        facts << verdictBadge(scene.verdict).text;
    return facts.join(QStringLiteral(" · "));
}

} // namespace

AnnotatedFrame::AnnotatedFrame(TrialScenePtr scene, AnnotationStyle style)
    : m_scene(std::move(scene)), m_style(std::move(style)), m_topSpeedMps(topSpeedMps(*m_scene))
{
    m_scale = std::min(m_style.sizePx.width() / leastWidth, m_style.sizePx.height() / leastHeight);
    layOut();
    m_plan = {m_scene->floorBounds(), m_map.size()};
    if (m_chart.isEmpty())
        return;
    SamplePositions positions;
    for (const SceneRobot &robot : m_scene->robots)
        positions.push_back(robot.analysis ? sampleTimes(robot.analysis->profile) : std::vector<double>());
    m_curves = TrialCurves(m_scene, Quantity::Speed, positions);
}

void AnnotatedFrame::layOut()
{
    const bool hasTrack =
        std::ranges::any_of(m_scene->robots, [](const SceneRobot &r) { return r.analysis.has_value(); });
    const bool hasMap = hasTrack || std::ranges::any_of(m_scene->views, [](const SceneView &v) {
                            return v.floorView.has_value();
                        });
    const double width = m_style.sizePx.width() / m_scale, height = m_style.sizePx.height() / m_scale;
    m_header = QRectF(imageGap, 0, width - 2 * imageGap, headerHeight);
    QRectF area(imageGap, headerHeight, width - 2 * imageGap, height - headerHeight - imageGap);
    const bool isAlone = m_scene->views.size() == 1; // then the map is beside it
    const double viewsWidth = isAlone && hasMap ? 0.62 * area.width() : area.width();
    if (hasTrack || (hasMap && !isAlone)) {
        constexpr double mostForViews = 0.64;
        QRectF low = area;
        low.setTop(area.top() + std::min(mostForViews * area.height(), viewsHeight(viewsWidth)) + imageGap);
        area.setBottom(low.top() - imageGap);
        const double mapWidth = isAlone ? 0 : hasTrack ? 0.36 * low.width() : low.width();
        if (!isAlone)
            m_map = snapped(QRectF(low.topLeft(), QSizeF(mapWidth, low.height())), m_scale);
        if (hasTrack)
            m_chart = snapped(low.adjusted(isAlone ? 0 : mapWidth + imageGap, 0, 0, 0), m_scale);
    }
    if (isAlone && hasMap) {
        m_map = snapped(area.adjusted(viewsWidth + imageGap, 0, 0, 0), m_scale);
        area.setRight(m_map.left() - imageGap);
    }
    layOutViews(area);
}

/// How many views are in a row.
std::size_t AnnotatedFrame::columns() const
{
    constexpr std::size_t mostInARow = 3;
    const std::size_t count = m_scene->views.size(), rows = (count + mostInARow - 1) / mostInARow;
    return (count + rows - 1) / rows;
}

/// What all views take where they fill the width.
double AnnotatedFrame::viewsHeight(double width) const
{
    const std::size_t rows = (m_scene->views.size() + columns() - 1) / columns();
    const double cell = (width - imageGap * double(columns() - 1)) / double(columns());
    double highest = cell / 4; // whatever a file says of itself
    for (const SceneView &view : m_scene->views)
        highest = std::max(highest, cell * view.recording.heightPx / std::max(1, view.recording.widthPx));
    return double(rows) * highest + imageGap * double(rows - 1);
}

void AnnotatedFrame::layOutViews(const QRectF &area)
{
    const std::size_t count = m_scene->views.size(), inARow = columns(), rows = (count + inARow - 1) / inARow;
    const double width = (area.width() - imageGap * double(inARow - 1)) / double(inARow),
                 height = (area.height() - imageGap * double(rows - 1)) / double(rows);
    for (std::size_t view = 0; view < count; ++view) {
        const std::size_t above = view / inARow;
        const double column = double(view % inARow), row = double(above);
        m_views.push_back(snapped(QRectF(area.left() + column * (width + imageGap),
                                         area.top() + row * (height + imageGap), width, height),
                                  m_scale));
    }
}

Eigen::AlignedBox2d AnnotatedFrame::floorExtent() const
{
    return odo::floorExtent(m_plan.bounds);
}

int AnnotatedFrame::floorSidePx() const
{
    return m_map.isEmpty() ? 0 : odo::floorSidePx(floorExtent(), m_plan.scalePx() * m_scale);
}

QRectF AnnotatedFrame::imageRect(std::size_t view) const
{
    const RecordingRecord &recording = m_scene->views[view].recording;
    return fittedRect(QSize(recording.widthPx, recording.heightPx), m_views[view].size(), m_scale)
        .translated(m_views[view].topLeft());
}

QPointF AnnotatedFrame::inView(std::size_t view, const QPointF &pixel) const
{
    const RecordingRecord &recording = m_scene->views[view].recording;
    return fromImagePixel(pixel, QSize(recording.widthPx, recording.heightPx), imageRect(view));
}

QPointF AnnotatedFrame::fromImagePixels(std::size_t view, const QPointF &pixel) const
{
    return inView(view, pixel) * m_scale;
}

QPointF AnnotatedFrame::fromWorld(const Eigen::Vector2d &point) const
{
    return (m_map.topLeft() + m_plan.fromWorld(point)) * m_scale;
}

QPointF AnnotatedFrame::fromChart(Nanoseconds time, double speed) const
{
    return (m_chart.topLeft() + m_plot.at(toSeconds(time), speed)) * m_scale;
}

QSize AnnotatedFrame::viewSizePx(std::size_t view) const
{
    return (imageRect(view).size() * m_scale).toSize();
}

QFont AnnotatedFrame::font(double sizePx, bool isBold) const
{
    QFont font = m_style.font;
    font.setPixelSize(static_cast<int>(sizePx));
    font.setBold(isBold);
    return font;
}

/// What is painted in, as pixels of the image; exact for the layout.
QRect AnnotatedFrame::pixels(const QRectF &rect) const
{
    return QRectF(rect.topLeft() * m_scale, rect.size() * m_scale).toRect();
}

void AnnotatedFrame::paintHeader(QPainter &painter) const
{
    const ThemeColours colours = ThemeColours::of(m_style.palette);
    constexpr double timeWidth = 330;
    QRectF area = m_header.adjusted(4, 0, -timeWidth, 0);
    const QFont heading = font(headingPx, true);
    const QFontMetricsF metrics(heading);
    const QString facts = trialFacts(*m_scene);
    const double nameWidth = facts.isEmpty() ? area.width() : 0.6 * area.width();
    const QString name =
        metrics.elidedText(QString::fromStdString(m_scene->trial.name), Qt::ElideRight, nameWidth);
    painter.setFont(heading);
    painter.setPen(colours.text);
    painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine, name);
    area.setLeft(area.left() + metrics.horizontalAdvance(name) + 16);
    painter.setFont(font(textPx + 2));
    painter.setPen(colours.muted);
    painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                     QFontMetricsF(painter.font()).elidedText(facts, Qt::ElideRight, area.width()));
}

void AnnotatedFrame::paintMapStill(QPainter &painter) const
{
    const QPalette &palette = m_style.palette;
    paintCard(painter, m_map, ThemeColours::of(palette).mapGround, palette);
    painter.save();
    painter.setClipRect(m_map);
    painter.translate(m_map.topLeft());
    drawMapGround(painter, m_plan, *m_scene, m_floor, palette);
    for (const SceneRobot &robot : m_scene->robots)
        if (robot.analysis)
            drawSpeedTrail(painter, m_plan, robot.analysis->profile, m_topSpeedMps, palette);
    drawMapMarks(painter, m_plan, *m_scene, palette);
    drawSpeedLegend(painter, m_plan, m_topSpeedMps, palette);
    painter.restore();
}

void AnnotatedFrame::paintChartStill(QPainter &painter)
{
    const QPalette &palette = m_style.palette;
    paintCard(painter, m_chart, ThemeColours::of(palette).card, palette);
    painter.save();
    painter.setClipRect(m_chart);
    painter.translate(m_chart.topLeft());
    painter.setFont(font(textPx, true));
    painter.setPen(ThemeColours::of(palette).text);
    painter.drawText(QRectF(12, 2, m_chart.width() - 24, titleHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     QStringLiteral("%1, %2").arg(quantityName(Quantity::Speed), curveUnit(Quantity::Speed)));
    painter.setFont(font(textPx));
    const auto &times = m_scene->frameTimes();
    ChartDrawing drawing;
    drawing.content = m_curves.content();
    drawing.low = toSeconds(times.front());
    drawing.high = std::max(toSeconds(times.back()), drawing.low + 1e-3);
    m_plot = drawChart(painter, QRectF(QPointF(0, titleHeight), m_chart.size() - QSizeF(0, titleHeight)),
                       drawing, palette, font(textPx), m_scale);
    painter.restore();
}

void AnnotatedFrame::paintStill()
{
    m_still = QImage(m_style.sizePx, QImage::Format_RGB32);
    m_still.fill(m_style.palette.color(QPalette::Window));
    QPainter painter(&m_still);
    painter.scale(m_scale, m_scale);
    painter.setRenderHint(QPainter::Antialiasing);
    paintHeader(painter);
    painter.setFont(font(textPx));
    for (const QRectF &view : m_views)
        paintCard(painter, view, ThemeColours::of(m_style.palette).imageBackground, m_style.palette);
    if (!m_map.isEmpty())
        paintMapStill(painter);
    if (!m_chart.isEmpty())
        paintChartStill(painter);
    paintFloorLayer();
}

void AnnotatedFrame::paintFloorLayer()
{
    m_floorLayer = QImage(m_style.sizePx, QImage::Format_ARGB32_Premultiplied);
    m_floorLayer.fill(Qt::transparent);
    QPainter painter(&m_floorLayer);
    painter.scale(m_scale, m_scale);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font(textPx));
    for (std::size_t view = 0; view < m_views.size(); ++view) {
        painter.setClipRect(imageRect(view));
        paintFloor(painter, *m_scene, view,
                   [this, view](const QPointF &pixel) { return inView(view, pixel); });
        painter.setClipping(false);
        drawTag(painter, m_views[view].topLeft() + QPointF(8, 18), viewTitle(m_scene->views[view]), Qt::white,
                m_views[view]);
    }
}

void AnnotatedFrame::paintTime(QPainter &painter, Nanoseconds time) const
{
    const ThemeColours colours = ThemeColours::of(m_style.palette);
    QRectF area = m_header.adjusted(0, 0, -4, 0);
    painter.setFont(font(headingPx));
    painter.setPen(colours.text);
    const QString now = timeCode(time);
    painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine, now);
    if (m_style.speed == 1)
        return;
    area.setRight(area.right() - QFontMetricsF(painter.font()).horizontalAdvance(now) - 16);
    painter.setFont(font(textPx + 2));
    painter.setPen(colours.muted);
    painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine,
                     AnnotatedFrameWords::tr("slow motion %1×").arg(QLocale().toString(m_style.speed)));
}

void AnnotatedFrame::paintView(QPainter &painter, std::size_t view, const ViewMoment &moment) const
{
    const QRectF rect = imageRect(view);
    painter.save();
    painter.resetTransform(); // images lie on whole pixels: nothing is to be resampled
    painter.drawImage(pixels(rect).topLeft(), moment.image);
    painter.drawImage(pixels(m_views[view]).topLeft(), m_floorLayer, pixels(m_views[view]));
    painter.restore();
    if (moment.image.isNull()) {
        painter.setPen(ThemeColours::of(m_style.palette).muted);
        painter.drawText(m_views[view].adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                         moment.frame < 0
                             ? AnnotatedFrameWords::tr("This camera was not recording at this time")
                             : AnnotatedFrameWords::tr("This frame cannot be decoded"));
    }
    if (moment.frame < 0)
        return;
    painter.save();
    painter.setClipRect(rect);
    for (std::size_t robot = 0; robot < m_scene->robots.size(); ++robot)
        paintRobot(painter, *m_scene, view, robot, moment.frame,
                   [this, view](const QPointF &pixel) { return inView(view, pixel); });
    painter.restore();
}

QImage AnnotatedFrame::paint(Nanoseconds time, const std::vector<ViewMoment> &views)
{
    if (m_still.isNull())
        paintStill();
    QImage image = m_still.copy();
    QPainter painter(&image);
    painter.scale(m_scale, m_scale);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTime(painter, time);
    painter.setFont(font(textPx));
    for (std::size_t view = 0; view < m_views.size(); ++view)
        paintView(painter, view, views.at(view));
    if (!m_map.isEmpty()) {
        painter.save();
        painter.setClipRect(m_map);
        painter.translate(m_map.topLeft());
        drawTrialRobots(painter, m_plan, *m_scene, time, m_style.palette);
        painter.restore();
    }
    if (!m_chart.isEmpty()) {
        painter.translate(m_chart.topLeft());
        drawChartCursor(painter, m_plot, toSeconds(time), m_style.palette);
        m_curves.drawValues(
            painter, m_plot, time, [time](std::size_t) { return toSeconds(time); }, m_style.palette);
    }
    return image;
}

} // namespace odo
