// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/background_task.h"
#include "ui/models/shown_names.h"
#include "ui/models/timeline.h"
#include "ui/review/corrections.h"
#include "ui/review/internal/range_card.h"
#include "ui/review/review_column.h"
#include "ui/review/review_desk.h"
#include "ui/views/charts/timeline_bar.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/empty_state.h"
#include "ui/views/widgets/spike_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <map>

namespace odo {

/// What is asked of the project.
struct ReviewPage::Wish
{
    std::string chosen; ///< shown, wherever it is; empty: none
    std::string shown;  ///< shown again, unless it is in the bin now
    bool withList = false;
};

/// What it gave.
struct ReviewPage::Reading
{
    struct List
    {
        QStringList names, words;
    };
    std::optional<List> list;    ///< of the trials that are not in the bin, in the order of time
    Result<TrialScenePtr> scene; ///< null: there is none
};

ReviewPage::ReviewPage(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_reader(new ProjectReader(project.file(), this)),
      m_timeline(new Timeline(this)), m_spikes(new SpikeActions(*m_timeline, this)),
      m_pointing(new RobotPointing(*m_timeline, this)), m_stack(new QStackedWidget(this)),
      m_content(new QWidget(m_stack)), m_chooser(new TrialChooser),
      m_desk(new ReviewDesk(*m_timeline, m_content)), m_timelineBar(new TimelineBar(*m_timeline, m_content)),
      m_column(new ReviewColumn(*m_timeline, m_chooser, m_content)),
      m_empty(new EmptyState(
          QStringLiteral("review"), tr("No trials yet"),
          tr("A trial is one run of a robot. Bring in the videos that your cameras took of it, "
             "and it will be shown here."),
          m_stack))
{
    setObjectName(QStringLiteral("page"));
    auto *left = new QVBoxLayout;
    left->setSpacing(8);
    left->addWidget(m_desk, 1);
    left->addWidget(m_timelineBar);
    auto *contentLayout = new QHBoxLayout(m_content);
    contentLayout->setContentsMargins(8, 8, 8, 8);
    contentLayout->setSpacing(8);
    contentLayout->addLayout(left, 1);
    contentLayout->addWidget(m_column);
    m_stack->addWidget(m_content);
    m_stack->addWidget(m_empty);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_stack);

    m_column->spikes().setActions(m_spikes->actions());
    connect(&m_column->spikes(), &SpikeList::robotChosen, m_spikes, &SpikeActions::setRobot);
    for (QAction *action :
         m_timeline->actions() + m_desk->viewActions() + m_spikes->actions() + QList{m_pointing->action()}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
    }
    QPushButton *import = m_empty->addButton(QStringLiteral("import"), tr("Import trial from videos…"));
    connect(import, &QPushButton::clicked, this, &ReviewPage::importRequested);
    connect(m_column, &ReviewColumn::trackRequested, this,
            [this] { Q_EMIT trackRequested(QString::fromStdString(m_scene->trial.name)); });
    connect(m_chooser, &TrialChooser::chosen, this, [this](const QString &name) {
        if (const Result<void> shown = showTrial(name); !shown)
            Q_EMIT failed(shown.error());
    });
    connect(m_desk, &ReviewDesk::settled, this, &ReviewPage::showSettled);
    connect(m_desk, &ReviewDesk::pointedAt, m_pointing, &RobotPointing::ask);
    connect(m_pointing->action(), &QAction::toggled, m_desk, &ReviewDesk::setPointing);
    connect(m_desk, &ReviewDesk::quantitiesChanged, this,
            [this] { m_column->range().setQuantities(m_desk->quantities()); });
    connect(&m_column->range(), &RangeCard::fitChanged, m_desk, &ReviewDesk::setFit);
    m_column->range().setQuantities(m_desk->quantities());
}

ReviewPage::~ReviewPage() = default;

Result<void> ReviewPage::showTrial(const QString &name)
{
    ODO_TRY(m_project.trials().find(name.toStdString()));
    m_chosen = name;
    m_chooser->setCurrent(name);
    load();
    return {};
}

QString ReviewPage::trial() const
{
    if (!m_chosen.isEmpty() || !m_scene)
        return m_chosen;
    return QString::fromStdString(m_scene->trial.name);
}

void ReviewPage::refresh()
{
    m_isListStale = true;
    load();
}

/// On the reader's thread.
Result<ReviewPage::Reading> ReviewPage::readTrial(Project &project, const Wish &wish)
{
    Reading reading{std::nullopt, nullptr};
    std::string name = wish.chosen.empty() ? wish.shown : wish.chosen;
    if (wish.withList) {
        std::vector<TrialName> trials = ODO_TRY(project.trials().names());
        reading.list.emplace();
        std::map<std::string, QString> shownTeams; // by name
        for (const TeamRecord &team : project.teams().all().value_or(std::vector<TeamRecord>()))
            shownTeams[team.name] = shownTeam(team);
        std::string newest;
        bool isThere = !wish.chosen.empty();
        std::ranges::reverse(trials); // the chooser goes on in time
        for (const TrialName &trial : trials) {
            if (trial.binned)
                continue;
            const QString shown = QString::fromStdString(trial.name), team = shownTeams[trial.teamName];
            reading.list->names << shown;
            reading.list->words << (team.isEmpty() ? shown : QStringLiteral("%1 · %2").arg(shown, team));
            newest = trial.name;
            isThere |= trial.name == name;
        }
        if (!isThere)
            name = newest;
    }
    if (!name.empty())
        reading.scene = loadTrialScene(project, name);
    return reading;
}

void ReviewPage::load()
{
    const Wish wish{m_chosen.toStdString(), m_scene ? m_scene->trial.name : std::string(), m_isListStale};
    m_reader->read<Reading>([wish](Project &project) { return readTrial(project, wish); },
                            [this](Result<Reading> reading) { take(std::move(reading)); });
}

void ReviewPage::take(Result<Reading> reading)
{
    m_chosen.clear();
    if (reading && reading->list) {
        m_isListStale = false;
        m_chooser->setTrials(reading->list->names, reading->list->words);
    }
    const Result<TrialScenePtr> scene = reading ? reading->scene : tl::unexpected(reading.error());
    if (scene) {
        adopt(*scene);
        return;
    }
    m_chooser->setCurrent(trial());
    Q_EMIT failed(scene.error());
    showSettled();
}

void ReviewPage::adopt(TrialScenePtr scene)
{
    const bool sameTrial = m_scene && scene && m_scene->trial.id == scene->trial.id;
    const Nanoseconds time = m_timeline->currentTime();
    const std::optional<TimeSpan> selection = m_timeline->selection();
    m_scene = std::move(scene);
    m_timeline->setFrameTimes(m_scene ? m_scene->frameTimes() : std::vector<Nanoseconds>());
    if (sameTrial) {
        m_timeline->setCurrentTime(time);
        m_timeline->setSelection(selection);
    }
    m_desk->setScene(m_scene);
    m_timelineBar->setScene(m_scene);
    m_spikes->setScene(m_scene);
    m_pointing->setScene(m_scene);
    m_column->setScene(m_scene);
    m_chooser->setCurrent(trial());
    m_stack->setCurrentIndex(m_scene ? 0 : 1);
    Q_EMIT trialShown();
    showSettled();
}

bool ReviewPage::isSettled() const
{
    return !m_reader->isRunning() && m_desk->isSettled();
}

void ReviewPage::showSettled()
{
    if (isSettled())
        Q_EMIT settled();
}

bool ReviewPage::event(QEvent *event)
{
    return keepSpaceForFocus(*event) || QWidget::event(event);
}

} // namespace odo
