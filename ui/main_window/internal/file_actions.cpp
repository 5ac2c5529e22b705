// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window/internal/file_actions.h"

#include "core/project/names.h"
#include "core/project/project.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/demo.h"
#include "core/workflow/project_copy.h"
#include "ui/main_window/internal/backups_dialog.h"
#include "ui/main_window/internal/import_tracks_dialog.h"
#include "ui/main_window/internal/transfer_actions.h"
#include "ui/main_window/workspace.h"
#include "ui/views/widgets/command_keys.h"
#include "ui/views/widgets/empty_state.h"
#include "ui/views/widgets/form_fields.h"
#include "ui/views/widgets/theme.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <algorithm>

namespace odo {

namespace {

const QString projectSuffix = QStringLiteral(".odo");

QString documentsFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

QString withSuffix(QString file)
{
    if (QFileInfo(file).suffix().isEmpty())
        file += projectSuffix;
    return file;
}

const QString demoKey = QStringLiteral("demoLesson"); ///< the project of the last one that was made

/// A folder of that name which does not exist yet: the demo may be made as often as one likes.
QString freeFolder(const QString &base)
{
    QString folder = base;
    for (int number = 2; QFileInfo::exists(folder); ++number)
        folder = QStringLiteral("%1 %2").arg(base).arg(number);
    return folder;
}

} // namespace

FileActions::FileActions(Workspace &workspace, RecentProjects &recent, QWidget &window)
    : QObject(&window), m_workspace(workspace), m_recent(recent), m_window(window),
      m_new(new QAction(themeIcon(QStringLiteral("new")), tr("&New project…"), this)),
      m_like(new QAction(tr("New project from t&his one…"), this)),
      m_open(new QAction(themeIcon(QStringLiteral("open")), tr("&Open project…"), this)),
      m_demo(new QAction(themeIcon(QStringLiteral("demo")), tr("Open &demo lesson…"), this)),
      m_copy(new QAction(tr("Save a &copy as…"), this)), m_backups(new QAction(tr("&Backups…"), this)),
      m_quit(new QAction(tr("&Quit"), this)), m_transfer(new TransferActions(workspace, window))
{
    nameCommands({{m_new, "newProject"},
                  {m_like, "newProjectLike"},
                  {m_open, "openProject"},
                  {m_demo, "demo"},
                  {m_copy, "saveCopy"},
                  {m_backups, "backups"},
                  {m_quit, "quit"}});
    m_new->setShortcut(QKeySequence::New);
    m_open->setShortcut(QKeySequence::Open);
    m_copy->setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    m_quit->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_Q));
    m_like->setToolTip(tr("With its cameras, marker layouts, robots and tasks, without people and trials"));
    for (QAction *action : {m_like, m_copy, m_backups})
        action->setEnabled(false);
    connect(m_new, &QAction::triggered, this, &FileActions::askNew);
    connect(m_open, &QAction::triggered, this, &FileActions::askOpen);
    connect(m_demo, &QAction::triggered, this, &FileActions::askDemo);
    connect(m_copy, &QAction::triggered, this, &FileActions::askCopy);
    connect(m_quit, &QAction::triggered, &m_window, &QWidget::close);
    connect(m_backups, &QAction::triggered, this, &FileActions::showBackups);
    connect(m_like, &QAction::triggered, this, &FileActions::askLike);
    connect(&m_workspace, &Workspace::opened, this, [this] {
        for (QAction *action : {m_like, m_copy, m_backups})
            action->setEnabled(true);
    });
    connect(m_transfer, &TransferActions::failed, this, &FileActions::failed);
    connect(m_transfer, &TransferActions::done, this, &FileActions::done);
    connect(m_transfer, &TransferActions::unpacked, &m_recent, &RecentProjects::add);
}

void FileActions::fillMenu(QMenu &menu, const QList<QAction *> &further)
{
    menu.addAction(m_new);
    menu.addAction(m_like);
    menu.addAction(m_open);
    m_recentMenu = menu.addMenu(tr("Open &recent"));
    connect(&m_recent, &RecentProjects::changed, this, &FileActions::fillRecent);
    fillRecent();
    menu.addAction(m_demo);
    menu.addSeparator();
    menu.addAction(m_copy);
    menu.addAction(m_backups);
    m_transfer->fillMenu(menu);
    menu.addSeparator();
    menu.addActions(further);
    menu.addSeparator();
    menu.addAction(m_quit);
}

void FileActions::fillRecent()
{
    m_recentMenu->clear();
    const QStringList files = m_recent.files();
    for (const QString &file : files) {
        QAction *action = m_recentMenu->addAction(
            QDir::toNativeSeparators(file).replace(QLatin1String("&"), QLatin1String("&&")));
        action->setEnabled(RecentProjects::exists(file));
        connect(action, &QAction::triggered, this, [this, file] { beginOpening(pathOf(file)); });
    }
    if (!files.isEmpty()) {
        m_recentMenu->addSeparator();
        connect(m_recentMenu->addAction(tr("&Clear this list")), &QAction::triggered, &m_recent,
                &RecentProjects::clear);
    }
    m_recentMenu->setEnabled(!files.isEmpty());
}

void FileActions::findLostVideos()
{
    m_transfer->askLostVideos();
}

void FileActions::beginOpening(const std::filesystem::path &file)
{
    showFailure(m_workspace.beginOpening(file, [this, file] { m_recent.add(file); }));
}

void FileActions::beginRestoring(const std::filesystem::path &file)
{
    showFailure(m_workspace.beginRestoring(file, [this, file] { m_recent.add(file); }));
}

Result<void> FileActions::open(const std::filesystem::path &file)
{
    Result<void> opened = m_workspace.open(file);
    if (opened)
        m_recent.add(file);
    return opened;
}

namespace {

/// In place of each folder that has videos, those and the ones in its folders, by name: a class's clips,
/// perhaps a folder for each phone. A folder without any may be one of numbered images.
QStringList withVideosOfFolders(const QStringList &files)
{
    static const QStringList endings{QStringLiteral("*.mp4"), QStringLiteral("*.mov"),
                                     QStringLiteral("*.m4v"), QStringLiteral("*.mkv"),
                                     QStringLiteral("*.avi"), QStringLiteral("*.webm")};
    QStringList all;
    for (const QString &file : files) {
        QStringList inside;
        if (QFileInfo(file).isDir()) {
            QStringList folders{file};
            for (const QString &folder : QDir(file).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
                folders << QDir(file).filePath(folder);
            for (const QString &folder : folders)
                for (const QString &video : QDir(folder).entryList(endings, QDir::Files, QDir::Name))
                    inside << QDir(folder).filePath(video);
        }
        all += inside.isEmpty() ? QStringList(file) : inside;
    }
    return all;
}

} // namespace

void FileActions::openDropped(const QStringList &files)
{
    if (files.isEmpty())
        return;
    if (files.front().endsWith(projectSuffix, Qt::CaseInsensitive))
        beginOpening(pathOf(files.front()));
    else if (files.front().endsWith(QLatin1String(TransferActions::archiveSuffix), Qt::CaseInsensitive))
        m_transfer->askUnpack(pathOf(files.front()));
    else if (m_workspace.project() && !m_workspace.isReadOnly()) {
        if (std::ranges::all_of(files, &ImportTracksDialog::isTrackFile))
            Q_EMIT tracksDropped(files);
        else if (std::ranges::all_of(files, [](const QString &file) { return isStillImage(pathOf(file)); }))
            Q_EMIT stillsDropped(files);
        else
            Q_EMIT videosDropped(withVideosOfFolders(files));
    }
}

QString FileActions::askFile(const QString &title, const QString &offered) const
{
    const QString file =
        QFileDialog::getSaveFileName(&m_window, title, offered, tr("Odograph projects (*.odo)"), nullptr,
                                     // it is refused, whatever the answer
                                     QFileDialog::DontConfirmOverwrite);
    return file.isEmpty() ? file : withSuffix(file);
}

QString FileActions::newFile() const
{
    return askFile(tr("New project"), QDir(documentsFolder()).filePath(tr("Project.odo")));
}

void FileActions::askLike()
{
    const QString file = newFile();
    if (file.isEmpty())
        return;
    const auto make = [original = m_workspace.project()->file(), file = pathOf(file),
                       title = titleFromName(pathOf(file))](const JobControl &control) {
        return makeProjectLike(original, file, title, control);
    };
    showFailure(m_workspace.makeAndOpen(make, ODO_TEXT("ui.taking_over_setup", "Copying the set-up"),
                                        [this, file] { m_recent.add(pathOf(file)); }));
}

void FileActions::askNew()
{
    const QString file = newFile();
    if (file.isEmpty())
        return;
    const Result<void> made =
        m_workspace.create(pathOf(file), QString::fromStdString(titleFromName(pathOf(file))));
    if (made)
        m_recent.add(pathOf(file));
    showFailure(made);
}

void FileActions::askOpen()
{
    const QString file = QFileDialog::getOpenFileName(&m_window, tr("Open project"), documentsFolder(),
                                                      tr("Odograph projects (*.odo);;All files (*)"));
    if (!file.isEmpty())
        beginOpening(pathOf(file));
}

bool FileActions::wantsDemoThere(const QString &file)
{
    QMessageBox question(
        QMessageBox::Question, tr("Open demo lesson"),
        tr("A demo lesson is in %1.").arg(QDir::toNativeSeparators(QFileInfo(file).absolutePath())),
        QMessageBox::Cancel, &m_window);
    QPushButton *openIt = question.addButton(tr("&Open it"), QMessageBox::AcceptRole);
    QPushButton *another = question.addButton(tr("&Create another…"), QMessageBox::ActionRole);
    question.setDefaultButton(openIt);
    question.exec();
    if (question.clickedButton() == openIt)
        showFailure(m_workspace.beginOpening(pathOf(file), [this, file] {
            m_recent.add(pathOf(file));
            Q_EMIT demoOpened();
        }));
    return question.clickedButton() != another;
}

void FileActions::askDemo()
{
    const QString there = QSettings().value(demoKey).toString();
    if (QFileInfo::exists(there) && wantsDemoThere(there))
        return;
    const QString parent = QFileDialog::getExistingDirectory(
        &m_window, tr("Choose a folder for the demo lesson"), documentsFolder());
    if (parent.isEmpty())
        return;
    const QString folder = freeFolder(QDir(parent).filePath(tr("Odograph demo")));
    const auto make = [folder = pathOf(folder)](const JobControl &control) {
        return makeDemo(folder, control);
    };
    showFailure(m_workspace.makeAndOpen(make, ODO_TEXT("ui.making_demo", "Creating the demo lesson"), [this] {
        const std::filesystem::path file = m_workspace.project()->file();
        QSettings().setValue(demoKey, textOf(file));
        m_recent.add(file);
        Q_EMIT demoOpened();
    }));
}

void FileActions::askCopy()
{
    const QString own = textOf(m_workspace.project()->file());
    const QString offered = QFileInfo(own).dir().filePath(tr("Copy of %1").arg(QFileInfo(own).fileName()));
    const QString file = askFile(tr("Save a copy"), offered);
    if (file.isEmpty())
        return;
    showFailure(m_workspace.start(
        std::make_shared<CopyJob>(pathOf(file)), ODO_TEXT("ui.saving_copy", "Saving a copy"), [this, file] {
            Q_EMIT done(
                {tr("Copy saved as %1. Its videos stay where they are.").arg(QDir::toNativeSeparators(file)),
                 {},
                 QFileInfo(file).absolutePath()});
        }));
}

void FileActions::showBackups()
{
    const std::filesystem::path project = m_workspace.project()->file();
    BackupsDialog dialog(project, m_workspace.isReadOnly(), &m_window);
    if (dialog.exec() == QDialog::Accepted)
        showFailure(m_workspace.beginGoingBack(dialog.chosen()));
}

void FileActions::showFailure(const Result<void> &result)
{
    if (!result)
        Q_EMIT failed(result.error());
}

namespace {
constexpr int mostFiles = 10;
const QString settingsKey = QStringLiteral("recentProjects");
} // namespace

QStringList RecentProjects::files() const
{
    return QSettings().value(settingsKey).toStringList();
}

void RecentProjects::add(const std::filesystem::path &file)
{
    const QString path = QFileInfo(QString::fromStdString(file.string())).absoluteFilePath();
    QStringList list = files();
    list.removeAll(path);
    list.prepend(path);
    QSettings().setValue(settingsKey, QStringList(list.mid(0, mostFiles)));
    Q_EMIT changed();
}

void RecentProjects::clear()
{
    QSettings().remove(settingsKey);
    Q_EMIT changed();
}

bool RecentProjects::exists(const QString &file)
{
    return QFileInfo::exists(file);
}

namespace {
constexpr int mostRows = 5;
constexpr int rowHeight = 44;
} // namespace

WelcomePage::WelcomePage(FileActions &files, RecentProjects &recent, QWidget *parent)
    : QWidget(parent), m_recent(recent), m_recentBox(new QWidget), m_list(new QListWidget)
{
    setObjectName(QStringLiteral("page"));
    auto *state =
        new EmptyState(QStringLiteral("review"), tr("Odograph"),
                       tr("Measures how a mobile robot moved, from the videos of ordinary cameras."));
    const auto add = [state](const QString &icon, QAction *action) {
        QPushButton *button = state->addButton(icon, action->text().remove(QLatin1Char('&')));
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
    };
    add(QStringLiteral("demo"), files.demo());
    add(QStringLiteral("new"), files.newProject());
    add(QStringLiteral("open"), files.openProject());

    m_list->setAccessibleName(tr("Recent projects"));
    auto *title = new QLabel(tr("Recent projects"));
    title->setObjectName(QStringLiteral("quiet"));
    auto *boxLayout = new QVBoxLayout(m_recentBox);
    boxLayout->setContentsMargins(0, 18, 0, 0);
    boxLayout->addWidget(title);
    boxLayout->addWidget(m_list);
    state->addWidget(m_recentBox);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(state);
    connect(m_list, &QListWidget::itemActivated, this,
            [this](QListWidgetItem *item) { Q_EMIT recentChosen(item->data(Qt::UserRole).toString()); });
    connect(m_list, &QListWidget::itemClicked, m_list, &QListWidget::itemActivated);
    connect(&m_recent, &RecentProjects::changed, this, &WelcomePage::fillRecent);
    fillRecent();
}

void WelcomePage::fillRecent()
{
    m_list->clear();
    const QStringList files = m_recent.files().mid(0, mostRows);
    for (const QString &file : files) {
        const QFileInfo info(file);
        const bool exists = RecentProjects::exists(file);
        auto *item = new QListWidgetItem(m_list);
        item->setText(QStringLiteral("%1\n%2").arg(
            info.completeBaseName(), exists ? QDir::toNativeSeparators(info.path()) : tr("no longer found")));
        item->setData(Qt::UserRole, file);
        item->setToolTip(file.toHtmlEscaped());
        item->setSizeHint({0, rowHeight});
        if (!exists)
            item->setFlags(Qt::NoItemFlags);
    }
    m_list->setFixedHeight(static_cast<int>(files.size()) * rowHeight + 4);
    m_recentBox->setVisible(!files.isEmpty());
}

} // namespace odo
