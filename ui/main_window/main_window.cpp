// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/main_window.h"

#include "core/analysis/run_differences.h"
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/compare/compare_desk.h"
#include "ui/compare/compare_page.h"
#include "ui/history/history_page.h"
#include "ui/main_window/help/help_actions.h"
#include "ui/main_window/internal/awake_watch.h"
#include "ui/main_window/internal/class_actions.h"
#include "ui/main_window/internal/file_actions.h"
#include "ui/main_window/internal/hub_actions.h"
#include "ui/main_window/internal/report_actions.h"
#include "ui/main_window/internal/start_actions.h"
#include "ui/main_window/internal/trial_actions.h"
#include "ui/main_window/internal/window_bars.h"
#include "ui/main_window/internal/window_menus.h"
#include "ui/main_window/internal/window_messages.h"
#include "ui/main_window/preferences/command_keys.h"
#include "ui/main_window/preferences/preferences_dialog.h"
#include "ui/main_window/workspace.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/models/timeline.h"
#include "ui/record/record_page.h"
#include "ui/review/corrections.h"
#include "ui/review/guidance_tool.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/testbed/testbed_page.h"
#include "ui/views/present/present_source.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"

#include <QCloseEvent>
#include <QDir>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QToolButton>

namespace odo {
namespace {
const QString geometryKey = QStringLiteral("window/geometry");
constexpr QSize usualSize(1440, 900);

tl::unexpected<Error> noProject(Message what)
{
    return fail(ErrorCode::NotFound, std::move(what), noProjectIsOpen(),
                ODO_TEXT("ui.open_its_project", "open the project that it belongs to"));
}

} // namespace

MainWindow::MainWindow()
    : m_recent(new RecentProjects(this)), m_workspace(new Workspace(this)),
      m_files(new FileActions(*m_workspace, *m_recent, *this)),
      m_trials(new TrialActions(*m_workspace, *this)), m_many(new HistoryActions(*m_workspace, *this)),
      m_class(new ClassActions(*m_workspace, *this)), m_hub(new HubActions(*m_workspace, *this)),
      m_reports(new ReportActions(*m_workspace, *this)),
      m_start(new StartActions(*m_workspace, *m_trials, *m_reports, *this)),
      m_undo(new UndoActions(*m_workspace, this)), m_views(new ViewActions(*this)),
      m_keys(new CommandKeys(this)), m_helpPanel(new HelpPanel),
      m_help(new HelpActions(*m_keys, *m_helpPanel, *this)), m_modeBar(new ModeBar),
      m_stack(new QStackedWidget), m_welcome(new WelcomePage(*m_files, *m_recent)), m_status(new StatusLine)
{
    GeneralPage::applySettings();
    setAcceptDrops(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    resize(usualSize.boundedTo(screen()->availableSize()));
    restoreGeometry(QSettings().value(geometryKey).toByteArray());
    makeCentre();
    makeMenus();
    setStatusBar(m_status);
    connectActions();
    connectJobs();
    connectHub();
    showTitle();
    showState();
}

MainWindow::~MainWindow()
{
    closePages(); // before the workspace, whose project they use
    m_hub->end();
}

void MainWindow::makeCentre()
{
    for (const Mode mode : allModes)
        m_modeBar->addMode(modeWord(mode), modeName(mode));
    m_modeBar->setModesEnabled(false);
    m_stack->addWidget(m_welcome);
    auto *right = new QVBoxLayout;
    right->setSpacing(0);
    right->addWidget(m_stack, 1);
    right->addWidget(new LessonBar(m_help->lesson()));
    auto *centre = new QWidget;
    auto *layout = new QHBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_modeBar);
    layout->addLayout(right, 1);
    layout->addWidget(m_helpPanel);
    setCentralWidget(centre);
    m_messages = new WindowMessages(*m_stack, this);
    m_status->addPermanentWidget(m_messages->bell());
    connect(m_messages, &WindowMessages::remedyWanted, this, &MainWindow::begin);
}

void MainWindow::makeMenus()
{
    m_files->fillMenu(*menuBar()->addMenu(tr("&File")), {m_reports->report(), m_reports->certificate()});
    QMenu *edit = menuBar()->addMenu(tr("&Edit"));
    m_undo->fillMenu(*edit);
    edit->addSeparator();
    edit->addAction(m_many->changes());
    edit->addSeparator();
    QAction *preferences =
        edit->addAction(tr("Pr&eferences…"), this, [this] { showPreferences(PreferencesDialog::General); });
    preferences->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Comma));
    preferences->setMenuRole(QAction::PreferencesRole);
    nameCommands({{preferences, "preferences"}});
    QMenu *ofClass = menuBar()->addMenu(tr("C&lass"));
    m_class->fillMenu(*ofClass);
    ofClass->addAction(m_many->roster());
    ofClass->addSeparator();
    ofClass->addAction(m_class->standings());
    ofClass->addAction(m_hub->hub());
    m_menus = std::make_unique<PageMenus>(*menuBar(), *m_modeBar, *m_views, *m_trials);
    m_views->addAction(m_messages->action());
    m_help->fillMenu(*menuBar()->addMenu(tr("&Help")));
    m_keys->adopt(*menuBar());
}

void MainWindow::connectActions()
{
    connect(m_modeBar, &ModeBar::chosen, this, [this](int mode) { showMode(static_cast<Mode>(mode)); });
    connect(m_welcome, &WelcomePage::recentChosen, this,
            [this](const QString &file) { beginOpening(pathOf(file)); });
    connect(m_files, &FileActions::videosDropped, m_trials, &TrialActions::askImport);
    connect(m_files, &FileActions::stillsDropped, m_start, &StartActions::calibrateBy);
    connect(m_files, &FileActions::tracksDropped, m_trials, &TrialActions::askImportTracks);
    connect(m_files, &FileActions::demoOpened, m_help, &HelpActions::beginLesson);
    connect(m_help, &HelpActions::demoWanted, m_files->demo(), &QAction::trigger);
    connect(m_files, &FileActions::failed, this, &MainWindow::showFailure);
    connect(m_files, &FileActions::done, m_messages, &WindowMessages::showDone);
    connect(m_trials, &TrialActions::failed, this, &MainWindow::showFailure);
    connect(m_trials, &TrialActions::done, m_messages, &WindowMessages::showDone);
    connect(m_reports, &ReportActions::failed, this, &MainWindow::showFailure);
    connect(m_reports, &ReportActions::done, m_messages, &WindowMessages::showDone);
    connect(m_reports, &ReportActions::letterheadRequested, this,
            [this] { showPreferences(PreferencesDialog::Reports); });
    connect(m_many, &HistoryActions::failed, this, &MainWindow::showFailure);
    connect(m_many, &HistoryActions::changed, this, [this](const DoneWork &work) {
        refreshPages();
        if (!work.words.isEmpty())
            m_messages->showDone(work);
    });
    connect(m_class, &ClassActions::changed, this, &MainWindow::refreshPages);
    connect(m_class, &ClassActions::rosterRequested, m_many, &HistoryActions::askRoster);
    connect(m_class, &ClassActions::reprocessRequested, m_many, &HistoryActions::reprocessTrials);
    connect(m_undo, &UndoActions::aboutToSearch, this, [this] {
        if (m_pages)
            m_pages->saveNotes();
    });
    connect(m_undo, &UndoActions::failed, this, &MainWindow::showFailure);
    connect(m_undo, &UndoActions::changed, this, [this](const QString &words) {
        refreshPages();
        m_messages->showDone(words);
    });
    connect(m_trials, &TrialActions::editRequested, this, [this](const QStringList &trials) {
        m_pages->saveNotes();
        m_trials->askEdit(trials);
    });
    connect(m_trials, &TrialActions::trialsEdited, this, &MainWindow::refreshPages);
    connect(m_trials, &TrialActions::robotAdded, this, &MainWindow::refreshPages);
    connect(m_trials, &TrialActions::trialImported, this, &MainWindow::showImported);
    connect(m_trials, &TrialActions::lessonChosen, m_many, &HistoryActions::importTrials);
    connect(m_trials, &TrialActions::trialTracked, this, &MainWindow::openTrial);
    connect(m_start, &StartActions::failed, this, &MainWindow::showFailure);
    connect(m_start, &StartActions::done, m_messages, &WindowMessages::showDone);
}

void MainWindow::connectJobs()
{
    connect(m_workspace, &Workspace::aboutToClose, this, &MainWindow::closePages);
    connect(m_workspace, &Workspace::opened, this, &MainWindow::makePages);
    connect(m_workspace, &Workspace::messageReady, m_messages, &WindowMessages::showDone);
    connect(m_workspace, &Workspace::jobStarted, &m_status->job(), &JobIndicator::begin);
    connect(m_workspace, &Workspace::jobProgressed, &m_status->job(), &JobIndicator::setProgress);
    connect(m_workspace, &Workspace::jobDone, &m_status->job(), &JobIndicator::end);
    connect(m_workspace, &Workspace::changed, this, [this] {
        if (!m_many->isRunning()) // of many trials, once at the end
            refreshPages();
    });
    connect(m_workspace, &Workspace::savedChanged, this, &MainWindow::showState);
    connect(m_workspace, &Workspace::lost, this, &MainWindow::rescueProject);
    connect(m_workspace, &Workspace::overwritten, this, &MainWindow::reopenProject);
    connect(m_workspace, &Workspace::jobFailed, &m_status->job(), &JobIndicator::end);
    connect(m_workspace, &Workspace::jobFailed, this, &MainWindow::showFailure);
    connect(m_workspace, &Workspace::backupFound, this, [this](const std::filesystem::path &project) {
        m_messages->offer({tr("Restore the backup"), [this, project] { m_files->beginRestoring(project); },
                           MessageAction::Ends::AfterUse});
    });
    connect(&m_status->job(), &JobIndicator::cancelRequested, m_workspace, &Workspace::cancel);
}

void MainWindow::connectHub()
{
    m_hub->setMayPublish([this] { return !isWorking(); });
    new AwakeWatch([this] { return isWorking(); }, this);
    connect(m_hub, &HubActions::changed, this, [this] {
        m_status->showHub(m_hub->words());
        if (m_pages && m_pages->isMade(Mode::History))
            m_pages->history().setHub(m_hub->address());
    });
    connect(m_hub, &HubActions::received, this, &MainWindow::refreshPages);
    connect(m_hub, &HubActions::conflictsFound, this, [this] {
        m_messages->showWarning(tr("You and another bench changed the same things. Both versions are kept."));
        m_messages->offer({tr("Show both"), [this] { m_hub->showConflicts(); }});
    });
    connect(m_status, &StatusLine::hubRequested, m_hub, &HubActions::showDialog);
}

/// The file was deleted, renamed or replaced while it was open. What still runs on it ends first.
void MainWindow::rescueProject()
{
    if (m_workspace->project()->isInPlace()) // said once more before it was rescued
        return;
    const QString name = projectName();
    if (isWorking()) {
        m_messages->showDone(tr("Another program deleted, renamed or replaced “%1”. Odograph will rescue its "
                                "contents when the running job has ended.")
                                 .arg(name));
        return;
    }
    if (m_pages)
        m_pages->saveNotes();
    if (const auto moved = m_workspace->movedTo(); moved && m_workspace->project()->emptyLog()) {
        if (const auto opened = m_workspace->open(*moved); !opened)
            showFailure(opened.error());
        else
            m_messages->showWarning(tr("Another program renamed “%1” and its videos. It is now open as “%2”.")
                                        .arg(name, projectName()));
        return;
    }
    const auto rescued = m_workspace->rescue();
    if (rescued)
        m_messages->showWarning(tr("Another program deleted, renamed or replaced “%1”. Odograph rescued its "
                                   "contents in “%2” and opened that project.")
                                    .arg(name, QString::fromStdString(rescued->filename().string())));
    else
        showFailure(rescued.error());
}

/// Another program wrote over the file while it was open: what it held before is gone.
void MainWindow::reopenProject()
{
    // said once more before it was opened again
    if (!m_workspace->project() || !m_workspace->project()->isOverwritten())
        return;
    const QString name = projectName();
    if (isWorking()) {
        m_messages->showDone(tr("Another program overwrote “%1”. Odograph will open the new contents when "
                                "the running job has ended.")
                                 .arg(name));
        return;
    }
    if (const Result<void> opened = m_workspace->reopen(); !opened) {
        m_modeBar->setModesEnabled(false);
        showTitle();
        showFailure(opened.error());
        return;
    }
    m_messages->showWarning(tr("Another program overwrote “%1” while it was open. Its earlier contents are "
                               "gone; the window shows the new ones.")
                                .arg(name));
}

QString MainWindow::projectName() const
{
    return QString::fromStdString(m_workspace->project()->file().filename().string());
}

/// On the project.
bool MainWindow::isWorking() const
{
    return m_workspace->isBusy() || (m_pages && m_pages->isRecording());
}

void MainWindow::closePages()
{
    if (!m_pages)
        return;
    m_views->setDesk(nullptr);
    m_help->setPages(nullptr);
    m_reports->setPages(nullptr);
    m_start->forgetPages();
    m_menus->clear();
    m_trials->setCurrentTrial({});
    m_trials->setChosenTrials({});
    m_pages.reset();
    m_messages->endProject();
}

void MainWindow::makePages()
{
    m_pages = std::make_unique<ProjectPages>(*m_workspace, *m_stack);
    connectPages();
    m_reports->setPages(m_pages.get());
    m_modeBar->setModesEnabled(true);
    m_messages->hideBar();
    knowTeams();
    m_pages->review();
    m_pages->makeSoon();
    showTitle();
}

void MainWindow::connectPages()
{
    connect(m_pages.get(), &ProjectPages::made, this, &MainWindow::addPage);
    connect(m_pages.get(), &ProjectPages::shown, this, [this](Mode mode) {
        m_modeBar->setCurrent(static_cast<int>(mode));
        m_menus->setShown(mode);
        if (mode == Mode::Record)
            m_pages->review().desk().setPresented(&m_pages->record().presentation());
        else if (mode == Mode::Review)
            m_pages->review().desk().setPresented(nullptr);
        showDesk(mode);
        m_trials->setChosenTrials(m_pages->chosenTrials());
    });
    connect(m_pages.get(), &ProjectPages::changed, this, &MainWindow::showState);
    connect(m_pages.get(), &ProjectPages::messageReady, m_messages,
            [this](const QString &words, const std::vector<Message> &warnings) {
                m_messages->showDone({words, warnings});
            });
    connect(m_pages.get(), &ProjectPages::warned, m_messages, &WindowMessages::keepWarning);
    connect(m_pages.get(), &ProjectPages::failed, this, &MainWindow::showFailure);
    connect(m_pages.get(), &ProjectPages::settled, this, &MainWindow::settled);
}

/// Its actions come into the menus, and go with the page.
void MainWindow::addPage(Mode mode)
{
    const auto askImport = [this] { m_trials->askImport(); };
    switch (mode) {
    case Mode::Start:
        m_start->serve(*m_pages);
        break;
    case Mode::Testbed:
        connect(&m_pages->testbed(), &TestbedPage::tasksRequested, m_class, &ClassActions::showTasks);
        break;
    case Mode::Record:
        break;
    case Mode::Review: {
        ReviewPage *review = &m_pages->review();
        connect(review, &ReviewPage::trialShown, this, &MainWindow::showTitle);
        connect(&review->timeline(), &Timeline::selectionChanged, m_trials,
                [this, review] { m_trials->setSelection(review->timeline().selection()); });
        connect(review, &ReviewPage::importRequested, m_trials, askImport);
        connect(review, &ReviewPage::trackRequested, m_trials, &TrialActions::askTrack);
        connect(&review->spikes(), &SpikeActions::requested, m_trials, &TrialActions::manualOverride);
        connect(review, &ReviewPage::rangeRequested, m_trials, &TrialActions::setRange);
        connect(&review->pointing(), &RobotPointing::requested, m_trials, &TrialActions::pointOut);
        connect(&review->guidance(), &GuidanceTool::byHandRequested, m_trials, &TrialActions::correctByHand);
        showDesk(m_pages->mode());
        m_help->setPages(m_pages.get());
        break;
    }
    case Mode::Compare:
        connect(&m_pages->compare(), &ComparePage::importRequested, m_trials, askImport);
        break;
    case Mode::History: {
        HistoryPage *history = &m_pages->history();
        history->setHub(m_hub->address());
        connect(history, &HistoryPage::teamNamesChanged, this, &MainWindow::showTitle);
        history->addEditAction(m_trials->editAction());
        connect(history, &HistoryPage::selectionChanged, this,
                [this] { m_trials->setChosenTrials(m_pages->chosenTrials()); });
        connect(history, &HistoryPage::trialsChanged, this, &MainWindow::knowTeams);
        connect(history, &HistoryPage::emptyBinRequested, m_many, &HistoryActions::emptyBin);
        connect(history, &HistoryPage::reportRequested, m_reports, &ReportActions::askTrials);
        connect(history, &HistoryPage::tableSaved, this, [this](const QString &file) {
            m_messages->showDone({tr("Table saved as %1.").arg(QDir::toNativeSeparators(file)), {}, file});
        });
        connect(history, &HistoryPage::exportRequested, m_many, &HistoryActions::exportTrials);
        connect(history, &HistoryPage::videosRequested, m_many, &HistoryActions::exportVideos);
        connect(history, &HistoryPage::reprocessRequested, m_many, &HistoryActions::reprocessTrials);
        break;
    }
    }
    m_menus->add(*m_pages, mode);
    m_keys->adopt(*menuBar());
}

/// The docks of the mode that is shown come into the menu; those of Review where it has none.
void MainWindow::showDesk(Mode mode)
{
    DockDesk *desk = &m_pages->review().desk();
    if (mode == Mode::Compare)
        desk = &m_pages->compare().desk();
    m_views->setDesk(desk, m_pages->review().desk().viewActions());
}

void MainWindow::knowTeams()
{
    Project *project = m_workspace->project();
    knowPseudonyms(project ? project->teams().all().value_or(std::vector<TeamRecord>())
                           : std::vector<TeamRecord>());
}

void MainWindow::refreshPages()
{
    knowTeams();
    if (m_pages)
        m_pages->refresh();
}

void MainWindow::showPreferences(PreferencesDialog::Page page)
{
    PreferencesDialog dialog(*m_keys, m_views->theme(), this);
    dialog.turnTo(page);
    connect(&dialog, &PreferencesDialog::themeChosen, m_views, &ViewActions::chooseTheme);
    connect(&dialog, &PreferencesDialog::styleChanged, this, &MainWindow::remakePages);
    dialog.exec();
    if (m_pages && m_pages->mode() == Mode::Record) // one that is hidden asks when it is shown
        m_pages->record().followNetwork();
}

/// Pages hold what they show in the units and colours of when they were made.
void MainWindow::remakePages()
{
    m_status->showUnits();
    if (!m_pages)
        return;
    if (m_pages->record().isRecording()) {
        m_messages->showDone(
            tr("A recording is running. The change takes effect when you reopen the project."));
        return;
    }
    const Mode mode = m_pages->mode();
    const QString trial = m_pages->review().trial();
    closePages();
    makePages();
    if (!trial.isEmpty())
        openTrial(trial);
    showMode(mode);
}

void MainWindow::openTrial(const QString &trial)
{
    if (const Result<void> shown = showTrial(trial.toStdString()); !shown)
        m_messages->showError(shown.error());
}

void MainWindow::showImported(const QString &trial)
{
    if (m_pages->mode() != Mode::Start)
        openTrial(trial);
}

void MainWindow::beginOpening(const std::filesystem::path &file)
{
    m_files->beginOpening(file);
}

Result<void> MainWindow::openProject(const std::filesystem::path &file)
{
    Result<void> opened = m_files->open(file);
    if (opened)
        m_pages->makeAll();
    return opened;
}

void MainWindow::showMode(Mode mode)
{
    if (m_pages)
        m_pages->show(mode);
}

Result<void> MainWindow::showTrial(const std::string &name)
{
    return m_pages ? m_pages->showTrial(name) : noProject(trialSubject(name));
}

Result<void> MainWindow::compareTrials(const QStringList &names)
{
    return m_pages ? m_pages->compareTrials(names) : noProject(comparisonSubject());
}

void MainWindow::finishRecording()
{
    if (!m_pages)
        return;
    m_pages->finishRecording();
    m_pages->saveNotes();
}

bool MainWindow::isSettled() const
{
    return !m_pages || m_pages->isSettled();
}

void MainWindow::showTitle()
{
    const TrialScenePtr scene = m_pages ? m_pages->scene() : nullptr;
    setWindowTitle(windowTitleOf(m_workspace->project(), scene));
    m_trials->setCurrentTrial(scene ? QString::fromStdString(scene->trial.name) : QString());
    m_trials->setChosenTrials(m_pages ? m_pages->chosenTrials() : QStringList());
    showState();
}

void MainWindow::showState()
{
    m_status->showState(*m_workspace, m_pages ? m_pages->scene() : nullptr);
}

/// What a message advises.
void MainWindow::begin(Remedy remedy, const QString &trial)
{
    if (!m_workspace->project())
        return;
    switch (remedy) {
    case Remedy::Synchronise:
        return m_trials->askSynchronise(trial);
    case Remedy::ChangeRobots:
        return m_class->showRobots();
    case Remedy::OpenTestbed:
        return showMode(Mode::Testbed);
    case Remedy::Track:
        return m_trials->askTrack(trial);
    case Remedy::FindVideos:
        return m_files->findLostVideos();
    }
}

/// The core knows teams by their names only.
void MainWindow::showFailure(const Error &error)
{
    knowTeams();
    m_messages->showError(error);
}

bool MainWindow::event(QEvent *event)
{
    if (event->type() == QEvent::ThemeChange)
        m_views->followDesktop();
    return QMainWindow::event(event);
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    QSettings().setValue(geometryKey, saveGeometry());
    if (m_pages)
        m_pages->saveLayouts();
    QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent *event)
{
    if (!localFiles(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    m_files->openDropped(localFiles(*event->mimeData()));
}

} // namespace odo
