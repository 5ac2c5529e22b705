// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/internal/task_canvas.h"

#include "core/base/units.h"
#include "ui/models/number_text.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/tasks/internal/part_tables.h"
#include "ui/views/map/map_painting.h"
#include "ui/views/widgets/theme.h"

#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {
namespace {

constexpr double turnStep = 5 * std::numbers::pi / 180, widthStepM = 0.02, leastWidthM = 0.02;

double distancePx(const QLineF &line, const QPointF &position)
{
    const QPointF along = line.p2() - line.p1(), from = position - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double share = square > 0 ? std::clamp(QPointF::dotProduct(from, along) / square, 0.0, 1.0) : 0;
    return QLineF(line.pointAt(share), position).length();
}

bool canBeDrawn(const Zone &zone)
{
    return zone.corners.size() >= 2 && std::ranges::all_of(zone.corners, [](const Eigen::Vector2d &corner) {
               return corner.allFinite();
           });
}

/// What a key does to the chosen gate or zone.
struct Nudge
{
    Eigen::Vector2d by = Eigen::Vector2d::Zero();
    double turn = 0, widerM = 0;
};

std::optional<Nudge> nudgeOf(const QKeyEvent &event)
{
    const double stepM = event.modifiers() & Qt::ShiftModifier     ? 0.1
                         : event.modifiers() & Qt::ControlModifier ? 0.001
                                                                   : 0.01;
    switch (event.key()) {
    case Qt::Key_Left:
        return Nudge{{-stepM, 0}};
    case Qt::Key_Right:
        return Nudge{{stepM, 0}};
    case Qt::Key_Up:
        return Nudge{{0, stepM}};
    case Qt::Key_Down:
        return Nudge{{0, -stepM}};
    case Qt::Key_Less:
    case Qt::Key_Comma:
        return Nudge{{0, 0}, turnStep};
    case Qt::Key_Greater:
    case Qt::Key_Period:
        return Nudge{{0, 0}, -turnStep};
    case Qt::Key_Plus:
        return Nudge{{0, 0}, 0, widthStepM};
    case Qt::Key_Minus:
        return Nudge{{0, 0}, 0, -widthStepM};
    default:
        return std::nullopt;
    }
}

} // namespace

TaskCanvas::TaskCanvas(QWidget *parent) : MapCanvas(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("The task from above"));
    setToolTip(tr("Drag a gate or one of its ends, a zone's edge or corner. Keys: Page Up and Down choose a "
                  "gate or a zone, arrows move "
                  "it (Shift: 100 mm, Ctrl: 1 mm), < and > turn it, + and − change its width"));
    setMouseTracking(true);
    fit();
}

void TaskCanvas::setLayout(const std::optional<MarkerLayout> &layout)
{
    m_layout = layout;
    fit();
}

void TaskCanvas::setTask(const Task &task)
{
    m_task = task;
    m_current = std::min(m_current, static_cast<int>(task.gates.size()) - 1);
    m_zone = std::min(m_zone, static_cast<int>(task.zones.size()) - 1);
    if (m_dragged == Part::None) // the ground must not move under the hand
        fit();
    forgetStill();
    describe();
}

void TaskCanvas::setCurrentGate(int gate)
{
    m_current = std::clamp(gate, -1, static_cast<int>(m_task.gates.size()) - 1);
    m_zone = -1;
    describe();
    update();
}

void TaskCanvas::setCurrentZone(int zone)
{
    m_zone = std::clamp(zone, -1, static_cast<int>(m_task.zones.size()) - 1);
    m_current = -1;
    describe();
    update();
}

void TaskCanvas::describe()
{
    if (m_zone >= 0) {
        const Zone &zone = m_task.zones[static_cast<std::size_t>(m_zone)];
        setAccessibleDescription(
            tr("Zone %1, %2: %3 mm")
                .arg(QString::fromStdString(zone.name), zoneRuleName(zone.rule), cornersText(zone.corners)));
        return;
    }
    if (m_current < 0) {
        setAccessibleDescription(tr("No gate or zone is chosen"));
        return;
    }
    const Gate &gate = m_task.gates[static_cast<std::size_t>(m_current)];
    setAccessibleDescription(tr("Gate %1 from %2, %3 to %4, %5")
                                 .arg(QString::fromStdString(gate.name), lengthText(gate.from.x()),
                                      lengthText(gate.from.y()), lengthText(gate.to.x()),
                                      lengthText(gate.to.y())));
}

void TaskCanvas::fit()
{
    Eigen::AlignedBox2d box;
    if (m_layout)
        for (const Marker &marker : m_layout->markers)
            box.extend(marker.pointInWorld);
    for (const Gate &gate : m_task.gates)
        if (gate.from.allFinite() && gate.to.allFinite())
            box.extend(gate.from).extend(gate.to);
    for (const Eigen::Vector2d &point : m_task.path.points)
        box.extend(point);
    for (const Zone &zone : m_task.zones)
        for (const Eigen::Vector2d &corner : zone.corners)
            if (corner.allFinite())
                box.extend(corner);
    if (box.isEmpty() || box.sizes().maxCoeff() <= 0)
        box = {Eigen::Vector2d(0, 0), Eigen::Vector2d(3, 2)};
    m_bounds = box;
    forgetStill();
}

MapPlan TaskCanvas::plan() const
{
    return {m_bounds, QSizeF(size())};
}

void TaskCanvas::paintStill(QPainter &painter) const
{
    drawMapGrid(painter, plan(), palette(), false);
    if (m_layout)
        drawMapMarkers(painter, plan(), *m_layout, palette());
    const auto toScreen = [this](const Eigen::Vector2d &point) { return fromWorld(point); };
    std::vector<Zone> drawn = m_task.zones;
    std::erase_if(drawn, [](const Zone &zone) { return !canBeDrawn(zone); });
    drawZones(painter, drawn, toScreen, palette());
    drawReferencePath(painter, m_task.path, toScreen, palette());
    std::vector<Gate> sound = m_task.gates;
    std::erase_if(sound, [](const Gate &gate) { return !gate.from.allFinite() || !gate.to.allFinite(); });
    drawGates(painter, sound, toScreen, palette());
}

void TaskCanvas::paintCurrent(QPainter &painter) const
{
    const Gate &gate = m_task.gates[static_cast<std::size_t>(m_current)];
    if (!gate.from.allFinite() || !gate.to.allFinite())
        return;
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.accent, 2));
    painter.setBrush(colours.card);
    for (const Eigen::Vector2d &end : {gate.from, gate.to})
        painter.drawRect(QRectF(fromWorld(end) - QPointF(5, 5), QSizeF(10, 10)));
    painter.setBrush(colours.accent);
    painter.drawEllipse(fromWorld((gate.from + gate.to) / 2), 4, 4);
}

void TaskCanvas::paintCurrentZone(QPainter &painter) const
{
    const Zone &zone = m_task.zones[static_cast<std::size_t>(m_zone)];
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.accent, 2));
    painter.setBrush(colours.card);
    for (const Eigen::Vector2d &corner : zone.corners)
        if (corner.allFinite())
            painter.drawRect(QRectF(fromWorld(corner) - QPointF(5, 5), QSizeF(10, 10)));
}

void TaskCanvas::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    drawStill(painter);
    if (m_current >= 0 && m_editable)
        paintCurrent(painter);
    if (m_zone >= 0 && m_editable)
        paintCurrentZone(painter);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(QPen(ThemeColours::of(palette()).accent, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void TaskCanvas::pick(int gate)
{
    setCurrentGate(gate);
    Q_EMIT gatePicked(gate);
}

void TaskCanvas::mousePressEvent(QMouseEvent *event)
{
    if (!m_editable || event->button() != Qt::LeftButton)
        return;
    if (grabGate(event->position()) || grabZone(event->position()))
        m_grabbedAt = plan().toWorld(event->position());
}

bool TaskCanvas::grabGate(const QPointF &position)
{
    double nearest = floorGrabPx;
    int found = -1;
    for (int i = 0; i < static_cast<int>(m_task.gates.size()); ++i) {
        const Gate &gate = m_task.gates[static_cast<std::size_t>(i)];
        if (!gate.from.allFinite() || !gate.to.allFinite())
            continue;
        const QLineF line(fromWorld(gate.from), fromWorld(gate.to));
        const double apart = distancePx(line, position);
        if (apart >= nearest)
            continue;
        nearest = apart;
        found = i;
        m_dragged = QLineF(line.p1(), position).length() < floorGrabPx   ? Part::From
                    : QLineF(line.p2(), position).length() < floorGrabPx ? Part::To
                                                                         : Part::Line;
    }
    if (found < 0)
        return false;
    m_grabbed = m_task.gates[static_cast<std::size_t>(found)];
    pick(found);
    return true;
}

bool TaskCanvas::grabZone(const QPointF &position)
{
    double nearest = floorGrabPx;
    int found = -1;
    for (int i = 0; i < static_cast<int>(m_task.zones.size()); ++i) {
        const Zone &zone = m_task.zones[static_cast<std::size_t>(i)];
        if (!canBeDrawn(zone))
            continue;
        for (std::size_t k = 0; k < zone.corners.size(); ++k) {
            const QLineF edge(fromWorld(zone.corners[k]),
                              fromWorld(zone.corners[(k + 1) % zone.corners.size()]));
            const double apart = distancePx(edge, position);
            if (apart >= nearest)
                continue;
            nearest = apart;
            found = i;
            const bool isFirst = QLineF(edge.p1(), position).length() < floorGrabPx,
                       isSecond = QLineF(edge.p2(), position).length() < floorGrabPx;
            m_dragged = isFirst || isSecond ? Part::Corner : Part::Zone;
            m_grabbedCorner = isSecond ? (k + 1) % zone.corners.size() : k;
        }
    }
    if (found < 0)
        return false;
    m_grabbedCorners = m_task.zones[static_cast<std::size_t>(found)].corners;
    setCurrentZone(found);
    Q_EMIT zonePicked(found);
    return true;
}

void TaskCanvas::mouseMoveEvent(QMouseEvent *event)
{
    const Eigen::Vector2d by = plan().toWorld(event->position()) - m_grabbedAt;
    if ((m_dragged == Part::Corner || m_dragged == Part::Zone) && m_zone >= 0) {
        std::vector<Eigen::Vector2d> corners = m_grabbedCorners;
        if (m_dragged == Part::Corner)
            corners[m_grabbedCorner] = onDragStep(corners[m_grabbedCorner] + by);
        else
            for (Eigen::Vector2d &corner : corners)
                corner += onDragStep(by);
        Q_EMIT zoneMoved(m_zone, corners);
        return;
    }
    if (m_dragged == Part::None || m_current < 0)
        return;
    Eigen::Vector2d from = m_grabbed.from, to = m_grabbed.to;
    if (m_dragged == Part::Line) {
        const Eigen::Vector2d step = onDragStep(by);
        from += step;
        to += step;
    } else {
        (m_dragged == Part::From ? from : to) = onDragStep((m_dragged == Part::From ? from : to) + by);
    }
    if ((to - from).norm() >= leastWidthM)
        Q_EMIT gateMoved(m_current, from, to);
}

void TaskCanvas::mouseReleaseEvent(QMouseEvent *)
{
    if (std::exchange(m_dragged, Part::None) != Part::None)
        fit();
}

bool TaskCanvas::moveByKey(const QKeyEvent &event)
{
    const std::optional<Nudge> nudge = m_editable ? nudgeOf(event) : std::nullopt;
    if (!nudge || (m_current < 0 && m_zone < 0))
        return false;
    if (m_zone >= 0) {
        std::vector<Eigen::Vector2d> corners = m_task.zones[static_cast<std::size_t>(m_zone)].corners;
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d &corner : corners)
            box.extend(corner);
        if (!box.sizes().allFinite() || box.sizes().maxCoeff() <= 0)
            return true;
        const double share =
            std::max(leastWidthM, box.sizes().maxCoeff() + nudge->widerM) / box.sizes().maxCoeff();
        for (Eigen::Vector2d &corner : corners)
            corner = box.center() + nudge->by +
                     Eigen::Rotation2Dd(nudge->turn) * Eigen::Vector2d(share * (corner - box.center()));
        Q_EMIT zoneMoved(m_zone, corners);
        return true;
    }
    const Gate &gate = m_task.gates[static_cast<std::size_t>(m_current)];
    const Eigen::Vector2d middle = (gate.from + gate.to) / 2;
    Eigen::Vector2d half = (gate.to - gate.from) / 2;
    const double width = std::max(leastWidthM, 2 * half.norm() + nudge->widerM);
    half = Eigen::Rotation2Dd(nudge->turn) * Eigen::Vector2d(half.normalized() * width / 2);
    Q_EMIT gateMoved(m_current, middle + nudge->by - half, middle + nudge->by + half);
    return true;
}

/// The next one, gates first, zones after them, round.
void TaskCanvas::choose(int by)
{
    const int gates = static_cast<int>(m_task.gates.size()),
              count = gates + static_cast<int>(m_task.zones.size());
    const int now = m_zone >= 0 ? gates + m_zone : m_current;
    const int next = (std::max(now, by > 0 ? -1 : 0) + by + count) % count;
    if (next < gates)
        return pick(next);
    setCurrentZone(next - gates);
    Q_EMIT zonePicked(next - gates);
}

void TaskCanvas::keyPressEvent(QKeyEvent *event)
{
    const bool any = !m_task.gates.empty() || !m_task.zones.empty();
    if (m_editable && any && (event->key() == Qt::Key_PageDown || event->key() == Qt::Key_PageUp))
        choose(event->key() == Qt::Key_PageDown ? 1 : -1);
    else if (!moveByKey(*event))
        MapCanvas::keyPressEvent(event);
}

void TaskCanvas::focusInEvent(QFocusEvent *event)
{
    MapCanvas::focusInEvent(event);
    update();
}

void TaskCanvas::focusOutEvent(QFocusEvent *event)
{
    MapCanvas::focusOutEvent(event);
    update();
}

} // namespace odo
