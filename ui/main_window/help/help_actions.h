// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QObject>
#include <QString>
#include <functional>
#include <vector>

class QAction;
class QLabel;
class QMenu;
class QPushButton;
class QTextBrowser;
class QWidget;

namespace odo {

class CommandKeys;
class HelpPanel;
class Lesson;
class ProjectPages;

/// The ways to help: the panel beside the page, the keys, the first lesson. Owns the
/// actions and the lesson.
class HelpActions : public QObject
{
    Q_OBJECT
public:
    HelpActions(const CommandKeys &keys, HelpPanel &panel, QWidget &window);

    void fillMenu(QMenu &menu);
    /// The pages of the project that is open; nullptr: none, which ends a lesson.
    void setPages(const ProjectPages *pages);
    Lesson &lesson() const { return *m_lesson; }
    void beginLesson();

Q_SIGNALS:
    /// The user asked for a lesson, but no project is open: it starts when the demo project is.
    void demoWanted();

private:
    void showPage();

    const CommandKeys &m_keys;
    HelpPanel &m_panel;
    QWidget &m_window;
    Lesson *m_lesson;
    const ProjectPages *m_pages = nullptr;
    QAction *m_help, *m_learn, *m_showKeys, *m_about;
};

/// Help beside a page: what it shows and what to do there.
class HelpPanel : public QFrame
{
    Q_OBJECT
public:
    explicit HelpPanel(QWidget *parent = nullptr);

    /// The name of a text in the resources: "welcome", or that of a mode. Loaded when first shown.
    void showPage(const QString &name);

Q_SIGNALS:
    void closed(); ///< by a person

protected:
    void showEvent(QShowEvent *event) override;

private:
    void layOut();

    QString m_wanted; ///< not loaded yet; empty: nothing
    QTextBrowser *m_text;
};

/// One thing to do.
struct LessonStep
{
    /// Whether it was done since the step began.
    using IsDone = std::function<bool()>;

    QString title, words;
    std::function<IsDone()> begin; ///< remembers how things are now; empty: there is nothing to do but read
};

/// A guided tour: steps in order, each of which notices when it is done. GUI thread.
class Lesson : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    void start(std::vector<LessonStep> steps);
    void stop();
    bool isRunning() const { return !m_steps.empty(); }
    std::size_t count() const { return m_steps.size(); }
    std::size_t position() const { return m_position; } ///< of the present step, from 0
    const LessonStep &step() const { return m_steps[m_position]; }
    bool isDone() const { return m_done; } ///< the present step
    /// To the step after; after the last one it ends.
    void next();
    /// Something happened: was it what the step asks for?
    void poll();

Q_SIGNALS:
    void changed(); ///< another step, its being done, or the end

private:
    void begin(std::size_t position);

    std::vector<LessonStep> m_steps;
    std::size_t m_position = 0;
    LessonStep::IsDone m_isDone;
    bool m_done = false;
};

/// Five minutes on the demo project, from playing a run to finding it again. The pages must outlive the
/// lesson.
std::vector<LessonStep> firstLesson(const ProjectPages &pages);

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
    QLabel *m_position, *m_tick, *m_title, *m_words;
    QPushButton *m_next, *m_leave;
};

} // namespace odo
