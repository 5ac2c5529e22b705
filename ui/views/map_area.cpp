// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map_area.h"

#include "ui/models/figure_text.h"
#include "ui/models/profile_place.h"
#include "ui/models/shown_units.h"
#include "ui/models/timeline.h"
#include "ui/views/simplified_line.h"
#include "ui/views/task_overlay.h"
#include "ui/views/theme.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {

namespace {

constexpr double footHeight = MapPlan::footHeight;

double topSpeed(const TrialScene &scene)
{
    double top = 0;
    for (const SceneRobot &robot : scene.robots) {
        if (!robot.analysis)
            continue;
        for (const ProfilePoint &point : robot.analysis->profile.points) {
            if (point.valid)
                top = std::max(top, point.speedMps);
        }
    }
    return top;
}

} // namespace

MapArea::MapArea(Timeline &timeline, QWidget *parent)
    : MapCanvas(parent), m_timeline(timeline), m_bounds(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1))
{
    connect(&m_timeline, &Timeline::currentChanged, this, qOverload<>(&QWidget::update));
    connect(&m_maker, &FloorPictureMaker::ready, this, [this](const FloorPicture &picture) {
        m_floor = picture;
        forgetStill();
        Q_EMIT settled();
    });
}

void MapArea::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_floor = {};
    setDisagreements({});
    if (m_scene) {
        m_bounds = m_scene->floorBounds();
        m_topSpeedMps = topSpeed(*m_scene);
    }
    m_maker.make(m_scene, m_bounds, plan().scalePx() * devicePixelRatioF());
    update();
}

void MapArea::resizeEvent(QResizeEvent *event)
{
    MapCanvas::resizeEvent(event);
    m_maker.setScale(plan().scalePx() * devicePixelRatioF());
}

MapPlan MapArea::plan() const
{
    return {m_bounds, QSizeF(size())};
}

QPointF MapArea::fromWorld(const Eigen::Vector2d &point) const
{
    return plan().fromWorld(point);
}

void MapArea::paintTrail(QPainter &painter, const Profile &profile) const
{
    constexpr double tolerancePx = 0.2; // less cannot be seen, and strokes cost by the point
    constexpr int colourSteps = 48;     // nor can more of them be told apart
    struct Piece
    {
        QPolygonF line;
        int colour;
    };
    std::vector<Piece> pieces;
    QPainterPath whole;
    QPolygonF run;
    const auto endRun = [&] {
        whole.addPolygon(simplified(run, tolerancePx));
        run.clear();
    };
    for (const ProfilePoint &point : profile.points) {
        if (!point.valid) {
            endRun();
            continue;
        }
        const double part = m_topSpeedMps > 0 ? point.speedMps / m_topSpeedMps : 0;
        const int colour = static_cast<int>(std::lround(colourSteps * part));
        const QPointF at = fromWorld(point.position);
        if (!run.isEmpty() && pieces.back().colour == colour)
            pieces.back().line << at;
        else
            pieces.push_back({run.isEmpty() ? QPolygonF({at}) : QPolygonF({run.back(), at}), colour});
        run << at;
    }
    endRun();
    // A rim, so that both ends of the colour scale stand out from any floor.
    const QColor rim = isDark(palette()) ? QColor(235, 238, 240, 150) : QColor(25, 30, 35, 110);
    painter.strokePath(whole, QPen(rim, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const Piece &piece : pieces) {
        painter.setPen(QPen(scaleColour(double(piece.colour) / colourSteps), 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(simplified(piece.line, tolerancePx));
    }
}

void MapArea::paintSpikes(QPainter &painter, const Profile &profile) const
{
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setPen(QPen(colours.card, 1));
    painter.setBrush(colours.spike);
    for (const Spike &spike : profile.spikes) {
        const auto index = static_cast<std::size_t>(spike.sampleIndex);
        if (index >= profile.samples.size())
            continue;
        const auto &measured = profile.samples[index].position;
        if (!measured && !profile.points[index].valid)
            continue;
        const QPointF at = fromWorld(measured ? *measured : profile.points[index].position);
        const QPointF triangle[] = {at + QPointF(-6, 5), at + QPointF(6, 5), at + QPointF(0, -6)};
        painter.drawConvexPolygon(triangle, 3);
    }
}

void MapArea::setColouring(MapColouring colouring)
{
    m_colouring = colouring;
    forgetStill();
}

void MapArea::setDisagreements(std::vector<ViewDisagreement> disagreements)
{
    constexpr double leastM = 0.001;
    m_disagreements = std::move(disagreements);
    std::vector<double> apart;
    for (const ViewDisagreement &robot : m_disagreements)
        for (const Disagreement &place : robot.places)
            apart.push_back(place.apartM);
    std::sort(apart.begin(), apart.end());
    // A few that stand out must not leave one colour for all others.
    m_topDisagreementM = apart.empty() ? 0 : std::max(leastM, apart[(apart.size() - 1) * 95 / 100]);
    forgetStill();
}

void MapArea::paintDisagreements(QPainter &painter) const
{
    constexpr double radius = 3;
    std::vector<const Disagreement *> places;
    QStringList words;
    for (std::size_t robot = 0; robot < m_disagreements.size(); ++robot) {
        const QString name =
            m_disagreements.size() > 1
                ? QString::fromStdString(m_scene->robots[robot].robot.name) + QStringLiteral(": ")
                : QString();
        words << name + disagreementWords(m_disagreements[robot]);
        for (const Disagreement &place : m_disagreements[robot].places)
            places.push_back(&place);
    }
    // The largest on top.
    std::stable_sort(places.begin(), places.end(),
                     [](const Disagreement *a, const Disagreement *b) { return a->apartM < b->apartM; });
    painter.setPen(QPen(isDark(palette()) ? QColor(235, 238, 240, 120) : QColor(25, 30, 35, 90), 0.6));
    for (const Disagreement *place : places) {
        painter.setBrush(scaleColour(std::min(1.0, place->apartM / m_topDisagreementM)));
        painter.drawEllipse(fromWorld(place->position), radius, radius);
    }
    const ThemeColours colours = ThemeColours::of(palette());
    const QRectF room(8, 4, width() - 16, height());
    const QRectF box = QFontMetricsF(font()).boundingRect(room, Qt::TextWordWrap, words.join(u'\n'));
    QColor ground = colours.mapGround;
    ground.setAlpha(225);
    painter.fillRect(QRectF(0, 0, width(), box.height() + 8), ground);
    painter.setPen(colours.text);
    painter.drawText(room, Qt::TextWordWrap, words.join(u'\n'));
}

void MapArea::paintLegend(QPainter &painter) const
{
    const bool isSpeed = m_colouring == MapColouring::Speed;
    if ((isSpeed ? m_topSpeedMps : m_topDisagreementM) <= 0)
        return;
    constexpr int barWidth = 76, barHeight = 7;
    const double left = 12, middle = height() - footHeight / 2.0 + 1;
    const ThemeColours colours = ThemeColours::of(palette());
    QLinearGradient gradient(left, 0, left + barWidth, 0);
    for (int i = 0; i <= 8; ++i)
        gradient.setColorAt(i / 8.0, scaleColour(i / 8.0));
    painter.setPen(QPen(colours.border, 1));
    painter.setBrush(gradient);
    painter.drawRect(QRectF(left, middle - barHeight / 2.0, barWidth, barHeight));
    painter.setPen(colours.muted);
    const ShownUnit &speed = shownUnits().speed;
    const double top = speed.perSi * m_topSpeedMps;
    painter.drawText(QPointF(left + barWidth + 7, middle + QFontMetricsF(font()).capHeight() / 2),
                     isSpeed ? tr("0 to %1 %2").arg(QLocale().toString(top, 'f', top < 1 ? 2 : 1), speed.name)
                             : tr("0 to %1 apart").arg(lengthText(m_topDisagreementM)));
}

void MapArea::paintStill(QPainter &painter) const
{
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!m_floor.image.isNull()) {
        constexpr double muted = 0.55; // the trail comes first
        painter.setOpacity(muted);
        painter.drawImage(QRectF(fromWorld({m_floor.extent.min().x(), m_floor.extent.max().y()}),
                                 fromWorld({m_floor.extent.max().x(), m_floor.extent.min().y()})),
                          m_floor.image);
        painter.setOpacity(1);
    }
    // The foot is kept calm, so that scale and legend can be read over any floor.
    QColor foot = colours.mapGround;
    foot.setAlpha(215);
    painter.fillRect(QRectF(0, height() - footHeight, width(), footHeight), foot);
    drawMapGrid(painter, plan(), palette(), !m_floor.image.isNull());
    if (m_scene->layout)
        drawMapMarkers(painter, plan(), *m_scene->layout, palette());
    const auto toScreen = [this](const Eigen::Vector2d &point) { return fromWorld(point); };
    if (m_scene->task)
        drawReferencePath(painter, m_scene->task->path, toScreen, palette());
    for (const SceneRobot &robot : m_scene->robots) {
        if (robot.analysis && m_colouring == MapColouring::Speed)
            paintTrail(painter, robot.analysis->profile);
    }
    if (m_colouring == MapColouring::Disagreement)
        paintDisagreements(painter);
    if (m_scene->task)
        drawGates(painter, m_scene->task->gates, toScreen, palette());
    for (const SceneRobot &robot : m_scene->robots) {
        if (robot.analysis)
            paintSpikes(painter, robot.analysis->profile);
    }
    paintLegend(painter);
}

void MapArea::paintRobot(QPainter &painter, std::size_t robot) const
{
    const SceneRobot &shown = m_scene->robots[robot];
    if (!shown.analysis)
        return;
    const Profile &profile = shown.analysis->profile;
    const std::ptrdiff_t index = pointIndexAt(profile, m_timeline.currentTime());
    if (index < 0)
        return;
    const ProfilePoint &point = profile.points[static_cast<std::size_t>(index)];
    const bool alone = m_scene->robots.size() == 1;
    MapRobot sign{&shown.robot,
                  point.position,
                  point.sigmaXM,
                  point.sigmaYM,
                  drivenHeadingAt(profile, index),
                  alone ? ThemeColours::of(palette()).spike : seriesColour(int(robot), palette()),
                  {}};
    if (!alone)
        sign.label = QString::fromStdString(shown.robot.name);
    drawMapRobot(painter, plan(), sign, palette());
}

void MapArea::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    const ThemeColours colours = ThemeColours::of(palette());
    if (!m_scene) {
        painter.fillRect(rect(), colours.mapGround);
        return;
    }
    drawStill(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t robot = 0; robot < m_scene->robots.size(); ++robot)
        paintRobot(painter, robot);
}

void MapArea::mousePressEvent(QMouseEvent *event)
{
    if (!m_scene || event->button() != Qt::LeftButton)
        return;
    constexpr double reachPx = 20;
    double nearest = reachPx;
    std::optional<Nanoseconds> time;
    for (const SceneRobot &robot : m_scene->robots) {
        for (std::size_t i = 0; robot.analysis && i < robot.analysis->profile.points.size(); ++i) {
            const ProfilePoint &point = robot.analysis->profile.points[i];
            if (!point.valid)
                continue;
            const double apart = QLineF(fromWorld(point.position), event->position()).length();
            if (apart < nearest) {
                nearest = apart;
                time = robot.analysis->profile.samples[i].time;
            }
        }
    }
    if (time) {
        m_timeline.pause();
        m_timeline.setCurrentTime(*time);
    }
}

} // namespace odo
