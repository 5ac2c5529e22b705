// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/internal/compare_map.h"

#include "ui/models/timeline.h"
#include "ui/models/trial_scene.h"
#include "ui/views/charts/chart_overlay.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/map/trial_map.h"
#include "ui/views/widgets/theme.h"
#include "ui/views/widgets/zoom_pan.h"

#include <QKeyEvent>
#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace odo {

namespace {

constexpr double grabPx = 9, clickPx = 20;
constexpr double fineM = 0.01, coarseM = 0.1;

} // namespace

CompareMap::CompareMap(Timeline &timeline, QWidget *parent)
    : MapCanvas(parent), m_timeline(timeline), m_zoom(new ZoomPan(*this))
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    m_zoom->setDragFilter([this](const QPointF &position) { return !gateAt(position); });
    connect(m_zoom, &ZoomPan::changed, this, &CompareMap::forgetStill);
    connect(&m_timeline, &Timeline::currentChanged, this, qOverload<>(&QWidget::update));
    connect(&m_maker, &FloorImageMaker::ready, this, [this](const FloorImage &image) {
        m_floor = image;
        forgetStill();
        Q_EMIT settled();
    });
}

void CompareMap::setScene(ComparisonScenePtr scene)
{
    const bool sameFloor =
        m_scene && scene && m_scene->scenes.front()->trial.id == scene->scenes.front()->trial.id;
    m_scene = std::move(scene);
    m_chosen.reset();
    if (m_scene)
        m_bounds = m_scene->floorBounds();
    showFloor();
    forgetStill();
    if (sameFloor)
        return;
    m_floor = {};
    m_maker.make(m_scene ? m_scene->scenes.front() : nullptr, m_bounds,
                 fittedPlan().scalePx() * devicePixelRatioF());
}

void CompareMap::resizeEvent(QResizeEvent *event)
{
    MapCanvas::resizeEvent(event);
    showFloor();
    m_maker.setScale(fittedPlan().scalePx() * devicePixelRatioF());
}

void CompareMap::setGates(std::vector<PathGate> gates)
{
    m_gates = std::move(gates);
    update();
}

void CompareMap::showFloor()
{
    m_zoom->setFrame(QRectF(rect()), fittedPlan().mostZoom());
}

MapPlan CompareMap::fittedPlan() const
{
    return {m_bounds, QSizeF(size())};
}

MapPlan CompareMap::plan() const
{
    return {m_bounds, QSizeF(size()), m_zoom->state().scale(), m_zoom->state().shift()};
}

void CompareMap::paintStill(QPainter &painter) const
{
    const MapPlan shown = plan();
    constexpr double muted = 0.4; // the paths come first
    drawMapFloor(painter, shown, *m_scene->scenes.front(), m_floor, muted, palette());
    if (m_scene->compared.comparison.isTasksPath)
        drawReferencePath(
            painter, path(), [&shown](const Eigen::Vector2d &point) { return shown.fromWorld(point); },
            palette());
    std::vector<std::size_t> runs(m_scene->runCount());
    std::iota(runs.begin(), runs.end(), std::size_t(0));
    drawPaths(painter, shown, *m_scene, runs, palette());
}

QLineF CompareMap::gateLine(std::size_t gate) const
{
    return pathGateLine(plan(), path(), m_gates[gate]);
}

QPointF CompareMap::gatePosition(std::size_t gate) const
{
    return gateLine(gate).center();
}

void CompareMap::paintRobots(QPainter &painter) const
{
    for (std::size_t run = m_scene->runCount(); run-- > 0;) {
        const Profile &profile = m_scene->profile(run);
        const std::ptrdiff_t index = pointIndexAt(profile, m_scene->ownTime(run, m_timeline.currentTime()));
        if (index < 0)
            continue;
        const ProfilePoint &point = profile.points[static_cast<std::size_t>(index)];
        drawMapRobot(painter, plan(),
                     {&m_scene->robot(run), point.position, point.sigmaXM, point.sigmaYM,
                      drivenHeadingAt(profile, index), seriesColour(int(run), palette()), QString(),
                      m_scene->scenes[run]->referenceM(m_scene->robots[run])},
                     palette());
    }
}

void CompareMap::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    if (!m_scene) {
        painter.fillRect(rect(), ThemeColours::of(palette()).mapGround);
        return;
    }
    drawStill(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t gate = 0; gate < m_gates.size(); ++gate)
        drawPathGate(painter, gateLine(gate), QString::fromStdString(m_gates[gate].name), m_chosen == gate,
                     palette());
    paintRobots(painter);
    drawChartFocus(painter, *this);
}

std::optional<std::size_t> CompareMap::gateAt(const QPointF &position) const
{
    std::optional<std::size_t> nearest;
    double leastPx = grabPx;
    for (std::size_t gate = 0; m_scene && gate < m_gates.size(); ++gate) {
        const QLineF line = gateLine(gate);
        const QPointF along = line.unitVector().p2() - line.p1(), apart = position - line.p1();
        const double part = std::clamp(QPointF::dotProduct(apart, along), 0.0, line.length());
        const double px = QLineF(position, line.p1() + part * along).length();
        if (px <= leastPx) {
            leastPx = px;
            nearest = gate;
        }
    }
    return nearest;
}

double CompareMap::nearestStation(const QPointF &position, double aroundM) const
{
    // Where the path crosses itself a gate stays on the branch that it is on.
    constexpr double faithfulness = 0.15;
    const Eigen::Vector2d wanted = plan().toWorld(position);
    const std::vector<Eigen::Vector2d> &points = path().points;
    const double lengthM = lengthOf(path());
    double bestM = aroundM, least = std::numeric_limits<double>::infinity(), stationM = 0;
    for (std::size_t i = 0; i + (path().closed ? 0 : 1) < points.size(); ++i) {
        const Eigen::Vector2d way = points[(i + 1) % points.size()] - points[i];
        const double pieceM = way.norm();
        if (pieceM <= 0)
            continue;
        const double alongM = std::clamp(way.dot(wanted - points[i]) / pieceM, 0.0, pieceM),
                     hereM = stationM + alongM;
        const double apartM = path().closed ? std::remainder(hereM - aroundM, lengthM) : hereM - aroundM;
        const double price =
            (points[i] + alongM / pieceM * way - wanted).norm() + faithfulness * std::abs(apartM);
        if (price < least) {
            least = price;
            bestM = hereM;
        }
        stationM += pieceM;
    }
    return bestM;
}

void CompareMap::moveGate(std::size_t gate, double stationM)
{
    const double lengthM = lengthOf(path());
    stationM = path().closed ? stationM - lengthM * std::floor(stationM / lengthM)
                             : std::clamp(stationM, 0.0, lengthM);
    m_gates[gate].stationM = stationM;
    update();
    Q_EMIT gatesMoved(m_gates);
}

void CompareMap::goToNearest(const QPointF &position)
{
    const MapPlan shown = plan();
    double least = clickPx;
    std::optional<Nanoseconds> time;
    for (std::size_t run = 0; run < m_scene->runCount(); ++run) {
        const Profile &profile = m_scene->profile(run);
        for (std::size_t i = 0; i < profile.points.size(); ++i) {
            const double px = profile.points[i].valid
                                  ? QLineF(shown.fromWorld(profile.points[i].position), position).length()
                                  : clickPx;
            if (px < least) {
                least = px;
                time = m_scene->commonTime(run, profile.samples[i].time);
            }
        }
    }
    if (time) {
        m_timeline.pause();
        m_timeline.setCurrentTime(*time);
    }
}

void CompareMap::mousePressEvent(QMouseEvent *event)
{
    if (!m_scene || event->button() != Qt::LeftButton)
        return;
    m_chosen = gateAt(event->position());
    m_isDragged = m_chosen.has_value();
    if (!m_chosen)
        goToNearest(event->position());
    update();
}

void CompareMap::mouseMoveEvent(QMouseEvent *event)
{
    if (m_isDragged)
        moveGate(*m_chosen, nearestStation(event->position(), m_gates[*m_chosen].stationM));
    else
        setCursor(gateAt(event->position()) ? Qt::OpenHandCursor : Qt::ArrowCursor);
}

void CompareMap::mouseReleaseEvent(QMouseEvent *)
{
    m_isDragged = false;
}

bool CompareMap::wants(const QKeyEvent &event) const
{
    if (!m_scene || m_gates.empty() || (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)))
        return false;
    const int key = event.key();
    return key == Qt::Key_Up || key == Qt::Key_Down ||
           (m_chosen && (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Escape));
}

bool CompareMap::event(QEvent *event)
{
    // Left and Right move the time unless a gate is chosen.
    if (event->type() == QEvent::ShortcutOverride && wants(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return MapCanvas::event(event);
}

void CompareMap::keyPressEvent(QKeyEvent *event)
{
    if (!wants(*event)) {
        MapCanvas::keyPressEvent(event);
        return;
    }
    const double stepM = event->modifiers() & Qt::ShiftModifier ? coarseM : fineM;
    switch (event->key()) {
    case Qt::Key_Up:
        m_chosen = m_chosen ? (*m_chosen + m_gates.size() - 1) % m_gates.size() : m_gates.size() - 1;
        break;
    case Qt::Key_Down:
        m_chosen = m_chosen ? (*m_chosen + 1) % m_gates.size() : 0;
        break;
    case Qt::Key_Escape:
        m_chosen.reset();
        break;
    default:
        moveGate(*m_chosen, m_gates[*m_chosen].stationM + (event->key() == Qt::Key_Left ? -stepM : stepM));
    }
    update();
}

void CompareMap::focusOutEvent(QFocusEvent *event)
{
    m_chosen.reset();
    m_isDragged = false;
    MapCanvas::focusOutEvent(event);
    update();
}

} // namespace odo
