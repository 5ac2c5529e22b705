// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/start_page.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/start/internal/setup_steps.h"
#include "ui/start/internal/step_row.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace odo {

namespace {

constexpr int columnPx = 760;

} // namespace

StartPage::StartPage(Project &project, bool isReadOnly, QWidget *parent)
    : QWidget(parent), m_project(project), m_isReadOnly(isReadOnly), m_state(std::make_unique<SetupState>())
{
    setObjectName(QStringLiteral("page"));
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setAccessibleName(tr("Steps to a first result"));
    scroll->setWidgetResizable(true);
    scroll->setWidget(makeColumn());
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    setFocusProxy(scroll);
}

StartPage::~StartPage() = default;

QWidget *StartPage::makeColumn()
{
    const std::vector<std::pair<StepRow *, std::vector<std::pair<QString, Task>>>> steps{
        {addStep(QStringLiteral("camera"), tr("Cameras or clips")),
         {{tr("Import clips…"), ImportClips}, {tr("Connect cameras"), ConnectCameras}}},
        {addStep(QStringLiteral("register"), tr("Floor")),
         {{tr("Find the mat in the clips…"), FindMat},
          {tr("Print a mat…"), PrintMat},
          {tr("Use other markers…"), RegisterFloor}}},
        {addStep(QStringLiteral("calibrate"), tr("Lens (optional)")), {{tr("Calibrate…"), Calibrate}}},
        {addStep(QStringLiteral("robot"), tr("Robot")), {{tr("Add a robot…"), AddRobot}}},
        {addStep(QStringLiteral("track"), tr("First run")),
         {{tr("Track…"), TrackNewest}, {tr("Record"), RecordTrial}}},
        {addStep(QStringLiteral("print"), tr("Report")), {{tr("Report…"), MakeReport}}}};
    auto *column = new QWidget;
    column->setObjectName(QStringLiteral("page"));
    column->setMaximumWidth(columnPx);
    auto *layout = new QVBoxLayout(column);
    layout->setContentsMargins(16, 20, 16, 20);
    layout->setSpacing(10);
    auto *headline = new QLabel(tr("From clips to a first result"));
    headline->setObjectName(QStringLiteral("headline"));
    layout->addWidget(headline);
    for (const auto &[row, buttons] : steps) {
        for (const auto &[text, task] : buttons) {
            m_buttons[task] = row->addButton(text);
            connect(m_buttons[task], &QPushButton::clicked, this,
                    [this, task = task] { Q_EMIT requested(task); });
        }
        layout->addWidget(row);
    }
    layout->addStretch(1);
    auto *page = new QWidget;
    page->setObjectName(QStringLiteral("page"));
    auto *across = new QHBoxLayout(page);
    across->setContentsMargins(0, 0, 0, 0);
    across->addStretch(1);
    across->addWidget(column, 100);
    across->addStretch(1);
    return page;
}

StepRow *StartPage::addStep(const QString &icon, const QString &title)
{
    m_steps.push_back(new StepRow(icon, title));
    return m_steps.back();
}

QString StartPage::newestTrial() const
{
    return m_state->newestTrial;
}

void StartPage::refresh()
{
    auto state = readSetup(m_project);
    if (!state) {
        Q_EMIT failed(state.error());
        return;
    }
    *m_state = std::move(*state);
    show(*m_state);
}

void StartPage::show(const SetupState &state)
{
    for (const auto &[task, button] : m_buttons)
        button->setEnabled(isPossible(task, state));
    const auto next = static_cast<std::size_t>(nextStep(state));
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const StepState step = stateOf(static_cast<SetupStep>(i), state);
        m_steps[i]->setState(step.isDone, step.words);
        m_steps[i]->setNext(i == next);
    }
}

bool StartPage::isPossible(Task task, const SetupState &state) const
{
    switch (task) {
    case PrintMat:
        return true;
    case MakeReport:
        return state.isNewestMeasured;
    case FindMat:
        return !m_isReadOnly && std::ranges::any_of(state.cameras, &SetupState::Camera::hasRecording);
    case RecordTrial:
        return !m_isReadOnly && std::ranges::any_of(state.cameras, &SetupState::Camera::isConnected);
    case TrackNewest:
        return !m_isReadOnly && !state.newestTrial.isEmpty();
    case ImportClips:
    case ConnectCameras:
    case RegisterFloor:
    case Calibrate:
    case AddRobot:
        break;
    }
    return !m_isReadOnly;
}

Result<bool> isNothingMeasured(Project &project)
{
    return !ODO_TRY(readTrials(project)).isMeasured;
}

} // namespace odo
