// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/testbed/check/check_camera.h"
#include "ui/testbed/floor/still_picture.h"
#include "ui/views/step_dialog.h"

#include <utility>
#include <vector>

class QComboBox;

namespace odo {

class BadgeLabel;
class LengthPage;
class LiveCameras;
class PictureChoice;

/// Checks a registered camera by a length that is known: which camera and picture, then both ends in it. Stores nothing.
class LengthWizard : public StepDialog
{
    Q_OBJECT
public:
    /// cameras: one at least. current: name of the one to begin with. live must outlive it.
    LengthWizard(std::vector<CheckCamera> cameras, const QString &current, const LiveCameras &live,
                 QWidget *parent = nullptr);
    ~LengthWizard() override;

    PictureChoice &picture() { return *m_choice; }
    LengthPage &page() { return *m_page; }

    void done(int result) override;

protected:
    bool isComplete(int step) const override;
    void next() override;
    void back() override;

private:
    QWidget *makeSource(const QString &current);
    const CheckCamera &camera() const;
    void showCamera();
    void takePicture();

    const std::vector<CheckCamera> m_cameras;
    QComboBox *m_camera;
    BadgeLabel *m_badge;
    PictureChoice *m_choice;
    LengthPage *m_page;
    std::shared_ptr<StillPicture> m_picture; ///< that is being got
    BackgroundTask m_task;
};

} // namespace odo
