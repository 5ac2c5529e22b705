// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/workflow/run_control.h"
#include "ui/views/card.h"

class QAction;
class QLabel;
class QPushButton;

namespace odo {

/// The one big button, with what it will do, and how long it has been going on.
class StartCard : public Card
{
    Q_OBJECT
public:
    explicit StartCard(QWidget *parent = nullptr);

    struct State
    {
        RunPhase phase = RunPhase::Ready;
        bool ending = false; ///< the last pictures are being written
        Nanoseconds countdownLeft{0}, elapsed{0};
        QString room;    ///< "room for 42 min"
        QString blocked; ///< why nothing can be recorded now; empty: it can
        QString gate;    ///< that is waited for
    };
    void setState(const State &state);

    QPushButton *button() const { return m_button; }
    /// F9, for a menu too.
    QAction *action() const { return m_action; }
    QString words() const;

Q_SIGNALS:
    void pressed();

private:
    QAction *m_action;
    QPushButton *m_button;
    QLabel *m_clock, *m_words;
};

} // namespace odo
