// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/records.h"

#include <QList>
#include <QString>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

class QAction;
class QListWidget;
class QStackedWidget;
class QTableView;

namespace odo {

class CameraListModel;
class CameraView;
class Card;
class EmptyState;
class FactList;
class FloorSketch;
class Job;
class Project;
class Timeline;

/// Testbed: the cameras, how well each is calibrated and registered, what it sees, and where all stand.
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
    /// Calibrate, register, import intrinsics, import a layout; for menus too.
    QList<QAction *> toolActions() const { return m_actions; }

Q_SIGNALS:
    /// words: what the job does; done: what there is to say after it.
    void jobRequested(const std::shared_ptr<odo::Job> &job, const QString &words,
                      const std::function<QString()> &done);
    void changed(const QString &words); ///< the project was changed without a job
    void failed(const odo::Error &error);
    void settled();

private:
    void makeActions();
    QWidget *makeCameraCard();
    QWidget *makeLayoutCard();
    void calibrate();
    void registerCamera();
    void importLens();
    void importLayout();
    void printTargets();
    void showCamera();
    void showLayout();
    QStringList cameraNames() const;
    QString currentCamera() const;

    Project &m_project;
    Timeline *m_timeline;
    CameraListModel *m_cameras;
    std::vector<LayoutRecord> m_layouts;
    QList<QAction *> m_actions;
    QTableView *m_table;
    QListWidget *m_layoutList;
    CameraView *m_view;
    FactList *m_facts;
    Card *m_factCard;
    FloorSketch *m_sketch;
    EmptyState *m_empty;
    QStackedWidget *m_stack;
};

} // namespace odo
