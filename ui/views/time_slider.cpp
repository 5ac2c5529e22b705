// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/time_slider.h"

#include "ui/models/timeline.h"
#include "ui/views/axis_ticks.h"
#include "ui/views/theme.h"
#include "ui/views/tool_tip.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>

namespace odo {

namespace {

constexpr double sliderMargin = 12, handleRadius = 8, grooveHeight = 5;

} // namespace

TimeSlider::TimeSlider(Timeline &timeline, QWidget *parent) : QAbstractSlider(parent), m_timeline(timeline)
{
    setOrientation(Qt::Horizontal);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Time of the trial"));
    const auto takeRange = [this] {
        setRange(0, static_cast<int>(std::max<qint64>(0, m_timeline.frameCount() - 1)));
        setPageStep(std::max(1, maximum() / 10));
        setEnabled(m_timeline.frameCount() > 0);
        update();
    };
    connect(&m_timeline, &Timeline::rangeChanged, this, takeRange);
    connect(&m_timeline, &Timeline::currentChanged, this,
            [this] { setValue(static_cast<int>(m_timeline.currentFrame())); });
    connect(&m_timeline, &Timeline::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(this, &QAbstractSlider::valueChanged, this, [this](int frame) {
        if (frame != m_timeline.currentFrame())
            m_timeline.setCurrentFrame(frame);
        update();
    });
    takeRange();
}

void TimeSlider::setScene(TrialScenePtr scene)
{
    m_scene = std::move(scene);
    m_stretches = m_scene ? doubtfulStretches(*m_scene) : std::vector<DoubtfulStretch>();
    update();
}

QSize TimeSlider::sizeHint() const
{
    return {320, static_cast<int>(2 * handleRadius) + 14 + fontMetrics().height()};
}
QSize TimeSlider::minimumSizeHint() const
{
    return {120, sizeHint().height()};
}

double TimeSlider::grooveY() const
{
    return 12 + handleRadius;
}

double TimeSlider::xOf(Nanoseconds time) const
{
    const double span = toSeconds(m_timeline.endTime() - m_timeline.startTime());
    const double part = span > 0 ? toSeconds(time - m_timeline.startTime()) / span : 0;
    return sliderMargin + part * (width() - 2 * sliderMargin);
}

void TimeSlider::goTo(double x)
{
    m_timeline.setCurrentTime(std::clamp(timeAt(x), m_timeline.startTime(), m_timeline.endTime()));
}

void TimeSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    setSliderDown(true);
    m_timeline.pause();
    goTo(event->position().x());
}

void TimeSlider::mouseMoveEvent(QMouseEvent *event)
{
    if (isSliderDown())
        goTo(event->position().x());
}

void TimeSlider::mouseReleaseEvent(QMouseEvent *)
{
    setSliderDown(false);
}

void TimeSlider::wheelEvent(QWheelEvent *event)
{
    m_timeline.step(event->angleDelta().y() > 0 ? -1 : 1);
    event->accept();
}

void TimeSlider::paintSeconds(QPainter &painter, double y) const
{
    const double start = toSeconds(m_timeline.startTime()), end = toSeconds(m_timeline.endTime());
    const QFontMetrics metrics = fontMetrics();
    const int labelWidth = metrics.horizontalAdvance(QStringLiteral("00000"));
    const AxisTicks ticks = niceTicks(start, end, std::max(2, width() / (2 * labelWidth)));
    painter.setPen(ThemeColours::of(palette()).muted);
    for (const double second : ticks.values()) {
        const double x = xOf(fromSeconds(second));
        const QRectF box(x - labelWidth / 2.0, y, labelWidth, metrics.height());
        if (second > start + 1e-9 && box.right() <= width())
            painter.drawText(box, Qt::AlignCenter, ticks.label(second));
    }
}

void TimeSlider::paintSpikes(QPainter &painter, double y) const
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(ThemeColours::of(palette()).spike);
    for (const SceneRobot &robot : m_scene->robots) {
        if (!robot.analysis)
            continue;
        for (const Spike &spike : robot.analysis->profile.spikes) {
            const double x = xOf(spike.time);
            const QPointF triangle[] = {{x - 4, y + 7}, {x + 4, y + 7}, {x, y}};
            painter.drawConvexPolygon(triangle, 3);
        }
    }
}

void TimeSlider::paintStretches(QPainter &painter, double y) const
{
    constexpr double height = 5, leastWidth = 5;
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setPen(Qt::NoPen);
    for (const DoubtfulStretch &one : m_stretches) {
        painter.setBrush(one.kind == DoubtfulStretch::Kind::Name ? QBrush(colours.spike, Qt::Dense3Pattern) : QBrush(colours.field));
        const double left = std::clamp(xOf(one.span.begin), 0.0, double(width())), right = std::clamp(xOf(one.span.end), 0.0, double(width()));
        const double more = std::max(0.0, leastWidth - (right - left)) / 2;
        painter.drawRect(QRectF(left - more, y + 2, right - left + 2 * more, height));
    }
}

Nanoseconds TimeSlider::timeAt(double x) const
{
    const double part = (x - sliderMargin) / std::max(1.0, width() - 2 * sliderMargin);
    return m_timeline.startTime() + fromSeconds(part * toSeconds(m_timeline.endTime() - m_timeline.startTime()));
}

bool TimeSlider::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QAbstractSlider::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    constexpr double reachPx = 4;
    const double x = help->pos().x();
    const QString words = doubtfulWordsAt(m_stretches, timeAt(x), timeAt(x + reachPx) - timeAt(x));
    showToolTip(*help, words, this);
    return true;
}

/// Brackets around the range that is selected.
void TimeSlider::paintSelection(QPainter &painter, double y) const
{
    if (!m_timeline.selection())
        return;
    constexpr double reach = 8, lip = 4;
    const double left = xOf(m_timeline.selection()->begin), right = xOf(m_timeline.selection()->end);
    painter.setPen(QPen(ThemeColours::of(palette()).text, 2));
    for (const auto &[x, inwards] : {std::pair(left, lip), std::pair(right, -lip)})
        painter.drawPolyline(
            QPolygonF({{x + inwards, y - reach}, {x, y - reach}, {x, y + reach}, {x + inwards, y + reach}}));
    painter.setPen(Qt::NoPen);
}

void TimeSlider::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    const double y = grooveY(), left = sliderMargin, right = width() - sliderMargin;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.border);
    painter.drawRoundedRect(QRectF(left, y - grooveHeight / 2, right - left, grooveHeight), 2, 2);
    if (m_timeline.frameCount() == 0)
        return;
    const double x = xOf(m_timeline.currentTime());
    painter.setBrush(colours.accent);
    painter.drawRoundedRect(QRectF(left, y - grooveHeight / 2, x - left, grooveHeight), 2, 2);
    paintSelection(painter, y);
    paintSeconds(painter, y + handleRadius + 2);
    if (m_scene) {
        paintStretches(painter, y - handleRadius - 8);
        paintSpikes(painter, y - handleRadius - 8);
    }
    if (hasFocus()) {
        QColor halo = colours.accent;
        halo.setAlpha(70);
        painter.setPen(Qt::NoPen);
        painter.setBrush(halo);
        painter.drawEllipse(QPointF(x, y), handleRadius + 3, handleRadius + 3);
    }
    painter.setPen(QPen(colours.accent, 2.5));
    painter.setBrush(colours.card);
    painter.drawEllipse(QPointF(x, y), handleRadius - 1, handleRadius - 1);
}

} // namespace odo
