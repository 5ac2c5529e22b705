// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

namespace odo {

/// One thing to do.
struct LessonStep
{
    /// Whether it was done since the step began.
    using IsDone = std::function<bool()>;

    QString title, words;
    std::function<IsDone()> begin; ///< remembers how things are now; empty: there is nothing to do but read
};

/// A guided tour: steps in their order, each of which tells by itself when it was done. GUI thread.
class Lesson : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    void start(std::vector<LessonStep> steps);
    void stop();
    bool isRunning() const { return !m_steps.empty(); }
    std::size_t count() const { return m_steps.size(); }
    std::size_t place() const { return m_place; } ///< of the present step, from 0
    const LessonStep &step() const { return m_steps[m_place]; }
    bool isDone() const { return m_done; } ///< the present step
    /// To the step after; after the last one it ends.
    void next();
    /// Something happened: was it what the step asks for?
    void look();

Q_SIGNALS:
    void changed(); ///< another step, its being done, or the end

private:
    void begin(std::size_t place);

    std::vector<LessonStep> m_steps;
    std::size_t m_place = 0;
    LessonStep::IsDone m_isDone;
    bool m_done = false;
};

} // namespace odo
