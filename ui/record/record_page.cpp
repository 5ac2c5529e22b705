// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_page.h"

#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/models/shown_names.h"
#include "ui/record/internal/health_watch.h"
#include "ui/record/internal/live_board.h"
#include "ui/record/internal/run_card.h"
#include "ui/record/internal/run_presentation.h"
#include "ui/record/internal/run_recorder.h"
#include "ui/record/internal/run_results.h"
#include "ui/record/internal/running_cameras.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/empty_state.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <algorithm>

namespace odo {

namespace {

constexpr int tickMs = 50, healthEachTicks = 10;
constexpr int columnWidth = 320;
// Beyond what is to be recorded before a start: what a gate, or the project, takes to begin it.
constexpr Nanoseconds keptBesides = std::chrono::seconds(4);

} // namespace

RecordPage::RecordPage(Project &project, bool readOnly, CameraAccess access, QWidget *parent)
    : QWidget(parent), m_project(project), m_cameras(project, std::move(access), this), m_control(steadyNow),
      m_recorder(new RunRecorder(project.file(), this)), m_warningBar(new WarningBar), m_start(new StartCard),
      m_run(new RunCard), m_result(new RunResultCard), m_results(new RunResults(project, *m_result, this)),
      m_empty(new EmptyState(QStringLiteral("camera"), tr("No camera is connected"),
                             tr("Connect one or two cameras, then search again. If a connected camera is not "
                                "found, run the set-up doctor."))),
      m_stack(new QStackedWidget(this))
{
    setObjectName(QStringLiteral("page"));
    setFocusProxy(m_start->button());
    makeActions();
    m_board = new LiveBoard(m_actions.mid(1));
    m_presentation = new RunPresentation(*m_board, *m_run, this);
    m_health = std::make_unique<HealthWatch>(project, readOnly, m_cameras, *m_board, *m_warningBar);
    auto *content = new QWidget;
    auto *row = new QHBoxLayout;
    row->setContentsMargins(8, 8, 8, 8);
    row->setSpacing(8);
    row->addWidget(m_board, 1);
    row->addWidget(makeColumn());
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->setSpacing(0);
    contentLayout->addWidget(m_warningBar);
    contentLayout->addLayout(row, 1);
    connect(m_empty->addButton(QStringLiteral("search"), tr("Search again")), &QPushButton::clicked,
            &m_cameras, &ChosenCameras::poll);
    connect(m_empty->addButton(QStringLiteral("doctor"), tr("Set-up doctor…")), &QPushButton::clicked, this,
            &RecordPage::examine);
    connect(m_empty->addButton(QStringLiteral("camera"), tr("Cameras…")), &QPushButton::clicked, this,
            &RecordPage::chooseCameras);
    m_stack->addWidget(content);
    m_stack->addWidget(m_empty);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_stack);
    m_timer.setInterval(tickMs);
    connectAll();
    showStart();
}

RecordPage::~RecordPage()
{
    m_timer.stop();
    // Completes the recording; this needs the cameras and emits no more signals.
    m_recorder->disconnect(this);
    delete m_recorder;
}

void RecordPage::makeActions()
{
    auto *cameras = new QAction(themeIcon(QStringLiteral("camera")), tr("Choose &cameras…"), this);
    cameras->setIconText(tr("Cameras…"));
    cameras->setToolTip(tr("Assign the connected devices to the cameras of the project"));
    connect(cameras, &QAction::triggered, this, &RecordPage::chooseCameras);
    auto *doctor = new QAction(themeIcon(QStringLiteral("doctor")), tr("Set-up &doctor…"), this);
    doctor->setIconText(tr("Doctor…"));
    doctor->setToolTip(tr("Check for what makes cameras lose frames or measure wrongly, and get advice"));
    connect(doctor, &QAction::triggered, this, &RecordPage::examine);
    nameCommands({{cameras, "chooseCameras"}, {doctor, "doctor"}});
    m_actions = {m_start->action(), cameras, doctor};
    addAction(m_start->action());
}

QWidget *RecordPage::makeColumn()
{
    auto *cards = new QWidget;
    cards->setObjectName(QStringLiteral("cardBody"));
    auto *layout = new QVBoxLayout(cards);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_start);
    layout->addWidget(m_run);
    layout->addWidget(m_result, 1);
    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(cards);
    scroll->setFixedWidth(columnWidth);
    scroll->setFocusPolicy(Qt::NoFocus);
    return scroll;
}

void RecordPage::connectCameras()
{
    RunningCameras *running = &m_cameras.running();
    connect(&m_cameras, &ChosenCameras::failed, this, &RecordPage::failed);
    connect(&m_cameras, &ChosenCameras::noneConnected, this, [this] { m_stack->setCurrentIndex(1); });
    connect(&m_cameras, &ChosenCameras::starting, this, [this] {
        m_stack->setCurrentIndex(0);
        m_health->countFromOpening();
        showCameras();
    });
    connect(running, &RunningCameras::started, this, &RecordPage::showCameras);
    connect(running, &RunningCameras::failed, this, &RecordPage::failed);
    connect(running, &RunningCameras::frameReady, m_board, &LiveBoard::setImage);
    connect(running, &RunningCameras::moved, this, &RecordPage::takeMoment);
    connect(running, &RunningCameras::floorSeen, this,
            [this](const MotionSight &sight) { obey(m_control.floorAt(sight)); });
    connect(m_board, &LiveBoard::shownSizeChanged, running, &RunningCameras::setShownSize);
}

void RecordPage::connectAll()
{
    connect(&m_timer, &QTimer::timeout, this, &RecordPage::tick);
    connectCameras();
    connect(m_start, &StartCard::pressed, this, &RecordPage::press);
    connect(m_run, &RunCard::changed, this, &RecordPage::showFloor);
    connect(m_run, &RunCard::beforeChanged, this, &RecordPage::keepBefore);
    connect(m_run, &RunCard::robotsChanged, this, &RecordPage::followRobots);
    connect(m_recorder, &RunRecorder::recorded, this, &RecordPage::takeRecorded);
    connect(m_recorder, &RunRecorder::gaveUp, this, &RecordPage::takeGivenUp);
    connect(m_recorder, &RunRecorder::failed, this, &RecordPage::failed);
    connect(m_results, &RunResults::changed, this, &RecordPage::changed);
    connect(m_results, &RunResults::shown, m_presentation, &RunPresentation::setResults);
    connect(m_results, &RunResults::failed, this, &RecordPage::failed);
    connect(m_result, &RunResultCard::openRequested, this, &RecordPage::trialChosen);
    connect(m_warningBar, &WarningBar::warned, this, &RecordPage::warned);
    connect(m_warningBar, &WarningBar::clicked, this, &RecordPage::testbedRequested);
}

bool RecordPage::isRecording() const
{
    return m_recorder->isRecording() || m_recorder->isEnding();
}

void RecordPage::finishRecording()
{
    if (m_control.phase() != RunPhase::Ready)
        obey(m_control.press());
    m_recorder->finish();
}

void RecordPage::refresh()
{
    auto lineUp = LineUp::read(m_project, arePseudonymsShown());
    if (!lineUp) {
        Q_EMIT failed(lineUp.error());
        return;
    }
    m_run->setLineUp(*lineUp);
    const bool wasByPseudonym = std::exchange(m_isByPseudonym, arePseudonymsShown());
    const bool isRenamed = wasByPseudonym != m_isByPseudonym && m_control.phase() == RunPhase::Ready;
    if (!std::exchange(m_isLineUpRead, true)) {
        m_run->setRun(lineUp->first());
    } else if (isRenamed) { // the suggested name would reveal whose pseudonym it is
        NextRun run = m_run->run();
        run.trial = lineUp->freeTrialName(run.team);
        m_run->setRun(run);
    }
    if (m_cameras.session() && m_control.phase() == RunPhase::Ready && !m_recorder->isEnding())
        m_cameras.restart(); // a registration may be a new one
}

void RecordPage::showEvent(QShowEvent *)
{
    m_timer.start();
    m_cameras.want();
    m_health->watchNone();
}

/// Others may need the cameras now, unless a run goes on.
void RecordPage::hideEvent(QHideEvent *)
{
    if (isRecording() || m_control.phase() != RunPhase::Ready)
        return;
    m_timer.stop();
    m_cameras.stop();
    showStart(); // nothing can be recorded by its key now
}

void RecordPage::showCameras()
{
    m_board->setCameras(m_cameras.running());
    keepBefore();
    followRobots();
    showFloor();
    checkHealth();
}

void RecordPage::showFloor()
{
    auto scene = liveScene(m_project, m_cameras.cameras(), m_run->task());
    if (!scene) {
        Q_EMIT failed(scene.error());
        return;
    }
    m_board->setFloor(*scene);
    prepare();
    showStart();
}

/// What comes next, unless something goes on.
void RecordPage::prepare()
{
    if (m_control.phase() != RunPhase::Ready)
        return;
    m_control.prepare(m_run->settings(), m_run->task(), m_run->robots().size());
    m_cameras.running().watchFloor(m_control.needsFloorSights());
}

/// Cameras keep what is to be recorded before the next start.
void RecordPage::keepBefore()
{
    if (m_cameras.session())
        m_cameras.session()->setPreRoll(m_run->settings().before + keptBesides);
    prepare();
    showStart();
}

void RecordPage::followRobots()
{
    const std::vector<RobotRecord> robots = m_run->robots();
    m_followedSince = steadyNow();
    m_board->setRobots(robots);
    prepare();
    m_sent = SentPositions::chosen();
    m_cameras.running().setTarget(m_sent.wanted());
    if (const Result<void> following = m_cameras.running().follow(robots); !following)
        Q_EMIT failed(following.error());
    m_board->setTarget(m_cameras.running().sentStatistics() ? m_sent.wanted() : std::nullopt);
    m_run->setEnabled(m_control.phase() == RunPhase::Ready);
}

void RecordPage::followNetwork()
{
    if (m_control.phase() == RunPhase::Ready && m_cameras.session() && m_sent != SentPositions::chosen())
        followRobots();
}

void RecordPage::takeMoment(const LiveMoment &moment)
{
    m_board->addMoment(moment);
    obey(m_control.robotAt(moment.robot, moment.position));
}

void RecordPage::press()
{
    prepare();
    obey(m_control.press());
    m_results->setRecording(m_control.phase() != RunPhase::Ready);
    m_run->setEnabled(m_control.phase() == RunPhase::Ready);
    showStart();
}

void RecordPage::obey(const std::optional<RunOrder> &order)
{
    if (!order)
        return;
    if (order->kind == RunOrder::Kind::Begin)
        begin(*order);
    else if (order->kind == RunOrder::Kind::End)
        end();
    m_results->setRecording(m_control.phase() != RunPhase::Ready);
    m_run->setEnabled(m_control.phase() == RunPhase::Ready);
    showStart();
}

/// Nothing from before its robots were chosen belongs to the run.
void RecordPage::begin(const RunOrder &order)
{
    const Nanoseconds from = std::max(order.from, m_followedSince);
    std::vector<std::string> names;
    for (const WantedCamera &camera : m_cameras.cameras())
        names.push_back(camera.name);
    m_recorder->begin(m_run->run(), names, m_cameras.session(), {order.at, from});
    m_health->countFromNow();
    m_cameras.tracker()->beginRun(from);
    m_board->forgetPaths();
    m_presentation->begin();
}

void RecordPage::end()
{
    const NextRun run = m_run->run();
    const TaskRecord *task = m_run->lineUp().task(run.task);
    m_results->takeEnded(QString::fromStdString(run.trial), m_cameras.tracker()->endRun(),
                         task ? std::optional(*task) : std::nullopt);
    m_presentation->end();
    m_recorder->end();
    if (!isVisible())
        hideEvent(nullptr);
}

PresentSource &RecordPage::presentation() const
{
    return *m_presentation;
}

void RecordPage::takeRecorded(const QString &trial, const std::vector<Message> &warnings)
{
    const NextRun driven = m_run->run();
    if (auto lineUp = LineUp::read(m_project, arePseudonymsShown())) {
        m_run->setLineUp(*lineUp);
        m_run->setRun(lineUp->next(driven));
    }
    m_results->takeRecorded(trial, warnings);
    showStart();
    if (!isVisible())
        hideEvent(nullptr);
}

void RecordPage::takeGivenUp(const QString &trial, const Error &error)
{
    m_control.hasEnded();
    m_run->setEnabled(true);
    m_results->takeGivenUp(trial, error);
    showStart();
    if (!isVisible())
        hideEvent(nullptr);
}

void RecordPage::tick()
{
    obey(m_control.tick());
    if (m_control.phase() != RunPhase::Ready)
        showStart();
    if (++m_ticks % healthEachTicks == 0)
        checkHealth();
}

void RecordPage::checkHealth()
{
    if (!m_cameras.session())
        return;
    m_health->poll();
    if (m_recorder->isRecording() && m_health->hasEnded())
        obey(m_control.press());
    showStart();
}

void RecordPage::showStart()
{
    StartCard::State state;
    state.phase = m_control.phase();
    state.ending = m_recorder->isEnding();
    state.countdownLeft = m_control.countdownLeft();
    state.elapsed = m_control.elapsed();
    state.remainingTime = m_health->remainingTime();
    state.blocked = m_health->blocked();
    if (state.blocked.isEmpty() && m_run->run().trial.empty())
        state.blocked = tr("Give the trial a name");
    const RunSettings settings = m_run->settings();
    state.beforeS = settings.countdown > Nanoseconds{0} ? 0 : int(toSeconds(settings.before));
    state.gate = QString::fromStdString(m_control.startGate());
    const auto copyOf = [](const RunTrigger *trigger) {
        return trigger ? std::optional(*trigger) : std::nullopt;
    };
    state.start = copyOf(m_control.start());
    state.stop = copyOf(m_control.stop());
    const bool isFloorSeen = std::ranges::any_of(
        m_cameras.cameras(), [](const WantedCamera &camera) { return camera.floorView.has_value(); });
    if (state.blocked.isEmpty() && state.start && !isFloorSeen)
        state.blocked = tr("Register a camera to the floor, or begin at once");
    m_start->setState(state);
}

void RecordPage::chooseCameras()
{
    if (!isRecording())
        m_cameras.choose(this);
}

void RecordPage::examine()
{
    DoctorDialog(m_cameras.running(), this).exec();
}

void RecordPage::keyPressEvent(QKeyEvent *event)
{
    const RunPhase phase = m_control.phase();
    if (event->key() == Qt::Key_Escape && (phase == RunPhase::CountingDown || phase == RunPhase::Armed))
        press();
    else
        QWidget::keyPressEvent(event);
}

} // namespace odo
