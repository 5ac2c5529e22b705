// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "ui/start/start_page.h"

#include <QObject>
#include <QString>
#include <filesystem>
#include <string>
#include <vector>

class QWidget;

namespace odo {

class ProjectPages;
class ReportActions;
class TrialActions;
class Workspace;

/// What the buttons of the Start page do: opens the dialog or the page of each step, and registers the
/// cameras to the printed mat that their newest recordings show.
class StartActions : public QObject
{
    Q_OBJECT
public:
    /// window: parent of the dialogs.
    StartActions(Workspace &workspace, TrialActions &trials, ReportActions &reports, QWidget &window);

    /// Serves the page of these, until they go.
    void serve(ProjectPages &pages);
    void forgetPages() { m_pages = nullptr; }

    /// Calibrates a lens, with these images of a board to begin with.
    void calibrateBy(const QStringList &stills);

Q_SIGNALS:
    void failed(const odo::Error &error);
    void done(const QString &words);

private:
    struct MatCamera
    {
        std::string name;
        std::filesystem::path recording;
    };
    void act(StartPage::Task task);
    void printMat();
    void findMat();
    Result<std::vector<MatCamera>> recordedCameras() const;
    void registerNext(std::vector<MatCamera> cameras, const std::string &layout, const QString &outcome,
                      const QString &without);
    void showFailure(const Result<void> &result);

    Workspace &m_workspace;
    TrialActions &m_trials;
    ReportActions &m_reports;
    QWidget &m_window;
    ProjectPages *m_pages = nullptr;
};

} // namespace odo
