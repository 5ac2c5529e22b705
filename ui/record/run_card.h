// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/line_up.h"
#include "core/workflow/run_control.h"
#include "ui/views/card.h"

class QComboBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace odo {

class CheckList;

/// Who is up: class, team, task, robots, the trial's name; and how the recording begins. All of it can be
/// changed by hand.
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
    void changed();       ///< team, task or how to begin
    void robotsChanged(); ///< other robots are to be followed

private:
    void fillTeams();
    void chooseTeam();
    void showStarts();

    LineUp m_lineUp;
    QFormLayout *m_form;
    QComboBox *m_class, *m_team, *m_task, *m_start;
    CheckList *m_robots;
    QLineEdit *m_trial;
    QSpinBox *m_laps;
};

} // namespace odo
