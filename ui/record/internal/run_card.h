// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/workflow/record/line_up.h"
#include "core/workflow/record/run_control.h"
#include "ui/views/widgets/card.h"

class QAction;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace odo {

class CheckList;
class NumberBox;
class TriggerBox;

/// Who is up: class, team, task, robots, the trial's name; and how the recording begins and ends. All of it
/// can be changed by hand.
class RunCard : public Card
{
    Q_OBJECT
public:
    explicit RunCard(QWidget *parent = nullptr);

    /// What there is to choose from; what is chosen stays, as far as it is still there.
    void setLineUp(const LineUp &lineUp);
    void setRun(const NextRun &run);
    NextRun run() const;
    RunSettings settings() const;
    const LineUp &lineUp() const { return m_lineUp; }
    /// The chosen task, if any.
    std::optional<Task> task() const;
    std::vector<RobotRecord> robots() const;

Q_SIGNALS:
    void changed();       ///< team, task or how to begin and end
    void beforeChanged(); ///< so much before the start is to be recorded too
    void robotsChanged(); ///< other robots are to be followed

private:
    void fillTeams();
    void chooseTeam();
    void addTriggers();
    void showStarts();

    LineUp m_lineUp;
    QFormLayout *m_form;
    QComboBox *m_class, *m_team, *m_task;
    TriggerBox *m_start, *m_stop;
    CheckList *m_robots;
    QLineEdit *m_trial;
    QSpinBox *m_before, *m_laps;
    NumberBox *m_rest, *m_length; ///< seconds
    bool m_startedByGate = false;
};

/// The one big button, with what it will do, and how long it has been going on.
class StartCard : public Card
{
    Q_OBJECT
public:
    explicit StartCard(QWidget *parent = nullptr);

    struct State
    {
        RunPhase phase = RunPhase::Ready;
        bool ending = false; ///< the last frames are being written
        Nanoseconds countdownLeft{0}, elapsed{0};
        QString remainingTime;                           ///< remaining recording time
        QString blocked;                                 ///< why nothing can be recorded now; empty: it can
        QString gate;                                    ///< waiting for this one
        std::optional<RunTrigger> start = {}, stop = {}; ///< by itself
        int beforeS = 0;                                 ///< so much before the start is recorded too
    };
    void setState(const State &state);

    QPushButton *button() const { return m_button; }
    /// F9, for a menu too.
    QAction *action() const { return m_action; }
    QString words() const;

Q_SIGNALS:
    void pressed();

private:
    static QString keyWords(const State &state);

    QAction *m_action;
    QPushButton *m_button;
    QLabel *m_clock, *m_words;
};

} // namespace odo
