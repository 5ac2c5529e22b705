// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QList>
#include <QString>
#include <QWidget>
#include <vector>

class QAction;
class QCheckBox;
class QListWidget;
class QStackedWidget;
class QTableView;

namespace odo {

class AccuracyMaker;
class CameraListModel;
class CameraView;
class Card;
class CheckTools;
class EmptyState;
struct ExpectedAccuracy;
class FactList;
class FloorReadOut;
class FloorSketch;
class LiveCameras;
class Project;
class TestbedTools;
class Timeline;

/// Testbed: the cameras, how well each is calibrated and registered, its image, and all camera positions.
/// Uses the project on its own thread. The project must outlive the page.
class TestbedPage : public QWidget
{
    Q_OBJECT
public:
    explicit TestbedPage(Project &project, QWidget *parent = nullptr);
    ~TestbedPage() override;

    /// Reads the project, keeping the selection. Call it once the signals are connected, and after every
    /// change.
    void refresh();
    bool isSettled() const;
    /// What TestbedTools and CheckTools offer; for menus too.
    QList<QAction *> toolActions() const;

    /// Asks for the lens calibration of a camera, with these images of a board to begin with.
    void calibrate(const QStringList &stills);

Q_SIGNALS:
    /// The project was changed. The words contain the warnings.
    void changed(const QString &words, const std::vector<odo::Message> &warnings);
    void tasksRequested(); ///< the user wants to see the tasks of this floor
    void failed(const odo::Error &error);
    void settled();

private:
    QWidget *makeCameraCard();
    QWidget *makeLayoutCard();
    void showCamera();
    void showLayout();
    void showAccuracy(const ExpectedAccuracy &accuracy);
    void updateTools();
    QStringList cameraNames() const;
    QString currentCamera() const;

    Project &m_project;
    LiveCameras *m_live;
    TestbedTools *m_tools;
    CheckTools *m_checks;
    Timeline *m_timeline;
    CameraListModel *m_cameras;
    std::vector<LayoutRecord> m_layouts;
    QTableView *m_table;
    QListWidget *m_layoutList;
    CameraView *m_view;
    FloorReadOut *m_readOut;
    FactList *m_facts;
    Card *m_factCard = nullptr;
    FloorSketch *m_sketch;
    Card *m_sketchCard;
    QCheckBox *m_showAccuracy;
    AccuracyMaker *m_accuracy;
    EmptyState *m_empty;
    QStackedWidget *m_stack;
};

} // namespace odo
