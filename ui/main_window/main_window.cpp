// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/main_window.h"

#include "core/project/project.h"
#include "core/project/repositories.h"
#include "ui/compare/compare_desk.h"
#include "ui/compare/compare_page.h"
#include "ui/history/history_page.h"
#include "ui/main_window/file_actions.h"
#include "ui/main_window/help_dialogs.h"
#include "ui/main_window/history_actions.h"
#include "ui/main_window/job_indicator.h"
#include "ui/main_window/message_bar.h"
#include "ui/main_window/mode_bar.h"
#include "ui/main_window/recent_projects.h"
#include "ui/main_window/transfer_actions.h"
#include "ui/main_window/trial_actions.h"
#include "ui/main_window/undo_actions.h"
#include "ui/main_window/view_actions.h"
#include "ui/main_window/welcome_page.h"
#include "ui/main_window/workspace.h"
#include "ui/models/timeline.h"
#include "ui/record/record_page.h"
#include "ui/review/review_desk.h"
#include "ui/review/review_page.h"
#include "ui/review/trial_chooser.h"
#include "ui/testbed/testbed_page.h"
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
      m_undo(new UndoActions(*m_workspace, this)), m_views(new ViewActions(*this)),
      m_modeBar(new ModeBar), m_messages(new MessageBar), m_stack(new QStackedWidget),
      m_welcome(new WelcomePage(*m_files, *m_recent)), m_saved(new QLabel), m_analysis(new QLabel),
      m_job(new JobIndicator)
{
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
    m_modeBar->addMode(QStringLiteral("testbed"), tr("Testbed"));
    m_modeBar->addMode(QStringLiteral("record"), tr("Record"));
    m_modeBar->addMode(QStringLiteral("review"), tr("Review"));
    m_modeBar->addMode(QStringLiteral("compare"), tr("Compare"));
    m_modeBar->addMode(QStringLiteral("history"), tr("History"));
    m_modeBar->setModesEnabled(false);
    m_stack->addWidget(m_welcome);
    auto *right = new QVBoxLayout;
    right->setSpacing(0);
    right->addWidget(m_messages);
    right->addWidget(m_stack, 1);
    auto *centre = new QWidget;
    auto *layout = new QHBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_modeBar);
    layout->addLayout(right, 1);
    setCentralWidget(centre);
}

void MainWindow::makeMenus()
{
    m_files->fillMenu(*menuBar()->addMenu(tr("&File")));
    QMenu *edit = menuBar()->addMenu(tr("&Edit"));
    m_undo->fillMenu(*edit);
    edit->addSeparator();
    m_many->fillMenu(*edit);
    m_viewMenu = menuBar()->addMenu(tr("&View"));
    m_viewMenu->addActions(m_modeBar->modeActions());
    m_viewMenu->addSeparator();
    m_views->fillMenu(*m_viewMenu);
    m_viewMenu->addSeparator();
    m_trialMenu = menuBar()->addMenu(tr("T&rial"));
    m_trials->fillMenu(*m_trialMenu);
    m_trialMenu->addSeparator();
    m_recordMenu = m_trialMenu->addMenu(tr("Re&cord"));
    m_recordMenu->setEnabled(false);
    m_playMenu = m_trialMenu->addMenu(tr("&Play"));
    m_playMenu->setEnabled(false);
    m_toolsMenu = menuBar()->addMenu(tr("&Tools"));
    m_toolsMenu->setEnabled(false);
    QMenu *help = menuBar()->addMenu(tr("&Help"));
    QAction *keys = help->addAction(tr("&Keys"));
    keys->setShortcut(QKeySequence(Qt::Key_F1));
    connect(keys, &QAction::triggered, this, [this] { showKeys(*this); });
    connect(help->addAction(tr("&About Odograph")), &QAction::triggered, this, [this] { showAbout(*this); });
}

void MainWindow::makeStatusBar()
{
    auto *units = new QLabel(tr("mm · m/s · s"));
    units->setToolTip(tr("Units: positions in millimetres, speeds in metres a second, times in seconds"));
    for (QLabel *label : {m_saved, m_analysis, units}) {
        label->setTextFormat(Qt::PlainText);
        label->setContentsMargins(8, 2, 8, 2);
    }
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setFixedHeight(m_job->sizeHint().height() + 6); // it must not jump when a job begins
    statusBar()->addWidget(m_saved);
    statusBar()->addWidget(m_analysis);
    statusBar()->addPermanentWidget(m_job);
    statusBar()->addPermanentWidget(units);
}

void MainWindow::connectActions()
{
    connect(m_modeBar, &ModeBar::chosen, this, [this](int mode) { showMode(static_cast<Mode>(mode)); });
    connect(m_welcome, &WelcomePage::recentChosen, this, [this](const QString &file) {
        if (const Result<void> opened = openProject(pathOf(file)); !opened)
            tellFailure(opened.error());
    });
    connect(m_files, &FileActions::failed, this, &MainWindow::tellFailure);
    connect(m_files, &FileActions::done, m_messages, &MessageBar::showDone);
    connect(m_trials, &TrialActions::failed, this, &MainWindow::tellFailure);
    connect(m_trials, &TrialActions::done, m_messages, &MessageBar::showDone);
    connect(m_many, &HistoryActions::failed, this, &MainWindow::tellFailure);
    connect(m_many, &HistoryActions::changed, this, [this](const QString &words) {
        refreshPages();
        if (!words.isEmpty())
            m_messages->showDone(words);
    });
    connect(m_undo, &UndoActions::aboutToLook, this, [this] {
        if (m_history)
            m_history->saveNotes();
    });
    connect(m_undo, &UndoActions::failed, this, &MainWindow::tellFailure);
    connect(m_undo, &UndoActions::changed, this, [this](const QString &words) {
        refreshPages();
        m_messages->showDone(words);
    });
    for (const auto signal : {&TrialActions::trialImported, &TrialActions::trialTracked})
        connect(m_trials, signal, this, [this](const QString &trial) {
            if (const Result<void> shown = showTrial(trial.toStdString()); !shown)
                tellFailure(shown.error());
        });
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
    if (!m_review)
        return;
    m_views->setDesk(nullptr);
    m_playMenu->clear();
    m_recordMenu->clear();
    m_toolsMenu->clear();
    m_trials->setCurrentTrial({});
    // What is being recorded is completed before anything else goes.
    for (QWidget *page : {static_cast<QWidget *>(m_record), static_cast<QWidget *>(m_testbed), static_cast<QWidget *>(m_review),
                          static_cast<QWidget *>(m_compare), static_cast<QWidget *>(m_history)})
        delete page;
    m_testbed = nullptr;
    m_record = nullptr;
    m_review = nullptr;
    m_compare = nullptr;
    m_history = nullptr;
}

void MainWindow::makePages()
{
    Project &project = *m_workspace->project();
    m_testbed = new TestbedPage(project);
    m_record = new RecordPage(project, m_workspace->isReadOnly());
    m_review = new ReviewPage(project);
    m_compare = new ComparePage(project);
    m_history = new HistoryPage(project, m_workspace->isReadOnly());
    m_stack->addWidget(m_testbed);
    m_stack->addWidget(m_record);
    m_stack->addWidget(m_review);
    m_stack->addWidget(m_compare);
    m_stack->addWidget(m_history);
    connectPages();
    connectRecording();
    m_recordMenu->addActions(m_record->actions());
    m_recordMenu->setEnabled(true);
    m_toolsMenu->addActions(m_testbed->toolActions());
    m_toolsMenu->setEnabled(true);
    m_playMenu->addActions(m_review->timeline().actions());
    m_playMenu->setEnabled(true);
    m_viewMenu->addAction(m_history->pseudonyms()); // goes with the page
    m_views->setDesk(&m_review->desk());
    m_modeBar->setModesEnabled(true);
    m_messages->hide();
    refreshPages();
    showMode(Mode::Review);
    showTitle();
}

void MainWindow::connectPages()
{
    connect(m_testbed, &TestbedPage::changed, this, [this](const QString &words) {
        m_messages->showDone(words);
        m_record->refresh();
        m_review->refresh();
    });
    connect(m_testbed, &TestbedPage::failed, this, &MainWindow::tellFailure);
    connect(m_testbed, &TestbedPage::settled, this, [this] {
        if (isSettled())
            Q_EMIT settled();
    });
    connect(m_review, &ReviewPage::trialShown, this, &MainWindow::showTitle);
    connect(m_review, &ReviewPage::importRequested, m_trials, [this] { m_trials->askImport(); });
    connect(m_review, &ReviewPage::trackRequested, m_trials, &TrialActions::askTrack);
    connect(m_review, &ReviewPage::failed, this, &MainWindow::tellFailure);
    connect(m_review, &ReviewPage::settled, this, [this] {
        if (isSettled())
            Q_EMIT settled();
    });
    connect(m_compare, &ComparePage::importRequested, m_trials, [this] { m_trials->askImport(); });
    connect(m_compare, &ComparePage::failed, this, &MainWindow::tellFailure);
    connect(m_compare, &ComparePage::settled, this, [this] {
        if (isSettled())
            Q_EMIT settled();
    });
    connect(m_history, &HistoryPage::compareRequested, this, [this](const QStringList &trials) {
        if (const Result<void> shown = compareTrials(trials); !shown)
            tellFailure(shown.error());
    });
    connect(m_history, &HistoryPage::trialChosen, this, [this](const QString &trial) {
        if (const Result<void> shown = showTrial(trial.toStdString()); !shown)
            tellFailure(shown.error());
    });
    connect(m_history, &HistoryPage::notesChanged, m_review, &ReviewPage::refresh);
    connect(m_history, &HistoryPage::exportRequested, m_many, &HistoryActions::exportTrials);
    connect(m_history, &HistoryPage::reprocessRequested, m_many, &HistoryActions::reprocessTrials);
    connect(m_history, &HistoryPage::trialsChanged, this, [this](const QString &words) {
        m_record->refresh();
        m_review->refresh();
        m_compare->refresh();
        if (!words.isEmpty())
            m_messages->showDone(words);
    });
    connect(m_history, &HistoryPage::settled, this, [this] {
        if (isSettled())
            Q_EMIT settled();
    });
    connect(m_history, &HistoryPage::failed, this, &MainWindow::tellFailure);
    const QList<QAction *> steps{m_review->chooser().previousAction(), m_review->chooser().nextAction()};
    m_trialMenu->insertActions(m_playMenu->menuAction(), steps);
}

void MainWindow::connectRecording()
{
    connect(m_record, &RecordPage::changed, this, [this](const QString &words) {
        m_messages->showDone(words);
        m_review->refresh();
        m_compare->refresh();
        m_history->refresh();
        showState();
    });
    connect(m_record, &RecordPage::failed, this, &MainWindow::tellFailure);
    connect(m_record, &RecordPage::testbedRequested, this, [this] { showMode(Mode::Testbed); });
    connect(m_record, &RecordPage::trialChosen, this, [this](const QString &trial) {
        if (const Result<void> shown = showTrial(trial.toStdString()); !shown)
            tellFailure(shown.error());
    });
}

void MainWindow::refreshPages()
{
    if (!m_review)
        return;
    m_testbed->refresh();
    m_record->refresh();
    m_review->refresh();
    m_compare->refresh();
    m_history->refresh();
    showState();
}

Result<void> MainWindow::openProject(const std::filesystem::path &file)
{
    return m_files->open(file);
}

void MainWindow::showMode(Mode mode)
{
    if (!m_review)
        return;
    QWidget *const pages[] = {m_testbed, m_record, m_review, m_compare, m_history};
    if (mode == Mode::Compare && m_review->scene())
        m_compare->suggestTrial(QString::fromStdString(m_review->scene()->trial.name));
    m_modeBar->setCurrent(static_cast<int>(mode));
    QWidget *page = pages[static_cast<int>(mode)];
    m_stack->setCurrentWidget(page);
    page->setFocus(Qt::OtherFocusReason); // so that the page's keys work at once
    if (mode == Mode::History && m_review->scene())
        m_history->selectTrial(QString::fromStdString(m_review->scene()->trial.name));
}

Result<void> MainWindow::showTrial(const std::string &name)
{
    if (!m_review)
        return fail(ErrorCode::NotFound, "trial '" + name + "'", tr("no project is open").toStdString(),
                    tr("open the project that it belongs to").toStdString());
    const Result<void> shown = m_review->showTrial(QString::fromStdString(name));
    if (shown)
        showMode(Mode::Review);
    return shown;
}

Result<void> MainWindow::compareTrials(const QStringList &names)
{
    if (!m_compare)
        return fail(ErrorCode::NotFound, "comparison", tr("no project is open").toStdString(),
                    tr("open the project that the trials belong to").toStdString());
    for (const QString &name : names)
        if (const auto trial = m_workspace->project()->trials().find(name.toStdString()); !trial)
            return tl::unexpected(trial.error());
    m_compare->showTrials(names);
    showMode(Mode::Compare);
    return {};
}

bool MainWindow::isSettled() const
{
    const QWidget *page = m_stack->currentWidget();
    if (page == m_review)
        return m_review->isSettled();
    if (page == m_compare)
        return m_compare->isSettled();
    if (page == m_history)
        return m_history->isSettled();
    return page != m_testbed || m_testbed->isSettled();
}

void MainWindow::showTitle()
{
    QStringList parts;
    QString trial;
    if (const Project *project = m_workspace->project())
        parts << QString::fromStdString(project->title());
    if (m_review && m_review->scene()) {
        const TrialRecord &record = m_review->scene()->trial;
        trial = QString::fromStdString(record.name);
        QStringList words{trial};
        if (!record.teamName.empty())
            words << tr("Team %1").arg(QString::fromStdString(record.teamName));
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
    if (m_review && m_review->scene()) {
        analysis = tr("Not tracked yet");
        for (const SceneRobot &robot : m_review->scene()->robots)
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
    if (m_review)
        m_review->desk().saveLayout();
    if (m_compare)
        m_compare->desk().saveLayout();
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
        if (const Result<void> opened = openProject(pathOf(files.front())); !opened)
            tellFailure(opened.error());
    } else if (files.front().endsWith(QLatin1String(TransferActions::archiveSuffix), Qt::CaseInsensitive)) {
        m_files->transfer().askUnpack(pathOf(files.front()));
    } else if (m_workspace->project()) {
        m_trials->askImport(files);
    }
}

} // namespace odo
