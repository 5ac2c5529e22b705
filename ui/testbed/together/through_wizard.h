// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/background_task.h"
#include "ui/testbed/together/shared_points_page.h"
#include "ui/testbed/together/through_source_page.h"
#include "ui/views/step_dialog.h"

namespace odo {

class LiveCameras;

/// Registers a camera that sees no markers through another one that sees the same floor: which two and their pictures,
/// then the same points in both. Stores nothing: that is up to whoever opened it, once it is accepted.
class ThroughWizard : public StepDialog
{
    Q_OBJECT
public:
    /// cameras and registered: one at least of each.
    ThroughWizard(const std::vector<FloorCamera> &cameras, const QString &current, const std::vector<CheckCamera> &registered,
                  const LiveCameras &live, KeepPicture keep, QWidget *parent = nullptr);
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
