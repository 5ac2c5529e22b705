// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/calibrate/camera_position_job.h"
#include "core/workflow/job.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_image.h"

#include <QDialog>
#include <deque>
#include <utility>
#include <vector>

class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

class LiveCameras;
struct CameraDescription;

/// Before a trial: checks in a new image of each registered camera whether it has moved. Each result is
/// stored with its registration at once; a cancelled check stores nothing.
class CameraPositionDialog : public QDialog
{
    Q_OBJECT
public:
    /// live must outlive it. A camera begins with the connected one that it is, or else
    /// with its newest recording. The project must outlive the dialog; used on its own thread.
    CameraPositionDialog(Project &project, std::vector<CheckCamera> cameras, const LiveCameras &live,
                         QWidget *parent = nullptr);
    ~CameraPositionDialog() override;

    /// The source of a camera's new image; both empty: the camera is not checked.
    void setImage(int row, const ImageOrigin &origin);
    bool isRunning() const { return m_runner.isRunning(); }
    /// Something was found out and kept.
    bool hasChecked() const { return m_hasChecked; }
    /// The camera that is to be registered again, which the dialog was left for; or empty.
    QString toRegister() const { return m_toRegister; }

    void done(int result) override;

private:
    struct Row
    {
        CheckCamera camera;
        ImageOrigin origin;
        Badge badge;
        QString words;
        bool chosen = false; ///< by a person
    };

    QWidget *makeDetail();
    void addRow(int row);
    void offerLive(const LiveCameras &live);
    void offerLive(int row, const CameraDescription &live);
    void chooseImage(int row, int index);
    void checkAll();
    void checkNext();
    void finishOne(const std::shared_ptr<Job> &job, const std::optional<Error> &error);
    void showRow(int row);
    void showCurrent();

    Project &m_project;
    std::vector<Row> m_rows;
    std::deque<int> m_waiting; ///< rows to be checked; the first is being checked
    bool m_hasChecked = false;
    QString m_toRegister;
    QTableWidget *m_table;
    QLabel *m_words;
    QPushButton *m_check, *m_register;
    JobRunner m_runner;
};

} // namespace odo
