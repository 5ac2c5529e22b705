// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"

#include <QDialog>
#include <vector>

class QPlainTextEdit;

namespace odo {

class CheckList;

/// The people of a team, a line each, and the robots that belong to it. Stores nothing: that is up to whoever opened it.
class TeamDialog : public QDialog
{
    Q_OBJECT
public:
    TeamDialog(TeamRecord team, const std::vector<RobotRecord> &robots, QWidget *parent = nullptr);
    /// The team with what was written.
    TeamRecord team() const;

private:
    const TeamRecord m_team;
    const std::vector<RobotRecord> m_robots;
    QPlainTextEdit *m_members;
    CheckList *m_list;
};

/// "Anna, Ben", or, where teams are shown by pseudonym, how many they are.
QString shownMembers(const TeamRecord &team);

} // namespace odo
