// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/help/lesson.h"

namespace odo {

void Lesson::start(std::vector<LessonStep> steps)
{
    m_steps = std::move(steps);
    if (!m_steps.empty())
        begin(0);
    Q_EMIT changed();
}

void Lesson::stop()
{
    m_isDone = {};
    m_steps.clear();
    m_place = 0;
    Q_EMIT changed();
}

void Lesson::begin(std::size_t place)
{
    m_place = place;
    const auto &start = m_steps[place].begin;
    m_isDone = start ? start() : LessonStep::IsDone();
    m_done = !m_isDone;
}

void Lesson::next()
{
    if (m_place + 1 >= m_steps.size()) {
        stop();
        return;
    }
    begin(m_place + 1);
    Q_EMIT changed();
}

void Lesson::look()
{
    if (!isRunning() || m_done || !m_isDone())
        return;
    m_done = true;
    Q_EMIT changed();
}

} // namespace odo
