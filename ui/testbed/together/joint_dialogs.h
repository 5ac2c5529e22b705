// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/calibrate/register_job.h"
#include "ui/models/background_task.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_picture.h"
#include "ui/testbed/together/internal/shared_points_page.h"
#include "ui/views/widgets/step_dialog.h"

#include <QDialog>
#include <QWidget>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace odo {

/// Registers all cameras of a layout together and shows what changes, before anything is stored. Once it is
/// accepted the job is to be committed by whoever opened it.
class JointDialog : public QDialog
{
    Q_OBJECT
public:
    /// A prepared job for this σ of the markers' measured positions. Called on the dialog's thread.
    using Prepare = std::function<Result<std::shared_ptr<RegisterJointJob>>(double tapeSigmaM)>;

    JointDialog(const QString &layout, Prepare prepare, QWidget *parent = nullptr);
    ~JointDialog() override;

    /// Once accepted: run, not yet committed.
    const std::shared_ptr<RegisterJointJob> &job() const { return m_job; }

    void done(int result) override;

private:
    QWidget *makeTables();
    void fit();
    void show(const std::optional<Error> &error);
    void showCameras();
    void showMarkers();

    const Prepare m_prepare;
    std::shared_ptr<RegisterJointJob> m_job;
    BackgroundTask m_task;
    bool m_fitAgain = false;
    QDoubleSpinBox *m_tape;
    QTableWidget *m_cameras, *m_markers;
    QLabel *m_verdict, *m_advice;
    QPushButton *m_save;
};

class LiveCameras;
class PictureChoice;

/// First page of registering a camera via another one: which two, and the source of an image of each.
class ThroughSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// cameras: those that can be registered. registered: those it can be done through; one at least.
    ThroughSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                      const std::vector<CheckCamera> &registered, const LiveCameras &live,
                      QWidget *parent = nullptr);

    const FloorCamera &camera() const;
    const CheckCamera &through() const;
    PictureChoice &picture() { return *m_picture; }
    PictureChoice &throughPicture() { return *m_throughPicture; }
    bool isComplete() const;

Q_SIGNALS:
    void completeChanged();

private:
    void showCameras();

    const std::vector<FloorCamera> m_cameras;
    const std::vector<CheckCamera> m_registered;
    QComboBox *m_camera, *m_through;
    PictureChoice *m_picture, *m_throughPicture;
    QLabel *m_same; ///< shown when both are the same camera
};

/// Registers a camera that sees no markers via another one that sees the same floor: which two and their
/// images, then the same points in both. Stores nothing: the caller does, once it is accepted.
class ThroughWizard : public StepDialog
{
    Q_OBJECT
public:
    /// cameras and registered: one at least of each.
    ThroughWizard(const std::vector<FloorCamera> &cameras, const QString &current,
                  const std::vector<CheckCamera> &registered, const LiveCameras &live, KeepPicture keep,
                  QWidget *parent = nullptr);
    ~ThroughWizard() override;

    ThroughSourcePage &source() { return *m_source; }
    SharedPointsPage &page() { return *m_page; }
    QString camera() const { return m_source->camera().name; }
    QString through() const { return m_source->through().name; }

    void done(int result) override;

protected:
    bool isComplete(int step) const override;
    void next() override;
    void back() override;
    void showNotSaved(const Error &error) override;

private:
    void takePictures();

    ThroughSourcePage *m_source;
    SharedPointsPage *m_page;
    std::shared_ptr<PicturePair> m_pictures; ///< that are being got
    const KeepPicture m_keep;
    BackgroundTask m_task;
};

} // namespace odo
