// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/internal/run_card.h"

#include "core/workflow/record/record_trial.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_names.h"
#include "ui/record/internal/trigger_box.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace odo {

namespace {

constexpr int mostLaps = 100;
constexpr double leastRestS = 0.5, mostRestS = 60, leastLengthS = 1, mostLengthS = 3600, usualLengthS = 10;

const QString beforeKey = QStringLiteral("record/secondsBefore"), restKey = QStringLiteral("record/rest"),
              lengthKey = QStringLiteral("record/length");

bool hasLaps(const std::optional<Task> &task)
{
    return task && std::ranges::find(task->gates, GateRole::StartFinish, &Gate::role) != task->gates.end();
}

/// A number of seconds that is remembered on this computer.
void setUpSeconds(NumberBox &box, const QString &key, double least, double most, double usual)
{
    box.setDecimals(1);
    box.setRange(least, most);
    box.setSuffix(RunCard::tr(" s"));
    box.setValue(QSettings().value(key, usual).toDouble());
    QObject::connect(&box, &QDoubleSpinBox::valueChanged, &box,
                     [key](double seconds) { QSettings().setValue(key, seconds); });
}

} // namespace

RunCard::RunCard(QWidget *parent)
    : Card(tr("Up now"), parent), m_form(new QFormLayout), m_class(new QComboBox), m_team(new QComboBox),
      m_task(new QComboBox), m_start(new TriggerBox(TriggerBox::Of::Start)),
      m_stop(new TriggerBox(TriggerBox::Of::Stop)), m_robots(new CheckList(tr("Robots of this run"))),
      m_trial(new QLineEdit), m_before(new QSpinBox), m_laps(new QSpinBox), m_rest(new NumberBox),
      m_length(new NumberBox)
{
    auto *content = new QWidget;
    content->setObjectName(QStringLiteral("cardBody"));
    content->setLayout(m_form);
    m_form->setContentsMargins(10, 8, 10, 8);
    m_form->setVerticalSpacing(5);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->addRow(tr("&Class"), m_class);
    m_form->addRow(tr("Te&am"), m_team);
    m_form->addRow(tr("Tas&k"), m_task);
    m_form->addRow(tr("R&obots"), m_robots);
    m_form->addRow(tr("Trial &name"), m_trial);
    addTriggers();
    m_team->setAccessibleName(tr("Team of this run"));
    for (QComboBox *box : {m_class, m_team, m_task}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(12);
    }
    setContent(content);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    connect(m_class, &QComboBox::currentIndexChanged, this, [this] {
        fillTeams();
        chooseTeam();
    });
    connect(m_team, &QComboBox::currentIndexChanged, this, &RunCard::chooseTeam);
    connect(m_task, &QComboBox::currentIndexChanged, this, [this] {
        showStarts();
        Q_EMIT changed();
    });
    connect(m_robots, &QListWidget::itemChanged, this, &RunCard::robotsChanged);
    showStarts();
}

/// How it begins and ends.
void RunCard::addTriggers()
{
    m_form->addRow(tr("Be&gins"), m_start);
    m_form->addRow(tr("Before start"), m_before);
    m_form->addRow(tr("Ends"), m_stop);
    m_form->addRow(tr("&Laps"), m_laps);
    m_form->addRow(tr("At rest for"), m_rest);
    m_form->addRow(tr("After start"), m_length);
    m_start->setAccessibleName(tr("When the recording begins"));
    m_stop->setAccessibleName(tr("When the recording ends"));
    m_before->setRange(0, int(longestPreRollS));
    m_before->setSuffix(tr(" s"));
    m_before->setSpecialValueText(tr("off"));
    m_before->setValue(QSettings().value(beforeKey, 0).toInt());
    m_before->setAccessibleName(tr("Seconds recorded before the start"));
    m_before->setToolTip(tr("Frames of this time are kept in memory, so a late press loses nothing"));
    m_laps->setRange(1, mostLaps);
    m_laps->setAccessibleName(tr("Number of laps"));
    setUpSeconds(*m_rest, restKey, leastRestS, mostRestS, toSeconds(usualRest));
    m_rest->setAccessibleName(tr("Seconds without motion that end the recording"));
    setUpSeconds(*m_length, lengthKey, leastLengthS, mostLengthS, usualLengthS);
    m_length->setAccessibleName(tr("Seconds after the start that end the recording"));
    for (TriggerBox *box : {m_start, m_stop}) {
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            showStarts();
            Q_EMIT changed();
        });
    }
    connect(m_laps, &QSpinBox::valueChanged, this, &RunCard::changed);
    for (NumberBox *box : {m_rest, m_length})
        connect(box, &QDoubleSpinBox::valueChanged, this, &RunCard::changed);
    connect(m_before, &QSpinBox::valueChanged, this, [this](int seconds) {
        QSettings().setValue(beforeKey, seconds);
        Q_EMIT beforeChanged();
    });
}

void RunCard::setLineUp(const LineUp &lineUp)
{
    m_lineUp = lineUp;
    const QSignalBlocker quietClass(m_class), quietTask(m_task), quietRobots(m_robots);
    const QString className = m_class->currentData().toString(), task = m_task->currentText();
    const std::vector<std::string> checked = m_robots->checkedNames();
    m_class->clear();
    for (const std::string &name : lineUp.classes())
        m_class->addItem(name.empty() ? tr("no class") : QString::fromStdString(name),
                         QString::fromStdString(name));
    m_class->setCurrentIndex(std::max(0, m_class->findData(className)));
    m_form->setRowVisible(m_class, m_class->count() > 1);
    fillTeams();
    m_task->clear();
    m_task->addItem(tr("none"), QString());
    for (const TaskRecord &each : lineUp.tasks())
        m_task->addItem(QString::fromStdString(each.name), QString::fromStdString(each.name));
    m_task->setCurrentIndex(std::max(0, m_task->findText(task)));
    m_form->setRowVisible(m_task, m_task->count() > 1);
    QStringList names;
    for (const RobotRecord &robot : lineUp.robots())
        names << QString::fromStdString(robot.name);
    m_robots->setNames(names, false);
    for (int i = 0; i < m_robots->count(); ++i) {
        if (std::ranges::find(checked, m_robots->item(i)->text().toStdString()) != checked.end())
            m_robots->item(i)->setCheckState(Qt::Checked);
    }
    m_form->setRowVisible(m_robots, m_robots->count() > 0);
    showStarts();
}

void RunCard::fillTeams()
{
    const QSignalBlocker quiet(m_team);
    const QString before = m_team->currentData().toString();
    m_team->clear();
    for (const std::string &name : m_lineUp.teams(m_class->currentData().toString().toStdString()))
        m_team->addItem(shownTeam(name, m_lineUp.pseudonymOf(name)), QString::fromStdString(name));
    m_team->addItem(tr("no team"), QString());
    m_team->setCurrentIndex(std::max(0, m_team->findData(before)));
    m_form->setRowVisible(m_team, m_team->count() > 1);
}

void RunCard::chooseTeam()
{
    NextRun run = m_lineUp.run(m_class->currentData().toString().toStdString(),
                               m_team->currentData().toString().toStdString());
    run.task = m_task->currentData().toString().toStdString(); // the class goes on with what it was doing
    setRun(run);
}

void RunCard::setRun(const NextRun &run)
{
    {
        const QSignalBlocker quietClass(m_class), quietTeam(m_team), quietTask(m_task), quietRobots(m_robots);
        m_class->setCurrentIndex(std::max(0, m_class->findData(QString::fromStdString(run.className))));
        fillTeams();
        m_team->setCurrentIndex(std::max(0, m_team->findData(QString::fromStdString(run.team))));
        m_task->setCurrentIndex(std::max(0, m_task->findData(QString::fromStdString(run.task))));
        for (int i = 0; i < m_robots->count(); ++i) {
            const bool drives =
                std::ranges::find(run.robots, m_robots->item(i)->text().toStdString()) != run.robots.end();
            m_robots->item(i)->setCheckState(drives ? Qt::Checked : Qt::Unchecked);
        }
        m_trial->setText(QString::fromStdString(run.trial));
    }
    showStarts();
    Q_EMIT robotsChanged();
    Q_EMIT changed();
}

/// Who starts at the gate usually ends at the finish; both can be chosen otherwise.
void RunCard::showStarts()
{
    m_start->setTask(task());
    m_stop->setTask(task());
    const bool byGate = m_start->isBy(TriggerBox::byGate);
    if (std::exchange(m_startedByGate, byGate) != byGate && (byGate || m_stop->isBy(TriggerBox::byGate))) {
        const QSignalBlocker quiet(m_stop);
        m_stop->choose(byGate ? TriggerBox::byGate : TriggerBox::byPress);
    }
    m_before->setEnabled(m_start->countdownS() == 0); // nobody is late after a countdown
    m_form->setRowVisible(m_laps, m_stop->isBy(TriggerBox::byGate) && hasLaps(task()));
    m_form->setRowVisible(m_rest, m_stop->isBy(TriggerBox::byMotion));
    m_form->setRowVisible(m_length, m_stop->isBy(TriggerBox::byTime));
}

NextRun RunCard::run() const
{
    return {m_class->currentData().toString().toStdString(), m_team->currentData().toString().toStdString(),
            m_task->currentData().toString().toStdString(), m_robots->checkedNames(),
            m_trial->text().trimmed().toStdString()};
}

RunSettings RunCard::settings() const
{
    RunSettings settings;
    settings.start = m_start->trigger();
    settings.stop = m_stop->trigger();
    if (m_stop->isBy(TriggerBox::byMotion))
        settings.stop->time = fromSeconds(m_rest->value());
    if (m_stop->isBy(TriggerBox::byTime))
        settings.stop->time = fromSeconds(m_length->value());
    settings.countdown = std::chrono::seconds(m_start->countdownS());
    settings.laps = m_laps->value();
    settings.before = std::chrono::seconds(m_before->value());
    return settings;
}

std::optional<Task> RunCard::task() const
{
    const TaskRecord *record = m_lineUp.task(m_task->currentData().toString().toStdString());
    return record ? std::optional(record->task) : std::nullopt;
}

std::vector<RobotRecord> RunCard::robots() const
{
    const std::vector<std::string> checked = m_robots->checkedNames();
    std::vector<RobotRecord> robots;
    for (const RobotRecord &robot : m_lineUp.robots()) {
        if (std::ranges::find(checked, robot.name) != checked.end())
            robots.push_back(robot);
    }
    return robots;
}

namespace {

constexpr int iconSide = 22;

/// "00:12.3": tenths are enough while it runs.
QString clockText(Nanoseconds elapsed)
{
    return timeCode(elapsed).chopped(2);
}

} // namespace

StartCard::StartCard(QWidget *parent)
    : Card(tr("Recording"), parent), m_action(new QAction(tr("&Record or stop"), this)),
      m_button(new QPushButton), m_clock(new QLabel), m_words(new QLabel)
{
    auto *content = new QWidget;
    content->setObjectName(QStringLiteral("cardBody"));
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(10, 10, 10, 8);
    layout->setSpacing(6);
    m_button->setObjectName(QStringLiteral("recordButton"));
    m_button->setIconSize({iconSide, iconSide});
    m_clock->setObjectName(QStringLiteral("recordClock"));
    m_clock->setAlignment(Qt::AlignCenter);
    m_clock->setTextFormat(Qt::PlainText);
    m_clock->setAccessibleName(tr("Recorded time"));
    m_words->setTextFormat(Qt::PlainText);
    m_words->setWordWrap(true);
    m_words->setAlignment(Qt::AlignCenter);
    m_words->setObjectName(QStringLiteral("quiet"));
    layout->addWidget(m_button);
    layout->addWidget(m_clock);
    layout->addWidget(m_words);
    setContent(content);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    nameCommands({{m_action, "recordOrStop"}});
    m_action->setShortcut(QKeySequence(Qt::Key_F9));
    connect(m_action, &QAction::triggered, this, &StartCard::pressed);
    connect(m_button, &QPushButton::clicked, this, &StartCard::pressed);
    setState({});
}

QString StartCard::keyWords(const State &state)
{
    if (state.beforeS > 0 && state.remainingTime.isEmpty())
        return tr("F9 records, with the %1 s before; F9 stops").arg(state.beforeS);
    if (state.beforeS > 0)
        return tr("F9 records, with the %1 s before; F9 stops; %2")
            .arg(state.beforeS)
            .arg(state.remainingTime);
    return state.remainingTime.isEmpty() ? tr("F9 records, F9 stops")
                                         : tr("F9 records, F9 stops; %1").arg(state.remainingTime);
}

void StartCard::setState(const State &state)
{
    QString words, clock = clockText(state.elapsed);
    QString sign = QStringLiteral("record"), text = tr("Record");
    bool able = state.blocked.isEmpty() && !state.ending;
    switch (state.phase) {
    case RunPhase::Ready:
        words = state.ending               ? tr("Writing the last frames…")
                : !state.blocked.isEmpty() ? state.blocked
                                           : keyWords(state);
        break;
    case RunPhase::CountingDown:
        text = tr("Cancel");
        sign = QStringLiteral("stop");
        clock = tr("in %1").arg(int(std::ceil(toSeconds(state.countdownLeft))));
        words = tr("Get ready");
        able = true;
        break;
    case RunPhase::Armed:
        text = tr("Cancel");
        sign = QStringLiteral("stop");
        words = awaitedWords(state.start.value_or(RunTrigger{}), state.gate, state.beforeS);
        able = true;
        break;
    case RunPhase::Recording:
        text = tr("Stop");
        sign = QStringLiteral("stop");
        words = state.stop ? endWords(*state.stop) : state.remainingTime;
        able = true;
        break;
    }
    if (m_button->text() != text || m_button->icon().isNull() || m_button->isEnabled() != able) {
        m_button->setText(text);
        m_button->setAccessibleName(text);
        m_button->setIcon(able ? themeIcon(sign, Qt::white) : themeIcon(sign)); // white would be lost on grey
    }
    const bool isOn = state.phase != RunPhase::Ready;
    if (m_button->property("on").toBool() != isOn) {
        m_button->setProperty("on", isOn);
        m_button->style()->unpolish(m_button);
        m_button->style()->polish(m_button);
    }
    m_button->setEnabled(able);
    m_action->setEnabled(able);
    m_clock->setText(clock);
    if (m_words->text() != words)
        m_words->setText(words);
}

QString StartCard::words() const
{
    return m_words->text();
}

} // namespace odo
