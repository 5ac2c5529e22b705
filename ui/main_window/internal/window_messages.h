// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/main_window/internal/done_work.h"
#include "ui/main_window/internal/message_list.h"
#include "ui/main_window/internal/remedies.h"

#include <QFrame>
#include <QList>
#include <QObject>
#include <QPointer>

class QAction;
class QLabel;
class QPushButton;
class QTimer;
class QToolButton;
class QVBoxLayout;

namespace odo {

/// A note over the foot of the page that says what went wrong, or what was done, until it is closed, another
/// one comes, or some seconds have passed (not while it has the mouse or the focus). It moves nothing. Plain
/// text only.
class MessageBar : public QFrame
{
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);
    void present(const WindowMessage &message);
    /// In full, though a long one is shortened on screen; empty while hidden.
    QString text() const;

Q_SIGNALS:
    void acted(qsizetype action); ///< its button was pressed
    void closed();                ///< by a person

private:
    void leave();

    QString m_fullText;
    QLabel *m_icon, *m_text;
    QList<QPushButton *> m_buttons;
    QTimer *m_timer;
};

/// All warnings and errors that were not dismissed, over the page, each with its buttons. Esc closes it.
class MessagePanel : public QFrame
{
    Q_OBJECT
public:
    explicit MessagePanel(MessageList &list, QWidget *parent = nullptr);
    /// With all of its rows, in that width.
    int heightFor(int width) const;

Q_SIGNALS:
    void closed();
    void rowsChanged();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void fill();
    QWidget *makeRow(const WindowMessage &message);

    MessageList &m_list;
    QLabel *m_none;
    QPushButton *m_dismissAll;
    QToolButton *m_close;
    QWidget *m_rows;
    QVBoxLayout *m_rowLayout;
};

/// The messages of a window: each is shown for a while, and warnings and errors are kept in a list behind a
/// bell until they are dismissed. GUI thread.
class WindowMessages : public QObject
{
    Q_OBJECT
public:
    /// page: over whose foot they are shown; it has a parent.
    explicit WindowMessages(QWidget &page, QObject *parent = nullptr);

    /// With what can be done about it. A cancelled job is no error: it is shown as done.
    void showError(const Error &error);
    /// A warning if it has some, with what can be done about them; else it is not kept.
    void showDone(const DoneWork &work);
    /// What somebody should know who was not asked.
    void showWarning(const QString &text);
    /// One more button for the message that was shown last.
    void offer(MessageAction action);
    /// What was offered for the project that is closed goes.
    void endProject();
    void hideBar();

    /// Shows and hides the list.
    QAction *action() const { return m_action; }
    /// How many there are; opens the list. For the foot of the window.
    QToolButton *bell() const { return m_bell; }

Q_SIGNALS:
    /// The window is to begin it; trial: that the message names, or empty.
    void remedyWanted(odo::Remedy remedy, const QString &trial);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void show(WindowMessage message);
    void follow();
    void place();
    void showPanel(bool shown);
    void addRemedies(WindowMessage &message, const Message &words);

    QWidget &m_page;
    MessageList m_list;
    MessageBar *m_bar;
    MessagePanel *m_panel;
    QToolButton *m_bell;
    QAction *m_action;
    WindowMessage m_shown; ///< last; its id is 0 where it is not kept
    QPointer<QWidget> m_focusBefore;
};

} // namespace odo
