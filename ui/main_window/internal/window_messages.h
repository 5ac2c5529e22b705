// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/main_window/internal/done_work.h"
#include "ui/main_window/internal/message_bar.h"
#include "ui/main_window/internal/message_list.h"
#include "ui/main_window/internal/message_panel.h"
#include "ui/main_window/internal/remedies.h"

#include <QObject>
#include <QPointer>

class QAction;
class QToolButton;

namespace odo {

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
    /// A warning that is on the page already: only for the list.
    void keepWarning(const QString &text);
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
