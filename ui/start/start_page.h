// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QString>
#include <QWidget>
#include <map>
#include <memory>
#include <vector>

class QPushButton;

namespace odo {

class Project;
struct SetupState;
class StepRow;

/// Start: the way from an empty project to a first report, as a list of steps that the project's content
/// ticks, each with how far it is (the floor in mm) and the buttons that do it. Uses the project on its own
/// thread. The project must outlive the page.
class StartPage : public QWidget
{
    Q_OBJECT
public:
    /// What the buttons ask for.
    enum Task {
        ImportClips,
        ConnectCameras,
        PrintMat,
        FindMat,
        RegisterFloor,
        Calibrate,
        AddRobot,
        TrackNewest,
        RecordTrial,
        MakeReport,
    };

    StartPage(Project &project, bool isReadOnly, QWidget *parent = nullptr);
    ~StartPage() override;

    /// Reads the project. Call it once the signals are connected, and after every change.
    void refresh();
    /// The newest trial; empty: none.
    QString newestTrial() const;

Q_SIGNALS:
    void requested(odo::StartPage::Task task);
    void failed(const odo::Error &error);

private:
    QWidget *makeColumn();
    StepRow *addStep(const QString &icon, const QString &title);
    void show(const SetupState &state);
    bool isPossible(Task task, const SetupState &state) const;

    Project &m_project;
    const bool m_isReadOnly;
    std::unique_ptr<SetupState> m_state;
    std::vector<StepRow *> m_steps; ///< in the order of SetupStep
    std::map<Task, QPushButton *> m_buttons;
};

/// Whether nothing in the project is measured yet, so that a person needs the way to it first.
Result<bool> isNothingMeasured(Project &project);

} // namespace odo
