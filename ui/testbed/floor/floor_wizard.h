// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/records.h"
#include "ui/models/background_task.h"
#include "ui/testbed/floor/floor_camera.h"
#include "ui/testbed/floor/still_picture.h"
#include "ui/views/widgets/step_dialog.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace odo {

class FloorSourcePage;
class LiveCameras;
class MarkerPage;

/// Leads from a picture of the markers to a camera's place over the floor: which camera, layout and picture;
/// the markers, found or put by hand, with the result at once. The project is up to whoever opened it, once
/// it is accepted. Closing it at any page leaves nothing behind.
class FloorWizard : public StepDialog
{
    Q_OBJECT
public:
    FloorWizard(std::vector<FloorCamera> cameras, const QString &current, std::vector<LayoutRecord> layouts,
                const LiveCameras &live, KeepPicture keep, QWidget *parent = nullptr);
    ~FloorWizard() override;

    FloorSourcePage &source() { return *m_source; }
    MarkerPage &markers() { return *m_markers; }
    QString camera() const;
    /// Once accepted: everything but the camera's number, the date, and where the picture is.
    RegistrationRecord result() const;

    void done(int result) override;

protected:
    bool isComplete(int step) const override;
    void next() override;
    void back() override;
    void showNotSaved(const Error &error) override;

private:
    void beginMarkers();
    void showPicture(const std::optional<Error> &error);

    std::vector<FloorCamera> m_cameras;
    std::vector<LayoutRecord> m_layouts;
    FloorSourcePage *m_source;
    MarkerPage *m_markers;
    std::shared_ptr<StillPicture> m_picture; ///< that is being got
    const KeepPicture m_keep;
    BackgroundTask m_task;
};

class BadgeLabel;
class PictureChoice;

/// First page of the floor wizard: which camera, which layout, and the picture in which its markers are seen.
class FloorSourcePage : public QWidget
{
    Q_OBJECT
public:
    /// live must outlive it.
    FloorSourcePage(const std::vector<FloorCamera> &cameras, const QString &current,
                    const std::vector<LayoutRecord> &layouts, const LiveCameras &live,
                    QWidget *parent = nullptr);

    QString camera() const;
    int layout() const; ///< its place in the list
    PictureOrigin origin() const;
    void setFile(const QString &file);
    bool isComplete() const;

Q_SIGNALS:
    void completeChanged();

private:
    void showCamera();
    const FloorCamera *known() const;

    const std::vector<FloorCamera> m_cameras;
    QComboBox *m_camera, *m_layout;
    PictureChoice *m_picture;
    QLabel *m_lens;
    BadgeLabel *m_badge;
};

} // namespace odo
