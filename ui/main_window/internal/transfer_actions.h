// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/main_window/internal/done_work.h"

#include <QObject>
#include <filesystem>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace odo {

class FindStraysJob;
class Workspace;
struct ChosenOutput;

/// Moves a project: packs it into one file with its videos, unpacks such a file, finds lost videos, and files
/// in its media folder that belong to nothing. Owns the actions and asks for the files.
class TransferActions : public QObject
{
    Q_OBJECT
public:
    static constexpr const char *archiveSuffix = ".zip";

    /// window: parent of the dialogs.
    TransferActions(Workspace &workspace, QWidget &window);

    void fillMenu(QMenu &menu);
    /// Asks for a folder and searches it.
    void askLostVideos();
    /// Asks where, unpacks and opens.
    void askUnpack(const std::filesystem::path &archive);

Q_SIGNALS:
    void failed(const odo::Error &error);
    void done(const odo::DoneWork &work);
    /// A project was unpacked, and is open.
    void unpacked(const std::filesystem::path &project);

private:
    void askPack();
    void askArchive();
    void findStrays();
    void askStrays(const FindStraysJob &found);
    void adopt(const std::vector<std::filesystem::path> &videos);
    void removeStrays(const std::vector<std::filesystem::path> &files);
    void pack(const ChosenOutput &archive);
    void showFailure(const Result<void> &result);

    Workspace &m_workspace;
    QWidget &m_window;
    QAction *m_pack, *m_unpack, *m_relink, *m_strays;
};

} // namespace odo
