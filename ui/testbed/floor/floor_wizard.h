// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/models/background_task.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/marker_page.h"
#include "ui/testbed/floor/still_image.h"
#include "ui/views/widgets/step_dialog.h"

#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;

namespace odo {

class FloorSourcePage;
class LiveCameras;

/// Registers a camera from an image of the markers: choose camera, layout and image, then detect or click the
/// markers, with the result at once. The caller stores it once it is accepted. Closing it at any page leaves
/// nothing behind.
class FloorWizard : public StepDialog
{
    Q_OBJECT
public:
    FloorWizard(std::vector<FloorCamera> cameras, const QString &current, std::vector<LayoutRecord> layouts,
                const LiveCameras &live, KeepImage keep, QWidget *parent = nullptr);
    ~FloorWizard() override;

    FloorSourcePage &source() { return *m_source; }
    MarkerPage &markers() { return *m_markers; }
    QString camera() const;
    /// Once accepted: everything but the camera's number, the date, and the path of the image.
    RegistrationRecord result() const;

    void done(int result) override;

protected:
    QString missing(int step) const override;
    bool isBusy(int step) const override;
    QString unsaved() const override;
    void next() override;
    void back() override;
    void showNotSaved(const Error &error) override;

private:
    void beginMarkers();
    void showImage(const std::optional<Error> &error);

    std::vector<FloorCamera> m_cameras;
    std::vector<LayoutRecord> m_layouts;
    FloorSourcePage *m_source;
    MarkerPage *m_markers;
    std::shared_ptr<StillImage> m_image; ///< that is being got
    const KeepImage m_keep;
    BackgroundTask m_task;
};

class BadgeLabel;
class ImageChoice;

/// First page of the floor wizard: camera, layout, and the image that shows the markers.
class FloorSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it.
    FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                    const std::vector<LayoutRecord> &layouts, const LiveCameras &live,
                    QWidget *parent = nullptr);

    QString camera() const;
    int layout() const; ///< its row in the list
    ImageOrigin origin() const;
    void setFile(const QString &file);
    QString missing() const; ///< as a sentence; empty: nothing

Q_SIGNALS:
    void completeChanged();

private:
    void showCamera();
    const FloorCamera *known() const;

    const std::vector<FloorCamera> m_cameras;
    QComboBox *m_camera, *m_layout;
    ImageChoice *m_image;
    QLabel *m_intrinsics;
    BadgeLabel *m_badge;
};

} // namespace odo
