// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/compare/compare_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/compare/compare_desk.h"
#include "ui/compare/internal/compare_column.h"
#include "ui/compare/internal/compare_map.h"
#include "ui/models/background_task.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/models/timeline.h"
#include "ui/views/charts/timeline_bar.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/empty_state.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <map>
#include <string>

namespace odo {

namespace {

bool areSameRuns(const CompareSettings &a, const CompareSettings &b)
{
    return std::ranges::equal(a.runs, b.runs,
                              [](const CompareSettings::Run &x, const CompareSettings::Run &y) {
                                  return x.trial == y.trial && x.robot == y.robot;
                              });
}

} // namespace

/// What is asked of the project.
struct ComparePage::Request
{
    CompareSettings settings;
    bool withList = false;    ///< of all runs, among which the compared ones are looked up
    bool withPartner = false; ///< with the list: for a single run another one is found
    /// of the compared trials by the names they had: they may have others now
    std::map<std::string, RecordId> ids = {};
};

/// What it gave.
struct ComparePage::Reading
{
    CompareSettings settings;
    std::optional<QList<RunChoice>> list;
    Result<ComparisonScenePtr> scene; ///< null: there are not two runs
};

ComparePage::ComparePage(Project &project, QWidget *parent)
    : QWidget(parent), m_reader(new ProjectReader(project.file(), this)), m_timeline(new Timeline(this)),
      m_chooser(new RunChooser), m_desk(new CompareDesk(*m_timeline)),
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
    connect(m_chooser, &RunChooser::runsChanged, this, [this] {
        m_runs = m_chooser->runs();
        m_wantsPartner = false;
        m_chooser->alignAutomatically();
        m_originM.reset();
        load();
    });
    connect(m_chooser, &RunChooser::alignmentChanged, this, &ComparePage::load);
    connect(m_desk, &CompareDesk::gatesMoved, m_column, &CompareColumn::setGates);
    connect(m_desk, &CompareDesk::settled, this, &ComparePage::showSettled);
    adopt(nullptr);
}

ComparePage::~ComparePage() = default;

void ComparePage::refresh()
{
    m_isListStale = true;
    load();
}

void ComparePage::showTrials(const QStringList &trials)
{
    m_runs.clear();
    for (const QString &trial : trials)
        m_runs.push_back({trial.toStdString(), {}});
    m_wantsPartner = m_runs.size() == 1;
    m_isListStale = true; // the runs are looked up in it
    m_chooser->alignAutomatically();
    m_originM.reset();
    load();
}

void ComparePage::suggestTrial(const QString &trial)
{
    if (m_runs.size() < 2 && !trial.isEmpty())
        showTrials({trial});
}

/// On the reader's thread.
Result<ComparePage::Reading> ComparePage::readRuns(Project &project, Request request)
{
    Reading reading{std::move(request.settings), std::nullopt, nullptr};
    auto &runs = reading.settings.runs;
    if (request.withList) {
        const auto trials = ODO_TRY(project.trials().all());
        reading.list = runChoices(trials);
        for (CompareSettings::Run &run : runs) {
            const auto id = request.ids.find(run.trial);
            if (id == request.ids.end())
                continue;
            const auto now = std::ranges::find(trials, id->second, &TrialRecord::id);
            if (now != trials.end())
                run.trial = now->name;
        }
        if (request.withPartner && runs.size() == 1) {
            const auto partner = ODO_TRY(partnerOf(project, trials, runs.front().trial));
            if (partner)
                runs.push_back({*partner, {}});
        }
        std::vector<CompareSettings::Run> known;
        for (const int position : paletteIndicesOf(*reading.list, runs))
            known.push_back(reading.list->at(position).run);
        runs = std::move(known);
    }
    if (runs.size() >= 2)
        reading.scene = loadComparisonScene(project, reading.settings);
    return reading;
}

void ComparePage::load()
{
    CompareSettings settings;
    settings.runs = m_runs;
    settings.alignBy = m_chooser->alignBy();
    if (settings.alignBy == AlignBy::ByHand) {
        if (m_runs.size() < 2 || m_handTimesS.size() != m_runs.size()) {
            m_chooser->alignAutomatically();
            settings.alignBy.reset();
        } else {
            settings.handTimesS = m_handTimesS;
            settings.handTimesS[1] += m_chooser->shiftS();
        }
    }
    if (settings.alignBy == AlignBy::Distance && m_originM && m_chooser->stationM())
        settings.stationM = *m_originM + *m_chooser->stationM();
    Request request{std::move(settings), m_isListStale, m_wantsPartner};
    if (m_scene)
        for (const ComparedTrial &run : m_scene->trials.runs)
            request.ids[run.trial.name] = run.trial.id;
    m_reader->read<Reading>(
        [request = std::move(request)](Project &project) { return readRuns(project, request); },
        [this](Result<Reading> reading) { take(std::move(reading)); });
}

void ComparePage::take(Result<Reading> reading)
{
    if (!reading) {
        Q_EMIT failed(reading.error());
        showSettled();
        return;
    }
    m_runs = reading->settings.runs;
    m_wantsPartner = false;
    if (reading->list) {
        m_isListStale = false;
        m_chooser->setChoices(std::move(*reading->list));
    }
    m_chooser->setRuns(m_runs);
    if (!reading->scene)
        showNone(tr("These runs cannot be compared"),
                 tr("%1. What to do: %2.")
                     .arg(shownWords(reading->scene.error().why), shownWords(reading->scene.error().advice)),
                 false);
    else if (!*reading->scene)
        showNone(tr("Select two runs"),
                 tr("A comparison shows where one run is faster than the other, and whether the difference "
                    "is significant. Select two tracked trials, or import another one."),
                 true);
    else
        adopt(*reading->scene);
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
    if (m_scene) {
        const RunComparison &comparison = m_scene->compared.comparison;
        m_originM =
            comparison.alignedBy == AlignBy::Distance ? std::optional(comparison.originM) : std::nullopt;
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
    return !m_reader->isRunning() && m_desk->isSettled();
}

void ComparePage::showSettled()
{
    if (isSettled())
        Q_EMIT settled();
}

bool ComparePage::event(QEvent *event)
{
    return keepSpaceForFocus(*event) || QWidget::event(event);
}

} // namespace odo
