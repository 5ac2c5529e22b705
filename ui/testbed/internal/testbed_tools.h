// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QList>
#include <QObject>
#include <QString>
#include <optional>

class QAction;
class QWidget;

namespace odo {

class LiveCameras;
class Project;

/// What can be done with a testbed: calibrate and register cameras, make layouts, print targets. Owns the
/// actions, asks in dialogs, and stores what they end with. Uses the project on its own thread.
class TestbedTools : public QObject
{
    Q_OBJECT
public:
    enum Tool {
        Calibrate,
        Register,
        RegisterViaCamera,
        RegisterJointly,
        ImportCalibration,
        NewLayout,
        ImportLayout,
        PrintTargets,
        ToolCount
    };

    /// live: refreshed before a dialog asks for a camera; must outlive it. window: parent of the dialogs.
    TestbedTools(Project &project, LiveCameras &live, QWidget &window);

    QAction *action(Tool tool) const { return m_actions.at(tool); }
    QList<QAction *> actions() const { return m_actions; }
    /// What the dialogs begin with. layout: empty where there is none.
    void setCurrent(const QString &camera, const std::optional<LayoutRecord> &layout);
    /// As the action, for another camera than the current one.
    void registerAgain(const QString &camera);
    /// As the action, with these images to begin with.
    void calibrateBy(const QStringList &stills);

Q_SIGNALS:
    /// The words contain the warnings.
    void changed(const QString &words, const std::vector<odo::Message> &warnings = {});
    void failed(const odo::Error &error);

private:
    void add(Tool tool, const QString &icon, const QString &text, const QString &shortText,
             const QString &tip, void (TestbedTools::*slot)());
    void calibrate() { calibrateBy({}); }
    void registerCamera();
    void startRegisterViaCamera();
    void registerTogether();
    void importCalibration();
    void newLayout();
    void importLayout();
    void printTargets();
    QStringList cameraNames() const;
    QStringList layoutNames() const;
    void store(MarkerLayout layout);

    Project &m_project;
    LiveCameras &m_live;
    QWidget &m_window;
    QList<QAction *> m_actions;
    QString m_camera;
    std::optional<LayoutRecord> m_layout;
};

/// How a testbed is checked: whether cameras have moved, by a known length, by what accuracy is to be
/// expected, and through the revisions of what it was made from. Owns the actions and asks in dialogs. Uses
/// the project on its own thread.
class CheckTools : public QObject
{
    Q_OBJECT
public:
    enum Tool { Moved, Length, Accuracy, Revisions, ToolCount };

    /// live: refreshed before a dialog asks for a camera; must outlive it. window: parent of the dialogs.
    CheckTools(Project &project, LiveCameras &live, QWidget &window);

    QAction *action(Tool tool) const { return m_actions.at(tool); }
    QList<QAction *> actions() const { return m_actions; }
    /// What the dialogs begin with. layout: empty where there is none. isRegistered: some camera is.
    void setCurrent(const QString &camera, const std::optional<LayoutRecord> &layout, bool isRegistered);

Q_SIGNALS:
    void changed(const QString &words);
    void registerRequested(const QString &camera); ///< it has moved
    void failed(const odo::Error &error);

private:
    void add(Tool tool, const QString &icon, const QString &text, const QString &shortText,
             const QString &tip, void (CheckTools::*slot)());
    void checkLength();
    void showAccuracy();
    void checkCameraPosition();
    void showRevisions();

    Project &m_project;
    LiveCameras &m_live;
    QWidget &m_window;
    QList<QAction *> m_actions;
    QString m_camera;
    std::optional<LayoutRecord> m_layout;
};

} // namespace odo
