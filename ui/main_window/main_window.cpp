// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/main_window.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/compare/compare_desk.h"
#include "ui/compare/compare_page.h"
#include "ui/history/history_page.h"
#include "ui/main_window/class_actions.h"
#include "ui/main_window/file_actions.h"
#include "ui/main_window/help/help_actions.h"
#include "ui/main_window/help/help_panel.h"
#include "ui/main_window/help/lesson_bar.h"
#include "ui/main_window/history_actions.h"
#include "ui/main_window/import_tracks_dialog.h"
#include "ui/main_window/job_indicator.h"
#include "ui/main_window/message_bar.h"
#include "ui/main_window/mode_bar.h"
#include "ui/main_window/preferences/command_keys.h"
#include "ui/main_window/preferences/general_page.h"
#include "ui/main_window/recent_projects.h"
#include "ui/main_window/report_actions.h"
#include "ui/main_window/transfer_actions.h"
#include "ui/main_window/trial_actions.h"
#include "ui/main_window/undo_actions.h"
#include "ui/main_window/view_actions.h"
#include "ui/main_window/welcome_page.h"
#include "ui/main_window/workspace.h"
#include "ui/models/shown_units.h"
#include "ui/models/shown_team.h"
#include "ui/models/timeline.h"
#include "ui/record/record_page.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/review/spike_actions.h"
#include "ui/review/trial_chooser.h"
#include "ui/testbed/testbed_page.h"
#include "ui/views/command_names.h"
#include "ui/views/path_field.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>

namespace odo {
namespace {
const QString geometryKey = QStringLiteral("window/geometry");
const QString projectSuffix = QStringLiteral(".odo");
constexpr QSize usualSize(1440, 900);
} // namespace

MainWindow::MainWindow()
    : m_recent(new RecentProjects(this)), m_workspace(new Workspace(this)),
      m_files(new FileActions(*m_workspace, *m_recent, *this)),
      m_trials(new TrialActions(*m_workspace, *this)), m_many(new HistoryActions(*m_workspace, *this)),
      m_class(new ClassActions(*m_workspace, *this)), m_reports(new ReportActions(*m_workspace, *this)),
      m_undo(new UndoActions(*m_workspace, this)), m_views(new ViewActions(*this)), m_keys(new CommandKeys(this)),
      m_helpPanel(new HelpPanel), m_help(new HelpActions(*m_keys, *m_helpPanel, *this)),
      m_modeBar(new ModeBar), m_messages(new MessageBar), m_stack(new QStackedWidget),
      m_welcome(new WelcomePage(*m_files, *m_recent)), m_saved(new QLabel), m_analysis(new QLabel), m_units(new QLabel),
      m_job(new JobIndicator)
{
    GeneralPage::applySettings();
    setAcceptDrops(true);
    setContextMenuPolicy(Qt::NoContextMenu);
    resize(usualSize.boundedTo(screen()->availableSize()));
    restoreGeometry(QSettings().value(geometryKey).toByteArray());
    makeCentre();
    makeMenus();
    makeStatusBar();
    connectActions();
    connectJobs();
    showTitle();
    showState();
}

MainWindow::~MainWindow()
{
    closePages(); // before the workspace, whose project they use
}

void MainWindow::makeCentre()
{
    for (const Mode mode : allModes)
        m_modeBar->addMode(modeWord(mode), modeName(mode));
    m_modeBar->setModesEnabled(false);
    m_stack->addWidget(m_welcome);
    auto *right = new QVBoxLayout;
    right->setSpacing(0);
    right->addWidget(m_messages);
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
}

void MainWindow::makeMenus()
{
    m_files->fillMenu(*menuBar()->addMenu(tr("&File")), {m_reports->report()});
    QMenu *edit = menuBar()->addMenu(tr("&Edit"));
    m_undo->fillMenu(*edit);
    edit->addSeparator();
    m_class->fillMenu(*edit);
    edit->addSeparator();
    m_many->fillMenu(*edit);
    edit->addSeparator();
    QAction *preferences = edit->addAction(tr("Pr&eferences…"), this, [this] { showPreferences(PreferencesDialog::General); });
    preferences->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Comma));
    preferences->setMenuRole(QAction::PreferencesRole);
    nameCommands({{preferences, "preferences"}});
    m_viewMenu = menuBar()->addMenu(tr("&View"));
    m_viewMenu->addActions(m_modeBar->modeActions());
    m_viewMenu->addSeparator();
    m_views->fillMenu(*m_viewMenu);
    m_viewMenu->addSeparator();
    m_trialMenu = menuBar()->addMenu(tr("T&rial"));
    m_trials->fillMenu(*m_trialMenu);
    m_trialMenu->addSeparator();
    m_spikeMenu = m_trialMenu->addMenu(tr("&Spikes"));
    m_spikeMenu->setEnabled(false);
    m_historyMenu = m_trialMenu->addMenu(tr("&History"));
    m_historyMenu->setEnabled(false);
    m_recordMenu = m_trialMenu->addMenu(tr("Re&cord"));
    m_recordMenu->setEnabled(false);
    m_playMenu = m_trialMenu->addMenu(tr("&Play"));
    m_playMenu->setEnabled(false);
    m_toolsMenu = menuBar()->addMenu(tr("&Tools"));
    m_toolsMenu->setEnabled(false);
    m_help->fillMenu(*menuBar()->addMenu(tr("&Help")));
    m_keys->adopt(*menuBar());
}

void MainWindow::makeStatusBar()
{
    m_units->setToolTip(tr("Units of lengths, speeds and times; to be chosen in the preferences"));
    showUnits();
    for (QLabel *label : {m_saved, m_analysis, m_units}) {
        label->setTextFormat(Qt::PlainText);
        label->setContentsMargins(8, 2, 8, 2);
    }
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setFixedHeight(m_job->sizeHint().height() + 6); // it must not jump when a job begins
    statusBar()->addWidget(m_saved);
    statusBar()->addWidget(m_analysis);
    statusBar()->addPermanentWidget(m_job);
    statusBar()->addPermanentWidget(m_units);
}

void MainWindow::showUnits()
{
    const ShownUnits &units = shownUnits();
    m_units->setText(QStringLiteral("%1 \u00b7 %2 \u00b7 s").arg(units.length.name, units.speed.name));
}

void MainWindow::connectActions()
{
    connect(m_modeBar, &ModeBar::chosen, this, [this](int mode) { showMode(static_cast<Mode>(mode)); });
    connect(m_welcome, &WelcomePage::recentChosen, this, [this](const QString &file) { beginOpening(pathOf(file)); });
    connect(m_files, &FileActions::demoOpened, m_help, &HelpActions::beginLesson);
    connect(m_help, &HelpActions::demoWanted, m_files->demo(), &QAction::trigger);
    connect(m_files, &FileActions::failed, this, &MainWindow::tellFailure);
    connect(m_files, &FileActions::done, m_messages, &MessageBar::showDone);
    connect(m_trials, &TrialActions::failed, this, &MainWindow::tellFailure);
    connect(m_trials, &TrialActions::done, m_messages, &MessageBar::showDone);
    connect(m_reports, &ReportActions::failed, this, &MainWindow::tellFailure);
    connect(m_reports, &ReportActions::done, m_messages, &MessageBar::showDone);
    connect(m_reports, &ReportActions::letterheadRequested, this,
            [this] { showPreferences(PreferencesDialog::Reports); });
    connect(m_many, &HistoryActions::failed, this, &MainWindow::tellFailure);
    connect(m_many, &HistoryActions::changed, this, [this](const QString &words) {
        refreshPages();
        if (!words.isEmpty())
            m_messages->showDone(words);
    });
    connect(m_class, &ClassActions::changed, this, &MainWindow::refreshPages);
    connect(m_class, &ClassActions::rosterRequested, m_many, &HistoryActions::askRoster);
    connect(m_class, &ClassActions::reprocessRequested, m_many, &HistoryActions::reprocessTrials);
    connect(m_undo, &UndoActions::aboutToLook, this, [this] {
        if (m_pages)
            m_pages->saveNotes();
    });
    connect(m_undo, &UndoActions::failed, this, &MainWindow::tellFailure);
    connect(m_undo, &UndoActions::changed, this, [this](const QString &words) {
        refreshPages();
        m_messages->showDone(words);
    });
    for (const auto signal : {&TrialActions::trialImported, &TrialActions::trialTracked})
        connect(m_trials, signal, this, &MainWindow::openTrial);
}

void MainWindow::connectJobs()
{
    connect(m_workspace, &Workspace::aboutToClose, this, &MainWindow::closePages);
    connect(m_workspace, &Workspace::opened, this, &MainWindow::makePages);
    connect(m_workspace, &Workspace::told, m_messages, &MessageBar::showDone);
    connect(m_workspace, &Workspace::jobStarted, m_job, &JobIndicator::begin);
    connect(m_workspace, &Workspace::jobProgressed, m_job, &JobIndicator::setProgress);
    connect(m_workspace, &Workspace::jobDone, m_job, &JobIndicator::end);
    connect(m_workspace, &Workspace::jobDone, this, [this] {
        if (!m_many->isRunning()) // of many trials, once at the end
            refreshPages();
    });
    connect(m_workspace, &Workspace::jobFailed, m_job, &JobIndicator::end);
    connect(m_workspace, &Workspace::jobFailed, this, &MainWindow::tellFailure);
    connect(m_job, &JobIndicator::cancelRequested, m_workspace, &Workspace::cancel);
}

void MainWindow::closePages()
{
    if (!m_pages)
        return;
    m_views->setDesk(nullptr);
    m_help->setPages(nullptr);
    m_reports->setPages(nullptr);
    m_spikeMenu->clear();
    m_playMenu->clear();
    m_recordMenu->clear();
    m_historyMenu->clear();
    m_toolsMenu->clear();
    m_trials->setCurrentTrial({});
    m_pages.reset();
}

void MainWindow::makePages()
{
    m_pages = std::make_unique<ProjectPages>(*m_workspace, *m_stack);
    connectPages();
    m_reports->setPages(m_pages.get());
    m_modeBar->setModesEnabled(true);
    m_messages->hide();
    m_pages->review();
    m_pages->makeSoon();
    showTitle();
}

void MainWindow::connectPages()
{
    connect(m_pages.get(), &ProjectPages::made, this, &MainWindow::addPage);
    connect(m_pages.get(), &ProjectPages::shown, this,
            [this](Mode mode) {
                m_modeBar->setCurrent(static_cast<int>(mode));
                m_historyMenu->setEnabled(mode == Mode::History); // it works on what is selected there
                showDesk(mode);
            });
    connect(m_pages.get(), &ProjectPages::changed, this, &MainWindow::showState);
    connect(m_pages.get(), &ProjectPages::told, m_messages, &MessageBar::showDone);
    connect(m_pages.get(), &ProjectPages::failed, this, &MainWindow::tellFailure);
    connect(m_pages.get(), &ProjectPages::settled, this, &MainWindow::settled);
}

/// Its actions come into the menus, and go with the page.
void MainWindow::addPage(Mode mode)
{
    const auto askImport = [this] { m_trials->askImport(); };
    switch (mode) {
    case Mode::Testbed:
        connect(&m_pages->testbed(), &TestbedPage::tasksRequested, m_class, &ClassActions::showTasks);
        m_toolsMenu->addActions(m_pages->testbed().toolActions());
        m_toolsMenu->setEnabled(true);
        break;
    case Mode::Record:
        m_recordMenu->addActions(m_pages->record().actions());
        m_recordMenu->setEnabled(true);
        break;
    case Mode::Review: {
        ReviewPage *review = &m_pages->review();
        connect(review, &ReviewPage::trialShown, this, &MainWindow::showTitle);
        connect(review, &ReviewPage::importRequested, m_trials, askImport);
        connect(review, &ReviewPage::trackRequested, m_trials, &TrialActions::askTrack);
        connect(&review->spikes(), &SpikeActions::said, m_trials, &TrialActions::overrule);
        m_trialMenu->insertActions(m_playMenu->menuAction(),
                                   {review->chooser().previousAction(), review->chooser().nextAction()});
        m_spikeMenu->addActions(review->spikes().actions());
        m_spikeMenu->setEnabled(true);
        m_playMenu->addActions(review->timeline().actions());
        m_playMenu->setEnabled(true);
        showDesk(m_pages->mode());
        m_help->setPages(m_pages.get());
        break;
    }
    case Mode::Compare:
        connect(&m_pages->compare(), &ComparePage::importRequested, m_trials, askImport);
        break;
    case Mode::History: {
        HistoryPage *history = &m_pages->history();
        connect(history, &HistoryPage::teamNamesChanged, this, &MainWindow::showTitle);
        connect(history, &HistoryPage::emptyBinRequested, m_many, &HistoryActions::emptyBin);
        connect(history, &HistoryPage::reportRequested, m_reports, &ReportActions::askTrials);
        connect(history, &HistoryPage::exportRequested, m_many, &HistoryActions::exportTrials);
        connect(history, &HistoryPage::videosRequested, m_many, &HistoryActions::exportVideos);
        connect(history, &HistoryPage::reprocessRequested, m_many, &HistoryActions::reprocessTrials);
        m_viewMenu->addAction(history->pseudonyms());
        m_historyMenu->addActions(history->listActions());
        break;
    }
    }
    m_keys->adopt(*menuBar());
}

/// The docks of the mode that is shown come into the menu; those of Review where it has none.
void MainWindow::showDesk(Mode mode)
{
    DockDesk *desk = &m_pages->review().desk();
    if (mode == Mode::Compare)
        desk = &m_pages->compare().desk();
    m_views->setDesk(desk, m_pages->review().desk().chartActions());
}

void MainWindow::refreshPages()
{
    if (m_pages)
        m_pages->refresh();
}

void MainWindow::showPreferences(PreferencesDialog::Page page)
{
    PreferencesDialog dialog(*m_keys, m_views->theme(), this);
    dialog.turnTo(page);
    connect(&dialog, &PreferencesDialog::themeChosen, m_views, &ViewActions::chooseTheme);
    connect(&dialog, &PreferencesDialog::lookChanged, this, &MainWindow::remakePages);
    dialog.exec();
    if (m_pages && m_pages->mode() == Mode::Record) // one that is hidden asks when it is shown
        m_pages->record().followNetwork();
}

/// Pages hold what they show in the units and colours of when they were made.
void MainWindow::remakePages()
{
    showUnits();
    if (!m_pages)
        return;
    if (m_pages->record().isRecording()) {
        m_messages->showDone(tr("The pages follow when the project is opened again, for a recording goes on."));
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
        tellFailure(shown.error());
}

void MainWindow::beginOpening(const std::filesystem::path &file)
{
    m_files->beginOpening(file);
}

Result<void> MainWindow::openProject(const std::filesystem::path &file)
{
    const Result<void> opened = m_files->open(file);
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
    if (!m_pages)
        return fail(ErrorCode::NotFound, "trial '" + name + "'", tr("no project is open").toStdString(),
                    tr("open the project that it belongs to").toStdString());
    return m_pages->showTrial(name);
}

Result<void> MainWindow::compareTrials(const QStringList &names)
{
    if (!m_pages)
        return fail(ErrorCode::NotFound, "comparison", tr("no project is open").toStdString(),
                    tr("open the project that the trials belong to").toStdString());
    return m_pages->compareTrials(names);
}

bool MainWindow::isSettled() const
{
    return !m_pages || m_pages->isSettled();
}

void MainWindow::showTitle()
{
    QStringList parts;
    QString trial;
    if (const Project *project = m_workspace->project())
        parts << QString::fromStdString(project->title());
    if (const TrialScenePtr scene = m_pages ? m_pages->scene() : nullptr) {
        const TrialRecord &record = scene->trial;
        trial = QString::fromStdString(record.name);
        QStringList words{trial};
        if (!record.teamName.empty())
            words << tr("Team %1").arg(shownTeam(record));
        parts << words.join(QStringLiteral(", "));
    }
    parts << tr("Odograph");
    // An asterisk in brackets would be taken as the place of the "changed" mark.
    setWindowTitle(parts.join(QStringLiteral(" — ")).replace(QLatin1String("[*]"), QLatin1String("[ *]")));
    m_trials->setCurrentTrial(trial);
    showState();
}

void MainWindow::showState()
{
    if (!m_workspace->project()) {
        m_saved->setText(tr("No project is open"));
        m_analysis->clear();
        return;
    }
    m_saved->setText(m_workspace->isReadOnly() ? tr("Read only: nothing can be changed")
                                               : tr("All changes saved"));
    QString analysis = tr("No trial");
    if (const TrialScenePtr scene = m_pages ? m_pages->scene() : nullptr) {
        analysis = tr("Not tracked yet");
        for (const SceneRobot &robot : scene->robots)
            if (robot.analysis)
                analysis = tr("Analysis %1, Odograph %2")
                               .arg(robot.analysis->id)
                               .arg(QString::fromStdString(robot.analysis->softwareVersion));
    }
    m_analysis->setText(analysis);
}

void MainWindow::tellFailure(const Error &error)
{
    if (error.code == ErrorCode::Cancelled)
        m_messages->showDone(tr("Cancelled. Nothing was changed."));
    else
        m_messages->showError(named(error));
}

/// As it may be shown: the core knows teams by their names only.
Error MainWindow::named(Error error) const
{
    if (!arePseudonymsShown() || !m_workspace->project())
        return error;
    const auto teams = m_workspace->project()->teams().all().value_or(std::vector<TeamRecord>());
    for (std::string *part : {&error.what, &error.why, &error.advice})
        *part = shownSentence(QString::fromStdString(*part), teams).toStdString();
    return error;
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
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent *event)
{
    QStringList files;
    for (const QUrl &url : event->mimeData()->urls())
        files << url.toLocalFile();
    event->acceptProposedAction();
    if (files.front().endsWith(projectSuffix, Qt::CaseInsensitive)) {
        beginOpening(pathOf(files.front()));
    } else if (files.front().endsWith(QLatin1String(TransferActions::archiveSuffix), Qt::CaseInsensitive)) {
        m_files->transfer().askUnpack(pathOf(files.front()));
    } else if (m_workspace->project() && !m_workspace->isReadOnly()) {
        const bool areTracks = std::ranges::all_of(files, &ImportTracksDialog::isTrackFile);
        areTracks ? m_trials->askImportTracks(files) : m_trials->askImport(files);
    }
}

} // namespace odo
