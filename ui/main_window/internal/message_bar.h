// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/internal/message_list.h"

#include <QFrame>
#include <QList>
#include <QString>

class QLabel;
class QPushButton;
class QTimer;
class QToolButton;

namespace odo {

/// Of messages, in logical pixels.
constexpr int messageIconSide = 20;
QString messageIcon(WindowMessage::Kind kind);
/// A small cross in the corner.
QToolButton *messageCloseButton(const QString &accessibleName, const QString &toolTip);
/// As much of a text as is shown at most.
QString shownOfMessage(const QString &text);

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

} // namespace odo
