// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/compare_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/compare/compare_column.h"
#include "ui/compare/compare_desk.h"
#include "ui/compare/compare_map.h"
#include "ui/compare/run_chooser.h"
#include "ui/models/comparison_loader.h"
#include "ui/models/timeline.h"
#include "ui/views/empty_state.h"
#include "ui/views/page_keys.h"
#include "ui/views/timeline_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>

namespace odo {

namespace {

QString choiceWords(const TrialRecord &trial, const std::string &robot)
{
    QStringList words{QString::fromStdString(trial.name)};
    if (!robot.empty())
        words << QString::fromStdString(robot);
    if (!trial.teamName.empty())
        words << QString::fromStdString(trial.teamName);
    if (!trial.task.empty())
        words << QString::fromStdString(trial.task);
    return words.join(QStringLiteral(" · "));
}

bool areSameRuns(const CompareSettings &a, const CompareSettings &b)
{
    return std::ranges::equal(a.runs, b.runs,
                              [](const CompareSettings::Run &x, const CompareSettings::Run &y) {
                                  return x.trial == y.trial && x.robot == y.robot;
                              });
}

} // namespace

ComparePage::ComparePage(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_loader(new ComparisonLoader(project.file(), this)),
      m_timeline(new Timeline(this)), m_chooser(new RunChooser), m_desk(new CompareDesk(*m_timeline)),
      m_timelineBar(new TimelineBar(*m_timeline)), m_column(new CompareColumn(*m_timeline, m_chooser)),
      m_stack(new QStackedWidget)
{
    setObjectName(QStringLiteral("page"));
    auto *content = new QWidget;
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->setSpacing(8);
    contentLayout->addWidget(m_desk, 1);
    contentLayout->addWidget(m_timelineBar);
    m_stack->addWidget(content);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(8);
    layout->addWidget(m_stack, 1);
    layout->addWidget(m_column);

    for (QAction *action : m_timeline->actions()) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
    }
    connect(m_loader, &ComparisonLoader::loaded, this, &ComparePage::adopt);
    connect(m_loader, &ComparisonLoader::failed, this, [this](const Error &error) {
        showNone(tr("These runs cannot be compared"),
                 tr("%1. What helps: %2.")
                     .arg(QString::fromStdString(error.why), QString::fromStdString(error.advice)),
                 false);
    });
    connect(m_chooser, &RunChooser::runsChanged, this, [this] {
        m_chooser->alignAutomatically();
        load();
    });
    connect(m_chooser, &RunChooser::alignmentChanged, this, &ComparePage::load);
    connect(m_desk, &CompareDesk::gatesMoved, m_column, &CompareColumn::setGates);
    connect(m_desk, &CompareDesk::settled, this, &ComparePage::showSettled);
    adopt(nullptr);
}

ComparePage::~ComparePage() = default;

std::vector<TrialRecord> ComparePage::readTrials()
{
    auto trials = m_project.trials().all();
    if (trials) {
        std::erase_if(*trials, [](const TrialRecord &trial) { return trial.binned.has_value(); });
        return std::move(*trials);
    }
    Q_EMIT failed(trials.error());
    return {};
}

void ComparePage::refresh()
{
    QList<RunChoice> choices;
    for (const TrialRecord &trial : readTrials()) { // newest first; the list goes on in time
        if (trial.robotNames.size() < 2)
            choices.prepend({{trial.name, {}}, choiceWords(trial, {})});
        else
            for (auto robot = trial.robotNames.rbegin(); robot != trial.robotNames.rend(); ++robot)
                choices.prepend({{trial.name, *robot}, choiceWords(trial, *robot)});
    }
    m_chooser->setChoices(std::move(choices));
    m_isStale = true;
    if (isVisible())
        load();
}

void ComparePage::showTrials(const QStringList &trials)
{
    std::vector<CompareSettings::Run> runs;
    for (const QString &trial : trials)
        runs.push_back({trial.toStdString(), {}});
    if (runs.size() == 1)
        if (const auto partner = partnerOf(runs.front().trial))
            runs.push_back({*partner, {}});
    m_chooser->setRuns(runs);
    m_chooser->alignAutomatically();
    m_isStale = true;
    if (isVisible())
        load();
}

void ComparePage::suggestTrial(const QString &trial)
{
    if (m_chooser->runs().size() < 2 && !trial.isEmpty())
        showTrials({trial});
}

/// The newest other trial of the same task that was tracked, or else the newest other one that was.
std::optional<std::string> ComparePage::partnerOf(const std::string &name)
{
    constexpr int mostAsked = 40; // a year's trials need not be gone through for a suggestion
    const std::vector<TrialRecord> trials = readTrials();
    const auto self = std::ranges::find(trials, name, &TrialRecord::name);
    if (self == trials.end())
        return std::nullopt;
    for (const bool sameTask : {true, false}) {
        int asked = 0;
        for (const TrialRecord &trial : trials) {
            if (trial.id == self->id || (trial.task == self->task) != sameTask || ++asked > mostAsked)
                continue;
            const auto analyses = m_project.analyses().currentMetrics(trial.id);
            if (analyses && !analyses->empty())
                return trial.name;
        }
    }
    return std::nullopt;
}

void ComparePage::load()
{
    m_isStale = false;
    CompareSettings settings;
    settings.runs = m_chooser->runs();
    settings.alignBy = m_chooser->alignBy();
    if (settings.runs.size() < 2) {
        showNone(tr("Two runs are needed"),
                 tr("Comparing shows where one run is faster than another, and whether that is more than the "
                    "error. "
                    "Choose two trials that have been tracked, or bring in another one."),
                 true);
        return;
    }
    if (settings.alignBy == AlignBy::ByHand) {
        if (m_handTimesS.size() != settings.runs.size()) {
            m_chooser->alignAutomatically();
            settings.alignBy.reset();
        } else {
            settings.handTimesS = m_handTimesS;
            settings.handTimesS[1] += m_chooser->shiftS();
        }
    }
    m_loader->load(std::move(settings));
}

void ComparePage::adopt(ComparisonScenePtr scene)
{
    const bool sameRuns = m_scene && scene && areSameRuns(m_scene->settings, scene->settings);
    const Nanoseconds time = sameRuns ? m_timeline->currentTime() : Nanoseconds(0);
    m_scene = std::move(scene);
    if (m_scene && m_scene->compared.comparison.alignedBy != AlignBy::ByHand) {
        m_handTimesS.clear();
        for (const RunOnPath &run : m_scene->compared.comparison.runs)
            m_handTimesS.push_back(run.aligned.timeS);
    }
    if (m_scene && !m_scene->settings.alignBy)
        m_chooser->setAlignedBy(m_scene->compared.comparison.alignedBy);
    m_timeline->setFrameTimes(m_scene ? m_scene->frameTimes() : std::vector<Nanoseconds>());
    m_desk->setScene(m_scene);
    m_column->setScene(m_scene);
    m_timeline->setCurrentTime(time);
    if (m_scene)
        m_stack->setCurrentIndex(0);
    showSettled();
}

void ComparePage::showNone(const QString &headline, const QString &why, bool mayImport)
{
    adopt(nullptr);
    while (m_stack->count() > 1)
        delete m_stack->widget(1);
    auto *none = new EmptyState(QStringLiteral("compare"), headline, why);
    if (mayImport)
        connect(none->addButton(QStringLiteral("import"), tr("Import trial from videos…")),
                &QPushButton::clicked, this, &ComparePage::importRequested);
    m_stack->addWidget(none);
    m_stack->setCurrentIndex(1);
}

bool ComparePage::isSettled() const
{
    return !m_isStale && !m_loader->isRunning() && m_desk->isSettled();
}

void ComparePage::showSettled()
{
    if (isSettled())
        Q_EMIT settled();
}

void ComparePage::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (m_isStale)
        load();
}

bool ComparePage::event(QEvent *event)
{
    return keepSpaceForFocus(*event) || QWidget::event(event);
}

} // namespace odo
