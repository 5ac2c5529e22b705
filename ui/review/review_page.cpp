// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/track/stored_verdicts.h"
#include "ui/models/background_task.h"
#include "ui/models/shown_names.h"
#include "ui/models/timeline.h"
#include "ui/review/corrections.h"
#include "ui/review/guidance_tool.h"
#include "ui/review/internal/range_card.h"
#include "ui/review/internal/trial_facts.h"
#include "ui/review/range_actions.h"
#include "ui/review/review_desk.h"
#include "ui/views/charts/timeline_bar.h"
#include "ui/views/widgets/card.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/empty_state.h"
#include "ui/views/widgets/fact_list.h"
#include "ui/views/widgets/spike_list.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

namespace odo {

/// What is asked of the project.
struct ReviewPage::Request
{
    std::string chosen; ///< shown, wherever it is; empty: none
    RecordId shown = 0; ///< shown again, unless it is in the bin now
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
      m_pointing(new RobotPointing(*m_timeline, this)), m_guidance(new GuidanceTool(*m_timeline, this)),
      m_range(new RangeActions(*m_timeline, this)), m_stack(new QStackedWidget(this)),
      m_content(new QWidget(m_stack)), m_chooser(new TrialChooser),
      m_desk(new ReviewDesk(*m_timeline, m_content)), m_timelineBar(new TimelineBar(*m_timeline, m_content)),
      m_column(new ReviewColumn(*m_timeline, m_chooser, m_content)),
      m_empty(new EmptyState(
          QStringLiteral("review"), tr("No trials yet"),
          tr("A trial is one run of a robot. Import the videos that your cameras took of it to see it here."),
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
    connect(&m_column->spikes(), &SpikeList::samplesChosen, m_spikes, &SpikeActions::setChosen);
    for (QAction *action : m_timeline->actions() + m_desk->viewActions() + spikeActions() +
                               m_range->actions() + m_guidance->actions() + QList{m_pointing->action()}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
    }
    QPushButton *import = m_empty->addButton(QStringLiteral("import"), tr("Import trial from videos…"));
    connect(import, &QPushButton::clicked, this, &ReviewPage::importRequested);
    connect(m_column, &ReviewColumn::trackRequested, this,
            [this] { Q_EMIT trackRequested(QString::fromStdString(m_scene->trial.name)); });
    connect(m_column, &ReviewColumn::verdictRequested, this, &ReviewPage::judgeVerdict);
    connect(m_chooser, &TrialChooser::chosen, this, [this](const QString &name) {
        if (const Result<void> shown = showTrial(name); !shown)
            Q_EMIT failed(shown.error());
    });
    m_timelineBar->setRangeActions(m_range->actions());
    connect(m_timelineBar, &TimelineBar::rangeDragged, m_range, &RangeActions::request);
    connect(m_range, &RangeActions::requested, this, [this](const RangeChoice &range) {
        Q_EMIT rangeRequested(QString::fromStdString(m_scene->trial.name), range);
    });
    connect(m_desk, &ReviewDesk::settled, this, &ReviewPage::showSettled);
    connectPointing();
    connect(m_desk, &ReviewDesk::quantitiesChanged, this,
            [this] { m_column->range().setQuantities(m_desk->quantities()); });
    connect(&m_column->range(), &RangeCard::fitChanged, m_desk, &ReviewDesk::setFit);
    m_column->range().setQuantities(m_desk->quantities());
}

ReviewPage::~ReviewPage() = default;

/// What the mouse in a view does, besides looking closely.
void ReviewPage::connectPointing()
{
    const auto setPointing = [this] {
        m_desk->setPointing(m_pointing->action()->isChecked() || m_guidance->isDrawing());
    };
    connect(m_desk, &ReviewDesk::pointedAt, this, &ReviewPage::pointAt);
    connect(m_desk, &ReviewDesk::pointingEnded, m_guidance, &GuidanceTool::finish);
    connect(m_desk, &ReviewDesk::hovered, m_guidance, &GuidanceTool::hover);
    connect(m_pointing->action(), &QAction::toggled, this, setPointing);
    connect(m_guidance, &GuidanceTool::drawingChanged, this, [this, setPointing](bool isDrawing) {
        if (isDrawing)
            m_pointing->action()->setChecked(false);
        setPointing();
    });
    connect(m_guidance, &GuidanceTool::overlayChanged, m_desk, &ReviewDesk::updateOverlay);
    connect(m_guidance, &GuidanceTool::requested, this, &ReviewPage::guide);
    m_desk->setOverlay(m_guidance->overlay());
}

void ReviewPage::pointAt(std::size_t view, const QPointF &pixel, const QPoint &global)
{
    if (m_guidance->isDrawing()) {
        m_guidance->addCorner(view, pixel);
        return;
    }
    m_timeline->pause();
    QMenu menu;
    m_pointing->fill(menu, view, pixel);
    if (!m_pointing->action()->isChecked())
        m_guidance->fill(menu, view, pixel);
    if (!menu.isEmpty())
        menu.exec(global);
}

void ReviewPage::guide(const QString &trial, const GuidanceEdit &edit)
{
    if (const auto done = changeGuidance(m_project, trial.toStdString(), edit); !done)
        Q_EMIT failed(done.error());
    else
        Q_EMIT changed();
}

Result<void> ReviewPage::showTrial(const QString &name)
{
    ODO_TRY(m_project.trials().find(name.toStdString()));
    m_chosen = name;
    m_chooser->setCurrent(name);
    load();
    return {};
}

QList<QAction *> ReviewPage::spikeActions() const
{
    return m_spikes->actions() + m_column->spikes().selectActions();
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
Result<ReviewPage::Reading> ReviewPage::readTrial(Project &project, const Request &request)
{
    Reading reading{std::nullopt, nullptr};
    std::string name = request.chosen;
    if (name.empty() && request.shown != 0) // it may have another name now
        if (const auto shown = project.trials().get(request.shown))
            name = shown->name;
    if (request.withList) {
        std::vector<TrialName> trials = ODO_TRY(project.trials().names());
        reading.list.emplace();
        std::map<std::string, QString> shownTeams; // by name
        for (const TeamRecord &team : project.teams().all().value_or(std::vector<TeamRecord>()))
            shownTeams[team.name] = shownTeam(team);
        std::string newest;
        bool isThere = !request.chosen.empty();
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
    const Request request{m_chosen.toStdString(), m_scene ? m_scene->trial.id : 0, m_isListStale};
    m_reader->read<Reading>([request](Project &project) { return readTrial(project, request); },
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
    m_guidance->setScene(m_scene);
    m_range->setScene(m_scene);
    m_column->setScene(m_scene);
    m_chooser->setCurrent(trial());
    m_stack->setCurrentIndex(m_scene ? 0 : 1);
    Q_EMIT trialShown();
    showSettled();
}

/// Accepts a doubtful verdict for a reason that a person gives, or withdraws that.
void ReviewPage::judgeVerdict()
{
    const std::string trial = m_scene->trial.name;
    Result<void> done;
    if (m_scene->verdict.isAccepted()) {
        done = withdrawAcceptance(m_project, trial);
    } else {
        bool isGiven = false;
        const QString reason =
            QInputDialog::getText(this, tr("Accept doubtful results"),
                                  tr("Why can these results be used? The reason is shown wherever they are."),
                                  QLineEdit::Normal, {}, &isGiven);
        if (!isGiven)
            return;
        done = acceptVerdict(m_project, trial, reason.toStdString());
    }
    if (done)
        Q_EMIT changed();
    else
        Q_EMIT failed(done.error());
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

namespace {

constexpr int columnWidth = 308;

bool isTracked(const TrialScene &scene)
{
    return std::any_of(scene.robots.begin(), scene.robots.end(),
                       [](const SceneRobot &robot) { return robot.analysis.has_value(); });
}

} // namespace

ReviewColumn::ReviewColumn(Timeline &timeline, QWidget *chooser, QWidget *parent)
    : QWidget(parent), m_whyTrack(new QLabel), m_track(makeTrackCard()), m_result(new ResultPanel),
      m_spikes(new SpikeList(timeline)), m_range(new RangeCard(timeline)), m_trial(new Card(tr("Trial"))),
      m_facts(new FactList(FactList::Badges::Beneath))
{
    auto *scroll = scrolled(m_facts, tr("Facts of the trial"));
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_trial->setContent(scroll);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(chooser);
    layout->addWidget(m_track);
    layout->addWidget(m_result);
    layout->addWidget(m_spikes, 2);
    layout->addWidget(m_range, 5);
    layout->addWidget(m_trial, 3);
    connect(m_range, &RangeCard::shownChanged, m_trial, &QWidget::setHidden);
    connect(m_facts, &FactList::actionRequested, this, &ReviewColumn::verdictRequested);
    setFixedWidth(columnWidth);
    setScene(nullptr);
}

Card *ReviewColumn::makeTrackCard()
{
    auto *content = new QWidget;
    m_whyTrack->setTextFormat(Qt::PlainText);
    m_whyTrack->setWordWrap(true);
    auto *button = new QPushButton(themeIcon(QStringLiteral("track"), Qt::white), tr("Track…"));
    button->setObjectName(QStringLiteral("trackButton"));
    button->setProperty("primary", true);
    button->setMinimumHeight(40);
    connect(button, &QPushButton::clicked, this, &ReviewColumn::trackRequested);
    auto *layout = new QVBoxLayout(content);
    layout->setContentsMargins(12, 10, 12, 12);
    layout->setSpacing(10);
    layout->addWidget(m_whyTrack);
    layout->addWidget(button);
    auto *card = new Card(tr("Result"));
    card->setContent(content);
    return card;
}

void ReviewColumn::setScene(const TrialScenePtr &scene)
{
    const bool tracked = scene && isTracked(*scene);
    m_track->setVisible(scene && (!tracked || scene->isGuidanceNew));
    m_whyTrack->setText(
        tracked ? tr("The areas have changed since this trial was tracked. Track it again to use them.")
                : tr("This trial has not been tracked yet. Tracking follows the robot through the videos and "
                     "computes its position and speed."));
    m_result->setVisible(tracked);
    m_spikes->setVisible(tracked);
    m_result->setScene(scene);
    m_spikes->setScene(scene);
    m_range->setScene(scene);
    m_facts->setFacts(scene ? trialFacts(*scene) : QList<Fact>());
}

namespace {

QToolButton *buttonFor(QAction *action, QWidget *parent)
{
    auto *button = new QToolButton(parent);
    button->setDefaultAction(action);
    button->setProperty("flat", true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setAccessibleName(action->text().remove(QLatin1Char('&')));
    return button;
}

} // namespace

TrialChooser::TrialChooser(QWidget *parent)
    : QWidget(parent), m_trials(new QComboBox(this)),
      m_previous(new QAction(themeIcon(QStringLiteral("previous")), tr("&Previous trial"), this)),
      m_next(new QAction(themeIcon(QStringLiteral("next")), tr("&Next trial"), this))
{
    m_trials->setAccessibleName(tr("Trial"));
    // chosen from by the mouse it takes no focus, and Space goes on playing
    m_trials->setFocusPolicy(Qt::TabFocus);
    m_trials->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_trials->setMinimumContentsLength(8);
    nameCommands({{m_previous, "previousTrial"}, {m_next, "nextTrial"}});
    m_previous->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageUp));
    m_next->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_PageDown));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttonFor(m_previous, this));
    layout->addWidget(m_trials, 1);
    layout->addWidget(buttonFor(m_next, this));
    connect(m_trials, &QComboBox::activated, this,
            [this](int index) { Q_EMIT chosen(m_trials->itemData(index).toString()); });
    connect(m_previous, &QAction::triggered, this, [this] { step(-1); });
    connect(m_next, &QAction::triggered, this, [this] { step(1); });
    updateActions();
}

void TrialChooser::setTrials(const QStringList &names, const QStringList &words)
{
    const QString current = m_trials->currentData().toString();
    m_trials->setModel(new NameListModel(names, words, m_trials)); // the one before goes with it
    setCurrent(current);
}

void TrialChooser::setCurrent(const QString &name)
{
    const auto *model = qobject_cast<NameListModel *>(m_trials->model());
    m_trials->setCurrentIndex(model ? model->indexOf(name) : -1);
    m_trials->setToolTip(m_trials->currentText().toHtmlEscaped());
    updateActions();
}

void TrialChooser::step(int by)
{
    const int index = m_trials->currentIndex() + by;
    if (index >= 0 && index < m_trials->count())
        Q_EMIT chosen(m_trials->itemData(index).toString());
}

void TrialChooser::updateActions()
{
    m_previous->setEnabled(m_trials->currentIndex() > 0);
    m_next->setEnabled(m_trials->currentIndex() >= 0 && m_trials->currentIndex() + 1 < m_trials->count());
    m_trials->setEnabled(m_trials->count() > 0);
}

} // namespace odo
