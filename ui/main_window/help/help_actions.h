// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QObject>

class QAction;
class QMenu;
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
    /// A lesson is wanted, and no project is open: it begins when the demo project is.
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

/// Stands beside a page and tells what is on it and what to do there.
class HelpPanel : public QFrame
{
    Q_OBJECT
public:
    explicit HelpPanel(QWidget *parent = nullptr);

    /// The name of a text in the resources: "welcome", or that of a mode.
    /// It is read and laid out once it is seen.
    void showPage(const QString &name);

Q_SIGNALS:
    void closed(); ///< by a person

protected:
    void showEvent(QShowEvent *event) override;

private:
    void layOut();

    QString m_wanted; ///< is not laid out yet; empty: nothing
    QTextBrowser *m_text;
};

} // namespace odo
