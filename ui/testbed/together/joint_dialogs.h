// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/workflow/calibrate/register_job.h"
#include "ui/models/background_task.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_image.h"
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
class ImageChoice;

/// First page of registering a camera via another one: which two, and the source of an image of each.
class ReferenceCameraPage : public QWidget
{
    Q_OBJECT
public:
    /// cameras: those that can be registered. registered: those it can be done through; one at least.
    ReferenceCameraPage(const std::vector<FloorCamera> &cameras, const QString &current,
                        const std::vector<CheckCamera> &registered, const LiveCameras &live,
                        QWidget *parent = nullptr);

    const FloorCamera &camera() const;
    const CheckCamera &reference() const;
    ImageChoice &image() { return *m_image; }
    ImageChoice &referenceImage() { return *m_referenceImage; }
    QString missing() const; ///< as a sentence; empty: nothing

Q_SIGNALS:
    void completeChanged();

private:
    void showCameras();

    const std::vector<FloorCamera> m_cameras;
    const std::vector<CheckCamera> m_registered;
    QComboBox *m_camera, *m_reference;
    ImageChoice *m_image, *m_referenceImage;
};

/// Registers a camera that sees no markers via another one that sees the same floor: which two and their
/// images, then the same points in both. Stores nothing: the caller does, once it is accepted.
class RegisterViaCameraWizard : public StepDialog
{
    Q_OBJECT
public:
    /// cameras and registered: one at least of each.
    RegisterViaCameraWizard(const std::vector<FloorCamera> &cameras, const QString &current,
                            const std::vector<CheckCamera> &registered, const LiveCameras &live,
                            KeepImage keep, QWidget *parent = nullptr);
    ~RegisterViaCameraWizard() override;

    ReferenceCameraPage &source() { return *m_source; }
    SharedPointsPage &page() { return *m_page; }
    QString camera() const { return m_source->camera().name; }
    QString reference() const { return m_source->reference().name; }

    void done(int result) override;

protected:
    QString missing(int step) const override;
    bool isBusy(int step) const override;
    QString unsaved() const override;
    void next() override;
    void back() override;
    void showNotSaved(const Error &error) override;

private:
    void takeFrames();

    ReferenceCameraPage *m_source;
    SharedPointsPage *m_page;
    std::shared_ptr<ImagePair> m_images; ///< that are being got
    const KeepImage m_keep;
    BackgroundTask m_task;
};

} // namespace odo
