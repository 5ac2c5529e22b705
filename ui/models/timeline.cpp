// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/timeline.h"

#include "core/base/steady_now.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QObject>
#include <algorithm>
#include <cmath>
#include <utility>

class QAction;

namespace odo {

/// Whether the key of a command is being held down, so that other keys can mean something else meanwhile. The
/// command itself runs as ever when the key goes down. GUI thread; needs the application.
class HeldKey : public QObject
{
    Q_OBJECT
public:
    /// action: whose key it is, whatever key it has; must outlive this.
    explicit HeldKey(const QAction &action, QObject *parent = nullptr);
    bool isHeld() const { return m_isHeld; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool isItsKey(int key) const;

    const QAction &m_action;
    bool m_isHeld = false;
};

HeldKey::HeldKey(const QAction &action, QObject *parent) : QObject(parent), m_action(action)
{
    if (QCoreApplication *application = QCoreApplication::instance())
        application->installEventFilter(this); // a shortcut's key goes to no widget
}

bool HeldKey::isItsKey(int key) const
{
    return std::ranges::any_of(m_action.shortcuts(), [key](const QKeySequence &keys) {
        return keys.count() == 1 && keys[0].key() == key;
    });
}

bool HeldKey::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: // comes before the shortcut runs
    case QEvent::KeyPress:
        m_isHeld |= isItsKey(static_cast<QKeyEvent *>(event)->key());
        break;
    case QEvent::KeyRelease:
        // A key that is held repeats as releases and presses.
        if (const auto *key = static_cast<QKeyEvent *>(event); !key->isAutoRepeat() && isItsKey(key->key()))
            m_isHeld = false;
        break;
    case QEvent::ApplicationStateChange:
    case QEvent::WindowDeactivate: // its release would go elsewhere
        m_isHeld = false;
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

namespace {

Nanoseconds scaled(Nanoseconds time, double factor)
{
    return Nanoseconds(std::llround(static_cast<double>(time.count()) * factor));
}

} // namespace

Timeline::Timeline(QObject *parent) : Timeline(&steadyNow, parent) {}

Timeline::Timeline(Clock clock, QObject *parent) : QObject(parent), m_clock(std::move(clock))
{
    // Twice the rate of an ordinary screen's refresh is not needed; a frame more or less late is not seen.
    constexpr int tickMs = 15;
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(tickMs);
    connect(&m_timer, &QTimer::timeout, this, &Timeline::tick);
    makeActions();
    updateActions();
}

Timeline::~Timeline() = default;

void Timeline::makeActions()
{
    struct Entry
    {
        Command command;
        const char *name;
        QString text;
        QKeySequence key;
        std::function<void()> work;
    };
    const auto second = std::chrono::seconds(1);
    const std::vector<Entry> entries = {
        {Command::PlayPause, "playPause", tr("&Play or pause"), Qt::Key_Space, [this] { toggle(); }},
        {Command::PreviousFrame, "previousFrame", tr("One frame &back"), Qt::Key_Left, [this] { step(-1); }},
        {Command::NextFrame, "nextFrame", tr("One frame &forward"), Qt::Key_Right, [this] { step(1); }},
        {Command::BackOneSecond, "backOneSecond", tr("One second back"), Qt::SHIFT | Qt::Key_Left,
         [this, second] { skip(-second); }},
        {Command::ForwardOneSecond, "forwardOneSecond", tr("One second forward"), Qt::SHIFT | Qt::Key_Right,
         [this, second] { skip(second); }},
        {Command::ShuttleBack, "shuttleBack", tr("Play backwards, again: faster"), Qt::Key_J,
         [this] { stepOrShuttle(-1); }},
        {Command::ShuttleStop, "shuttleStop", tr("&Stop; while held, the keys beside it step one frame"),
         Qt::Key_K,
         [this] {
             pause();
             setRate(1);
         }},
        {Command::ShuttleForward, "shuttleForward", tr("Play forwards, again: faster"), Qt::Key_L,
         [this] { stepOrShuttle(1); }},
        {Command::First, "firstFrame", tr("To the first frame"), Qt::Key_Home,
         [this] {
             pause();
             setCurrentFrame(0);
         }},
        {Command::Last, "lastFrame", tr("To the last frame"), Qt::Key_End,
         [this] {
             pause();
             setCurrentFrame(frameCount() - 1);
         }},
        {Command::Loop, "loop", tr("&Loop"), Qt::CTRL | Qt::Key_L, [] {}},
        {Command::SelectionBegin, "rangeBegin", tr("Selection beg&ins here"), Qt::SHIFT | Qt::Key_I,
         [this] { beginSelection(); }},
        {Command::SelectionEnd, "rangeEnd", tr("Selection &ends here"), Qt::SHIFT | Qt::Key_O,
         [this] { endSelection(); }},
        {Command::ClearSelection, "clearRange", tr("&Clear the selection"), Qt::Key_Escape,
         [this] { setSelection(std::nullopt); }},
    };
    for (const Entry &entry : entries) {
        auto *action = new QAction(entry.text, this);
        action->setObjectName(QString::fromLatin1(entry.name));
        action->setShortcut(entry.key);
        connect(action, &QAction::triggered, this, [work = entry.work] { work(); });
        m_actions.append(action);
    }
    m_stopKey = new HeldKey(*action(Command::ShuttleStop), this);
    action(Command::Loop)->setCheckable(true);
    connect(action(Command::Loop), &QAction::toggled, this, &Timeline::setLooping);
}

QAction *Timeline::action(Command command) const
{
    return m_actions.at(static_cast<qsizetype>(command));
}

void Timeline::updateActions()
{
    for (QAction *each : std::as_const(m_actions))
        each->setEnabled(!m_times.empty());
    // So that Esc is free for others while there is no range.
    action(Command::ClearSelection)->setEnabled(m_selection.has_value());
}

void Timeline::setFrameTimes(std::vector<Nanoseconds> times)
{
    pause();
    m_times = std::move(times);
    m_frame = 0;
    const bool hadSelection = std::exchange(m_selection, std::nullopt).has_value();
    updateActions();
    Q_EMIT rangeChanged();
    Q_EMIT currentChanged();
    if (hadSelection)
        Q_EMIT selectionChanged();
}

Nanoseconds Timeline::startTime() const
{
    return m_times.empty() ? Nanoseconds(0) : m_times.front();
}
Nanoseconds Timeline::endTime() const
{
    return m_times.empty() ? Nanoseconds(0) : m_times.back();
}

Nanoseconds Timeline::currentTime() const
{
    return m_times.empty() ? Nanoseconds(0) : m_times[static_cast<std::size_t>(m_frame)];
}

qint64 Timeline::frameNotAfter(Nanoseconds time) const
{
    const auto after = std::upper_bound(m_times.begin(), m_times.end(), time);
    return std::max<qint64>(0, (after - m_times.begin()) - 1);
}

Nanoseconds Timeline::frameEnd(qint64 frame) const
{
    const auto i = static_cast<std::size_t>(frame), count = m_times.size();
    if (count < 2)
        return endTime();
    return i + 1 < count ? m_times[i + 1] : m_times[i] + (m_times[i] - m_times[i - 1]);
}

/// What is played over and over: the last frame has its time as well.
TimeSpan Timeline::playedSpan() const
{
    if (m_looping && m_selection)
        return {m_selection->begin, frameEnd(frameNotAfter(m_selection->end))};
    return {startTime(), frameEnd(frameCount() - 1)};
}

Nanoseconds Timeline::frameTimeNear(Nanoseconds time) const
{
    const auto frame = static_cast<std::size_t>(frameNotAfter(time));
    const bool nextIsNearer = frame + 1 < m_times.size() && m_times[frame + 1] - time < time - m_times[frame];
    return m_times[nextIsNearer ? frame + 1 : frame];
}

void Timeline::setSelection(std::optional<TimeSpan> selection)
{
    if (selection && !m_times.empty()) {
        const auto [begin, end] = std::minmax(selection->begin, selection->end);
        selection = TimeSpan{frameTimeNear(begin), frameTimeNear(end)};
        if (selection->begin == selection->end)
            selection.reset();
    }
    if (m_times.empty())
        selection.reset();
    if (selection == m_selection)
        return;
    m_selection = selection;
    updateActions();
    Q_EMIT selectionChanged();
}

void Timeline::beginSelection()
{
    const Nanoseconds now = currentTime();
    setSelection(TimeSpan{now, m_selection && m_selection->end > now ? m_selection->end : endTime()});
}

void Timeline::endSelection()
{
    const Nanoseconds now = currentTime();
    setSelection(TimeSpan{m_selection && m_selection->begin < now ? m_selection->begin : startTime(), now});
}

void Timeline::showFrame(qint64 frame)
{
    if (frame == m_frame)
        return;
    m_frame = frame;
    Q_EMIT currentChanged();
}

void Timeline::setCurrentFrame(qint64 frame)
{
    if (m_times.empty())
        return;
    frame = std::clamp<qint64>(frame, 0, frameCount() - 1);
    m_position = m_times[static_cast<std::size_t>(frame)];
    showFrame(frame);
}

void Timeline::setCurrentTime(Nanoseconds time)
{
    if (m_times.empty())
        return;
    setCurrentFrame(frameNotAfter(frameTimeNear(time)));
}

void Timeline::step(qint64 frames)
{
    pause();
    setCurrentFrame(m_frame + frames);
}

void Timeline::skip(Nanoseconds duration)
{
    pause();
    const qint64 before = m_frame;
    setCurrentTime(currentTime() + duration);
    if (m_frame == before)
        setCurrentFrame(before + (duration < Nanoseconds(0) ? -1 : 1));
}

void Timeline::play()
{
    if (m_playing || m_times.empty())
        return;
    if (m_rate > 0 && m_frame == frameCount() - 1)
        setCurrentFrame(0);
    else if (m_rate < 0 && m_frame == 0)
        setCurrentFrame(frameCount() - 1);
    m_position = currentTime();
    m_lastTick = m_clock();
    m_playing = true;
    m_timer.start();
    Q_EMIT playingChanged(true);
}

void Timeline::pause()
{
    if (!m_playing)
        return;
    m_timer.stop();
    m_playing = false;
    Q_EMIT playingChanged(false);
}

void Timeline::toggle()
{
    if (m_playing)
        pause();
    else
        play();
}

void Timeline::setRate(double rate)
{
    if (!std::isfinite(rate) || rate == 0)
        return;
    rate = std::copysign(std::clamp(std::abs(rate), slowestRate, fastestRate), rate);
    if (rate == m_rate)
        return;
    if (m_playing)
        tick(); // what has passed so far passed at the old rate
    m_rate = rate;
    Q_EMIT rateChanged(rate);
}

void Timeline::setLooping(bool looping)
{
    if (looping == m_looping)
        return;
    m_looping = looping;
    action(Command::Loop)->setChecked(looping);
}

void Timeline::shuttle(double direction)
{
    const bool sameWay = m_playing && m_rate * direction > 0;
    setRate(sameWay ? m_rate * 2 : direction);
    play();
}

/// As on an editing desk: with a finger on Stop the shuttle keys go frame by frame.
void Timeline::stepOrShuttle(int direction)
{
    if (m_stopKey->isHeld())
        step(direction);
    else
        shuttle(direction);
}

void Timeline::tick()
{
    if (!m_playing)
        return;
    const Nanoseconds now = m_clock();
    m_position += scaled(now - m_lastTick, m_rate);
    m_lastTick = now;
    const auto [start, end] = playedSpan();
    const bool passedEnd = m_rate > 0 ? m_position >= end : m_position < start;
    if (!passedEnd) {
        showFrame(frameNotAfter(m_position));
        return;
    }
    if (m_looping && end > start) {
        const Nanoseconds length = end - start;
        Nanoseconds inside = (m_position - start) % length;
        if (inside < Nanoseconds(0))
            inside += length;
        m_position = start + inside;
        showFrame(frameNotAfter(m_position));
        return;
    }
    showFrame(m_rate > 0 ? frameCount() - 1 : 0);
    pause();
}

} // namespace odo

#include "timeline.moc"
