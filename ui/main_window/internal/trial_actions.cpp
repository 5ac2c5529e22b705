// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/trial_actions.h"

#include "core/exchange/file_name.h"
#include "core/project/project.h"
#include "core/project/repositories.h"
#include "core/workflow/import/chapter_names.h"
#include "core/workflow/import/import_tracks_job.h"
#include "core/workflow/import/import_trial_job.h"
#include "core/workflow/import/recording_source.h"
#include "core/workflow/track/synchronise_job.h"
#include "core/workflow/track/track_job.h"
#include "core/workflow/track/track_warnings.h"
#include "core/workflow/trial_sources.h"
#include "core/workflow/turned_recordings.h"
#include "ui/main_window/internal/edit_trial_dialog.h"
#include "ui/main_window/internal/import_lesson_dialog.h"
#include "ui/main_window/internal/import_tracks_dialog.h"
#include "ui/main_window/internal/job_words.h"
#include "ui/main_window/internal/robots_dialog.h"
#include "ui/main_window/internal/synchronise_dialog.h"
#include "ui/main_window/internal/track_dialog.h"
#include "ui/main_window/internal/trial_export.h"
#include "ui/main_window/workspace.h"
#include "ui/models/camera_lists.h"
#include "ui/models/number_text.h"
#include "ui/models/shown_message.h"
#include "ui/models/shown_names.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QDialog>
#include <QDir>
#include <QMenu>
#include <QStandardPaths>
#include <QWidget>
#include <algorithm>

namespace odo {

namespace {

template <class Record>
QStringList namesOf(const Result<std::vector<Record>> &records)
{
    QStringList names;
    if (records)
        for (const Record &record : *records)
            names << QString::fromStdString(record.name);
    return names;
}

Message importing(const std::string &trial)
{
    return ODO_TEXT("ui.importing", "Importing %1")(Named::trial(trial));
}

struct OfferedTeams
{
    QStringList names, shown;
    QList<QStringList> robots; ///< that belong to each
};
OfferedTeams teamsOf(Project &project)
{
    const auto teams = project.teams().all();
    const auto robots = project.robots().all();
    OfferedTeams offered{namesOf(teams), {}, {}};
    for (const TeamRecord &team : teams.value_or(std::vector<TeamRecord>())) {
        offered.shown << shownTeam(team);
        offered.robots << QStringList();
        for (const RobotRecord &robot : robots.value_or(std::vector<RobotRecord>()))
            if (std::ranges::find(team.robots, robot.id) != team.robots.end())
                offered.robots.back() << QString::fromStdString(robot.name);
    }
    return offered;
}

} // namespace

TrialActions::TrialActions(Workspace &workspace, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_window(window),
      m_import(new QAction(themeIcon(QStringLiteral("import")), tr("&Import trial from videos…"), this)),
      m_importTracks(new QAction(themeIcon(QStringLiteral("import")), tr("Import finished tra&cks…"), this)),
      m_edit(new QAction(tr("E&dit…"), this)),
      m_track(new QAction(themeIcon(QStringLiteral("track")), tr("&Track…"), this)),
      m_synchronise(new QAction(tr("S&ynchronise…"), this)),
      m_export(new QAction(themeIcon(QStringLiteral("export")), tr("&Export…"), this)),
      m_video(new QAction(tr("Export &video…"), this)),
      m_addRobot(new QAction(themeIcon(QStringLiteral("add")), tr("Add &robot…"), this))
{
    nameCommands({{m_import, "import"},
                  {m_importTracks, "importTracks"},
                  {m_edit, "editTrials"},
                  {m_track, "track"},
                  {m_synchronise, "synchronise"},
                  {m_export, "export"},
                  {m_video, "exportVideo"},
                  {m_addRobot, "addRobot"}});
    m_import->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_I));
    m_track->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_T));
    connect(m_import, &QAction::triggered, this, [this] { askImport(); });
    m_importTracks->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I));
    connect(m_importTracks, &QAction::triggered, this, [this] { askImportTracks(); });
    m_edit->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E));
    connect(m_edit, &QAction::triggered, this, [this] { Q_EMIT editRequested(m_chosen); });
    connect(m_track, &QAction::triggered, this, [this] { askTrack(m_trial); });
    connect(m_synchronise, &QAction::triggered, this, [this] { askSynchronise(m_trial); });
    m_export->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_E));
    connect(m_export, &QAction::triggered, this, &TrialActions::askExport);
    connect(m_video, &QAction::triggered, this, &TrialActions::askVideo);
    connect(m_addRobot, &QAction::triggered, this, &TrialActions::askRobot);
    connect(&m_workspace, &Workspace::opened, this, &TrialActions::updateActions);
    connect(&m_workspace, &Workspace::jobStarted, this, &TrialActions::updateActions);
    connect(&m_workspace, &Workspace::jobDone, this, &TrialActions::updateActions);
    connect(&m_workspace, &Workspace::jobFailed, this, &TrialActions::updateActions);
    updateActions();
}

void TrialActions::fillMenu(QMenu &menu)
{
    menu.addActions(
        {m_import, m_importTracks, m_addRobot, m_edit, m_track, m_synchronise, m_export, m_video});
}

void TrialActions::setCurrentTrial(const QString &name)
{
    m_trial = name;
    updateActions();
}

void TrialActions::setChosenTrials(const QStringList &names)
{
    m_chosen = names;
    updateActions();
}

void TrialActions::updateActions()
{
    const bool writable = m_workspace.project() != nullptr && !m_workspace.isReadOnly();
    m_addRobot->setEnabled(writable);
    m_import->setEnabled(writable && !m_workspace.isBusy());
    m_importTracks->setEnabled(m_import->isEnabled());
    m_export->setEnabled(!m_trial.isEmpty());
    m_video->setEnabled(!m_trial.isEmpty() && !m_workspace.isBusy());
    m_track->setEnabled(writable && !m_workspace.isBusy() && !m_trial.isEmpty());
    m_synchronise->setEnabled(m_track->isEnabled());
    m_edit->setEnabled(writable && !m_workspace.isBusy() && !m_chosen.isEmpty());
}

void TrialActions::showFailure(const Result<void> &result)
{
    if (!result)
        Q_EMIT failed(result.error());
}

template <class ImportJob>
void TrialActions::startImport(const std::shared_ptr<ImportJob> &job, const std::string &trial)
{
    showFailure(m_workspace.start(job, importing(trial), [this, job] {
        Q_EMIT trialImported(QString::fromStdString(job->trial().name));
        Q_EMIT done({importedWords(job->trial(), job->warnings()), job->warnings()});
    }));
}

ImportTrialDialog::Offer TrialActions::offer() const
{
    Project &project = *m_workspace.project();
    std::vector<ImportTrialDialog::OfferedCamera> cameras;
    for (const CameraRow &row : loadCameraRows(project).value_or(std::vector<CameraRow>()))
        cameras.push_back({QString::fromStdString(row.camera.name), cameraBadge(row.registration)});
    const OfferedTeams teams = teamsOf(project);
    return {freeTrialName(namesOf(project.trials().names())),
            teams.names,
            namesOf(project.robots().all()),
            std::move(cameras),
            teams.shown,
            teams.robots,
            namesOf(project.tasks().current())};
}

/// Files of more than one run are told apart by their headers, which are read on another thread.
void TrialActions::askImport(const QStringList &videos)
{
    constexpr qsizetype ofOneRun = 2;
    if (videos.size() <= ofOneRun)
        return askTrial(videos);
    std::vector<std::filesystem::path> files;
    for (const QString &video : videos)
        files.push_back(pathOf(video));
    const Message what = ODO_TEXT("ui.dropped_clips", "the dropped clips");
    if (m_clipSearch.isRunning()) {
        Q_EMIT failed({ErrorCode::InvalidInput, what,
                       ODO_TEXT("ui.clips_being_read", "those dropped before are still being read"),
                       ODO_TEXT("ui.drop_again", "drop them again in a moment")});
        return;
    }
    const auto found = std::make_shared<std::vector<ClipGroup>>();
    const std::filesystem::path project = m_workspace.project()->file();
    disconnect(&m_clipSearch, nullptr, this, nullptr);
    connect(&m_clipSearch, &BackgroundTask::finished, this,
            [this, found, videos, project](const std::optional<Error> &error) {
                if (!m_workspace.project() || m_workspace.project()->file() != project)
                    return; // they were dropped on another one
                if (error)
                    Q_EMIT failed(*error);
                else if (found->size() > 1)
                    askLesson(std::move(*found));
                else
                    askTrial(videos);
            });
    m_clipSearch.start([found, files](const JobControl &) -> Result<void> {
        std::vector<std::filesystem::path> recordings;
        for (const auto &chapters : chapterGroups(files, ChapterEvidence::Name))
            recordings.push_back(joinedNames(chapters));
        *found = groupClips(describeClips(recordings));
        return {};
    });
}

void TrialActions::askTrial(const QStringList &videos)
{
    ImportTrialDialog dialog(offer(), &m_window);
    dialog.addVideos(videos);
    if (dialog.exec() != QDialog::Accepted)
        return;
    startImport(std::make_shared<ImportTrialJob>(dialog.settings()), dialog.settings().trial);
}

void TrialActions::askLesson(std::vector<ClipGroup> groups)
{
    ImportLessonDialog dialog(offer(), namesOf(m_workspace.project()->trials().names()), std::move(groups),
                              &m_window);
    if (dialog.exec() == QDialog::Accepted)
        Q_EMIT lessonChosen(dialog.settings());
}

void TrialActions::askImportTracks(const QStringList &files)
{
    Project &project = *m_workspace.project();
    const OfferedTeams teams = teamsOf(project);
    ImportTracksDialog dialog({freeTrialName(namesOf(project.trials().names())), teams.names,
                               namesOf(project.robots().all()), namesOf(project.tasks().current()),
                               teams.shown},
                              &m_window);
    for (const QString &file : files)
        dialog.addTrack(file);
    if (dialog.exec() != QDialog::Accepted)
        return;
    startImport(std::make_shared<ImportTracksJob>(dialog.settings()), dialog.settings().trial);
}

void TrialActions::askTrack(const QString &trial)
{
    Project &project = *m_workspace.project();
    QStringList robots = namesOf(project.robots().all());
    if (robots.isEmpty()) { // no robot to track yet: ask for the first one now
        if (!askRobot())
            return;
        robots = namesOf(project.robots().all());
    }
    const Result<TrialRecord> record = project.trials().find(trial.toStdString());
    if (!record) {
        Q_EMIT failed(record.error());
        return;
    }
    QStringList expected;
    for (const std::string &name : record->robotNames)
        expected << QString::fromStdString(name);
    QStringList caveats;
    if (auto views = registeredViews(project, *record)) { // what else is wrong, tracking will say
        std::erase_if(*views,
                      [](const RegisteredView &view) { return isSyncOpen(view.recording); }); // sought
        for (const Message &sentence : stepWarnings(record->name, *views))
            caveats << shownWords(sentence) + u'.';
        for (const Message &sentence : turnedWarnings(record->name, *views, Opened::NeverTurned))
            caveats << shownWords(sentence) + u'.';
        for (QString &sentence : caveats)
            sentence.front() = sentence.front().toUpper();
    }
    TrackDialog dialog(trial, robots, expected, caveats, &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    TrackSettings settings = dialog.settings();
    const auto imported = importedTracksOf(project, *record);
    settings.again = imported && !imported->empty(); // there is no video to track in
    startTracking(trial, std::move(settings));
}

void TrialActions::askEdit(const QStringList &trials)
{
    std::vector<TrialRecord> records;
    for (const QString &trial : trials) {
        Result<TrialRecord> record = m_workspace.project()->trials().find(trial.toStdString());
        if (!record) {
            Q_EMIT failed(record.error());
            return;
        }
        records.push_back(std::move(*record));
    }
    const int count = static_cast<int>(records.size());
    EditTrialDialog dialog(*m_workspace.project(), std::move(records), &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    Q_EMIT trialsEdited();
    Q_EMIT done(tr("%n trial(s) changed. Choose Undo to reverse this.", "", count));
}

void TrialActions::askSynchronise(const QString &trial)
{
    Project &project = *m_workspace.project();
    const Result<TrialRecord> record = project.trials().find(trial.toStdString());
    const auto views = record ? project.trials().recordings(record->id)
                              : Result<std::vector<RecordingRecord>>(tl::unexpected(record.error()));
    if (!views) {
        Q_EMIT failed(views.error());
        return;
    }
    std::vector<ViewStep> steps;
    if (views->size() > 1) { // the job says what is wrong with any other
        std::vector<std::filesystem::path> files;
        for (const RecordingRecord &view : *views)
            files.push_back(project.resolve(view));
        SynchroniseDialog dialog(trial, *views, files, &m_window);
        if (dialog.exec() != QDialog::Accepted)
            return;
        steps = dialog.steps();
    }
    const auto job = std::make_shared<SynchroniseJob>(trial.toStdString(), std::move(steps));
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.synchronising", "Synchronising %1")(Named::trial(trial.toStdString())),
        [this, job] {
            Q_EMIT trialTracked(QString::fromStdString(job->trial().name));
            Q_EMIT done({synchronisedWords(*job), job->warnings()});
        }));
}

void TrialActions::startTracking(const QString &trial, TrackSettings settings)
{
    const auto job = std::make_shared<TrackJob>(trial.toStdString(), std::move(settings));
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.tracking", "Tracking %1")(Named::trial(trial.toStdString())), [this, job] {
            Q_EMIT trialTracked(QString::fromStdString(job->outcome().trial));
            Q_EMIT done({trackedWords(job->outcome()), job->outcome().warnings});
        }));
}

void TrialActions::pointOut(const QString &trial, const RobotPointer &pointer)
{
    if (!mayChange(ODO_TEXT("ui.the_trial", "the trial")))
        return;
    TrackSettings settings;
    settings.pointers = {pointer};
    startTracking(trial, std::move(settings));
}

void TrialActions::correctByHand(const QString &trial, const GuidanceEdit &edit)
{
    if (!mayChange(ODO_TEXT("ui.the_trial", "the trial")))
        return;
    TrackSettings settings;
    settings.again = true;
    settings.guidance = edit;
    startTracking(trial, std::move(settings));
}

bool TrialActions::mayChange(const Message &what)
{
    if (m_workspace.isReadOnly())
        Q_EMIT failed(fail(ErrorCode::InvalidInput, what,
                           ODO_TEXT("ui.only_be_read", "this project is read-only"),
                           ODO_TEXT("ui.save_copy", "save a copy and work on the copy"))
                          .value());
    return !m_workspace.isReadOnly();
}

void TrialActions::manualOverride(const OverrideRequest &word)
{
    if (!mayChange(ODO_TEXT("ui.the_sample", "the sample")))
        return;
    const auto job = std::make_shared<OverrideJob>(word);
    const QString trial = QString::fromStdString(word.trial);
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.measuring_again", "Reanalysing %1")(Named::trial(word.trial)), [this, job, trial] {
            const QString time = secondsText(job->outcome().time);
            if (const int count = int(job->outcome().count); count > 1) {
                Q_EMIT done(
                    isRejected(job->outcome().flags)
                        ? tr("%n samples of %1 are not used. Choose Undo to use them.", "", count).arg(trial)
                        : tr("%n samples of %1 are used. Choose Undo to reverse this.", "", count)
                              .arg(trial));
                return;
            }
            Q_EMIT done(
                isRejected(job->outcome().flags)
                    ? tr("The sample at %1 of %2 is not used. Choose Undo to use it.").arg(time, trial)
                    : tr("The sample at %1 of %2 is used. Choose Undo to reverse this.").arg(time, trial));
        }));
}

void TrialActions::setRange(const QString &trial, const RangeChoice &range)
{
    if (!mayChange(ODO_TEXT("ui.the_range", "the range")))
        return;
    const std::string name = trial.toStdString();
    const auto job = std::make_shared<RangeJob>(name, range);
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.measuring_again", "Reanalysing %1")(Named::trial(name)), [this, job, trial] {
            Q_EMIT done(
                job->range()
                    ? tr("The results of %1 are of its range, %2 to %3. Choose Undo to reverse this.")
                          .arg(trial, secondsText(job->range()->begin), secondsText(job->range()->end))
                    : tr("The results of %1 are of the whole run.").arg(trial));
        }));
}

void TrialActions::askExport()
{
    const Result<DoneWork> exported = exportTrial(*m_workspace.project(), m_trial, m_selection, m_window);
    if (!exported)
        Q_EMIT failed(exported.error());
    else if (!exported->words.isEmpty())
        Q_EMIT done(*exported);
}

void TrialActions::askVideo()
{
    VideoDialog dialog(tr("Video of %1").arg(m_trial), isDark(m_window.palette()), &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return;
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::MoviesLocation));
    const QString offered = QString::fromStdString(fileNameOf(m_trial.toStdString()) + ".mp4");
    const auto chosen = askOutput(&m_window, tr("Video of %1").arg(m_trial), folder.filePath(offered),
                                  {{tr("MP4 videos (*.mp4)"), QStringLiteral("mp4"), FileKind::Mp4, true}});
    if (!chosen)
        return;
    AnnotatedVideoSettings settings = dialog.settings();
    settings.target = chosen->target;
    const auto job = std::make_shared<AnnotatedVideoJob>(m_trial.toStdString(), settings);
    showFailure(m_workspace.start(
        job, ODO_TEXT("ui.making_video", "Creating the video of %1")(Named::trial(m_trial.toStdString())),
        [this, file = chosen->file, trial = m_trial] {
            Q_EMIT done({tr("Video of %1 saved as %2").arg(trial, QDir::toNativeSeparators(file)), {}, file});
        }));
}

bool TrialActions::askRobot()
{
    RobotDialog dialog(newestRecordings(*m_workspace.project()), &m_window);
    if (dialog.exec() != QDialog::Accepted)
        return false;
    Project &project = *m_workspace.project();
    const QString name = QString::fromStdString(dialog.robot().name);
    const auto added = changing(project, addRobotWords(dialog.robot().name),
                                [&] { return project.robots().add(dialog.robot()); });
    if (!added) {
        Q_EMIT failed(added.error());
        return false;
    }
    Q_EMIT robotAdded();
    Q_EMIT done(tr("Robot %1 added.").arg(name));
    return true;
}

} // namespace odo
