// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/classes_dialog.h"

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/table_list.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStringList>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

enum Column { NameColumn, PseudonymColumn, MembersColumn, RobotsColumn, ColumnCount };
constexpr int classesWidth = 300;

QHBoxLayout *rowOf(const QList<QPushButton *> &buttons)
{
    auto *row = new QHBoxLayout;
    for (QPushButton *button : buttons)
        row->addWidget(button);
    row->addStretch(1);
    return row;
}

} // namespace

ClassesDialog::ClassesDialog(Project &project, bool readOnly, QWidget *parent)
    : QDialog(parent), m_project(project), m_changes(project), m_readOnly(readOnly),
      m_classList(new QListWidget), m_teamTable(new QTableWidget(0, ColumnCount)),
      m_moveMenu(new QMenu(this)), m_newClass(plainButton(tr("&New class…"))),
      m_rename(plainButton(tr("&Rename…"))), m_archive(plainButton(tr("&Archive"))),
      m_removeClass(plainButton(tr("Dele&te"))), m_newTeam(plainButton(tr("New t&eam…"))),
      m_move(plainButton(tr("&Move to"))), m_editTeam(plainButton(tr("Members and r&obots…"))),
      m_removeTeam(plainButton(tr("&Delete"))), m_roster(plainButton(tr("&Import roster…"))),
      m_message(new QLabel)
{
    setWindowTitle(tr("Classes and teams"));
    auto *row = new QHBoxLayout;
    row->addWidget(makeClasses());
    row->addWidget(makeTeams(), 1);
    m_message->setTextFormat(Qt::PlainText);
    m_message->setWordWrap(true);
    m_message->setAccessibleName(tr("What was done"));
    auto *close = plainButton(tr("Close"));
    close->setDefault(true);
    auto *bottom = new QHBoxLayout;
    bottom->addWidget(m_message, 1);
    bottom->addWidget(close);
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(row, 1);
    layout->addLayout(bottom);
    resize(1040, 520);
    connect(close, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_roster, &QPushButton::clicked, this, [this] {
        accept();
        Q_EMIT rosterRequested();
    });
    addUndoKeys(*this, m_changes, [this](const Result<QString> &outcome) { showOutcome(outcome); });
    refresh();
}

QWidget *ClassesDialog::makeClasses()
{
    m_classList->setAccessibleName(tr("Classes"));
    auto *box = new QWidget;
    box->setFixedWidth(classesWidth);
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_classList, 1);
    layout->addLayout(rowOf({m_newClass, m_rename}));
    layout->addLayout(rowOf({m_archive, m_removeClass}));
    connect(m_classList, &QListWidget::currentRowChanged, this, [this] {
        if (!m_isShowing)
            showTeams();
    });
    connect(m_newClass, &QPushButton::clicked, this, &ClassesDialog::addClass);
    connect(m_rename, &QPushButton::clicked, this, &ClassesDialog::renameClass);
    connect(m_archive, &QPushButton::clicked, this, &ClassesDialog::archiveClass);
    connect(m_removeClass, &QPushButton::clicked, this, &ClassesDialog::removeClass);
    m_archive->setToolTip(tr("Archiving hides a class: History, Record and the standings show its teams and "
                             "trials only if you choose the class by name"));
    return box;
}

QWidget *ClassesDialog::makeTeams()
{
    m_teamTable->setHorizontalHeaderLabels({tr("Team"), tr("Pseudonym"), tr("Members"), tr("Robots")});
    m_teamTable->setAccessibleName(tr("Teams of the class"));
    showAsList(*m_teamTable);
    m_teamTable->setSelectionMode(QAbstractItemView::SingleSelection);
    m_teamTable->setEditTriggers(m_readOnly
                                     ? QAbstractItemView::NoEditTriggers
                                     : QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_teamTable->setToolTip(tr("Double-click or press F2 to change a name or a pseudonym"));
    m_teamTable->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_move->setMenu(m_moveMenu);
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_teamTable, 1);
    layout->addLayout(rowOf({m_newTeam, m_editTeam, m_move, m_removeTeam, m_roster}));
    connect(m_teamTable, &QTableWidget::cellChanged, this, &ClassesDialog::readCell);
    connect(m_teamTable, &QTableWidget::currentCellChanged, this, &ClassesDialog::showButtons);
    connect(m_newTeam, &QPushButton::clicked, this, &ClassesDialog::addTeam);
    connect(m_editTeam, &QPushButton::clicked, this, &ClassesDialog::editTeam);
    connect(m_teamTable, &QTableWidget::cellDoubleClicked, this, [this](int, int column) {
        if (column == MembersColumn || column == RobotsColumn)
            editTeam();
    });
    connect(m_removeTeam, &QPushButton::clicked, this, &ClassesDialog::removeTeam);
    return box;
}

void ClassesDialog::refresh()
{
    auto classes = m_project.classes().all();
    auto teams = m_project.teams().all();
    auto robots = m_project.robots().all();
    if (!classes || !teams || !robots) {
        const Error &error = !classes ? classes.error() : !teams ? teams.error() : robots.error();
        m_message->setText(errorLine(error));
        return;
    }
    m_robots = std::move(*robots);
    const ClassRecord *chosen = currentClass();
    const QString before = !m_wanted.isNull() ? m_wanted
                           : chosen           ? QString::fromStdString(chosen->name)
                                              : QString();
    m_wanted = QString();
    m_classes = std::move(*classes);
    m_all = std::move(*teams);
    m_isShowing = true;
    m_classList->clear();
    int row = 0;
    for (const ClassRecord &each : m_classes) {
        const QString name = QString::fromStdString(each.name);
        if (name == before)
            row = m_classList->count();
        auto *item =
            new QListWidgetItem(each.archived ? tr("%1 (archived, %n team(s))", "", each.teams).arg(name)
                                              : tr("%1 (%n team(s))", "", each.teams).arg(name),
                                m_classList);
        item->setToolTip(name.toHtmlEscaped());
    }
    m_classList->addItem(tr("Teams without a class"));
    m_classList->setCurrentRow(row);
    m_isShowing = false;
    showTeams();
}

const ClassRecord *ClassesDialog::currentClass() const
{
    return recordAt(m_classes, m_classList->currentRow());
}

const TeamRecord *ClassesDialog::currentTeam() const
{
    return recordAt(m_teams, m_teamTable->currentRow());
}

void ClassesDialog::showTeams()
{
    const ClassRecord *chosen = currentClass();
    const RecordId current = currentTeam() ? currentTeam()->id : 0;
    const int before = m_teamTable->currentRow();
    m_teams.clear();
    for (const TeamRecord &team : m_all)
        if (team.className == (chosen ? chosen->name : std::string()))
            m_teams.push_back(team);
    std::ranges::stable_sort(m_teams, {}, &TeamRecord::name);
    m_isShowing = true;
    m_teamTable->setRowCount(static_cast<int>(m_teams.size()));
    for (int i = 0; i < m_teamTable->rowCount(); ++i) {
        const TeamRecord &team = m_teams[static_cast<std::size_t>(i)];
        m_teamTable->setItem(i, NameColumn, new QTableWidgetItem(QString::fromStdString(team.name)));
        m_teamTable->setItem(i, PseudonymColumn,
                             new QTableWidgetItem(QString::fromStdString(team.pseudonym)));
        QStringList robots;
        for (const RobotRecord &robot : m_robots)
            if (std::ranges::find(team.robots, robot.id) != team.robots.end())
                robots << QString::fromStdString(robot.name);
        showToRead(i, MembersColumn, shownMembers(team));
        showToRead(i, RobotsColumn, robots.join(QStringLiteral(", ")));
    }
    const auto same =
        std::ranges::find(m_teams, current, &TeamRecord::id); // another name may have put it elsewhere
    const int row = same != m_teams.end() ? static_cast<int>(same - m_teams.begin()) : std::max(0, before);
    m_teamTable->setCurrentCell(std::min(row, m_teamTable->rowCount() - 1), NameColumn);
    m_isShowing = false;
    showButtons();
}

/// A cell that is changed in the team's dialog, not in place.
void ClassesDialog::showToRead(int row, int column, const QString &text)
{
    auto *item = new QTableWidgetItem(text);
    item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    item->setToolTip(text.toHtmlEscaped());
    m_teamTable->setItem(row, column, item);
}

void ClassesDialog::showButtons()
{
    const ClassRecord *chosen = currentClass();
    const bool able = chosen && !m_readOnly, hasTeam = currentTeam() && !m_readOnly;
    m_newClass->setEnabled(!m_readOnly);
    m_rename->setEnabled(able);
    m_archive->setEnabled(able);
    m_archive->setText(chosen && chosen->archived ? tr("Restore from &archive") : tr("&Archive"));
    m_removeClass->setEnabled(able && chosen->teams == 0);
    m_newTeam->setEnabled(!m_readOnly);
    m_roster->setEnabled(!m_readOnly);
    m_removeTeam->setEnabled(hasTeam);
    m_editTeam->setEnabled(hasTeam);
    m_moveMenu->clear();
    for (const ClassRecord &each : m_classes)
        if (!chosen || each.id != chosen->id)
            m_moveMenu->addAction(QString::fromStdString(each.name).replace(u'&', QStringLiteral("&&")), this,
                                  [this, name = each.name] { moveTeam(name); });
    if (chosen)
        m_moveMenu->addAction(tr("No class"), this, [this] { moveTeam({}); });
    m_move->setEnabled(hasTeam && !m_moveMenu->isEmpty());
}

QString ClassesDialog::askName(const QString &title, const QString &name)
{
    bool accepted = false;
    const QString answer =
        QInputDialog::getText(this, title, tr("Name:"), QLineEdit::Normal, name, &accepted).trimmed();
    return accepted && answer != name ? answer : QString();
}

void ClassesDialog::addClass()
{
    const QString name = askName(tr("New class"), {});
    if (name.isNull())
        return;
    m_wanted = name;
    apply(ODO_TEXT("ui.add_class", "add class %1")(Named::schoolClass(name.toStdString())),
          [&] { return withoutValue(m_project.classes().add(name.toStdString())); });
}

void ClassesDialog::renameClass()
{
    const ClassRecord chosen = *currentClass();
    const QString name = askName(tr("Rename class"), QString::fromStdString(chosen.name));
    if (name.isNull())
        return;
    m_wanted = name;
    apply(ODO_TEXT("ui.rename_class", "rename class %1 to %2")(Named::schoolClass(chosen.name),
                                                               Named::schoolClass(name.toStdString())),
          [&] { return m_project.classes().rename(chosen.id, name.toStdString()); });
}

void ClassesDialog::archiveClass()
{
    const ClassRecord chosen = *currentClass();
    const MessageText &words = chosen.archived
                                   ? ODO_TEXT("ui.unarchive_class", "restore class %1 from the archive")
                                   : ODO_TEXT("ui.archive_class", "archive class %1");
    apply(words(Named::schoolClass(chosen.name)),
          [&] { return m_project.classes().setArchived(chosen.id, !chosen.archived); });
}

void ClassesDialog::removeClass()
{
    const ClassRecord chosen = *currentClass();
    apply(ODO_TEXT("ui.delete_class", "delete class %1")(Named::schoolClass(chosen.name)),
          [&] { return m_project.classes().remove(chosen.id); });
}

void ClassesDialog::addTeam()
{
    const QString name = askName(tr("New team"), {});
    if (name.isNull())
        return;
    const std::string className = currentClass() ? currentClass()->name : std::string();
    apply(ODO_TEXT("ui.add_team", "add team %1")(Named::team(name.toStdString())), [&] {
        return withoutValue(m_project.teams().add({0, name.toStdString(), className}));
    });
}

void ClassesDialog::moveTeam(const std::string &className)
{
    TeamRecord team = *currentTeam();
    team.className = className;
    apply(className.empty()
              ? ODO_TEXT("ui.take_team_out", "remove team %1 from its class")(Named::team(team.name))
              : ODO_TEXT("ui.move_team", "move team %1 to class %2")(Named::team(team.name),
                                                                     Named::schoolClass(className)),
          [&] { return m_project.teams().set(team); });
}

void ClassesDialog::removeTeam()
{
    const TeamRecord team = *currentTeam();
    apply(ODO_TEXT("ui.delete_team", "delete team %1")(Named::team(team.name)),
          [&] { return m_project.teams().remove(team.id); });
}

void ClassesDialog::editTeam()
{
    if (!m_editTeam->isEnabled())
        return;
    const TeamRecord before = *currentTeam();
    TeamDialog dialog(before, m_robots, this);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const TeamRecord team = dialog.team();
    if (team.members == before.members && team.robots == before.robots)
        return;
    apply(ODO_TEXT("ui.change_team", "change members and robots of team %1")(Named::team(team.name)),
          [&] { return m_project.teams().set(team); });
}

void ClassesDialog::readCell(int row, int column)
{
    if (m_isShowing || column > PseudonymColumn)
        return;
    const TeamRecord before = m_teams[static_cast<std::size_t>(row)];
    TeamRecord team = before;
    const QString text = m_teamTable->item(row, column)->text().trimmed();
    (column == NameColumn ? team.name : team.pseudonym) = text.toStdString();
    if (team.name == before.name && team.pseudonym == before.pseudonym)
        return showTeams();
    apply(column == NameColumn
              ? ODO_TEXT("ui.rename_team", "rename team %1 to %2")(Named::team(before.name),
                                                                   Named::team(team.name))
              : ODO_TEXT("ui.change_pseudonym", "change the pseudonym of team %1")(Named::team(before.name)),
          [&] { return m_project.teams().set(team); });
}

void ClassesDialog::apply(const Message &words, const std::function<Result<void>()> &work)
{
    showOutcome(m_changes.make(words, work));
}

void ClassesDialog::showOutcome(const Result<QString> &outcome)
{
    m_message->setText(outcome ? *outcome : errorLine(outcome.error()));
    if (!outcome)
        m_wanted = QString();
    refresh(); // a cell that was refused shows again what is stored
    if (outcome)
        Q_EMIT changed();
}

TeamDialog::TeamDialog(TeamRecord team, const std::vector<RobotRecord> &robots, QWidget *parent)
    : QDialog(parent), m_team(std::move(team)), m_robots(robots), m_members(new QPlainTextEdit),
      m_list(new CheckList(tr("Robots of the team")))
{
    setWindowTitle(tr("Team %1").arg(shownTeam(m_team)));
    QStringList members, names;
    for (const std::string &member : m_team.members)
        members << QString::fromStdString(member);
    m_members->setPlainText(members.join(u'\n'));
    m_members->setPlaceholderText(tr("One name per line"));
    m_members->setAccessibleName(tr("Members of the team, one per line"));
    m_members->setTabChangesFocus(true);
    for (const RobotRecord &robot : m_robots)
        names << QString::fromStdString(robot.name);
    m_list->setNames(names, false);
    for (int i = 0; i < m_list->count(); ++i)
        if (std::ranges::find(m_team.robots, m_robots[static_cast<std::size_t>(i)].id) != m_team.robots.end())
            m_list->item(i)->setCheckState(Qt::Checked);
    m_list->setToolTip(tr("Record and Import propose these robots for the team's runs"));
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
        return team.members.empty()
                   ? QString()
                   : TeamDialog::tr("%n member(s)", "", static_cast<int>(team.members.size()));
    QStringList names;
    for (const std::string &member : team.members)
        names << QString::fromStdString(member);
    return names.join(QStringLiteral(", "));
}

} // namespace odo
