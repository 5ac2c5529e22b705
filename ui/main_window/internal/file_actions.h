// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/main_window/internal/done_work.h"

#include <QObject>
#include <QStringList>
#include <QWidget>
#include <filesystem>

class QAction;
class QListWidget;
class QMenu;
class QWidget;

namespace odo {

class RecentProjects;
class TransferActions;
class Workspace;

/// What can be done with project files: new, new with the set-up of the open one, open, open a recent one,
/// the demo lesson, save a copy, and taking them elsewhere. Owns the actions and asks for the files.
class FileActions : public QObject
{
    Q_OBJECT
public:
    /// window: parent of the dialogs.
    FileActions(Workspace &workspace, RecentProjects &recent, QWidget &window);

    /// further: what others offer, before the end.
    void fillMenu(QMenu &menu, const QList<QAction *> &further);
    QAction *newProject() const { return m_new; }
    QAction *openProject() const { return m_open; }
    QAction *demo() const { return m_demo; }
    /// Asks for a folder in which the videos may be.
    void findLostVideos();
    /// Begins to open, and remembers it among the recent ones when it is open.
    void beginOpening(const std::filesystem::path &file);
    /// Like beginOpening, with the newest intact backup, which replaces the damaged project.
    void beginRestoring(const std::filesystem::path &file);
    /// As beginOpening, but waits.
    Result<void> open(const std::filesystem::path &file);

    /// Opens a project, unpacks an archive, or where a project is open asks for videos (also those of
    /// folders) or tracks to be imported, or for a lens to be calibrated by stills.
    void openDropped(const QStringList &files);

Q_SIGNALS:
    void failed(const odo::Error &error);
    void done(const odo::DoneWork &work);
    void demoOpened();
    void videosDropped(const QStringList &files);
    void tracksDropped(const QStringList &files);
    void stillsDropped(const QStringList &files);

private:
    /// Of a project to be made. A project is never replaced, so the dialog doesn't offer to. Empty: none was
    /// chosen.
    QString askFile(const QString &title, const QString &offered) const;
    QString newFile() const; ///< empty: none was chosen
    void askNew();
    void askLike();
    void askOpen();
    void askDemo();
    /// Offers the demo lesson that exists; false: another one is to be made.
    bool wantsDemoThere(const QString &file);
    void askCopy();
    void showBackups();
    void fillRecent();
    void showFailure(const Result<void> &result);

    Workspace &m_workspace;
    RecentProjects &m_recent;
    QWidget &m_window;
    QAction *m_new, *m_like, *m_open, *m_demo, *m_copy, *m_backups, *m_quit;
    TransferActions *m_transfer;
    QMenu *m_recentMenu = nullptr;
};

/// The projects that were open last, newest first, at most ten; kept in the settings. One that is gone stays
/// in the list (its disk may be unplugged) and is marked by exists().
class RecentProjects : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;
    QStringList files() const;
    void add(const std::filesystem::path &file);
    void clear();
    static bool exists(const QString &file);

Q_SIGNALS:
    void changed();
};

class FileActions;

/// Shown while no project is open: the ways in.
class WelcomePage : public QWidget
{
    Q_OBJECT
public:
    WelcomePage(FileActions &files, RecentProjects &recent, QWidget *parent = nullptr);

Q_SIGNALS:
    void recentChosen(const QString &file);

private:
    void fillRecent();
    RecentProjects &m_recent;
    QWidget *m_recentBox;
    QListWidget *m_list;
};

} // namespace odo
