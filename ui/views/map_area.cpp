// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/map_area.h"

#include "ui/models/core_words.h"
#include "ui/models/figure_text.h"
#include "ui/models/timeline.h"
#include "ui/views/chart_painting.h"
#include "ui/views/theme.h"
#include "ui/views/tool_tip.h"
#include "ui/views/trail_painting.h"
#include "ui/views/trial_map.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStringList>
#include <algorithm>

namespace odo {

MapArea::MapArea(Timeline &timeline, QWidget *parent)
    : MapCanvas(parent), m_timeline(timeline), m_bounds(Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 1))
{
    setFocusPolicy(Qt::StrongFocus);
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
    m_stretches = m_scene ? doubtfulStretches(*m_scene) : std::vector<DoubtfulStretch>();
    setDisagreements({});
    if (m_scene) {
        m_bounds = m_scene->floorBounds();
        m_topSpeedMps = topSpeedMps(*m_scene);
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
        const QString disagreement = disagreementWords(m_disagreements[robot]);
        words << (m_disagreements.size() > 1 ? joinedWords(QString::fromStdString(m_scene->robots[robot].robot.name), disagreement)
                                             : disagreement);
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
    if (m_colouring == MapColouring::Speed)
        drawSpeedLegend(painter, plan(), m_topSpeedMps, palette());
    else if (m_topDisagreementM > 0)
        drawScaleLegend(painter, plan(), tr("0 to %1 apart").arg(lengthText(m_topDisagreementM)), palette());
}

void MapArea::paintStill(QPainter &painter) const
{
    drawMapGround(painter, plan(), *m_scene, m_floor, palette());
    for (const SceneRobot &robot : m_scene->robots) {
        if (robot.analysis && m_colouring == MapColouring::Speed)
            drawSpeedTrail(painter, plan(), robot.analysis->profile, m_topSpeedMps, palette());
    }
    if (m_colouring == MapColouring::Disagreement)
        paintDisagreements(painter);
    drawMapMarks(painter, plan(), *m_scene, palette());
    paintLegend(painter);
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
    drawTrialRobots(painter, plan(), *m_scene, m_timeline.currentTime(), palette());
    drawChartFocus(painter, *this);
}

std::optional<Nanoseconds> MapArea::timeNear(const QPointF &place) const
{
    constexpr double reachPx = 20;
    double nearest = reachPx;
    std::optional<Nanoseconds> time;
    for (std::size_t robot = 0; m_scene && robot < m_scene->robots.size(); ++robot) {
        const auto &analysis = m_scene->robots[robot].analysis;
        for (std::size_t i = 0; analysis && i < analysis->profile.points.size(); ++i) {
            const ProfilePoint &point = analysis->profile.points[i];
            if (!point.valid)
                continue;
            const double apart = QLineF(fromWorld(point.position), place).length();
            if (apart < nearest) {
                nearest = apart;
                time = analysis->profile.samples[i].time;
            }
        }
    }
    return time;
}

void MapArea::mousePressEvent(QMouseEvent *event)
{
    const auto time = event->button() == Qt::LeftButton ? timeNear(event->position()) : std::nullopt;
    if (time) {
        m_timeline.pause();
        m_timeline.setCurrentTime(*time);
    }
}

bool MapArea::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return MapCanvas::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    const auto time = timeNear(help->pos());
    const QString words = time ? doubtfulWordsAt(m_stretches, *time) : QString();
    showToolTip(*help, words, this);
    return true;
}

} // namespace odo
