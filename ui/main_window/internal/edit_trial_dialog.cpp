// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/edit_trial_dialog.h"

#include "core/project/class_repository.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/main_window/internal/import_dialogs.h"
#include "ui/main_window/internal/variable_table.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/models/trial_model.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/labels.h"

#include <QDateTimeEdit>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>

namespace odo {

/// A field of one trial or several. Where they differ it is a button that says so, and the field comes when
/// that is pressed: from then on all get what is in it.
class SharedField : public QWidget
{
    Q_OBJECT
public:
    SharedField(const QString &name, QWidget *editor, bool areSame) : m_editor(editor), m_areSame(areSame)
    {
        auto *layout = new QVBoxLayout(this);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(editor);
        setFocusPolicy(Qt::StrongFocus); // its label's key goes to what is in it
        setFocusProxy(editor);
        editor->setVisible(areSame);
        if (areSame)
            return;
        m_several = plainButton(tr("several"));
        m_several->setAccessibleName(tr("%1: several").arg(name));
        m_several->setToolTip(tr("The trials differ here. Press to enter one value for all of them."));
        layout->addWidget(m_several);
        setFocusProxy(m_several);
        connect(m_several, &QPushButton::clicked, this, [this] {
            open();
            m_editor->setFocus(Qt::OtherFocusReason);
        });
    }

    /// The field is there, and no longer the button.
    bool isOpen() const { return m_isOpen; }
    /// Whether what is in it is to be stored. isChanged: it is another value than at first.
    bool isEdited(bool isChanged) const { return m_areSame ? isChanged : m_isOpen; }

    void open()
    {
        if (std::exchange(m_isOpen, true))
            return;
        m_editor->show();
        setFocusProxy(m_editor);
        m_several->hide();
    }

private:
    QWidget *const m_editor;
    QPushButton *m_several = nullptr;
    const bool m_areSame;
    bool m_isOpen = m_areSame;
};

namespace {

template <class Value>
bool areSame(const std::vector<TrialRecord> &trials, Value TrialRecord::*what)
{
    return std::ranges::all_of(trials,
                               [&](const TrialRecord &trial) { return trial.*what == trials.front().*what; });
}

QStringList shownList(const std::vector<std::string> &names)
{
    QStringList list;
    for (const std::string &name : names)
        list << QString::fromStdString(name);
    return list;
}

QComboBox *makeNames(bool editable)
{
    auto *names = new QComboBox;
    names->setEditable(editable);
    names->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon); // a name may be long
    names->setMinimumContentsLength(16);
    return names;
}

/// Names of variables, of all trials of the project.
QStringList knownVariables(Project &project)
{
    QStringList names;
    for (const TrialRecord &trial : project.trials().all().value_or(std::vector<TrialRecord>()))
        for (const auto &variable : trial.variables)
            names << QString::fromStdString(variable.first);
    names.removeDuplicates();
    names.sort(Qt::CaseInsensitive);
    return names;
}

} // namespace

EditTrialDialog::EditTrialDialog(Project &project, std::vector<TrialRecord> trials, QWidget *parent)
    : QDialog(parent), m_project(project), m_trials(std::move(trials)),
      m_teams(project.teams().all().value_or(std::vector<TeamRecord>())), m_name(new QLineEdit),
      m_tags(new QLineEdit), m_class(makeNames(true)), m_task(makeNames(false)), m_date(makeMomentField()),
      m_robots(new CheckList(tr("Robots in the trial"))), m_notes(new QPlainTextEdit),
      m_variables(new VariableTable(m_trials, knownVariables(project))), m_message(new QLabel)
{
    setWindowTitle(m_trials.size() == 1 ? tr("Edit %1").arg(QString::fromStdString(m_trials.front().name))
                                        : tr("Edit %n trial(s)", "", static_cast<int>(m_trials.size())));
    QStringList names, shown;
    for (const TeamRecord &team : m_teams) {
        names << QString::fromStdString(team.name);
        shown << shownTeam(team);
    }
    m_team = new TeamBox(names, shown);
    m_team->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    fillChoices();
    fillValues();
    m_before = written();
    auto *scroll = new QScrollArea;
    scroll->setWidget(makeForm());
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    showAsWords(*m_message);
    m_message->setAccessibleName(tr("Why it was not changed"));
    m_message->hide();
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *change = buttons->addButton(tr("&Change"), QDialogButtonBox::AcceptRole);
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(scroll, 1);
    layout->addWidget(m_message);
    layout->addWidget(buttons);
    change->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &EditTrialDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_team, &QComboBox::currentTextChanged, this, &EditTrialDialog::proposeClass);
    constexpr int width = 520, margins = 90;
    resize(width, scroll->widget()->sizeHint().height() + margins);
}

void EditTrialDialog::fillChoices()
{
    m_class->addItem(QString());
    for (const ClassRecord &each : m_project.classes().all().value_or(std::vector<ClassRecord>()))
        if (!each.archived || each.name == m_trials.front().className)
            m_class->addItem(QString::fromStdString(each.name));
    m_task->addItem(tr("None"), QString());
    for (const TaskRecord &task : m_project.tasks().current().value_or(std::vector<TaskRecord>()))
        m_task->addItem(QString::fromStdString(task.name), QString::fromStdString(task.name));
    QStringList robots;
    for (const RobotRecord &robot : m_project.robots().all().value_or(std::vector<RobotRecord>()))
        robots << QString::fromStdString(robot.name);
    m_robots->setNames(robots, false);
}

/// Of the first trial; where the others differ it is hidden at first.
void EditTrialDialog::fillValues()
{
    const TrialRecord &first = m_trials.front();
    m_name->setText(QString::fromStdString(first.name));
    m_team->setCurrentText(shownTeam(first));
    m_class->setCurrentText(QString::fromStdString(first.className));
    m_date->setDateTime(QDateTime::fromMSecsSinceEpoch(first.date.time_since_epoch().count()));
    const QString task = QString::fromStdString(first.task);
    if (m_task->findData(task) < 0) // one that is archived
        m_task->addItem(task, task);
    m_task->setCurrentIndex(m_task->findData(task));
    m_robots->setChecked(shownList(first.robotNames));
    m_tags->setText(shownList(first.tags).join(QStringLiteral(", ")));
    m_notes->setPlainText(QString::fromStdString(first.notes));
}

QWidget *EditTrialDialog::makeForm()
{
    auto *content = new QWidget;
    auto *form = new QFormLayout(content);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    if (m_trials.size() == 1) {
        m_nameField = addField(*form, tr("&Name"), m_name, true);
    } else { // a name is one trial's
        m_name->setParent(content);
        m_name->hide();
    }
    m_teamField = addField(*form, tr("T&eam"), m_team, areSame(m_trials, &TrialRecord::teamName));
    m_classField = addField(*form, tr("C&lass"), m_class, areSame(m_trials, &TrialRecord::className));
    m_dateField = addField(*form, tr("&Date and time"), m_date, areSame(m_trials, &TrialRecord::date));
    m_taskField = addField(*form, tr("Tas&k"), m_task, areSame(m_trials, &TrialRecord::task));
    m_robotsField = addField(*form, tr("R&obots"), m_robots, areSame(m_trials, &TrialRecord::robots));
    m_tags->setPlaceholderText(tr("separated by commas"));
    m_tagsField = addField(*form, tr("Ta&gs"), m_tags, areSame(m_trials, &TrialRecord::tags));
    m_notes->setTabChangesFocus(true);
    constexpr int notesHeight = 72;
    m_notes->setFixedHeight(notesHeight);
    m_notesField = addField(*form, tr("Note&s"), m_notes, areSame(m_trials, &TrialRecord::notes));
    auto *variables = new QLabel(tr("&Variables"));
    variables->setBuddy(m_variables);
    form->addRow(variables, makeVariables());
    return content;
}

SharedField *EditTrialDialog::addField(QFormLayout &form, const QString &label, QWidget *editor, bool areSame)
{
    const QString name = QString(label).remove(u'&');
    editor->setAccessibleName(name);
    auto *field = new SharedField(name, editor, areSame);
    form.addRow(label, field);
    return field;
}

QWidget *EditTrialDialog::makeVariables()
{
    auto *box = new QWidget;
    auto *layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_variables);
    QPushButton *remove = plainButton(tr("&Remove variable"));
    layout->addWidget(remove, 0, Qt::AlignLeft);
    connect(remove, &QPushButton::clicked, m_variables, &VariableTable::removeCurrent);
    return box;
}

/// A team is of one class: choosing the team chooses it too.
void EditTrialDialog::proposeClass()
{
    const auto team = std::ranges::find(m_teams, m_team->team(), &TeamRecord::name);
    if (team == m_teams.end() && !m_team->team().empty())
        return; // a new one
    m_classField->open();
    m_class->setCurrentText(team == m_teams.end() ? QString() : QString::fromStdString(team->className));
}

TrialEdit EditTrialDialog::written() const
{
    TrialEdit all;
    all.name = m_name->text().toStdString();
    all.team = m_team->team();
    all.className = m_class->currentText().trimmed().toStdString();
    all.date = Instant(std::chrono::milliseconds(m_date->dateTime().toMSecsSinceEpoch()));
    all.task = m_task->currentData().toString().toStdString();
    all.robots = m_robots->checkedNames();
    all.tags = tagsOf(m_tags->text());
    all.notes = m_notes->toPlainText().toStdString();
    return all;
}

TrialEdit EditTrialDialog::edit() const
{
    TrialEdit edit = written();
    const auto keepChanged = [](const SharedField *field, auto &now, const auto &before) {
        if (!field || !field->isEdited(now != before))
            now.reset();
    };
    const std::string className = *edit.className;
    keepChanged(m_nameField, edit.name, m_before.name);
    keepChanged(m_teamField, edit.team, m_before.team);
    keepChanged(m_classField, edit.className, m_before.className);
    if (edit.team) { // its class confirms a change of class; one without takes the trial out of its class
        edit.className.reset();
        if (m_classField->isOpen() && !className.empty())
            edit.className = className;
    }
    keepChanged(m_dateField, edit.date, m_before.date);
    keepChanged(m_taskField, edit.task, m_before.task);
    keepChanged(m_robotsField, edit.robots, m_before.robots);
    keepChanged(m_tagsField, edit.tags, m_before.tags);
    keepChanged(m_notesField, edit.notes, m_before.notes);
    edit.variables = m_variables->changes();
    return edit;
}

void EditTrialDialog::accept()
{
    m_variables->storeEdited();
    if (const QString twice = m_variables->repeatedName(); !twice.isEmpty())
        return showFailure(tr("The variable %1 is in the table twice. Remove one of the rows.").arg(twice));
    std::vector<RecordId> ids;
    for (const TrialRecord &trial : m_trials)
        ids.push_back(trial.id);
    auto edited = editTrials(m_project, ids, edit());
    if (!edited)
        return showFailure(errorLine(edited.error()));
    m_trials = std::move(*edited);
    QDialog::accept();
}

void EditTrialDialog::showFailure(const QString &words)
{
    m_message->setText(words);
    m_message->show();
}

} // namespace odo

#include "edit_trial_dialog.moc"
