// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QFrame>
#include <functional>

class QLabel;
class QPushButton;
class QTimer;

namespace odo {

/// A line across the window that says what went wrong, or what was done, until it is closed, another one
/// comes, or (for what was done) some seconds have passed. Never in the way of work. Plain text only.
class MessageBar : public QFrame
{
    Q_OBJECT
public:
    explicit MessageBar(QWidget *parent = nullptr);
    /// What was cancelled is no error: it is told as what was done.
    void showError(const Error &error);
    void showDone(const QString &text);
    /// What somebody should know who was not asked; stays until it is closed.
    void showWarning(const QString &text);
    /// Puts a button behind what is shown, until it is pressed or another message comes.
    void offer(const QString &words, std::function<void()> act);
    QString text() const;

private:
    void present(const char *kind, const QString &icon, const QString &text);
    QLabel *m_icon;
    QLabel *m_text;
    QPushButton *m_button;
    std::function<void()> m_act;
    QTimer *m_timer;
};

} // namespace odo
