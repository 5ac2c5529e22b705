// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/preferences/preferences_dialog.h"
#include "ui/main_window/project_pages.h"

#include <QMainWindow>
#include <filesystem>
#include <memory>
#include <string>

class QStackedWidget;

namespace odo {

class ClassActions;
class CommandKeys;
class FileActions;
class HelpActions;
class HelpPanel;
class HistoryActions;
class HubActions;
class ModeBar;
class PageMenus;
class RecentProjects;
class ReportActions;
class StartActions;
class StatusLine;
class TrialActions;
class UndoActions;
class ViewActions;
class WelcomePage;
class WindowMessages;
class Workspace;
enum class Remedy;

/// The one window of Odograph: joins the mode bar, the pages, the menus and the running job. It wires; what
/// is done is done by those it joins. GUI thread.
class MainWindow : public QMainWindow
{
    Q_OBJECT
public:
    using Mode = WindowMode;

    MainWindow();
    ~MainWindow() override;

    /// Starts to open a project and to show its newest trial; on failure it shows the error and keeps the
    /// project that was open.
    void beginOpening(const std::filesystem::path &file);
    /// As beginOpening, but waits until it is open and leaves a failure to the caller.
    Result<void> openProject(const std::filesystem::path &file);
    /// Without a project the welcome page stays.
    void showMode(Mode mode);
    /// Shows a trial in Review. NotFound with the names there are.
    Result<void> showTrial(const std::string &name);
    /// Compares trials in Compare; a single one with another that suits it. NotFound where one of them does
    /// not exist.
    Result<void> compareTrials(const QStringList &names);
    /// Every image of what is shown is on screen, or cannot be loaded.
    bool isSettled() const;

    /// For when the program may have to end at any moment: what is being recorded is complete in the project,
    /// and notes are stored, when this returns.
    void finishRecording();

    Workspace &workspace() const { return *m_workspace; }

Q_SIGNALS:
    void settled();

protected:
    bool event(QEvent *event) override;
    void closeEvent(QCloseEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void makeCentre();
    void makeMenus();
    void connectActions();
    void connectJobs();
    void connectHub();
    void closePages();
    void makePages();
    void connectPages();
    void addPage(Mode mode);
    void refreshPages();
    /// Messages of core are shown with the pseudonyms of the project as it is now.
    void knowTeams();
    void showPreferences(PreferencesDialog::Page page);
    void remakePages();
    void openTrial(const QString &trial);
    /// In Start it is one of its steps; elsewhere it is shown.
    void showImported(const QString &trial);
    void showTitle();
    void showState();
    void rescueProject();
    void reopenProject();
    QString projectName() const;
    bool isWorking() const;
    void showFailure(const Error &error);
    void begin(Remedy remedy, const QString &trial);
    void showDesk(Mode mode);

    RecentProjects *m_recent;
    Workspace *m_workspace;
    FileActions *m_files;
    TrialActions *m_trials;
    HistoryActions *m_many;
    ClassActions *m_class;
    HubActions *m_hub;
    ReportActions *m_reports;
    StartActions *m_start;
    UndoActions *m_undo;
    ViewActions *m_views;
    CommandKeys *m_keys;
    HelpPanel *m_helpPanel;
    HelpActions *m_help;
    ModeBar *m_modeBar;
    WindowMessages *m_messages = nullptr;
    QStackedWidget *m_stack;
    WelcomePage *m_welcome;
    std::unique_ptr<ProjectPages> m_pages; ///< null: no project is open
    std::unique_ptr<PageMenus> m_menus;
    StatusLine *m_status;
};

} // namespace odo
