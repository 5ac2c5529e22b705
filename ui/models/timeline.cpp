// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/timeline.h"

#include "core/base/steady_now.h"

#include <QAction>
#include <algorithm>
#include <cmath>

namespace odo {

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
        QKeySequence key;
        std::function<void()> work;
    };
    const auto second = std::chrono::seconds(1);
    const std::vector<Entry> entries = {
        {Command::PlayPause, "playPause", Qt::Key_Space, [this] { toggle(); }},
        {Command::PreviousFrame, "previousFrame", Qt::Key_Left, [this] { step(-1); }},
        {Command::NextFrame, "nextFrame", Qt::Key_Right, [this] { step(1); }},
        {Command::BackOneSecond, "backOneSecond", Qt::SHIFT | Qt::Key_Left,
         [this, second] { skip(-second); }},
        {Command::ForwardOneSecond, "forwardOneSecond", Qt::SHIFT | Qt::Key_Right,
         [this, second] { skip(second); }},
        {Command::ShuttleBack, "shuttleBack", Qt::Key_J, [this] { shuttle(-1); }},
        {Command::ShuttleStop, "shuttleStop", Qt::Key_K,
         [this] {
             pause();
             setRate(1);
         }},
        {Command::ShuttleForward, "shuttleForward", Qt::Key_L, [this] { shuttle(1); }},
        {Command::First, "firstFrame", Qt::Key_Home,
         [this] {
             pause();
             setCurrentFrame(0);
         }},
        {Command::Last, "lastFrame", Qt::Key_End,
         [this] {
             pause();
             setCurrentFrame(frameCount() - 1);
         }},
        {Command::Loop, "loop", Qt::CTRL | Qt::Key_L, [] {}},
    };
    for (const Entry &entry : entries) {
        auto *action = new QAction(this);
        action->setObjectName(QString::fromLatin1(entry.name));
        action->setShortcut(entry.key);
        connect(action, &QAction::triggered, this, [work = entry.work] { work(); });
        m_actions.append(action);
    }
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
}

void Timeline::setFrameTimes(std::vector<Nanoseconds> times)
{
    pause();
    m_times = std::move(times);
    m_frame = 0;
    updateActions();
    Q_EMIT rangeChanged();
    Q_EMIT currentChanged();
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

Nanoseconds Timeline::lastFrameEnd() const
{
    const std::size_t count = m_times.size();
    return count < 2 ? endTime() : m_times[count - 1] + (m_times[count - 1] - m_times[count - 2]);
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
    qint64 frame = frameNotAfter(time);
    const auto next = static_cast<std::size_t>(frame) + 1;
    if (next < m_times.size() && m_times[next] - time < time - m_times[next - 1])
        ++frame;
    setCurrentFrame(frame);
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
    Q_EMIT loopingChanged(looping);
}

void Timeline::shuttle(double direction)
{
    const bool sameWay = m_playing && m_rate * direction > 0;
    setRate(sameWay ? m_rate * 2 : direction);
    play();
}

void Timeline::tick()
{
    if (!m_playing)
        return;
    const Nanoseconds now = m_clock();
    m_position += scaled(now - m_lastTick, m_rate);
    m_lastTick = now;
    const Nanoseconds start = startTime(), end = lastFrameEnd();
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
