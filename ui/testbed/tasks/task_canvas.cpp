// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/testbed/tasks/task_canvas.h"

#include "core/base/units.h"
#include "ui/models/figure_text.h"
#include "ui/views/task_overlay.h"
#include "ui/views/theme.h"

#include <QLineF>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace odo {
namespace {

constexpr double grabPx = 10, dragStepM = 0.01;
constexpr double turnStep = 5 * std::numbers::pi / 180, widthStepM = 0.02, leastWidthM = 0.02;

Eigen::Vector2d rounded(const Eigen::Vector2d &point)
{
    return dragStepM * (point / dragStepM).array().round().matrix();
}

double distancePx(const QLineF &line, const QPointF &place)
{
    const QPointF along = line.p2() - line.p1(), from = place - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double share = square > 0 ? std::clamp(QPointF::dotProduct(from, along) / square, 0.0, 1.0) : 0;
    return QLineF(line.pointAt(share), place).length();
}

} // namespace

TaskCanvas::TaskCanvas(QWidget *parent) : MapCanvas(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("The task from above"));
    setToolTip(tr("Drag a gate, or one of its ends. Keys: Page Up and Down choose a gate, arrows move it "
                  "(Shift: 100 mm, Ctrl: 1 mm), "
                  "< and > turn it, + and − change its width"));
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
    if (m_dragged == Part::None) // the ground must not move under the hand
        fit();
    forgetStill();
    describe();
}

void TaskCanvas::setCurrentGate(int gate)
{
    m_current = std::clamp(gate, -1, static_cast<int>(m_task.gates.size()) - 1);
    describe();
    update();
}

void TaskCanvas::describe()
{
    if (m_current < 0) {
        setAccessibleDescription(tr("No gate is chosen"));
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

void TaskCanvas::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    drawStill(painter);
    if (m_current >= 0 && m_editable)
        paintCurrent(painter);
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
    double nearest = grabPx;
    int found = -1;
    for (int i = 0; i < static_cast<int>(m_task.gates.size()); ++i) {
        const Gate &gate = m_task.gates[static_cast<std::size_t>(i)];
        if (!gate.from.allFinite() || !gate.to.allFinite())
            continue;
        const QLineF line(fromWorld(gate.from), fromWorld(gate.to));
        const double apart = distancePx(line, event->position());
        if (apart >= nearest)
            continue;
        nearest = apart;
        found = i;
        m_dragged = QLineF(line.p1(), event->position()).length() < grabPx   ? Part::From
                    : QLineF(line.p2(), event->position()).length() < grabPx ? Part::To
                                                                             : Part::Line;
    }
    if (found < 0)
        return;
    m_grabbed = m_task.gates[static_cast<std::size_t>(found)];
    m_grabbedAt = plan().toWorld(event->position());
    pick(found);
}

void TaskCanvas::mouseMoveEvent(QMouseEvent *event)
{
    if (m_dragged == Part::None || m_current < 0)
        return;
    const Eigen::Vector2d by = plan().toWorld(event->position()) - m_grabbedAt;
    Eigen::Vector2d from = m_grabbed.from, to = m_grabbed.to;
    if (m_dragged == Part::Line) {
        const Eigen::Vector2d step = rounded(by);
        from += step;
        to += step;
    } else {
        (m_dragged == Part::From ? from : to) = rounded((m_dragged == Part::From ? from : to) + by);
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
    if (m_current < 0 || !m_editable)
        return false;
    const Gate &gate = m_task.gates[static_cast<std::size_t>(m_current)];
    const double stepM = event.modifiers() & Qt::ShiftModifier     ? 0.1
                         : event.modifiers() & Qt::ControlModifier ? 0.001
                                                                   : 0.01;
    const Eigen::Vector2d middle = (gate.from + gate.to) / 2;
    Eigen::Vector2d half = (gate.to - gate.from) / 2, by(0, 0);
    double turn = 0, wider = 0;
    switch (event.key()) {
    case Qt::Key_Left:
        by.x() = -stepM;
        break;
    case Qt::Key_Right:
        by.x() = stepM;
        break;
    case Qt::Key_Up:
        by.y() = stepM;
        break;
    case Qt::Key_Down:
        by.y() = -stepM;
        break;
    case Qt::Key_Less:
    case Qt::Key_Comma:
        turn = turnStep;
        break;
    case Qt::Key_Greater:
    case Qt::Key_Period:
        turn = -turnStep;
        break;
    case Qt::Key_Plus:
        wider = widthStepM;
        break;
    case Qt::Key_Minus:
        wider = -widthStepM;
        break;
    default:
        return false;
    }
    const double width = std::max(leastWidthM, 2 * half.norm() + wider);
    half = Eigen::Rotation2Dd(turn) * Eigen::Vector2d(half.normalized() * width / 2);
    Q_EMIT gateMoved(m_current, middle + by - half, middle + by + half);
    return true;
}

void TaskCanvas::keyPressEvent(QKeyEvent *event)
{
    const int count = static_cast<int>(m_task.gates.size());
    if (m_editable && count > 0 && (event->key() == Qt::Key_PageDown || event->key() == Qt::Key_PageUp)) {
        const int by = event->key() == Qt::Key_PageDown ? 1 : -1;
        pick((std::max(m_current, by > 0 ? -1 : 0) + by + count) % count);
    } else if (!moveByKey(*event)) {
        MapCanvas::keyPressEvent(event);
    }
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
