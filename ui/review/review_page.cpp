// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/timeline.h"
#include "ui/review/review_column.h"
#include "ui/review/review_desk.h"
#include "ui/review/trial_chooser.h"
#include "ui/views/empty_state.h"
#include "ui/views/page_keys.h"
#include "ui/views/theme_icon.h"
#include "ui/views/timeline_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStackedWidget>
#include <ranges>

namespace odo {

ReviewPage::ReviewPage(Project &project, QWidget *parent)
    : QWidget(parent), m_project(project), m_timeline(new Timeline(this)), m_chooser(new TrialChooser),
      m_desk(new ReviewDesk(*m_timeline)), m_timelineBar(new TimelineBar(*m_timeline)),
      m_column(new ReviewColumn(*m_timeline, m_chooser)),
      m_empty(new EmptyState(
          QStringLiteral("review"), tr("No trials yet"),
          tr("A trial is one run of a robot. Bring in the videos that your cameras took of it, "
             "and it will be shown here."))),
      m_stack(new QStackedWidget(this))
{
    setObjectName(QStringLiteral("page"));
    auto *left = new QVBoxLayout;
    left->setSpacing(8);
    left->addWidget(m_desk, 1);
    left->addWidget(m_timelineBar);
    auto *content = new QWidget;
    auto *contentLayout = new QHBoxLayout(content);
    contentLayout->setContentsMargins(8, 8, 8, 8);
    contentLayout->setSpacing(8);
    contentLayout->addLayout(left, 1);
    contentLayout->addWidget(m_column);
    m_stack->addWidget(content);
    m_stack->addWidget(m_empty);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_stack);

    for (QAction *action : m_timeline->actions()) {
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
}

ReviewPage::~ReviewPage() = default;

Result<void> ReviewPage::showTrial(const QString &name)
{
    Result<TrialScenePtr> scene = loadTrialScene(m_project, name.toStdString());
    if (!scene)
        return tl::unexpected(scene.error());
    adopt(*scene);
    return {};
}

void ReviewPage::refresh()
{
    const Result<std::vector<TrialName>> trials = m_project.trials().names();
    if (!trials) {
        Q_EMIT failed(trials.error());
        return;
    }
    QStringList names, teams;
    for (const TrialName &trial : *trials | std::views::reverse) { // the chooser goes on in time
        if (trial.binned)
            continue;
        names << QString::fromStdString(trial.name);
        teams << QString::fromStdString(trial.teamName);
    }
    m_chooser->setTrials(names, teams);
    if (names.isEmpty()) {
        adopt(nullptr);
        return;
    }
    const QString shown = m_scene ? QString::fromStdString(m_scene->trial.name) : QString();
    if (const Result<void> done = showTrial(names.contains(shown) ? shown : names.back()); !done)
        Q_EMIT failed(done.error());
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
    m_column->setScene(m_scene);
    m_chooser->setCurrent(m_scene ? QString::fromStdString(m_scene->trial.name) : QString());
    m_stack->setCurrentIndex(m_scene ? 0 : 1);
    Q_EMIT trialShown();
    showSettled();
}

bool ReviewPage::isSettled() const
{
    return m_desk->isSettled();
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
