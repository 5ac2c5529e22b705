// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QObject>
#include <QString>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

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

class ProjectPages;

/// Five minutes on the demo project, from playing a run to finding it again. The pages must outlive the
/// lesson.
std::vector<LessonStep> firstLesson(const ProjectPages &pages);

class Lesson;

/// The present step of a lesson, below the page; hidden while none runs.
class LessonBar : public QFrame
{
    Q_OBJECT
public:
    /// lesson must outlive it.
    explicit LessonBar(Lesson &lesson, QWidget *parent = nullptr);

private:
    void follow();

    Lesson &m_lesson;
    QLabel *m_place, *m_tick, *m_title, *m_words;
    QPushButton *m_next, *m_leave;
};

} // namespace odo
