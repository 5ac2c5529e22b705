// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/main_window/project_pages.h"

#include <QString>
#include <QStringList>
#include <functional>
#include <memory>

class QDialog;
class QImage;
class QWidget;

namespace odo {
class MainWindow;
}

namespace odo::test {

/// Takes the pictures of the manual: opens the main window on a project, brings pages and dialogs up as a
/// person would, and writes what they show as PNG files into a folder, each under a name without its ending.
/// GUI thread.
class PictureBook
{
public:
    /// The window is on screen, without a project.
    explicit PictureBook(QString folder);
    ~PictureBook();

    void open(const QString &project);
    /// To the size that all pictures of it have.
    void fitWindow();
    MainWindow &window() { return *m_window; }
    /// The page of a mode, once everything that belongs to it is there.
    void showPage(WindowMode mode);
    /// Writes what a widget shows, once it stands still.
    void take(QWidget &widget, const QString &name);
    void write(const QImage &image, const QString &name);
    /// Writes what the window shows.
    void takeWindow(const QString &name);
    /// Calls a command by its object name, has the dialog that comes filled in, writes what it shows, and
    /// dismisses it. What fill itself takes stands beside that; an empty name takes no further picture.
    void takeDialog(const char *command, const QString &name,
                    const std::function<void(QDialog &)> &fill = {});

    const QStringList &names() const { return m_names; }

private:
    QString m_folder;
    QStringList m_names;
    std::unique_ptr<MainWindow> m_window;
};

/// Until what is shown has not changed for a while; at most some seconds where it never stands still.
void waitUntilStill(QWidget &widget);

} // namespace odo::test
