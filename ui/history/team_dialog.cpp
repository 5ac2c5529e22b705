// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/team_dialog.h"

#include "ui/models/shown_team.h"
#include "ui/views/check_list.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPlainTextEdit>
#include <QStringList>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

TeamDialog::TeamDialog(TeamRecord team, const std::vector<RobotRecord> &robots, QWidget *parent)
    : QDialog(parent), m_team(std::move(team)), m_robots(robots), m_members(new QPlainTextEdit),
      m_list(new CheckList(tr("Robots of the team")))
{
    setWindowTitle(tr("Team %1").arg(shownTeam(m_team)));
    QStringList members, names;
    for (const std::string &member : m_team.members)
        members << QString::fromStdString(member);
    m_members->setPlainText(members.join(u'\n'));
    m_members->setPlaceholderText(tr("A name on each line"));
    m_members->setAccessibleName(tr("Members of the team, one on each line"));
    m_members->setTabChangesFocus(true);
    for (const RobotRecord &robot : m_robots)
        names << QString::fromStdString(robot.name);
    m_list->setNames(names, false);
    for (int i = 0; i < m_list->count(); ++i)
        if (std::ranges::find(m_team.robots, m_robots[static_cast<std::size_t>(i)].id) != m_team.robots.end())
            m_list->item(i)->setCheckState(Qt::Checked);
    m_list->setToolTip(tr("Record and importing propose these robots for the team's runs"));
    auto *form = new QFormLayout;
    form->addRow(tr("&Members"), m_members);
    form->addRow(tr("&Robots"), m_list);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(form, 1);
    layout->addWidget(buttons);
    resize(420, 340);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

TeamRecord TeamDialog::team() const
{
    TeamRecord team = m_team;
    team.members.clear();
    for (const QString &line : m_members->toPlainText().split(u'\n'))
        if (const QString member = line.trimmed(); !member.isEmpty())
            team.members.push_back(member.toStdString());
    team.robots.clear();
    for (int i = 0; i < m_list->count(); ++i)
        if (m_list->item(i)->checkState() == Qt::Checked)
            team.robots.push_back(m_robots[static_cast<std::size_t>(i)].id);
    return team;
}

QString shownMembers(const TeamRecord &team)
{
    if (arePseudonymsShown())
        return team.members.empty() ? QString() : TeamDialog::tr("%n member(s)", "", static_cast<int>(team.members.size()));
    QStringList names;
    for (const std::string &member : team.members)
        names << QString::fromStdString(member);
    return names.join(QStringLiteral(", "));
}

} // namespace odo
