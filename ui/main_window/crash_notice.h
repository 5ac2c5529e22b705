// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <filesystem>
#include <optional>

namespace odo {

class MainWindow;

/// Says that the program ended by its own fault the last time, where the report of it is, and offers to open the project that
/// was open then, with what was recorded in it.
class CrashNotice : public QDialog
{
    Q_OBJECT
public:
    /// project: to be offered; empty: none.
    CrashNotice(const std::filesystem::path &report, const std::optional<std::filesystem::path> &project,
                QWidget *parent = nullptr);

Q_SIGNALS:
    void openRequested(const std::filesystem::path &project);
};

/// Shows a notice over the window where the folder holds reports that nobody was told of. opening: the project that is being
/// opened anyway. Does not wait.
void tellCrashes(MainWindow &window, const std::filesystem::path &folder,
                 const std::optional<std::filesystem::path> &opening);

} // namespace odo
