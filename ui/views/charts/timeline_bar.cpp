// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/charts/timeline_bar.h"

#include "ui/models/number_text.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/chart_axis.h"
#include "ui/views/widgets/labels.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QColor>
#include <QComboBox>
#include <QEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHelpEvent>
#include <QIcon>
#include <QIconEngine>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

namespace odo {

namespace {

constexpr double sliderMargin = 12, handleRadius = 8, grooveHeight = 5, handleReach = 7;

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
    m_stretches = m_scene ? uncertainIntervals(*m_scene) : std::vector<UncertainInterval>();
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

TimeSpan TimeSlider::range() const
{
    if (m_dragged)
        return *m_dragged;
    return m_scene && m_scene->trial.range ? *m_scene->trial.range
                                           : TimeSpan{m_timeline.startTime(), m_timeline.endTime()};
}

/// The handles are below the groove, where the slider's own does not cover them.
bool TimeSlider::beginDrag(const QPointF &position)
{
    if (!m_scene || m_scene->trial.unfinished || position.y() < grooveY() + grooveHeight)
        return false;
    const TimeSpan now = range();
    const double toBegin = std::abs(position.x() - xOf(now.begin)),
                 toEnd = std::abs(position.x() - xOf(now.end));
    if (std::min(toBegin, toEnd) > handleReach)
        return false;
    m_dragsEnd = toEnd < toBegin;
    m_dragged = now;
    return true;
}

void TimeSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    m_timeline.pause();
    if (beginDrag(event->position()))
        return;
    setSliderDown(true);
    goTo(event->position().x());
}

void TimeSlider::mouseMoveEvent(QMouseEvent *event)
{
    if (isSliderDown())
        goTo(event->position().x());
    if (!m_dragged)
        return;
    goTo(event->position().x()); // to see what is there
    const Nanoseconds time = m_timeline.currentTime();
    if (m_dragsEnd && time > m_dragged->begin)
        m_dragged->end = time;
    else if (!m_dragsEnd && time < m_dragged->end)
        m_dragged->begin = time;
    update();
}

void TimeSlider::mouseReleaseEvent(QMouseEvent *)
{
    setSliderDown(false);
    const auto dragged = std::exchange(m_dragged, std::nullopt);
    if (dragged && *dragged != range())
        Q_EMIT rangeDragged(*dragged);
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
    for (const UncertainInterval &one : m_stretches) {
        painter.setBrush(one.kind == UncertainInterval::Kind::Name ? QBrush(colours.spike, Qt::Dense3Pattern)
                                                                   : QBrush(colours.field));
        const double left = std::clamp(xOf(one.span.begin), 0.0, double(width())),
                     right = std::clamp(xOf(one.span.end), 0.0, double(width()));
        const double more = std::max(0.0, leastWidth - (right - left)) / 2;
        painter.drawRect(QRectF(left - more, y + 2, right - left + 2 * more, height));
    }
}

Nanoseconds TimeSlider::timeAt(double x) const
{
    const double part = (x - sliderMargin) / std::max(1.0, width() - 2 * sliderMargin);
    return m_timeline.startTime() +
           fromSeconds(part * toSeconds(m_timeline.endTime() - m_timeline.startTime()));
}

bool TimeSlider::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QAbstractSlider::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    constexpr double reachPx = 4;
    const double x = help->pos().x();
    const QString words = uncertaintyTextAt(m_stretches, timeAt(x), timeAt(x + reachPx) - timeAt(x));
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

/// What is outside is dimmed; a handle hangs from either end.
void TimeSlider::paintRange(QPainter &painter, double y) const
{
    constexpr double width = 8, height = 11;
    const ThemeColours colours = ThemeColours::of(palette());
    const double left = xOf(range().begin), right = xOf(range().end);
    painter.setPen(Qt::NoPen);
    QColor veil = colours.card;
    veil.setAlpha(190);
    painter.setBrush(veil);
    painter.drawRect(QRectF(QPointF(0, 0), QPointF(left, this->height())));
    painter.drawRect(QRectF(QPointF(right, 0), QPointF(this->width(), this->height())));
    const bool isSet = m_dragged || (m_scene && m_scene->trial.range);
    painter.setPen(QPen(isSet ? colours.accent : colours.field, 1.5));
    painter.setBrush(isSet ? colours.accent : colours.card);
    for (const double x : {left, right}) {
        const double inwards = x == left ? width : -width;
        painter.drawPolygon(QPolygonF({{x, y + grooveHeight},
                                       {x + inwards, y + grooveHeight + height},
                                       {x, y + grooveHeight + height}}));
        painter.drawLine(QPointF(x, y - handleRadius), QPointF(x, y + grooveHeight + height));
    }
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
        paintRange(painter, y);
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

/// The signs of a player's buttons.
enum class TransportSign { First, Play, Pause, Last };

namespace {

/// A triangle that points to the right, in a unit square.
QPainterPath triangle(double left, double right)
{
    QPainterPath path(QPointF(left, 0.14));
    path.lineTo(right, 0.5);
    path.lineTo(left, 0.86);
    path.closeSubpath();
    return path;
}

QPainterPath signPath(TransportSign sign)
{
    QPainterPath path;
    switch (sign) {
    case TransportSign::Play:
        return triangle(0.22, 0.88);
    case TransportSign::Pause:
        path.addRect(0.22, 0.14, 0.2, 0.72);
        path.addRect(0.58, 0.14, 0.2, 0.72);
        return path;
    case TransportSign::Last:
        path = triangle(0.14, 0.7);
        path.addRect(0.74, 0.14, 0.13, 0.72);
        return path;
    case TransportSign::First:
        return QTransform(-1, 0, 0, 1, 1, 0).map(signPath(TransportSign::Last));
    }
    return path;
}

class SignEngine : public QIconEngine
{
public:
    SignEngine(TransportSign sign, const QColor &colour) : m_sign(sign), m_colour(colour) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        QColor colour = m_colour;
        if (mode == QIcon::Disabled)
            colour.setAlphaF(0.4F);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width(), rect.height());
        painter->fillPath(signPath(m_sign), colour);
        painter->restore();
    }
    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine *clone() const override { return new SignEngine(m_sign, m_colour); }

private:
    TransportSign m_sign;
    QColor m_colour;
};

} // namespace

/// Painted at whatever size and device pixel ratio it is shown, in one colour; lighter when disabled.
QIcon transportIcon(TransportSign sign, const QColor &colour)
{
    return QIcon(new SignEngine(sign, colour));
}

namespace {

constexpr double offeredRates[] = {0.1, 0.25, 0.5, 1, 2, 4, 8};

QString rateText(double rate)
{
    return QLocale().toString(rate, 'g', 3) + QChar(u'×');
}

} // namespace

TimelineBar::TimelineBar(Timeline &timeline, QWidget *parent)
    : QFrame(parent), m_timeline(timeline), m_first(new QToolButton(this)), m_play(new QToolButton(this)),
      m_last(new QToolButton(this)), m_time(new QLabel(this)), m_frame(new QLabel(this)),
      m_slider(new TimeSlider(timeline, this)), m_rate(new QComboBox(this))
{
    setAccessibleName(tr("Timeline"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    makeButtons();
    m_time->setTextFormat(Qt::PlainText);
    m_frame->setTextFormat(Qt::PlainText);
    m_time->setAccessibleName(tr("Time"));
    m_frame->setAccessibleName(tr("Frame"));
    m_rate->setAccessibleName(tr("Playback speed"));
    m_rate->setToolTip(tr("Playback speed"));
    m_rate->setFocusPolicy(Qt::TabFocus); // Space goes on playing
    for (const double rate : offeredRates)
        m_rate->addItem(rateText(rate), rate);
    connect(m_rate, &QComboBox::activated, this,
            [this](int index) { m_timeline.setRate(m_rate->itemData(index).toDouble()); });

    auto *words = new QVBoxLayout;
    words->setSpacing(1);
    words->addStretch();
    words->addWidget(m_time);
    words->addWidget(m_frame);
    words->addStretch();
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(14, 10, 14, 8);
    layout->setSpacing(10);
    for (QToolButton *button : {m_first, m_play, m_last})
        layout->addWidget(button);
    layout->addLayout(words);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_rate);

    connect(m_slider, &TimeSlider::rangeDragged, this, &TimelineBar::rangeDragged);
    connect(&m_timeline, &Timeline::currentChanged, this, &TimelineBar::showCurrent);
    connect(&m_timeline, &Timeline::rangeChanged, this, &TimelineBar::showCurrent);
    connect(&m_timeline, &Timeline::playingChanged, this, &TimelineBar::showPlaying);
    connect(&m_timeline, &Timeline::rateChanged, this, &TimelineBar::showRate);
    applyColours();
    showCurrent();
    showPlaying();
    showRate();
}

void TimelineBar::makeButtons()
{
    const auto join = [this](QToolButton *button, Timeline::Command command, const QString &name) {
        button->setAccessibleName(name);
        button->setToolTip(name);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setIconSize(QSize(16, 16));
        button->setFixedSize(button == m_play ? QSize(42, 34) : QSize(34, 34));
        QAction *action = m_timeline.action(command);
        connect(button, &QToolButton::clicked, action, &QAction::trigger);
        button->setEnabled(action->isEnabled());
        connect(action, &QAction::enabledChanged, button, &QWidget::setEnabled);
    };
    join(m_first, Timeline::Command::First, tr("To the first frame (Home)"));
    join(m_play, Timeline::Command::PlayPause, tr("Play (Space)"));
    join(m_last, Timeline::Command::Last, tr("To the last frame (End)"));
}

void TimelineBar::setScene(TrialScenePtr scene)
{
    m_slider->setScene(std::move(scene));
}

void TimelineBar::setRangeActions(const QList<QAction *> &actions)
{
    m_slider->addActions(actions);
    m_slider->setContextMenuPolicy(Qt::ActionsContextMenu);
}

void TimelineBar::showCurrent()
{
    const qint64 count = m_timeline.frameCount();
    m_time->setText(timeCode(m_timeline.currentTime()));
    m_frame->setText(count == 0 ? tr("no frames")
                                : tr("frame %1 of %2").arg(m_timeline.currentFrame() + 1).arg(count));
    // Wide enough for the last frame, so that the slider does not move while playing.
    const QString widest = tr("frame %1 of %2").arg(count).arg(count);
    m_frame->setMinimumWidth(m_frame->fontMetrics().horizontalAdvance(widest) + 4);
}

void TimelineBar::showPlaying()
{
    const QString name = m_timeline.isPlaying() ? tr("Pause (Space)") : tr("Play (Space)");
    m_play->setAccessibleName(name);
    m_play->setToolTip(name);
    m_play->setIcon(transportIcon(m_timeline.isPlaying() ? TransportSign::Pause : TransportSign::Play,
                                  palette().color(QPalette::HighlightedText)));
}

void TimelineBar::showRate()
{
    const double rate = m_timeline.rate();
    const QSignalBlocker blocked(m_rate);
    int index = m_rate->findData(rate);
    // A rate that is not on offer (a shuttle backwards) is one more entry while it lasts.
    while (m_rate->count() > static_cast<int>(std::size(offeredRates)))
        m_rate->removeItem(m_rate->count() - 1);
    index = m_rate->findData(rate);
    if (index < 0) {
        m_rate->addItem(rateText(rate), rate);
        index = m_rate->count() - 1;
    }
    m_rate->setCurrentIndex(index);
}

void TimelineBar::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours colours = ThemeColours::of(palette());
    painter.setPen(QPen(colours.border, 1));
    painter.setBrush(colours.card);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
}

void TimelineBar::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange)
        applyColours();
    QFrame::changeEvent(event);
}

void TimelineBar::applyColours()
{
    const ThemeColours colours = ThemeColours::of(palette());
    QPalette muted;
    muted.setColor(QPalette::WindowText, colours.muted);
    m_frame->setPalette(muted);
    const QString plain =
        QStringLiteral("QToolButton { background: %1; border: 1px solid %2; border-radius: 5px; }"
                       "QToolButton:hover { border-color: %3; }"
                       "QToolButton:focus { border: 2px solid %3; }")
            .arg(colours.card.name(), colours.border.name(), colours.accent.name());
    m_first->setStyleSheet(plain);
    m_last->setStyleSheet(plain);
    m_play->setStyleSheet(
        QStringLiteral("QToolButton { background: %1; border: 1px solid %1; border-radius: 5px; }"
                       "QToolButton:hover { background: %2; }"
                       "QToolButton:focus { border: 2px solid %3; }"
                       "QToolButton:disabled { background: %4; border-color: %4; }")
            .arg(colours.accent.name(), colours.accent.lighter(112).name(), colours.text.name(),
                 colours.border.name()));
    m_first->setIcon(transportIcon(TransportSign::First, colours.text));
    m_last->setIcon(transportIcon(TransportSign::Last, colours.text));
    showPlaying();
}

} // namespace odo
