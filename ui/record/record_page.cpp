// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_page.h"

#include "core/base/steady_now.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/record/camera_choice_dialog.h"
#include "ui/record/doctor_dialog.h"
#include "ui/record/health_words.h"
#include "ui/record/live_board.h"
#include "ui/record/live_scene.h"
#include "ui/record/run_card.h"
#include "ui/record/run_measuring.h"
#include "ui/record/run_recorder.h"
#include "ui/record/start_card.h"
#include "ui/record/trouble_bar.h"
#include "ui/views/empty_state.h"
#include "ui/views/theme_icon.h"

#include <QAction>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <algorithm>

namespace odo {
namespace {

constexpr int tickMs = 50, healthEachTicks = 10, retryMs = 3000;
constexpr int columnWidth = 320;
constexpr std::ptrdiff_t leastSightings = 10;

bool wasSeen(const LiveRun &run)
{
    return std::ranges::any_of(run.views, [](const ViewTrack &view) {
        return std::ranges::count_if(view.observations, &Observation::found) >= leastSightings;
    });
}

QString sentence(QString words)
{
    if (!words.isEmpty() && !words.endsWith(u'.'))
        words += u'.';
    if (!words.isEmpty())
        words.front() = words.front().toUpper();
    return words;
}

} // namespace

RecordPage::RecordPage(Project &project, bool readOnly, CameraAccess access, QWidget *parent)
    : QWidget(parent), m_project(project), m_readOnly(readOnly), m_connected(std::move(access.list)),
      m_cameras(std::move(access.open)), m_control(steadyNow), m_recorder(new RunRecorder(project, this)),
      m_measuring(new RunMeasuring(project, this)), m_troubleBar(new TroubleBar), m_start(new StartCard),
      m_run(new RunCard), m_result(new RunResultCard),
      m_empty(new EmptyState(QStringLiteral("camera"), tr("No camera is connected"),
                             tr("Connect a camera, or two, and look again. One that is connected and not "
                                "found is a case for the set-up doctor."))),
      m_stack(new QStackedWidget(this))
{
    setObjectName(QStringLiteral("page"));
    setFocusProxy(m_start->button());
    makeActions();
    m_board = new LiveBoard(m_actions.mid(1));
    auto *content = new QWidget;
    auto *row = new QHBoxLayout;
    row->setContentsMargins(8, 8, 8, 8);
    row->setSpacing(8);
    row->addWidget(m_board, 1);
    row->addWidget(makeColumn());
    auto *contentLayout = new QVBoxLayout(content);
    contentLayout->setContentsMargins(0, 0, 0, 0);
    contentLayout->setSpacing(0);
    contentLayout->addWidget(m_troubleBar);
    contentLayout->addLayout(row, 1);
    connect(m_empty->addButton(QStringLiteral("search"), tr("Look again")), &QPushButton::clicked,
            &m_connected, &LiveCameras::look);
    connect(m_empty->addButton(QStringLiteral("doctor"), tr("Set-up doctor…")), &QPushButton::clicked, this,
            &RecordPage::examine);
    m_stack->addWidget(content);
    m_stack->addWidget(m_empty);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_stack);
    m_timer.setInterval(tickMs);
    m_retry.setInterval(retryMs);
    m_retry.setSingleShot(true);
    connectAll();
    showStart();
}

RecordPage::~RecordPage()
{
    m_timer.stop();
    // Completes what is being recorded, which needs the cameras and is told to nobody any more.
    m_recorder->disconnect(this);
    delete m_recorder;
}

void RecordPage::makeActions()
{
    auto *cameras = new QAction(themeIcon(QStringLiteral("camera")), tr("Choose &cameras…"), this);
    cameras->setIconText(tr("Cameras…"));
    cameras->setToolTip(tr("Choose which connected device is which camera of the project"));
    connect(cameras, &QAction::triggered, this, &RecordPage::chooseCameras);
    auto *doctor = new QAction(themeIcon(QStringLiteral("doctor")), tr("Set-up &doctor…"), this);
    doctor->setIconText(tr("Doctor…"));
    doctor->setToolTip(tr("Look for what makes cameras lose pictures, or measure wrongly, with advice"));
    connect(doctor, &QAction::triggered, this, &RecordPage::examine);
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

void RecordPage::connectAll()
{
    connect(&m_timer, &QTimer::timeout, this, &RecordPage::tick);
    connect(&m_retry, &QTimer::timeout, this, &RecordPage::startCameras);
    connect(&m_connected, &LiveCameras::changed, this, [this] {
        if (isVisible() && !m_connected.isLooking() && !m_cameras.session() && !m_cameras.isOpening())
            startCameras();
    });
    connect(&m_cameras, &RunningCameras::started, this, &RecordPage::showCameras);
    connect(&m_cameras, &RunningCameras::failed, this, [this](const Error &error) {
        m_cameraFailure = error;
        if (!m_cameras.session())
            m_retry.start();
        showTrouble({});
        showStart();
    });
    connect(&m_cameras, &RunningCameras::pictureReady, m_board, &LiveBoard::setPicture);
    connect(m_board, &LiveBoard::shownSizeChanged, this,
            [this](std::size_t view, const QSize &pixels) { m_cameras.setShownSize(view, pixels); });
    connect(&m_cameras, &RunningCameras::moved, this, &RecordPage::takeMoment);
    connect(m_start, &StartCard::pressed, this, &RecordPage::press);
    connect(m_run, &RunCard::changed, this, &RecordPage::showFloor);
    connect(m_run, &RunCard::robotsChanged, this, &RecordPage::followRobots);
    connect(m_recorder, &RunRecorder::recorded, this, &RecordPage::takeRecorded);
    connect(m_recorder, &RunRecorder::failed, this, &RecordPage::failed);
    connect(m_measuring, &RunMeasuring::measuredLive, this,
            [this](const QString &trial, const auto &results) {
                if (m_result->trial() == trial)
                    m_result->setResults(trial, results, RunResultCard::From::Live);
            });
    connect(m_measuring, &RunMeasuring::measured, this,
            [this](const QString &trial, const auto &results, const QStringList &warnings) {
                if (m_result->trial() == trial)
                    m_result->setResults(trial, results, RunResultCard::From::Recording);
                QStringList sentences{tr("%1 is measured.").arg(trial)};
                for (const QString &warning : warnings)
                    sentences << sentence(warning);
                Q_EMIT changed(sentences.join(u' '));
            });
    connect(m_measuring, &RunMeasuring::failed, this, [this](const QString &trial, const Error &error) {
        if (m_result->trial() == trial)
            m_result->setFailure(trial, tr("It is recorded, but could not be measured: %1")
                                            .arg(sentence(QString::fromStdString(error.message()))));
        Q_EMIT failed(error);
    });
    connect(m_result, &RunResultCard::openRequested, this, &RecordPage::trialChosen);
    connect(m_troubleBar, &TroubleBar::clicked, this, &RecordPage::testbedRequested);
}

bool RecordPage::isRecording() const
{
    return m_recorder->isRecording() || m_recorder->isEnding();
}

void RecordPage::refresh()
{
    auto lineUp = LineUp::read(m_project);
    if (!lineUp) {
        Q_EMIT failed(lineUp.error());
        return;
    }
    m_run->setLineUp(*lineUp);
    if (!std::exchange(m_isLineUpRead, true))
        m_run->setRun(lineUp->first());
    if (m_cameras.session() && m_control.phase() == RunPhase::Ready && !m_recorder->isEnding())
        startCameras(); // a registration may be a new one
}

void RecordPage::showEvent(QShowEvent *)
{
    m_timer.start();
    if (!m_cameras.session() && !m_cameras.isOpening())
        m_connected.look();
    showTrouble({});
}

/// Others may need the cameras now, unless a run goes on.
void RecordPage::hideEvent(QHideEvent *)
{
    if (isRecording() || m_control.phase() != RunPhase::Ready)
        return;
    m_retry.stop();
    m_timer.stop();
    m_cameras.stop();
    showStart(); // nothing can be recorded by its key now
}

void RecordPage::startCameras()
{
    m_cameraFailure.reset();
    const auto cameras = m_project.cameras().all();
    if (!cameras) {
        Q_EMIT failed(cameras.error());
        return;
    }
    if (m_chosen.empty() ||
        std::ranges::all_of(m_chosen, [](const ChosenCamera &camera) { return camera.second.empty(); }))
        m_chosen = proposeCameras(*cameras, m_connected.cameras(), rememberedCameras());
    auto wanted = wantedCameras(m_project, m_chosen);
    if (!wanted) {
        Q_EMIT failed(wanted.error());
        return;
    }
    m_stack->setCurrentIndex(wanted->empty() ? 1 : 0);
    if (wanted->empty())
        return;
    m_before = {};
    m_cameras.start(std::move(*wanted), m_run->robots());
    showCameras();
}

void RecordPage::showCameras()
{
    m_board->setCameras(m_cameras);
    followRobots();
    showFloor();
    showHealth();
}

void RecordPage::showFloor()
{
    auto scene = liveScene(m_project, m_cameras.cameras(), m_run->task());
    if (!scene) {
        Q_EMIT failed(scene.error());
        return;
    }
    m_board->setFloor(*scene);
    if (m_control.phase() == RunPhase::Ready)
        m_control.prepare(m_run->settings(), m_run->task(), m_run->robots().size());
    showStart();
}

void RecordPage::followRobots()
{
    const std::vector<RobotRecord> robots = m_run->robots();
    m_board->setRobots(robots);
    if (m_control.phase() == RunPhase::Ready)
        m_control.prepare(m_run->settings(), m_run->task(), robots.size());
    if (const Result<void> following = m_cameras.follow(robots); !following)
        Q_EMIT failed(following.error());
    m_run->setEnabled(m_control.phase() == RunPhase::Ready);
}

void RecordPage::takeMoment(const LiveMoment &moment)
{
    m_board->addMoment(moment);
    obey(m_control.robotAt(moment.robot, moment.position));
}

void RecordPage::press()
{
    if (m_control.phase() == RunPhase::Ready)
        m_control.prepare(m_run->settings(), m_run->task(), m_run->robots().size());
    obey(m_control.press());
    m_measuring->setRecording(m_control.phase() != RunPhase::Ready);
    m_run->setEnabled(m_control.phase() == RunPhase::Ready);
    showStart();
}

void RecordPage::obey(const std::optional<RunOrder> &order)
{
    if (!order)
        return;
    if (order->kind == RunOrder::Kind::Begin)
        begin(order->from);
    else if (order->kind == RunOrder::Kind::End)
        end();
    m_measuring->setRecording(m_control.phase() != RunPhase::Ready);
    m_run->setEnabled(m_control.phase() == RunPhase::Ready);
    showStart();
}

void RecordPage::begin(Nanoseconds from)
{
    std::vector<std::string> names;
    for (const WantedCamera &camera : m_cameras.cameras())
        names.push_back(camera.name);
    const auto begun = m_recorder->begin(m_run->run(), names, m_cameras.session(),
                                         std::max(Nanoseconds{0}, steadyNow() - from));
    if (!begun) {
        m_control.hasEnded();
        Q_EMIT failed(begun.error());
        return;
    }
    m_before = m_cameras.session()->health();
    m_cameras.tracker()->beginRun(from);
    m_board->forgetWays();
}

void RecordPage::end()
{
    const NextRun run = m_run->run();
    const QString trial = QString::fromStdString(run.trial);
    m_result->setWorking(trial);
    const TaskRecord *task = m_run->lineUp().task(run.task);
    std::vector<LiveRun> runs = m_cameras.tracker()->endRun();
    m_seen.clear();
    for (const LiveRun &each : runs) {
        if (wasSeen(each))
            m_seen.push_back(each.robot.name);
    }
    m_measuring->measureLive(trial, std::move(runs), task ? std::optional(*task) : std::nullopt);
    m_recorder->end();
    if (!isVisible())
        hideEvent(nullptr);
}

void RecordPage::takeRecorded(const QString &trial, const QStringList &warnings)
{
    const NextRun driven = m_run->run();
    if (auto lineUp = LineUp::read(m_project)) {
        m_run->setLineUp(*lineUp);
        m_run->setRun(lineUp->next(driven));
    }
    m_measuring->track(trial, m_seen); // one that never came must not spoil the others' figures
    QStringList sentences{tr("%1 is recorded.").arg(trial)};
    for (const QString &warning : warnings)
        sentences << sentence(warning);
    Q_EMIT changed(sentences.join(u' '));
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
        showHealth();
}

void RecordPage::showHealth()
{
    if (!m_cameras.session())
        return;
    const CaptureHealth health = m_cameras.session()->health();
    const LiveFigures live = m_cameras.tracker() ? m_cameras.tracker()->figures() : LiveFigures{};
    m_board->setHealth(health, m_cameras.cameras(), live, m_before);
    m_room = QString::fromStdString(roomWords(health.disk));
    showTrouble(health);
    const bool allEnded = std::ranges::all_of(
        health.views, [](const ViewHealth &view) { return view.state == ViewHealth::State::Ended; });
    if (m_recorder->isRecording() && (health.disk.ended || allEnded))
        obey(m_control.press()); // nothing more can be recorded
    showStart();
}

void RecordPage::showTrouble(const CaptureHealth &health)
{
    const auto &cameras = m_cameras.cameras();
    QString words = troubleWords(health, cameras);
    if (words.isEmpty() && m_cameraFailure)
        words = tr("%1 It is tried again every few seconds.")
                    .arg(sentence(QString::fromStdString(m_cameraFailure->message())));
    if (m_readOnly)
        words = tr("This project can only be read: nothing can be recorded into it.");
    const QString unregistered = m_cameras.session() ? unregisteredWords(cameras) : QString();
    if (words.isEmpty() && !unregistered.isEmpty())
        m_troubleBar->setWords(unregistered, tr("&Register it in Testbed"));
    else
        m_troubleBar->setWords(words);
}

void RecordPage::showStart()
{
    StartCard::State state;
    state.phase = m_control.phase();
    state.ending = m_recorder->isEnding();
    state.countdownLeft = m_control.countdownLeft();
    state.elapsed = m_control.elapsed();
    state.room = m_room;
    if (m_readOnly)
        state.blocked = tr("The project can only be read");
    else if (!m_cameras.session())
        state.blocked = m_cameras.isOpening() || m_connected.isLooking() ? tr("Opening the cameras…")
                                                                         : tr("No camera runs");
    else if (m_run->run().trial.empty())
        state.blocked = tr("Give the trial a name");
    state.gate = QString::fromStdString(m_control.startGate());
    m_start->setState(state);
}

void RecordPage::useChoice(const std::vector<ChosenCamera> &chosen)
{
    m_chosen = chosen;
    rememberCameras(chosen);
    startCameras();
}

void RecordPage::chooseCameras()
{
    if (isRecording())
        return;
    std::vector<ChosenCamera> now = m_chosen;
    if (now.empty())
        now = proposeCameras(m_project.cameras().all().value_or(std::vector<CameraRecord>()),
                             m_connected.cameras(), rememberedCameras());
    CameraChoiceDialog dialog(now, m_connected, this);
    if (dialog.exec() == QDialog::Accepted)
        useChoice(dialog.cameras());
}

void RecordPage::examine()
{
    DoctorDialog(m_cameras, this).exec();
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
